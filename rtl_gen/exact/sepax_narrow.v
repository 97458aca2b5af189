// SPDX-License-Identifier: MIT
// Narrow phase: sepax_core with its control. A pair enters at the end of an II window and is in
// window 0 then, in window k after k more; its verdict goes to the reorder buffer, which has an
// entry for each pair.
//@ if passes
// A pair that is flat in the projection on x and y goes round once more in that on u and z, where u
// is x, or y where all six x are equal; flat again, it is on a line, where the AABBs decide.
//@ end
module sepax_narrow (
  input  wire            clk,      // clock
  input  wire            rst,      // synchronous reset of the control, active high
  input  wire            in_valid, // a pair is here
  output wire            in_ready, // it is taken in this cycle
  input  wire [18*@core_word@-1:0] in_pair, // x of A_1 (lowest) ... A_3, B_1 ... B_3; y; z
  input  wire            in_disjoint, // the AABBs are disjoint; goes with the pair //@ aabb_test
  input  wire            in_exceeds, // an AABB exceeds its extent; goes with the pair //@ extents
  output wire            out_valid,     // a verdict is here
  input  wire            out_ready,     // it is taken in this cycle
  output wire            out_collision, // 1: @collision_about@
  output wire            out_coplanar,  // 1: all six points are in one plane
  output wire [1:0]      out_band,      // 0 free, 1 warning, 2 collision //@ limits
  //@ if aabb_test
  output wire [@note@-1:0] out_note, // in_disjoint@exceeds_about@ of the pair; no verdict if not 0
  //@ end
  output wire [3:0]      out_axis       // what @axis_about@, see sepax_top; 0 none
);
  localparam N = @core_word@; // bits of a coordinate
  localparam LAST = @last_window@; // window of the verdict; a pair is in windows 0 ... LAST
  localparam JUDGED = @judged@; // window that it enters when its plane is known //@ passes
//@ if fpga
  localparam BEFORE = @before@; // window that it is in a cycle before that is used //@ passes
