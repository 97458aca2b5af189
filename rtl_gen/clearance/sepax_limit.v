// SPDX-License-Identifier: MIT
// What twice a gap on @what@ must exceed, for each clearance D:
// (2 + D) (|x| + |y| + |z|) + D max(|x|, |y|, |z|). Latency @latency@.
module @name@ #(
  parameter C_W = @c_w@,       // bits of a component
  parameter L_W = @l_w@,       // bits of a limit
  parameter LIMITS = @limits@  // clearances
) (
  input  wire                  clk,  // clock
  input  wire                  advance, // registers move //@ gated
  input  wire signed [C_W-1:0] x,    // component
  input  wire signed [C_W-1:0] y,    // component
  input  wire signed [C_W-1:0] z,    // component
  output reg  [LIMITS*L_W-1:0] limit // for each clearance, the inner in the lower half
);
  reg [C_W-1:0] size_x_q, size_y_q, size_z_q;
  reg [C_W+1:0] sum_q;
  reg [C_W+1:0] sum_q2; //@ registered
//@ if most
  wire [C_W-1:0] most_xy = (size_x_q > size_y_q) ? size_x_q : size_y_q;
  reg [C_W-1:0] most_q;
  reg [C_W-1:0] most_xy_q, size_z_q2; //@ registered
//@ end
  reg [LIMITS*L_W-1:0] of_sum_q, of_most_q; //@ parts
  integer k; //@ parts

  always @(posedge clk) begin //@ !gated
  always @(posedge clk) if (advance) begin //@ gated
    size_x_q <= x[C_W-1] ? -x : x;
    size_y_q <= y[C_W-1] ? -y : y;
    size_z_q <= z[C_W-1] ? -z : z;
    sum_q <= {2'd0, size_x_q} + {2'd0, size_y_q} + {2'd0, size_z_q};
    sum_q2 <= sum_q; //@ registered
//@ if most
//@ if registered
    most_xy_q <= most_xy;
    size_z_q2 <= size_z_q;
    most_q <= (most_xy_q > size_z_q2) ? most_xy_q : size_z_q2;
//@ else
    most_q <= (most_xy > size_z_q) ? most_xy : size_z_q;
//@ end
//@ end
    // (2 + D) sum + D most
//@ if parts
    of_sum_q <= {@of_sum@};
    of_most_q <= {@of_most@};
    for (k = 0; k < LIMITS; k = k + 1) begin
      limit[k*L_W +: L_W] <= of_sum_q[k*L_W +: L_W] + of_most_q[k*L_W +: L_W];
    end
//@ else
    limit <= {@limit@};
//@ end
  end
endmodule
