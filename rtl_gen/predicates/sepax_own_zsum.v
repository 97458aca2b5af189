// SPDX-License-Identifier: MIT
//@ if biased
// z sum of B: the sum of B's z less the sum of A's, since the origin of z is the mean of A's z,
// plus BIAS = 1 + 4 + 16 ..., which the recoded multiplier of the prism deducts.
//@ else
// z sum of B: the sum of B's z less the sum of A's, since the origin of z is the mean of A's z.
//@ end
// One vertex of each triangle a cycle: z = so_far + z_b - z_a. Latency 1. //@ running_biased
// One vertex of each triangle a cycle: z = so_far + diff. Latency 1. //@ running_diffs
//@ if shared
// Made of three z differences, which have brought a DIFF_BIAS of theirs each. @own_latency@
//@ end
// @own_latency@ //@ six
module sepax_own_zsum #(
  parameter Z_W = @z_w@, // bits of a z difference //@ shared
  parameter Z_W = @z_w@, // bits of a z difference //@ running_diffs
  parameter DIFF_DIGITS = @digits@, // radix-4 digits of a z difference //@ shared
  parameter W = @w@, // bits of a coordinate //@ coordinates
//@ if biased
  parameter DIGITS = @own_digits@, // radix-4 digits of the z sum //@ !running
//@ end
  parameter O_W = @o_w@ // bits of the z sum
) (
//@ if !own_wire
  input  wire                  clk,    // clock
  input  wire                  advance, // registers move //@ gated
//@ end
//@ if running
  input  wire signed [O_W-1:0] so_far, // @so_far@, or the sum that has no third vertices yet
  input  wire signed [W-1:0]   z_a,    // coordinate //@ biased
  input  wire signed [W-1:0]   z_b,    // coordinate //@ biased
  input  wire signed [Z_W-1:0] diff,   // z of B's vertex less z of A's //@ !biased
//@ end
//@ if shared
  input  wire signed [Z_W-1:0] diff_1, // z of B_1 less z of A_1, + DIFF_BIAS
  input  wire signed [Z_W-1:0] diff_2, // z of B_2 less z of A_2, + DIFF_BIAS
  input  wire signed [Z_W-1:0] diff_3, // z of B_3 less z of A_3, + DIFF_BIAS
//@ end
//@ if six
  input  wire signed [W-1:0]   z_a1,   // coordinate
  input  wire signed [W-1:0]   z_a2,   // coordinate
  input  wire signed [W-1:0]   z_a3,   // coordinate
  input  wire signed [W-1:0]   z_b1,   // coordinate
  input  wire signed [W-1:0]   z_b2,   // coordinate
  input  wire signed [W-1:0]   z_b3,   // coordinate
//@ end
  output @net_own@ signed [O_W-1:0] z       // z sum@plus_bias@
);
//@ if biased
//@ if !running
  // 1 for each digit but the highest.
  localparam [O_W-1:0] BIAS = {{(O_W+2-2*DIGITS){1'b0}}, {(DIGITS-1){2'b01}}};
//@ end
//@ end
//@ if shared
  localparam [O_W-1:0] DIFF_BIAS = {{(O_W+2-2*DIFF_DIGITS){1'b0}}, {(DIFF_DIGITS-1){2'b01}}};
  // Wires of their own: where O_W = Z_W Yosys takes a port's concatenation for the signed wire.
  wire [O_W-1:0] term_1 = {{(O_W-Z_W+1){diff_1[Z_W-1]}}, diff_1[Z_W-2:0]};
  wire [O_W-1:0] term_2 = {{(O_W-Z_W+1){diff_2[Z_W-1]}}, diff_2[Z_W-2:0]};
  wire [O_W-1:0] term_3 = {{(O_W-Z_W+1){diff_3[Z_W-1]}}, diff_3[Z_W-2:0]};
//@ end
//@ if coordinates
  function [O_W-1:0] wide(input [W-1:0] coordinate);
    wide = {{(O_W-W){coordinate[W-1]}}, coordinate};
  endfunction
//@ end
//@ if biased
  wire [O_W-1:0] sum, carry;

//@ if running
  sepax_csa #(.N(O_W)) three (
    .a(so_far), .b(wide(z_b)), .c(~wide(z_a)), .carry_in(1'b1), .sum(sum), .carry(carry)
  );
//@ end
//@ if shared
  sepax_csa #(.N(O_W)) three (
    .a(term_1), .b(term_2), .c(term_3), .carry_in(1'b0), .sum(sum), .carry(carry)
  );
//@ end
//@ if six
  wire [O_W-1:0] b_sum, b_carry, a_sum, a_carry, five_sum, five_carry;

  sepax_csa #(.N(O_W)) of_b (
    .a(wide(z_b1)), .b(wide(z_b2)), .c(wide(z_b3)), .carry_in(1'b1), .sum(b_sum), .carry(b_carry)
  );
  sepax_csa #(.N(O_W)) of_a (
    .a(~wide(z_a1)), .b(~wide(z_a2)), .c(~wide(z_a3)),
    .carry_in(1'b1), .sum(a_sum), .carry(a_carry)
  );
  sepax_csa #(.N(O_W)) five (
    .a(b_sum), .b(b_carry), .c(a_sum), .carry_in(1'b1), .sum(five_sum), .carry(five_carry)
  );
  sepax_csa #(.N(O_W)) six (
    .a(five_sum), .b(five_carry), .c(a_carry), .carry_in(1'b0), .sum(sum), .carry(carry)
  );
//@ end

//@ if own_wire
  assign z = sum + carry + (BIAS - (DIFF_BIAS + DIFF_BIAS + DIFF_BIAS)); //@ shared
  assign z = sum + carry + BIAS; //@ six
//@ else
  reg [O_W-1:0] sum_q, carry_q; //@ registered
  always @(posedge clk) begin //@ !gated
  always @(posedge clk) if (advance) begin //@ gated
    sum_q <= sum; //@ registered
    carry_q <= carry; //@ registered
    z <= sum + carry; //@ running
    z <= sum + carry + (BIAS - (DIFF_BIAS + DIFF_BIAS + DIFF_BIAS)); //@ shared
    z <= @sum@ + BIAS; //@ six
  end
//@ end
//@ else
  reg [O_W-1:0] b_q, a_q; //@ registered

  always @(posedge clk) begin //@ !gated
  always @(posedge clk) if (advance) begin //@ gated
    z <= {{(O_W-Z_W+1){diff[Z_W-1]}}, diff[Z_W-2:0]} + so_far; //@ running
    b_q <= wide(z_b1) + wide(z_b2) + wide(z_b3); //@ registered
    a_q <= wide(z_a1) + wide(z_a2) + wide(z_a3); //@ registered
    z <= @sum@; //@ six
  end
//@ end
endmodule
