// SPDX-License-Identifier: MIT
// Are two intervals disjoint, that is, without a common point? AABBs overlap if they are so on
// no axis. Combinational.
module sepax_disjoint #(
  parameter W = @word@ // bits of a coordinate
) (
  input  wire signed [W-1:0] low_a,   // lower end of the first
  input  wire signed [W-1:0] high_a,  // upper end
  input  wire signed [W-1:0] low_b,   // lower end of the second
  input  wire signed [W-1:0] high_b,  // upper end
  output wire                disjoint // they are disjoint
);
  assign disjoint = (high_a < low_b) || (high_b < low_a);
endmodule
