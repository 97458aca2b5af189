// SPDX-License-Identifier: MIT
// Which side of an AABB is the thinnest? Combinational.
module sepax_thinnest #(
  parameter W = @word@ // bits of a side
) (
  input  wire [3*W-1:0] sides,   // {z, y, x}, unsigned
  output wire [1:0]     thinnest // one-hot: x, thinner than z; y, thinner than x and z; 0: z
);
  wire [W-1:0] x = sides[0*W +: W];
  wire [W-1:0] y = sides[1*W +: W];
  wire [W-1:0] z = sides[2*W +: W];
  wire         is_z = (z <= x) && (z <= y);
  wire         is_x = x <= y;

  assign thinnest = {!is_z && !is_x, !is_z && is_x};
endmodule
