// SPDX-License-Identifier: MIT
// Signed product between registers, as one multiplier of the FPGA makes it with its own: one behind
// each factor's port, one behind the product. p = a b modulo 2^P_W. Latency 2.
module sepax_dsp #(
  parameter A_W = @port_a@, // bits of the first factor
  parameter B_W = @port_b@, // bits of the second factor
  parameter P_W = @ports@  // bits of the product, more than those of a factor
) (
  input  wire                  clk, // clock
  input  wire signed [A_W-1:0] a,   // first factor
  input  wire signed [B_W-1:0] b,   // second factor
  output reg  signed [P_W-1:0] p    // product, 2 clocks later
);
  reg signed [A_W-1:0] a_q;
  reg signed [B_W-1:0] b_q;
  wire signed [P_W-1:0] left = {{(P_W-A_W){a_q[A_W-1]}}, a_q};
  wire signed [P_W-1:0] right = {{(P_W-B_W){b_q[B_W-1]}}, b_q};

  always @(posedge clk) begin
    a_q <= a;
    b_q <= b;
    p <= left * right;
  end
endmodule
