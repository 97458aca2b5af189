// SPDX-License-Identifier: MIT
// boxes_properties.v - a box that holds a turned vertex is hit (docs/reference/tree-engine.md, "Why
// nothing is missed"), in two steps, for Yosys' SAT solver. Registers are wires: inputs stand.
// Macros:
//   TERM    entry 3 i + k of the matrix; AXIS: i; BIAS of sepax_turn_box
//   M_W     bits of an entry of the matrix, worth 2^M_AT
//   E_W     bits of exponents; X_W, SIGMA_W, TERM_W of X, of sigma, of the sum of products
// Full widths: 22 and 0; 4; 45, 24, 22.
`default_nettype none

// Term k of a turned box's sum, N_k end_k, stands for M_k q_k of any q_k in the child's cells: in
// units of 2^(10 + g), it is not above by more than 2^6, or of the upper end not below.
module term_properties (
    input wire clk, upper, side,
    input wire signed [`M_W-1:0] m,       // M_k / 2^M_AT
    input wire [3*`E_W-1:0] s_e, t_e,     // exponents of S, of T
    input wire signed [7:0] low, high, b, // cells of the child, one of them
    input wire [14:0] fine                // where in it
);
  localparam I = `TERM / 3, K = `TERM % 3, SUM = 19 + `M_W + 2 * (1 << `E_W);
  wire signed [21:0] wide = m * (22'sd1 <<< `M_AT);
  wire [233:0] matrix = {221'd0, wide[21:9]} << 13 * (side ? `TERM + 9 : `TERM);
  wire [11:0] s_exponents, t_exponents;
  wire [107:0] n;
  wire [8:0] low_end = low + `BIAS, high_end = high + 9'sd1 + `BIAS;
  genvar k;
  generate
    for (k = 0; k < 3; k = k + 1) begin : axis
      assign s_exponents[4*k +: 4] = s_e[`E_W*k +: `E_W];
      assign t_exponents[4*k +: 4] = t_e[`E_W*k +: `E_W];
    end
  endgenerate
  sepax_tree_setup setup (
      .clk(clk), .matrix(matrix), .sigma(144'd0), .begin_in(1'b1), .side(side),
      .s_exponents(s_exponents), .t_exponents(t_exponents), .x_valid(1'b1), .x(105'd0),
      .load(1'b1), .n(n));
  sepax_turn_box turn (
      .clk(clk), .upper(upper), .lows({18'd0, low_end} << 9 * K),
      .highs({18'd0, high_end} << 9 * K), .n(n), .start(63'd0), .shift(12'd0));
  (* hierconn *) wire [26:0] \turn.axis[0].ends , \turn.axis[1].ends , \turn.axis[2].ends ;
  wire [26:0] ends = I == 0 ? \turn.axis[0].ends : I == 1 ? \turn.axis[1].ends :
                     \turn.axis[2].ends ;
  wire signed [8:0] end_k = ends[9*K +: 9] - `BIAS;
  wire signed [11:0] n_k = n[12*`TERM +: 12];
  wire [3:0] e = s_exponents[4*K +: 4];
  wire [3:0] e_01 = s_exponents[3:0] > s_exponents[7:4] ? s_exponents[3:0] : s_exponents[7:4];
  wire [3:0] e_max = s_exponents[11:8] > e_01 ? s_exponents[11:8] : e_01;
  wire [3:0] e_t = t_exponents[4*I +: 4];
  wire [3:0] g = e_max > e_t ? e_max : e_t;
  wire signed [SUM-1:0] q = ($signed(b) <<< e) + $signed({1'b0, fine});
  wire signed [SUM-1:0] product = (m * q) <<< `M_AT;
  wire signed [SUM-1:0] term = (n_k * end_k) <<< (10 + g);
  wire signed [SUM-1:0] slack = 1 << (16 + g);
  wire inside = low <= b && b <= high && (fine >> e) == 15'd0;
  always @* begin
    assert (!inside || (upper ? term >= product - slack : term <= product + slack));
  end
endmodule

// The sum of any three terms of which that is true: where the turned vertex, moved by sigma at
// most, is in a cell of T's child, the child is hit. y: the least that it can be, or of the upper
// end the highest, X + sum of M_k q_k - 2^20 o_T in 2^-20 LSB.
module sum_properties (
    input wire clk, upper, side,
    input wire [3*`E_W-1:0] s_e, t_e,
    input wire signed [`X_W-1:0] x,
    input wire [`SIGMA_W-1:0] sigma,
    input wire signed [7:0] t_cell,
    input wire signed [`TERM_W-1:0] term // sum of three N_k end_k
);
  localparam I = `AXIS;
  localparam signed [21:0] MOST = 22'sd393216; // three times 1024 x 128
  wire [11:0] s_exponents, t_exponents, shift;
  wire [107:0] n;
  wire [62:0] low_start, high_start;
  wire [143:0] sigmas = {{(144-`SIGMA_W){1'b0}}, sigma} << 24 * (side ? I + 3 : I);
  wire signed [44:0] wide_x = x;
  wire signed [21:0] wide_term = term;
  wire [23:0] cells;
  wire [15:0] hits;
  wire beyond;
  genvar k;
  generate
    for (k = 0; k < 3; k = k + 1) begin : axis
      assign s_exponents[4*k +: 4] = s_e[`E_W*k +: `E_W];
      assign t_exponents[4*k +: 4] = t_e[`E_W*k +: `E_W];
    end
  endgenerate
  sepax_tree_setup setup (
      .clk(clk), .matrix(234'd0), .sigma(sigmas), .begin_in(1'b1), .side(side),
      .s_exponents(s_exponents), .t_exponents(t_exponents), .x_valid(1'b1),
      .x({70'd0, wide_x[44:10]} << 35 * I), .load(1'b1), .n(n), .low(low_start),
      .high(high_start), .shift(shift));
  // The sum of products comes in place of N; the module below hands it on.
  sepax_turn_box turn (
      .clk(clk), .upper(upper), .lows(27'd0), .highs(27'd0), .n({86'd0, wide_term} << 36 * I),
      .start(upper ? high_start : low_start), .shift(shift), .cells(cells), .beyond(beyond));
  wire [7:0] bound = upper ? ~t_cell : t_cell;
  sepax_lanes lanes (
      .cells(cells), .beyond(beyond), .hits(hits),
      .bounds({16{(24'h7f7f7f & ~(24'hff << 8 * I)) | ({16'd0, bound} << 8 * I)}}));
  wire [3:0] e_01 = s_exponents[3:0] > s_exponents[7:4] ? s_exponents[3:0] : s_exponents[7:4];
  wire [3:0] e_max = s_exponents[11:8] > e_01 ? s_exponents[11:8] : e_01;
  wire [3:0] e_t = t_exponents[4*I +: 4];
  wire [3:0] g = e_max > e_t ? e_max : e_t;
  wire signed [51:0] more = (52'sd3 <<< (16 + g)) + $signed({1'b0, sigma, 10'd0});
  wire signed [51:0] y = wide_x + ($signed(term) <<< (10 + g)) + (upper ? more : -more);
  wire signed [51:0] end_of_cell = ($signed(t_cell) + (upper ? 52'sd0 : 52'sd1)) <<< (20 + e_t);
  always @* begin
    assert (wide_term > MOST || wide_term < -MOST || (&hits) ||
            (upper ? y < end_of_cell : y >= end_of_cell));
  end
endmodule

// In the place of sums of products.
module sepax_products3_12x9 (
    input wire [35:0] a,
    input wire [26:0] b,
    input wire signed [20:0] c,
    output wire signed [21:0] p
);
  assign p = c + $signed(a[21:0]);
endmodule

`default_nettype wire
