// SPDX-License-Identifier: MIT
// The trapezoid term of an edge: twice the area between the edge and the x axis in a projection,
//@ if biased
//   t = (x_to - x_from) (y_from + y_to - BIAS) modulo 2^G_W, BIAS = 1 + 4 + 16 ... = @bias@.
// y is offset by BIAS / 2, because the recoded multiplier computes a (b - BIAS). The offset cancels
// in every closed sum. Latency @latency@.
//@ else
//   t = (x_to - x_from) (y_from + y_to) modulo 2^G_W. Latency @latency@.
//@ end
// Beside it the order of the edge's ends in x. //@ order
module @name@ #(
  parameter W = @w@,     // bits of a coordinate
  parameter S_W = @s_w@, // bits of a sum or difference, W + 1
  parameter G_W = @g_w@  // bits of t
) (
//@ if !chained_t
  input  wire                  clk,    // clock
  input  wire                  advance, // registers move //@ gated
//@ end
  input  wire signed [W-1:0]   x_from, // coordinate
  input  wire signed [W-1:0]   x_to,   // coordinate
  input  wire signed [W-1:0]   y_from, // coordinate
  input  wire signed [W-1:0]   y_to,   // coordinate
//@ if chained_t
  output wire        [1:0]     order,  // {x_to > x_from, x_to < x_from} //@ order
  output wire signed [G_W-1:0] t       // trapezoid term
//@ else
  output reg         [1:0]     order,  // {x_to > x_from, x_to < x_from}, @order_clocks@ //@ order
  output reg  signed [G_W-1:0] t       // trapezoid term
//@ end
);
  wire signed [S_W-1:0] run = {x_to[W-1], x_to} - {x_from[W-1], x_from};
  wire signed [S_W-1:0] height = {y_to[W-1], y_to} + {y_from[W-1], y_from};
  reg signed [S_W-1:0] run_q, height_q; //@ sums
  wire signed [G_W-1:0] product;

  @multiplier@ multiply (
    .clk(clk), //@ clocked
    .a(run_q), .b(height_q), .p(product) //@ sums
    .a(run), .b(height), .p(product) //@ !sums
  );

//@ if chained_t
  assign t = product;
  assign order = {!run[S_W-1] && (run != {S_W{1'b0}}), run[S_W-1]}; //@ order
//@ else
  always @(posedge clk) begin //@ !gated
  always @(posedge clk) if (advance) begin //@ gated
    run_q <= run; //@ sums
    height_q <= height; //@ sums
    t <= product;
    order <= {!run@order_q@[S_W-1] && (run@order_q@ != {S_W{1'b0}}), run@order_q@[S_W-1]}; //@ order
  end
//@ end
endmodule
