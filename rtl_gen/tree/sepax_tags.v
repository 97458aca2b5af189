// Which blocks of one body are in a cache of 2^SETS sets of 4 ways, and where. A request finds its
// block, or takes a way of its set and asks for the block. The ways that requests `oldest` to
// `number` - 1 found are pinned: they are not given to other blocks; a request waits while all
// four are. An address has its set in its lowest bits. Latency 3.
module sepax_tags #(
  parameter ADDRESS = 33, // bits of a block's address
  parameter SETS = 4,     // log2 of the sets
  parameter NUMBER = 8    // bits of a request's number, counted modulo 2^NUMBER
) (
  input  wire               clk,          // clock
  input  wire               rst,          // synchronous reset, active high: forget all blocks
  input  wire               forget,       // forget all blocks; takes 2^SETS cycles
  input  wire               drop,         // drop the request
  input  wire               valid,        // a request; stands until next, or is dropped
  input  wire [ADDRESS-1:0] address,      // of its block
  input  wire [NUMBER-1:0]  number,       // of the request
  input  wire [NUMBER-1:0]  used,         // number - oldest: requests that pin
  output wire               found,        // the block is or will be in slot; stands until next
  output wire [SETS+1:0]    slot,         // {set, way}
  output wire               missed,       // it is asked for; in the first cycle of found
  input  wire               next,         // the request is done with; only when found
  output reg                miss_valid,   // a block is asked for
  input  wire               miss_ready,   // it is taken
  output reg  [ADDRESS-1:0] miss_address, // its address
  output reg  [SETS+1:0]    miss_slot     // its slot
);
  localparam TAG = ADDRESS - SETS;      // bits of a tag
  localparam WORD = 1 + TAG + NUMBER;   // {valid, tag, number of the last request that found it}
  localparam [1:0] READ = 2'd0, COMPARE = 2'd1, DECIDE = 2'd2, FOUND = 2'd3;
  localparam [SETS-1:0] ONE = 1;
  reg  [1:0]        state_q;
  reg               forget_q;   // forgetting
  reg  [SETS-1:0]   forget_set_q;
  reg  [3:0]        hit_q;      // one-hot: the way that has the block
  reg  [3:0]        pinned_q;   // ways that are pinned
  reg  [1:0]        rotate_q;   // the way that is looked at first
  reg  [1:0]        way_q;      // the way that was found
  wire [3:0]        hit, pinned;
  wire [SETS-1:0]   set = address[SETS-1:0] ^ address[2*SETS-1:SETS];
  wire [TAG-1:0]    tag = address[ADDRESS-1:SETS];
  wire              read = (state_q == READ) && valid && !forget_q;
  wire              is_hit = |hit_q;
  wire              decide = (state_q == DECIDE) && !drop;
  wire              take = decide && !is_hit && !(&pinned_q) && !miss_valid;
  wire [1:0]        way;
  wire [1:0]        way_1 = rotate_q + 2'd1, way_2 = rotate_q + 2'd2, way_3 = rotate_q + 2'd3;
  wire [1:0]        free_way = !pinned_q[rotate_q] ? rotate_q : !pinned_q[way_1] ? way_1 :
                               !pinned_q[way_2] ? way_2 : way_3;

  assign way = is_hit ? {hit_q[3] || hit_q[2], hit_q[3] || hit_q[1]} : free_way;
  assign found = (decide && is_hit) || take || (state_q == FOUND);
  assign slot = {set, (state_q == FOUND) ? way_q : way};
  assign missed = take;

  genvar w;
  generate
    for (w = 0; w < 4; w = w + 1) begin : ways
      wire [WORD-1:0]   word;
      wire [NUMBER-1:0] ago = number - word[NUMBER-1:0];
      sepax_ram #(.WIDTH(WORD), .ADDRESS(SETS)) tags (
        .clk(clk), .write(forget_q || (decide && found && (way == w[1:0]))),
        .write_address(forget_q ? forget_set_q : set),
        .write_data(forget_q ? {WORD{1'b0}} : {1'b1, tag, number}), .read(read),
        .read_address(set), .read_data(word)
      );
      assign hit[w] = word[WORD-1] && (word[WORD-2:NUMBER] == tag);
      // The last request that found it was 1 ... used requests ago.
      assign pinned[w] = word[WORD-1] && (|ago) && (ago <= used);
    end
  endgenerate

  always @(posedge clk) begin
    if (rst) begin
      state_q <= READ;
      forget_q <= 1'b1;
      forget_set_q <= {SETS{1'b0}};
      miss_valid <= 1'b0;
      rotate_q <= 2'd0;
    end else begin
      if (drop) begin
        state_q <= READ;
      end else begin
        case (state_q)
          READ: state_q <= read ? COMPARE : READ;
          COMPARE: state_q <= DECIDE;
          DECIDE: state_q <= !found ? COMPARE : next ? READ : FOUND;
          default: state_q <= next ? READ : FOUND;
        endcase
      end
      forget_q <= forget || (forget_q && !(&forget_set_q));
      if (forget_q) begin
        forget_set_q <= forget_set_q + ONE;
      end
      miss_valid <= take || (miss_valid && !miss_ready);
      if (take) begin
        rotate_q <= way_1;
      end
    end
    if (state_q == COMPARE) begin
      hit_q <= hit;
      pinned_q <= pinned;
    end
    if (decide) begin
      way_q <= way;
    end
    if (take) begin
      miss_address <= address;
      miss_slot <= slot;
    end
  end
endmodule
