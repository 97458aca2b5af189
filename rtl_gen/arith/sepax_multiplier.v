// SPDX-License-Identifier: MIT
//@ if plain
// Signed product: p = a * b modulo 2^@p_w@.
//@ else
// Biased multiplier: p = a * (b - BIAS) modulo 2^@p_w@, BIAS = @bias@,
// for b with floor(b / 4^@top_row@) in -2 ... 2. Whoever wants a * b adds BIAS to b
// beforehand, or has sums in which a * BIAS cancels.
//@ end
// Latency @latency@. Structure: @rows@ rows, selected by the radix-4 digits of @recoded@,
// each but the highest less @less@; @full@ full and @half@ half adders in columns, the earliest
// bits first; one addition. Where SEPAX_BEHAVIOURAL is defined, a plain product of the
// same latency.
module @name@ (
  input  wire               clk, // clock //@ latency
  input  wire signed [@a_msb@:0] a, // first factor
  input  wire signed [@b_msb@:0] b, // second factor@biased@
  output wire signed [@p_msb@:0] p  // product, @latency@ clocks later
);

`ifdef SEPAX_BEHAVIOURAL
  wire [@p_msb@:0] wide_a;
  wire [@p_msb@:0] wide_b;
  assign wide_a = {{@pad_a@{a[@a_msb@]}}, a};
//@ if plain
  assign wide_b = {{@pad_b@{b[@b_msb@]}}, b};
//@ else
  // The module multiplies by b - BIAS.
  localparam [@p_msb@:0] BIAS = @p_w@'d@bias@;
  assign wide_b = {{@pad_b@{b[@b_msb@]}}, b} - BIAS;
//@ end
//@ if latency
@products@
  always @(posedge clk) begin
    product_1 <= wide_a * wide_b;@delays@
  end
  assign p = product_@latency@;
//@ else
  assign p = wide_a * wide_b;
//@ end
`else
  // Rows: digit k selects row k, worth 4^k; its sign bit counts negative.
//@ if plain
  wire [@sum_msb@:0] sum;
  // Added to b, so that its digits may be one less.
  localparam [@sum_msb@:0] BIAS = @sum_w@'d@bias@;
  assign sum = {b[@b_msb@], b} + BIAS;
//@ end
  wire [2:0] top;
  assign top = @top@;
  wire [@top_row@:0] negative;
@digits@
@adders@
  // The last two rows.
  assign p =@first@ +@second@;
`endif

endmodule
