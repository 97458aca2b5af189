// SPDX-License-Identifier: MIT
// The last gate of figure 5: a separating axis was found iff not all 11
// projections overlap. Combinational.
module sepax_nand (
  input  wire [10:0] overlap,  // bit i-1: projections on axis i overlap
  output wire        separated // 1: the triangles are separated
);
  assign separated = ~(&overlap);
endmodule
