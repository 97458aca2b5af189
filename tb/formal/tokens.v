// SPDX-License-Identifier: MIT
// tokens.v - pairs through sepax_top, whatever its core decides: two of the pairs, whichever, are
// marked, and their verdicts leave once each, in order, and so many cycles after their pairs
// entered sepax_narrow, unless the receiver or a verdict before is in the way. The control does not
// look at coordinates, so what is true of any two marked pairs is true of all. By induction: the
// assertions say where a pair is at any time, and so hold from one cycle to the next. Macros, from
// the design:
//   WORD           bits of a coordinate
//   LAST, TAG      of sepax_narrow: the window of the verdict; log2 of the entries of its queue
//   II, SLOT       cycles of a window, and in which of them the verdict of window LAST is written
//   RESULT         bits of a verdict
//   LIMITS         two clearances: a band
//   AXIS           there is a sepax_axis
//   TESTED         there is an AABB test
//   SKID           there is a skid buffer
//   FPGA           a design for an FPGA: a register behind the verdict
`default_nettype none

`ifdef AXIS
// In the place of sepax_axis: the core below holds the marks for all windows.
module sepax_axis (
`ifdef SHARED
    input wire last,
`endif
    input wire clk,
    input wire [18*`WORD-1:0] in_pair,
    output wire [18*`WORD-1:0] out_pair
);
  assign out_pair = in_pair;
endmodule
`endif

// In the place of sepax_core: the marks of a pair go from window to window, signs are any.
module sepax_core (
    input wire clk,
`ifdef SHARED
    input wire [`II-1:0] slot,
`endif
    input wire signed [`WORD-1:0] in_a1_x, in_a1_y, in_a1_z, in_a2_x, in_a2_y, in_a2_z,
    input wire signed [`WORD-1:0] in_a3_x, in_a3_y, in_a3_z, in_b1_x, in_b1_y, in_b1_z,
    input wire signed [`WORD-1:0] in_b2_x, in_b2_y, in_b2_z, in_b3_x, in_b3_y, in_b3_z,
`ifdef LIMITS
    output wire [1:0] band,
`endif
    output wire coplanar,
    output wire [3:0] axis
);
  reg [2*`LAST+1:0] mark_q; // of the pair in window 0 (lowest) ...
`ifdef SHARED
  wire ends = slot[`II-1];
`else
  wire ends = 1'b1;
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
  always @(posedge clk) if (ends) mark_q <= {mark_q[2*`LAST-1:0], in_a1_z[0], in_a1_x[0]};
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
  localparam LATENCY = `II * `LAST + `SLOT + 2 + BEHIND; // cycles behind the one that enters
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
  (* hierconn *) wire [2*`LAST+1:0] \dut.narrow.core.mark_q ;
  (* hierconn *) wire [`TAG:0] \dut.narrow.queue.taken_q , \dut.narrow.queue.tail_q ;
  (* hierconn *) wire [`TAG:0] \dut.narrow.queue.head_q ;
  (* hierconn *) wire [ENTRIES*`RESULT-1:0] \dut.narrow.queue.result_q ;
  wire enter = \dut.narrow.take ;
  wire [1:0] enters = marks_of(\dut.narrow.in_pair ) & 3'd3;
  wire [`LAST:0] valid = \dut.narrow.valid_q ;
  wire [`TAG:0] head = \dut.narrow.queue.head_q ;
  wire [`TAG:0] pairs = \dut.narrow.queue.taken_q - head;   // that have entered and not left
  wire [`TAG:0] verdicts = \dut.narrow.queue.tail_q - head; // of them
  wire [`TAG-1:0] tail = \dut.narrow.queue.tail_q [`TAG-1:0];
  wire [ENTRIES*`RESULT-1:0] result = \dut.narrow.queue.result_q ;
`ifdef SHARED
  (* hierconn *) wire [`II-1:0] \dut.narrow.slot_q ;
  wire [`II-1:0] slot = \dut.narrow.slot_q ;
  wire [`II-1:0] gone = slot >> `SLOT >> 1; // the verdict of window LAST was written before
`else
  wire slot = 1'b1, gone = 1'b0;
`endif
`ifdef TESTED
  (* hierconn *) wire [`LAST:0] \dut.narrow.note_q ;
  (* hierconn *) wire \dut.aabb_test.valid_q ;
  (* hierconn *) wire [18*W-1:0] \dut.aabb_test.pair_q ;
  wire [`LAST:0] note = \dut.narrow.note_q ;
  wire tested_valid = \dut.aabb_test.valid_q ;
  wire [2:0] tested = marks_of(\dut.aabb_test.pair_q );
  wire enter_disjoint = tested[2];
