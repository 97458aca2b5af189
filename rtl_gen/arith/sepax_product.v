// Signed product: p = a * b modulo 2^@p_w@.
//@ if parts
// For multipliers of @port_a@ x @port_b@ bits, signed (@family@): a is cut into @parts@ parts,
// each times b, one a cycle later than the other.
//@ end
// @low@ low bits of the factors are left to logic. //@ low
// In logic (@family@). //@ whole
// Latency @latency@. a and b are registers. //@ held
// Latency @latency@. //@ !held
module @name@ (
  input  wire               clk, // clock
  input  wire signed [@a_msb@:0] a, // first factor
  input  wire signed [@b_msb@:0] b, // second factor
  output wire signed [@p_msb@:0] p  // product, @latency@ clocks later
);
@body@
  reg [@p_msb@:0] product_q2; //@ whole
  assign p = @result@; //@ parts
  assign p = product_q2; //@ whole

  always @(posedge clk) begin
@clocked@
    product_q2 <= sum_0; //@ whole
  end
endmodule
