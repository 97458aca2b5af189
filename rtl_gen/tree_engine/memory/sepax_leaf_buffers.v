// SPDX-License-Identifier: MIT
// The cache of leaves, as triangles: 16 triangles a leaf, 2^SETS sets of 4 leaves for each body.
// Each body has a memory of its own, which is a triangle wide.
module sepax_leaf_buffers #(
  parameter W = 18,       // bits of a coordinate, 4 ... 21
  parameter ADDRESS = 40, // bits of a byte address
  parameter INFO = 64,    // bits that go with a pair
  parameter SETS = 1,     // log2 of the sets of 4 leaves a body
  parameter WINDOW = 3    // log2 of the most pairs between in and release
) (
  input  wire                clk,          // clock
  input  wire                rst,          // synchronous reset, active high
  input  wire                start,        // drop all pairs; no leaf may be on its way
  input  wire                cold,         // with start: empty the buffers
  input  wire                drop,         // drop all pairs
  input  wire [ADDRESS-13:0] base_a,       // A's image / 4096
  input  wire [ADDRESS-13:0] base_b,       // B's image / 4096
  input  wire                in_valid,     // a pair is wanted; stays 1 until in_ready or drop
  output wire                in_ready,     // it is taken in this cycle
  input  wire [31:0]         in_a,         // place of A's record in the image, in beats
  input  wire [3:0]          in_beats_a,   // beats of A's record less 1
  input  wire [31:0]         in_b,         // place of B's record in the image, in beats
  input  wire [3:0]          in_beats_b,   // beats of B's record less 1
  input  wire [INFO-1:0]     in_info,      // bits that go with the pair
  output wire                out_valid,    // the oldest pair is here, or has an error
  input  wire                out_ready,    // it is taken in this cycle
  output wire [SETS+1:0]     out_a,        // slot of A's leaf
  output wire [SETS+1:0]     out_b,        // slot of B's leaf
  output wire [INFO-1:0]     out_info,     // the bits that went in with the pair
  output wire                out_error,    // a leaf of the pair was not read
  input  wire                done,         // the oldest pair is released
  input  wire                read_a,       // read a triangle of A
  input  wire [SETS+5:0]     slot_a,       // {slot of its leaf, its number in the leaf}
  output wire [9*W:0]        triangle_a,   // the data, from the next cycle on
  input  wire                read_b,       // read a triangle of B
  input  wire [SETS+5:0]     slot_b,       // {slot of its leaf, its number in the leaf}
  output wire [9*W:0]        triangle_b,   // the data, from the next cycle on
  input  wire                corners_read_b, // read the vertex numbers of a triangle of B
  input  wire [SETS+5:0]     corners_slot_b, // {slot of its leaf, its number in the leaf}
  output wire [14:0]         corners_b,    // the data, from the next cycle on
  output wire                miss_valid,   // a burst is wanted
  input  wire                miss_ready,   // it is taken in this cycle
  output wire [ADDRESS-5:0]  miss_address, // place of its first beat, in units of 16 bytes
  output wire [3:0]          miss_beats,   // beats of the burst less 1
  output wire [SETS+2:0]     miss_tag,     // tag that comes back with the data: {is B's, slot}
  input  wire                fill,         // a beat has come
  input  wire [119:0]        fill_numbers, // the beat as vertex numbers, 15 bits a triangle
  input  wire [3*W-1:0]      fill_even,    // the beat's first vertex, {z, y, x}
  input  wire [3*W-1:0]      fill_odd,     // the beat's second vertex
  input  wire [3:0]          fill_beat,    // number of the beat in its burst
  input  wire                fill_last,    // the last beat of its burst
  input  wire                fill_error,   // the beat came with an error
  input  wire [SETS+2:0]     fill_tag,     // tag of the burst
  output wire                busy,         // no new record may begin to come
  output wire                idle          // no record is being converted
);
  localparam BLOCK = ADDRESS; // bits of a block's address: {beats, place}
  wire [ADDRESS-5:0] place_a = {base_a, 8'd0} + {{(ADDRESS-36){1'b0}}, in_a};
  wire [ADDRESS-5:0] place_b = {base_b, 8'd0} + {{(ADDRESS-36){1'b0}}, in_b};
  wire               write, filled, error;
  wire [9*W:0]       triangle;
  wire [14:0]        corners;
  wire [3:0]         index;
  wire [SETS+2:0]    tag;
  wire               is_b = tag[SETS+2];

  sepax_cache #(.ADDRESS(BLOCK), .INFO(INFO), .SETS(SETS), .WINDOW(WINDOW)) cache (
    .clk(clk), .rst(rst), .start(start), .cold(cold), .drop(drop),
    .in_valid(in_valid), .in_ready(in_ready), .in_a({in_beats_a, place_a}),
    .in_b({in_beats_b, place_b}), .in_info(in_info), .out_valid(out_valid),
    .out_ready(out_ready), .out_a(out_a), .out_b(out_b), .out_info(out_info),
    .out_error(out_error), .done(done), .miss_valid(miss_valid), .miss_ready(miss_ready),
    .miss_is_b(miss_tag[SETS+2]), .miss_address({miss_beats, miss_address}),
    .miss_slot(miss_tag[SETS+1:0]), .filled(filled), .filled_is_b(is_b), .filled_error(error)
  );
  sepax_leaf_fill #(.W(W), .TAG(SETS+3)) records (
    .clk(clk), .rst(rst), .fill(fill), .fill_numbers(fill_numbers), .fill_even(fill_even),
    .fill_odd(fill_odd), .fill_beat(fill_beat), .fill_last(fill_last), .fill_error(fill_error),
    .fill_tag(fill_tag), .busy(busy), .idle(idle), .write(write),
    .triangle(triangle), .corners(corners), .index(index), .tag(tag), .done(filled), .error(error)
  );
  sepax_ram #(.WIDTH(9*W+1), .ADDRESS(SETS+6)) triangles_a (
    .clk(clk), .write(write && !is_b), .write_address({tag[SETS+1:0], index}),
    .write_data(triangle), .read(read_a), .read_address(slot_a), .read_data(triangle_a)
  );
  sepax_ram #(.WIDTH(9*W+1), .ADDRESS(SETS+6)) triangles_b (
    .clk(clk), .write(write && is_b), .write_address({tag[SETS+1:0], index}),
    .write_data(triangle), .read(read_b), .read_address(slot_b), .read_data(triangle_b)
  );
  sepax_ram #(.WIDTH(15), .ADDRESS(SETS+6), .DISTRIBUTED(1)) all_corners_b ( //@ fpga
  sepax_ram #(.WIDTH(15), .ADDRESS(SETS+6)) all_corners_b ( //@ !fpga
    .clk(clk), .write(write && is_b), .write_address({tag[SETS+1:0], index}),
    .write_data(corners), .read(corners_read_b), .read_address(corners_slot_b),
    .read_data(corners_b)
  );
endmodule
