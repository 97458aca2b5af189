// SPDX-License-Identifier: MIT
// Carry-save adder (3:2 compressor) of words: a + b + c + carry_in = sum + carry modulo 2^N.
// Combinational.
module sepax_csa #(
  parameter N = 8 // bits of a word
) (
  input  wire [N-1:0] a,        // addend
  input  wire [N-1:0] b,        // addend
  input  wire [N-1:0] c,        // addend
  input  wire         carry_in, // 1 more
  output wire [N-1:0] sum,      // of each column
  output wire [N-1:0] carry     // from the column below
);
  wire [N-2:0] up;

  assign sum[N-1] = a[N-1] ^ b[N-1] ^ c[N-1];
  assign carry = {up, carry_in};
  sepax_fa #(.N(N-1)) columns (
    .a(a[N-2:0]), .b(b[N-2:0]), .c(c[N-2:0]), .sum(sum[N-2:0]), .carry(up)
  );
endmodule
