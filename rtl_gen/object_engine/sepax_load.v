// SPDX-License-Identifier: MIT
// Triangles from AXI4-Stream into a memory: a vertex a transfer, three a triangle, an object up to
// TLAST. An object that is not whole is not there: its count stays 0.
module sepax_load (
  input  wire            clk,       // clock
  input  wire            rst,       // synchronous reset, active high
  input  wire            busy,      // a run goes on or begins: nothing is taken
  input  wire            tvalid,    // a vertex is here
  output wire            tready,    // it is taken in this cycle
  input  wire [95:0]     tdata,     // {z, y, x}, signed, 32 bits each
  input  wire            tlast,     // the last of the object
  input  wire            tdest,     // 0: of object A, 1: of B; that of its first vertex counts
  output reg             write_a,   // write a triangle of A, @written@ cycles after its last vertex
  output reg             write_b,   // write a triangle of B, likewise
  output reg  [@index@-1:0]    address,   // its number
  output reg  [9*@word@-1:0] triangle,  // signed, @word@ bits each, x of the first vertex lowest
  output wire [6*@word@-1:0] aabb,      // its AABB, {high, low} of z, y, x
  output wire [1:0]      thinnest,  // thinnest side of that: sepax_thinnest.v //@ swaps
  output reg  [@index_a@:0]      count_a,   // triangles of A
  output reg  [@index_b@:0]      count_b,   // triangles of B
  output reg             loading,   // an object has begun to come
  output reg             ended,     // the last vertex of an object came @ended@
  output reg             bad_word,  // last object: a coordinate does not fit
  output reg             partial, // last object: ended within a triangle
  output reg             bad_size   // last object: too many triangles
);
  localparam W = @word@;     // bits of a coordinate
  localparam INDEX = @index@; // bits of a triangle's number
  localparam [INDEX:0] ONE = 1;
  reg              is_b_q;   // object B is coming
  reg  [2:0]       phase_q;  // one-hot: the vertex of the triangle
  reg  [INDEX:0]   number_q; // of the triangle
  reg  [3*W-1:0]   vertex_1_q, vertex_2_q;
  reg              came_a_q, came_b_q; // a triangle of A, of B is in `triangle`
  reg  [3*W-1:0]   sides_q; // of its AABB //@ swaps
  wire [3*W-1:0]   vertex; //@ !fpga
  wire [2:0]       fits;
  //@ if fpga
  // A vertex waits a cycle in registers.
  reg  [3*W-1:0]   vertex;
  reg              take, last_q, to_b_q, bad_vertex;
  wire             to_b = loading ? is_b_q : to_b_q;
  //@ else
  wire             bad_vertex = !(&fits);
  wire             take = tvalid && tready;
  wire             to_b = loading ? is_b_q : tdest;
  //@ end
  wire             free = !number_q[INDEX]; //@ !smaller
  wire             free = !number_q[INDEX] && //@ smaller
                          (@not_smaller@ || !(|number_q[INDEX-1:@smaller@])); //@ smaller
  wire             bad = loading && (bad_word || partial || bad_size);
  wire             whole = @last@ && phase_q[2] && !bad_vertex && free && !bad;
  wire [INDEX:0]   next_number = number_q + ONE;

  assign tready = !busy;

  genvar k;
  generate
    for (k = 0; k < 3; k = k + 1) begin : axis
      //@ if fpga
      always @(posedge clk) begin
        vertex[k*W +: W] <= tdata[32*k +: W];
      end
      //@ else
      assign vertex[k*W +: W] = tdata[32*k +: W];
      //@ end
      assign fits[k] = !(|tdata[32*k+W-1 +: 33-W]) || (&tdata[32*k+W-1 +: 33-W]); //@ narrow
      assign fits[k] = 1'b1; //@ !narrow
      //@ if fpga
      // The least and the greatest of two vertices, of three.
      wire signed [W-1:0] x = vertex[k*W +: W];
      wire signed [W-1:0] x_1 = vertex_1_q[k*W +: W];
      reg  signed [W-1:0] low_2_q, high_2_q, low_q, high_q;
      assign aabb[2*k*W +: W] = low_q;
      assign aabb[(2*k+1)*W +: W] = high_q;
      always @(posedge clk) begin
        if (take && phase_q[1]) begin
          low_2_q <= (x < x_1) ? x : x_1;
          high_2_q <= (x < x_1) ? x_1 : x;
        end
        if (take && phase_q[2]) begin
          low_q <= (x < low_2_q) ? x : low_2_q;
          high_q <= (high_2_q < x) ? x : high_2_q;
        end
      end
      //@ else
      sepax_bounds #(.W(W)) bounds (
        .x_1(triangle[k*W +: W]), .x_2(triangle[(3+k)*W +: W]), .x_3(triangle[(6+k)*W +: W]),
        .low(aabb[2*k*W +: W]), .high(aabb[(2*k+1)*W +: W])
      );
      //@ end
      always @(posedge clk) begin //@ swaps
        sides_q[k*W +: W] <= aabb[(2*k+1)*W +: W] - aabb[2*k*W +: W]; //@ swaps
      end //@ swaps
    end
  endgenerate

  sepax_thinnest #(.W(W)) thinnest_side (.sides(sides_q), .thinnest(thinnest)); //@ swaps

  always @(posedge clk) begin
    {last_q, to_b_q, bad_vertex} <= {tlast, tdest, !(&fits)}; //@ fpga
    if (rst) begin
      {loading, ended, came_a_q, came_b_q, bad_word, partial, bad_size} <= 7'd0;
      {write_a, write_b} <= 2'd0;
      take <= 1'b0; //@ fpga
      phase_q <= 3'b001;
      number_q <= {(INDEX+1){1'b0}};
      count_a <= {(@index_a@+1){1'b0}};
      count_b <= {(@index_b@+1){1'b0}};
    end else begin
      ended <= take && @last@;
      take <= tvalid && tready; //@ fpga
      came_a_q <= take && phase_q[2] && free && !to_b;
      came_b_q <= take && phase_q[2] && free && to_b;
      {write_a, write_b} <= {came_a_q, came_b_q};
      if (take) begin
        loading <= !@last@;
        phase_q <= @last@ ? 3'b001 : {phase_q[1:0], phase_q[2]};
        bad_word <= bad_vertex || (loading && bad_word);
        partial <= @last@ && !phase_q[2];
        bad_size <= (phase_q[2] && !free) || (loading && bad_size);
        if (@last@) begin
          number_q <= {(INDEX+1){1'b0}};
        end else if (phase_q[2] && free) begin
          number_q <= next_number;
        end
        if (to_b) begin
          count_b <= next_number[@index_b@:0] & {(@index_b@+1){whole}};
        end else begin
          count_a <= next_number[@index_a@:0] & {(@index_a@+1){whole}};
        end
      end
    end
    if (take && !loading) begin
      is_b_q <= @dest@;
    end
    if (take && phase_q[0]) begin
      vertex_1_q <= vertex;
    end
    if (take && phase_q[1]) begin
      vertex_2_q <= vertex;
    end
    if (take && phase_q[2]) begin
      triangle <= {vertex, vertex_2_q, vertex_1_q};
      address <= number_q[INDEX-1:0];
    end
  end
endmodule
