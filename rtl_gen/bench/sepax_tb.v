// SPDX-License-Identifier: MIT
// Self-checking test bench of @top@ in Verilog-2005, for any simulator. Compile it with
// the files of @prefix@.f; the top is sepax_tb.
// It reads no other file. At the end it prints PASS or FAIL.
// The core is that of an engine, by itself; the buses of the engine are not tested. //@ engine
//
// Its last part is @vectors@ pairs of triangles with the verdicts of the golden model. The bench
// sends some of them alone, which shows the latency, then many without a gap, which shows the rate,
// then all with gaps at random on both sides, and some more after a reset amid others. In each
// cycle it checks all outputs. Verdicts come in the order of the pairs and stand still while they
// wait. No output is X. //@ stream
// wait. No output is X, and without out_valid all are 0. //@ !stream

`default_nettype none
/* verilator lint_off BLKSEQ */
/* verilator lint_off UNUSED */

module sepax_tb;
  localparam W = @word@; // bits of a coordinate
  localparam VECTORS = @vectors@;
  localparam PARTS = @parts@; // transfers of a pair
  localparam LATENCY = @latency@; // cycles from a pair to its verdict, both counted
  localparam GAP = @gap@; // cycles from a pair to the next at full speed
  localparam II = @ii@; // cycles after which the core can take another pair
  localparam IN = @in@; // bits of a pair in this file
  localparam OUT = @out@; // bits of a verdict
  localparam QUEUE = 1024; // more pairs than fit
  localparam PATIENCE = 2000 + 64 * (LATENCY + II); // cycles in which something must happen
  localparam MOST = 10; // errors after which it ends

  reg clk = 1'b0;
  reg rst = 1'b1;
  reg in_valid = 1'b0;
  reg out_ready = 1'b0;
  wire in_ready, out_valid;
  wire [OUT-1:0] shown; // the verdict

  //@ if exact
  reg [18*W-1:0] in;
  wire out_collision, out_coplanar, out_of_range;
  wire [1:0] out_band;
  wire [3:0] out_axis;

  sepax_top dut (
    .clk(clk), .rst(rst), .in_valid(in_valid), .in_ready(in_ready),
    .in_a1_x(in[0*W +: W]), .in_a1_y(in[1*W +: W]), .in_a1_z(in[2*W +: W]),
    .in_a2_x(in[3*W +: W]), .in_a2_y(in[4*W +: W]), .in_a2_z(in[5*W +: W]),
    .in_a3_x(in[6*W +: W]), .in_a3_y(in[7*W +: W]), .in_a3_z(in[8*W +: W]),
    .in_b1_x(in[9*W +: W]), .in_b1_y(in[10*W +: W]), .in_b1_z(in[11*W +: W]),
    .in_b2_x(in[12*W +: W]), .in_b2_y(in[13*W +: W]), .in_b2_z(in[14*W +: W]),
    .in_b3_x(in[15*W +: W]), .in_b3_y(in[16*W +: W]), .in_b3_z(in[17*W +: W]),
    .out_of_range(out_of_range), //@ extents
    .out_band(out_band), //@ limits
    .out_valid(out_valid), .out_ready(out_ready), .out_collision(out_collision),
    .out_coplanar(out_coplanar), .out_axis(out_axis)
  );
  assign out_of_range = 1'b0; //@ !extents
  assign out_band = 2'd0; //@ !limits
  assign shown = {out_of_range, out_band, out_collision, out_coplanar, out_axis};
  //@ end
  //@ if stream
  localparam TAG = @tag@; // bits of a tag
  localparam VERTICES = 6 / PARTS; // of a transfer
  localparam BITS = @bits@;
  reg [BITS-1:0] in;
  reg [TAG-1:0] in_tag;
  reg in_last;
  wire out_last;
  wire [TAG-1:0] out_tag;
  wire [31:0] out_data;

  sepax_stream dut (
    .aclk(clk), .aresetn(!rst), .s_axis_tvalid(in_valid), .s_axis_tready(in_ready),
    .s_axis_tdata(in), .s_axis_tuser(in_tag), .s_axis_tlast(in_last),
    .m_axis_tvalid(out_valid), .m_axis_tready(out_ready), .m_axis_tdata(out_data),
    .m_axis_tuser(out_tag), .m_axis_tlast(out_last)
  );
  assign shown = {out_last, out_tag, out_data};
  //@ end
  //@ if published
  reg [8*W-1:0] in;
  wire out_collision, out_coplanar;

  sepax_top dut (
    .clk(clk), .rst(rst), .in_valid(in_valid),
    .in_a_x(in[0*W +: W]), .in_a_y(in[1*W +: W]), .in_a_z(in[2*W +: W]),
    .in_b_x(in[3*W +: W]), .in_b_y(in[4*W +: W]), .in_b_z(in[5*W +: W]),
    .in_na(in[6*W +: W]), .in_nb(in[7*W +: W]),
    .out_valid(out_valid), .out_collision(out_collision), .out_coplanar(out_coplanar)
  );
  assign in_ready = 1'b1;
  assign shown = {out_collision, out_coplanar};
  //@ end

  always #5 clk = !clk;

  reg [IN-1:0] pair [0:VECTORS-1];
  reg [@verdict@-1:0] verdict [0:VECTORS-1];
  reg [OUT-1:0] due [0:QUEUE-1]; // verdicts of the pairs that were taken
  reg due_timed [0:QUEUE-1]; // must it come after LATENCY cycles?
  integer taken_in [0:QUEUE-1]; // the cycle
  integer cycle = 0;
  integer sent = 0; // pairs that were taken
  integer judged = 0; // verdicts, and pairs that a reset dropped
  integer verdicts = 0;
  integer errors = 0;
  integer waited = 0; // cycles in which nothing happened
  integer streamed = 0; // pairs without a gap
  integer first_in = 0;
  integer last_in = 0;
  integer n = 0; // the pair that is offered
  integer part = 0; // and its transfer
  integer offers = 0; // in so many of 8 cycles
  integer accepts = 0;
  integer left = 0; // cycles for which this holds
  integer drawn = 0;
  reg timed = 1'b0; // the latency of the pair is known
  reg whole = 1'b1; // no batch ends amid a pair //@ stream
  reg taken = 1'b1; // what was offered //@ stream
  reg blocked = 1'b0; // a verdict waits
  reg ended = 1'b0;
  reg [OUT-1:0] shown_before = 0;
  reg [31:0] random = 32'd2463534242;

  // ------------------------------------------------------------------------ checks

  task wrong(input [8*40-1:0] what);
    begin
      errors = errors + 1;
      $display("sepax_tb: cycle %0d, verdict %0d: %0s: valid %b, %b, due %b", cycle, verdicts, what,
               out_valid, shown, due[judged % QUEUE]);
      if (errors == MOST) begin
        finish;
      end
    end
  endtask

  task finish;
    if (!ended) begin
      ended = 1'b1;
      $display("sepax_tb: %0d verdicts, %0d errors", verdicts, errors);
      if (errors == 0 && verdicts > 0) begin
        $display("PASS");
      end else begin
        $display("FAIL");
      end
      $finish;
    end
  endtask

  //@ if !published
  // May the pair pass the core twice, which takes longer? Coplanar ones do, and some on axis 12.
  function twice(input [@verdict@-1:0] of);
    twice = of[4] || of[3:0] == 4'd12; //@ exact
    twice = of[1] || of[11:8] == 4'd12 || of[11:8] == 4'd14; //@ stream
  endfunction
  //@ else
  // The latency is the same for all pairs.
  function twice(input [@verdict@-1:0] of);
    twice = of[0] && 1'b0;
  endfunction
  //@ end

  task judge;
    begin
      if (shown !== due[judged % QUEUE]) begin
        wrong("a wrong verdict");
      end
      if (due_timed[judged % QUEUE] && cycle - taken_in[judged % QUEUE] + 1 != LATENCY) begin
        wrong("a wrong latency");
      end
      judged = judged + 1;
      verdicts = verdicts + 1;
    end
  endtask

  // A transfer is taken; with the last one of a pair its verdict is due.
  task take;
    begin
      first_in = streamed == 0 && part == 0 ? cycle : first_in;
      part = part + 1;
      //@ if stream
      if (part == PARTS || in_last) begin
        due[sent % QUEUE] = {in_last, in_tag, part == PARTS ? verdict[n] : 32'd@cut@};
      //@ else
      if (part == PARTS) begin
        due[sent % QUEUE] = verdict[n];
      //@ end
        due_timed[sent % QUEUE] = timed;
        taken_in[sent % QUEUE] = cycle; //@ !published
        taken_in[sent % QUEUE] = cycle - (PARTS - 1); //@ published
        last_in = cycle;
        streamed = streamed + 1;
        sent = sent + 1;
        part = 0;
      end
      if (sent - judged == QUEUE) begin
        wrong("more pairs are taken than fit");
        finish;
      end
    end
  endtask

  // What stands at the rising edge of the clock; the inputs change at the falling edge.
  always @(posedge clk) begin
    cycle = cycle + 1;
    if (rst) begin
      judged = sent;
      part = 0;
      taken = 1'b1; //@ stream
      blocked = 1'b0;
    end else if (!ended) begin
      if (^{in_ready, out_valid, shown} === 1'bx) begin //@ !stream
      if (^{in_ready, out_valid} === 1'bx) begin //@ stream
        wrong("an output is X");
      end
      //@ if !stream
      if (out_valid !== 1'b1 && |shown !== 1'b0) begin
        wrong("an output without a verdict");
      end
      //@ end
      if (blocked && (out_valid !== 1'b1 || shown !== shown_before)) begin
        wrong("a verdict moves while it waits");
      end
      if ((in_valid && in_ready === 1'b1) || (out_valid === 1'b1 && out_ready)) begin
        waited = 0;
      end else if (out_ready && (in_valid || judged != sent)) begin
        waited = waited + 1;
      end
      if (waited > PATIENCE) begin
        wrong("nothing comes, nothing is taken");
        finish;
      end
      blocked = out_valid === 1'b1 && !out_ready;
      shown_before = shown;
      if (out_valid === 1'b1 && judged == sent) begin
        wrong("a verdict that nobody asked for");
      end else if (out_valid === 1'b1 && out_ready) begin
        judge;
      end
      taken = in_valid && in_ready === 1'b1; //@ stream
      if (in_valid && in_ready === 1'b1) begin
        take;
      end
    end
  end

  // ---------------------------------------------------------------------- stimulus

  // 0 ... below - 1; the same numbers in every simulator.
  task draw(input integer below, output integer number);
    begin
      random = random ^ (random << 13);
      random = random ^ (random >> 17);
      random = random ^ (random << 5);
      number = {16'd0, random[31:16]} % below;
    end
  endtask

  // In how many of 8 cycles a signal is 1.
  task draw_rate(output integer rate);
    begin
      draw(5, rate);
      rate = rate == 4 ? 8 : rate == 3 ? 7 : rate == 2 ? 4 : rate;
    end
  endtask

  // Both sides have a rate for a stretch of cycles.
  task draw_stretch;
    begin
      draw(64, left);
      draw_rate(offers);
      draw_rate(accepts);
    end
  endtask

  //@ if exact
  // Pair n, or anything when none is offered.
  task drive;
    in = pair[n] ^ (in_valid ? {18*W{1'b0}} : {18{random[W-1:0]}});
  endtask
  //@ end
  //@ if published
  // Word `part` of pair n, or anything when none is offered.
  task drive;
    in = pair[n][8*W*part +: 8*W] ^ (in_valid ? {8*W{1'b0}} : {8{random[W-1:0]}});
  endtask
  //@ end
  //@ if stream
  // Transfer `part` of pair n, or anything when none is offered. The bits of no coordinate are
  // anything. Now and then a batch ends, also amid a pair.
  task drive;
    integer v;
    begin
      in = {BITS/32{random}};
      for (v = 0; v < VERTICES && in_valid; v = v + 1) begin
        in[512*(v/3) + 128*(v%3) +: 96] = pair[n][96*(part*VERTICES+v) +: 96];
      end
      draw(65536, drawn);
      in_tag = @drawn_tag@;
      draw(65536, drawn);
      in_last = drawn % (part + 1 == PARTS ? 4 : 16) == 0 && !whole;
    end
  endtask
  //@ end

  // One cycle: offer what is next, or nothing, at random unless `steady`.
  task tick(input offer, input steady);
    begin
      left = left - 1;
      if (left < 0) begin
        draw_stretch;
      end
      draw(8, drawn);
      //@ if stream
      // AXI4-Stream: what was offered stands until it is taken.
      if (!in_valid || taken) begin
        in_valid = offer && (steady || drawn < offers);
        drive;
      end
      //@ else
      in_valid = offer && (steady || drawn < offers);
      drive;
      //@ end
      draw(8, drawn);
      out_ready = steady || drawn < accepts; //@ !published
      out_ready = 1'b1; //@ published
      @(negedge clk);
    end
  endtask

  task send(input steady);
    integer goal;
    begin
      goal = sent + 1;
      while (sent != goal && !ended) begin
        tick(1'b1, steady);
      end
    end
  endtask

  task drain(input steady);
    while (judged != sent && !ended) begin
      tick(1'b0, steady);
    end
  endtask

  // So many pairs, one after the other without a gap.
  task stream(input integer count);
    begin
      streamed = 0;
      for (n = 0; n < VECTORS && streamed < count && !ended; n = n + 1) begin
        if (!twice(verdict[n])) begin
          send(1'b1);
        end
      end
      if (streamed > 0 && last_in - first_in > GAP * streamed) begin
        wrong("pairs are taken too slowly");
      end
      n = 0;
      drain(1'b1);
    end
  endtask

  // Each alone.
  task probe(input integer count);
    for (n = 0; n < VECTORS && n < count; n = n + 1) begin
      timed = !twice(verdict[n]);
      send(1'b1);
      drain(1'b1);
      repeat (2 * II) tick(1'b0, 1'b1);
    end
  endtask

  initial begin
    repeat (3) @(negedge clk);
    rst = 1'b0;
    probe(16);
    timed = @always@;
    stream(VECTORS);
    whole = 1'b0; //@ stream
    for (n = 0; n < VECTORS; n = n + 1) begin
      send(1'b0);
    end
    n = 0;
    drain(1'b0);
    for (n = 0; n < VECTORS && n < 8; n = n + 1) begin
      send(1'b1);
    end
    n = 0;
    repeat (2) tick(1'b1, 1'b1);
    rst = 1'b1; // amid pairs
    tick(1'b0, 1'b1);
    rst = 1'b0;
    whole = 1'b1; //@ stream
    stream(64);
    repeat (4 * (LATENCY + II)) tick(1'b0, 1'b1); // a verdict too many is seen here
    finish;
  end

  // Each pair, @pair_about@; and its verdict,
  // @verdict_about@.
  initial begin