//@ end
  localparam TAG = @tag@; // log2 of the entries of the reorder buffer
  localparam RESULT = @result@; // bits of a verdict
  localparam II = @ii@; //@ shared

  reg  [LAST:0]           valid_q;    // a pair is in window k
  reg  [(LAST+1)*TAG-1:0] tag_q;      // its entry in the reorder buffer
  reg                     written_q;     // the verdict of this cycle is one //@ fpga
  reg  [TAG-1:0]          tag_written_q; // its entry //@ fpga
  wire [TAG-1:0]          tail;
  wire [RESULT-1:0]       oldest;
  wire                    free, coplanar;
  wire [3:0]              axis;
  wire [1:0]              band; //@ limits
  integer                 k;
  //@ if passes
  reg  [LAST:0]           second_q;   // this is its second pass
  reg  [JUDGED-1:0]       disjoint_q; // its projections were disjoint in the first
  //@ if !at_once
  reg  [LAST-JUDGED:0]    in_plane_q; // from window JUDGED on: it is separated if coplanar
  //@ end
  reg  [JUDGED-1:0]       decided_q;  // the AABB test has decided it //@ aabb_test
  wire                    flat, separated, disjoint_x, disjoint_z;
  wire                    flat_soon; // flat of the cycle behind //@ fpga
  wire again = valid_q[JUDGED-1] && flat && !second_q[JUDGED-1]@unless_decided@; //@ !fpga
  reg  again; // the pair in window JUDGED - 1 enters once more //@ fpga
  wire disjoint = disjoint_x || (disjoint_z && !second_q[JUDGED-1]) || disjoint_q[JUDGED-1];
  wire in_plane = flat ? disjoint : separated; // it is separated if coplanar //@ at_once
  //@ end
  reg  [II-1:0]           slot_q; // cycle of the II window, one-hot; rests at its end //@ shared
  wire last_slot = slot_q[II-1]; //@ shared
  wire take = in_valid && in_ready;
  wire enter = take || again; //@ passes
  wire enter = take; //@ !passes

  //@ if gated
  //@ if live
  // Bit t: a pair that the core works for is in its cycle t, or was in one of the II - 1 before.
  reg  [@live_msb@:0]     live_q;
  //@ end
  // With in_ready or again it enters.
  wire comes = (in_valid && !@decided@)@or_again@; //@ aabb_test
  wire comes = in_valid@or_again@; //@ !aabb_test
  //@ if shared
  reg  [II-1:0] core_slot_q; // slot_q while the core works for a pair, else 0
  wire [II-1:0] slot_next = (!last_slot || enter || (|valid_q)) ? {slot_q[II-2:0], slot_q[II-1]}
                                                                : slot_q;
  wire load = last_slot ? comes : live_q[0]; // first registers load, or rotate
  wire first = last_slot ? (comes && enter) : live_q[0];
  //@ else
  wire load = comes;
  wire first = comes && enter; //@ live
  //@ end
  //@ end
  assign in_ready = @at_last_slot@free@unless_again@;

  always @(posedge clk) begin
    if (rst) begin
      slot_q <= {1'b1, {(II-1){1'b0}}}; //@ shared
      valid_q <= {(LAST+1){1'b0}};
    end else begin
      //@ if shared
//@ if gated
      slot_q <= slot_next;
//@ else
      if (!last_slot || enter || (|valid_q)) begin //@ !fpga
      if (!last_slot || (in_valid && free) || (|valid_q)) begin //@ fpga
        slot_q <= {slot_q[II-2:0], slot_q[II-1]};
      end
//@ end
      //@ end
      if (@window_ends@) begin
        valid_q[0] <= enter;
        for (k = 1; k <= LAST; k = k + 1) begin
          valid_q[k] <= valid_q[k-1];
        end
        valid_q[JUDGED] <= valid_q[JUDGED-1] && !again; //@ judged_before
      end
    end
    //@ if fpga
    written_q <= !rst && valid_q[LAST]@at_verdict_slot@;
    tag_written_q <= tag_q[LAST*TAG +: TAG];
    again <= !rst && valid_q[BEFORE] && flat_soon && !second_q[BEFORE]@unless_decided@; //@ passes
    //@ end
    if (@window_ends@) begin
      tag_q[0 +: TAG] <= again ? tag_q[(JUDGED-1)*TAG +: TAG] : tail; //@ passes
      tag_q[0 +: TAG] <= tail; //@ !passes
      for (k = 1; k <= LAST; k = k + 1) begin
        tag_q[k*TAG +: TAG] <= tag_q[(k-1)*TAG +: TAG];
        second_q[k] <= second_q[k-1]; //@ passes
      end
      //@ if passes
      second_q[0] <= again;
      disjoint_q[0] <= again && disjoint;
      decided_q[0] <= !again && @decided@; //@ aabb_test
      for (k = 1; k < JUDGED; k = k + 1) begin
        disjoint_q[k] <= disjoint_q[k-1];
        decided_q[k] <= decided_q[k-1]; //@ aabb_test
      end
      //@ if !at_once
      in_plane_q[0] <= flat ? disjoint : separated;
      for (k = 1; k <= LAST - JUDGED; k = k + 1) begin
        in_plane_q[k] <= in_plane_q[k-1];
      end
      //@ end
      //@ end
    end
  end

//@ if live
  always @(posedge clk) begin
    if (rst) begin
      live_q <= @live_zero@;
      core_slot_q <= {II{1'b0}}; //@ shared
    end else begin
      live_q <= @live_next@;
      core_slot_q <= (first || (|live_q)) ? slot_next : {II{1'b0}}; //@ shared
    end
  end

//@ end
  sepax_core core (
    .clk(clk),
@advance_ports@ //@ gated
//@ if shared
    .slot(slot_q), //@ !gated
//@ if gated
    .slot(core_slot_q),
    .last(last_slot),
//@ end
//@ end
    .in_a1_x(in_pair[0*N +: N]), .in_a1_y(in_pair[6*N +: N]), .in_a1_z(in_pair[12*N +: N]),
    .in_a2_x(in_pair[1*N +: N]), .in_a2_y(in_pair[7*N +: N]), .in_a2_z(in_pair[13*N +: N]),
    .in_a3_x(in_pair[2*N +: N]), .in_a3_y(in_pair[8*N +: N]), .in_a3_z(in_pair[14*N +: N]),
    .in_b1_x(in_pair[3*N +: N]), .in_b1_y(in_pair[9*N +: N]), .in_b1_z(in_pair[15*N +: N]),
    .in_b2_x(in_pair[4*N +: N]), .in_b2_y(in_pair[10*N +: N]), .in_b2_z(in_pair[16*N +: N]),
    .in_b3_x(in_pair[5*N +: N]), .in_b3_y(in_pair[11*N +: N]), .in_b3_z(in_pair[17*N +: N]),
    //@ if limits
    .band(band),
    //@ else
    .flat_soon(flat_soon), //@ fpga_passes
    .again(again), .flat(flat), .separated(separated), .disjoint_x(disjoint_x), //@ passes
    .disjoint_z(disjoint_z), .second(second_q[LAST]), .in_plane(@in_plane@), //@ passes
    .in_plane(1'b0), //@ !passes
    //@ end
    .coplanar(coplanar), .axis(axis)
  );

  sepax_reorder reorder (
    .clk(clk), .rst(rst), .free(free), .take(take), .tail(tail),
    .note(@note_in@), .oldest_note(out_note), //@ aabb_test
    .write(written_q), .tag(tag_written_q), //@ fpga
    .write(valid_q[LAST]@at_verdict_slot@@unless_repeated@), .tag(tag_q[LAST*TAG +: TAG]), //@ !fpga
    .result({band, coplanar, axis}), //@ limits
    .result({coplanar, axis}), //@ !limits
    .valid(out_valid), .ready(out_ready), .oldest(oldest)
  );

  assign out_coplanar = out_valid && oldest[4];
  assign out_axis = oldest[3:0] & {4{out_valid}};
  assign out_collision = out_valid && (oldest[3:0] == 4'd0);
  assign out_band = oldest[6:5] & {2{out_valid}}; //@ limits
endmodule
