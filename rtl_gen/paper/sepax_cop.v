// SPDX-License-Identifier: MIT
// COP of figure 5: coplanar iff |p_k - q_k| < LIMIT for k = 1, 2, 3, with
// p_k = s_k = B_k.N_A and q_k = t_k = A_k.N_A (all of B in A's plane). //@ plane
// p_k = t_k = A_k.N_A and q_k = v_k = B_k.N_B, as line 12 of Algorithm 1 is printed //@ !plane
// (it compares plane offsets). //@ !plane
// Latency 1; en registers the three comparisons.
module sepax_cop #(
  parameter D_W = @normal_projection@ // bits of a projection on a normal
) (
  input  wire             clk,     // clock
  input  wire             en,      // take the comparisons
  input  wire [3*D_W-1:0] p,       // {p_3, p_2, p_1}, signed each
  input  wire [3*D_W-1:0] q,       // {q_3, q_2, q_1}, signed each
  output wire             coplanar // 1: treat the pair as coplanar
);
  localparam signed [D_W:0] LIMIT = @coplanar_limit@; // @epsilon@ LSB along a unit normal

  reg [2:0] near_q; // |p_k - q_k| < LIMIT

  genvar k;
  generate
    for (k = 0; k < 3; k = k + 1) begin : vertex
      wire signed [D_W:0] difference = {p[(k+1)*D_W-1], p[k*D_W +: D_W]}
                                     - {q[(k+1)*D_W-1], q[k*D_W +: D_W]};
      always @(posedge clk) begin
        if (en) begin
          near_q[k] <= (difference < LIMIT) && (difference > -LIMIT);
        end
      end
    end
  endgenerate

  assign coplanar = &near_q;
endmodule
