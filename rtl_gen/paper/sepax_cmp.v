// SPDX-License-Identifier: MIT
// CMP of figure 5: do the projections of A and B on one axis overlap?
//   overlap = not (min A > max B or max A > min B): (5) as the paper prints it //@ printed
//   overlap = not (min A > max B or max A < min B): touching intervals overlap //@ !printed
// Latency 1. An idle axis overlaps.
module sepax_cmp #(
  parameter D_W = @projection@ // bits of a projection
) (
  input  wire             clk,    // clock
  input  wire             en,     // take the comparison
  input  wire             idle,   // 1: the axis is not used
  input  wire [3*D_W-1:0] on_a,   // projections of A_3, A_2, A_1, signed each
  input  wire [3*D_W-1:0] on_b,   // projections of B_3, B_2, B_1, signed each
  output reg              overlap // 0: a separating axis
);
  wire signed [D_W-1:0] a_1 = on_a[0 +: D_W];
  wire signed [D_W-1:0] a_2 = on_a[D_W +: D_W];
  wire signed [D_W-1:0] a_3 = on_a[2*D_W +: D_W];
  wire signed [D_W-1:0] b_1 = on_b[0 +: D_W];
  wire signed [D_W-1:0] b_2 = on_b[D_W +: D_W];
  wire signed [D_W-1:0] b_3 = on_b[2*D_W +: D_W];

  wire signed [D_W-1:0] min_12_a = (a_1 < a_2) ? a_1 : a_2;
  wire signed [D_W-1:0] max_12_a = (a_1 > a_2) ? a_1 : a_2;
  wire signed [D_W-1:0] min_12_b = (b_1 < b_2) ? b_1 : b_2;
  wire signed [D_W-1:0] max_12_b = (b_1 > b_2) ? b_1 : b_2;
  wire signed [D_W-1:0] min_a = (min_12_a < a_3) ? min_12_a : a_3;
  wire signed [D_W-1:0] max_a = (max_12_a > a_3) ? max_12_a : a_3;
  wire signed [D_W-1:0] min_b = (min_12_b < b_3) ? min_12_b : b_3;
  wire signed [D_W-1:0] max_b = (max_12_b > b_3) ? max_12_b : b_3;

  always @(posedge clk) begin
    if (en) begin
      overlap <= idle || !((min_a > max_b) || (max_a > min_b)); //@ printed
      overlap <= idle || !((min_a > max_b) || (max_a < min_b)); //@ !printed
    end
  end
endmodule
