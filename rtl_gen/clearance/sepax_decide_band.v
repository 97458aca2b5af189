// SPDX-License-Identifier: MIT
// The band, and the axis that proves it, from what exceeds the limits. Each of f is
// {orient3d is zero, is below zero, exceeds the limit of each clearance}. @band_latency@ In this
// order:
//   AXIS_AABB      x, y or z: the AABBs are outside the clearance
//   AXIS_NORMAL_A  N_A: all f_s exceed on one side
//   AXIS_NORMAL_B  N_B: all f_w
//   AXIS_EDGES + 3 i + j  e_i x f_j: f_d exceeds, and where it is above zero s does not increase
//                  along f_j nor w along e_i; below zero, not decrease
//   AXIS_PLANE     normal to an edge and to x, y or z
//   AXIS_NONE      none: collision
module sepax_decide_band #(
  parameter LIMITS = @limits@, // clearances
  parameter F = LIMITS+2       // bits of each of f
) (
  input  wire                clk,      // clock //@ chain
  input  wire [3*F-1:0]      f_s,      // of A's plane and B_k
  input  wire [3*F-1:0]      f_w,      // of B's plane and A_i
  input  wire [9*F-1:0]      f_d,      // of edge i of A and edge j of B at 3i + j
  input  wire [5:0]          r_s,      // {does not decrease, does not increase} along edge j of B
  input  wire [5:0]          r_w,      // along edge i of A
  input  wire [6*LIMITS-1:0] e_xy,     // outside by edges of A, of B, in this projection
  input  wire [6*LIMITS-1:0] e_yz,     // likewise
  input  wire [6*LIMITS-1:0] e_zx,     // likewise
  input  wire [3*LIMITS-1:0] box,      // AABBs are outside in x, y, z
  output wire                coplanar, // all orient3d are zero
  output wire [1:0]          band,     // 0 free, 1 warning, 2 collision
  output wire [3:0]          axis      // AXIS_...
);
  localparam [3:0] AXIS_NONE = 4'd@axis_none@, AXIS_EDGES = 4'd@axis_edges@,
                   AXIS_NORMAL_A = 4'd@axis_normal_a@, AXIS_NORMAL_B = 4'd@axis_normal_b@,
                   AXIS_PLANE = 4'd@axis_plane@, AXIS_AABB = 4'd@axis_aabb@;

  // For each clearance: 0 ... 8 e_i x f_j, 9 N_A, 10 N_B, 11 edges, 12 AABBs.
  wire [13*LIMITS-1:0] proved;
  wire [12:0] by;
  wire [15*F-1:0] f = {f_d, f_w, f_s};
  wire [14:0] zero;
  reg [3:0] edges; // the first of AXIS_EDGES ... that proves, else of those behind them

  genvar i, k;
  generate
    for (k = 0; k < LIMITS; k = k + 1) begin : clearance
      wire [17:0] in_projection;
      for (i = 0; i < 9; i = i + 1) begin : edge_pair
        assign proved[13*k+i] = f_d[i*F+k] && (f_d[i*F+LIMITS] ? (r_s[2*(i%3)+1] && r_w[2*(i/3)+1])
                                                               : (r_s[2*(i%3)] && r_w[2*(i/3)]));
      end
      assign proved[13*k+9] = f_s[k] && f_s[F+k] && f_s[2*F+k] &&
                              (f_s[LIMITS] == f_s[F+LIMITS]) &&
                              (f_s[LIMITS] == f_s[2*F+LIMITS]);
      assign proved[13*k+10] = f_w[k] && f_w[F+k] && f_w[2*F+k] &&
                               (f_w[LIMITS] == f_w[F+LIMITS]) &&
                               (f_w[LIMITS] == f_w[2*F+LIMITS]);
      for (i = 0; i < 6; i = i + 1) begin : of_triangle
        assign in_projection[3*i +: 3] = {e_xy[i*LIMITS+k], e_yz[i*LIMITS+k], e_zx[i*LIMITS+k]};
      end
      assign proved[13*k+11] = |in_projection;
      assign proved[13*k+12] = box[k] || box[LIMITS+k] || box[2*LIMITS+k];
    end
    for (i = 0; i < 15; i = i + 1) begin : of_orient3d
      assign zero[i] = f[i*F+F-1];
    end
  endgenerate

//@ if chain
  reg [13*LIMITS-1:0] proved_q;
  reg zero_q;
  always @(posedge clk) begin
    proved_q <= proved;
    zero_q <= &zero;
  end
  assign coplanar = zero_q;
//@ else
  assign coplanar = &zero;
//@ end
//@ if two_limits
  assign by = (proved@q@[25:13] != 13'd0) ? proved@q@[25:13] : proved@q@[12:0];
  assign band = (proved@q@[25:13] != 13'd0) ? 2'd0 : (proved@q@[12:0] != 13'd0) ? 2'd1 : 2'd2;
//@ else
  assign by = proved@q@;
  assign band = (by != 13'd0) ? 2'd0 : 2'd2;
//@ end

  integer n;
  always @(*) begin
    edges = by[11] ? AXIS_PLANE : AXIS_NONE;
    for (n = 8; n >= 0; n = n - 1) begin
      if (by[n]) begin
        edges = AXIS_EDGES + n[3:0];
      end
    end
  end
  assign axis = by[12] ? AXIS_AABB : by[9] ? AXIS_NORMAL_A : by[10] ? AXIS_NORMAL_B : edges;
endmodule
