// SPDX-License-Identifier: MIT
// The tags of one body's blocks in a cache of 2^SETS sets of 4 ways. A request finds its block, or
// it takes a way of its set and asks for the block. The ways of the `used` requests before it are
// pinned: they are not given to another block. While all four ways of a set are pinned, the request
// waits. A request takes @look_up@ cycles.
module sepax_tags #(
  parameter ADDRESS = 33, // bits of a block's address
  parameter SETS = 4,     // log2 of the sets
  parameter NUMBER = 8    // bits of a request's number, counted modulo 2^NUMBER
) (
  input  wire               clk,        // clock
  input  wire               rst,        // synchronous reset, active high: forget all blocks
  input  wire               forget,     // empty all sets; takes 2^SETS cycles
  input  wire               drop,       // drop the request
  input  wire               valid,      // a request; stays 1 until next or drop
  input  wire [ADDRESS-1:0] address,    // address of its block
  input  wire [NUMBER-1:0]  number,     // number of the request
  input  wire [NUMBER-1:0]  used,       // how many requests before it pin their blocks
  output wire               found,      // the block is, or will be, in the slot; stays 1 until next
  output wire [SETS+1:0]    slot,       // {set, way}
  input  wire               next,       // the request is finished; only when found
  output wire               miss_valid, // the block is asked for; found when taken
  input  wire               miss_ready  // it is taken in this cycle
);
  localparam TAG = ADDRESS - SETS;    // bits of a tag
  localparam WORD = 1 + TAG + NUMBER; // {valid, tag, number of the last request that found it}
  localparam [1:0] READ = 2'd0, COMPARE = 2'd1, DECIDE = 2'd2, FOUND = 2'd3;
  localparam [SETS-1:0] ONE = 1;
  reg  [1:0]      state_q;
  reg             forget_q;     // the sets are being emptied
  reg  [SETS-1:0] forget_set_q;
  reg  [3:0]      hit_q;        // one-hot: the way that has the block
  reg  [3:0]      pinned_q;     // ways that are pinned
  reg  [1:0]      rotate_q;     // the way that is tried first for a new block
  reg  [1:0]      way_q;        // the way of the block
  reg  [TAG-1:0]  tag_q;        // tag of the request
  wire [3:0]      hit, pinned;
  wire [SETS-1:0] set = address[SETS-1:0] ^ address[2*SETS-1:SETS];
  wire            read = (state_q == READ) && valid && !forget_q;
  wire            is_hit = |hit_q;
  wire            decide = (state_q == DECIDE);
  wire [1:0]      way_1 = rotate_q + 2'd1;
  wire [1:0]      way_2 = rotate_q + 2'd2;
  wire [1:0]      way_3 = rotate_q + 2'd3;
  wire [1:0]      free_way = !pinned_q[rotate_q] ? rotate_q : !pinned_q[way_1] ? way_1 :
                             !pinned_q[way_2] ? way_2 : way_3;
  wire [1:0]      way = is_hit ? {hit_q[3] || hit_q[2], hit_q[3] || hit_q[1]} : free_way;
  wire            take = miss_valid && miss_ready;
  wire            enter = (decide && is_hit) || take;

  assign miss_valid = decide && !is_hit && !(&pinned_q) && !drop; //@ !fpga
  //@ if fpga
  reg             miss_q;
  wire            asks = decide && !is_hit && !(&pinned_q);

  assign miss_valid = miss_q;
  //@ end
  assign found = enter || (state_q == FOUND); //@ !fpga
  assign slot = {set, decide ? way : way_q}; //@ !fpga
  assign slot = {set, way_q}; //@ fpga
  assign found = (state_q == FOUND); //@ fpga

  genvar w;
  generate
    for (w = 0; w < 4; w = w + 1) begin : ways
      wire [WORD-1:0]   word;
      wire [NUMBER-1:0] ago = number - word[NUMBER-1:0]; // how many requests ago: 1 ... used pins
      sepax_ram #(.WIDTH(WORD), .ADDRESS(SETS)) tags (
        .clk(clk), .write(forget_q || (enter && (way == w[1:0]))), //@ !fpga
        .clk(clk), .write(forget_q || (decide && hit_q[w]) || (take && (way_q == w[1:0]))), //@ fpga
        .write_address(forget_q ? forget_set_q : set),
        .write_data(forget_q ? {WORD{1'b0}} : {1'b1, tag_q, number}), .read(read),
        .read_address(set), .read_data(word)
      );
      assign hit[w] = word[WORD-1] && (word[WORD-2:NUMBER] == tag_q);
      assign pinned[w] = word[WORD-1] && (|ago) && (ago <= used);
    end
  endgenerate

  always @(posedge clk) begin
    if (rst) begin
      forget_q <= 1'b1;
      forget_set_q <= {SETS{1'b0}};
      rotate_q <= 2'd0;
    end else begin
      forget_q <= forget || (forget_q && !(&forget_set_q));
      if (forget_q) begin
        forget_set_q <= forget_set_q + ONE;
      end
      if (take) begin
        rotate_q <= way_1;
      end
    end
    if (rst || drop) begin
      state_q <= READ;
      miss_q <= 1'b0; //@ fpga
    end else begin
      miss_q <= asks && !take; //@ fpga
      case (state_q)
        READ: state_q <= read ? COMPARE : READ;
        COMPARE: state_q <= DECIDE;
        DECIDE: state_q <= enter ? (next ? READ : FOUND) : miss_valid ? DECIDE : COMPARE; //@ !fpga
        DECIDE: state_q <= enter ? FOUND : asks ? DECIDE : COMPARE; //@ fpga
        default: state_q <= next ? READ : FOUND;
      endcase
    end
    if (read) begin
      tag_q <= address[ADDRESS-1:SETS];
    end
    if (state_q == COMPARE) begin
      hit_q <= hit;
      pinned_q <= pinned;
    end
    if (decide) begin
      way_q <= way;
    end
  end
endmodule
