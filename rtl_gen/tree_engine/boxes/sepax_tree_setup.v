// SPDX-License-Identifier: MIT
// Computes the numbers that turn boxes of node S into the cells of node T
// (docs/reference/tree-engine.md, Set-up). With e_max the highest exponent of S and
// g_i = max(e_max, e_Ti):
//   n_ik = floor(M_ik / 2^(10 + g_i - e_Sk) + 1/2), D_i = floor(X_i / 2^(10 + g_i)),
//   s_i = 192 + ceil(sigma_i / 2^g_i), low_i = sat(D_i - s_i), high_i = sat(D_i + 1 + s_i),
//   shift_i = g_i - e_Ti.
// X of an entry comes some cycles after the entry. From the cycle after `load` on, the outputs are
// those of this entry.
module sepax_tree_setup (
  input  wire         clk,       // clock
  input  wire [233:0] matrix,    // M_ik / 2^9 of a side at 13 (9 side + 3 i + k), signed
  input  wire [143:0] sigma,     // sigma_i of a side at 24 (3 side + i)
  input  wire         begin_in,  // an entry comes in
  input  wire         side,      // side of the entry
  input  wire [11:0]  s_exponents, // {z, y, x} of S, 0 ... 15
  input  wire [11:0]  t_exponents, // {z, y, x} of T
  input  wire         x_valid,   // X of the entry has come
  input  wire [104:0] x,         // X / 2^10, {2, 1, 0}, 35 bits each, signed
//@ if fpga
  input  wire         load,      // 2 cycles after x_valid or later, 5 after begin_in or later
//@ else
  input  wire         load,      // in the cycle after x_valid or later, 3 after begin_in or later
//@ end
  output reg  [107:0] n,         // entry (i, k) at 12 (3 i + k), -1024 ... 1024
  output reg  [62:0]  low,       // {2, 1, 0}, 21 bits each, signed //@ !fpga
  output reg  [62:0]  high,      // {2, 1, 0}, 21 bits each, signed //@ !fpga
  output wire [62:0]  low,       // {2, 1, 0}, 21 bits each, signed //@ fpga
  output wire [62:0]  high,      // {2, 1, 0}, 21 bits each, signed //@ fpga
  output reg  [11:0]  shift      // {2, 1, 0}, 0 ... 15
);
  function [3:0] larger(input [3:0] a, input [3:0] b);
    larger = (a > b) ? a : b;
  endfunction

  // Saturates to 21 bits, signed. If `beyond`, only the sign of the value is known.
  function [20:0] saturated(input [26:0] value, input beyond, input negative);
    saturated = beyond ? {negative, {20{!negative}}}
              : ((|value[26:20]) == (&value[26:20])) ? value[20:0]
              : {value[26], {20{!value[26]}}};
  endfunction

  reg         side_q;
  reg  [11:0] s_exponents_q, scales_q, shifts_q; // scales: g
  reg  [104:0] x_q;
  //@ if fpga
  reg  [11:0] t_exponents_q;
  reg  [3:0]  highest_q;
  wire [3:0]  highest =
    larger(larger(s_exponents_q[3:0], s_exponents_q[7:4]), s_exponents_q[11:8]);
  //@ else
  wire [3:0]  highest =
    larger(larger(s_exponents[3:0], s_exponents[7:4]), s_exponents[11:8]);
  //@ end
  wire [71:0]  margin = side_q ? sigma[143:72] : sigma[71:0];

  genvar i, k;
  generate
    for (i = 0; i < 3; i = i + 1) begin : axis
      wire [3:0] scale = larger(highest, t_exponents[4*i +: 4]); //@ !fpga
      wire [3:0] scale = larger(highest_q, t_exponents_q[4*i +: 4]); //@ fpga
      wire [3:0] g = scales_q[4*i +: 4];
      wire signed [34:0] d = $signed(x_q[35*i +: 35]) >>> g; //@ !fpga
      wire [38:0] wide = {margin[24*i +: 24], 15'd0} >> g; //@ !fpga
      //@ if fpga
      reg  signed [34:0] d_q;
      reg  [38:0] wide_q;
      wire signed [34:0] d = d_q;
      wire [38:0] wide = wide_q;
      //@ end
      wire [25:0] s = {1'b0, wide[38:15], |wide[14:0]} + 26'd385; // bits 25:1 are s
      reg  [24:0] s_q;
      wire        unused_half = s[0];
      // s is below 2^25, so if D has more than 26 bits, then D - s and D + s have more than 21
      // bits.
      wire        beyond = (|d[34:25]) != (&d[34:25]);
      wire [26:0] least = {d[25], d[25:0]} - {2'd0, s_q};
      wire [26:0] most = {d[25], d[25:0]} - ~{2'd0, s_q};
      //@ if fpga
      reg  [26:0] least_q, most_q;
      reg         beyond_q, negative_q;
      assign low[21*i +: 21] = saturated(least_q, beyond_q, negative_q);
      assign high[21*i +: 21] = saturated(most_q, beyond_q, negative_q);
      //@ end

      for (k = 0; k < 3; k = k + 1) begin : column
        localparam AT = 3 * i + k;
        //@ if fpga
        reg  [3:0] by_q;
        reg signed [12:0] m_q;
        reg  [12:0] halves_q;
        wire [12:0] halves = halves_q;
        //@ else
        wire [3:0] by = g - s_exponents_q[4*k +: 4];
        wire signed [12:0] m = side_q ? matrix[13*AT+117 +: 13] : matrix[13*AT +: 13];
        wire [12:0] halves = m >>> by;
        //@ end
        always @(posedge clk) begin
          //@ if fpga
          by_q <= g - s_exponents_q[4*k +: 4];
          m_q <= side_q ? matrix[13*AT+117 +: 13] : matrix[13*AT +: 13];
          halves_q <= m_q >>> by_q;
          //@ end
          if (load) begin
            n[12*AT +: 12] <= halves[12:1] + {11'd0, halves[0]};
          end
        end
      end

      always @(posedge clk) begin
        //@ if fpga
        scales_q[4*i +: 4] <= scale;
        shifts_q[4*i +: 4] <= g - t_exponents_q[4*i +: 4];
        d_q <= $signed(x_q[35*i +: 35]) >>> g;
        wide_q <= {margin[24*i +: 24], 15'd0} >> g;
        //@ else
        if (begin_in) begin
          scales_q[4*i +: 4] <= scale;
          shifts_q[4*i +: 4] <= scale - t_exponents[4*i +: 4];
        end
        //@ end
        s_q <= s[25:1];
        if (x_valid) begin
          x_q[35*i +: 35] <= x[35*i +: 35];
        end
        if (load) begin
          //@ if fpga
          {least_q, most_q, beyond_q, negative_q} <= {least, most, beyond, d[34]};
          //@ else
          low[21*i +: 21] <= saturated(least, beyond, d[34]);
          high[21*i +: 21] <= saturated(most, beyond, d[34]);
          //@ end
          shift[4*i +: 4] <= shifts_q[4*i +: 4];
        end
      end
    end
  endgenerate

  always @(posedge clk) begin
    if (begin_in) begin
      side_q <= side;
      s_exponents_q <= s_exponents;
      t_exponents_q <= t_exponents; //@ fpga
    end
    highest_q <= highest; //@ fpga
  end
endmodule
