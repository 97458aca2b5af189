// SPDX-License-Identifier: MIT
// orient3d against the limit of its axis: is twice its size above it, for each clearance? //@ zero
// orient2d against the limit of its edge: is twice its size above it, for each clearance? //@ !zero
// For v of sign s the comparison is {~v if s else v, s, s} > {limit, 0}. Latency 1.
module @name@ #(
  parameter V_W = @x_w@,      // bits of the value
  parameter L_W = @l_w@,      // bits of a limit
  parameter N = @n@,          // bits of the comparison
  parameter LIMITS = @limits@ // clearances
) (
  input  wire                  clk,     // clock
  input  wire                  advance, // registers move //@ gated
  input  wire signed [V_W-1:0] @value@,       // value
  input  wire [LIMITS*L_W-1:0] limit,   // for each clearance, the inner in the lower half
  output reg  [LIMITS+1:0]     exceeds  // {it is 0, is below 0, exceeds each limit} //@ zero
  output reg  [LIMITS:0]       exceeds  // {it is below 0, exceeds each limit} //@ !zero
);
  wire [N-1:0] size = {@pad@@value@ ^ {V_W{@value@[V_W-1]}}, {2{@value@[V_W-1]}}};
  integer k;

  always @(posedge clk) begin //@ !gated
  always @(posedge clk) if (advance) begin //@ gated
    exceeds[LIMITS+1] <= @value@ == {V_W{1'b0}}; //@ zero
    exceeds[LIMITS] <= @value@[V_W-1];
    for (k = 0; k < LIMITS; k = k + 1) begin
      exceeds[k] <= size > {{(N-L_W-1){1'b0}}, limit[k*L_W +: L_W], 1'b0};
    end
  end
endmodule
