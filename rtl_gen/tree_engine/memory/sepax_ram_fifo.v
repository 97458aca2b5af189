// SPDX-License-Identifier: MIT
// A FIFO in a memory. A word is at `out` from the second cycle after its push on, or from the cycle
// after the word before it was taken, whichever is later.
module sepax_ram_fifo #(
  parameter WIDTH = 8,  // bits of a word
  parameter ADDRESS = 4 // log2 of the words, 1 or more
) (
  input  wire             clk,   // clock
  input  wire             clear, // drop all words
  input  wire             push,  // append a word; only if there are fewer than 2^ADDRESS
  input  wire [WIDTH-1:0] in,    // the word
  output reg              valid, // a word is at out
  input  wire             pop,   // take the word at out; only if valid
  output wire [WIDTH-1:0] out    // the oldest word, at the memory's output
);
  localparam [ADDRESS:0] ONE = 1;
  reg  [ADDRESS:0] head_q, tail_q; // number of words that were read, that were pushed
  wire             read = (head_q != tail_q) && (!valid || pop);

  sepax_ram #(.WIDTH(WIDTH), .ADDRESS(ADDRESS), .DISTRIBUTED(1)) words ( //@ fpga
  sepax_ram #(.WIDTH(WIDTH), .ADDRESS(ADDRESS)) words ( //@ !fpga
    .clk(clk), .write(push), .write_address(tail_q[ADDRESS-1:0]), .write_data(in), .read(read),
    .read_address(head_q[ADDRESS-1:0]), .read_data(out)
  );

  always @(posedge clk) begin
    if (clear) begin
      head_q <= {(ADDRESS+1){1'b0}};
      tail_q <= {(ADDRESS+1){1'b0}};
      valid <= 1'b0;
    end else begin
      if (read) begin
        head_q <= head_q + ONE;
      end
      if (push) begin
        tail_q <= tail_q + ONE;
      end
      valid <= read || (valid && !pop);
    end
  end
endmodule
