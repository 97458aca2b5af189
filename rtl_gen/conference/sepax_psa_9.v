// The nine axes of table 1 across edges, 54 multipliers:
//   axis 3(i-1) + j = edge i of A x edge j of B
// Edges are 1: 1->2, 2: 2->3, 3: 3->1. Latency 3: operands by load_en,
// products by product_en, axes by axis_en. Number 1 of vertices, edges and axes is the
// lowest part of its bus; vectors are {z, y, x}, signed each.
module sepax_psa_9 #(
  parameter V_W = @vertex@, // bits of a coordinate
  parameter D_W = @edge_exact@, // bits of a coordinate difference
  parameter E_W = @edge@, // bits of an edge's component
  parameter M_W = @cross_product_exact@, // bits of an exact product
  parameter P_W = @cross_product@, // bits kept of it
  parameter S_W = @axis_exact@, // bits of an exact axis component
  parameter C_W = @axis@  // bits kept of it
) (
  input  wire              clk,        // clock
  input  wire              load_en,    // first cycle: take the operands
  input  wire              product_en, // second cycle: take the products
  input  wire              axis_en,    // third cycle: take the axes
  input  wire [9*V_W-1:0]  a,          // triangle A
  input  wire [9*V_W-1:0]  b,          // triangle B
  output wire [27*C_W-1:0] axis        // axes 1 ... 9
);
  localparam U = 3 * E_W; // bits of an operand

  wire [3*U-1:0] edge_a;
  wire [3*U-1:0] edge_b;
  reg [3*U-1:0] p_q; // edges of A
  reg [3*U-1:0] q_q; // edges of B

  genvar k;
  generate
    for (k = 0; k < 3; k = k + 1) begin : edges
      sepax_edge #(.V_W(V_W), .D_W(D_W), .E_W(E_W)) of_a (
        .from(a[3*k*V_W +: 3*V_W]), .to(a[3*((k+1)%3)*V_W +: 3*V_W]), .edge_vector(edge_a[k*U +: U])
      );
      sepax_edge #(.V_W(V_W), .D_W(D_W), .E_W(E_W)) of_b (
        .from(b[3*k*V_W +: 3*V_W]), .to(b[3*((k+1)%3)*V_W +: 3*V_W]), .edge_vector(edge_b[k*U +: U])
      );
    end
    for (k = 0; k < 9; k = k + 1) begin : axes
      sepax_cross #(.E_W(E_W), .M_W(M_W), .P_W(P_W), .S_W(S_W), .C_W(C_W)) product (
        .clk(clk), .product_en(product_en), .axis_en(axis_en),
        .p(p_q[(k/3)*U +: U]), .q(q_q[(k%3)*U +: U]), .axis(axis[3*k*C_W +: 3*C_W])
      );
    end
  endgenerate

  always @(posedge clk) begin
    if (load_en) begin
      p_q <= edge_a;
      q_q <= edge_b;
    end
  end
endmodule
