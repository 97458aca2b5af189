// SPDX-License-Identifier: MIT
// Signed product: p = floor(a * b / 2^(FULL_W - P_W)).
// Combinational. FULL_W bits hold every product of the operands' proven
// ranges, so it may be less than A_W + B_W.
module sepax_mul #(
  parameter A_W    = @vertex@, // bits of a
  parameter B_W    = @axis@, // bits of b
  parameter FULL_W = @product_exact@, // bits of the exact product, > A_W, > B_W
  parameter P_W    = @product@  // bits kept, 1 ... FULL_W
) (
  input  wire signed [A_W-1:0] a, // first factor
  input  wire signed [B_W-1:0] b, // second factor
  output wire signed [P_W-1:0] p  // product, its P_W most significant bits
);
  wire signed [FULL_W-1:0] a_wide = {{(FULL_W-A_W){a[A_W-1]}}, a};
  wire signed [FULL_W-1:0] b_wide = {{(FULL_W-B_W){b[B_W-1]}}, b};
  wire signed [FULL_W-1:0] full = a_wide * b_wide;

  generate
    if (FULL_W <= A_W || FULL_W <= B_W) begin : check
      sepax_mul_product_is_narrower_than_a_factor fault ();
    end
  endgenerate

  sepax_trunc #(.IN_W(FULL_W), .OUT_W(P_W)) trunc_p (.value(full), .kept(p));
endmodule
