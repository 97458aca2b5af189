// SPDX-License-Identifier: MIT
// One end of a turned box, in cells of T. For each axis i:
//   sum_i = start_i + sum over k of n_ik e_k. If upper = 0, e_k is the lower end of the box for
//   n_ik >= 0 and the upper end for n_ik < 0. If upper = 1, it is the other end.
//   cell_i = floor(sum_i 2^shift_i / 2^10). If upper = 1, the output is -1 - cell_i instead.
// A cell above 127 sets `beyond`, and a cell below -128 becomes -128. Neither changes a comparison
// with cells of 8 bits. Both ends come biased by @bias@; the upper end is high + 1.
// Latency 2; shift comes one cycle after the ends. //@ !fpga
// Latency @cells@; shift comes @sums@ cycles after the ends. //@ fpga
module sepax_turn_box (
  input  wire         clk,    // clock
  input  wire         upper,  // 1: the upper end; 0: the lower end
  input  wire [26:0]  lows,   // {z, y, x}: low + @bias@, 9 bits each, signed
  input  wire [26:0]  highs,  // {z, y, x}: high + 1 + @bias@
  input  wire [107:0] n,      // entry (i, k) at 12 (3 i + k), signed
  input  wire [62:0]  start,  // {2, 1, 0}, 21 bits each, signed: low or high of the set-up
  input  wire [11:0]  shift,  // {2, 1, 0}, 0 ... 15
  output reg  [23:0]  cells,  // {2, 1, 0}, 8 bits each, signed
  output wire         beyond  // the cell is above all cells
);
  reg       upper_q; //@ !fpga
  wire      upper_q = upper; //@ fpga
  reg [2:0] beyond_q;
  assign beyond = |beyond_q;

  genvar i, k;
  generate
    for (i = 0; i < 3; i = i + 1) begin : axis
      wire [26:0] ends;
      wire [21:0] sum;
      reg  [21:0] sum_q;
      for (k = 0; k < 3; k = k + 1) begin : column
        assign ends[9*k +: 9] = (n[36*i+12*k+11] ^ upper) ? highs[9*k +: 9] : lows[9*k +: 9];
      end
      @dot@ products (
        .clk(clk), //@ fpga
        .a(n[36*i +: 36]), .b(ends), .c(start[21*i +: 21]), .p(sum)
      );

      // Bits that differ from the sign. If one is shifted beyond bit 16, the cell is too large.
      wire        sign = sum_q[21];
      wire [3:0]  by = shift[4*i +: 4];
      wire [20:0] size = sum_q[20:0] ^ {21{sign}};
      wire [16:0] by_8 = by[3] ? {size[8:0], {8{sign}}} : size[16:0];
      wire [16:0] by_4 = by[2] ? {by_8[12:0], {4{sign}}} : by_8;
      //@ if fpga
      wire        far = (|size[20:17]) || (by[3] && (|size[16:9])) || (by[2] && (|by_8[16:13]));
      reg  [16:0] by_4_q;
      reg  [1:0]  by_q;
      reg         sign_q, far_q;
      wire [16:0] by_2 = by_q[1] ? {by_4_q[14:0], {2{sign_q}}} : by_4_q;
      wire [16:0] by_1 = by_q[0] ? {by_2[15:0], sign_q} : by_2;
      wire        over = far_q || (by_q[1] && (|by_4_q[16:15])) || (by_q[0] && by_2[16]);
      wire        negative = sign_q ^ upper_q;
      //@ else
      wire [16:0] by_2 = by[1] ? {by_4[14:0], {2{sign}}} : by_4;
      wire [16:0] by_1 = by[0] ? {by_2[15:0], sign} : by_2;
      wire        over = (|size[20:17]) || (by[3] && (|size[16:9])) || (by[2] && (|by_8[16:13])) ||
                         (by[1] && (|by_4[16:15])) || (by[0] && by_2[16]);
      wire        negative = sign ^ upper_q;
      //@ end
      wire [9:0]  unused_fraction = by_1[9:0];

      always @(posedge clk) begin
        sum_q <= sum;
        {by_4_q, by_q, sign_q, far_q} <= {by_4, by[1:0], sign, far}; //@ fpga
        cells[8*i +: 8] <= {negative, (by_1[16:10] ^ {7{negative}}) & {7{!over}}};
        beyond_q[i] <= over && !negative;
      end
    end
  endgenerate
//@ if !fpga

  always @(posedge clk) begin
    upper_q <= upper;
  end
//@ end
endmodule
