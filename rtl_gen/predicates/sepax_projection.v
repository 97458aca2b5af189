// SPDX-License-Identifier: MIT
// The pair in one projection, from the signs {> 0, < 0} of its orient2d. Combinational. //@ !chain
// The pair in one projection, from the signs {> 0, < 0} of its orient2d. Latency 2. //@ chain
//   flat_soon   flat, a cycle before the others //@ chain
//   flat        all six vertices are on one line there
//   separated   an edge of one triangle has the other strictly on the side where its own third
//               vertex is not
//   disjoint_x, disjoint_z  the AABBs are disjoint in x, in z
module sepax_projection (
  input  wire        clk,        // clock //@ chain
  input  wire [17:0] g_a,        // of edge i of A and B_j: [2(3i + j) +: 2]
  input  wire [17:0] g_b,        // of edge j of B and A_i: [2(3j + i) +: 2]
  input  wire [3:0]  g_own,      // of A: [1:0], of B: [3:2]
  input  wire [17:0] x_order,    // sign of x of B_j less x of A_i: [2(3i + j) +: 2]
  input  wire [17:0] z_order,    // sign of z of B_j less z of A_i, likewise
//@ if chain
  output reg         flat_soon,  // flat of the cycle behind
  output reg         flat,       // all orient2d are zero
  output reg         separated,  // in this projection, unless it is flat
  output reg         disjoint_x, // all of B below or above all of A in x
  output reg         disjoint_z  // in z
//@ else
  output wire        flat,       // all orient2d are zero
  output wire        separated,  // in this projection, unless it is flat
  output wire        disjoint_x, // all of B below or above all of A in x
  output wire        disjoint_z  // in z
//@ end
);
  wire [8:0] a_above, a_below, b_above, b_below, x_above, x_below, z_above, z_below;
  wire [2:0] by_a, by_b; // edge i of A, edge j of B separates
  reg  [2:0] by_a_q, by_b_q; //@ chain
  reg  [1:0] x_q, z_q; //@ chain

  genvar i;
  generate
    for (i = 0; i < 9; i = i + 1) begin : sign
      assign {a_above[i], a_below[i]} = g_a[2*i +: 2];
      assign {b_above[i], b_below[i]} = g_b[2*i +: 2];
      assign {x_above[i], x_below[i]} = x_order[2*i +: 2];
      assign {z_above[i], z_below[i]} = z_order[2*i +: 2];
    end
    for (i = 0; i < 3; i = i + 1) begin : triangle_edge
      assign by_a[i] = ((&a_above[3*i +: 3]) && !g_own[1]) || ((&a_below[3*i +: 3]) && !g_own[0]);
      assign by_b[i] = ((&b_above[3*i +: 3]) && !g_own[3]) || ((&b_below[3*i +: 3]) && !g_own[2]);
    end
  endgenerate

//@ if chain
  always @(posedge clk) begin
    {by_a_q, by_b_q} <= {by_a, by_b};
    x_q <= {&x_above, &x_below};
    z_q <= {&z_above, &z_below};
    separated <= (by_a_q != 3'd0) || (by_b_q != 3'd0);
    flat_soon <= {g_own, g_a, g_b} == 40'd0;
    flat <= flat_soon;
    disjoint_x <= x_q != 2'd0;
    disjoint_z <= z_q != 2'd0;
  end
//@ else
  assign separated = (by_a != 3'd0) || (by_b != 3'd0);
  assign flat = {g_own, g_a, g_b} == 40'd0;
  assign disjoint_x = (&x_above) || (&x_below);
  assign disjoint_z = (&z_above) || (&z_below);
//@ end
endmodule