`else
  wire [`LAST:0] note = {(`LAST+1){1'b0}};
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
  (* hierconn *) wire [1:0] \dut.narrow.core.judged_q ;
  wire written = \dut.narrow.written_q ;
  wire [1:0] mark_written = \dut.narrow.core.judged_q ;
`ifdef TESTED
  (* hierconn *) wire \dut.narrow.noted_q ;
  wire note_written = \dut.narrow.noted_q ;
`else
  wire note_written = 1'b0;
`endif
`else
  wire written = 1'b0, note_written = 1'b0;
  wire [1:0] mark_written = 2'd0;
`endif

  reg begun = 1'b0;
  reg [1:0] taken, left, entered;  // the first, the second marked pair; into sepax_narrow
  reg [2*`TAG+1:0] place;          // the numbers of their entries
  reg [(`LAST+1)*`TAG-1:0] tag;    // the entry of the pair in each window,
  reg [`TAG-1:0] tag_written;      // and of the verdict behind the register
  reg [8*ENTRIES-1:0] age;         // of each entry, since its pair entered
  reg [7:0] shut;                  // cycles without in_ready, while nothing is inside
  wire [1:0] takes = {take && mark == 2'd2, take && mark == 2'd1};
  wire [1:0] leaves = {leave && out_mark == 2'd2, leave && out_mark == 2'd1};
  wire [1:0] of_enter = enter_disjoint ? one_disjoint : enters;
  wire [1:0] now_enters = {enter && of_enter == 2'd2, enter && of_enter == 2'd1};
  wire [1:0] live = taken & ~left, inside = entered & ~left;
  integer e, k, n;
  wire [`TAG:0] ahead = place[`TAG:0] - head; // of the first: pairs before it
  wire [`TAG:0] ahead_2 = place[`TAG+1 +: `TAG+1] - head;
  always @(posedge clk) begin
    begun <= 1'b1;
    taken <= rst ? 2'd0 : taken | takes;
    left <= rst ? 2'd0 : left | leaves;
    entered <= rst ? 2'd0 : entered | now_enters;
    for (n = 0; n < 2; n = n + 1) begin
      if (now_enters[n]) place[n*(`TAG+1) +: `TAG+1] <= \dut.narrow.queue.taken_q ;
    end
    for (n = 0; n < ENTRIES; n = n + 1) begin
      if (enter && \dut.narrow.queue.taken_q [`TAG-1:0] == n[`TAG-1:0]) age[8*n +: 8] <= 8'd1;
      else if (age[8*n +: 8] != 8'd255) age[8*n +: 8] <= age[8*n +: 8] + 8'd1;
    end
    if (slot[`II-1]) tag <= {tag[`LAST*`TAG-1:0], \dut.narrow.queue.taken_q [`TAG-1:0]};
    tag_written <= tag[`LAST*`TAG +: `TAG];
    shut <= rst || \dut.narrow.in_ready || pairs != 0 ? 8'd0 : shut + 8'd1;
  end

  reg [`TAG-1:0] at, oldest;
  reg [7:0] old, windows, number;
  reg [1:0] marked;
  reg noted; // the AABB test has decided the pair
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
      assert (!out_valid || pairs != 0);
      assert (!out_valid || out_mark != 2'd3);
      assert (!leaves[0] || live[0]);
      assert (!leaves[1] || (live[1] && left[0]));
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
      // Pairs in the order of their entries: verdicts first, then the windows, the last first.
      assert (verdicts <= pairs && pairs <= ENTRIES);
      assert (out_valid == (verdicts != 0));
`ifdef SHARED
      assert (slot != 0 && (slot & (slot - 1'b1)) == 0);
`endif
      number = 8'd1;
      for (k = 0; k < `II; k = k + 1) if (slot[k]) number = number + k;
      assert (shut < number);
      oldest = tail;
      if (written) begin
        assert (tag_written == oldest);
        oldest = oldest + 1'b1;
      end
      for (k = `LAST; k >= 0; k = k - 1) begin
        if (valid[k] && !(k == `LAST && gone != 0)) begin
          assert (tag[k*`TAG +: `TAG] == oldest);
          oldest = oldest + 1'b1;
        end
      end
      for (e = 0; e < ENTRIES; e = e + 1) begin
        at = e[`TAG-1:0] - head[`TAG-1:0];
        old = age[8*e +: 8];
        marked = inside[0] && place[0 +: `TAG] == e[`TAG-1:0] ? 2'd1 :
                 inside[1] && place[`TAG+1 +: `TAG] == e[`TAG-1:0] ? 2'd2 : 2'd0;
        noted = marked != 2'd0 && marked == one_disjoint;
        windows = 8'd0;
        for (k = 0; k <= `LAST; k = k + 1) begin
          if (valid[k] && tag[k*`TAG +: `TAG] == e[`TAG-1:0] && !(k == `LAST && gone != 0)) begin
            windows = windows + 8'd1;
            assert (old == k * `II + number);
            assert (note[k] == noted);
            assert (\dut.narrow.core.mark_q [2*k +: 2] == (noted ? 2'd0 : marked));
          end
        end
        if (written && tag_written == e[`TAG-1:0]) begin
          windows = windows + 8'd1;
          assert (old == LATENCY - 1);
          assert (note_written == noted);
          assert (mark_written == (noted ? 2'd0 : marked));
        end
        // A pair is in one window, or its verdict is there: from one and the same age on.
        assert (windows == {7'd0, {1'b0, at} >= verdicts && {1'b0, at} < pairs});
        if ({1'b0, at} < pairs) assert (({1'b0, at} < verdicts) == (old >= LATENCY));
        if ({1'b0, at} < verdicts) begin
          assert (result[`RESULT*e +: 4] == (noted ? 4'd0 : {2'd0, marked}));
`ifdef TESTED
          assert (result[`RESULT*e + `RESULT-1] == noted);
`endif
        end
      end
      if (inside[0]) assert (ahead < pairs);
      if (inside[1]) assert (ahead_2 < pairs && (left[0] || ahead < ahead_2));
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
