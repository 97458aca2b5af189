// SPDX-License-Identifier: MIT
// z difference, the z sum of an edge of A and a vertex of B: the origin of z is the mean of A's z,
// so that all terms cancel but z_p of that vertex and z_r of A's third:
//@ if biased
//   z = z_p - z_r + BIAS, BIAS = 1 + 4 + 16 ..., which the recoded multiplier of the prism deducts.
//@ else
//   z = z_p - z_r.
//@ end
// Combinational. //@ diff_wire
// Latency 1. //@ !diff_wire
module sepax_zdiff #(
  parameter W = @w@,          // bits of a coordinate
  parameter Z_W = @z_w@,      // bits of a z sum //@ biased
  parameter DIGITS = @digits@ // radix-4 digits of a z sum //@ biased
  parameter Z_W = @z_w@       // bits of a z sum //@ !biased
) (
//@ if !diff_wire
  input  wire                  clk, // clock
  input  wire                  advance, // registers move //@ gated
//@ end
  input  wire signed [W-1:0]   z_p, // coordinate
  input  wire signed [W-1:0]   z_r, // coordinate
  output wire signed [Z_W-1:0] z    // difference@plus_bias@ //@ diff_wire
  output reg  signed [Z_W-1:0] z    // difference@plus_bias@ //@ !diff_wire
);
//@ if biased
  // 1 for each digit but the highest.
  localparam signed [Z_W-1:0] BIAS = {{(Z_W+2-2*DIGITS){1'b0}}, {(DIGITS-1){2'b01}}};

//@ end
  wire signed [Z_W-1:0] wide_p = {{(Z_W-W){z_p[W-1]}}, z_p};
  wire signed [Z_W-1:0] wide_r = {{(Z_W-W){z_r[W-1]}}, z_r};

//@ if diff_wire
  assign z = wide_p - wide_r@plus_bias@;
//@ else
  always @(posedge clk) begin //@ !gated
  always @(posedge clk) if (advance) begin //@ gated
    z <= wide_p - wide_r@plus_bias@;
  end
//@ end
endmodule
