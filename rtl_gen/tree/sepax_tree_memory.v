// What the tree engine reads of external memory: nodes, and leaves as triangles, of bodies A and
// B, through caches, by one AXI4 read port. They are asked for in pairs, one of A and one of B.
// Pairs come out in the order in which they went in, when both are here. What a pair needs stays
// until the pair is released; pairs are released in order.
module sepax_tree_memory #(
  parameter W = 18,          // bits of a coordinate, 4 ... 21
  parameter ADDRESS = 40,    // bits of a byte address, 36 ... 64
  parameter NODE_INFO = 32,  // bits that go with a pair of nodes
  parameter LEAF_INFO = 64,  // bits that go with a pair of leaves
  parameter NODE_SETS = 4,   // log2 of the sets of 4 nodes a body
  parameter LEAF_SETS = 1,   // log2 of the sets of 4 leaves a body
  parameter NODE_WINDOW = 5, // log2 of the pairs of nodes that are in and not released
  parameter LEAF_WINDOW = 3, // log2 of the pairs of leaves that are in and not released
  parameter OPEN = 4         // log2 of the open bursts
) (
  input  wire                  clk,             // clock
  input  wire                  rst,             // synchronous reset, active high; AXI's, too
  input  wire                  start,           // a run begins; only while idle, no pair going in
  input  wire                  cold,            // with start: forget what the caches have
  input  wire                  drop,            // the run ends: drop all pairs
  output wire                  idle,            // nothing is looked up, no burst is open
  input  wire [ADDRESS-13:0]   base_a,          // A's image / 4096; stands in a run
  input  wire [ADDRESS-13:0]   base_b,          // B's
  // pairs of nodes in, out; release
  input  wire                  node_in_valid,   // a pair of nodes is wanted
  output wire                  node_in_ready,   // it is taken
  input  wire [22:0]           node_in_a,       // number of A's node
  input  wire [22:0]           node_in_b,       // number of B's node
  input  wire [NODE_INFO-1:0]  node_in_info,    // goes with the pair
  output wire                  node_out_valid,  // the oldest pair is here, or an error
  input  wire                  node_out_ready,  // it is taken
  output wire [NODE_SETS+1:0]  node_out_a,      // slot of A's node
  output wire [NODE_SETS+1:0]  node_out_b,      // slot of B's node
  output wire [NODE_INFO-1:0]  node_out_info,   // what went with it
  output wire                  node_out_error,  // SLVERR or DECERR: one of the nodes is not here
  input  wire                  node_release,    // the oldest pair that was taken is done with
  // nodes: one stands from the cycle after its read on until the next read of the same body
  input  wire                  node_read_a,     // read a node of A
  input  wire [NODE_SETS+1:0]  node_slot_a,     // its slot
  output wire [1023:0]         node_a,          // its 128 bytes, byte 0 lowest
  input  wire                  node_read_b,     // read a node of B
  input  wire [NODE_SETS+1:0]  node_slot_b,     // its slot
  output wire [1023:0]         node_b,          // its 128 bytes
  // pairs of leaves in, out; release
  input  wire                  leaf_in_valid,   // a pair of leaves is wanted
  output wire                  leaf_in_ready,   // it is taken
  input  wire [31:0]           leaf_in_a,       // A's record: where in the image, / 16
  input  wire [3:0]            leaf_in_beats_a, // its beats less 1, 2 ... 15; not across 4096 bytes
  input  wire [31:0]           leaf_in_b,       // B's record
  input  wire [3:0]            leaf_in_beats_b, // its beats less 1
  input  wire [LEAF_INFO-1:0]  leaf_in_info,    // goes with the pair
  output wire                  leaf_out_valid,  // the oldest pair is here, or an error
  input  wire                  leaf_out_ready,  // it is taken
  output wire [LEAF_SETS+1:0]  leaf_out_a,      // slot of A's leaf
  output wire [LEAF_SETS+1:0]  leaf_out_b,      // slot of B's leaf
  output wire [LEAF_INFO-1:0]  leaf_out_info,   // what went with it
  output wire                  leaf_out_error,  // SLVERR or DECERR: one of the leaves is not here
  input  wire                  leaf_release,    // the oldest pair that was taken is done with
  // triangles: one stands from the cycle after its read on until the next read of the same body
  input  wire                  triangle_read_a, // read a triangle of A
  input  wire [LEAF_SETS+5:0]  triangle_slot_a, // {slot of its leaf, its number there}
  output wire [9*W:0]          triangle_a,      // {damaged, z, y, x of vertex 2, of 1, of 0}
  input  wire                  triangle_read_b, // read a triangle of B
  input  wire [LEAF_SETS+5:0]  triangle_slot_b, // {slot of its leaf, its number there}
  output wire [9*W:0]          triangle_b,      // {damaged, z, y, x of vertex 2, of 1, of 0}
  // AXI4, 128 bits, read only: ARSIZE 4, ARBURST INCR, one ID
  output wire                  arvalid,         // an address
  input  wire                  arready,         // it is taken
  output wire [ADDRESS-1:0]    araddr,          // byte address, a multiple of 16
  output wire [7:0]            arlen,           // beats less 1, 0 ... 15
  input  wire                  rvalid,          // a beat
  output wire                  rready,          // it is taken
  input  wire [127:0]          rdata,           // its data
  input  wire [1:0]            rresp,           // 2, 3: error
  input  wire                  rlast            // the last of its burst
);
endmodule
