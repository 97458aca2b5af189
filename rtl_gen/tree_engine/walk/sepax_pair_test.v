// SPDX-License-Identifier: MIT
// Tests whether a pair is near: low_b - high_a <= MARGIN and low_a - high_b <= MARGIN on each axis.
// Finds the thinnest side of the AABB of both triangles. Latency 1.
module sepax_pair_test #(
  parameter W = 18,    // bits of a coordinate, 4 ... 21
  parameter MARGIN = 0 // largest gap of a near pair, 0 ... 2^(W-1)
) (
  input  wire            clk,   // clock
  input  wire [6*W-1:0]  box_a, // {high, low} of A, z highest
  input  wire [6*W+11:0] box_b, // {high, low} of B, W + 2 bits each
  output reg             near,  // the pair is near
  output wire [1:0]      thinnest // the thinnest side, as in sepax_thinnest
);
  localparam V = W + 2;
  localparam [V:0] GAP = MARGIN;
  wire [2:0]     separate;
  reg  [3*W-1:0] side_q;

  sepax_thinnest #(.W(W)) thinnest_side (.sides(side_q), .thinnest(thinnest));

  genvar k;
  generate
    for (k = 0; k < 3; k = k + 1) begin : axis
      wire signed [V-1:0] low_a = {{2{box_a[W*k+W-1]}}, box_a[W*k +: W]};
      wire signed [V-1:0] high_a = {{2{box_a[3*W+W*k+W-1]}}, box_a[3*W+W*k +: W]};
      wire signed [V-1:0] low_b = box_b[V*k +: V];
      wire signed [V-1:0] high_b = box_b[3*V+V*k +: V];
      wire signed [V:0]   lower_b = {low_b[V-1], low_b} - GAP;
      wire signed [V:0]   higher_b = {high_b[V-1], high_b} + GAP;
      wire [W-1:0]        low = (low_b < low_a) ? low_b[W-1:0] : low_a[W-1:0];
      wire [W-1:0]        high = (high_b > high_a) ? high_b[W-1:0] : high_a[W-1:0];
      assign separate[k] = (lower_b > $signed({high_a[V-1], high_a})) ||
                        ($signed({low_a[V-1], low_a}) > higher_b);
      // Valid if B fits W bits. If it does not, the pair is not judged.
      always @(posedge clk) begin
        side_q[W*k +: W] <= high - low;
      end
    end
  endgenerate

  always @(posedge clk) begin
    near <= !(|separate);
  end
endmodule
