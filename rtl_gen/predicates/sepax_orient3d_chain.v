// SPDX-License-Identifier: MIT
// @what@ of @points@:
// six times the signed volume of the tetrahedron, modulo 2^V_W, from the prisms of its faces:
//   volume = @formula@, on carry chains. Latency @latency@.
module @name@ #(
  parameter V_W = @v_w@ // bits of an orient3d
) (
  input  wire                  clk,    // clock
  input  wire signed [V_W-1:0] p,      // signed prism volume
  input  wire signed [V_W-1:0] q,      // signed prism volume
  input  wire signed [V_W-1:0] r,      // signed prism volume
  input  wire signed [V_W-1:0] s,      // signed prism volume //@ four
  output reg  signed [V_W-1:0] volume  // orient3d //@ whole
  output reg         [1:0]     sign    // {volume > 0, volume < 0} //@ !whole
);
  reg signed [V_W-1:0] p_q, q_q, r_q; //@ fetch_3d
  reg signed [V_W-1:0] s_q; //@ fetch_four
  reg signed [V_W-1:0] first_q, second_q; //@ rows
//@ if !whole
  reg signed [V_W-1:0] volume; //@ registered
  wire signed [V_W-1:0] volume = @sum@; //@ !registered
//@ end

  always @(posedge clk) begin
//@ if fetch_3d
    p_q <= p;
    q_q <= q;
    r_q <= r;
    s_q <= s; //@ four
//@ end
    first_q <= @first@; //@ rows
    second_q <= @second@; //@ rows
    volume <= @sum@; //@ registered
    sign <= {!volume[V_W-1] && (volume != {V_W{1'b0}}), volume[V_W-1]}; //@ !whole
  end
endmodule
