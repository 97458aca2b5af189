// Sends the pairs of a run and its end by AXI4-Stream, 64 bits (docs/reference/tree-engine.md,
// Results).
module sepax_tree_results (
  input  wire        clk,          // clock
  input  wire        rst,          // synchronous reset, active high
  input  wire        valid,        // a pair of the run
  output wire        ready,        // it is taken
  input  wire [31:0] a,            // number of A's triangle
  input  wire [23:0] b,            // of B's
  input  wire        coplanar,     // they are in one plane
  input  wire        outside,      // out of range
  input  wire        warning,      // in the band of warnings
  input  wire        send,         // the run has ended: send its end
  input  wire [6:0]  status,       // with send: {LAST, REFUSED, ... HIT}
  output wire        busy,         // its end has not gone; what follows stands meanwhile //@ !fpga
  output reg         busy,         // its end has not gone; what follows stands meanwhile //@ fpga
  input  wire [31:0] job,          // number of the job
  input  wire [31:0] pose,         // number of the pose
  input  wire [31:0] steps,        // counters
  input  wire [31:0] cycles,       // clock cycles
  input  wire [31:0] near,         // near pairs
  input  wire [31:0] collisions,   // of these, pairs that collide
  input  wire [31:0] warnings,     // of these, in the band of warnings
  input  wire [31:0] out_of_range, // of the collisions, undecided
  input  wire [31:0] pairs,        // pairs that were tested
  input  wire [31:0] rows,         // rows
  input  wire [31:0] entries,      // entries
  input  wire [31:0] first_a,      // FIRST: A's triangle
  input  wire [23:0] first_b,      // B's triangle
  input  wire [26:0] first_row_a,  // {a, leaf A}
  input  wire [26:0] first_row_b,  // {b, leaf B}
  output reg         tvalid,       // a transfer
  input  wire        tready,       // it is taken
  output reg  [63:0] tdata,        // its data
  output reg         tlast         // the last of a pose
);
  reg         ending_q;
  reg  [6:0]  status_q;
  reg  [2:0]  number_q; // of the transfer of the end that comes next
  reg  [63:0] shown;
  //@ if fpga
  reg  [63:0] shown_q;
  reg         here_q;   // it is that transfer
  wire        sends = ending_q && here_q;
  //@ end
  wire        free = !tvalid || tready;
  wire        hit = status_q[0];
  wire        ran = !(|status_q[5:4]); // neither BUS nor REFUSED: counters are those of the pose

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
