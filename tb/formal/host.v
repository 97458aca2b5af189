// SPDX-License-Identifier: MIT
// host.v - what AXI asks of the tree engine on the channels that it drives, for ABC: inputs are
// free in every cycle after a reset, but for what their source keeps to, which is assumed;
// host_jobs proves it of sepax_tree_jobs. With `stands` and `answers` of
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

// Results: transfers stand; each pair that was taken is one, each end eight, the last with TLAST,
// with three cycles between them at most.
module host_results (
    input wire clk, rst, valid, send, tready, coplanar, outside, warning,
    input wire [31:0] a, number,
    input wire [23:0] b,
    input wire [6:0] status
);
  wire ready, busy, tvalid, tlast;
  wire [63:0] tdata;
  sepax_tree_results dut (
      .clk(clk), .rst(rst), .valid(valid), .ready(ready), .a(a), .b(b), .coplanar(coplanar),
      .outside(outside), .warning(warning), .send(send), .status(status), .busy(busy),
      .job(number), .pose(number), .steps(number), .cycles(number), .near(number),
      .collisions(number), .warnings(number), .out_of_range(number), .pairs(number),
      .rows(number), .entries(number), .first_a(number), .first_b(b), .first_row_a(27'd0),
      .first_row_b(27'd0), .tvalid(tvalid), .tready(tready), .tdata(tdata), .tlast(tlast));
  stands #(.WIDTH(65)) m (
      .clk(clk), .rst(rst), .valid(tvalid), .ready(tready), .data({tlast, tdata}));
  reg begun = 1'b0;
  reg ending;           // an end is to go
  reg waits;            // a pair is to go
  reg [58:0] pair;
  reg [2:0] gone;       // transfers of the end
  reg [2:0] silent;     // cycles without a transfer while an end is to go
  always @(posedge clk) begin
    begun <= 1'b1;
    if (rst) {ending, waits, gone, silent} <= 8'd0;
    else begin
      // No pair and no end comes while one goes out.
      if (busy || ending) assume (!send);
      if (ending || send) assume (!valid);
      if (send) ending <= 1'b1;
      if (tvalid && tready) begin
        waits <= 1'b0;
        if (!waits) begin
          gone <= gone + 3'd1;
          if (&gone) ending <= 1'b0;
        end
      end
      if (valid && ready) waits <= 1'b1;
      if (valid && ready) pair <= {warning, outside, coplanar, b, a};
      silent <= tvalid || !ending ? 3'd0 : silent + 3'd1;
      if (begun && ending) assert (busy && silent <= 3'd3);
      if (begun && tvalid) begin
        assert (waits || ending);
        assert (tlast == (!waits && (&gone)));
        if (waits) assert (tdata == {5'd0, pair});
        if (!waits && gone == 3'd0) assert (tdata[63]);
      end
    end
  end
endmodule

// The read port of memory: an address stands until it is taken, whoever asks. Bursts of jobs and
// poses come whole. The engine's port keeps to AXI, and has nothing open when one is asked for.
module host_fetch (
    input wire clk, rst, ask, engine_arvalid, engine_rready, arready, rvalid, rlast,
    input wire [39:0] ask_address, engine_araddr,
    input wire [3:0] ask_beats, read_beat,
    input wire [7:0] engine_arlen,
    input wire [1:0] rresp
);
  wire busy, error, arvalid, rready, engine_arready, engine_rvalid;
  wire [39:0] araddr;
  wire [7:0] arlen;
  sepax_tree_fetch #(.ADDRESS(40)) dut (
      .clk(clk), .rst(rst), .ask(ask), .ask_address(ask_address), .ask_beats(ask_beats),
      .busy(busy), .error(error), .read(1'b0), .read_beat(read_beat),
      .engine_arvalid(engine_arvalid), .engine_arready(engine_arready),
      .engine_araddr(engine_araddr), .engine_arlen(engine_arlen),
      .engine_rvalid(engine_rvalid), .engine_rready(engine_rready), .arvalid(arvalid),
      .arready(arready), .araddr(araddr), .arlen(arlen), .rvalid(rvalid), .rready(rready),
      .rdata(128'd0), .rresp(rresp), .rlast(rlast));
  reg begun = 1'b0;
  reg stood, asked, coming, of_engine;
  reg [47:0] address, engine;
  reg [4:0] left; // beats of the burst that was asked for
  always @(posedge clk) begin
    begun <= 1'b1;
    assume (begun || rst);
    stood <= begun && !rst && arvalid && !arready;
    address <= {araddr, arlen};
    of_engine <= begun && !rst && engine_arvalid && !engine_arready;
    engine <= {engine_araddr, engine_arlen};
    if (rst) {asked, coming} <= 2'd0;
    else begin
      assume (!ask || (!busy && !coming && !engine_arvalid));
      if (ask) {asked, coming, left} <= {2'b11, {1'b0, ask_beats} + 5'd1};
      if (arvalid && arready) asked <= 1'b0;
      if (coming) assume (!rvalid || !asked);
      if (rvalid && rready && coming) begin
        left <= left - 5'd1;
        if (left == 5'd1) coming <= 1'b0;
      end
      if (begun && of_engine) begin
        assume (engine_arvalid && {engine_araddr, engine_arlen} == engine);
      end
      if (begun && stood) assert (arvalid && {araddr, arlen} == address);
      if (begun && coming) begin
        assert (busy);
        assert (!engine_rvalid);
        assert (rready);
      end
      if (begun && asked) assert (arvalid && !engine_arready);
    end
  end
endmodule

// The list of jobs: a burst is asked for while none comes and the engine is idle, an end is sent
// while none goes out, and a run begins while none is. Whatever jobs, poses and runs say.
module host_jobs (
    input wire clk, rst, start, stop, come, fetch_error, bad_job, bad_pose, ended, any, undecided,
    input wire stopped, damaged, run_error, sent,
    input wire [32:0] list,
    input wire [31:0] jobs, count, poses,
    input wire [5:0] modes
);
  wire busy, done, ask, run_start, send;
  reg begun = 1'b0;
  reg fetching, running, sending;
  wire run_done = running && ended;
`ifdef FPGA
  reg was_fetching, was_sending; // busy is a register there
  wire fetch_busy = fetching || was_fetching, send_busy = sending || was_sending;
`else
  wire fetch_busy = fetching, send_busy = sending;
`endif
  sepax_tree_jobs #(.ADDRESS(40)) dut (
      .clk(clk), .rst(rst), .start(start), .stop(stop), .list(list), .jobs(jobs), .busy(busy),
      .done(done), .ask(ask), .fetch_busy(fetch_busy), .fetch_error(fetch_error),
      .bad_job(bad_job), .bad_pose(bad_pose), .poses(poses), .count(count), .modes(modes),
      .job_row_a(27'd0), .job_row_b(27'd0), .run_idle(!running), .run_start(run_start),
      .run_done(run_done), .any(any), .undecided(undecided), .stopped(stopped),
      .damaged(damaged), .run_error(run_error), .first_row_a(27'd0), .first_row_b(27'd0),
      .send(send), .send_busy(send_busy));
  always @(posedge clk) begin
    begun <= 1'b1;
    assume (begun || rst);
    assume (!start || !busy);
    fetching <= !rst && (ask || (fetching && !come));
    running <= !rst && (run_start || (running && !run_done));
    sending <= !rst && (send || (sending && !sent));
`ifdef FPGA
    was_fetching <= !rst && (ask || fetching);
    was_sending <= !rst && (send || sending);
`endif
    if (begun && !rst) begin
      assert (!ask || (!fetching && !running && !run_start));
      assert (!send || !sending);
      assert (!run_start || (!running && busy));
      assert (!done || (!running && !fetching && !sending));
    end
  end
endmodule

`default_nettype wire
