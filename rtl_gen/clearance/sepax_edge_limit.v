// SPDX-License-Identifier: MIT
// What twice an orient2d over an edge (X, Y, Z) must exceed, in the projection on x and y:
// (2 + D) (|X| + |Y|) + D max(|X|, |Y|), likewise on y and z, on z and x; for each clearance D.
// Latency @latency@.
module sepax_edge_limit #(
  parameter W = @w@,           // bits of a coordinate
  parameter L_W = @l_w@,       // bits of a limit
  parameter LIMITS = @limits@  // clearances
) (
  input  wire                clk,      // clock
  input  wire                advance, // registers move //@ gated
  input  wire signed [W-1:0] x_from,   // coordinate
  input  wire signed [W-1:0] x_to,     // coordinate
  input  wire signed [W-1:0] y_from,   // coordinate
  input  wire signed [W-1:0] y_to,     // coordinate
  input  wire signed [W-1:0] z_from,   // coordinate
  input  wire signed [W-1:0] z_to,     // coordinate
  output wire [LIMITS*L_W-1:0] limit_xy, // for each clearance, the inner in the lower half
  output wire [LIMITS*L_W-1:0] limit_yz, // likewise
  output wire [LIMITS*L_W-1:0] limit_zx  // likewise
);
  localparam M_W = LIMITS * L_W;
  reg [3*W-1:0] size_q; // |Z|, |Y|, |X|
  reg [3*M_W-1:0] limit;

  always @(posedge clk) begin //@ !gated
  always @(posedge clk) if (advance) begin //@ gated
    size_q <= {(z_to < z_from) ? z_from - z_to : z_to - z_from,
               (y_to < y_from) ? y_from - y_to : y_to - y_from,
               (x_to < x_from) ? x_from - x_to : x_to - x_from};
  end

  genvar n;
  generate
    for (n = 0; n < 3; n = n + 1) begin : projection
      wire [W-1:0] size_1 = size_q[n*W +: W];
      wire [W-1:0] size_2 = size_q[((n+1)%3)*W +: W];
      reg [W:0] sum_q;
      reg [W-1:0] most_q; //@ most
      reg [M_W-1:0] of_sum_q, of_most_q; //@ parts
      integer k; //@ parts

      always @(posedge clk) begin //@ !gated
  always @(posedge clk) if (advance) begin //@ gated
        sum_q <= {1'b0, size_1} + {1'b0, size_2};
        most_q <= (size_1 > size_2) ? size_1 : size_2; //@ most
//@ if parts
        of_sum_q <= {@of_sum@};
        of_most_q <= {@of_most@};
        for (k = 0; k < LIMITS; k = k + 1) begin
          limit[n*M_W+k*L_W +: L_W] <= of_sum_q[k*L_W +: L_W] + of_most_q[k*L_W +: L_W];
        end
//@ else
        limit[n*M_W +: M_W] <= {@limit@};
//@ end
      end
    end
  endgenerate

  assign {limit_zx, limit_yz, limit_xy} = limit;
endmodule
