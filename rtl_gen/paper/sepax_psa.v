// SPDX-License-Identifier: MIT
// PSA of figure 5: the potential separating axes of a pair, 54 multipliers. //@ both
// PSA of table 1: the nine axes across edges, 54 multipliers. //@ nine
// PSA of table 2: the six axes of coplanar pairs, 36 multipliers. //@ six
//   table 1 (not coplanar): axis 3(i-1) + j = edge i of A x edge j of B //@ !six
//   table 2 (coplanar):     axis j = N_A x edge j of A, axis 3 + j = N_B x edge j of B //@ !nine
// Axes 7 ... 9 are idle for coplanar pairs: their operands and products are held. //@ both
// Edges are 1: 1->2, 2: 2->3, 3: 3->1. Latency 3: operands by load_en, products by
// product_en, axes by axis_en.
// `coplanar` must stand in all three cycles. //@ both
// Number 1 of vertices, edges and axes is the lowest part of its bus; vectors are {z, y, x},
// signed each.
module @name@ #(
  parameter V_W = @vertex@, // bits of a coordinate
  parameter N_W = @normal@, // bits of a normal's component //@ !nine
  parameter E_W = @edge@, // bits of an edge's component, N_W or more
  parameter C_W = @axis@  // bits of an axis component
) (
  input  wire              clk,        // clock
  input  wire              load_en,    // first cycle: take the operands
  input  wire              product_en, // second cycle: take the products
  input  wire              axis_en,    // third cycle: take the axes
  input  wire              coplanar,   // 1: table 2, 0: table 1 //@ both
  input  wire [9*V_W-1:0]  a,          // triangle A
  input  wire [9*V_W-1:0]  b,          // triangle B
  input  wire [3*N_W-1:0]  n_a,        // N_A //@ !nine
  input  wire [3*N_W-1:0]  n_b,        // N_B //@ !nine
  output wire [3*@axes@*C_W-1:0] axis  // axes 1 ... @axes@
);
  localparam U = 3 * E_W; // bits of an operand

  wire [3*U-1:0] edge_a, edge_b;
  genvar k;

  sepax_edges of_a (.triangle(a), .edges(edge_a));
  sepax_edges of_b (.triangle(b), .edges(edge_b));
//@ if !nine

  wire [U-1:0] normal_a, normal_b;
  generate
    for (k = 0; k < 3; k = k + 1) begin : component
      assign normal_a[k*E_W +: E_W] = {{(E_W-N_W+1){n_a[(k+1)*N_W-1]}}, n_a[k*N_W +: N_W-1]};
      assign normal_b[k*E_W +: E_W] = {{(E_W-N_W+1){n_b[(k+1)*N_W-1]}}, n_b[k*N_W +: N_W-1]};
    end
  endgenerate
//@ end

//@ if both
  wire wanted = !coplanar; // axes 7 ... 9 are
  reg [3*U-1:0] p_q; // left factors of axes 1 ... 3, 4 ... 6, 7 ... 9
  reg [9*U-1:0] q_q; // right factors of axes 1 ... 9

  always @(posedge clk) begin
    if (load_en) begin
      p_q[0 +: U] <= coplanar ? normal_a : edge_a[0 +: U];
      p_q[U +: U] <= coplanar ? normal_b : edge_a[U +: U];
      q_q[0 +: 3*U] <= coplanar ? edge_a : edge_b;
      q_q[3*U +: 3*U] <= edge_b;
      if (wanted) begin
        p_q[2*U +: U] <= edge_a[2*U +: U];
        q_q[6*U +: 3*U] <= edge_b;
      end
    end
  end
//@ else
  reg [3*U-1:0] p_q, q_q; // edges of A, edges of B //@ nine
  reg [2*U-1:0] p_q; // N_A, N_B //@ six
  reg [6*U-1:0] q_q; // edges of A, edges of B //@ six

  always @(posedge clk) begin
    if (load_en) begin
      p_q <= edge_a; //@ nine
      q_q <= edge_b; //@ nine
      p_q <= {normal_b, normal_a}; //@ six
      q_q <= {edge_b, edge_a}; //@ six
    end
  end
//@ end

  generate
    for (k = 0; k < @axes@; k = k + 1) begin : axes
      sepax_cross product (
        .clk(clk),
        .product_en(product_en && (k < 6 || wanted)), //@ both
        .axis_en(axis_en && (k < 6 || wanted)), //@ both
        .product_en(product_en), .axis_en(axis_en), //@ !both
        .p(p_q[(k/3)*U +: U]), .axis(axis[3*k*C_W +: 3*C_W]),
        .q(q_q[(k%3)*U +: U]) //@ nine
        .q(q_q[k*U +: U]) //@ !nine
      );
    end
  endgenerate
endmodule
