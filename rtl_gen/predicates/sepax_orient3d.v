// SPDX-License-Identifier: MIT
// @what@ of @points@:
// six times the signed volume of the tetrahedron, modulo 2^V_W, from the prisms of its faces:
//   volume = @formula@. Latency @latency@.
module @name@ #(
  parameter V_W = @v_w@ // bits of an orient3d
) (
//@ if !chained_d
  input  wire                  clk,    // clock
  input  wire                  advance, // registers move //@ gated
//@ end
  input  wire signed [V_W-1:0] p,      // signed prism volume
  input  wire signed [V_W-1:0] q,      // signed prism volume
  input  wire signed [V_W-1:0] r,      // signed prism volume
  input  wire signed [V_W-1:0] s,      // signed prism volume //@ four
  output reg  signed [V_W-1:0] volume  // orient3d //@ whole
  output @net_d@        [1:0]     sign    // {volume > 0, volume < 0} //@ !whole
);
  wire [V_W-1:0] three_sum, three_carry; //@ four
  wire [V_W-1:0] sum, carry;
  reg  [V_W-1:0] sum_q, carry_q; //@ rows

  sepax_csa #(.N(V_W)) three (
    .a(p), .b(q), .c(~r), .carry_in(1'b1), //@ minus_r
    .a(p), .b(q), .c(r), .carry_in(1'b0), //@ !minus_r
    .sum(three_sum), .carry(three_carry) //@ four
    .sum(sum), .carry(carry) //@ !four
  );
//@ if four
  sepax_csa #(.N(V_W)) four (
    .a(three_sum), .b(three_carry), .c(~s), .carry_in(1'b1), .sum(sum), .carry(carry)
  );
//@ end
//@ if !whole

  reg  [V_W-1:0] volume; //@ registered
  wire [V_W-1:0] volume = @sum@; //@ !registered
//@ end

//@ if chained_d
  assign sign = {!volume[V_W-1] && (volume != {V_W{1'b0}}), volume[V_W-1]};
//@ else
  always @(posedge clk) begin //@ !gated
  always @(posedge clk) if (advance) begin //@ gated
    sum_q <= sum; //@ rows
    carry_q <= carry; //@ rows
    volume <= @sum@; //@ registered
    sign <= {!volume[V_W-1] && (volume != {V_W{1'b0}}), volume[V_W-1]}; //@ !whole
  end
//@ end
endmodule
