// SPDX-License-Identifier: MIT
// Least and greatest of three coordinates: the AABB of a triangle on one axis. Combinational.
module sepax_bounds #(
  parameter W = @word@ // bits of a coordinate
) (
  input  wire signed [W-1:0] x_1, // coordinate
  input  wire signed [W-1:0] x_2, // coordinate
  input  wire signed [W-1:0] x_3, // coordinate
  output wire signed [W-1:0] low, // the least
  output wire signed [W-1:0] high // the greatest
);
  wire less_12 = x_1 < x_2;
  wire less_13 = x_1 < x_3;
  wire less_23 = x_2 < x_3;

  assign low = less_12 ? (less_13 ? x_1 : x_3) : (less_23 ? x_2 : x_3);
  assign high = less_12 ? (less_23 ? x_3 : x_2) : (less_13 ? x_3 : x_1);
endmodule
