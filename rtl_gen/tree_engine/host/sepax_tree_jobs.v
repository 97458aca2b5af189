// SPDX-License-Identifier: MIT
// Works through a list of jobs, pose by pose (docs/reference/tree-engine.md, Jobs): reads a job and
// its poses, starts a run for each pose, reads the next pose or job during the run, and sends the
// end of each pose.
module sepax_tree_jobs #(
  parameter ADDRESS = 40 // bits of a byte address
) (
  input  wire               clk,         // clock
  input  wire               rst,         // synchronous reset, active high
  input  wire               start,       // a batch begins; only while not busy
  input  wire               stop,        // end the batch with the pose that is being walked
  input  wire [ADDRESS-8:0] list,        // address of the first job / 128
  input  wire [31:0]        jobs,        // number of jobs, 1 or more
  output wire               busy,        // a batch is running
  output wire               done,        // the batch ends in this cycle
  output reg  [31:0]        job,         // number of the job
  output reg  [31:0]        pose,        // number of the pose
  // fetch of jobs and poses
  output wire               ask,         // ask for a burst
  output wire [ADDRESS-1:0] ask_address, // address of the burst
  output wire [3:0]         ask_beats,   // beats of the burst less 1
  input  wire               fetch_busy,  // the burst has not come completely
  input  wire               fetch_error, // a beat of the burst came with an error
  output wire               read,        // read a beat of the burst
  output reg  [3:0]         read_beat,   // number of the beat
  output wire               clear,       // a job or a pose is about to be loaded
  output reg                load_job,    // a beat of a job is here
  output reg                load_pose,   // a beat of a pose is here
  output reg  [3:0]         beat,        // number of the beat that is loaded
  input  wire               bad_job,     // a number of the job is out of its range
  input  wire               bad_pose,    // a number of the pose is out of its range
  // of the job
  input  wire [ADDRESS-9:0] poses,       // address of the first pose / 256
  input  wire [31:0]        count,       // number of poses
  input  wire [5:0]         modes,       // modes of the job: {LEAVE, WARM, COLD, AGAIN, ROW, FIRST}
  input  wire [26:0]        job_row_a,   // first row of the job: {a, leaf A}
  input  wire [26:0]        job_row_b,   // first row of the job: {b, leaf B}
  // runs of the engine
  input  wire               run_idle,    // a run may begin
  output reg                run_start,   // a run begins
  output wire               run_stop,    // end the run
  output wire               run_cold,    // with run_start: empty the caches
  output reg                row,         // the run has a first row
  output reg  [26:0]        row_a,       // first row of the run: {a, leaf A}
  output reg  [26:0]        row_b,       // first row of the run: {b, leaf B}
  input  wire               run_done,    // the run has ended
  input  wire               any,         // the run has found a collision
  input  wire               undecided,   // some collisions are out of range
  input  wire               stopped,     // FIRST, BUDGET or STOP ended the run
  input  wire               damaged,     // a tree is damaged, or the stack is full
  input  wire               run_error,   // memory answered with an error
  input  wire [26:0]        first_row_a, // first collision of the run: {a, leaf A}
  input  wire [26:0]        first_row_b, // first collision of the run: {b, leaf B}
  // end of a run
  output wire               send,        // send the end of the pose
  output wire [5:0]         status,      // {REFUSED, BUS, DAMAGED, STOPPED, OUT_OF_RANGE, HIT}
  output wire               last,        // the batch ends with this pose
  input  wire               send_busy    // the end of the pose before has not gone
);
  localparam [3:0] IDLE = 4'd0;  // no batch
  localparam [3:0] ASK = 4'd1;   // ask for a job or a pose
  localparam [3:0] WAIT = 4'd2;  // wait until it has come
  localparam [3:0] LOAD = 4'd3;  // load it into its registers
  localparam [3:0] JUDGE = 4'd4; // wait for the result of its range check
  localparam [3:0] START = 4'd5; // start the engine, and ask for the next burst
  localparam [3:0] RUN = 4'd6;   // wait until the engine has ended
  localparam [3:0] FAIL = 4'd7;  // send the end of a job or pose that is not run
  localparam [3:0] END = 4'd8;   // end the batch
  localparam [3:0] JOB_LAST = 4'd5;  // number of the last beat of a job
  localparam [3:0] POSE_LAST = 4'd8; // number of the last beat of a pose
  reg  [3:0]         state_q;
  reg                of_job_q;     // a job is read, not a pose
  reg                ahead_q;      // the next burst was asked for while the engine ran
  reg                ahead_job_q;  // that burst is a job
  reg                first_job_q, first_pose_q; // the next one is first of the batch, of its job
  reg                bus_q, refused_q, stop_q;
  reg  [1:0]         loaded_q;     // bit k: the last beat was read k + 1 cycles ago //@ !fpga
  reg  [3:0]         loaded_q;     // bit k: the last beat was read k + 1 cycles ago //@ fpga
  reg                busy_q;       // a batch is running //@ fpga
  reg  [31:0]        jobs_left_q, poses_left_q; // jobs and poses after the current one
  reg  [ADDRESS-8:0] job_q;        // address / 128 of the next job
  reg  [ADDRESS-9:0] pose_q;       // address / 256 of the next pose
  //@ if fpga
  reg                more_jobs, more_poses; // a cycle late
  reg                judged_q;     // a job or a pose was judged in the cycle before
  reg                asks_q;       // the burst that ASK asks for is known
  reg  [1:0]         ready_q;      // the burst that START asks for is known
  wire               begins = ready_q[1] && run_idle && !fetch_busy;
  //@ else
  wire               more_jobs = |jobs_left_q;
  wire               more_poses = |poses_left_q;
  wire               begins = (state_q == START) && run_idle && !fetch_busy;
  //@ end
  wire               judged = (state_q == JUDGE) && !send_busy;
  wire               ask_now = (state_q == ASK) && !fetch_busy; //@ !fpga
  wire               ask_now = asks_q && !fetch_busy; //@ fpga
  wire               ask_job = ask_now ? of_job_q : !more_poses;
  wire               good = !damaged && !run_error;
  wire               leaves = !more_poses || (modes[5] && any);
  wire               ends = (state_q == RUN) && run_done;

  assign busy = |state_q; //@ !fpga
  assign busy = busy_q; //@ fpga
  assign done = (state_q == END) && run_idle && !fetch_busy && !send_busy;
  assign ask = ask_now || (begins && (more_poses || more_jobs));
  assign ask_address = ask_job ? {job_q, 7'd0} : {pose_q, 8'd0};
  assign ask_beats = ask_job ? JOB_LAST : POSE_LAST;
  assign read = (state_q == LOAD);
  assign clear = (state_q == WAIT);
  assign run_stop = stop_q && (state_q == RUN);
  assign run_cold = modes[3] || (first_pose_q && !modes[4]);
  assign send = ends || (state_q == FAIL);
  assign last = (state_q == FAIL) || !good || stop_q || (leaves && !more_jobs);
  assign status = (state_q == FAIL) ? {refused_q, bus_q, 4'd0} :
                  {1'b0, run_error, damaged && !run_error, good && stopped && !(any && modes[0]),
                   good && any && undecided, good && any};

  always @(posedge clk) begin
    if (rst) begin
      state_q <= IDLE;
      {run_start, load_job, load_pose, stop_q} <= 4'd0;
      {busy_q, judged_q, asks_q, ready_q} <= 5'd0; //@ fpga
    end else begin
      case (state_q)
        IDLE: state_q <= start ? ASK : IDLE;
        ASK: state_q <= fetch_busy ? ASK : WAIT; //@ !fpga
        ASK: state_q <= ask_now ? WAIT : ASK; //@ fpga
        WAIT: state_q <= fetch_busy ? WAIT : fetch_error ? JUDGE : LOAD;
        LOAD: state_q <= loaded_q[1] ? JUDGE : LOAD; //@ !fpga
        LOAD: state_q <= loaded_q[3] ? JUDGE : LOAD; //@ fpga
        JUDGE: state_q <= send_busy ? JUDGE : (bus_q || refused_q) ? FAIL : of_job_q ? ASK : START;
        START: state_q <= begins ? RUN : START;
        RUN: begin
          if (run_done) begin
            state_q <= last ? END :
                       (ahead_q && (ahead_job_q == leaves)) ? WAIT : ASK;
          end
        end
        FAIL: state_q <= END;
        default: state_q <= done ? IDLE : END;
      endcase
      busy_q <= busy_q ? !done : start; //@ fpga
      //@ if fpga
      judged_q <= judged;
      asks_q <= (state_q == ASK) && !ask_now;
      ready_q <= {ready_q[0], state_q == START} & {2{!begins}};
      //@ end
      run_start <= begins;
      load_job <= read && of_job_q && !(|loaded_q);
      load_pose <= read && !of_job_q && !(|loaded_q);
      stop_q <= busy && (stop_q || stop);
    end
    beat <= read_beat;
    if (state_q == WAIT) begin
      read_beat <= 4'd0;
      loaded_q <= 2'd0; //@ !fpga
      loaded_q <= 4'd0; //@ fpga
    end else if (read) begin
      read_beat <= read_beat + 4'd1;
      loaded_q[3:2] <= loaded_q[2:1]; //@ fpga
      //@ if fpga
      loaded_q[1:0] <= {
        loaded_q[0], loaded_q[0] || (read_beat == (of_job_q ? JOB_LAST : POSE_LAST))
      };
      //@ else
      loaded_q <= {loaded_q[0], loaded_q[0] || (read_beat == (of_job_q ? JOB_LAST : POSE_LAST))};
      //@ end
    end
    if (state_q == WAIT) begin
      bus_q <= fetch_error;
    end
    refused_q <= !bus_q && (of_job_q ? bad_job : bad_pose);
    {more_jobs, more_poses} <= {|jobs_left_q, |poses_left_q}; //@ fpga
    if (start) begin
      {of_job_q, first_job_q} <= 2'b11;
      jobs_left_q <= jobs;
      job_q <= list;
    end else if (judged) begin //@ !fpga
    end else if (judged_q) begin //@ fpga
      of_job_q <= 1'b0;
      if (of_job_q) begin
        job <= first_job_q ? 32'd0 : job + 32'd1;
        pose <= 32'd0;
        {first_job_q, first_pose_q} <= 2'b01;
        jobs_left_q <= jobs_left_q - 32'd1;
        job_q <= job_q + {{(ADDRESS-8){1'b0}}, 1'b1};
        poses_left_q <= count;
        pose_q <= poses;
        {row, row_a, row_b} <= {modes[1], job_row_a, job_row_b};
      end else begin
        pose <= first_pose_q ? 32'd0 : pose + 32'd1;
        poses_left_q <= poses_left_q - 32'd1;
        pose_q <= pose_q + {{(ADDRESS-9){1'b0}}, 1'b1};
      end
    end else if (begins) begin
      {ahead_q, ahead_job_q} <= {more_poses || more_jobs, !more_poses};
    end else if (ends) begin
      {first_pose_q, of_job_q} <= {1'b0, leaves};
      if (any && modes[2]) begin
        {row, row_a, row_b} <= {1'b1, first_row_a, first_row_b};
      end
    end
  end
endmodule
