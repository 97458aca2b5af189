// SPDX-License-Identifier: MIT
// N full adders side by side: a + b + c = sum + 2 carry, bit by bit.
// Combinational. A library's full-adder cell may stand for it.
module sepax_fa #(
  parameter N = 8 // bits
) (
  input  wire [N-1:0] a,    // row
  input  wire [N-1:0] b,    // row
  input  wire [N-1:0] c,    // row, may be the last to come
  output wire [N-1:0] sum,  // sums of the columns
  output wire [N-1:0] carry // carries of the columns
);
  wire [N-1:0] half = a ^ b;
  assign sum = half ^ c;
  assign carry = (a & b) | (half & c);
endmodule
