// FIFO of words in registers. `free` falls while MARGIN words still find an entry, as many as may
// come after it was seen. A word is at `out` from the cycle after its push on.
module sepax_fifo #(
  parameter WIDTH = 8,   // bits of a word
  parameter ADDRESS = 4, // log2 of the entries
  parameter MARGIN = 2   // entries that `free` promises
) (
  input  wire             clk,   // clock
  input  wire             clear, // drop all words
  input  wire             push,  // append a word; only with an entry free
  input  wire [WIDTH-1:0] in,    // the word
  output reg              free,  // MARGIN or more entries are free
  output wire             valid, // there is a word
  input  wire             pop,   // take it; only if there is one
  output wire [WIDTH-1:0] out    // the oldest word
);
  localparam [ADDRESS:0] ONE = 1;
  localparam [ADDRESS:0] FULLEST = (1 << ADDRESS) - MARGIN;
  reg  [WIDTH-1:0]   word_q [0:(1<<ADDRESS)-1];
  reg  [ADDRESS-1:0] head_q;
  reg  [ADDRESS-1:0] tail_q;
  reg  [ADDRESS:0]   count_q;
  wire [ADDRESS:0]   next_count;

  assign valid = |count_q;
  assign out = word_q[head_q];
  assign next_count = count_q + {{ADDRESS{1'b0}}, push} - {{ADDRESS{1'b0}}, pop};

  always @(posedge clk) begin
    if (clear) begin
      head_q <= {ADDRESS{1'b0}};
      tail_q <= {ADDRESS{1'b0}};
      count_q <= {(ADDRESS+1){1'b0}};
      free <= 1'b1;
    end else begin
      count_q <= next_count;
      free <= next_count <= FULLEST;
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
  end

`ifdef FORMAL
  always @(posedge clk) begin
    if (!clear) begin
      assert (!(push && !pop && count_q[ADDRESS]));
      assert (!(pop && !valid));
    end
  end
`endif
endmodule
