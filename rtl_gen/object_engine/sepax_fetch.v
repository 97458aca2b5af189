// SPDX-License-Identifier: MIT
// The triangles of a pair from the memories, B's moved, and valid/ready to the cores. A pair of
// which B does not fit the word any more is marked; its verdict does not count.
//@ if fpga
// What comes from block RAM waits a cycle more in registers.
//@ end
//@ if swaps
// The thinnest side of A becomes z of both: a pair in a plane across an axis takes one pass.
//@ end
module sepax_fetch (
  input  wire            clk,         // clock
  input  wire            clear,       // drop what is in flight
  input  wire            valid,       // a pair is here
  input  wire [@index_a@-1:0]    a,           // number of A's triangle
  input  wire [@index_b@-1:0]    b,           // number of B's triangle
  output wire            read,        // it is taken: read both memories //@ !fpga
  output wire            read,        // read both memories; a pair that is here is taken //@ fpga
  input  wire [9*@word@-1:0] read_a,      // from A's, in the next cycle
  input  wire [1:0]      thinnest,    // with it: which side of its AABB is the thinnest //@ swaps
  input  wire [9*@word@-1:0] read_b,      // from B's
  input  wire [3*(@word@+1)-1:0] move,    // added to B: {z, y, x}, signed
  output wire            busy,        // a pair is in flight
  output reg             out_valid,   // a pair for a core
  input  wire            out_ready,   // it is taken
  output reg  [9*@word@-1:0] out_a,       // A
  output reg  [9*@word@-1:0] out_b,       // B
  output reg             out_outside, // B does not fit //@ !fpga
  output wire            out_outside, // B does not fit //@ fpga
  output reg  [@index_a@-1:0]    number_a,    // number of A's triangle
  output reg  [@index_b@-1:0]    number_b     // number of B's triangle
);
  localparam W = @word@;  // bits of a coordinate
  localparam V = @moved@; // of one that was moved
  reg            valid_q;
  reg  [@index_a@-1:0]   a_q;
  reg  [@index_b@-1:0]   b_q;
  wire [9*V-1:0] moved;
  wire [9*W-1:0] moved_b;
  wire [9*W-1:0] next_a, next_b;
  wire [8:0]     outside;
  wire           enable_2 = !out_valid || out_ready; //@ each_cycle
  // A core's in_ready comes late; a pair in every other cycle is enough. //@ !each_cycle
  wire           enable_2 = !out_valid; //@ !each_cycle
  wire           enable_1 = !valid_q || enable_2; //@ !fpga
  wire           enable_1 = enable_2; // all move, the memories, too //@ fpga
  //@ if fpga
  reg            valid_in_q;
  reg  [@index_a@-1:0]   a_in_q;
  reg  [@index_b@-1:0]   b_in_q;
  reg  [9*W-1:0] read_a_in_q, read_b_in_q;
  reg  [1:0]     thinnest_in_q; //@ swaps
  reg  [8:0]     outside_q;
  //@ end

  //@ if swaps
  sepax_swap_axes #(.W(W)) axes_a (.thinnest(thinnest@in@), .in(read_a@in@), .out(next_a));
  sepax_swap_axes #(.W(W)) axes_b (.thinnest(thinnest@in@), .in(moved_b), .out(next_b));
  //@ else
  assign next_a = read_a@in@;
  assign next_b = moved_b;
  //@ end

  assign read = valid && enable_1; //@ !fpga
  assign read = enable_1; //@ fpga
  assign out_outside = |outside_q; //@ fpga
  assign busy = valid_q || out_valid; //@ !fpga
  assign busy = valid_q || valid_in_q || out_valid; //@ fpga

  genvar k;
  generate
    for (k = 0; k < 9; k = k + 1) begin : coordinate
      assign moved[k*V +: V] = {{2{read_b@in@[k*W+W-1]}}, read_b@in@[k*W +: W]} +
                               {move[(k%3)*(W+1)+W], move[(k%3)*(W+1) +: W+1]};
      assign moved_b[k*W +: W] = moved[k*V +: W];
      assign outside[k] = (moved[k*V+V-1] != moved[k*V+W-1]) ||
                          (moved[k*V+V-2] != moved[k*V+W-1]);
    end
  endgenerate

  always @(posedge clk) begin
    if (clear) begin
      {valid_q, out_valid} <= 2'd0;
      valid_in_q <= 1'b0; //@ fpga
    end else begin
      if (enable_1) begin
        valid_q <= valid;
        valid_in_q <= valid_q; //@ fpga
      end
      out_valid <= enable_2 ? valid@at@_q : !out_ready;
    end
    if (read) begin
      a_q <= a;
      b_q <= b;
    end
    //@ if fpga
    if (read) begin
      a_in_q <= a_q;
      b_in_q <= b_q;
      read_a_in_q <= read_a;
      read_b_in_q <= read_b;
      thinnest_in_q <= thinnest; //@ swaps
    end
    //@ end
    if (enable_2) begin
      number_a <= a@at@_q;
      number_b <= b@at@_q;
      out_a <= next_a;
      out_b <= next_b;
      out_outside <= |outside; //@ !fpga
      outside_q <= outside; //@ fpga
    end
  end
endmodule
