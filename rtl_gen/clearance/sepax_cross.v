// SPDX-License-Identifier: MIT
// A component of e x f, from orient2d of e and both ends of f: c = p - q. Latency 1.
module sepax_cross #(
  parameter G_W = @g_w@, // bits of an orient2d
  parameter C_W = @c_w@  // bits of a component
) (
  input  wire                  clk, // clock
  input  wire                  advance, // registers move //@ gated
  input  wire signed [G_W-1:0] p,   // orient2d with the end of f
  input  wire signed [G_W-1:0] q,   // orient2d with its beginning
  output reg  signed [C_W-1:0] c    // component
);
  always @(posedge clk) begin //@ !gated
  always @(posedge clk) if (advance) begin //@ gated
    c <= {{(C_W-G_W){p[G_W-1]}}, p} - {{(C_W-G_W){q[G_W-1]}}, q};
  end
endmodule
