// SPDX-License-Identifier: MIT
// Is a coplanar pair separated? From the signs {> 0, < 0} of its orient2d in the projection that
// sepax_axis chose. Combinational. //@ !chain
// sepax_axis chose. Latency 2. //@ chain
// It is if an edge of one triangle has the other triangle strictly on the side where its own third
// vertex is not, or if the AABBs are disjoint in x of the projection.
module sepax_projection (
  input  wire        clk,      // clock //@ chain
  input  wire [17:0] g_a,      // of edge i of A and B_j: [2(3i + j) +: 2]
  input  wire [17:0] g_b,      // of edge j of B and A_i: [2(3j + i) +: 2]
  input  wire [3:0]  g_own,    // of A: [1:0], of B: [3:2]
  input  wire [17:0] x_order,  // sign of x of B_j less x of A_i: [2(3i + j) +: 2]
  output reg         separated // the pair is separated, if it is coplanar //@ chain
  output wire        separated // the pair is separated, if it is coplanar //@ !chain
);
  wire [8:0] a_above, a_below, b_above, b_below, x_above, x_below;
  wire [2:0] by_a, by_b; // edge i of A, edge j of B separates
  wire       disjoint_x = (&x_above) || (&x_below);
  reg  [6:0] by_q; //@ chain

  genvar i;
  generate
    for (i = 0; i < 9; i = i + 1) begin : sign
      assign {a_above[i], a_below[i]} = g_a[2*i +: 2];
      assign {b_above[i], b_below[i]} = g_b[2*i +: 2];
      assign {x_above[i], x_below[i]} = x_order[2*i +: 2];
    end
    for (i = 0; i < 3; i = i + 1) begin : triangle_edge
      assign by_a[i] = ((&a_above[3*i +: 3]) && !g_own[1]) || ((&a_below[3*i +: 3]) && !g_own[0]);
      assign by_b[i] = ((&b_above[3*i +: 3]) && !g_own[3]) || ((&b_below[3*i +: 3]) && !g_own[2]);
    end
  endgenerate

//@ if chain
  always @(posedge clk) begin
    by_q <= {disjoint_x, by_b, by_a};
    separated <= by_q != 7'd0;
  end
//@ else
  assign separated = {disjoint_x, by_b, by_a} != 7'd0;
//@ end
endmodule
