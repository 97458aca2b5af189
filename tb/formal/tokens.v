// SPDX-License-Identifier: MIT
// tokens.v - pairs through sepax_top, whatever its core decides: two of the pairs, whichever, are
// marked, and their verdicts leave once each, in order, in time. The control does not look at
// coordinates, so what is true of any two marked pairs is true of all. By induction: the
// assertions say where a pair is at any time, and so hold from one cycle to the next. Macros, from
// the design:
//   WORD           bits of a coordinate
//   LAST, TAG      of sepax_narrow: the window of the verdict; log2 of the entries
//   JUDGED         window before which the second pass is decided, if there is one
//   II, SLOT       cycles of a window, and in which of them the verdict of window LAST is written
//   RESULT         bits of a verdict
//   LIMITS         two clearances: a band
//   TESTED         there is an AABB test
//   SKID           there is a skid buffer
//   FPGA           a design for an FPGA: registers before a second pass and behind the verdict
//   FRONT          places before sepax_narrow
`default_nettype none

// In the place of sepax_core: the marks of a pair go from window to window, signs are any.
module sepax_core (
    input wire clk,
`ifdef SHARED
    input wire [`II-1:0] slot,
`endif
    input wire signed [`WORD-1:0] in_a1_x, in_a1_y, in_a1_z, in_a2_x, in_a2_y, in_a2_z,
    input wire signed [`WORD-1:0] in_a3_x, in_a3_y, in_a3_z, in_b1_x, in_b1_y, in_b1_z,
    input wire signed [`WORD-1:0] in_b2_x, in_b2_y, in_b2_z, in_b3_x, in_b3_y, in_b3_z,
`ifdef JUDGED
    input wire again, second,
`ifdef FPGA
    output wire flat_soon,
    output reg flat,
    output wire separated, disjoint_x, disjoint_z,
`else
    output wire flat, separated, disjoint_x, disjoint_z,
`endif
`endif
`ifdef LIMITS
    output wire [1:0] band,
`else
    input wire in_plane,
`endif
    output wire coplanar,
    output wire [3:0] axis
);
  reg [2*`LAST+1:0] mark_q; // of the pair in window 0 (lowest) ...
  wire [1:0] mark = {in_a1_z[0], in_a1_x[0]};
`ifdef SHARED
  wire ends = slot[`II-1];
`else
  wire ends = 1'b1;
`endif
`ifdef JUDGED
  (* anyseq *) wire [3:0] any;
`ifdef FPGA
  assign {flat_soon, separated, disjoint_x, disjoint_z} = any;
  always @(posedge clk) flat <= flat_soon;
