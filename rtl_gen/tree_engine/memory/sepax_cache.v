// SPDX-License-Identifier: MIT
// Control of a cache for pairs of blocks, one of body A and one of body B. Both blocks of a pair
// are looked up, and a block that is not here is asked for. The blocks of a body come in the order
// in which they were asked for. So a pair waits until as many blocks have come as were asked for up
// to its lookup. Pairs come out in order. The blocks of a pair stay until the pair is released;
// pairs are released in order.
module sepax_cache #(
  parameter ADDRESS = 33, // bits of a block's address
  parameter INFO = 32,    // bits that go with a pair
  parameter QUICK = 0,    // a pair whose blocks are here comes out two cycles earlier
  parameter SETS = 4,     // log2 of the sets of 4 ways a body
  parameter WINDOW = 5    // log2 of the most pairs between in and release
) (
  input  wire               clk,          // clock
  input  wire               rst,          // synchronous reset, active high
  input  wire               start,        // drop all pairs; no block is on its way
  input  wire               cold,         // with start: empty the cache
  input  wire               drop,         // drop all pairs
  input  wire               in_valid,     // a pair is wanted; it stands until in_ready or drop
  output wire               in_ready,     // it is taken in this cycle
  input  wire [ADDRESS-1:0] in_a,         // address of A's block
  input  wire [ADDRESS-1:0] in_b,         // address of B's block
  input  wire [INFO-1:0]    in_info,      // bits that go with the pair
  output reg                out_valid,    // the oldest pair is here, or has an error
  input  wire               out_ready,    // it is taken in this cycle
  output wire [SETS+1:0]    out_a,        // slot of A's block
  output wire [SETS+1:0]    out_b,        // slot of B's block
  output wire [INFO-1:0]    out_info,     // the bits that went in with the pair
  output reg                out_error,    // a block of the pair came with an error
  input  wire               done,         // the oldest pair is released
  output wire               miss_valid,   // a block is asked for
  input  wire               miss_ready,   // it is taken in this cycle
  output wire               miss_is_b,    // the block is B's
  output wire [ADDRESS-1:0] miss_address, // address of the block
  output wire [SETS+1:0]    miss_slot,    // slot of the block
  input  wire               filled,       // a block has come
  input  wire               filled_is_b,  // the block is B's
  input  wire               filled_error  // it came with an error
);
  localparam NUMBER = WINDOW + 3; // bits of a pair's number
  localparam COUNT = WINDOW + 2;  // bits of a count of blocks of a body
  localparam [NUMBER-1:0] ONE = 1;
  reg  [NUMBER-1:0] number_q;               // number of the pair that is looked up
  reg  [NUMBER-1:0] used_q;                 // number of pairs before it that are not released
  reg  [COUNT-1:0]  asked_a_q, asked_b_q;   // blocks that were asked for
  reg  [COUNT-1:0]  filled_a_q, filled_b_q; // blocks that have come
  reg               error_a_q, error_b_q;   // a block came with an error
  reg  [COUNT-1:0]  good_a_q, good_b_q;     // number of blocks that came before the first error
  reg  [WINDOW:0]   waiting_q;              // pairs that have not come out
  wire [COUNT-1:0]  asked_a, asked_b, wait_a, wait_b;
  wire              found_a, found_b, miss_a, miss_b, waiting;
  wire [SETS+1:0]   slot_a, slot_b;
  wire              clear = rst || start || drop;
  wire              forget = start && (cold || error_a_q || error_b_q);
  wire              take = out_valid && out_ready;

  // A pair waits for all blocks of its bodies that were asked for up to its lookup.
  wire [COUNT-1:0]  over_a = filled_a_q - wait_a;
  wire [COUNT-1:0]  over_b = filled_b_q - wait_b;
  wire [COUNT-1:0]  lack_a = good_a_q - wait_a;
  wire [COUNT-1:0]  lack_b = good_b_q - wait_b;
  wire              is_here = !over_a[COUNT-1] && !over_b[COUNT-1];
  wire              is_error = (error_a_q && lack_a[COUNT-1]) || (error_b_q && lack_b[COUNT-1]);

  // If no block is on its way, then the pair at the FIFO's output in the next cycle is here.
  wire              all_here = (asked_a_q == filled_a_q) && (asked_b_q == filled_b_q) &&
                               !error_a_q && !error_b_q;
  wire              comes = (in_ready && !miss_valid) || (take && (|waiting_q[WINDOW:1]));
  wire              quick = QUICK[0] && all_here && comes;

  assign in_ready = found_a && found_b && !used_q[WINDOW];
  assign asked_a = asked_a_q + {{(COUNT-1){1'b0}}, miss_a && miss_ready};
  assign asked_b = asked_b_q + {{(COUNT-1){1'b0}}, miss_b && miss_ready && !miss_a};
  assign miss_valid = miss_a || miss_b;
  assign miss_is_b = !miss_a;
  assign miss_address = miss_a ? in_a : in_b;
  assign miss_slot = miss_a ? slot_a : slot_b;

  sepax_tags #(.ADDRESS(ADDRESS), .SETS(SETS), .NUMBER(NUMBER)) tags_a (
    .clk(clk), .rst(rst), .forget(forget), .drop(clear), .valid(in_valid), .address(in_a),
    .number(number_q), .used(used_q), .found(found_a), .slot(slot_a), .next(in_ready),
    .miss_valid(miss_a), .miss_ready(miss_ready)
  );
  sepax_tags #(.ADDRESS(ADDRESS), .SETS(SETS), .NUMBER(NUMBER)) tags_b (
    .clk(clk), .rst(rst), .forget(forget), .drop(clear), .valid(in_valid), .address(in_b),
    .number(number_q), .used(used_q), .found(found_b), .slot(slot_b), .next(in_ready),
    .miss_valid(miss_b), .miss_ready(miss_ready && !miss_a)
  );
  sepax_ram_fifo #(
    .WIDTH(INFO+2*SETS+4+2*COUNT), .QUICK(QUICK), .ADDRESS(WINDOW)
  ) pairs (
    .clk(clk), .clear(clear), .push(in_ready), .in({in_info, slot_a, slot_b, @asked@}),
    .valid(waiting), .pop(take), .out({out_info, out_a, out_b, wait_a, wait_b})
  );

  always @(posedge clk) begin
    if (rst) begin
      number_q <= {NUMBER{1'b0}};
      asked_a_q <= {COUNT{1'b0}};
      asked_b_q <= {COUNT{1'b0}};
      filled_a_q <= {COUNT{1'b0}};
      filled_b_q <= {COUNT{1'b0}};
    end else begin
      if (in_ready) begin
        number_q <= number_q + ONE;
      end
      asked_a_q <= asked_a;
      asked_b_q <= asked_b;
      filled_a_q <= filled_a_q + {{(COUNT-1){1'b0}}, filled && !filled_is_b};
      filled_b_q <= filled_b_q + {{(COUNT-1){1'b0}}, filled && filled_is_b};
    end
    if (clear) begin
      out_valid <= 1'b0;
      used_q <= {NUMBER{1'b0}};
      waiting_q <= {(WINDOW+1){1'b0}};
    end else begin
      out_valid <= quick || (waiting && (is_here || is_error) && !take);
      waiting_q <= waiting_q + {{WINDOW{1'b0}}, in_ready} - {{WINDOW{1'b0}}, take};
      used_q <= used_q + {{(NUMBER-1){1'b0}}, in_ready} - {{(NUMBER-1){1'b0}}, done};
    end
    out_error <= is_error;
    if (rst || start) begin
      {error_a_q, error_b_q} <= 2'd0;
    end else if (filled && filled_error) begin
      error_a_q <= error_a_q || !filled_is_b;
      error_b_q <= error_b_q || filled_is_b;
    end
    if (!error_a_q) begin
      good_a_q <= filled_a_q;
    end
    if (!error_b_q) begin
      good_b_q <= filled_b_q;
    end
  end
endmodule
