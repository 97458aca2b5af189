// SPDX-License-Identifier: MIT
// Sum of products: p@plus_q@ = @formula@ modulo 2^@p_w@, for the
// @terms@ factors a_k and b_k of a and b, BIAS = @bias@, floor(b_k / 4^@top_digit@) in
// -2 ... 2.
// Whoever wants a_k b_k adds BIAS to b_k beforehand.
// Latency @latency@. Structure: @rows@ rows a product, selected by the radix-4 digits of b, each
// but the highest less 1; @full@ full and @half@ half adders in columns, the earliest bits first;
// @ending@. Where SEPAX_BEHAVIOURAL is defined, plain products of the same latency.
module @name@ (
  input  wire               clk, // clock //@ latency
  input  wire [@a_msb@:0] a, // first factors, signed, the first lowest
  input  wire [@b_msb@:0] b, // second factors + BIAS, signed, the first lowest
  input  wire signed [@c_msb@:0] c, // addend //@ c
  input  wire signed [@d_msb@:0] d, // addend //@ d
  output wire signed [@p_msb@:0] q, // one of two numbers whose sum it is //@ open
  output wire signed [@p_msb@:0] p  // sum, or the other one, @latency@ clocks later
);

`ifdef SEPAX_BEHAVIOURAL
  localparam [@p_msb@:0] BIAS = @p_w@'d@bias@;
@sum@
//@ if latency
@products@
  always @(posedge clk) begin
    product_1 <= whole;@delays@
  end
  assign p = product_@latency@;
//@ else
  assign p = whole;
//@ end
  assign q = @p_w@'d0; //@ open
`else
  // Rows: digit k selects row k of its product, worth 4^k; its sign bit counts negative.
  wire [@top_row@:0] negative;
@digits@
@addends@
@adders@
  // The last two rows.
  assign p =@first@ +@second@; //@ !open
  assign p =@first@; //@ open
  assign q =@second@; //@ open
`endif

endmodule
