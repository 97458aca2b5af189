// SPDX-License-Identifier: MIT
// In a projection: is the other triangle farther from an edge than its limit, all of it on the side
// where the edge's own triangle is not? For each clearance. Latency 1.
module sepax_edge_outside #(
  parameter G_W = @g_w@,      // bits of an orient2d
  parameter LIMITS = @limits@ // clearances
) (
  input  wire                  clk,    // clock
  input  wire                  advance, // registers move //@ gated
  input  wire [LIMITS:0]       b_1,    // sepax_exceeds_edge of the edge and vertex 1 of the other
  input  wire [LIMITS:0]       b_2,    // vertex 2
  input  wire [LIMITS:0]       b_3,    // vertex 3
  input  wire signed [G_W-1:0] own,    // orient2d of the edge's own triangle
  output reg  [LIMITS-1:0]     outside // bit k: of clearance k
);
  wire one_side = (b_1[LIMITS] == b_2[LIMITS]) && (b_1[LIMITS] == b_3[LIMITS]) &&
                  ((own == {G_W{1'b0}}) || (own[G_W-1] != b_1[LIMITS]));

  always @(posedge clk) begin //@ !gated
  always @(posedge clk) if (advance) begin //@ gated
    outside <= {LIMITS{one_side}} & b_1[LIMITS-1:0] & b_2[LIMITS-1:0] & b_3[LIMITS-1:0];
  end
endmodule
