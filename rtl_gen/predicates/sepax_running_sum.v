// Running sum of the signed prism volumes of the faces of a tetrahedron over A:
//   sum = p + q modulo 2^V_W. Latency 1.
module sepax_orient3d_a #(
  parameter V_W = @v_w@ // bits of an orient3d
) (
  input  wire                  clk, // clock
  input  wire signed [V_W-1:0] p,   // sum so far, or 0
  input  wire signed [V_W-1:0] q,   // signed prism volume
  output reg  signed [V_W-1:0] sum  // sum; behind the third prism the orient3d
);
  always @(posedge clk) begin
    sum <= p + q;
  end
endmodule
