// SPDX-License-Identifier: MIT
// PROJ of figure 5: A's vertices onto one axis, B's onto another or the same, 18
// multipliers. Latency 2: products are registered by product_en, sums by sum_en.
// Axes are {z, y, x}, triangles {vertex 3, vertex 2, vertex 1}, signed each.
module sepax_proj #(
  parameter V_W = @vertex@, // bits of a coordinate
  parameter C_W = @axis@, // bits of an axis component
  parameter M_W = @product_exact@, // bits of an exact product
  parameter P_W = @product@, // bits kept of it
  parameter S_W = @projection_exact@, // bits of the exact sum of three, > P_W
  parameter D_W = @projection@  // bits kept of it
) (
  input  wire             clk,        // clock
  input  wire             product_en, // first cycle: take the products
  input  wire             sum_en,     // second cycle: take the sums
  input  wire [3*C_W-1:0] axis_a,     // axis for A
  input  wire [3*C_W-1:0] axis_b,     // axis for B
  input  wire [9*V_W-1:0] a,          // triangle A
  input  wire [9*V_W-1:0] b,          // triangle B
  output wire [3*D_W-1:0] on_a,       // projections of A_3, A_2, A_1, signed each
  output wire [3*D_W-1:0] on_b        // projections of B_3, B_2, B_1, signed each
);
  wire [18*V_W-1:0] vertices = {b, a};
  wire [6*D_W-1:0] dots;

  assign {on_b, on_a} = dots;

  genvar k;
  generate
    for (k = 0; k < 6; k = k + 1) begin : vertex
      sepax_dot #(.V_W(V_W), .C_W(C_W), .M_W(M_W), .P_W(P_W), .S_W(S_W), .D_W(D_W)) inner (
        .clk(clk), .product_en(product_en), .sum_en(sum_en), .axis(k < 3 ? axis_a : axis_b),
        .vertex(vertices[3*k*V_W +: 3*V_W]), .dot(dots[k*D_W +: D_W])
      );
    end
  endgenerate
endmodule
