// SPDX-License-Identifier: MIT
// The counts of a batch that the registers show.
module sepax_tree_counts (
  input  wire        clk,      // clock
  input  wire        rst,      // synchronous reset, active high
  input  wire        start,    // a batch begins
  input  wire        busy,     // a batch is running
  input  wire        ended,    // a pose has ended, with this status, job and pose
  input  wire [5:0]  status,   // status bits 5:0 of the pose
  input  wire [31:0] job,      // number of its job
  input  wire [31:0] pose,     // number of the pose
  output reg  [5:0]  all,      // OR of the status bits of all poses
  output reg  [31:0] poses,    // poses that have ended
  output reg  [31:0] hits,     // poses with a collision
  output reg  [31:0] hit_job,  // number of the job of the first collision
  output reg  [31:0] hit_pose, // number of the pose of the first collision
  output reg  [31:0] cycles    // clock cycles of the batch, modulo 2^32
);
  always @(posedge clk) begin
    if (rst || start) begin
      all <= 6'd0;
      {poses, hits, cycles} <= 96'd0;
    end else begin
      cycles <= cycles + {31'd0, busy};
      if (ended) begin
        all <= all | status;
        poses <= poses + 32'd1;
        hits <= hits + {31'd0, status[0]};
      end
    end
    if (ended && status[0] && !all[0]) begin
      hit_job <= job;
      hit_pose <= pose;
    end
  end
endmodule
