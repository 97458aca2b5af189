// SPDX-License-Identifier: MIT
// Tree engine: finds the colliding triangles of two bodies for a list of jobs, which are pairs of
// bodies with a queue of poses each (docs/reference/tree-engine.md). s_axi (AXI4-Lite) starts a
// batch and reads its counts. m_axi (AXI4) reads the memory. m_axis (AXI4-Stream) sends collisions
// and the ends of poses. @cores@ exact core@plural@ of II = @ii@ judge@verb@ near pairs.
module sepax_engine (
  (* X_INTERFACE_INFO = "xilinx.com:signal:clock:1.0 aclk CLK" *)
  (* X_INTERFACE_PARAMETER = "ASSOCIATED_BUSIF s_axi:m_axi:m_axis, ASSOCIATED_RESET aresetn" *)
  input  wire         aclk,          // clock of all parts
  (* X_INTERFACE_INFO = "xilinx.com:signal:reset:1.0 aresetn RST" *)
  (* X_INTERFACE_PARAMETER = "POLARITY ACTIVE_LOW" *)
  input  wire         aresetn,       // synchronous reset of control and buses, active low
  (* X_INTERFACE_INFO = "xilinx.com:interface:aximm:1.0 s_axi AWVALID" *)
  (* X_INTERFACE_PARAMETER = "PROTOCOL AXI4LITE" *)
  input  wire         s_axi_awvalid, // AXI4-Lite, registers: address to write
  (* X_INTERFACE_INFO = "xilinx.com:interface:aximm:1.0 s_axi AWREADY" *)
  output wire         s_axi_awready, // taken in this cycle
  (* X_INTERFACE_INFO = "xilinx.com:interface:aximm:1.0 s_axi AWADDR" *)
  input  wire [6:0]   s_axi_awaddr,  // register address: sepax_tree_registers.md
  (* X_INTERFACE_INFO = "xilinx.com:interface:aximm:1.0 s_axi WVALID" *)
  input  wire         s_axi_wvalid,  // data to write
  (* X_INTERFACE_INFO = "xilinx.com:interface:aximm:1.0 s_axi WREADY" *)
  output wire         s_axi_wready,  // taken in this cycle
  (* X_INTERFACE_INFO = "xilinx.com:interface:aximm:1.0 s_axi WDATA" *)
  input  wire [31:0]  s_axi_wdata,   // the data
  (* X_INTERFACE_INFO = "xilinx.com:interface:aximm:1.0 s_axi WSTRB" *)
  input  wire [3:0]   s_axi_wstrb,   // byte strobes, all 1
  (* X_INTERFACE_INFO = "xilinx.com:interface:aximm:1.0 s_axi BVALID" *)
  output wire         s_axi_bvalid,  // response to a write
  (* X_INTERFACE_INFO = "xilinx.com:interface:aximm:1.0 s_axi BREADY" *)
  input  wire         s_axi_bready,  // taken in this cycle
  (* X_INTERFACE_INFO = "xilinx.com:interface:aximm:1.0 s_axi BRESP" *)
  output wire [1:0]   s_axi_bresp,   // 0: OKAY, 2: SLVERR
  (* X_INTERFACE_INFO = "xilinx.com:interface:aximm:1.0 s_axi ARVALID" *)
  input  wire         s_axi_arvalid, // address to read
  (* X_INTERFACE_INFO = "xilinx.com:interface:aximm:1.0 s_axi ARREADY" *)
  output wire         s_axi_arready, // taken in this cycle
  (* X_INTERFACE_INFO = "xilinx.com:interface:aximm:1.0 s_axi ARADDR" *)
  input  wire [6:0]   s_axi_araddr,  // register address: sepax_tree_registers.md
  (* X_INTERFACE_INFO = "xilinx.com:interface:aximm:1.0 s_axi RVALID" *)
  output wire         s_axi_rvalid,  // data that were read
  (* X_INTERFACE_INFO = "xilinx.com:interface:aximm:1.0 s_axi RREADY" *)
  input  wire         s_axi_rready,  // taken in this cycle
  (* X_INTERFACE_INFO = "xilinx.com:interface:aximm:1.0 s_axi RDATA" *)
  output wire [31:0]  s_axi_rdata,   // the data
  (* X_INTERFACE_INFO = "xilinx.com:interface:aximm:1.0 s_axi RRESP" *)
  output wire [1:0]   s_axi_rresp,   // 0: OKAY, 2: SLVERR
  (* X_INTERFACE_INFO = "xilinx.com:interface:aximm:1.0 m_axi ARVALID" *)
  (* X_INTERFACE_PARAMETER = "PROTOCOL AXI4, READ_WRITE_MODE READ_ONLY" *)
  output wire         m_axi_arvalid, // AXI4, memory, read only, one ID
  (* X_INTERFACE_INFO = "xilinx.com:interface:aximm:1.0 m_axi ARREADY" *)
  input  wire         m_axi_arready, // taken in this cycle
  (* X_INTERFACE_INFO = "xilinx.com:interface:aximm:1.0 m_axi ARADDR" *)
  output wire [39:0]  m_axi_araddr,  // byte address, a multiple of 16
  (* X_INTERFACE_INFO = "xilinx.com:interface:aximm:1.0 m_axi ARLEN" *)
  output wire [7:0]   m_axi_arlen,   // beats less 1, 0 ... 15; never across 4 KB
  (* X_INTERFACE_INFO = "xilinx.com:interface:aximm:1.0 m_axi ARSIZE" *)
  output wire [2:0]   m_axi_arsize,  // 16 bytes a beat: 4
  (* X_INTERFACE_INFO = "xilinx.com:interface:aximm:1.0 m_axi ARBURST" *)
  output wire [1:0]   m_axi_arburst, // INCR: 1
  (* X_INTERFACE_INFO = "xilinx.com:interface:aximm:1.0 m_axi RVALID" *)
  input  wire         m_axi_rvalid,  // a beat
  (* X_INTERFACE_INFO = "xilinx.com:interface:aximm:1.0 m_axi RREADY" *)
  output wire         m_axi_rready,  // taken in this cycle
  (* X_INTERFACE_INFO = "xilinx.com:interface:aximm:1.0 m_axi RDATA" *)
  input  wire [127:0] m_axi_rdata,   // the data
  (* X_INTERFACE_INFO = "xilinx.com:interface:aximm:1.0 m_axi RRESP" *)
  input  wire [1:0]   m_axi_rresp,   // 0: OKAY; otherwise an error
  (* X_INTERFACE_INFO = "xilinx.com:interface:aximm:1.0 m_axi RLAST" *)
  input  wire         m_axi_rlast,   // the last beat of its burst
  (* X_INTERFACE_INFO = "xilinx.com:interface:axis:1.0 m_axis TVALID" *)
  output wire         m_axis_tvalid, // AXI4-Stream, results: a pair, or the end of a pose
  (* X_INTERFACE_INFO = "xilinx.com:interface:axis:1.0 m_axis TREADY" *)
  input  wire         m_axis_tready, // taken in this cycle
  (* X_INTERFACE_INFO = "xilinx.com:interface:axis:1.0 m_axis TDATA" *)
  output wire [63:0]  m_axis_tdata,  // docs/reference/tree-engine.md, Results
  (* X_INTERFACE_INFO = "xilinx.com:interface:axis:1.0 m_axis TLAST" *)
  output wire         m_axis_tlast,  // end of a pose
  (* X_INTERFACE_INFO = "xilinx.com:signal:interrupt:1.0 irq INTERRUPT" *)
  (* X_INTERFACE_PARAMETER = "SENSITIVITY LEVEL_HIGH" *)
  output wire         irq            // interrupt, level: a bit is set in PENDING and ENABLE
);
  localparam W = @word@;       // bits of a coordinate
  localparam ADDRESS = 40; // bits of a byte address
  wire rst = !aresetn;

  assign m_axi_arsize = 3'd4;
  assign m_axi_arburst = 2'b01;

  // Registers and counts of the batch.
  wire start, stop, busy, done, send, send_room, send_busy, sent, last, hit;
  wire [32:0] list;
  wire [31:0] jobs, job, pose, poses_done, hits, hit_job, hit_pose, batch_cycles;
  wire [5:0]  status, all_status;

  sepax_registers registers (
    .clk(aclk), .rst(rst), .awvalid(s_axi_awvalid), .awready(s_axi_awready), .awaddr(s_axi_awaddr),
    .wvalid(s_axi_wvalid), .wready(s_axi_wready), .wdata(s_axi_wdata), .wstrb(s_axi_wstrb),
    .bvalid(s_axi_bvalid), .bready(s_axi_bready), .bresp(s_axi_bresp), .arvalid(s_axi_arvalid),
    .arready(s_axi_arready), .araddr(s_axi_araddr), .rvalid(s_axi_rvalid), .rready(s_axi_rready),
    .rdata(s_axi_rdata), .rresp(s_axi_rresp), .irq(irq), .start(start), .stop(stop), .list(list),
    .jobs(jobs), .status({25'd0, all_status, busy}), .job(job), .pose(pose), .poses(poses_done),
    .hits(hits), .hit_job(hit_job), .hit_pose(hit_pose), .cycles(batch_cycles), .done(done),
    .hit(hit), .ended(send)
  );

  sepax_tree_counts counts (
    .clk(aclk), .rst(rst), .start(start), .busy(busy), .ended(send), .status(status), .job(job),
    .pose(pose), .all(all_status), .poses(poses_done), .hits(hits), .hit_job(hit_job),
    .hit_pose(hit_pose), .cycles(batch_cycles)
  );

  // Job and pose.
  wire ask, fetch_busy, fetch_error, read, clear, load, bad_job, begin_poses, drop_poses;
  wire more_poses, pose_valid, take_pose, pose_failed, bad_pose, pose_fill;
  wire run_idle, run_start, run_stop, run_cold, run_probe, run_done, any, stopped, damaged;
  wire run_error, row, host_valid, host_ready, host_fill, host_last, host_error;
  wire [ADDRESS-8:0]  ask_job;
  wire [ADDRESS-5:0]  host_address;
  wire [3:0]          host_beats, host_beat, take_slot, fill_slot;
  wire [2:0]          read_beat, beat;
  wire [127:0]        read_data, host_data;
  wire [ADDRESS-13:0] base_a, base_b;
  wire [23:0]         nodes_a, nodes_b;
  wire [31:0]         triangles_a, beats_a, beats_b, count, budget;
  wire [24:0]         triangles_b;
  wire [ADDRESS-9:0]  poses;
  wire [6:0]          modes;
  wire [26:0]         job_row_a, job_row_b, row_a, row_b, first_row_a, first_row_b;
  wire [197:0]        matrix_m, matrix_k;
  wire [131:0]        shift_t, shift_u;
  wire [71:0]         sigma_a, sigma_b;
  wire [31:0]         entries, steps, rows, pairs, near, collisions, out_of_range, warnings;
  wire [31:0]         cycles, first_a;
  wire [23:0]         first_b;

  sepax_tree_jobs #(.ADDRESS(ADDRESS)) control (
    .clk(aclk), .rst(rst), .start(start), .stop(stop), .list(list), .jobs(jobs), .busy(busy),
    .done(done), .job(job), .pose(pose), .ask(ask), .ask_job(ask_job), .fetch_busy(fetch_busy),
    .fetch_error(fetch_error), .read(read), .read_beat(read_beat), .clear(clear), .load(load),
    .beat(beat), .bad_job(bad_job), .begin_poses(begin_poses), .drop_poses(drop_poses),
    .more_poses(more_poses), .pose_valid(pose_valid), .take_pose(take_pose),
    .pose_failed(pose_failed), .bad_pose(bad_pose), .modes({modes[6:2], modes[0]}),
    .job_row_a(job_row_a), .job_row_b(job_row_b), .run_idle(run_idle), .run_start(run_start),
    .run_stop(run_stop), .run_cold(run_cold), .run_probe(run_probe), .row(row), .row_a(row_a),
    .row_b(row_b), .run_done(run_done), .any(any), .undecided(|out_of_range),
    .stopped(stopped), .damaged(damaged), .run_error(run_error), .first_row_a(first_row_a),
    .first_row_b(first_row_b), .send(send), .status(status), .last(last),
    .send_room(send_room), .send_busy(send_busy)
  );

  sepax_tree_job #(.ADDRESS(ADDRESS)) of_job (
    .clk(aclk), .clear(clear), .load(load), .beat(beat), .data(read_data), .bad(bad_job),
    .base_a(base_a), .nodes_a(nodes_a), .triangles_a(triangles_a), .beats_a(beats_a),
    .base_b(base_b), .nodes_b(nodes_b), .triangles_b(triangles_b), .beats_b(beats_b),
    .poses(poses), .count(count), .modes(modes), .budget(budget), .row_a(job_row_a),
    .row_b(job_row_b)
  );

  sepax_tree_fetch #(.ADDRESS(ADDRESS), .SLOTS(4)) fetch (
    .clk(aclk), .rst(rst), .ask(ask), .job(ask_job), .busy(fetch_busy), .error(fetch_error),
    .read(read), .read_beat(read_beat), .read_data(read_data), .begins(begin_poses),
    .poses(poses), .count(count), .drop(drop_poses), .more(more_poses), .valid(pose_valid),
    .take(take_pose), .take_slot(take_slot), .fill(pose_fill), .fill_slot(fill_slot),
    .burst(host_valid), .burst_ready(host_ready), .burst_address(host_address),
    .burst_beats(host_beats), .came(host_fill), .came_data(host_data), .came_beat(host_beat[2:0]),
    .came_last(host_last), .came_error(host_error)
  );

  sepax_tree_pose #(.SLOTS(4)) of_pose (
    .clk(aclk), .write(pose_fill), .write_slot(fill_slot), .beat(host_beat), .data(host_data),
    .error(host_error), .read(take_pose), .read_slot(take_slot), .failed(pose_failed),
    .bad(bad_pose), .matrix_m(matrix_m), .matrix_k(matrix_k), .shift_t(shift_t),
    .shift_u(shift_u), .sigma_a(sigma_a), .sigma_b(sigma_b)
  );

  // The engine and the cores.
  wire pair_valid, pair_ready, pair_outside, in_flight, verdict_valid, verdict_ready;
  wire verdict_outside, collision, coplanar, warning, result_valid, result_ready;
  wire result_coplanar, result_outside, result_warning;
  wire [9*W-1:0] pair_a, pair_b;
  wire [31:0]    result_a;
  wire [23:0]    result_b;

  sepax_tree_engine #(
    .W(W), .MARGIN(@margin@), .FLIGHT(@flight_log2@), .LEAF_SETS(@leaf_sets@), .ROWS(@rows@),
    .ADDRESS(ADDRESS)
  ) engine (
    .clk(aclk), .rst(rst), .start(run_start), .stop(run_stop), .cold(run_cold),
    .probe(run_probe), .idle(run_idle), .done(run_done), .hit(hit), .first(modes[0]),
    .quiet(modes[1]), .clear_counts(sent || start),
    .budget((|budget) ? budget : 32'hffffffff), .base_a(base_a), .nodes_a(nodes_a), //@ !fpga
    .budget(budget), .base_a(base_a), .nodes_a(nodes_a), //@ fpga
    .triangles_a(triangles_a), .beats_a(beats_a), .base_b(base_b), .nodes_b(nodes_b),
    .triangles_b(triangles_b), .beats_b(beats_b), .matrix_m(matrix_m), .matrix_k(matrix_k),
    .shift_t(shift_t), .shift_u(shift_u), .sigma_a(sigma_a), .sigma_b(sigma_b), .row(row),
    .row_leaf_a(row_a[22:0]), .row_leaf_b(row_b[22:0]), .row_a(row_a[26:23]),
    .row_b(row_b[26:23]), .pair_valid(pair_valid), .pair_ready(pair_ready), .pair_a(pair_a),
    .pair_b(pair_b), .pair_outside(pair_outside), .verdict_valid(verdict_valid),
    .verdict_ready(verdict_ready), .collision(collision), .coplanar(coplanar), .warning(warning),
    .verdict_outside(verdict_outside), .in_flight(in_flight), .result_valid(result_valid),
    .result_ready(result_ready), .result_a(result_a), .result_b(result_b),
    .result_coplanar(result_coplanar), .result_outside(result_outside),
    .result_warning(result_warning), .any(any), .stopped(stopped), .damaged(damaged),
    .error(run_error), .entries(entries), .steps(steps), .rows(rows), .pairs(pairs), .near(near),
    .collisions(collisions), .out_of_range(out_of_range), .warnings(warnings), .cycles(cycles),
    .first_a(first_a), .first_b(first_b), .first_leaf_a(first_row_a[22:0]),
    .first_leaf_b(first_row_b[22:0]), .first_row_a(first_row_a[26:23]),
    .first_row_b(first_row_b[26:23]), .host_valid(host_valid), .host_ready(host_ready),
    .host_address(host_address), .host_beats(host_beats), .host_fill(host_fill),
    .host_data(host_data), .host_beat(host_beat), .host_last(host_last),
    .host_error(host_error), .arvalid(m_axi_arvalid), .arready(m_axi_arready),
    .araddr(m_axi_araddr), .arlen(m_axi_arlen), .rvalid(m_axi_rvalid), .rready(m_axi_rready),
    .rdata(m_axi_rdata), .rresp(m_axi_rresp), .rlast(m_axi_rlast)
  );

  assign warning = 1'b0; //@ !limits
  sepax_cores cores (
    .clk(aclk), .rst(rst), .pair_valid(pair_valid), .pair_ready(pair_ready), .pair_a(pair_a),
    .pair_b(pair_b), .pair_info(pair_outside), .in_flight(in_flight),
    .warning(warning), //@ limits
    .collision(collision), .coplanar(coplanar), .verdict_valid(verdict_valid),
    .verdict_ready(verdict_ready), .verdict_info(verdict_outside)
  );

  sepax_tree_results results (
    .clk(aclk), .rst(rst), .valid(result_valid), .ready(result_ready), .a(result_a), .b(result_b),
    .coplanar(result_coplanar), .outside(result_outside), .warning(result_warning),
    .send(send), .status({last, status}), .room(send_room), .sent(sent), .busy(send_busy),
    .job(job), .pose(pose), .steps(steps), .cycles(cycles), .near(near),
    .collisions(collisions), .warnings(warnings), .out_of_range(out_of_range), .pairs(pairs),
    .rows(rows), .entries(entries), .first_a(first_a), .first_b(first_b),
    .first_row_a(first_row_a), .first_row_b(first_row_b), .tvalid(m_axis_tvalid),
    .tready(m_axis_tready), .tdata(m_axis_tdata), .tlast(m_axis_tlast)
  );
endmodule
