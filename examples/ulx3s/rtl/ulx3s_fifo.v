// SPDX-License-Identifier: MIT
// ulx3s_fifo.v
//
// FIFO in block RAM: what a run finds waits here for the serial line, so that the run does not
// wait. Latency 2. A word stands at the output until it is taken.

`default_nettype none

module ulx3s_fifo #(
  parameter WIDTH = 65,  // bits of a word
  parameter ADDRESS = 12 // log2 of the words that it holds
) (
  input  wire             clk,       // clock
  input  wire             rst,       // synchronous reset, active high: drop all words
  input  wire             in_valid,  // a word is here
  output reg              in_ready,  // it is taken in this cycle
  input  wire [WIDTH-1:0] in,        // the word
  output reg              out_valid, // there is a word
  input  wire             out_ready, // it is taken in this cycle
  output reg  [WIDTH-1:0] out        // the oldest word
);
  localparam [ADDRESS:0] ONE = 1;
  localparam [ADDRESS:0] ALL = 1 << ADDRESS;
  // No word is read while it is written.
  (* no_rw_check *)
  reg  [WIDTH-1:0]   word_q [0:(1<<ADDRESS)-1];
  reg  [ADDRESS-1:0] head_q, tail_q;
  reg  [ADDRESS:0]   count_q; // words in the memory, without the one at the output
  wire               push = in_valid && in_ready;
  wire               pop = (|count_q) && (!out_valid || out_ready);
  wire [ADDRESS:0]   next_count = count_q + (push ? ONE : {(ADDRESS+1){1'b0}}) -
                                  (pop ? ONE : {(ADDRESS+1){1'b0}});

  always @(posedge clk) begin
    if (rst) begin
      head_q <= {ADDRESS{1'b0}};
      tail_q <= {ADDRESS{1'b0}};
      count_q <= {(ADDRESS+1){1'b0}};
      in_ready <= 1'b0;
      out_valid <= 1'b0;
    end else begin
      count_q <= next_count;
      in_ready <= next_count != ALL;
      out_valid <= pop || (out_valid && !out_ready);
      if (push) begin
        tail_q <= tail_q + ONE[ADDRESS-1:0];
      end
      if (pop) begin
        head_q <= head_q + ONE[ADDRESS-1:0];
      end
    end
    if (push) begin
      word_q[tail_q] <= in;
    end
    if (pop) begin
      out <= word_q[head_q];
    end
  end
endmodule

`default_nettype wire
