// SPDX-License-Identifier: MIT
//@ if fpga
// The cache of nodes: 128 bytes each, 2^SETS sets of 4 nodes for each body. Each body has a memory
// for its heads, the first 32 bytes. The boxes of both bodies are stored twice: all 16 of a node
// side by side, and in units of 16 bits, three for each box.
//@ else
// The cache of nodes: 128 bytes each, 2^SETS sets of 4 nodes for each body. Each body has a memory
// of its own, which is 128 bytes wide. The first 32 bytes of a node, its head, are read separately.
//@ end
// Of a head, only the bits that the engine reads are kept; the others are read as 0.
module sepax_node_cache #(
  parameter W = 18,       // bits of a coordinate, 4 ... 21
  parameter ADDRESS = 40, // bits of a byte address
  parameter INFO = 32,    // bits that go with a pair
  parameter SETS = 4,     // log2 of the sets of 4 nodes a body
  parameter WINDOW = 5    // log2 of the most pairs between in and release
) (
  input  wire                clk,         // clock
  input  wire                rst,         // synchronous reset, active high
  input  wire                start,       // drop all pairs; no node may be on its way
  input  wire                cold,        // with start: empty the cache
  input  wire                drop,        // drop all pairs
  input  wire [ADDRESS-13:0] base_a,      // A's image / 4096
  input  wire [ADDRESS-13:0] base_b,      // B's image / 4096
  input  wire                in_valid,    // a pair is wanted; stays 1 until in_ready or drop
  output wire                in_ready,    // it is taken in this cycle
  input  wire [22:0]         in_a,        // number of A's node
  input  wire [22:0]         in_b,        // number of B's node
  input  wire [INFO-1:0]     in_info,     // bits that go with the pair
  output wire                out_valid,   // the oldest pair is here, or has an error
  input  wire                out_ready,   // it is taken in this cycle
  output wire [SETS+1:0]     out_a,       // slot of A's node
  output wire [SETS+1:0]     out_b,       // slot of B's node
  output wire [INFO-1:0]     out_info,    // the bits that went in with the pair
  output wire                out_error,   // a node of the pair was not read
  input  wire                done,        // the oldest pair is released
  input  wire                head_a,      // read a node of A, bytes 0 ... 31
  input  wire [SETS+1:0]     head_slot_a, // slot of the node
  //@ if fpga
  output wire [255:0]        node_a,      // the data, from the next cycle on
  //@ else
  input  wire                read_a,      // read a node of A, bytes 32 ... 127
  input  wire [SETS+1:0]     slot_a,      // slot of the node
  output wire [1023:0]       node_a,      // the data, from the next cycle on
  //@ end
  input  wire                head_b,      // read a node of B, bytes 0 ... 31
  input  wire [SETS+1:0]     head_slot_b, // slot of the node
  //@ if fpga
  output wire [255:0]        node_b,      // the data, from the next cycle on
  input  wire                box_read,    // read a child's box
  input  wire [SETS+2:0]     box_slot,    // {is B's, slot} of the node
  input  wire [3:0]          box_index,   // number of the child
  output reg  [47:0]         box,         // the box, 3 cycles later
  input  wire                boxes_read,  // read all boxes of a node
  input  wire [SETS+2:0]     boxes_slot,  // {is B's, slot}
  output reg  [767:0]        boxes,       // the boxes, from the second cycle on
  //@ else
  input  wire                read_b,      // read a node of B, bytes 32 ... 127
  input  wire [SETS+1:0]     slot_b,      // slot of the node
  output wire [1023:0]       node_b,      // the data, from the next cycle on
  //@ end
  output wire                miss_valid,  // a burst of 8 beats is wanted
  input  wire                miss_ready,  // it is taken in this cycle
  output wire [ADDRESS-5:0]  miss_address, // place of its first beat, in units of 16 bytes
  output wire [SETS+2:0]     miss_tag,    // tag that comes back with the data: {is B's, slot}
  input  wire                fill,        // a beat has come
  input  wire [127:0]        fill_data,   // its data
  input  wire [2:0]          fill_beat,   // number of the beat in its burst
  input  wire                fill_last,   // the last beat of its burst
  input  wire                fill_error,  // the beat came with an error
  input  wire [SETS+2:0]     fill_tag     // tag of the burst
);
  localparam BLOCK = ADDRESS - 7; // bits of a node's address in units of 128 bytes
  wire [BLOCK-1:0] block_a = {base_a, 5'd0} + {{(BLOCK-23){1'b0}}, in_a};
  wire [BLOCK-1:0] block_b = {base_b, 5'd0} + {{(BLOCK-23){1'b0}}, in_b};
  wire [BLOCK-1:0] block;
  wire             is_b = fill_tag[SETS+2];
  reg              error_q; // an earlier beat of the burst came with an error
  localparam HEAD = 3 * W + 24; // bits that are kept of the first beat
  wire [HEAD-1:0]  head_in = {
    fill_data[119:96], fill_data[64 +: W], fill_data[32 +: W], fill_data[0 +: W]
  };
  wire [87:0]      rest_in = {fill_data[119:96], fill_data[63:0]}; // of the second beat
  wire             write_head = fill && (fill_beat == 3'd0);
  wire             write_rest = fill && (fill_beat == 3'd1);
  wire [HEAD-1:0]  head_out_a, head_out_b;
  wire [87:0]      rest_out_a, rest_out_b;

  assign node_a[255:0] = {
    8'd0, rest_out_a[87:64], 32'd0, rest_out_a[63:0], 8'd0, head_out_a[3*W +: 24],
    {(32-W){1'b0}}, head_out_a[2*W +: W], {(32-W){1'b0}}, head_out_a[W +: W],
    {(32-W){1'b0}}, head_out_a[0 +: W]
  };
  assign node_b[255:0] = {
    8'd0, rest_out_b[87:64], 32'd0, rest_out_b[63:0], 8'd0, head_out_b[3*W +: 24],
    {(32-W){1'b0}}, head_out_b[2*W +: W], {(32-W){1'b0}}, head_out_b[W +: W],
    {(32-W){1'b0}}, head_out_b[0 +: W]
  };
  sepax_ram #(.WIDTH(HEAD), .ADDRESS(SETS+2), .DISTRIBUTED(1)) heads_a ( //@ fpga
  sepax_ram #(.WIDTH(HEAD), .ADDRESS(SETS+2)) heads_a ( //@ !fpga
    .clk(clk), .write(write_head && !is_b), .write_address(fill_tag[SETS+1:0]),
    .write_data(head_in), .read(head_a), .read_address(head_slot_a), .read_data(head_out_a)
  );
  sepax_ram #(.WIDTH(HEAD), .ADDRESS(SETS+2), .DISTRIBUTED(1)) heads_b ( //@ fpga
  sepax_ram #(.WIDTH(HEAD), .ADDRESS(SETS+2)) heads_b ( //@ !fpga
    .clk(clk), .write(write_head && is_b), .write_address(fill_tag[SETS+1:0]),
    .write_data(head_in), .read(head_b), .read_address(head_slot_b), .read_data(head_out_b)
  );
  sepax_ram #(.WIDTH(88), .ADDRESS(SETS+2), .DISTRIBUTED(1)) rests_a ( //@ fpga
  sepax_ram #(.WIDTH(88), .ADDRESS(SETS+2)) rests_a ( //@ !fpga
    .clk(clk), .write(write_rest && !is_b), .write_address(fill_tag[SETS+1:0]),
    .write_data(rest_in), .read(head_a), .read_address(head_slot_a), .read_data(rest_out_a)
  );
  sepax_ram #(.WIDTH(88), .ADDRESS(SETS+2), .DISTRIBUTED(1)) rests_b ( //@ fpga
  sepax_ram #(.WIDTH(88), .ADDRESS(SETS+2)) rests_b ( //@ !fpga
    .clk(clk), .write(write_rest && is_b), .write_address(fill_tag[SETS+1:0]),
    .write_data(rest_in), .read(head_b), .read_address(head_slot_b), .read_data(rest_out_b)
  );

  assign miss_address = {block, 3'd0};

  sepax_cache #(
    .ADDRESS(BLOCK), .INFO(INFO), .QUICK(1), .SETS(SETS), .WINDOW(WINDOW)
  ) cache (
    .clk(clk), .rst(rst), .start(start), .cold(cold), .drop(drop),
    .in_valid(in_valid), .in_ready(in_ready), .in_a(block_a), .in_b(block_b), .in_info(in_info),
    .out_valid(out_valid), .out_ready(out_ready), .out_a(out_a), .out_b(out_b),
    .out_info(out_info), .out_error(out_error), .done(done), .miss_valid(miss_valid),
    .miss_ready(miss_ready), .miss_is_b(miss_tag[SETS+2]), .miss_address(block),
    .miss_slot(miss_tag[SETS+1:0]), .filled(fill && fill_last), .filled_is_b(is_b),
    .filled_error(fill_error || error_q)
  );

//@ if fpga
  // Boxes are written a cycle later than heads. This is early enough, because a box is read long
  // after its beat has come.
  reg              fill_q;
  reg  [2:0]       beat_q;
  reg  [SETS+2:0]  tag_q;
  reg  [127:0]     data_q;
  reg  [7:0]       first_q, first_q2; // one-hot: the unit that a box begins with, modulo 8
  wire [127:0]     words;             // the units of a box and their neighbours
  reg  [127:0]     words_q;
  wire [767:0]     all;

  genvar i, j, k;
  generate
    for (k = 0; k < 6; k = k + 1) begin : beat
      localparam [2:0] BEAT = k + 2;
      sepax_ram #(.WIDTH(128), .ADDRESS(SETS+3)) of_nodes (
        .clk(clk), .write(fill_q && (beat_q == BEAT)), .write_address(tag_q),
        .write_data(data_q), .read(boxes_read), .read_address(boxes_slot),
        .read_data(all[128*k +: 128])
      );
    end
    // Box j is units 3 j ... 3 j + 2 after the head. Unit u is unit u mod 8 of beat 2 + u / 8.
    for (k = 0; k < 8; k = k + 1) begin : unit
      wire [2:0] beat_of [0:15]; // for each box the beat of its unit with this number
      for (j = 0; j < 16; j = j + 1) begin : of_child
        localparam [31:0] AT = (3 * j + 23 - k) / 8;
        assign beat_of[j] = AT[2:0];
      end
      sepax_ram #(.WIDTH(16), .ADDRESS(SETS+6)) of_beats (
        .clk(clk), .write(fill_q), .write_address({tag_q, beat_q}),
        .write_data(data_q[16*k +: 16]), .read(box_read),
        .read_address({box_slot, beat_of[box_index]}), .read_data(words[16*k +: 16])
      );
      localparam [31:0] CHILD = (3 * k) % 8; // box number, modulo 8, of this first unit
      always @(posedge clk) begin
        first_q[k] <= box_index[2:0] == CHILD[2:0];
      end
    end
    for (i = 0; i < 48; i = i + 1) begin : box_bit
      wire [7:0] here;
      for (k = 0; k < 8; k = k + 1) begin : of_unit
        assign here[k] = words_q[16*k+i%16] && first_q2[(k+8-i/16)%8];
      end
      always @(posedge clk) begin
        box[i] <= |here;
      end
    end
  endgenerate

  always @(posedge clk) begin
    fill_q <= fill && !rst;
    beat_q <= fill_beat;
    tag_q <= fill_tag;
    data_q <= fill_data;
    first_q2 <= first_q;
    words_q <= words;
    boxes <= all;
  end
//@ else
  genvar k;
  generate
    for (k = 2; k < 8; k = k + 1) begin : beat
      wire write = fill && (fill_beat == k[2:0]);
      sepax_ram #(.WIDTH(128), .ADDRESS(SETS+2)) nodes_a (
        .clk(clk), .write(write && !is_b), .write_address(fill_tag[SETS+1:0]),
        .write_data(fill_data), .read(read_a), .read_address(slot_a),
        .read_data(node_a[128*k +: 128])
      );
      sepax_ram #(.WIDTH(128), .ADDRESS(SETS+2)) nodes_b (
        .clk(clk), .write(write && is_b), .write_address(fill_tag[SETS+1:0]),
        .write_data(fill_data), .read(read_b), .read_address(slot_b),
        .read_data(node_b[128*k +: 128])
      );
    end
  endgenerate
//@ end

  always @(posedge clk) begin
    if (rst) begin
      error_q <= 1'b0;
    end else if (fill) begin
      error_q <= !fill_last && (fill_error || error_q);
    end
  end
endmodule
