// SPDX-License-Identifier: MIT
// A triangle with z and the thinnest side of an AABB in each other's place. Combinational.
module sepax_swap_axes #(
  parameter W = @word@ // bits of a coordinate
) (
  input  wire [1:0]     thinnest, // as sepax_thinnest says it
  input  wire [9*W-1:0] in,       // {z, y, x of vertex 2, of 1, of 0}
  output wire [9*W-1:0] out       // the same
);
  genvar k;
  generate
    for (k = 0; k < 3; k = k + 1) begin : vertex
      wire [W-1:0] x = in[W*3*k +: W];
      wire [W-1:0] y = in[W*(3*k+1) +: W];
      wire [W-1:0] z = in[W*(3*k+2) +: W];
      assign out[W*3*k +: W] = thinnest[0] ? z : x;
      assign out[W*(3*k+1) +: W] = thinnest[1] ? z : y;
      assign out[W*(3*k+2) +: W] = thinnest[0] ? x : thinnest[1] ? y : z;
    end
  endgenerate
endmodule