`else
  assign {flat, separated, disjoint_x, disjoint_z} = any;
`endif
  wire [1:0] enters = again ? mark_q[2*`JUDGED-2 +: 2] : mark;
`else
  wire [1:0] enters = mark;
`endif
`ifdef LIMITS
  (* anyseq *) wire [1:0] any_band;
  assign band = any_band;
`endif
  (* anyseq *) wire any_coplanar;
  assign coplanar = any_coplanar;
`ifdef FPGA
  reg [1:0] judged_q; // mark of the verdict
  always @(posedge clk) judged_q <= mark_q[2*`LAST +: 2];
  assign axis = {2'd0, judged_q};
`else
  assign axis = {2'd0, mark_q[2*`LAST +: 2]};
`endif
  always @(posedge clk) if (ends) mark_q <= {mark_q[2*`LAST-1:0], enters};
endmodule

module tokens (
    input wire clk, rst, in_valid, out_ready,
    input wire [1:0] mark, // of the pair that is offered: 1 the first, 2 the second, or 0
    input wire disjoint       // its AABBs are disjoint
);
`ifdef FPGA
  localparam BEHIND = 1; // registers behind the verdict
`else
  localparam BEHIND = 0;
`endif
  localparam W = `WORD, ENTRIES = 1 << `TAG;
  localparam LONGEST = `II * (`LAST + 1 + `FIRST_PASS) + 1 + BEHIND;
  localparam BOUND = LONGEST + ENTRIES; // cycles behind the front
  wire in_ready, out_valid, out_collision, out_coplanar;
  wire [3:0] out_axis;
  wire [1:0] out_band;
  function [18*W-1:0] pair_of(input [2:0] marks); // the pair, of which coordinates have the marks
    begin
      pair_of = {18*W{1'b0}};
      {pair_of[12*W], pair_of[0]} = marks[1:0];
      {pair_of[12*W-2], pair_of[11*W-2], pair_of[10*W-2]} = {3{marks[2]}};
    end
  endfunction
  function [2:0] marks_of(input [18*W-1:0] pair);
    marks_of = {pair[10*W-2], pair[12*W], pair[0]};
  endfunction
  wire [18*W-1:0] in_pair = pair_of({disjoint, mark});
  sepax_top dut (
      .clk(clk), .rst(rst), .in_valid(in_valid), .in_ready(in_ready),
      .in_a1_x(in_pair[0*W +: W]), .in_a1_y(in_pair[6*W +: W]), .in_a1_z(in_pair[12*W +: W]),
      .in_a2_x(in_pair[1*W +: W]), .in_a2_y(in_pair[7*W +: W]), .in_a2_z(in_pair[13*W +: W]),
      .in_a3_x(in_pair[2*W +: W]), .in_a3_y(in_pair[8*W +: W]), .in_a3_z(in_pair[14*W +: W]),
      .in_b1_x(in_pair[3*W +: W]), .in_b1_y(in_pair[9*W +: W]), .in_b1_z(in_pair[15*W +: W]),
      .in_b2_x(in_pair[4*W +: W]), .in_b2_y(in_pair[10*W +: W]), .in_b2_z(in_pair[16*W +: W]),
      .in_b3_x(in_pair[5*W +: W]), .in_b3_y(in_pair[11*W +: W]), .in_b3_z(in_pair[17*W +: W]),
      .out_valid(out_valid), .out_ready(out_ready),
`ifdef LIMITS
      .out_band(out_band),
`endif
      .out_collision(out_collision), .out_coplanar(out_coplanar), .out_axis(out_axis));
`ifndef LIMITS
  assign out_band = 2'd0;
`endif
  wire take = in_valid && in_ready;
  wire leave = out_valid && out_ready;
  (* anyconst *) wire [1:0] one_disjoint; // which of the marked pairs has disjoint AABBs; 0: none
  wire [1:0] out_mark = out_axis == 4'd13 ? one_disjoint : out_axis[1:0];

  (* hierconn *) wire \dut.narrow.take , \dut.narrow.in_ready ;
  (* hierconn *) wire [18*W-1:0] \dut.narrow.in_pair ;
  (* hierconn *) wire [`LAST:0] \dut.narrow.valid_q ;
  (* hierconn *) wire [(`LAST+1)*`TAG-1:0] \dut.narrow.tag_q ;
  (* hierconn *) wire [2*`LAST+1:0] \dut.narrow.core.mark_q ;
  (* hierconn *) wire [`TAG-1:0] \dut.narrow.tail ;
  (* hierconn *) wire [`TAG:0] \dut.narrow.reorder.count_q ;
  (* hierconn *) wire [ENTRIES-1:0] \dut.narrow.reorder.head_q , \dut.narrow.reorder.done_q ;
  (* hierconn *) wire [ENTRIES*`RESULT-1:0] \dut.narrow.reorder.result_q ;
  wire enter = \dut.narrow.take ;
  wire [1:0] enters = marks_of(\dut.narrow.in_pair ) & 3'd3;
  wire [`LAST:0] valid = \dut.narrow.valid_q ;
  wire [`TAG-1:0] tail = \dut.narrow.tail ;
  wire [`TAG:0] count = \dut.narrow.reorder.count_q ;
  wire [ENTRIES-1:0] done = \dut.narrow.reorder.done_q ;
`ifdef SHARED
  (* hierconn *) wire [`II-1:0] \dut.narrow.slot_q ;
  wire [`II-1:0] slot = \dut.narrow.slot_q ;
  wire [`II-1:0] gone = slot >> `SLOT >> 1; // the verdict of window LAST was written before
`else
  wire slot = 1'b1, gone = 1'b0;
`endif
`ifdef JUDGED
  (* hierconn *) wire [`LAST:0] \dut.narrow.second_q ;
  (* hierconn *) wire \dut.narrow.again , \dut.narrow.flat ;
  wire [`LAST:0] second = \dut.narrow.second_q ;
  wire again = \dut.narrow.again , flat = \dut.narrow.flat ;
`ifdef TESTED
  (* hierconn *) wire [`JUDGED-1:0] \dut.narrow.decided_q ;
