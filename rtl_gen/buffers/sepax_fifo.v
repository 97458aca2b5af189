// SPDX-License-Identifier: MIT
// FIFO of words in registers. `free` falls while MARGIN words still find an entry, as many as may
// come after it was seen. A word is at `out` from the cycle after its push on.
module sepax_fifo #(
  parameter WIDTH = 8,   // bits of a word
  parameter ADDRESS = 4, // log2 of the entries
  parameter MARGIN = 2   // entries that `free` stands for
) (
  input  wire             clk,   // clock
  input  wire             clear, // drop all words
  input  wire             push,  // append a word; only with an entry free
  input  wire [WIDTH-1:0] in,    // the word
  output reg              free,  // MARGIN or more entries are free
  output wire             valid, // there is a word //@ !fpga
  output reg              valid, // there is a word //@ fpga
  input  wire             pop,   // take it; only if there is one
  output wire [WIDTH-1:0] out    // the oldest word
);
  localparam [ADDRESS:0] ONE = 1;
  localparam FULLEST = (1 << ADDRESS) - MARGIN;
  reg  [WIDTH-1:0]   word_q [0:(1<<ADDRESS)-1];
  reg  [ADDRESS-1:0] head_q, tail_q;
  reg  [ADDRESS:0]   count_q;
  //@ if !fpga
  wire [ADDRESS:0]   next_count = count_q + {{ADDRESS{1'b0}}, push} - {{ADDRESS{1'b0}}, pop};
  //@ end

  assign valid = |count_q; //@ !fpga
  assign out = word_q[head_q];

  always @(posedge clk) begin
    if (clear) begin
      head_q <= {ADDRESS{1'b0}};
      tail_q <= {ADDRESS{1'b0}};
      count_q <= {(ADDRESS+1){1'b0}};
      free <= 1'b1;
      valid <= 1'b0; //@ fpga
    end else begin
      //@ if fpga
      if (push != pop) begin
        count_q <= count_q + {{ADDRESS{pop}}, 1'b1};
      end
      free <= count_q < FULLEST[ADDRESS:0]; // a cycle late, and so one word early
      valid <= push || (|count_q[ADDRESS:1]) || (count_q[0] && !pop);
      //@ else
      count_q <= next_count;
      free <= next_count <= FULLEST[ADDRESS:0];
      //@ end
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
  // Who pushes has seen `free` at most MARGIN words before; nobody pops what is not there.
  reg             begun_q = 1'b0;
  reg [ADDRESS:0] late_q;   // words pushed since `free` was seen last
  reg             stored_q; // a word is watched: it stands at entry_q until it is popped
  reg [ADDRESS-1:0] entry_q;
  reg [WIDTH-1:0] watched_q;
  always @(posedge clk) begin
    begun_q <= 1'b1;
    assume (begun_q || clear);
    assume (!push || free || (late_q != MARGIN[ADDRESS:0] - ONE));
    assume (!pop || valid);
    late_q <= (clear || free) ? {(ADDRESS+1){1'b0}} : late_q + {{ADDRESS{1'b0}}, push};
    stored_q <= !clear && ((stored_q && !(pop && (head_q == entry_q))) || (push && !stored_q));
    if (push && !stored_q) begin
      entry_q <= tail_q;
      watched_q <= in;
    end
    if (begun_q && !clear) begin
      assert (!(push && !pop && count_q[ADDRESS]));
      assert (!(count_q[ADDRESS] && (|count_q[ADDRESS-1:0])));
      if (stored_q && (head_q == entry_q)) begin
        assert (valid && (out == watched_q));
      end
      if (begun_q && $past(begun_q && valid && !pop && !clear)) begin
        assert (valid && (out == $past(out)));
      end
    end
  end
`endif
endmodule
