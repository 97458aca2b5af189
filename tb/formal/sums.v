// SPDX-License-Identifier: MIT
// sums.v - the formulas of the sums, differences and factors of architecture exact, for ABC.
// Registers are wires: inputs stand. In the place of a multiplier is one of any results, of which
// the factors are looked at. Macros: W, G_W, Z_W, O_W, V_W, DIGITS, as in sepax_core; OWN_DIGITS,
// those of B's z sum; A_W, ROW_W: a row of a multiplier. SHARED, RUNNING: how II = 1 and II = 3
// sum.
`default_nettype none

module any_product #(
    parameter A_W = 1, B_W = 1, P_W = 1
) (
    input wire signed [A_W-1:0] a,
    input wire signed [B_W-1:0] b,
    output wire signed [P_W-1:0] p
);
  (* anyseq *) wire signed [P_W-1:0] any;
  assign p = any;
endmodule

// 1 + 4 + 16 ..., and the digits of what is recoded: the highest is worth -2 ... 2.
module digits #(
    parameter COUNT = 2
) (
    output wire signed [63:0] bias,
    input wire signed [63:0] b,
    output wire fit
);
  assign bias = {{(66-2*COUNT){1'b0}}, {(COUNT-1){2'b01}}};
  wire signed [63:0] highest = b >>> 2 * (COUNT - 1);
  assign fit = highest >= -64'sd2 && highest <= 64'sd2;
endmodule

module trapezoid (
    input wire clk,
    input wire signed [`W-1:0] x_from, x_to, y_from, y_to
);
  wire signed [`G_W-1:0] t;
`ifdef AB
  wire [1:0] order;
  sepax_trapezoid_ab dut (
      .clk(clk), .x_from(x_from), .x_to(x_to), .y_from(y_from), .y_to(y_to), .t(t), .order(order));
`else
  wire [1:0] order = {x_to > x_from, x_to < x_from};
  sepax_trapezoid dut (
      .clk(clk), .x_from(x_from), .x_to(x_to), .y_from(y_from), .y_to(y_to), .t(t));
`endif
  (* hierconn *) wire signed [`W:0] \dut.multiply.a , \dut.multiply.b ;
  (* hierconn *) wire signed [`G_W-1:0] \dut.multiply.p ;
  wire signed [63:0] a = \dut.multiply.a , b = \dut.multiply.b ;
  wire fit;
  digits #(.COUNT((`W + 2) / 2)) of_b (.b(b), .fit(fit));
  always @* begin
    assert (a == x_to - x_from + 64'sd0);
    assert (b == y_from + y_to + 64'sd0);
    assert (fit);
    assert (t == \dut.multiply.p );
    assert (order == {x_to > x_from, x_to < x_from});
  end
endmodule

module area (
    input wire clk,
    input wire signed [`G_W-1:0] p, q, r
);
  wire signed [`G_W-1:0] g;
  sepax_orient2d dut (.clk(clk), .p(p), .q(q), .r(r), .g(g));
  always @* assert (g == p + q - r);
endmodule

module own_area (
    input wire clk,
    input wire signed [`G_W-1:0] p, q, r
);
  wire signed [`G_W-1:0] g;
  sepax_own_orient2d dut (.clk(clk), .p(p), .q(q), .r(r), .g(g));
  always @* assert (g == p + q + r);
endmodule

module weight (
    input wire clk,
    input wire signed [`W-1:0] z_p, z_q, z_r, z_s
);
  wire signed [`Z_W-1:0] z, diff_1, diff_2;
  wire signed [63:0] bias, sum = z, difference = diff_1;
  wire fit, fits;
  digits #(.COUNT(`DIGITS)) of_z (.bias(bias), .b(sum), .fit(fit));
  digits #(.COUNT(`DIGITS)) of_diff (.b(difference), .fit(fits));
  sepax_zdiff of_1 (
`ifdef CLOCKED
      .clk(clk),
`endif
      .z_p(z_p), .z_r(z_r), .z(diff_1));
`ifdef SHARED
  sepax_zdiff of_2 (
`ifdef CLOCKED
      .clk(clk),
`endif
      .z_p(z_q), .z_r(z_s), .z(diff_2));
  sepax_zsum dut (.clk(clk), .diff_1(diff_1), .diff_2(diff_2), .z(z));
  wire signed [63:0] twice = bias + bias;
  always @* begin
    assert (sum == z_p + z_q - z_r - z_s + twice);
  end
`else
  sepax_zsum dut (.clk(clk), .z_p(z_p), .z_q(z_q), .z_r(z_r), .z_s(z_s), .z(z));
  always @* begin
    assert (sum == z_p + z_q - z_r - z_s + bias);
  end
`endif
  always @* begin
    assert (difference == z_p - z_r + bias);
    assert (fit && fits);
  end
endmodule

// Modulo 2^O_W; the exact sum is in the range of its digits.
module own_weight (
    input wire clk,
    input wire signed [`O_W-1:0] so_far,
    input wire signed [`Z_W-1:0] diff_1, diff_2, diff_3,
    input wire signed [`W-1:0] z_a, z_b,
    input wire signed [`W:0] of_1, of_2, of_3 // z differences without a bias
);
  localparam signed [`W:0] MOST = (1 << `W) - 1;
  wire signed [`O_W-1:0] z;
  wire signed [63:0] bias, diff_bias;
  wire fit;
  digits #(.COUNT(`OWN_DIGITS)) of_sum (.bias(bias), .b(of_1 + of_2 + of_3 + bias), .fit(fit));
  digits #(.COUNT(`DIGITS)) of_diff (.bias(diff_bias), .b(64'd0));
  wire signed [`O_W-1:0] change = bias - diff_bias - diff_bias - diff_bias;
  always @* begin
    assert (fit || of_1 < -MOST || of_2 < -MOST || of_3 < -MOST);
  end
`ifdef SHARED
  wire signed [`O_W-1:0] sum = diff_1 + diff_2 + diff_3 + change;
  sepax_own_zsum dut (
      .clk(clk), .diff_1(diff_1), .diff_2(diff_2), .diff_3(diff_3), .z(z));
`else
  wire signed [`O_W-1:0] sum = so_far + z_b - z_a;
  sepax_own_zsum dut (.clk(clk), .so_far(so_far), .z_a(z_a), .z_b(z_b), .z(z));
`endif
  always @* assert (z == sum);
endmodule

`ifdef VOLUME
module volume (
    input wire clk,
    input wire signed [`G_W-1:0] g,
    input wire signed [`O_W-1:0] z
);
  localparam WIDTH = `Z_OF;
  wire signed [`V_W-1:0] h;
  wire signed [WIDTH-1:0] z_of = z[WIDTH-1:0];
  `VOLUME dut (.clk(clk), .g(g), .z(z_of), .h(h));
  (* hierconn *) wire signed [`G_W-1:0] \dut.multiply.a ;
  (* hierconn *) wire signed [WIDTH-1:0] \dut.multiply.b ;
  (* hierconn *) wire signed [`V_W-1:0] \dut.multiply.p ;
  always @* begin
    assert (\dut.multiply.a == g);
    assert (\dut.multiply.b == z_of);
    assert (\dut.multiply.p == h);
  end
endmodule
`endif

// Sums of signed prism volumes, modulo 2^V_W.
module sums (
    input wire clk,
    input wire signed [`V_W-1:0] p, q, r, s
);
  wire [1:0] sign_b, sign_edges;
  wire signed [`V_W-1:0] of_b = p + q + r - s, of_edges = p + q - r - s;
  sepax_orient3d_b vertex_of_b (.clk(clk), .p(p), .q(q), .r(r), .s(s), .sign(sign_b));
  sepax_orient3d_edges edges (.clk(clk), .p(p), .q(q), .r(r), .s(s), .sign(sign_edges));
`ifdef RUNNING
  wire signed [`V_W-1:0] sum;
  sepax_orient3d_a vertex_of_a (.clk(clk), .p(p), .q(q), .sum(sum));
  always @* assert (sum == p + q);
`else
  wire [1:0] sign_a;
  wire signed [`V_W-1:0] of_a = p + q + r;
  sepax_orient3d_a vertex_of_a (.clk(clk), .p(p), .q(q), .r(r), .sign(sign_a));
  always @* assert (sign_a == {of_a > 0, of_a < 0});
`endif
  always @* begin
    assert (sign_b == {of_b > 0, of_b < 0});
    assert (sign_edges == {of_edges > 0, of_edges < 0});
  end
endmodule

`ifdef ROW_W
// Rows of multipliers: digit a = row + negative, modulo 2^ROW_W.
module rows (
    input wire signed [`A_W-1:0] a,
    input wire [2:0] b
);
  wire [`ROW_W-1:0] row;
  wire negative;
`ifdef TOP_DIGIT
  wire signed [2:0] digit = b;
  sepax_top_digit #(.A_W(`A_W), .ROW_W(`ROW_W)) dut (
      .a(a), .b(b), .row(row), .negative(negative));
  wire counts = digit >= -3'sd2 && digit <= 3'sd2;
`else
`ifdef TWO_LESS
  wire signed [3:0] digit = {2'd0, b[1:0]} - 4'd2;
  sepax_digit_2 #(.A_W(`A_W), .ROW_W(`ROW_W)) dut (
      .a(a), .b(b[1:0]), .row(row), .negative(negative));
`else
  wire signed [3:0] digit = {2'd0, b[1:0]} - 4'd1;
  sepax_digit #(.A_W(`A_W), .ROW_W(`ROW_W)) dut (
      .a(a), .b(b[1:0]), .row(row), .negative(negative));
`endif
  wire counts = 1'b1;
`endif
  wire signed [`A_W+1:0] product = digit * a;
  wire [`ROW_W-1:0] sum = row + {{(`ROW_W-1){1'b0}}, negative};
  always @* assert (!counts || sum == product[`ROW_W-1:0]);
endmodule
`endif

// A full adder of each column.
module adders (
    input wire [7:0] a, b, c
);
  wire [7:0] sum, carry;
  sepax_fa #(.N(8)) dut (.a(a), .b(b), .c(c), .sum(sum), .carry(carry));
  genvar n;
  generate
    for (n = 0; n < 8; n = n + 1) begin : column
      always @* assert ({carry[n], sum[n]} == {1'b0, a[n]} + {1'b0, b[n]} + {1'b0, c[n]});
    end
  endgenerate
endmodule

`default_nettype wire
