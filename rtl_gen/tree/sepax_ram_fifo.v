// FIFO whose words are in a memory, its oldest one in a register. A word is at `out` from the
// cycle after its push on if the FIFO was empty, else three cycles or more after it.
module sepax_ram_fifo #(
  parameter WIDTH = 8,  // bits of a word
  parameter ADDRESS = 4 // log2 of the words, 2 or more
) (
  input  wire             clk,   // clock
  input  wire             clear, // drop all words
  input  wire             push,  // append a word; only if free
  input  wire [WIDTH-1:0] in,    // the word
  output wire             free,  // a word can be pushed
  output reg              valid, // there is a word at out
  input  wire             pop,   // take it; only if there is one
  output reg  [WIDTH-1:0] out    // the oldest word
);
  localparam [ADDRESS:0] ONE = 1;
  reg  [ADDRESS:0]   count_q;        // words in all
  reg  [ADDRESS-1:0] head_q, tail_q; // in the memory
  reg                read_q;         // the memory's output is a word
  wire [WIDTH-1:0]   read_data;
  wire               empty = (head_q == tail_q);
  wire               move = !valid || pop;
  wire               bypass = push && empty && !read_q && move;
  wire               write = push && !bypass;
  wire               read = !empty && (move || !read_q);

  assign free = !count_q[ADDRESS];

  sepax_ram #(.WIDTH(WIDTH), .ADDRESS(ADDRESS)) words (
    .clk(clk), .write(write), .write_address(tail_q), .write_data(in), .read(read),
    .read_address(head_q), .read_data(read_data)
  );

  always @(posedge clk) begin
    if (clear) begin
      count_q <= {(ADDRESS+1){1'b0}};
      head_q <= {ADDRESS{1'b0}};
      tail_q <= {ADDRESS{1'b0}};
      {read_q, valid} <= 2'd0;
    end else begin
      count_q <= count_q + {{ADDRESS{1'b0}}, push} - {{ADDRESS{1'b0}}, pop};
      if (write) begin
        tail_q <= tail_q + ONE[ADDRESS-1:0];
      end
      if (read) begin
        head_q <= head_q + ONE[ADDRESS-1:0];
      end
      read_q <= read || (read_q && !move);
      valid <= !move || read_q || bypass;
    end
    if (move) begin
      out <= read_q ? read_data : in;
    end
  end
endmodule
