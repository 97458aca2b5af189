// SPDX-License-Identifier: MIT
// Running sum of @terms@:
//   sum = p + q modulo 2^@bits@. Latency 1.
module @name@ #(
  parameter @bits@ = @bits_value@ // bits of an @whole_sum@
) (
  input  wire                  clk, // clock
  input  wire                  advance, // registers move //@ gated
  input  wire signed [@bits@-1:0] p,   // sum so far, or 0
  input  wire signed [@bits@-1:0] q,   // @term@
  output reg  signed [@bits@-1:0] sum  // sum; behind the third @short_term@ the @whole_sum@
);
  always @(posedge clk) begin //@ !gated
  always @(posedge clk) if (advance) begin //@ gated
    sum <= p + q; //@ !chain
    sum <= q + p; //@ chain
  end
endmodule
