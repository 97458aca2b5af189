// SPDX-License-Identifier: MIT
// A FIFO in a memory. A word is at `out` from the second cycle after its push on, or from the cycle
// after the word before it was taken, whichever is later. In a quick one, a word that finds no
// other is at `out` from the cycle after its push on, because it does not go through the memory.
module sepax_ram_fifo #(
  parameter WIDTH = 8,  // bits of a word
  parameter QUICK = 0,  // a quick one
  parameter ADDRESS = 4 // log2 of the words, 1 or more
) (
  input  wire             clk,   // clock
  input  wire             clear, // drop all words
  input  wire             push,  // append a word; only if there are fewer than 2^ADDRESS
  input  wire [WIDTH-1:0] in,    // the word
  output reg              valid, // a word is at out
  input  wire             pop,   // take the word at out; only if valid
  output wire [WIDTH-1:0] out    // the oldest word
);
  localparam [ADDRESS:0] ONE = 1;
  reg  [ADDRESS:0] head_q, tail_q; // number of words that were read, that were pushed
  wire             some = head_q != tail_q;
  wire             read = some && (!valid || pop);
  wire             direct;      // the word that is pushed does not go through the memory
  wire [WIDTH-1:0] read_data;

  sepax_ram #(.WIDTH(WIDTH), .ADDRESS(ADDRESS), .DISTRIBUTED(1)) words ( //@ fpga
  sepax_ram #(.WIDTH(WIDTH), .ADDRESS(ADDRESS)) words ( //@ !fpga
    .clk(clk), .write(push && !direct), .write_address(tail_q[ADDRESS-1:0]), .write_data(in),
    .read(read), .read_address(head_q[ADDRESS-1:0]), .read_data(read_data)
  );

  generate
    if (QUICK != 0) begin : quick
      reg             direct_q; // the word at `out` did not go through the memory
      reg [WIDTH-1:0] word_q;
      assign direct = push && !some && (!valid || pop);
      assign out = direct_q ? word_q : read_data;
      always @(posedge clk) begin
        if (direct || read) begin
          direct_q <= direct;
        end
        if (direct) begin
          word_q <= in;
        end
      end
    end else begin : slow
      assign direct = 1'b0;
      assign out = read_data;
    end
  endgenerate

  always @(posedge clk) begin
    if (clear) begin
      head_q <= {(ADDRESS+1){1'b0}};
      tail_q <= {(ADDRESS+1){1'b0}};
      valid <= 1'b0;
    end else begin
      if (read) begin
        head_q <= head_q + ONE;
      end
      if (push && !direct) begin
        tail_q <= tail_q + ONE;
      end
      valid <= read || direct || (valid && !pop);
    end
  end
endmodule
