// What twice an orient2d over an edge (X, Y, Z) must exceed, in the projection on x and y:
// (2 + D) (|X| + |Y|) + D max(|X|, |Y|), likewise on y and z, on z and x; for each clearance D.
// Latency @latency@.
module sepax_edge_limit #(
  parameter W = @w@,     // bits of a coordinate
  parameter L_W = @l_w@, // bits of a limit
  parameter M_W = @m_w@  // bits of the limits of all clearances
) (
  input  wire                clk,      // clock
  input  wire signed [W-1:0] x_from,   // coordinate
  input  wire signed [W-1:0] x_to,     // coordinate
  input  wire signed [W-1:0] y_from,   // coordinate
  input  wire signed [W-1:0] y_to,     // coordinate
  input  wire signed [W-1:0] z_from,   // coordinate
  input  wire signed [W-1:0] z_to,     // coordinate
  output wire [M_W-1:0]      limit_xy, // for each clearance, the inner in the lower half
  output wire [M_W-1:0]      limit_yz, // likewise
  output wire [M_W-1:0]      limit_zx  // likewise
);
  reg [3*W-1:0] size_q; // |Z|, |Y|, |X|
  wire [3*M_W-1:0] limit;

  always @(posedge clk) begin
    size_q <= {(z_to < z_from) ? z_from - z_to : z_to - z_from,
               (y_to < y_from) ? y_from - y_to : y_to - y_from,
               (x_to < x_from) ? x_from - x_to : x_to - x_from};
  end

  genvar n;
  generate
    for (n = 0; n < 3; n = n + 1) begin : projection
      wire [W-1:0] size_1;
      wire [W-1:0] size_2;
      reg [W:0] sum_q;
      reg [L_W-1:0] limit_1_q;
      reg [W-1:0] most_q; //@ most
      reg [L_W-1:0] limit_2_q; //@ two_limits
//@ if parts
      reg [L_W-1:0] of_sum_1_q;
      reg [L_W-1:0] of_most_1_q;
      reg [L_W-1:0] of_sum_2_q; //@ two_limits
      reg [L_W-1:0] of_most_2_q; //@ two_limits
//@ end

      assign size_1 = size_q[n*W +: W];
      assign size_2 = size_q[((n+1)%3)*W +: W];
      always @(posedge clk) begin
        sum_q <= {1'b0, size_1} + {1'b0, size_2};
        most_q <= (size_1 > size_2) ? size_1 : size_2; //@ most
//@ if parts
        of_sum_1_q <= @of_sum_1@;
        of_most_1_q <= @of_most_1@;
        limit_1_q <= of_sum_1_q + of_most_1_q;
//@ if two_limits
        of_sum_2_q <= @of_sum_2@;
        of_most_2_q <= @of_most_2@;
        limit_2_q <= of_sum_2_q + of_most_2_q;
//@ end
//@ else
        limit_1_q <= @limit_1@;
        limit_2_q <= @limit_2@; //@ two_limits
//@ end
      end
      assign limit[n*M_W +: M_W] = {limit_2_q, limit_1_q}; //@ two_limits
      assign limit[n*M_W +: M_W] = limit_1_q; //@ !two_limits
    end
  endgenerate

  assign limit_xy = limit[0*M_W +: M_W];
  assign limit_yz = limit[1*M_W +: M_W];
  assign limit_zx = limit[2*M_W +: M_W];
endmodule
