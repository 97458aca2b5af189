// SPDX-License-Identifier: MIT
// host.v - what AXI asks of the tree engine on the channels that it drives, and order around it,
// for ABC: inputs are free in every cycle after a reset, but for what their source keeps to, which
// is assumed; host_jobs proves it of sepax_tree_jobs. With `stands` and `answers` of
// tb/formal/axi_properties.v.
`default_nettype none

module host_registers (
    input wire clk, rst, awvalid, wvalid, bready, arvalid, rready, done, hit, ended,
    input wire [6:0] awaddr, araddr,
    input wire [3:0] wstrb,
    input wire [31:0] wdata, status, number
);
  wire awready, wready, bvalid, arready, rvalid;
  wire [1:0] bresp, rresp;
  wire [31:0] rdata;
  sepax_registers dut (
      .clk(clk), .rst(rst), .awvalid(awvalid), .awready(awready), .awaddr(awaddr), .wvalid(wvalid),
      .wready(wready), .wdata(wdata), .wstrb(wstrb), .bvalid(bvalid), .bready(bready),
      .bresp(bresp), .arvalid(arvalid), .arready(arready), .araddr(araddr), .rvalid(rvalid),
      .rready(rready), .rdata(rdata), .rresp(rresp), .status(status), .job(number),
      .pose(number), .poses(number), .hits(number), .hit_job(number), .hit_pose(number),
      .cycles(number), .done(done), .hit(hit), .ended(ended));
  stands #(.WIDTH(2)) b (.clk(clk), .rst(rst), .valid(bvalid), .ready(bready), .data(bresp));
  stands #(.WIDTH(34)) r (
      .clk(clk), .rst(rst), .valid(rvalid), .ready(rready), .data({rresp, rdata}));
  answers writes (
      .clk(clk), .rst(rst), .request(awvalid && awready), .valid(bvalid), .ready(bready));
  answers data (
      .clk(clk), .rst(rst), .request(wvalid && wready), .valid(bvalid), .ready(bready));
  answers reads (
      .clk(clk), .rst(rst), .request(arvalid && arready), .valid(rvalid), .ready(rready));
endmodule

// In the place of the queue of results: words in order (tb/formal/tree proves it of the queue), of
// which one, whichever, is what was put in: its TLAST, and of its data the highest bit and another,
// whichever. The proof of sepax_tree_results has no memory then.
module sepax_ram_fifo #(parameter WIDTH = 8, parameter ADDRESS = 4) (
    input wire clk, clear, push, pop,
    input wire [WIDTH-1:0] in,
    output wire valid,
    output wire [WIDTH-1:0] out
);
  reg [4:0] head, tail; // words that went out, that came in, modulo 32
  reg highest, last, other;
  (* anyconst *) wire [4:0] watched;
  (* anyconst *) wire [5:0] number;
  (* anyseq *) wire [WIDTH-1:0] any;
  wire [WIDTH-1:0] one = {{(WIDTH-1){1'b0}}, 1'b1} << number;
  wire [WIDTH-1:0] word = {last, highest, {(WIDTH-2){other}}};
  wire [WIDTH-1:0] known = {2'b11, {(WIDTH-2){1'b0}}} | one;
  assign valid = head != tail;
  assign out = head == watched ? (word & known) | (any & ~known) : any;
  reg begun = 1'b0;
  always @(posedge clk) begin
    begun <= 1'b1;
    if (clear) {head, tail} <= 10'd0;
    else {head, tail} <= {head + {4'd0, pop}, tail + {4'd0, push}};
    if (push && tail == watched) {last, highest, other} <= {in[WIDTH-1:WIDTH-2], |(in & one)};
    assume (number != 6'd63);
    if (begun && !clear) begin
      assert (!push || tail - head != 5'd16);
      assert (!pop || valid);
    end
  end
endmodule

// Results: transfers stand; each pair that was taken is one, each end eight, the last with TLAST,
// in their order. An end is taken with room for it, and its numbers within eight cycles.
module host_results (
    input wire clk, rst, valid, ask_send, tready, coplanar, outside, warning,
    input wire [31:0] a, number,
    input wire [23:0] b,
    input wire [6:0] status
);
  wire ready, room, sent, busy, tvalid, tlast;
  wire [63:0] tdata;
  wire send = ask_send && room && !valid; // a run has ended: it has no pairs then
  sepax_tree_results dut (
      .clk(clk), .rst(rst), .valid(valid), .ready(ready), .a(a), .b(b), .coplanar(coplanar),
      .outside(outside), .warning(warning), .send(send), .status(status), .room(room),
      .sent(sent), .busy(busy), .job(number), .pose(number), .steps(number), .cycles(number),
      .near(number), .collisions(number), .out_of_range(number), .warnings(number),
      .pairs(number), .rows(number), .entries(number), .first_a(number), .first_b(b),
      .first_row_a(27'd0), .first_row_b(27'd0), .tvalid(tvalid), .tready(tready),
      .tdata(tdata), .tlast(tlast));
  stands #(.WIDTH(65)) m (
      .clk(clk), .rst(rst), .valid(tvalid), .ready(tready), .data({tlast, tdata}));
  reg begun = 1'b0;
  reg [2:0] left;         // numbers of the end that are not taken
  reg [4:0] came, gone;   // transfers that were taken, that left, modulo 32
  (* hierconn *) wire [4:0] \dut.queue.watched ;
  wire [4:0] one = \dut.queue.watched ; // this transfer is watched
  (* hierconn *) wire [5:0] \dut.queue.number ;
  (* hierconn *) wire [4:0] \dut.queue.head , \dut.queue.tail , \dut.count_q ;
  (* hierconn *) wire \dut.ending_q , \dut.queue.last , \dut.queue.highest , \dut.queue.other ;
  (* hierconn *) wire [2:0] \dut.number_q ;
  wire [4:0] behind = \dut.queue.tail - one - 5'd1; // transfers put in after the watched one
`ifdef FPGA
  (* hierconn *) wire \dut.push_q , \dut.last_q ;
  (* hierconn *) wire [63:0] \dut.shown_q ;
