// Nodes of bodies A and B: 128 bytes each, 2^SETS sets of 4 a body; each body has a memory of its
// own, 128 bytes wide. The first 32 bytes of a node are read on their own.
module sepax_node_cache #(
  parameter ADDRESS = 40, // bits of a byte address
  parameter INFO = 32,    // bits that go with a pair
  parameter SETS = 4,     // log2 of the sets of 4 nodes a body
  parameter WINDOW = 5    // log2 of the pairs that are in and not released
) (
  input  wire                clk,         // clock
  input  wire                rst,         // synchronous reset, active high
  input  wire                start,       // drop all pairs; no node is on its way
  input  wire                cold,        // with start: forget all nodes
  input  wire                drop,        // drop all pairs
  input  wire [ADDRESS-13:0] base_a,      // A's image / 4096
  input  wire [ADDRESS-13:0] base_b,      // B's
  input  wire                in_valid,    // a pair is wanted; stands until in_ready or drop
  output wire                in_ready,    // it is taken
  input  wire [22:0]         in_a,        // number of A's node
  input  wire [22:0]         in_b,        // number of B's node
  input  wire [INFO-1:0]     in_info,     // goes with the pair
  output wire                out_valid,   // the oldest pair is here, or an error
  input  wire                out_ready,   // it is taken
  output wire [SETS+1:0]     out_a,       // slot of A's node
  output wire [SETS+1:0]     out_b,       // slot of B's node
  output wire [INFO-1:0]     out_info,    // what went with it
  output wire                out_error,   // one of the nodes is not here
  input  wire                done,        // the oldest pair is released
  input  wire                head_a,      // read a node of A, bytes 0 ... 31
  input  wire [SETS+1:0]     head_slot_a, // its slot
  input  wire                read_a,      // read a node of A, bytes 32 ... 127
  input  wire [SETS+1:0]     slot_a,      // its slot
  output wire [1023:0]       node_a,      // from the next cycle on
  input  wire                head_b,      // read a node of B, bytes 0 ... 31
  input  wire [SETS+1:0]     head_slot_b, // its slot
  input  wire                read_b,      // read a node of B, bytes 32 ... 127
  input  wire [SETS+1:0]     slot_b,      // its slot
  output wire [1023:0]       node_b,      // from the next cycle on
  output wire                miss_valid,  // a burst of 8 beats is wanted
  input  wire                miss_ready,  // it is taken
  output wire [ADDRESS-5:0]  miss_address, // in units of 16 bytes
  output wire [SETS+2:0]     miss_tag,    // comes back with it: {of B, slot}
  input  wire                fill,        // a beat has come
  input  wire [127:0]        fill_data,   // its data
  input  wire [2:0]          fill_beat,   // its number
  input  wire                fill_last,   // the last of its burst
  input  wire                fill_error,  // with an error
  input  wire [SETS+2:0]     fill_tag     // that of the burst
);
  localparam BLOCK = ADDRESS - 7; // bits of a node's address in units of 128 bytes
  wire [BLOCK-1:0] block_a = {base_a, 5'd0} + {{(BLOCK-23){1'b0}}, in_a};
  wire [BLOCK-1:0] block_b = {base_b, 5'd0} + {{(BLOCK-23){1'b0}}, in_b};
  wire [BLOCK-1:0] block;
  wire             is_b = fill_tag[SETS+2];
  reg              error_q; // an earlier beat of the burst came with an error

  assign miss_address = {block, 3'd0};

  sepax_cache #(.ADDRESS(BLOCK), .INFO(INFO), .SETS(SETS), .WINDOW(WINDOW)) cache (
    .clk(clk), .rst(rst), .start(start), .cold(cold), .drop(drop),
    .in_valid(in_valid), .in_ready(in_ready), .in_a(block_a), .in_b(block_b), .in_info(in_info),
    .out_valid(out_valid), .out_ready(out_ready), .out_a(out_a), .out_b(out_b),
    .out_info(out_info), .out_error(out_error), .done(done), .miss_valid(miss_valid),
    .miss_ready(miss_ready), .miss_is_b(miss_tag[SETS+2]), .miss_address(block),
    .miss_slot(miss_tag[SETS+1:0]), .filled(fill && fill_last), .filled_is_b(is_b),
    .filled_error(fill_error || error_q)
  );

  genvar k;
  generate
    for (k = 0; k < 8; k = k + 1) begin : beat
      wire write = fill && (fill_beat == k[2:0]);
      sepax_ram #(.WIDTH(128), .ADDRESS(SETS+2), .DISTRIBUTED(k < 2)) nodes_a ( //@ fpga
      sepax_ram #(.WIDTH(128), .ADDRESS(SETS+2)) nodes_a ( //@ !fpga
        .clk(clk), .write(write && !is_b), .write_address(fill_tag[SETS+1:0]),
        .write_data(fill_data), .read(k < 2 ? head_a : read_a),
        .read_address(k < 2 ? head_slot_a : slot_a),
        .read_data(node_a[128*k +: 128])
      );
      sepax_ram #(.WIDTH(128), .ADDRESS(SETS+2), .DISTRIBUTED(k < 2)) nodes_b ( //@ fpga
      sepax_ram #(.WIDTH(128), .ADDRESS(SETS+2)) nodes_b ( //@ !fpga
        .clk(clk), .write(write && is_b), .write_address(fill_tag[SETS+1:0]),
        .write_data(fill_data), .read(k < 2 ? head_b : read_b),
        .read_address(k < 2 ? head_slot_b : slot_b),
        .read_data(node_b[128*k +: 128])
      );
    end
  endgenerate

  always @(posedge clk) begin
    if (rst) begin
      error_q <= 1'b0;
    end else if (fill) begin
      error_q <= !fill_last && (fill_error || error_q);
    end
  end
endmodule