`endif
`else
  wire [`LAST:0] second = 0;
  wire again = 1'b0;
`endif
`ifdef TESTED
  (* hierconn *) wire [ENTRIES-1:0] \dut.narrow.reorder.note_q ;
  (* hierconn *) wire \dut.aabb_test.valid_q ;
  (* hierconn *) wire [18*W-1:0] \dut.aabb_test.pair_q ;
  wire [ENTRIES-1:0] note = \dut.narrow.reorder.note_q ;
  wire tested_valid = \dut.aabb_test.valid_q ;
  wire [2:0] tested = marks_of(\dut.aabb_test.pair_q );
  wire enter_disjoint = tested[2];
`else
  wire [ENTRIES-1:0] note = {ENTRIES{1'b0}};
  wire tested_valid = 1'b0, enter_disjoint = 1'b0;
  wire [2:0] tested = 3'd0;
`endif
`ifdef SKID
  (* hierconn *) wire [18*W-1:0] \dut.skid.word_q ;
  wire skid_valid = !in_ready;
  wire [2:0] skid = marks_of(\dut.skid.word_q );
`else
  wire skid_valid = 1'b0;
  wire [2:0] skid = 3'd0;
`endif

`ifdef FPGA
  (* hierconn *) wire \dut.narrow.written_q ;
  (* hierconn *) wire [`TAG-1:0] \dut.narrow.tag_written_q ;
  (* hierconn *) wire [1:0] \dut.narrow.core.judged_q ;
  wire written = \dut.narrow.written_q ;
  wire [`TAG-1:0] tag_written = \dut.narrow.tag_written_q ;
  wire [1:0] mark_written = \dut.narrow.core.judged_q ;
`else
  wire written = 1'b0;
  wire [`TAG-1:0] tag_written = {`TAG{1'b0}};
  wire [1:0] mark_written = 2'd0;
`endif

  reg begun = 1'b0;
  reg [1:0] taken, left, entered;  // the first, the second marked pair; into sepax_narrow
  reg [2*`TAG-1:0] place;          // their entries
  reg [8*ENTRIES-1:0] age;         // of each entry, since its pair entered
  reg [ENTRIES-1:0] was_flat;      // the pair of the entry, in its first pass
  reg [7:0] waits, shut;           // cycles that the first has waited since it entered, with
                                   // out_ready; without in_ready, while nothing is inside
  wire [1:0] takes = {take && mark == 2'd2, take && mark == 2'd1};
  wire [1:0] leaves = {leave && out_mark == 2'd2, leave && out_mark == 2'd1};
  wire [1:0] of_enter = enter_disjoint ? one_disjoint : enters;
  wire [1:0] now_enters = {enter && of_enter == 2'd2, enter && of_enter == 2'd1};
  wire [1:0] live = taken & ~left, inside = entered & ~left;
  integer e, k, n;
  reg [`TAG-1:0] head;
  always @* begin
    head = 0;
    for (n = 0; n < ENTRIES; n = n + 1) begin
      if (\dut.narrow.reorder.head_q [n]) head = head | n[`TAG-1:0];
    end
  end
  wire [`TAG-1:0] ahead = place[`TAG-1:0] - head; // of the first
  wire [`TAG-1:0] ahead_2 = place[`TAG +: `TAG] - head;
  always @(posedge clk) begin
    begun <= 1'b1;
    taken <= rst ? 2'd0 : taken | takes;
    left <= rst ? 2'd0 : left | leaves;
    entered <= rst ? 2'd0 : entered | now_enters;
    for (n = 0; n < 2; n = n + 1) begin
      if (now_enters[n]) place[n*`TAG +: `TAG] <= tail;
    end
    for (n = 0; n < ENTRIES; n = n + 1) begin
      if (enter && tail == n[`TAG-1:0]) age[8*n +: 8] <= 8'd1;
      else if (age[8*n +: 8] != 8'd255) age[8*n +: 8] <= age[8*n +: 8] + 8'd1;
`ifdef JUDGED
      if (slot[`II-1] && valid[`JUDGED-1] && !second[`JUDGED-1] &&
          \dut.narrow.tag_q [(`JUDGED-1)*`TAG +: `TAG] == n[`TAG-1:0]) begin
        was_flat[n] <= flat && !note[n];
      end
`endif
    end
    waits <= rst || !inside[0] ? 8'd0 : waits + {7'd0, out_ready};
    shut <= rst || \dut.narrow.in_ready || count != 0 ? 8'd0 : shut + 8'd1;
  end

  reg [`TAG-1:0] at, of;
  reg [7:0] since, old, windows, number;
  reg [1:0] marked;
  always @* begin
    assume (begun == !rst);
    assume (mark != 2'd3 && one_disjoint != 2'd3);
    assume (!(mark[0] && taken[0]));
    assume (!(mark[1] && (taken[1] || !taken[0])));
`ifdef TESTED
    assume (disjoint == (mark != 2'd0 && mark == one_disjoint));
`else
    assume (!disjoint && one_disjoint == 2'd0);
`endif
    if (begun) begin
      // What a user sees: no verdict from nowhere; each marked one once, in their order.
      assert (!out_valid || count != 0);
      assert (!out_valid || out_mark != 2'd3);
      assert (!leaves[0] || live[0]);
      assert (!leaves[1] || (live[1] && left[0]));
      assert (waits <= BOUND);
      assert (shut <= `II);
      // The marked pairs before sepax_narrow.
`ifdef SKID
      assert (!skid_valid || \dut.skid.word_q == pair_of(skid));
      if (skid_valid) assert (skid[2] == (one_disjoint != 2'd0 && skid[1:0] == one_disjoint));
`endif
`ifdef TESTED
      assert (!tested_valid || \dut.aabb_test.pair_q == pair_of(tested));
      if (tested_valid) assert (tested[2] == (one_disjoint != 2'd0 && tested[1:0] == one_disjoint));
`endif
      for (n = 0; n < 2; n = n + 1) begin
        assert ({7'd0, skid_valid && skid[n]} + {7'd0, tested_valid && tested[n]} ==
                {7'd0, taken[n] && !entered[n]});
      end
      assert (!(skid_valid && skid[1:0] == 2'd3) && !(tested_valid && tested[1:0] == 2'd3));
      assert (!(skid_valid && skid[0] && tested_valid && tested[1]));
      assert (!entered[1] || entered[0]);
      assert (!taken[1] || taken[0]);
      assert (!(left[0] && !entered[0]) && !(left[1] && !entered[1]) && !(left[1] && !left[0]));
      assert ((entered & ~taken) == 2'd0);
      if (skid_valid && skid[0]) assert (!taken[1]);
      if (tested_valid && tested[0]) assert (!entered[1]);
      // Entries: each that is taken is in one window, or done.
      assert (\dut.narrow.reorder.head_q == {{(ENTRIES-1){1'b0}}, 1'b1} << head);
      assert (tail == head + count[`TAG-1:0] && count <= ENTRIES);
`ifdef SHARED
      assert (slot != 0 && (slot & (slot - 1'b1)) == 0);
`endif
`ifdef FPGA
`ifdef JUDGED
      if (slot[`II-1]) begin
        assert (again == (valid[`JUDGED-1] && flat && !second[`JUDGED-1]
`ifdef TESTED
                          && !\dut.narrow.decided_q [`JUDGED-1]
`endif
                          ));
      end
`endif
`endif
      number = 8'd1;
      for (k = 0; k < `II; k = k + 1) if (slot[k]) number = number + k;
      assert (shut < number);
      for (e = 0; e < ENTRIES; e = e + 1) begin
        at = e[`TAG-1:0] - head;
        old = age[8*e +: 8];
        marked = inside[0] && place[0 +: `TAG] == e[`TAG-1:0] ? 2'd1 :
                 inside[1] && place[`TAG +: `TAG] == e[`TAG-1:0] ? 2'd2 : 2'd0;
        windows = 8'd0;
        for (k = 0; k <= `LAST; k = k + 1) begin
          if (valid[k] && \dut.narrow.tag_q [k*`TAG +: `TAG] == e[`TAG-1:0] &&
              !(k == `LAST && gone != 0)) begin
            windows = windows + 8'd1;
            since = k + (second[k] ? `FIRST_PASS : 0);
            assert (old == since * `II + number);
            assert (\dut.narrow.core.mark_q [2*k +: 2] == (note[e] ? 2'd0 : marked));
`ifdef JUDGED
            if (k >= `JUDGED || second[k]) assert (second[k] == was_flat[e]);
`ifdef TESTED
            if (k < `JUDGED) assert (\dut.narrow.decided_q [k] == note[e]);
`endif
`endif
          end
        end
        if (written && tag_written == e[`TAG-1:0]) begin
          windows = windows + 8'd1;
          since = `LAST + (was_flat[e] ? `FIRST_PASS : 0);
          assert (old == since * `II + `SLOT + 8'd2);
          assert (mark_written == (note[e] ? 2'd0 : marked));
        end
        assert (windows + {7'd0, done[e]} == {7'd0, {1'b0, at} < count});
        if ({1'b0, at} < count) begin
          assert (note[e] == (marked != 2'd0 && marked == one_disjoint));
          if (inside[0] && at < ahead) assert (old >= age[8*place[0 +: `TAG] +: 8]);
        end
        if (done[e]) begin
          assert (\dut.narrow.reorder.result_q [`RESULT*e +: 2] == (note[e] ? 2'd0 : marked));
          assert (\dut.narrow.reorder.result_q [`RESULT*e+2 +: 2] == 2'd0);
        end
      end
      if (inside[0]) assert ({1'b0, ahead} < count);
      if (inside[1]) assert ({1'b0, ahead_2} < count && (left[0] || ahead < ahead_2));
      if (inside[0]) begin
        old = age[8*place[0 +: `TAG] +: 8];
        assert (waits + ahead <= (old < LONGEST ? old : LONGEST) + ENTRIES - 1);
      end else begin
        assert (waits <= BOUND);
      end
    end
  end

  // A verdict stands until it is taken.
  reg stood = 1'b0;
  reg [7:0] verdict;
  wire [7:0] now = {out_collision, out_coplanar, out_band, out_axis};
  always @(posedge clk) begin
    stood <= begun && out_valid && !out_ready;
    verdict <= now;
  end
  always @* if (stood) assert (out_valid && now == verdict);
endmodule

`default_nettype wire
