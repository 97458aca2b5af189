// SPDX-License-Identifier: MIT
// Works through a list of jobs, pose by pose (docs/reference/tree-engine.md, Jobs): has a job and
// its poses read, starts a run for each pose, and sends the end of each pose. Poses are read ahead,
// and the next job while the last pose of a job runs.
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
  // jobs and poses that are read
  output wire               ask,         // read a job
  output wire [ADDRESS-8:0] ask_job,     // its address / 128
  input  wire               fetch_busy,  // it has not come whole, or dropped poses may come
  input  wire               fetch_error, // a beat of the job came with an error
  output wire               read,        // read a beat of the job
  output reg  [2:0]         read_beat,   // number of the beat
  output wire               clear,       // a job is about to be loaded
  output reg                load,        // a beat of the job is here
  output reg  [2:0]         beat,        // number of the beat
  input  wire               bad_job,     // a number of the job is out of its range
  output wire               begin_poses, // the job is good: read its poses
  output wire               drop_poses,  // the rest of them is not wanted
  input  wire               more_poses,  // poses of the job are not taken; two cycles later
  input  wire               pose_valid,  // the next pose is here
  output wire               take_pose,   // it is taken in this cycle
  input  wire               pose_failed, // it came with an error; from the next cycle on
  input  wire               bad_pose,    // a number of it is out of its range; likewise
  // of the job
  input  wire [5:0]         modes,       // modes of the job: {LEAVE, WARM, COLD, AGAIN, ROW, FIRST}
  input  wire [26:0]        job_row_a,   // first row of the job: {a, leaf A}
  input  wire [26:0]        job_row_b,   // first row of the job: {b, leaf B}
  // runs of the engine
  input  wire               run_idle,    // a run may begin
  output reg                run_start,   // a run begins
  output wire               run_stop,    // end the run
  output wire               run_cold,    // with run_start: empty the caches
  output wire               run_probe,   // with run_start: the first run of the job
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
  output wire               send,        // send the end of the pose; only with room
  output wire [5:0]         status,      // {REFUSED, BUS, DAMAGED, STOPPED, OUT_OF_RANGE, HIT}
  output wire               last,        // the batch ends with this pose
  input  wire               send_room,   // the end may be sent
  input  wire               send_busy    // an end has not gone
);
  localparam [3:0] IDLE = 4'd0;  // no batch
  localparam [3:0] ASK = 4'd1;   // ask for a job
  localparam [3:0] WAIT = 4'd2;  // wait until it has come
  localparam [3:0] LOAD = 4'd3;  // load it into its registers
  localparam [3:0] JUDGE = 4'd4; // wait for the result of its range check
  localparam [3:0] POSE = 4'd5;  // wait for a pose
  localparam [3:0] START = 4'd6; // start the engine
  localparam [3:0] RUN = 4'd7;   // wait until the engine has ended
  localparam [3:0] HOLD = 4'd8;  // it has: wait until its end may be sent
  localparam [3:0] FAIL = 4'd9;  // send the end of a job or pose that is not run
  localparam [3:0] END = 4'd10;  // end the batch
  localparam [2:0] JOB_LAST = 3'd5; // number of the last beat of a job
  reg  [3:0]         state_q;
  reg                ahead_q;      // the next job was asked for while the engine ran
  reg                first_job_q, first_pose_q; // the next one is first of the batch, of its job
  reg                bus_q, refused_q, stop_q;
  reg  [1:0]         loaded_q;     // bit k: the last beat was read k + 1 cycles ago //@ !fpga
  reg  [3:0]         loaded_q;     // bit k: the last beat was read k + 1 cycles ago //@ fpga
  reg                busy_q;       // a batch is running //@ fpga
  reg  [31:0]        jobs_left_q;  // jobs after the current one
  reg  [ADDRESS-8:0] job_q;        // address / 128 of the next job
  reg                more_jobs;    // there were jobs left in the cycle before
  wire               loads = (state_q == LOAD);
  wire               judges = (state_q == JUDGE);
  wire               good_job = judges && !bus_q && !refused_q;
  wire               bad = pose_failed || bad_pose;
  wire               begins = (state_q == START) && run_idle && !bad;
  wire               fails = (state_q == START) && bad;
  wire               good = !damaged && !run_error;
  wire               leaves = !more_poses || (modes[5] && any);
  wire               ends = (((state_q == RUN) && run_done) || (state_q == HOLD)) && send_room;
  wire               failed = (state_q == FAIL) && send_room;
  wire               goes_on = ends && !last && !leaves; // to the next pose of the job
  // The next job is asked for while the last pose of a job runs.
  wire               ask_ahead = (state_q == RUN) && !more_poses && more_jobs && !ahead_q;

  assign busy = |state_q; //@ !fpga
  assign busy = busy_q; //@ fpga
  assign done = (state_q == END) && run_idle && !fetch_busy && !send_busy;
  assign ask = ((state_q == ASK) || ask_ahead) && !fetch_busy;
  assign ask_job = job_q;
  assign read = loads;
  assign clear = (state_q == WAIT);
  assign begin_poses = good_job;
  assign take_pose = ((state_q == POSE) || goes_on) && pose_valid;
  assign drop_poses = (ends && !goes_on) || failed;
  assign run_stop = stop_q && (state_q == RUN);
  assign run_cold = modes[3] || (first_pose_q && !modes[4]);
  assign run_probe = modes[3] || first_pose_q;
  assign send = ends || failed;
  assign last = (state_q == FAIL) || !good || stop_q || (leaves && !more_jobs);
  assign status = (state_q == FAIL) ? {refused_q, bus_q, 4'd0} :
                  {1'b0, run_error, damaged && !run_error, good && stopped && !(any && modes[0]),
                   good && any && undecided, good && any};

  always @(posedge clk) begin
    if (rst) begin
      state_q <= IDLE;
      {run_start, load, stop_q, ahead_q} <= 4'd0;
      busy_q <= 1'b0; //@ fpga
    end else begin
      case (state_q)
        IDLE: state_q <= start ? ASK : IDLE;
        ASK: state_q <= fetch_busy ? ASK : WAIT;
        WAIT: state_q <= fetch_busy ? WAIT : fetch_error ? JUDGE : LOAD;
        LOAD: state_q <= loaded_q[1] ? JUDGE : LOAD; //@ !fpga
        LOAD: state_q <= loaded_q[3] ? JUDGE : LOAD; //@ fpga
        JUDGE: state_q <= good_job ? POSE : FAIL;
        POSE: state_q <= pose_valid ? START : POSE;
        START: state_q <= fails ? FAIL : begins ? RUN : START;
        RUN, HOLD: begin
          if (ends) begin
            state_q <= last ? END : leaves ? (ahead_q ? WAIT : ASK) : pose_valid ? START : POSE;
          end else if (run_done) begin
            state_q <= HOLD;
          end
        end
        FAIL: state_q <= failed ? END : FAIL;
        default: state_q <= done ? IDLE : END;
      endcase
      busy_q <= busy_q ? !done : start; //@ fpga
      run_start <= begins;
      load <= loads && !(|loaded_q);
      stop_q <= busy && (stop_q || stop);
      ahead_q <= (ahead_q || (ask && ask_ahead)) && !loads && (state_q != IDLE);
    end
    beat <= read_beat;
    if (state_q == WAIT) begin
      read_beat <= 3'd0;
      loaded_q <= 2'd0; //@ !fpga
      loaded_q <= 4'd0; //@ fpga
    end else if (read) begin
      read_beat <= read_beat + 3'd1;
      loaded_q[3:2] <= loaded_q[2:1]; //@ fpga
      loaded_q[1:0] <= {loaded_q[0], loaded_q[0] || (read_beat == JOB_LAST)};
    end
    if (state_q == WAIT) begin
      {bus_q, refused_q} <= {fetch_error, 1'b0};
    end else if (loads) begin
      refused_q <= bad_job;
    end else if (fails) begin
      {bus_q, refused_q} <= {pose_failed, !pose_failed};
    end
    more_jobs <= |jobs_left_q;
    if (start) begin
      first_job_q <= 1'b1;
      jobs_left_q <= jobs;
      job_q <= list;
    end else if (judges) begin
      job <= first_job_q ? 32'd0 : job + 32'd1;
      pose <= 32'd0;
      {first_job_q, first_pose_q} <= 2'b01;
      jobs_left_q <= jobs_left_q - 32'd1;
      job_q <= job_q + {{(ADDRESS-8){1'b0}}, 1'b1};
      {row, row_a, row_b} <= {modes[1], job_row_a, job_row_b};
    end else if (begins || fails) begin
      pose <= first_pose_q ? 32'd0 : pose + 32'd1;
    end else if (ends) begin
      first_pose_q <= 1'b0;
      if (any && modes[2]) begin
        {row, row_a, row_b} <= {1'b1, first_row_a, first_row_b};
      end
    end
  end
endmodule
