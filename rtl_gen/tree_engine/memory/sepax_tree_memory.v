// SPDX-License-Identifier: MIT
// Reads nodes and leaves of bodies A and B from external memory, through caches and one AXI4 read
// port; leaves become triangles (docs/reference/tree-engine.md, Memory side). Nodes and leaves are
// asked for in pairs, one of A and one of B. A pair comes out when both are here, in the order in
// which the pairs went in. Both stay here until the pair is released; pairs are released in order.
// A slot may be read in any cycle between out and release. The host reads jobs and poses through
// the same port: its bursts go last, and their beats come out as they are.
module sepax_tree_memory #(
  parameter W = 18,          // bits of a coordinate, 4 ... 21
  parameter ADDRESS = 40,    // bits of a byte address, 37 ... 64
  parameter NODE_INFO = 32,  // bits that go with a pair of nodes
  parameter LEAF_INFO = 64,  // bits that go with a pair of leaves
  parameter NODE_SETS = 4,   // log2 of the sets of 4 nodes a body
  parameter LEAF_SETS = 1,   // log2 of the sets of 4 leaves a body, less than NODE_SETS
  parameter NODE_WINDOW = 5, // log2 of the most pairs of nodes between in and release
  parameter LEAF_WINDOW = 3, // log2 of the most pairs of leaves between in and release
  parameter OPEN = 4         // log2 of the most open bursts
) (
  input  wire                  clk,             // clock
  input  wire                  rst,             // synchronous reset, active high; AXI's, too
  input  wire                  start,           // a run begins; only while idle and no pair goes in
  input  wire                  cold,            // with start: empty the caches
  input  wire                  drop,            // the run ends: drop all pairs
  output wire                  idle,            // no burst is open but the host's
  input  wire [ADDRESS-13:0]   base_a,          // A's image / 4096; does not change in a run
  input  wire [ADDRESS-13:0]   base_b,          // B's image / 4096; does not change in a run
  // pairs of nodes in, out; release
  input  wire                  node_in_valid,   // a pair is wanted; stays 1 until taken or dropped
  output wire                  node_in_ready,   // it is taken in this cycle
  input  wire [22:0]           node_in_a,       // number of A's node
  input  wire [22:0]           node_in_b,       // number of B's node
  input  wire [NODE_INFO-1:0]  node_in_info,    // bits that go with the pair
  output wire                  node_out_valid,  // the oldest pair is here, or has an error
  input  wire                  node_out_ready,  // it is taken in this cycle
  output wire [NODE_SETS+1:0]  node_out_a,      // slot of A's node
  output wire [NODE_SETS+1:0]  node_out_b,      // slot of B's node
  output wire [NODE_INFO-1:0]  node_out_info,   // the bits that went in with the pair
  output wire                  node_out_error,  // SLVERR or DECERR: a node was not read
  input  wire                  node_release,    // the oldest pair that was taken is released
  // nodes: each part is valid from the cycle after its read on until the body's next read
  input  wire                  head_read_a,     // read a node of A, bytes 0 ... 31
  input  wire [NODE_SETS+1:0]  head_slot_a,     // slot of the node
  //@ if fpga
  output wire [255:0]          node_a,          // byte 0 lowest
  //@ else
  input  wire                  node_read_a,     // read a node of A, bytes 32 ... 127
  input  wire [NODE_SETS+1:0]  node_slot_a,     // slot of the node
  output wire [1023:0]         node_a,          // both parts, byte 0 lowest
  //@ end
  input  wire                  head_read_b,     // read a node of B, bytes 0 ... 31
  input  wire [NODE_SETS+1:0]  head_slot_b,     // slot of the node
  //@ if fpga
  output wire [255:0]          node_b,          // byte 0 lowest
  input  wire                  box_read,        // read the box of a node's child
  input  wire [NODE_SETS+2:0]  box_slot,        // {is B's, slot} of the node
  input  wire [3:0]            box_index,       // number of the child
  output wire [47:0]           box,             // {high z, y, x, low z, y, x}, 3 cycles later
  input  wire                  boxes_read,      // read all boxes of a node, bytes 32 ... 127
  input  wire [NODE_SETS+2:0]  boxes_slot,      // {is B's, slot}
  output wire [767:0]          boxes,           // the boxes, from the second cycle after it
  //@ else
  input  wire                  node_read_b,     // read a node of B, bytes 32 ... 127
  input  wire [NODE_SETS+1:0]  node_slot_b,     // slot of the node
  output wire [1023:0]         node_b,          // both parts
  //@ end
  // pairs of leaves in, out; release
  input  wire                  leaf_in_valid,   // a pair is wanted; stays 1 until taken or dropped
  output wire                  leaf_in_ready,   // it is taken in this cycle
  input  wire [31:0]           leaf_in_a,       // place of A's record in the image, in beats
  input  wire [3:0]            leaf_in_beats_a, // beats of A's record less 1, 2 ... 15
  input  wire [31:0]           leaf_in_b,       // place of B's record in the image, in beats
  input  wire [3:0]            leaf_in_beats_b, // beats of B's record less 1, 2 ... 15
  input  wire [LEAF_INFO-1:0]  leaf_in_info,    // bits that go with the pair
  output wire                  leaf_out_valid,  // the oldest pair is here, or has an error
  input  wire                  leaf_out_ready,  // it is taken in this cycle
  output wire [LEAF_SETS+1:0]  leaf_out_a,      // slot of A's leaf
  output wire [LEAF_SETS+1:0]  leaf_out_b,      // slot of B's leaf
  output wire [LEAF_INFO-1:0]  leaf_out_info,   // the bits that went in with the pair
  output wire                  leaf_out_error,  // SLVERR or DECERR: a leaf was not read
  input  wire                  leaf_release,    // the oldest pair that was taken is released
  // triangles: valid from the cycle after the read on until the body's next read
  input  wire                  triangle_read_a, // read a triangle of A
  input  wire [LEAF_SETS+5:0]  triangle_slot_a, // {slot of its leaf, its number in the leaf}
  output wire [9*W:0]          triangle_a,      // {damaged, z, y, x of vertex 2, of 1, of 0}
  input  wire                  triangle_read_b, // read a triangle of B
  input  wire [LEAF_SETS+5:0]  triangle_slot_b, // {slot of its leaf, its number in the leaf}
  output wire [9*W:0]          triangle_b,      // {damaged, z, y, x of vertex 2, of 1, of 0}
  input  wire                  corners_read_b,  // read the vertex numbers of a triangle of B
  input  wire [LEAF_SETS+5:0]  corners_slot_b,  // {slot of its leaf, its number in the leaf}
  output wire [14:0]           corners_b,       // {number of vertex 2, of 1, of 0} in the leaf
  // bursts of the host
  input  wire                  host_valid,      // a burst is wanted
  output wire                  host_ready,      // it is taken in this cycle
  input  wire [ADDRESS-5:0]    host_address,    // place of its first beat, in units of 16 bytes
  input  wire [3:0]            host_beats,      // its beats less 1; it does not cross 4 KB
  output wire                  host_fill,       // a beat of the host has come
  output wire [127:0]          host_data,       // the beat
  output wire [3:0]            host_beat,       // its number in the burst
  output wire                  host_last,       // the last beat of its burst
  output wire                  host_error,      // it came with an error
  // AXI4, 128 bits, read only: ARSIZE 4, ARBURST INCR, one ID
  output wire                  arvalid,         // an address
  input  wire                  arready,         // it is taken in this cycle
  output wire [ADDRESS-1:0]    araddr,          // byte address, a multiple of 16
  output wire [7:0]            arlen,           // beats less 1, 0 ... 15
  input  wire                  rvalid,          // a beat
  output wire                  rready,          // it is taken in this cycle
  input  wire [127:0]          rdata,           // its data
  input  wire [1:0]            rresp,           // 0: OKAY; otherwise an error
  input  wire                  rlast            // the last beat of its burst
);
  localparam TAG = NODE_SETS + 5; // bits of a burst's tag: {a leaf's, the host's, is B's, slot}
  wire                 leaf_idle, read_idle;
  wire                 node_miss, leaf_miss, read_ready;
  wire [ADDRESS-5:0]   node_address, leaf_address;
  wire [3:0]           leaf_beats;
  wire [NODE_SETS+2:0] node_tag;
  wire [LEAF_SETS+2:0] leaf_tag;
  //@ if fpga
  reg                  fill, fill_last, fill_error;
  reg  [127:0]         fill_data;
  reg  [3:0]           fill_beat;
  reg  [TAG-1:0]       fill_tag;
  //@ else
  wire                 fill, fill_last, fill_error;
  wire [127:0]         fill_data;
  wire [3:0]           fill_beat;
  wire [TAG-1:0]       fill_tag;
  //@ end
  wire                 of_leaf = fill_tag[TAG-1];
  wire                 of_host = fill_tag[TAG-2];
  wire [119:0]         numbers;   // a beat as vertex numbers
  wire [3*W-1:0]       even, odd; // a beat as two vertices
  wire                 busy;      // no other record may begin to come

  assign idle = leaf_idle && read_idle;
  assign host_fill = fill && of_host;
  assign {host_data, host_beat, host_last, host_error} = {
    fill_data, fill_beat, fill_last, fill_error
  };
  //@ if fpga
  // Registers before and after the read master. A request that waits in them for more than a cycle
  // finds an open burst, so `idle` does not miss it.
  reg                  node_asked_q, leaf_asked_q; // bursts that wait
  reg  [ADDRESS-5:0]   node_address_q, leaf_address_q;
  reg  [3:0]           leaf_beats_q;
  reg  [NODE_SETS+2:0] node_tag_q;
  reg  [LEAF_SETS+2:0] leaf_tag_q;
  wire                 read_fill, read_last, read_error;
  wire [127:0]         read_data;
  wire [3:0]           read_beat;
  wire [TAG-1:0]       read_tag;

  always @(posedge clk) begin
    if (rst) begin
      {node_asked_q, leaf_asked_q, fill} <= 3'd0;
    end else begin
      node_asked_q <= node_asked_q ? !read_ready || leaf_asked_q : node_miss;
      leaf_asked_q <= leaf_asked_q ? !read_ready : leaf_miss;
      fill <= read_fill;
    end
    if (!node_asked_q) begin
      {node_address_q, node_tag_q} <= {node_address, node_tag};
    end
    if (!leaf_asked_q) begin
      {leaf_address_q, leaf_beats_q, leaf_tag_q} <= {leaf_address, leaf_beats, leaf_tag};
    end
    {fill_last, fill_error, fill_data, fill_beat, fill_tag} <= {
      read_last, read_error, read_data, read_beat, read_tag
    };
  end
  //@ end

  assign host_ready = read_ready && !leaf_asked_q && !node_asked_q; //@ fpga
  assign host_ready = read_ready && !leaf_miss && !node_miss; //@ !fpga

  genvar k;
  generate
    for (k = 0; k < 8; k = k + 1) begin : triangle
      assign numbers[15*k +: 15] = fill_data[16*k +: 15];
    end
    for (k = 0; k < 3; k = k + 1) begin : axis
      assign even[W*k +: W] = fill_data[21*k +: W];
      assign odd[W*k +: W] = fill_data[64+21*k +: W];
    end
  endgenerate

  sepax_node_cache #(
    .W(W), .ADDRESS(ADDRESS), .INFO(NODE_INFO), .SETS(NODE_SETS), .WINDOW(NODE_WINDOW)
  ) nodes (
    .clk(clk), .rst(rst), .start(start), .cold(cold), .drop(drop),
    .base_a(base_a), .base_b(base_b), .in_valid(node_in_valid), .in_ready(node_in_ready),
    .in_a(node_in_a), .in_b(node_in_b), .in_info(node_in_info), .out_valid(node_out_valid),
    .out_ready(node_out_ready), .out_a(node_out_a), .out_b(node_out_b), .out_info(node_out_info),
    .out_error(node_out_error), .done(node_release), .head_a(head_read_a),
    //@ if fpga
    .head_slot_a(head_slot_a), .node_a(node_a), .head_b(head_read_b), .head_slot_b(head_slot_b),
    .node_b(node_b), .box_read(box_read), .box_slot(box_slot), .box_index(box_index), .box(box),
    .boxes_read(boxes_read), .boxes_slot(boxes_slot), .boxes(boxes),
    //@ else
    .head_slot_a(head_slot_a), .read_a(node_read_a), .slot_a(node_slot_a), .node_a(node_a),
    .head_b(head_read_b), .head_slot_b(head_slot_b), .read_b(node_read_b), .slot_b(node_slot_b),
    .node_b(node_b),
    //@ end
    //@ if fpga
    .miss_valid(node_miss), .miss_ready(!node_asked_q), .miss_address(node_address),
    //@ else
    .miss_valid(node_miss), .miss_ready(read_ready && !leaf_miss), .miss_address(node_address),
    //@ end
    .miss_tag(node_tag), .fill(fill && !of_leaf && !of_host), .fill_data(fill_data),
    .fill_beat(fill_beat[2:0]), .fill_last(fill_last), .fill_error(fill_error),
    .fill_tag(fill_tag[NODE_SETS+2:0])
  );
  sepax_leaf_buffers #(
    .W(W), .ADDRESS(ADDRESS), .INFO(LEAF_INFO), .SETS(LEAF_SETS), .WINDOW(LEAF_WINDOW)
  ) leaves (
    .clk(clk), .rst(rst), .start(start), .cold(cold), .drop(drop),
    .base_a(base_a), .base_b(base_b), .in_valid(leaf_in_valid), .in_ready(leaf_in_ready),
    .in_a(leaf_in_a), .in_beats_a(leaf_in_beats_a), .in_b(leaf_in_b),
    .in_beats_b(leaf_in_beats_b), .in_info(leaf_in_info), .out_valid(leaf_out_valid),
    .out_ready(leaf_out_ready), .out_a(leaf_out_a), .out_b(leaf_out_b), .out_info(leaf_out_info),
    .out_error(leaf_out_error), .done(leaf_release), .read_a(triangle_read_a),
    .slot_a(triangle_slot_a), .triangle_a(triangle_a), .read_b(triangle_read_b),
    .slot_b(triangle_slot_b), .triangle_b(triangle_b), .corners_read_b(corners_read_b),
    .corners_slot_b(corners_slot_b), .corners_b(corners_b), .miss_valid(leaf_miss),
    .miss_ready(read_ready), .miss_address(leaf_address), .miss_beats(leaf_beats), //@ !fpga
    .miss_ready(!leaf_asked_q), .miss_address(leaf_address), .miss_beats(leaf_beats), //@ fpga
    .miss_tag(leaf_tag), .fill(fill && of_leaf), .fill_numbers(numbers), .fill_even(even),
    .fill_odd(odd), .fill_beat(fill_beat), .fill_last(fill_last), .fill_error(fill_error),
    .fill_tag(fill_tag[LEAF_SETS+2:0]), .busy(busy), .idle(leaf_idle)
  );
  // Leaves go first, because the cores wait for them. The host goes last, because it reads ahead.
  sepax_axi_read #(.ADDRESS(ADDRESS), .TAG(TAG), .OPEN(OPEN)) read (
    //@ if fpga
    .clk(clk), .rst(rst), .in_valid(leaf_asked_q || node_asked_q || host_valid),
    .in_ready(read_ready),
    .in_address(leaf_asked_q ? leaf_address_q : node_asked_q ? node_address_q : host_address),
    .in_beats(leaf_asked_q ? leaf_beats_q : node_asked_q ? 4'd7 : host_beats),
    .in_tag(leaf_asked_q ? {2'b10, {(NODE_SETS-LEAF_SETS){1'b0}}, leaf_tag_q}
                         : {1'b0, !node_asked_q, node_tag_q}),
    .pause(busy), .out_valid(read_fill),
    .out_data(read_data), .out_beat(read_beat), .out_last(read_last), .out_error(read_error),
    .out_tag(read_tag), .idle(read_idle),
    //@ else
    .clk(clk), .rst(rst), .in_valid(leaf_miss || node_miss || host_valid), .in_ready(read_ready),
    .in_address(leaf_miss ? leaf_address : node_miss ? node_address : host_address),
    .in_beats(leaf_miss ? leaf_beats : node_miss ? 4'd7 : host_beats),
    .in_tag(leaf_miss ? {2'b10, {(NODE_SETS-LEAF_SETS){1'b0}}, leaf_tag}
                      : {1'b0, !node_miss, node_tag}),
    .pause(busy), .out_valid(fill), .out_data(fill_data), .out_beat(fill_beat),
    .out_last(fill_last), .out_error(fill_error), .out_tag(fill_tag), .idle(read_idle),
    //@ end
    .arvalid(arvalid), .arready(arready), .araddr(araddr), .arlen(arlen), .rvalid(rvalid),
    .rready(rready), .rdata(rdata), .rresp(rresp), .rlast(rlast)
  );
endmodule
