// Turned triangles of B: their vertices, cut to W bits, go out one by one, the AABB follows with
// the last of three. Coordinates beyond W + 2 bits are saturated in it. Latency 3.
module sepax_turned_box #(
  parameter W = 18 // bits of a coordinate, 4 ... 21
) (
  input  wire             clk,     // clock
  input  wire             clear,   // drop everything
  input  wire             valid,   // a turned vertex
  input  wire             damaged, // its triangle is
  input  wire [74:0]      turned,  // {z, y, x}, 25 bits each, signed
  output wire [1:0]       index,   // its number, 0 ... 2
  output wire [3*W-1:0]   vertex,  // cut to W bits
  output reg              done,    // a triangle is done
  output wire [6*W+13:0]  box      // {damaged, outside W bits, high, low}, high z highest
);
  localparam V = W + 2;
  reg        [1:0]     index_q;            // of the next vertex
  reg                  valid_q, first_q, last_q, damaged_q, outside_q;
  reg                  all_damaged_q, any_outside_q;
  reg        [3*V-1:0] point_q, low_q, high_q;
  wire       [2:0]     outside;
  wire       [3*V-1:0] point;

  assign index = index_q;
  assign box = {all_damaged_q, any_outside_q, high_q, low_q};

  genvar k;
  generate
    for (k = 0; k < 3; k = k + 1) begin : axis
      wire [24:0] v = turned[25*k +: 25];
      wire        beyond = (|(v[24:V-1] ^ {(26-V){v[24]}}));
      wire signed [V-1:0] x = point_q[V*k +: V];
      wire signed [V-1:0] low = low_q[V*k +: V];
      wire signed [V-1:0] high = high_q[V*k +: V];
      assign vertex[W*k +: W] = v[W-1:0];
      assign outside[k] = |(v[24:W-1] ^ {(26-W){v[24]}});
      assign point[V*k +: V] = beyond ? {v[24], {(V-1){!v[24]}}} : v[V-1:0];
      always @(posedge clk) begin
        if (first_q || (x < low)) begin
          low_q[V*k +: V] <= x;
        end
        if (first_q || (x > high)) begin
          high_q[V*k +: V] <= x;
        end
      end
    end
  endgenerate

  always @(posedge clk) begin
    if (clear) begin
      index_q <= 2'd0;
      {valid_q, done} <= 2'd0;
    end else begin
      if (valid) begin
        index_q <= index_q[1] ? 2'd0 : index_q + 2'd1;
      end
      valid_q <= valid;
      done <= valid_q && last_q;
    end
    if (valid) begin
      first_q <= !(|index_q);
      last_q <= index_q[1];
      damaged_q <= damaged;
      outside_q <= |outside;
      point_q <= point;
    end
    if (valid_q) begin
      all_damaged_q <= damaged_q;
      any_outside_q <= outside_q || (any_outside_q && !first_q);
    end
  end
endmodule
