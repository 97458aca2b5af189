// SPDX-License-Identifier: MIT
// The axis that separates, from the signs {> 0, < 0} of the 15 orient3d; 00 is zero.
// Combinational. In this order: //@ !chain
// Latency 1. In this order: //@ chain
//   AXIS_PLANE     all orient3d are zero: an axis in the common plane, if in_plane says so
//   AXIS_NORMAL_A  N_A: all of s have one sign
//   AXIS_NORMAL_B  N_B: all of w have one sign
//   AXIS_EDGES + 3 i + j  e_i x f_j: d_ij has a sign that separates the edges, and on it s
//                  decreases (increases) along f_j and w along e_i
//   AXIS_NONE      none: collision
module sepax_decide (
  input  wire        clk,      // clock //@ chain
  input  wire [5:0]  s,        // of A's plane and B_k: [2k +: 2]
  input  wire [5:0]  w,        // of B's plane and A_i: [2i +: 2]
  input  wire [17:0] d,        // of edge i of A and edge j of B: [2(3i + j) +: 2]
  input  wire        in_plane, // should the pair be coplanar: it is separated
  output wire        coplanar, // all orient3d are zero
  output wire [3:0]  axis      // AXIS_...
);
  localparam [3:0] AXIS_NONE = 4'd@axis_none@, AXIS_EDGES = 4'd@axis_edges@,
                   AXIS_NORMAL_A = 4'd@axis_normal_a@, AXIS_NORMAL_B = 4'd@axis_normal_b@,
                   AXIS_PLANE = 4'd@axis_plane@;

  wire [2:0] s_falls, s_rises; // along f_j, or stays
  wire [2:0] w_falls, w_rises; // along e_i
  wire [8:0] separates;        // e_i x f_j: bit 3i + j
  reg  [8:0] separates_q; //@ chain
  wire normal_a = (s[1] && s[3] && s[5]) || (s[0] && s[2] && s[4]);
  wire normal_b = (w[1] && w[3] && w[5]) || (w[0] && w[2] && w[4]);
  reg [3:0] edges;             // the first of AXIS_EDGES ... that separates

  genvar i, j;
  generate
    for (i = 0; i < 3; i = i + 1) begin : along
      assign s_falls[i] = !(s[2*i] || s[2*((i+1)%3)+1]);
      assign s_rises[i] = !(s[2*i+1] || s[2*((i+1)%3)]);
      assign w_falls[i] = !(w[2*i] || w[2*((i+1)%3)+1]);
      assign w_rises[i] = !(w[2*i+1] || w[2*((i+1)%3)]);
    end
    for (i = 0; i < 3; i = i + 1) begin : edge_of_a
      for (j = 0; j < 3; j = j + 1) begin : edge_of_b
        assign separates[3*i+j] = (d[2*(3*i+j)+1] && s_falls[j] && w_falls[i]) ||
                                  (d[2*(3*i+j)] && s_rises[j] && w_rises[i]);
      end
    end
  endgenerate

  integer k;
  always @(*) begin
    edges = AXIS_NONE;
    for (k = 8; k >= 0; k = k - 1) begin
      if (separates@q@[k]) begin
        edges = AXIS_EDGES + k[3:0];
      end
    end
  end

  assign coplanar = {s, w, d} == 30'd0; //@ !chain
//@ if chain
  reg normal_a_q, normal_b_q, coplanar_q, in_plane_q;
  assign coplanar = coplanar_q;

  always @(posedge clk) begin
    separates_q <= separates;
    normal_a_q <= normal_a;
    normal_b_q <= normal_b;
    coplanar_q <= {s, w, d} == 30'd0;
    in_plane_q <= in_plane;
  end
//@ end
  assign axis = coplanar ? (in_plane@q@ ? AXIS_PLANE : AXIS_NONE) :
                normal_a@q@ ? AXIS_NORMAL_A : normal_b@q@ ? AXIS_NORMAL_B : edges;
endmodule
