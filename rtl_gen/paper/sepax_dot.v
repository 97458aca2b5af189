// SPDX-License-Identifier: MIT
// Inner product of a vertex and an axis, three multipliers:
//   dot = v_x c_x + v_y c_y + v_z c_z
// Latency 2: products are registered by product_en, their sum by sum_en.
// Vectors are {z, y, x}, signed each.
module sepax_dot #(
  parameter V_W = @vertex@, // bits of a coordinate
  parameter C_W = @axis@, // bits of an axis component
  parameter M_W = @product_exact@, // bits of an exact product
  parameter P_W = @product@, // bits kept of it
  parameter S_W = @projection_exact@, // bits of the exact sum of three, > P_W
  parameter D_W = @projection@  // bits kept of it
) (
  input  wire                  clk,        // clock
  input  wire                  product_en, // first cycle: take the products
  input  wire                  sum_en,     // second cycle: take the sum
  input  wire        [3*V_W-1:0] vertex,   // vertex
  input  wire        [3*C_W-1:0] axis,     // axis
  output reg  signed [D_W-1:0] dot         // inner product
);
  wire [3*P_W-1:0] product;
  reg  [3*P_W-1:0] product_q;

  genvar c;
  generate
    if (S_W <= P_W) begin : check
      sepax_dot_sum_is_no_wider_than_a_product fault ();
    end
    for (c = 0; c < 3; c = c + 1) begin : component
      sepax_mul #(.A_W(V_W), .B_W(C_W), .FULL_W(M_W), .P_W(P_W)) mul (
        .a(vertex[c*V_W +: V_W]), .b(axis[c*C_W +: C_W]), .p(product[c*P_W +: P_W])
      );
    end
  endgenerate

  wire signed [D_W-1:0] sum_kept;
  wire signed [S_W-1:0] sum = {{(S_W-P_W){product_q[P_W-1]}}, product_q[0 +: P_W]}
                            + {{(S_W-P_W){product_q[2*P_W-1]}}, product_q[P_W +: P_W]}
                            + {{(S_W-P_W){product_q[3*P_W-1]}}, product_q[2*P_W +: P_W]};

  sepax_trunc #(.IN_W(S_W), .OUT_W(D_W)) trunc_sum (.value(sum), .kept(sum_kept));

  always @(posedge clk) begin
    if (product_en) begin
      product_q <= product;
    end
    if (sum_en) begin
      dot <= sum_kept;
    end
  end
endmodule
