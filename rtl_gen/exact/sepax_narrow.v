// SPDX-License-Identifier: MIT
// Narrow phase: sepax_core with its control. A pair enters at the end of an II window, is in
// window 0 then, in window k after k more. Every pair takes the same cycles, so that verdicts come
// in the order of the pairs; a queue keeps them until they are taken.
//@ if ahead
// In its first @ahead@ cycles sepax_axis chooses the projection. Then it enters the core.
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
  localparam NOTE = @note@; // bits of a note //@ aabb_test
  localparam RESULT = @result@; // bits of a verdict, with its note //@ aabb_test
  localparam RESULT = @result@; // bits of a verdict //@ !aabb_test
  localparam II = @ii@; //@ shared

  reg  [LAST:0]           valid_q;    // a pair is in window k
  reg                     written_q;  // the verdict of this cycle is a pair's //@ fpga
  //@ if aabb_test
  reg  [(LAST+1)*NOTE-1:0] note_q;    // its note
  reg  [NOTE-1:0]         noted_q;    // note of this cycle's verdict //@ fpga
  //@ end
  wire [RESULT-1:0]       oldest;
  wire                    free, coplanar;
  wire [3:0]              axis;
  wire [1:0]              band; //@ limits
  wire [18*N-1:0]         pair; // as the core sees it
  integer                 k;
  reg  [II-1:0]           slot_q; // cycle of the II window, one-hot; rests at its end //@ shared
  wire last_slot = slot_q[II-1]; //@ shared
  wire take = in_valid && in_ready;
  wire written = valid_q[LAST]@at_verdict_slot@; // the core has a verdict

  //@ if gated
  //@ if live
  // Bit t: a pair that the core works for is in its cycle t, or was in one of the II - 1 before.
  reg  [@live_msb@:0]     live_q;
  //@ end
  // With in_ready it enters.
  wire comes = in_valid && !@decided@; //@ aabb_test
  wire comes = in_valid; //@ !aabb_test
  //@ if shared
  reg  [II-1:0] core_slot_q; // slot_q while the core works for a pair, else 0
  wire [II-1:0] slot_next = (!last_slot || take || (|valid_q)) ? {slot_q[II-2:0], slot_q[II-1]}
                                                               : slot_q;
  wire load = last_slot ? comes : live_q[0]; // first registers load, or rotate //@ !ahead
  wire first = last_slot ? (comes && take) : live_q[0];
  //@ else
  wire load = comes; //@ !ahead
  wire first = comes && take; //@ live
  //@ end
  //@ end
  assign in_ready = @at_last_slot@free;

  always @(posedge clk) begin
    if (rst) begin
      slot_q <= {1'b1, {(II-1){1'b0}}}; //@ shared
      valid_q <= {(LAST+1){1'b0}};
    end else begin
      //@ if shared
//@ if gated
      slot_q <= slot_next;
//@ else
      if (!last_slot || take || (|valid_q)) begin
        slot_q <= {slot_q[II-2:0], slot_q[II-1]};
      end
//@ end
      //@ end
      if (@window_ends@) begin
        valid_q[0] <= take;
        for (k = 1; k <= LAST; k = k + 1) begin
          valid_q[k] <= valid_q[k-1];
        end
      end
    end
    written_q <= !rst && written; //@ fpga
//@ if aabb_test
    noted_q <= note_q[LAST*NOTE +: NOTE]; //@ fpga
    if (@window_ends@) begin
      note_q[0 +: NOTE] <= @note_in@;
      for (k = 1; k <= LAST; k = k + 1) begin
        note_q[k*NOTE +: NOTE] <= note_q[(k-1)*NOTE +: NOTE];
      end
    end
//@ end
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
//@ if ahead
  sepax_axis projection (
    .clk(clk),
    .last(last_slot), //@ shared
    .second(slot_q[@tested_cycle@%II]), //@ in_turn
    .comes(comes), //@ gated
    .live(live_q[@axis_live@:0]), //@ axis_gated
    .in_pair(in_pair), .out_pair(pair)
  );
//@ else
  assign pair = in_pair;
//@ end

  sepax_core core (
    .clk(clk),
@advance_ports@ //@ gated
//@ if shared
    .slot(@core_slot@),
    .last(last_slot), //@ begins_at_last
//@ end
    .in_a1_x(pair[0*N +: N]), .in_a1_y(pair[6*N +: N]), .in_a1_z(pair[12*N +: N]),
    .in_a2_x(pair[1*N +: N]), .in_a2_y(pair[7*N +: N]), .in_a2_z(pair[13*N +: N]),
    .in_a3_x(pair[2*N +: N]), .in_a3_y(pair[8*N +: N]), .in_a3_z(pair[14*N +: N]),
    .in_b1_x(pair[3*N +: N]), .in_b1_y(pair[9*N +: N]), .in_b1_z(pair[15*N +: N]),
    .in_b2_x(pair[4*N +: N]), .in_b2_y(pair[10*N +: N]), .in_b2_z(pair[16*N +: N]),
    .in_b3_x(pair[5*N +: N]), .in_b3_y(pair[11*N +: N]), .in_b3_z(pair[17*N +: N]),
    .band(band), //@ limits
    .coplanar(coplanar), .axis(axis)
  );

  sepax_queue #(.RESULT(RESULT)) queue (
    .clk(clk), .rst(rst), .free(free), .take(take),
    .write(written_q), //@ fpga
    .write(written), //@ !fpga
    .result({@note_out@@band_out@coplanar, axis}),
    .valid(out_valid), .ready(out_ready), .oldest(oldest)
  );

  assign out_coplanar = out_valid && oldest[4];
  assign out_axis = oldest[3:0] & {4{out_valid}};
  assign out_collision = out_valid && (oldest[3:0] == 4'd0);
  assign out_band = oldest[6:5] & {2{out_valid}}; //@ limits
  assign out_note = oldest[RESULT-1 -: NOTE]; //@ aabb_test
endmodule
