// Sum of products: p = @formula@ modulo 2^@p_w@, for the
// @terms@ factors a_k and b_k of a and b. For multipliers of @family@.
// Latency @latency@.
module @name@ (
  input  wire               clk, // clock //@ latency
  input  wire [@a_msb@:0] a, // first factors, signed, the first lowest
  input  wire [@b_msb@:0] b, // second factors, signed, the first lowest
  input  wire signed [@c_msb@:0] c, // addend //@ c
  input  wire signed [@d_msb@:0] d, // addend //@ d
  output wire signed [@p_msb@:0] p  // sum, @latency@ clocks later
);
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
endmodule
