// SPDX-License-Identifier: MIT
// Reads jobs and poses through the engine's AXI4 read port. The poses of a job are read ahead, up
// to 2^SLOTS of them, and sepax_tree_pose keeps them. A job is read when all poses of the job
// before have come or are dropped. Bursts are answered in order, so a beat belongs to the oldest of
// them.
module sepax_tree_fetch #(
  parameter ADDRESS = 40, // bits of a byte address
  parameter SLOTS = 4     // log2 of the poses that are read ahead
) (
  input  wire               clk,        // clock
  input  wire               rst,        // synchronous reset, active high
  // jobs
  input  wire               ask,        // read a job; only while not busy
  input  wire [ADDRESS-8:0] job,        // with ask: address of the job / 128
  output wire               busy,       // the job has not come whole, or dropped poses may come
  output reg                error,      // a beat of the job came with an error
  input  wire               read,       // read a beat of the job
  input  wire [2:0]         read_beat,  // number of the beat
  output wire [127:0]       read_data,  // the beat, from the next cycle on
  // poses
  input  wire               begins,     // the poses of another job; only while not busy
  input  wire [ADDRESS-9:0] poses,      // with begins: address of the first pose / 256
  input  wire [31:0]        count,      // with begins: number of poses
  input  wire               drop,       // the rest of the poses is not wanted
  output reg                more,       // poses of the job were not taken in the cycle before
  output wire               valid,      // the next pose is here
  input  wire               take,       // it is taken in this cycle
  output wire [SLOTS-1:0]   take_slot,  // its slot
  output wire               fill,       // a beat of a pose has come
  output wire [SLOTS-1:0]   fill_slot,  // slot of the pose
  // bursts
  output reg                burst,      // a burst is wanted; stands until it is taken
  input  wire               burst_ready, // it is taken in this cycle
  output wire [ADDRESS-5:0] burst_address, // place of its first beat, in units of 16 bytes
  output wire [3:0]         burst_beats, // its beats less 1
  input  wire               came,       // a beat of the oldest burst has come
  input  wire [127:0]       came_data,  // the beat
  input  wire [2:0]         came_beat,  // its number in the burst, modulo 8
  input  wire               came_last,  // the last beat of its burst
  input  wire               came_error  // it came with an error
);
  localparam [3:0] JOB_LAST = 4'd5;  // number of the last beat of a job
  localparam [3:0] POSE_LAST = 4'd8; // number of the last beat of a pose
  localparam [SLOTS-1:0] NEXT = 1;
  localparam [SLOTS:0] ONE = 1;
  reg                is_job_q;       // the burst that is wanted, or the oldest, is a job
  reg                dropping_q;     // poses that come are dropped
  reg  [31:0]        left_q;         // poses that were not asked for
  reg  [ADDRESS-9:0] pose_q;         // address of the next pose / 256
  reg  [ADDRESS-8:0] job_q;          // address of the job / 128
  reg  [SLOTS-1:0]   head_q, tail_q; // slot of the oldest pose, of the next pose that comes
  reg  [SLOTS:0]     used_q;         // poses that were asked for and not taken
  reg  [SLOTS:0]     here_q;         // poses that are here and not taken
  wire               some_left = |left_q; //@ !fpga
  reg                some_left;      // a cycle late, while `burst` //@ fpga
  wire               asks_pose = some_left && !burst && !used_q[SLOTS];
  wire               pose_came = came && came_last && !is_job_q;
  wire               dropped = dropping_q && (used_q == here_q);
  //@ if fpga
  reg  [1:0]         came_q;         // bit k: a pose came k + 1 cycles ago
  wire               pose_here = came_q[1];
  //@ else
  wire               pose_here = pose_came;
  //@ end

  assign busy = is_job_q || dropping_q;
  assign valid = (|here_q) && !dropping_q;
  assign take_slot = head_q;
  assign fill = came && !is_job_q;
  assign fill_slot = tail_q;
  assign burst_address = is_job_q ? {job_q, 3'd0} : {pose_q, 4'd0};
  assign burst_beats = is_job_q ? JOB_LAST : POSE_LAST;

  sepax_ram #(.WIDTH(128), .ADDRESS(3)) beats (
    .clk(clk), .write(came && is_job_q), .write_address(came_beat), .write_data(came_data),
    .read(read), .read_address(read_beat), .read_data(read_data)
  );

  always @(posedge clk) begin
    if (rst) begin
      {burst, is_job_q, dropping_q} <= 3'd0;
      left_q <= 32'd0;
      {head_q, tail_q} <= {(2*SLOTS){1'b0}};
      {used_q, here_q} <= {(2*SLOTS+2){1'b0}};
      more <= 1'b0;
      {some_left, came_q} <= 3'd0; //@ fpga
    end else begin
      burst <= ask || asks_pose || (burst && !burst_ready);
      is_job_q <= ask || (is_job_q && !(came && came_last));
      dropping_q <= drop || (dropping_q && !dropped);
      if (drop) begin
        left_q <= 32'd0;
      end else if (begins) begin
        left_q <= count;
      end else if (asks_pose) begin
        left_q <= left_q - 32'd1;
      end
      if (dropped) begin
        head_q <= tail_q;
        {used_q, here_q} <= {(2*SLOTS+2){1'b0}};
      end else begin
        head_q <= head_q + (take ? NEXT : {SLOTS{1'b0}});
        used_q <= used_q + (asks_pose ? ONE : {(SLOTS+1){1'b0}}) -
                  (take ? ONE : {(SLOTS+1){1'b0}});
        here_q <= here_q + (pose_here ? ONE : {(SLOTS+1){1'b0}}) -
                  (take ? ONE : {(SLOTS+1){1'b0}});
      end
      tail_q <= tail_q + (pose_came ? NEXT : {SLOTS{1'b0}});
      //@ if fpga
      came_q <= {came_q[0], pose_came};
      some_left <= (|left_q) && !drop;
      //@ end
      more <= (|left_q) || (|used_q);
    end
    if (ask) begin
      job_q <= job;
      error <= 1'b0;
    end else if (came && is_job_q) begin
      error <= error || came_error;
    end
    if (begins) begin
      pose_q <= poses;
    end else if (burst && burst_ready && !is_job_q) begin
      pose_q <= pose_q + {{(ADDRESS-9){1'b0}}, 1'b1};
    end
  end
endmodule
