// SPDX-License-Identifier: MIT
// Pairs of transfers of AXI4-Stream: @words@.
module sepax_gather (
  //@ if parts
  input  wire         clk,     // clock
  input  wire         rst,     // synchronous reset, active high
  input  wire         take,    // a transfer is taken in this cycle
  input  wire         last,    // of a batch: it ends a pair, too
  output wire         ends,    // the transfer ends a pair
  output wire         partial, // the pair is cut short: some of it are of others
  //@ end
  input  wire [@bits@:0] in,       // @layout@
  output wire [@pair@:0] pair,    // x, y, z of A_1 (lowest) ... A_3, B_1 ... B_3
  output wire         outside  // a coordinate of the pair does not fit @word@ bits
);
  localparam W = @word@;       // bits of a coordinate
  localparam VERTICES = @vertices@; // of a transfer
  wire [3*VERTICES-1:0]   fits;
  wire [3*W*VERTICES-1:0] came;

  genvar v, k;
  generate
    for (v = 0; v < VERTICES; v = v + 1) begin : vertex
      localparam FIRST = 512 * (v / 3) + 128 * (v % 3); // its lowest bit
      wire [31:0] unused = in[FIRST+96 +: 32];
      for (k = 0; k < 3; k = k + 1) begin : axis
        wire [31:0] coordinate = in[FIRST+32*k +: 32];
        assign came[(3*v+k)*W +: W] = coordinate[W-1:0];
        assign fits[3*v+k] = !(|coordinate[31:W-1]) || (&coordinate[31:W-1]); //@ narrow
        assign fits[3*v+k] = 1'b1; //@ !narrow
      end
    end
    for (v = 0; v < VERTICES / 3; v = v + 1) begin : triangle
      wire [127:0] unused = in[512*v+384 +: 128];
    end
  endgenerate

  //@ if parts
  localparam PARTS = 6 / VERTICES; // transfers of a pair
  localparam FORMER = 18 * W - 3 * W * VERTICES;
  localparam [PARTS-1:0] ONE = 1;
  reg [PARTS-1:0]  part_q;    // one-hot: the transfer that comes
  reg [FORMER-1:0] former_q;  // those before it
  reg              outside_q; // a coordinate of these does not fit

  assign ends = last || part_q[PARTS-1];
  assign pair = {came, former_q};
  assign outside = outside_q || !(&fits);
  assign partial = !part_q[PARTS-1];

  always @(posedge clk) begin
    if (rst) begin
      part_q <= ONE;
      outside_q <= 1'b0;
    end else if (take) begin
      part_q <= ends ? ONE : {part_q[PARTS-2:0], part_q[PARTS-1]};
      outside_q <= outside && !ends;
    end
    if (take) begin
      former_q <= {came, former_q[FORMER-1:3*W*VERTICES]}; //@ vertices_come
      former_q <= came; //@ !vertices_come
    end
  end
  //@ else
  assign pair = came;
  assign outside = !(&fits);
  //@ end
endmodule
