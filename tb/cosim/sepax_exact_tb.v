// sepax_exact_tb.v - self-checking test bench of architecture exact for Icarus Verilog.
//
// +pairs=FILE  lines of 24 integers and what is expected (sepax judge --echo): the
//              collision, or collision, coplanar and axis (and band, with a clearance)
// +stall=SEED  in_valid and out_ready at random, the data anything without in_valid
//
// Verdicts must come in the order of the pairs with the expected value and stand still
// while they wait; the latency of a pair alone in the core must be LATENCY; X is a
// mismatch; so are operands of a core that an AABB test isolates (SEPAX_ISOLATION). Ends with
// $finish when all is well and with $stop (exit status 1 under vvp -N) if not.

`default_nettype none

module sepax_exact_tb;
  `include "sepax_params.vh"

  localparam QUEUE = 1024;
`ifdef SEPAX_BOXES
  // A pair may be taken before the II window of the core, empty by then, ends.
  localparam SETTLE = 2 * II;
`else
  localparam SETTLE = 0;
`endif
  localparam PATIENCE = 2000 + 64 * (LATENCY + II);

  reg clk = 1'b0;
  reg rst = 1'b1;
  reg in_valid = 1'b0;
  reg out_ready = 1'b1;
  reg signed [WORD-1:0] in_a1_x, in_a1_y, in_a1_z, in_a2_x, in_a2_y, in_a2_z;
  reg signed [WORD-1:0] in_a3_x, in_a3_y, in_a3_z, in_b1_x, in_b1_y, in_b1_z;
  reg signed [WORD-1:0] in_b2_x, in_b2_y, in_b2_z, in_b3_x, in_b3_y, in_b3_z;
  wire in_ready, out_valid, out_collision, out_coplanar;
  wire [3:0] out_axis;
`ifdef SEPAX_BANDS
  localparam FIELDS = 28;
  wire [1:0] out_band;
`else
  localparam FIELDS = 27;
  wire [1:0] out_band = 2'd0;
`endif

  sepax_top dut (
    .clk(clk), .rst(rst), .in_valid(in_valid), .in_ready(in_ready),
    .in_a1_x(in_a1_x), .in_a1_y(in_a1_y), .in_a1_z(in_a1_z),
    .in_a2_x(in_a2_x), .in_a2_y(in_a2_y), .in_a2_z(in_a2_z),
    .in_a3_x(in_a3_x), .in_a3_y(in_a3_y), .in_a3_z(in_a3_z),
    .in_b1_x(in_b1_x), .in_b1_y(in_b1_y), .in_b1_z(in_b1_z),
    .in_b2_x(in_b2_x), .in_b2_y(in_b2_y), .in_b2_z(in_b2_z),
    .in_b3_x(in_b3_x), .in_b3_y(in_b3_y), .in_b3_z(in_b3_z),
    .out_valid(out_valid), .out_ready(out_ready), .out_collision(out_collision),
    .out_coplanar(out_coplanar), .out_axis(out_axis)
`ifdef SEPAX_BANDS
    , .out_band(out_band)
`endif
  );

  always #2 clk = ~clk;

  // Without a pair, or where the boxes have decided, nothing but zeros enters the core.
  reg not_isolated = 1'b0;
