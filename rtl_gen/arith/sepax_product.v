// SPDX-License-Identifier: MIT
// Signed product: p = a * b modulo 2^@p_w@.
// For multipliers of @port_a@ x @port_b@ bits, signed (@family@).
// a is cut into @parts@ parts, each times b, one a cycle later than the other. //@ several
// @low@ low bits of the factors are left to logic. //@ low
// Latency @latency@.
module @name@ (
  input  wire               clk, // clock
  input  wire signed [@a_msb@:0] a, // first factor
  input  wire signed [@b_msb@:0] b, // second factor
  output wire signed [@p_msb@:0] p  // product, @latency@ clocks later
);
@body@
  assign p = @result@;
//@ if clocked

  always @(posedge clk) begin
@registers@
  end
//@ end
endmodule
