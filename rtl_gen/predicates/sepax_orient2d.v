// SPDX-License-Identifier: MIT
// orient2d of three vertices of both triangles: twice the signed area in a projection, //@ !own
// orient2d of the vertices of A or of B: twice its signed area in a projection, //@ own
// from the trapezoid terms of the edges: g = p + q @plus_r@ r modulo 2^G_W. Latency @clocks_2d@.
module @name@ #(
  parameter G_W = @g_w@ // bits of an orient2d
) (
//@ if !chained_g
  input  wire                  clk, // clock
  input  wire                  advance, // registers move //@ gated
//@ end
  input  wire signed [G_W-1:0] p,   // trapezoid term
  input  wire signed [G_W-1:0] q,   // trapezoid term
  input  wire signed [G_W-1:0] r,   // trapezoid term
  output @net_g@ signed [G_W-1:0] g    // twice the area
);
  reg signed [G_W-1:0] p_q, q_q, r_q; //@ fetch_2d
//@ if !chain
  wire [G_W-1:0] sum, carry;

  sepax_csa #(.N(G_W)) three (
    .a(p), .b(q), .c(r), .carry_in(1'b0), .sum(sum), .carry(carry) //@ own
    .a(p), .b(q), .c(~r), .carry_in(1'b1), .sum(sum), .carry(carry) //@ !own
  );

//@ end
//@ if chained_g
  assign g = sum + carry;
//@ else
  always @(posedge clk) begin //@ !gated
  always @(posedge clk) if (advance) begin //@ gated
    g <= sum + carry; //@ !chain
//@ if fetch_2d
    p_q <= p;
    q_q <= q;
    r_q <= r;
//@ end
    g <= @orient2d_sum@; //@ chain
  end
//@ end
endmodule
