// SPDX-License-Identifier: MIT
// A stack in a memory. The entry that was pushed last is in a register, so each cycle can push or
// pop an entry. An entry is at `top` from the cycle after its push on.
module sepax_tree_stack #(
  parameter WIDTH = 64,  // bits of an entry
  parameter ADDRESS = 10 // log2 of the entries
) (
  input  wire             clk,   // clock
  input  wire             clear, // drop all entries
  input  wire             push,  // put an entry on top; only if not full
  input  wire [WIDTH-1:0] in,    // the entry
  input  wire             pop,   // take the top; only if not empty, not with push
  output wire [WIDTH-1:0] top,   // the entry on top
  output wire             empty, // there is no entry
  output wire             full   // there are 2^ADDRESS entries
);
  localparam [ADDRESS:0] ONE = 1;
  localparam [ADDRESS-1:0] TWO = 2;
  reg  [ADDRESS:0]   count_q;
  reg                pushed_q;   // the top is in in_q; otherwise it is the memory's output
  reg  [WIDTH-1:0]   in_q;
  wire [WIDTH-1:0]   read_data;
  wire [ADDRESS-1:0] below = count_q[ADDRESS-1:0] - ONE[ADDRESS-1:0]; // index of the top

  assign empty = !(|count_q);
  assign full = count_q[ADDRESS];
  assign top = pushed_q ? in_q : read_data;

  sepax_ram #(.WIDTH(WIDTH), .ADDRESS(ADDRESS)) entries (
    .clk(clk), .write(push && pushed_q), .write_address(below), .write_data(in_q), .read(pop),
    .read_address(count_q[ADDRESS-1:0] - TWO), .read_data(read_data)
  );

  always @(posedge clk) begin
    if (clear) begin
      count_q <= {(ADDRESS+1){1'b0}};
      pushed_q <= 1'b0;
    end else begin
      count_q <= count_q + {{ADDRESS{1'b0}}, push} - {{ADDRESS{1'b0}}, pop};
      pushed_q <= push || (pushed_q && !pop);
    end
    if (push) begin
      in_q <= in;
    end
  end
endmodule
