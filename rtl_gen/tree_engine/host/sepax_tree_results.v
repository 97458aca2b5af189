// SPDX-License-Identifier: MIT
// Sends the pairs of a run and the end of its pose over AXI4-Stream, 64 bits
// (docs/reference/tree-engine.md, Results). The end is taken in eight cycles, a transfer a cycle,
// into a queue that has room for it. So the next run may begin before the end has gone.
module sepax_tree_results (
  input  wire        clk,          // clock
  input  wire        rst,          // synchronous reset, active high
  input  wire        valid,        // a pair of the run
  output wire        ready,        // it is taken in this cycle
  input  wire [31:0] a,            // number of A's triangle in its tree
  input  wire [23:0] b,            // number of B's triangle in its tree
  input  wire        coplanar,     // the triangles are coplanar
  input  wire        outside,      // a coordinate of B does not fit W bits
  input  wire        warning,      // the pair is in the warning band
  input  wire        send,         // the run has ended: take the end of the pose; only with room
  input  wire [6:0]  status,       // with send: status bits 6:0
  output wire        room,         // the end of a pose may be sent
  output wire        sent,         // the last numbers of the end are taken in this cycle
  output wire        busy,         // something has not gone
  // Numbers of the run: taken with send, in this order, and one a cycle after it.
  input  wire [31:0] steps,        // 0: STEPS
  input  wire [31:0] job,          // 1: number of the job
  input  wire [31:0] pose,         // 1: number of the pose
  input  wire [31:0] cycles,       // 2: cycles of the run
  input  wire [31:0] near,         // 2: NEAR
  input  wire [31:0] collisions,   // 3: COLLISIONS
  input  wire [31:0] warnings,     // 3: near pairs in the warning band
  input  wire [31:0] out_of_range, // 4: collisions that are out of range
  input  wire [31:0] pairs,        // 4: PAIRS
  input  wire [31:0] rows,         // 5: ROWS
  input  wire [31:0] entries,      // 5: ENTRIES
  input  wire [31:0] first_a,      // 6: FIRST: A's triangle
  input  wire [23:0] first_b,      // 6: FIRST: B's triangle
  input  wire [26:0] first_row_a,  // 7: FIRST: {a, leaf A}
  input  wire [26:0] first_row_b,  // 7: FIRST: {b, leaf B}
  output reg         tvalid,       // a transfer
  input  wire        tready,       // it is taken in this cycle
  output reg  [63:0] tdata,        // its data
  output reg         tlast         // the last transfer of a pose
);
  localparam [4:0] HALF = 5'd8;
  reg         ending_q; // an end is being taken
  reg         hit_q;    // of this end: HIT
  reg         ran_q;    // neither BUS nor REFUSED: the counters are valid
  reg  [2:0]  number_q; // number of the next transfer of the end
  reg  [4:0]  count_q;  // transfers in the queue, 0 ... 16
  reg  [63:0] shown;
  wire        taken = valid && ready;
  wire        push = taken || send || ending_q;
  wire        last = ending_q && (&number_q);
  wire        waiting, waiting_last;
  wire [63:0] waiting_data;
  wire        free = !tvalid || tready;
  wire        pop = waiting && free;
  wire        ran = !(|status[5:4]);
  //@ if fpga
  reg         push_q, last_q;
  reg  [63:0] shown_q;
  //@ end

  // A pair is taken while the queue is half empty, so an end always finds room for its eight.
  assign ready = (count_q < HALF) && !ending_q;
  assign room = (count_q <= HALF) && !ending_q;
  assign sent = last;
  assign busy = (|count_q) || ending_q || tvalid;

  sepax_ram_fifo #(.WIDTH(65), .ADDRESS(4)) queue (
    .clk(clk), .clear(rst), .push(push), .in({last, shown}), //@ !fpga
    .clk(clk), .clear(rst), .push(push_q), .in({last_q, shown_q}), //@ fpga
    .valid(waiting), .pop(pop), .out({waiting_last, waiting_data})
  );

  always @(*) begin
    case (number_q)
      3'd1: shown = {pose, job};
      3'd2: shown = {near, cycles} & {64{ran_q}};
      3'd3: shown = {warnings, collisions} & {64{ran_q}};
      3'd4: shown = {pairs, out_of_range} & {64{ran_q}};
      3'd5: shown = {entries, rows} & {64{ran_q}};
      3'd6: shown = {8'd0, first_b, first_a} & {64{hit_q}};
      3'd7: shown = {5'd0, first_row_b, 5'd0, first_row_a} & {64{hit_q}};
      default: shown = send ? {1'b1, 24'd0, status, steps & {32{ran}}}
                            : {5'd0, warning, outside, coplanar, b, a};
    endcase
  end

  always @(posedge clk) begin
    if (rst) begin
      {ending_q, number_q, count_q, tvalid} <= 10'd0;
      push_q <= 1'b0; //@ fpga
    end else begin
      ending_q <= send || (ending_q && !last);
      number_q <= number_q + {2'd0, send || ending_q};
      count_q <= count_q + {4'd0, push} - {4'd0, pop};
      tvalid <= waiting || !free;
      push_q <= push; //@ fpga
    end
    {last_q, shown_q} <= {last, shown}; //@ fpga
    if (send) begin
      {hit_q, ran_q} <= {status[0], ran};
    end
    if (free) begin
      {tlast, tdata} <= {waiting_last, waiting_data};
    end
  end
endmodule
