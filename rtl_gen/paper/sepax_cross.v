// SPDX-License-Identifier: MIT
// Cross product, six multipliers:
//   axis = {p_x q_y - p_y q_x, p_z q_x - p_x q_z, p_y q_z - p_z q_y}
// Latency 2: products are registered by product_en, the axis by axis_en.
// Vectors are {z, y, x}, signed each.
module sepax_cross #(
  parameter E_W = @edge@, // bits of an operand
  parameter M_W = @cross_product_exact@, // bits of an exact product
  parameter P_W = @cross_product@, // bits kept of it
  parameter S_W = @axis_exact@, // bits of the exact difference, P_W + 1
  parameter C_W = @axis@  // bits kept of it
) (
  input  wire             clk,        // clock
  input  wire             product_en, // first cycle: take the products
  input  wire             axis_en,    // second cycle: take the axis
  input  wire [3*E_W-1:0] p,          // left factor
  input  wire [3*E_W-1:0] q,          // right factor
  output reg  [3*C_W-1:0] axis        // p x q
);
  wire [3*S_W-1:0] exact, scaled;
  wire [3*C_W-1:0] kept;

  genvar c;
  generate
    if (S_W != P_W + 1) begin : check
      sepax_cross_S_W_is_not_P_W_plus_1 fault ();
    end
    for (c = 0; c < 3; c = c + 1) begin : component
      localparam I = (c + 1) % 3, J = (c + 2) % 3;
      wire signed [P_W-1:0] ij, ji; // p_i q_j, p_j q_i
      reg signed [P_W-1:0] ij_q, ji_q;
      sepax_mul #(.A_W(E_W), .B_W(E_W), .FULL_W(M_W), .P_W(P_W)) mul_ij (
        .a(p[I*E_W +: E_W]), .b(q[J*E_W +: E_W]), .p(ij)
      );
      sepax_mul #(.A_W(E_W), .B_W(E_W), .FULL_W(M_W), .P_W(P_W)) mul_ji (
        .a(p[J*E_W +: E_W]), .b(q[I*E_W +: E_W]), .p(ji)
      );
      always @(posedge clk) begin
        if (product_en) begin
          ij_q <= ij;
          ji_q <= ji;
        end
      end
      assign exact[c*S_W +: S_W] = {ij_q[P_W-1], ij_q} - {ji_q[P_W-1], ji_q};
      sepax_trunc #(.IN_W(S_W), .OUT_W(C_W)) trunc (
        .value(scaled[c*S_W +: S_W]), .kept(kept[c*C_W +: C_W])
      );
    end
  endgenerate

  sepax_norm #(.S_W(S_W)) norm (.exact(exact), .shifted(scaled)); //@ block_float
  assign scaled = exact; //@ !block_float

  always @(posedge clk) begin
    if (axis_en) begin
      axis <= kept;
    end
  end
endmodule
