// SPDX-License-Identifier: MIT
// sepax_tb.v - self-checking test bench of sepax_top, of any architecture, for Icarus Verilog, and
// for Verilator from version 5 on.
//
// +pairs=FILE  lines of 24 integers and what is expected (sepax judge --echo): collision and
//              coplanar; of exact also axis, and band with a clearance (pairs.txt)
// +stall=SEED  in_valid and out_ready at random
// +isolated=1  from the second pair on all are coplanar: check that the operands of axes 7 ... 9
//              and what depends on them are isolated: they do not toggle (not for netlists); of
//              conference, none is coplanar: the same of the six axes of table 2
//
// A pair is WORDS input words; the data is anything without in_valid. Verdicts must come in the
// order of the pairs with the expected value and stand still while they wait. The latency must be
// LATENCY: of a pair alone in the core where there is out_ready, else of every pair. X is a
// mismatch; so are operands of a core that an AABB test isolates (SEPAX_ISOLATION). Ends with
// $finish when all is well and with $stop (exit status 1 under vvp -N) if not, at the latest after
// 20 mismatches, +most=N: N.

`default_nettype none

module sepax_tb;
  `include "sepax_params.vh"

  reg clk = 1'b0;
  reg rst = 1'b1;
  reg in_valid = 1'b0;
  reg out_ready = 1'b1;
  wire in_ready, out_valid, out_collision, out_coplanar;
  wire [3:0] out_axis;
  wire [1:0] out_band;
  reg signed [WORD-1:0] in [0:17]; // the input ports in their order

`ifdef SEPAX_EXACT
  localparam EXACT = 1;
  localparam WORDS = 1;
  sepax_top dut (
    .clk(clk), .rst(rst), .in_valid(in_valid), .in_ready(in_ready),
    .in_a1_x(in[0]), .in_a1_y(in[1]), .in_a1_z(in[2]),
    .in_a2_x(in[3]), .in_a2_y(in[4]), .in_a2_z(in[5]),
    .in_a3_x(in[6]), .in_a3_y(in[7]), .in_a3_z(in[8]),
    .in_b1_x(in[9]), .in_b1_y(in[10]), .in_b1_z(in[11]),
    .in_b2_x(in[12]), .in_b2_y(in[13]), .in_b2_z(in[14]),
    .in_b3_x(in[15]), .in_b3_y(in[16]), .in_b3_z(in[17]),
`ifdef SEPAX_BANDS
    .out_band(out_band),
`endif
    .out_valid(out_valid), .out_ready(out_ready), .out_collision(out_collision),
    .out_coplanar(out_coplanar), .out_axis(out_axis)
  );
`else
  localparam EXACT = 0;
  localparam WORDS = 3;
  assign in_ready = 1'b1;
  assign out_axis = 4'd0;
  sepax_top dut (
    .clk(clk), .rst(rst), .in_valid(in_valid),
    .in_a_x(in[0]), .in_a_y(in[1]), .in_a_z(in[2]),
    .in_b_x(in[3]), .in_b_y(in[4]), .in_b_z(in[5]), .in_na(in[6]), .in_nb(in[7]),
    .out_valid(out_valid), .out_collision(out_collision), .out_coplanar(out_coplanar)
  );
`endif
`ifdef SEPAX_TEST_ENABLE // a port of the netlist: no scan
  assign dut.test_enable = 1'b0;
`endif
`ifdef SEPAX_BANDS
  localparam FIELDS = 28;
`else
  localparam FIELDS = EXACT ? 27 : 26;
  assign out_band = 2'd0;
`endif
`ifdef SEPAX_BOXES
  // A pair may be taken before the II window of the core, empty by then, ends.
  localparam SETTLE = 2 * II;
`elsif SEPAX_SKID
  localparam SETTLE = 2 * II;
