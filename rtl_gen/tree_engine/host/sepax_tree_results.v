// SPDX-License-Identifier: MIT
// Sends the pairs of a run and the end of its pose over AXI4-Stream, 64 bits
// (docs/reference/tree-engine.md, Results).
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
  input  wire        send,         // the run has ended: send the end of the pose
  input  wire [6:0]  status,       // with send: status bits 6:0
  output wire        busy,         // its end has not gone; what follows stands meanwhile //@ !fpga
  output reg         busy,         // its end has not gone; what follows stands meanwhile //@ fpga
  input  wire [31:0] job,          // number of the job
  input  wire [31:0] pose,         // number of the pose
  input  wire [31:0] steps,        // STEPS
  input  wire [31:0] cycles,       // cycles of the run
  input  wire [31:0] near,         // NEAR
  input  wire [31:0] collisions,   // COLLISIONS
  input  wire [31:0] warnings,     // near pairs in the warning band
  input  wire [31:0] out_of_range, // collisions that are out of range
  input  wire [31:0] pairs,        // PAIRS
  input  wire [31:0] rows,         // ROWS
  input  wire [31:0] entries,      // ENTRIES
  input  wire [31:0] first_a,      // FIRST: A's triangle
  input  wire [23:0] first_b,      // FIRST: B's triangle
  input  wire [26:0] first_row_a,  // FIRST: {a, leaf A}
  input  wire [26:0] first_row_b,  // FIRST: {b, leaf B}
  output reg         tvalid,       // a transfer
  input  wire        tready,       // it is taken in this cycle
  output reg  [63:0] tdata,        // its data
  output reg         tlast         // the last transfer of a pose
);
  reg         ending_q;
  reg  [6:0]  status_q;
  reg  [2:0]  number_q; // number of the next transfer of the end
  reg  [63:0] shown;
  //@ if fpga
  reg  [63:0] shown_q;
  reg         here_q;   // shown_q is that transfer
  wire        sends = ending_q && here_q;
  //@ end
  wire        free = !tvalid || tready;
  wire        hit = status_q[0];
  wire        ran = !(|status_q[5:4]); // neither BUS nor REFUSED: the counters are valid

  assign ready = free;
  assign busy = ending_q || tvalid; //@ !fpga

  always @(*) begin
    case (number_q)
      3'd0: shown = {1'b1, 24'd0, status_q, steps & {32{ran}}};
      3'd1: shown = {pose, job};
      3'd2: shown = {near, cycles} & {64{ran}};
      3'd3: shown = {warnings, collisions} & {64{ran}};
      3'd4: shown = {pairs, out_of_range} & {64{ran}};
      3'd5: shown = {entries, rows} & {64{ran}};
      3'd6: shown = {8'd0, first_b, first_a} & {64{hit}};
      default: shown = {5'd0, first_row_b, 5'd0, first_row_a} & {64{hit}};
    endcase
  end

  always @(posedge clk) begin
    if (rst) begin
      {ending_q, tvalid, number_q} <= 5'd0;
      {busy, here_q} <= 2'd0; //@ fpga
    end else begin
      busy <= send || ending_q || tvalid; //@ fpga
      //@ if fpga
      here_q <= ending_q && !(here_q && free);
      ending_q <= send || (ending_q && !(sends && free && (&number_q)));
      if (free) begin
        tvalid <= valid || sends;
        number_q <= ending_q ? number_q + {2'd0, here_q} : 3'd0;
      end
      //@ else
      ending_q <= send || (ending_q && !(free && (&number_q)));
      if (free) begin
        tvalid <= valid || ending_q;
        number_q <= ending_q ? number_q + 3'd1 : 3'd0;
      end
      //@ end
    end
    shown_q <= shown; //@ fpga
    if (send) begin
      status_q <= status;
    end
    if (free) begin
      tlast <= ending_q && (&number_q);
      tdata <= ending_q ? @shown@ : {5'd0, warning, outside, coplanar, b, a};
    end
  end
endmodule
