// SPDX-License-Identifier: MIT
// Turns a vertex into the coordinates of the other body: sum_i = M_i . point + t_i - 2^20 origin_i
// for the three rows i, with the matrix and shift of a side. The vertex is floor(sum_i / 2^20).
// Each coordinate is biased once, for its three products. //@ !fpga
// Latency @latency@, one vertex a cycle.
module sepax_turn_vertex #(
  parameter W = @w@ // bits of a coordinate, of which the sums of products are made
) (
  input  wire           clk,    // clock
  input  wire [395:0]   matrix, // entry (i, k) of a side at 22 (9 side + 3 i + k), -2^20 ... 2^20
  input  wire [263:0]   shift,  // t_i of a side at 44 (3 side + i), signed
  input  wire           side,   // 0: M, t; 1: K, u
  input  wire [3*W-1:0] point,  // {z, y, x}, signed
  input  wire [3*W-1:0] origin, // {z, y, x}, signed
  output reg  [134:0]   sum     // {2, 1, 0}, 45 bits each, signed
);
  localparam B_W = @b_w@; // bits of a biased coordinate //@ !fpga
  localparam [B_W-1:0] BIAS = @b_w@'d@bias@; //@ !fpga
  localparam B_W = W; //@ fpga
  reg  [3*B_W-1:0] biased_q;
  reg  [3*W-1:0]   origin_q;
  reg              side_q;
  wire [197:0]     m = side_q ? matrix[395:198] : matrix[197:0];
  wire [131:0]     t = side_q ? shift[263:132] : shift[131:0];
  wire [134:0]     total;

  genvar i;
  generate
    for (i = 0; i < 3; i = i + 1) begin : row
      @dot@ products (
        .clk(clk), .a(m[66*i +: 66]), .b(biased_q), .c(t[44*i +: 44]), .d(origin_q[W*i +: W]),
        .p(total[45*i +: 45])
      );
      always @(posedge clk) begin
        biased_q[B_W*i +: B_W] <= {{(B_W-W){point[W*i+W-1]}}, point[W*i +: W]} + BIAS; //@ !fpga
        biased_q[W*i +: W] <= point[W*i +: W]; //@ fpga
      end
    end
  endgenerate

  always @(posedge clk) begin
    side_q <= side;
    origin_q <= origin;
    sum <= total;
  end
endmodule
