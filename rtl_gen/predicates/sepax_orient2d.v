// orient2d of three vertices of both triangles: twice the signed area in a projection, from the
// trapezoid terms of the edges: g = p + q - r modulo 2^G_W. Latency 1.
module sepax_orient2d #(
  parameter G_W = @g_w@ // bits of an orient2d
) (
  input  wire                  clk, // clock
  input  wire signed [G_W-1:0] p,   // trapezoid term
  input  wire signed [G_W-1:0] q,   // trapezoid term
  input  wire signed [G_W-1:0] r,   // trapezoid term
  output reg  signed [G_W-1:0] g    // twice the area
);
  wire [G_W-1:0] sum;
  wire [G_W-1:0] carry;

  sepax_csa #(.N(G_W)) three (.a(p), .b(q), .c(~r), .carry_in(1'b1), .sum(sum), .carry(carry));

  always @(posedge clk) begin
    g <= sum + carry;
  end
endmodule
