// What a batch has come to, as registers show it.
module sepax_tree_counts (
  input  wire        clk,      // clock
  input  wire        rst,      // synchronous reset, active high
  input  wire        start,    // a batch begins
  input  wire        busy,     // a batch is worked on
  input  wire        ended,    // a pose has ended: of what follows
  input  wire [5:0]  status,   // its status; bit 0: a pair collides
  input  wire [31:0] job,      // number of its job
  input  wire [31:0] pose,     // its number
  output reg  [5:0]  all,      // every bit of the status that was set
  output reg  [31:0] poses,    // poses that have ended
  output reg  [31:0] hits,     // of these, poses with a collision
  output reg  [31:0] hit_job,  // the first of them: number of its job
  output reg  [31:0] hit_pose, // its number
  output reg  [31:0] cycles    // clock cycles of the batch
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