`endif
  reg is_end, is_last, is_first;        // what it is
  reg pair;                             // the bit of it that is watched
  wire [58:0] pair_now = {warning, outside, coplanar, b, a};
  wire [63:0] data_now = {5'd0, pair_now};
  reg [2:0] silent;       // cycles without a transfer while one is to go
  wire taken = valid && ready;
  wire comes = taken || send || (|left);
  always @(posedge clk) begin
    begun <= 1'b1;
    assume (begun || rst);
    if (rst) {left, came, gone, silent} <= 16'd0;
    else begin
      left <= send ? 3'd7 : left - {2'd0, |left};
      came <= came + {4'd0, comes};
      if (comes && came == one) begin
        {is_end, is_first, is_last} <= {!taken, send, left == 3'd1};
        pair <= data_now[\dut.queue.number ];
      end
      gone <= gone + {4'd0, tvalid && tready};
      silent <= tvalid || came == gone ? 3'd0 : silent + 3'd1;
      if (begun) begin
        assert (!(taken && (|left)));
        assert (sent == (left == 3'd1));
        assert (busy || came == gone);
        assert (!room || !(|left));
        assert (silent <= 3'd4);
        if (tvalid && gone == one) begin
          assert (tlast == (is_end && is_last));
          if (is_end) assert (tdata[63] || !is_first);
          else assert (tdata[\dut.queue.number ] == pair);
        end
        // So that the proof ends.
        assert (\dut.ending_q == (left != 3'd0));
        assert (\dut.number_q == 3'd0 - left);
        assert ({1'b0, \dut.count_q } + {3'd0, left} <= 6'd16);
        if (behind < \dut.queue.tail - \dut.queue.head ) begin
          assert (\dut.queue.last == (is_end && is_last));
          if (is_end) assert (\dut.queue.highest || !is_first);
          else assert (\dut.queue.other == pair);
        end
        assert (\dut.queue.head == gone + {4'd0, tvalid});
        assert (\dut.count_q == came - \dut.queue.head );
        assert (came - \dut.queue.head <= 5'd16);
        assert (\dut.queue.tail - \dut.queue.head <= 5'd16);
`ifdef FPGA
        assert (came == \dut.queue.tail + {4'd0, \dut.push_q });
        if (\dut.push_q && \dut.queue.tail == one) begin
          assert (\dut.last_q == (is_end && is_last));
          if (is_end) assert (\dut.shown_q [63] || !is_first);
          else assert (\dut.shown_q [\dut.queue.number ] == pair);
        end
`else
        assert (came == \dut.queue.tail );
`endif
      end
    end
  end
endmodule

// Bursts of jobs and poses: a burst stands until it is taken. A pose is asked for only while one of
// the sixteen slots is free. Poses come into their slots and are taken in order. Errors of a job
// are told.
module host_fetch (
    input wire clk, rst, ask_in, begins_in, drop_in, take_in, ready, came_in, ends, error_in,
    input wire [32:0] job,
    input wire [31:0] poses, count,
    input wire [2:0] beat
);
  wire busy, error, more, valid, fill, burst;
  wire [3:0] take_slot, fill_slot, beats;
  wire [35:0] address;
  reg begun = 1'b0;
  reg [5:0] asked, come, taken;   // poses, modulo 64
  reg open_job, wants_job;        // a job is on its way, is not asked for
  reg job_error, some, was_some;
  reg [31:0] left;                // poses that are not asked for
  reg [31:0] next;                // address of the next pose
  wire [5:0] open = asked - come; // poses that are on their way
  // The list asks for a job, and begins with poses, when nothing is on its way.
  wire ask = ask_in && !busy && !more && !was_some && come == taken && asked == come;
  wire begins = begins_in && !ask && !busy && !more && !was_some && asked == taken;
  wire drop = drop_in && !ask && !begins && !take_in;
  wire take = take_in && valid;
  wire came = came_in && (open_job || open != 6'd0);
  sepax_tree_fetch #(.ADDRESS(40)) dut (
      .clk(clk), .rst(rst), .ask(ask), .job(job), .busy(busy), .error(error), .read(1'b0),
      .read_beat(3'd0), .begins(begins), .poses(poses), .count(count), .drop(drop), .more(more),
      .valid(valid), .take(take), .take_slot(take_slot), .fill(fill), .fill_slot(fill_slot),
      .burst(burst), .burst_ready(ready), .burst_address(address), .burst_beats(beats),
      .came(came), .came_data(128'd0), .came_beat(beat), .came_last(ends),
      .came_error(error_in));
  stands #(.WIDTH(40)) b (
      .clk(clk), .rst(rst), .valid(burst), .ready(ready), .data({address, beats}));
  (* hierconn *) wire \dut.asks_pose , \dut.dropped , \dut.dropping_q , \dut.is_job_q ;
  (* hierconn *) wire [31:0] \dut.left_q , \dut.pose_q ;
  (* hierconn *) wire [3:0] \dut.head_q , \dut.tail_q ;
  (* hierconn *) wire [4:0] \dut.used_q , \dut.here_q ;
`ifdef FPGA
  (* hierconn *) wire [1:0] \dut.came_q ;
  wire [5:0] late = {5'd0, \dut.came_q [0]} + {5'd0, \dut.came_q [1]};
`else
  wire [5:0] late = 6'd0;
`endif
  wire dropped = \dut.dropped ;
  wire waits = burst && !wants_job; // a pose's burst is not taken
  reg job_seen;
  always @(posedge clk) begin
    begun <= 1'b1;
    assume (begun || rst);
    if (rst) begin
      {asked, come, taken, left} <= 50'd0;
      {open_job, wants_job, was_some, job_seen} <= 4'd0;
    end else begin
      was_some <= begins || asked != taken || left != 32'd0;
      wants_job <= ask || (wants_job && !(burst && ready));
      open_job <= (wants_job && burst && ready) || (open_job && !(came && ends));
      job_seen <= job_seen || ask;
      if (ask) job_error <= 1'b0;
      else if (came && open_job) job_error <= job_error || error_in;
      if (begins) left <= count;
      else if (drop) left <= {31'd0, (waits && !ready) || \dut.asks_pose }; // it stands
      else if (burst && ready && !wants_job) left <= left - 32'd1;
      if (begins) next <= poses;
      else if (burst && ready && !wants_job) next <= next + 32'd1;
      asked <= asked + {5'd0, burst && ready && !wants_job};
      come <= come + {5'd0, came && ends && !open_job};
      taken <= dropped ? come : taken + {5'd0, take};
      if (begun) begin
        assert (!wants_job || (burst && beats == 4'd5));
        if (burst && !wants_job) begin
          assert (beats == 4'd8 && address == {next, 4'd0});
          assert (asked - taken < 6'd16);
        end
        assert (asked - taken <= 6'd16 && open <= 6'd16 && come - taken <= 6'd16);
        assert (!(wants_job || open_job) || (busy && !fill));
        assert (fill == (came && !open_job));
        if (fill) assert (fill_slot == come[3:0]);
        if (valid) assert (come != taken && take_slot == taken[3:0]);
        if (job_seen) assert (error == job_error);
        // So that the proof ends.
        assert (left == \dut.left_q + {31'd0, waits});
        if (waits || left != 32'd0) assert (next == \dut.pose_q );
        assert ({1'b0, \dut.used_q } == asked - taken + {5'd0, waits});
        assert (\dut.used_q <= 5'd16);
        assert ({1'b0, \dut.here_q } == come - taken - late);
        assert (\dut.head_q == taken[3:0] && \dut.tail_q == come[3:0]);
        assert (\dut.is_job_q == (wants_job || open_job) && !(wants_job && open_job));
        if (open_job || wants_job) assert (asked == taken && come == taken && left == 32'd0);
        if (\dut.dropping_q ) assert (\dut.left_q == 32'd0);
        if (asked != taken || left != 32'd0) assert (more || was_some);
        if (wants_job || open_job) assert (!waits);
      end
    end
  end
endmodule

// In the place of a memory: one word, whichever, is what was written.
module sepax_ram #(parameter WIDTH = 8, parameter ADDRESS = 4, parameter DISTRIBUTED = 0) (
    input wire clk, write, read,
    input wire [ADDRESS-1:0] write_address, read_address,
    input wire [WIDTH-1:0] write_data,
    output reg [WIDTH-1:0] read_data
);
  reg [WIDTH-1:0] word;
  (* anyconst *) wire [ADDRESS-1:0] watched;
  (* anyseq *) wire [WIDTH-1:0] any;
  always @(posedge clk) begin
    if (write && write_address == watched) word <= write_data;
    if (read) read_data <= read_address == watched ? word : any;
  end
endmodule

// Poses in their slots: an error of the memory, or a number out of its range, in any beat of a pose
// is told when it is read; the number of the range check here is sigma_B's last.
module host_pose (
    input wire clk, rst, write_in, read_in, error,
    input wire [3:0] write_slot_in, read_slot,
    input wire [127:0] data
);
  wire failed, bad;
  reg begun = 1'b0;
  reg [3:0] beat;                // of the pose that comes
  reg [3:0] slot;                // its slot
  (* hierconn *) wire [3:0] \dut.marks.watched ;
  (* hierconn *) wire [1:0] \dut.marks.word ;
  (* hierconn *) wire \dut.error_q , \dut.wrong_q ;
  wire [3:0] one = \dut.marks.watched ; // this slot is watched
  reg known, one_failed, one_high, failing, was_read;
  reg was_failed, was_high;
  reg [2:0] settled;             // cycles since its last beat
`ifdef FPGA
  (* hierconn *) wire \dut.write_q , \dut.failed_q ;
  (* hierconn *) wire [3:0] \dut.slot_q , \dut.beat_q , \dut.wide_sigma_q ;
`endif
  wire [3:0] write_slot = beat == 4'd0 ? write_slot_in : slot;
  wire high = beat == 4'd8 && (|data[127:120]);
  wire write = write_in && !rst;
  wire now_fails = error || (failing && beat != 4'd0);
  wire read = read_in && (read_slot != one || (known && (&settled)));
  sepax_tree_pose dut (
      .clk(clk), .write(write), .write_slot(write_slot), .beat(beat), .data(data),
      .error(error), .read(read), .read_slot(read_slot), .failed(failed), .bad(bad));
  always @(posedge clk) begin
    begun <= 1'b1;
    assume (begun || rst);
    was_read <= !rst && read && read_slot == one;
    if (rst) {beat, known, settled} <= 8'd0;
    else begin
      if (write) begin
        beat <= beat == 4'd8 ? 4'd0 : beat + 4'd1;
        slot <= write_slot;
        failing <= now_fails;
      end
      settled <= {settled[1:0], 1'b1};
      if (write && write_slot == one) begin
        known <= beat == 4'd8;
        settled <= 3'd0;
        {one_failed, one_high} <= {now_fails, high};
      end
      was_failed <= one_failed;
      was_high <= one_high;
      if (begun && was_read) begin
        assert (failed == was_failed);
        assert (bad || !was_high);
      end
      // So that the proof ends.
      if (begun) begin
        assert (beat <= 4'd8);
        if (known && settled[0]) begin
          assert (\dut.marks.word [1] == one_failed && (\dut.marks.word [0] || !one_high));
        end
        if (known) assert (beat == 4'd0 || slot != one);
`ifdef FPGA
        if (\dut.write_q ) begin
          assert (failing == (\dut.failed_q || (\dut.error_q && \dut.beat_q != 4'd0)));
          assert (\dut.slot_q == slot && beat == (\dut.beat_q == 4'd8 ? 4'd0 : \dut.beat_q + 4'd1));
          if (known && !settled[0] && \dut.beat_q == 4'd8 && slot == one) begin
            assert (one_failed == failing && (\dut.wide_sigma_q [3] || !one_high));
          end
        end else begin
          assert (beat == 4'd0 || failing == \dut.error_q );
        end
        if (known && !settled[0]) assert (\dut.write_q && \dut.beat_q == 4'd8 && slot == one);
`else
        assert (beat == 4'd0 || failing == \dut.error_q );
        if (known) begin
          assert (\dut.marks.word [1] == one_failed && (\dut.marks.word [0] || !one_high));
        end
`endif
      end
    end
  end
endmodule

// The list of jobs: a job is asked for while none comes and no poses are left, poses begin after
// it, an end is sent with room for it, and a run begins while none is. Whatever jobs, poses and
// runs say.
module host_jobs (
    input wire clk, rst, start, stop, come, fetch_error, bad_job, bad_pose, failed, ended, any,
    input wire undecided, stopped, damaged, run_error, room, sent, here, fewer,
    input wire [32:0] list,
    input wire [31:0] jobs,
    input wire [5:0] modes
);
  wire busy, done, ask, run_start, send, begin_poses, drop, take;
  reg begun = 1'b0;
  reg fetching, running, sending, more, dropping, was_more;
  wire run_done = running && ended;
  wire pose_valid = more && here;
  wire fetch_busy = fetching || dropping;
  sepax_tree_jobs #(.ADDRESS(40)) dut (
      .clk(clk), .rst(rst), .start(start), .stop(stop), .list(list), .jobs(jobs), .busy(busy),
      .done(done), .ask(ask), .fetch_busy(fetch_busy), .fetch_error(fetch_error),
      .bad_job(bad_job), .bad_pose(bad_pose), .begin_poses(begin_poses), .drop_poses(drop),
      .more_poses(was_more), .pose_valid(pose_valid), .take_pose(take),
      .pose_failed(failed), .modes(modes), .job_row_a(27'd0), .job_row_b(27'd0),
      .run_idle(!running), .run_start(run_start), .run_done(run_done), .any(any),
      .undecided(undecided), .stopped(stopped), .damaged(damaged), .run_error(run_error),
      .first_row_a(27'd0), .first_row_b(27'd0), .send(send), .send_room(room && !sending),
      .send_busy(sending));
  (* hierconn *) wire [3:0] \dut.state_q ;
  (* hierconn *) wire \dut.ahead_q , \dut.bus_q ;
  wire [3:0] state = \dut.state_q ;
  wire ahead = \dut.ahead_q ;
  localparam IDLE = 4'd0, ASK = 4'd1, WAIT = 4'd2, LOAD = 4'd3, JUDGE = 4'd4, POSE = 4'd5;
  localparam START = 4'd6, RUN = 4'd7, HOLD = 4'd8, FAIL = 4'd9, END = 4'd10;
`ifdef FPGA
  (* hierconn *) wire \dut.busy_q ;
`endif
  always @(posedge clk) begin
    begun <= 1'b1;
    assume (begun || rst);
    assume (!start || !busy);
    fetching <= !rst && (ask || (fetching && !come));
    dropping <= !rst && (drop || (dropping && !come));
    more <= !rst && (begin_poses || (more && !drop && !(take && fewer)));
    was_more <= !rst && more;
    running <= !rst && (run_start || (running && !run_done));
    sending <= !rst && (send || (sending && !sent));
    if (begun && !rst) begin
      assert (!ask || (!fetching && !dropping && !more));
      assert (!begin_poses || (!fetching && !dropping && !more && !running && !run_start));
      assert (!drop || !take);
      assert (!take || pose_valid);
      assert (!send || (!sending && room));
      assert (!run_start || (!running && busy));
      assert (!done || (!running && !fetching && !sending && !dropping));
      // So that the proof ends.
      assert (state <= END);
      assert (!run_start || (state == RUN && !running));
      assert (!running || state == RUN);
      assert (state != RUN || run_start || running);
      assert (!more || was_more || state == POSE);
      if (state == IDLE || state == ASK || state == WAIT || state == LOAD || state == JUDGE ||
          state == END) assert (!more);
      assert (!dropping || state == ASK || state == WAIT || state == END);
      assert (!fetching || state == WAIT || state == END ||
              (ahead && (state == RUN || state == HOLD)));
      if (ahead && (state == RUN || state == HOLD)) assert (!more && !was_more);
      if (state == POSE || state == START || state == ASK) assert (!ahead);
      if (state == JUDGE) assert (!ahead || \dut.bus_q );
      if (state == IDLE) assert (!sending);
`ifdef FPGA
      assert (\dut.busy_q == (state != IDLE));
`endif
    end
  end
endmodule

`default_nettype wire
