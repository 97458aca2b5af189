// SPDX-License-Identifier: MIT
// z sum of a vertex of A and an edge of B: the origin of z is the mean of A's z, so that all terms
// cancel but z_p and z_q of that edge, z_r and z_s of A's other two vertices:
//   z = z_p + z_q - z_r - z_s + 2 BIAS, as a sum of two z differences. @zsum_latency@ //@ shared
//@ if !shared
//@ if biased
//   z = z_p + z_q - z_r - z_s + BIAS, BIAS = 1 + 4 + 16 ..., which the recoded
// multiplier of the prism deducts. @zsum_latency@
//@ else
//   z = z_p + z_q - z_r - z_s. @zsum_latency@
//@ end
//@ end
module sepax_zsum #(
  parameter W = @w@, // bits of a coordinate //@ !shared
//@ if !shared
  parameter DIGITS = @digits@, // radix-4 digits of a z sum //@ biased
//@ end
  parameter Z_W = @z_w@ // bits of a z sum
) (
//@ if !chained_g
  input  wire                  clk,    // clock
  input  wire                  advance, // registers move //@ gated
//@ end
//@ if shared
  input  wire signed [Z_W-1:0] diff_1, // z difference + BIAS
  input  wire signed [Z_W-1:0] diff_2, // z difference + BIAS
  output @net_g@ signed [Z_W-1:0] z       // z sum + 2 BIAS
);
//@ if chained_g
  assign z = diff_1 + diff_2;
//@ else
  always @(posedge clk) begin //@ !gated
  always @(posedge clk) if (advance) begin //@ gated
    z <= diff_1 + diff_2;
  end
//@ end
//@ else
  input  wire signed [W-1:0]   z_p,    // coordinate
  input  wire signed [W-1:0]   z_q,    // coordinate
  input  wire signed [W-1:0]   z_r,    // coordinate
  input  wire signed [W-1:0]   z_s,    // coordinate
  output @net_g@ signed [Z_W-1:0] z       // z sum@plus_bias@
);
//@ if biased
  // 1 for each digit but the highest.
  localparam [Z_W-1:0] BIAS = {{(Z_W+2-2*DIGITS){1'b0}}, {(DIGITS-1){2'b01}}};

//@ end
  function [Z_W-1:0] wide(input [W-1:0] coordinate);
    wide = {{(Z_W-W){coordinate[W-1]}}, coordinate};
  endfunction
//@ if biased
  wire [Z_W-1:0] three_sum, three_carry, sum, carry;

  sepax_csa #(.N(Z_W)) three (
    .a(wide(z_p)), .b(wide(z_q)), .c(~wide(z_r)),
    .carry_in(1'b1), .sum(three_sum), .carry(three_carry)
  );
  sepax_csa #(.N(Z_W)) four (
    .a(three_sum), .b(three_carry), .c(~wide(z_s)), .carry_in(1'b1), .sum(sum), .carry(carry)
  );

//@ end
//@ if chained_g
  assign z = sum + carry + BIAS;
//@ else
  always @(posedge clk) begin //@ !gated
  always @(posedge clk) if (advance) begin //@ gated
    z <= sum + carry + BIAS; //@ biased
    z <= (wide(z_p) - wide(z_r)) + (wide(z_q) - wide(z_s)); //@ !biased
  end
//@ end
//@ end
endmodule
