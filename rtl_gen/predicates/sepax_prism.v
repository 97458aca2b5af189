// SPDX-License-Identifier: MIT
// Signed prism volume: six times the volume between a triangle and the plane z = 0,
//@ if !biased
//   h = g z modulo 2^V_W, g = orient2d of the triangle, z = its z sum. Latency @latency@.
//@ else
//   h = g (z - BIAS) modulo 2^V_W, g = orient2d of the triangle, z = its z sum + BIAS,
// BIAS = 2 + 8 + 32 ..., since the z sum is a sum of two z differences. //@ two
// BIAS = 1 + 4 + 16 ... //@ !two
// The recoded multiplier deducts it. Latency @latency@.
//@ end
module @name@ #(
  parameter G_W = @g_w@, // bits of an orient2d
  parameter Z_W = @z_w@, // bits of a z sum
  parameter V_W = @v_w@  // bits of an orient3d
) (
//@ if !chained_h
  input  wire                  clk, // clock
  input  wire                  advance, // registers move //@ gated
//@ end
  input  wire signed [G_W-1:0] g,   // orient2d
  input  wire signed [Z_W-1:0] z,   // z sum@plus_bias@
  output @net_h@ signed [V_W-1:0] h    // signed prism volume
);
  wire signed [V_W-1:0] product;

  @multiplier@ multiply (
    .clk(clk), //@ clocked
    .a(g), .b(z), .p(product)
  );

//@ if chained_h
  assign h = product;
//@ else
  always @(posedge clk) begin //@ !gated
  always @(posedge clk) if (advance) begin //@ gated
    h <= product;
  end
//@ end
endmodule