`else
  localparam SETTLE = 0;
`endif
  localparam QUEUE = 1024;
  localparam PATIENCE = 2000 + 64 * (LATENCY + II);

  always #2 clk = ~clk;

  reg [8*1024-1:0] path;
  integer file, fields, cycle, sent, judged, mismatches, waited, blocked, idle, took;
  integer stall, most, isolated, seed, offering, offered, accepting, accepted, i, word, value,
    above;
  integer number [0:27];
  reg [7:0] expected [0:QUEUE-1]; // band, collision, coplanar, axis
  reg alone [0:QUEUE-1];
  integer taken_in [0:QUEUE-1];   // the cycle, as if a pair's words came without gaps
  reg taken, was_empty, was_blocked, not_isolated;
  reg [7:0] shown, shown_before;

  task mismatch(input [8*48-1:0] what);
    begin
      mismatches = mismatches + 1;
      $display("sepax_tb: pair %0d, cycle %0d: %0s (valid %b, collision %b, coplanar %b, axis %0d)",
               judged, cycle, what, out_valid, out_collision, out_coplanar, out_axis);
      if (mismatches == most) begin
        $stop;
      end
    end
  endtask

  task judge_verdict(input [7:0] due);
    begin
      if (shown[5] !== due[5]) begin
        mismatch("wrong verdict");
      end else if (shown[4] !== due[4]) begin
        mismatch("wrong out_coplanar");
      end else if (shown[3:0] !== due[3:0]) begin
        mismatch("wrong axis");
      end else if (shown[7:6] !== due[7:6]) begin
        mismatch("wrong band");
      end else if (!EXACT || (shown[4] == 1'b0 && shown[3:0] != 4'd12)) begin // no extra pass
        if (took < LATENCY) begin
          mismatch("a verdict too early");
        end else if (took > LATENCY && (!EXACT || (alone[judged % QUEUE] &&
                                                   blocked < taken_in[judged % QUEUE]))) begin
          mismatch("a verdict too late");
        end
      end
      judged = judged + 1;
    end
  endtask

  // What the outputs show in this cycle.
  task look;
    begin
      shown = {out_band, out_collision, out_coplanar, out_axis};
      took = cycle - taken_in[judged % QUEUE] + 1;
      if (was_blocked && (out_valid !== 1'b1 || shown !== shown_before)) begin
        mismatch("a verdict moves while it is blocked");
      end
      was_blocked = 1'b0;
      if (^{in_ready, out_valid, shown} === 1'bx) begin
        mismatch("an output is X");
      end
      if (out_valid !== 1'b1) begin
        if (shown !== 8'd0) begin
          mismatch("an output is not 0 without a verdict");
        end
        if (!EXACT && !was_empty && took >= LATENCY) begin
          mismatch("no verdict");
          judged = judged + 1;
        end
      end else if (was_empty) begin
        mismatch("a verdict that nobody asked for");
      end else if (out_ready || !EXACT) begin
        judge_verdict(expected[judged % QUEUE]);
      end else begin
        was_blocked = 1'b1;
        shown_before = shown;
      end
    end
  endtask

  // One clock cycle from the falling edge.
  task tick;
    begin
      drive;
      cycle = cycle + 1;
      #1;
      if (not_isolated === 1'b1) begin
        mismatch("an isolated core gets operands");
      end
      was_empty = judged == sent;
      idle = was_empty ? idle + 1 : 0;
      taken = in_valid && in_ready === 1'b1;
      waited = taken || (out_valid === 1'b1 && out_ready) ? 0
               : out_ready && (in_valid || !was_empty)    ? waited + 1
                                                          : waited;
      look;
      if (!out_ready) begin
        blocked = cycle;
      end
      if (waited > PATIENCE) begin
        mismatch("time-out: nothing comes and nothing is taken");
        $stop;
      end
      @(negedge clk);
    end
  endtask

  // A signal is 1 in `rate` of 8 cycles of a stretch.
  task draw_stalls;
    begin
      draw_stretch(offered, offering);
      draw_stretch(accepted, accepting);
      in_valid = draw(8) < offering;
      out_ready = draw(8) < accepting;
    end
  endtask

  task draw_stretch(inout integer left, inout integer rate);
    begin
      if (left == 0) begin
        left = 1 + draw(8 * LATENCY);
        case (draw(5))
          0: rate = 0;
          1: rate = 1;
          2: rate = 4;
          3: rate = 7;
          default: rate = 8;
        endcase
      end
      left = left - 1;
    end
  endtask

  // 0 ... below - 1, below <= 2^16, the same in each simulator.
  function integer draw(input integer below);
    begin
      seed = 1664525 * seed + 1013904223;
      draw = {16'd0, seed[31:16]} % below;
    end
  endfunction

  // Word `word` of the pair, or anything when it is not offered.
  task drive;
    for (i = 0; i < 18; i = i + 1) begin
      value = !in_valid    ? draw(65536) ^ (draw(65536) << 16)
              : EXACT != 0 ? number[i]
              : i < 6      ? number[9 * (i / 3) + 3 * word + i % 3]
                           : number[18 + 3 * (i % 2) + word];
      in[i] = value[WORD-1:0];
    end
  endtask

  task send_pair;
    begin
      for (word = 0; word < WORDS; word = word + (taken ? 1 : 0)) begin
        in_valid = 1'b1;
        if (stall != 0) begin
          draw_stalls;
        end
        tick;
      end
      in_valid = 1'b0;
      expected[sent % QUEUE] = {number[27][1:0], number[24] != 0, number[25] != 0, number[26][3:0]};
      alone[sent % QUEUE] = idle > SETTLE;
      taken_in[sent % QUEUE] = cycle - (WORDS - 1);
      sent = sent + 1;
      if (sent - judged > QUEUE) begin
        mismatch("more pairs were taken than fit");
        $stop;
      end
    end
  endtask

  task empty_core;
    begin
      while (judged < sent) begin
        if (stall != 0) begin
          draw_stalls;
        end
        in_valid = 1'b0;
        tick;
      end
      tick;
    end
  endtask

  task read_pair;
    begin
      fields = 0;
      for (i = 0; i < FIELDS; i = i + 1) begin
        fields = fields + ($fscanf(file, "%d", number[i]) == 1 ? 1 : 0);
        above = number[i] >>> (i < 24 ? WORD - 1 : 4); // 0, or of a negative coordinate -1
        if (fields == i + 1 && above != 0 && (i >= 24 || above != -1)) begin
          $display("sepax_tb: %0s: pair %0d: number %0d, %0d, does not fit %0d bits; judge the %0s",
                   path, sent, i + 1, number[i], i < 24 ? WORD : 4,
                   "pairs with the --word of this design");
          $stop;
        end
      end
    end
  endtask

  initial begin
    {cycle, idle, sent, judged, mismatches, waited, blocked, offered, accepted} = 0;
    {number[26], number[27]} = 0;
    was_blocked = 1'b0;
    seed = 1;
    stall = $value$plusargs("stall=%d", seed);
    if (!$value$plusargs("most=%d", most)) begin
      most = 20;
    end
    isolated = $test$plusargs("isolated=1");
    if (!$value$plusargs("pairs=%s", path)) begin
      path = "pairs.txt";
    end
    file = $fopen(path, "r");
    if (file == 0) begin
      $display("sepax_tb: %0s: cannot be read", path);
      $stop;
    end
    repeat (3) @(negedge clk);
    rst = 1'b0;
    read_pair;
    while (fields == FIELDS) begin
      send_pair;
      if (sent <= 3) begin
        empty_core; // their latency is checked
      end
      read_pair;
    end
    if (fields != 0) begin
      mismatch("a line without all its integers");
    end
    empty_core;
    out_ready = 1'b1;
    repeat (4 * (LATENCY + II)) tick; // a verdict too many is seen here
    $display("sepax_tb: %0d pairs, %0d mismatches", judged, mismatches);
    if (sent == 0 || judged != sent || mismatches != 0) begin
      $stop;
    end
    $finish;
  end

  // Without a pair, or where the AABB test has decided, nothing but zeros enters the core.
  initial not_isolated = 1'b0;
`ifdef SEPAX_ISOLATION
`ifdef SEPAX_BOXES
  always @(negedge clk) begin
    not_isolated <= !(dut.narrow.in_valid && !dut.narrow.in_disjoint) &&
                    (|dut.narrow.in_pair !== 1'b0);
  end
`endif
`ifndef SEPAX_EXACT
`ifdef SEPAX_CONFERENCE
  // Operands, products, axes, projections and comparisons of table 2.
  wire [1023:0] operands = {dut.a_14, dut.b_14, dut.psa_6.axes[0].product.p,
                            dut.psa_6.axes[0].product.q, dut.psa_6.axes[5].product.q};
  wire [2047:0] results = {dut.psa_6.axes[0].product.axis, dut.psa_6.axes[3].product.axis,
                           dut.psa_6.axes[5].product.axis, dut.flat[0].on_a, dut.flat[3].on_b,
                           dut.flat[5].on_a, dut.overlap_flat,
                           dut.psa_6.axes[1].product.component[0].ij_q,
                           dut.flat[0].proj.vertex[0].inner.product_q,
                           dut.flat[5].proj.vertex[5].inner.product_q};
`else
  // Operands, products, projections of the three isolated PROJ, and their PSA part.
  wire [1023:0] operands = {dut.a_10, dut.b_10, dut.psa.axes[6].product.p,
                            dut.psa.axes[6].product.q, dut.psa.axes[8].product.q};
  wire [2047:0] results = {dut.psa.axes[6].product.axis, dut.psa.axes[7].product.axis,
                           dut.psa.axes[8].product.axis, dut.axes[6].on_a, dut.axes[7].on_b,
                           dut.axes[8].on_a, dut.axes[6].proj.vertex[0].inner.product_q,
                           dut.axes[8].proj.vertex[5].inner.product_q};
`endif
  reg [1023:0] operands_before;
  reg [2047:0] results_before;
  integer watched = 0;

  always @(negedge clk) begin
    if (isolated != 0 && judged >= 1) begin
      if (watched > 0 && (operands !== operands_before || results !== results_before)) begin
        mismatch("an isolated axis moved");
      end
      watched = watched + 1;
    end
    operands_before = operands;
    results_before = results;
  end
`endif
`endif
endmodule

`default_nettype wire
