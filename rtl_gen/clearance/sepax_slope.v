// SPDX-License-Identifier: MIT
// How orient3d changes along an edge, from p to q. Latency 1.
module sepax_slope #(
  parameter V_W = @v_w@ // bits of an orient3d
) (
  input  wire                  clk,  // clock
  input  wire                  advance, // registers move //@ gated
  input  wire signed [V_W-1:0] p,    // orient3d of its beginning
  input  wire signed [V_W-1:0] q,    // orient3d of its end
  output reg         [1:0]     slope // {q >= p, q <= p}
);
  always @(posedge clk) begin //@ !gated
  always @(posedge clk) if (advance) begin //@ gated
    slope <= {q >= p, q <= p};
  end
endmodule
