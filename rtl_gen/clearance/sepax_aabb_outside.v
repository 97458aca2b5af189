// SPDX-License-Identifier: MIT
// One coordinate: is the gap of the AABBs above 1 + D, for each clearance D? Latency 2.
module sepax_aabb_outside #(
  parameter W = @w@,          // bits of a coordinate
  parameter LIMITS = @limits@ // clearances
) (
  input  wire                clk,    // clock
  input  wire                advance, // registers move //@ gated
  input  wire signed [W-1:0] a_1,    // coordinate
  input  wire signed [W-1:0] a_2,    // coordinate
  input  wire signed [W-1:0] a_3,    // coordinate
  input  wire signed [W-1:0] b_1,    // coordinate
  input  wire signed [W-1:0] b_2,    // coordinate
  input  wire signed [W-1:0] b_3,    // coordinate
  output reg  [LIMITS-1:0]   outside // bit k: of clearance k
);
  localparam [LIMITS*W-1:0] MARGINS = {@margins@};

  wire signed [W-1:0] low_a, high_a, low_b, high_b;
  reg signed [W-1:0] low_a_q, high_a_q, low_b_q, high_b_q;
  wire [W:0] up = {low_b_q[W-1], low_b_q} - {high_a_q[W-1], high_a_q};
  wire [W:0] down = {low_a_q[W-1], low_a_q} - {high_b_q[W-1], high_b_q};
  integer k;

  sepax_bounds #(.W(W)) bounds_a (.x_1(a_1), .x_2(a_2), .x_3(a_3), .low(low_a), .high(high_a));
  sepax_bounds #(.W(W)) bounds_b (.x_1(b_1), .x_2(b_2), .x_3(b_3), .low(low_b), .high(high_b));

  always @(posedge clk) begin //@ !gated
  always @(posedge clk) if (advance) begin //@ gated
    low_a_q <= low_a;
    high_a_q <= high_a;
    low_b_q <= low_b;
    high_b_q <= high_b;
    for (k = 0; k < LIMITS; k = k + 1) begin
      outside[k] <= (!up[W] && (up[W-1:0] > MARGINS[k*W +: W])) ||
                    (!down[W] && (down[W-1:0] > MARGINS[k*W +: W]));
    end
  end
endmodule