`ifdef SEPAX_ISOLATION
`ifdef SEPAX_BOXES
  always @(negedge clk) begin
    not_isolated <= !(dut.narrow.in_valid && !dut.narrow.in_disjoint) &&
                (|dut.narrow.in_pair !== 1'b0);
  end
`endif
`endif

  reg [8*4096-1:0] line;
  reg [8*1024-1:0] path;
  integer file, fields, length, cycle, sent, judged, mismatches, waited, blocked;
  integer idle;
  integer stall, seed, offering, offered, accepting, accepted, i;
  integer number [0:27];
  reg [7:0] expected [0:QUEUE-1]; // band, collision, coplanar, axis
  reg whole [0:QUEUE-1];          // all of them are known
  reg alone [0:QUEUE-1];
  integer taken_in [0:QUEUE-1];
  reg taken, was_empty, was_blocked;
  reg [7:0] shown, before;

  task mismatch(input [8*48-1:0] what);
    begin
      mismatches = mismatches + 1;
      $display("icarus: pair %0d, cycle %0d: %0s (valid %b, collision %b, coplanar %b, axis %0d)",
               judged, cycle, what, out_valid, out_collision, out_coplanar, out_axis);
      if (mismatches == 20) begin
        $stop;
      end
    end
  endtask

  task judge_verdict;
    begin
      if (shown[5] !== expected[judged % QUEUE][5]) begin
        mismatch("wrong verdict");
      end else if (whole[judged % QUEUE] && shown[4] !== expected[judged % QUEUE][4]) begin
        mismatch("wrong out_coplanar");
      end else if (whole[judged % QUEUE] && shown[3:0] !== expected[judged % QUEUE][3:0]) begin
        mismatch("wrong axis");
      end else if (whole[judged % QUEUE] && shown[7:6] !== expected[judged % QUEUE][7:6]) begin
        mismatch("wrong band");
      end else if (shown[4] == 1'b0 && shown[3:0] != 4'd12) begin
        // no extra pass
        if (cycle - taken_in[judged % QUEUE] + 1 < LATENCY) begin
          mismatch("a verdict too early");
        end else if (alone[judged % QUEUE] && blocked < taken_in[judged % QUEUE] &&
                     cycle - taken_in[judged % QUEUE] + 1 != LATENCY) begin
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
      if (was_blocked && (out_valid !== 1'b1 || shown !== before)) begin
        mismatch("a verdict moves while it is blocked");
      end
      was_blocked = 1'b0;
      if (out_valid !== 1'b0 && out_valid !== 1'b1) begin
        mismatch("out_valid is X");
      end else if (out_valid) begin
        if (^shown === 1'bx) begin
          mismatch("an output is X");
        end
        if (was_empty) begin
          mismatch("a verdict that nobody asked for");
        end else if (out_ready) begin
          judge_verdict;
        end else begin
          was_blocked = 1'b1;
          before = shown;
        end
      end
    end
  endtask

  // One clock cycle from the falling edge, after the inputs were set.
  task tick;
    begin
      cycle = cycle + 1;
      #1;
      if (not_isolated) begin
        mismatch("an isolated core gets operands");
      end
      was_empty = judged == sent;
      idle = was_empty ? idle + 1 : 0;
      taken = in_valid && in_ready === 1'b1;
      if (in_ready !== 1'b0 && in_ready !== 1'b1) begin
        mismatch("in_ready is X");
      end
      waited = taken || (out_valid === 1'b1 && out_ready)    ? 0
               : out_ready && (in_valid || !was_empty) ? waited + 1
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
      if (offered == 0) begin
        offered = 1 + $unsigned($random(seed)) % (8 * LATENCY);
        offering = draw_rate(0);
      end
      if (accepted == 0) begin
        accepted = 1 + $unsigned($random(seed)) % (8 * LATENCY);
        accepting = draw_rate(0);
      end
      offered = offered - 1;
      accepted = accepted - 1;
      in_valid = $unsigned($random(seed)) % 8 < offering;
      out_ready = $unsigned($random(seed)) % 8 < accepting;
    end
  endtask

  function integer draw_rate(input integer unused);
    case ($unsigned($random(seed)) % 5)
      0: draw_rate = 0;
      1: draw_rate = 1;
      2: draw_rate = 4;
      3: draw_rate = 7;
      default: draw_rate = 8;
    endcase
  endfunction

  task drive;
    begin
      {in_a1_x, in_a1_y, in_a1_z} = {word(0), word(1), word(2)};
      {in_a2_x, in_a2_y, in_a2_z} = {word(3), word(4), word(5)};
      {in_a3_x, in_a3_y, in_a3_z} = {word(6), word(7), word(8)};
      {in_b1_x, in_b1_y, in_b1_z} = {word(9), word(10), word(11)};
      {in_b2_x, in_b2_y, in_b2_z} = {word(12), word(13), word(14)};
      {in_b3_x, in_b3_y, in_b3_z} = {word(15), word(16), word(17)};
    end
  endtask

  // Coordinate k of the pair, or anything when it is not offered.
  function [WORD-1:0] word(input integer k);
    word = in_valid ? number[k] : $random(seed);
  endfunction

  task send_pair;
    begin
      taken = 1'b0;
      while (!taken) begin
        in_valid = 1'b1;
        if (stall) begin
          draw_stalls;
        end
        drive;
        tick;
      end
      expected[sent % QUEUE] = {number[27][1:0], number[24] != 0, number[25] != 0, number[26][3:0]};
      whole[sent % QUEUE] = fields == FIELDS;
      alone[sent % QUEUE] = idle > SETTLE;
      taken_in[sent % QUEUE] = cycle;
      sent = sent + 1;
      in_valid = 1'b0;
      drive;
      if (sent - judged > QUEUE) begin
        mismatch("more pairs were taken than fit");
        $stop;
      end
    end
  endtask

  task empty_core;
    begin
      in_valid = 1'b0;
      while (judged < sent) begin
        if (stall) begin
          draw_stalls;
          in_valid = 1'b0;
        end
        drive;
        tick;
      end
      tick;
    end
  endtask

  task read_pair;
    begin
      fields = 0;
      length = $fgets(line, file);
      if (length != 0) begin
        fields = $sscanf(line,
          "%d %d %d %d %d %d %d %d %d %d %d %d %d %d %d %d %d %d %d %d %d %d %d %d %d %d %d %d",
          number[0], number[1], number[2], number[3], number[4], number[5], number[6], number[7],
          number[8], number[9], number[10], number[11], number[12], number[13], number[14],
          number[15], number[16], number[17], number[18], number[19], number[20], number[21],
          number[22], number[23], number[24], number[25], number[26], number[27]);
      end
    end
  endtask

  initial begin
    cycle = 0;
    idle = 0;
    sent = 0;
    judged = 0;
    mismatches = 0;
    waited = 0;
    blocked = -1;
    offered = 0;
    accepted = 0;
    was_blocked = 1'b0;
    seed = 1;
    stall = $value$plusargs("stall=%d", seed);
    if (!$value$plusargs("pairs=%s", path)) begin
      $display("icarus: give +pairs=FILE");
      $stop;
    end
    file = $fopen(path, "r");
    if (file == 0) begin
      $display("icarus: %0s: cannot be read", path);
      $stop;
    end
    for (i = 0; i < 28; i = i + 1) begin
      number[i] = 0;
    end
    repeat (3) @(negedge clk);
    rst = 1'b0;
    read_pair;
    while (fields == 25 || fields == FIELDS) begin
      send_pair;
      if (sent <= 3) begin
        empty_core; // their latency is checked
      end
      read_pair;
    end
    if (length != 0) begin
      mismatch("a line without 25 integers, or all");
    end
    empty_core;
    out_ready = 1'b1;
    repeat (4 * (LATENCY + II)) tick; // a verdict too many is seen here
    $display("icarus: %0d pairs, %0d mismatches", judged, mismatches);
    if (sent == 0 || judged != sent || mismatches != 0) begin
      $stop;
    end
    $finish;
  end
endmodule

`default_nettype wire
