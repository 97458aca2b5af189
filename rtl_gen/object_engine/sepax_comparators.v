// SPDX-License-Identifier: MIT
// @lanes@ comparator lanes. AABBs come from the memories one cycle after the step that asked for
// them; B's is moved in another; its candidate mask, bit k for lane k, leaves two cycles later.
//@ if fpga
// What comes from block RAM waits a cycle more in registers, while `taken`, one bit a lane, is
// found; what is counted is a cycle behind the lanes.
//@ end
module sepax_comparators (
  input  wire           clk,       // clock
  input  wire           clear,     // drop all that is in flight
  input  wire           step,      // a step is made
  input  wire [@index_b@:0]     j,         // number of B's triangle //@ !fpga
  input  wire [@index_b@-1:0]   j,         // number of B's triangle //@ fpga
  input  wire           is_b,      // there is one
  input  wire [@index_a@-1:0]   base,      // first of A's triangles in this round
  input  wire           load,      // lane j takes a triangle of A
  input  wire           is_a,      // there is one
  input  wire [6*@word@-1:0] aabb_a,    // AABB of A, one cycle behind the step
  input  wire [6*@word@-1:0] aabb_b,    // AABB of B, likewise
  input  wire [3*(@word@+1)-1:0] move, // added to B: {z, y, x}, signed
  output wire           busy,      // a step is in flight
  output wire           push,      // some AABBs overlap //@ !fpga
  output reg            push,      // some AABBs overlap //@ fpga
  output reg  [@lanes@-1:0]  mask,      // in which lanes
  output reg  [@index_b@-1:0]   mask_j,    // number of B's triangle
  output reg  [@index_a@-1:0]   mask_base, // its base
  output wire [6:0]     tested     // pairs that are tested in this cycle
);
  localparam LANES = @lanes@;
  localparam W = @word@;    // bits of a coordinate
  localparam V = @moved@;   // of one that was moved
  localparam A = @index_a@; // bits of the number of a triangle of A
  localparam B = @index_b@; // of B
  localparam LANE = @lane_bits@; // of the number of a lane //@ staged
  localparam [V-1:0] MARGIN = @margin@; // AABBs nearer than this overlap //@ margin
  reg              valid_q, valid_q2, valid_q3, is_b_q, load_q, is_a_q; //@ !fpga
  reg              valid_q, valid_q2, valid_q3, valid_q4, is_b_q, is_a_q; //@ fpga
  reg  [B:0]       j_q; //@ !fpga
  reg  [B-1:0]     j_q; //@ fpga
  reg  [B-1:0]     j_q2;
  reg  [B-1:0]     j_q3; //@ fpga
  reg  [A-1:0]     base_q, base_q2;
  reg  [A-1:0]     base_q3; //@ fpga
  reg  [6*V-1:0]   aabb_q2;
  reg  [6:0]       live_q; // lanes that hold an AABB
  wire [6*V-1:0]   moved, moved_b;
  //@ if fpga
  // The step that these registers of the memories belong to.
  reg              step_in_q, is_b_in_q, load_in_q, is_a_in_q;
  reg  [B-1:0]     j_in_q;
  reg  [A-1:0]     base_in_q;
  reg  [6*W-1:0]   aabb_a_in_q, aabb_b_in_q;
  reg              gained_q, lost_q; // a lane comes to hold an AABB, does not any more
  reg  [LANES-1:0] taken_q;
  //@ end
  wire [LANES-1:0] overlap, live, taken;

  assign busy = valid_q || valid_q2 || valid_q3; //@ !fpga
  assign busy = step_in_q || valid_q || valid_q2 || valid_q3 || valid_q4; //@ fpga
  assign push = |mask; //@ !fpga
  assign tested = live_q & {7{valid_q2}}; //@ !fpga
  assign tested = live_q & {7{valid_q3}}; //@ fpga
  assign taken = taken_q; //@ fpga

  genvar k;
  generate
    for (k = 0; k < 6; k = k + 1) begin : side
      assign moved[k*V +: V] = {{2{aabb_b@in@[k*W+W-1]}}, aabb_b@in@[k*W +: W]} +
                               {move[(k/2)*(W+1)+W], move[(k/2)*(W+1) +: W+1]};
      assign moved_b[k*V +: V] = moved[k*V +: V]; //@ !margin
      assign moved_b[k*V +: V] = moved[k*V +: V] + ((k % 2 == 1) ? MARGIN : -MARGIN); //@ margin
    end
    for (k = 0; k < LANES; k = k + 1) begin : lane
      assign taken[k] = valid_q && load_q && (j_q == k[B:0]); //@ !fpga
      //@ if fpga
      always @(posedge clk) begin
        //@ if staged
        taken_q[k] <= load_in_q && (j_in_q[LANE-1:0] == k[LANE-1:0]);
        //@ else
        taken_q[k] <= load_in_q;
        //@ end
      end
      //@ end
      sepax_comparator comparator (
        .clk(clk), .clear(clear), .load(taken[k]), .is_a(is_a_q), .aabb_a(aabb_a@in@),
        .is_b(valid_q2), .aabb_b(aabb_q2), .live(live[k]), .overlap(overlap[k])
      );
    end
  endgenerate

  always @(posedge clk) begin
    if (clear) begin
      {valid_q, valid_q2, valid_q3} <= 3'd0;
      {step_in_q, valid_q4, gained_q, lost_q, push} <= 5'd0; //@ fpga
      mask <= {LANES{1'b0}};
      live_q <= 7'd0;
    end else begin
      valid_q <= step@in@;
      {step_in_q, valid_q4} <= {step, valid_q3}; //@ fpga
      valid_q2 <= valid_q && is_b_q;
      valid_q3 <= valid_q2;
      mask <= overlap;
      push <= |overlap; //@ fpga
      //@ if fpga
      gained_q <= (|taken) && is_a_q;
      lost_q <= |(taken & live);
      live_q <= live_q + {6'd0, gained_q} - {6'd0, lost_q};
      //@ else
      live_q <= live_q + {6'd0, valid_q && load_q && is_a_q} - {6'd0, |(taken & live)};
      //@ end
    end
    j_q <= j@in@;
    base_q <= base@in@;
    {is_b_q, load_q, is_a_q} <= {is_b, load, is_a}; //@ !fpga
    {is_b_q, is_a_q} <= {is_b_in_q, is_a_in_q}; //@ fpga
    //@ if fpga
    j_in_q <= j;
    base_in_q <= base;
    {is_b_in_q, load_in_q, is_a_in_q} <= {is_b, step && load, is_a};
    aabb_a_in_q <= aabb_a;
    aabb_b_in_q <= aabb_b;
    //@ end
    j_q2 <= j_q[B-1:0]; //@ !fpga
    j_q2 <= j_q; //@ fpga
    base_q2 <= base_q;
    mask_j <= j@late_q@;
    mask_base <= base@late_q@;
    {j_q3, base_q3} <= {j_q2, base_q2}; //@ fpga
    aabb_q2 <= moved_b;
  end
endmodule
