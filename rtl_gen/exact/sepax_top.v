// SPDX-License-Identifier: MIT
// Exact collision detection of two triangles: the verdict is the mathematical one for every
// input. valid/ready on both sides; a pair every @every@, verdicts in order.
//@ if aabb_test
// Pairs @aabb_decided@ (axis @aabb_axis@).
// They enter the core as zeros, which it passes on without a transition.
//@ end
//@ if extents
// Of the others those with an AABB longer than @extent_a@ (A) or @extent_b@ (B) LSB are called
// collisions, undecided, and flagged (out_of_range, axis @limit_axis@); for the rest
// @core_word@ bits of @word@ are enough.
//@ end
//@ if limits
// out_band is proved for the real triangles. Each of their coordinates may differ by 1/2 LSB from
// the coordinate on the port. 0: they are farther apart than @free_from@ LSB. 2: not proved to be
// farther apart than @collision_to@ LSB.@between@
//@ end
// Coplanar pairs are called collisions, undecided, and flagged. //@ flag
// Coplanar and degenerate pairs are decided, too. //@ ahead
// in_ready is a register: no path leads to it from an input. //@ registered_ready
// out_axis: 1 + 3 i + j e_i x f_j, 10 N_A, 11 N_B,
// 12 @axis_12@@axis_aabb@; 0 none.
// e_i is the edge of A from vertex i + 1 to the next one, f_j that of B from j + 1; i, j = 0, 1, 2.
// Latency @latency@ from the cycle in which a pair is taken to that of its verdict, both
// counted, for every pair, unless an earlier verdict waits for out_ready. //@ !wait
// counted, unless an earlier verdict waits for out_ready. A pair that is taken before the //@ wait
// core can begin with it has up to @wait@ cycles more. //@ wait
// Outputs are 0 without out_valid.
module sepax_top (
  input  wire            clk,      // clock
  input  wire            rst,      // synchronous reset of the control, active high
  input  wire            in_valid, // a pair is on the inputs
  output wire            in_ready, // the core takes a pair in this cycle
  input  wire signed [@msb@:0] in_a1_x, // x of A_1, @least@ ... @most@
  input  wire signed [@msb@:0] in_a1_y, // y of A_1, @least@ ... @most@
  input  wire signed [@msb@:0] in_a1_z, // z of A_1, @least@ ... @most@
  input  wire signed [@msb@:0] in_a2_x, // x of A_2, @least@ ... @most@
  input  wire signed [@msb@:0] in_a2_y, // y of A_2, @least@ ... @most@
  input  wire signed [@msb@:0] in_a2_z, // z of A_2, @least@ ... @most@
  input  wire signed [@msb@:0] in_a3_x, // x of A_3, @least@ ... @most@
  input  wire signed [@msb@:0] in_a3_y, // y of A_3, @least@ ... @most@
  input  wire signed [@msb@:0] in_a3_z, // z of A_3, @least@ ... @most@
  input  wire signed [@msb@:0] in_b1_x, // x of B_1, @least@ ... @most@
  input  wire signed [@msb@:0] in_b1_y, // y of B_1, @least@ ... @most@
  input  wire signed [@msb@:0] in_b1_z, // z of B_1, @least@ ... @most@
  input  wire signed [@msb@:0] in_b2_x, // x of B_2, @least@ ... @most@
  input  wire signed [@msb@:0] in_b2_y, // y of B_2, @least@ ... @most@
  input  wire signed [@msb@:0] in_b2_z, // z of B_2, @least@ ... @most@
  input  wire signed [@msb@:0] in_b3_x, // x of B_3, @least@ ... @most@
  input  wire signed [@msb@:0] in_b3_y, // y of B_3, @least@ ... @most@
  input  wire signed [@msb@:0] in_b3_z, // z of B_3, @least@ ... @most@
  output wire            out_valid,     // a verdict is on the outputs
  input  wire            out_ready,     // the verdict is taken in this cycle
  output wire            out_collision, // 1: @collision_about@
  output wire            out_coplanar,  // 1: all six points are in one plane
  output wire            out_of_range,  // 1: an AABB exceeds its extent; undecided //@ extents
  output wire [1:0]      out_band,      // 0 free, 1 warning, 2 collision //@ limits
  output wire [3:0]      out_axis       // number of the axis that @axis_about@; 0: none
);
  localparam W = @word@; // bits of a coordinate
  wire [18*W-1:0] in_pair = { // x of A_1 (lowest) ... A_3, B_1 ... B_3, then y, then z
    in_b3_z, in_b2_z, in_b1_z, in_a3_z, in_a2_z, in_a1_z,
    in_b3_y, in_b2_y, in_b1_y, in_a3_y, in_a2_y, in_a1_y,
    in_b3_x, in_b2_x, in_b1_x, in_a3_x, in_a2_x, in_a1_x
  };
  wire [18*W-1:0] pair;
  wire pair_valid, pair_ready;

  //@ if registered_ready
  sepax_skid #(.WIDTH(18*W)) skid (
    .clk(clk), .rst(rst), .in_valid(in_valid), .in_ready(in_ready), .in(in_pair),
    .out_valid(pair_valid), .out_ready(pair_ready), .out(pair)
  );
  //@ else
  assign pair = in_pair;
  assign pair_valid = in_valid;
  assign in_ready = pair_ready;
  //@ end

  //@ if aabb_test
  wire narrow_valid, narrow_ready, narrow_collision, narrow_coplanar, disjoint;
  wire exceeds; //@ extents
  wire [18*@core_word@-1:0] narrow_pair;
  wire [3:0] narrow_axis;
  wire [1:0] narrow_band; //@ limits
  wire [@note@-1:0] note;
  wire decided = |note;
  wire exceeded = @exceeded@; // an AABB exceeds its extent

  sepax_aabb_test aabb_test (
    .clk(clk), .rst(rst), .in_valid(pair_valid), .in_ready(pair_ready), .in_pair(pair),
    .out_valid(narrow_valid), .out_ready(narrow_ready), .out_pair(narrow_pair),
    .out_exceeds(exceeds), //@ extents
    .out_disjoint(disjoint)
  );
  sepax_narrow narrow (
    .clk(clk), .rst(rst), .in_valid(narrow_valid), .in_ready(narrow_ready),
    .in_pair(narrow_pair), .in_disjoint(disjoint),
    .in_exceeds(exceeds), //@ extents
    .out_valid(out_valid), .out_ready(out_ready), .out_collision(narrow_collision),
    .out_band(narrow_band), //@ limits
    .out_coplanar(narrow_coplanar), .out_note(note), .out_axis(narrow_axis)
  );

  assign out_coplanar = narrow_coplanar && !decided;
  assign out_of_range = out_valid && exceeded; //@ extents
  assign out_collision = (out_valid && exceeded) || (narrow_collision && !decided);
  assign out_axis = decided ? ({2'b11, exceeded, !exceeded} & {4{out_valid}}) : narrow_axis;
  assign out_band = decided ? {out_valid && exceeded, 1'b0} : narrow_band; //@ limits
  //@ else
  sepax_narrow narrow (
    .clk(clk), .rst(rst), .in_valid(pair_valid), .in_ready(pair_ready), .in_pair(pair),
    .out_valid(out_valid), .out_ready(out_ready), .out_collision(out_collision),
    .out_band(out_band), //@ limits
    .out_coplanar(out_coplanar), .out_axis(out_axis)
  );
  //@ end
endmodule
