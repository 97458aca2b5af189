// SPDX-License-Identifier: MIT
// Finds the colliding triangles of two bodies in one pose of B (docs/reference/tree-engine.md,
// Engine). Reads the trees of both bodies over AXI4 and walks them at once. Near pairs go to exact
// cores outside of this module, and their verdicts come back. All inputs of a run except start and
// stop must not change from start to done.
module sepax_tree_engine #(
  parameter W = @word@,        // bits of a coordinate, 4 ... 21
  parameter MARGIN = 0,    // largest gap of a near pair, 0 ... 2^(W-1)
  parameter FLIGHT = 5,    // log2 of the most pairs in the cores
  parameter ADDRESS = 40,  // bits of a byte address, 37 ... 64
  parameter STACK = 10,    // log2 of the places of the stack, 9 or more
  parameter LINE = 5,      // log2 of the places of the line, 2 or more
  parameter NODE_SETS = 4, // log2 of the sets of 4 nodes a body
  parameter LEAF_SETS = 2, // log2 of the sets of 4 leaves a body
  parameter ROWS = 7       // log2 of the most rows that wait
) (
  input  wire               clk,             // clock
  input  wire               rst,             // synchronous reset, active high; AXI's, too
  // run
  input  wire               start,           // a run begins; only while idle
  input  wire               stop,            // end the run
  input  wire               cold,            // with start: empty the caches
  input  wire               probe,           // with start: the bodies may be others than before
  output wire               idle,            // a run may begin
  output wire               done,            // a pulse: the run has ended, all results are taken
  output wire               hit,             // a pulse: the first collision was found
  input  wire               first,           // end the run at its first collision
  input  wire               quiet,           // send no results
  input  wire [31:0]        budget,          // cycles after which the run ends, 1 or more
  input  wire               clear_counts,    // set counters to 0; not while a run counts
  // bodies
  input  wire [ADDRESS-13:0] base_a,         // address of A's image / 4096
  input  wire [23:0]        nodes_a,         // nodes of A
  input  wire [31:0]        triangles_a,     // triangles of A
  input  wire [31:0]        beats_a,         // beats of A's image
  input  wire [ADDRESS-13:0] base_b,         // address of B's image / 4096
  input  wire [23:0]        nodes_b,         // nodes of B
  input  wire [24:0]        triangles_b,     // triangles of B
  input  wire [31:0]        beats_b,         // beats of B's image
  // pose
  input  wire [197:0]       matrix_m,        // M, entry (i, j) at 22 (3 i + j)
  input  wire [197:0]       matrix_k,        // K, in the same order
  input  wire [131:0]       shift_t,         // t, {z, y, x}
  input  wire [131:0]       shift_u,         // u, {z, y, x}
  input  wire [71:0]        sigma_a,         // sigma_A, {z, y, x}
  input  wire [71:0]        sigma_b,         // sigma_B, {z, y, x}
  // a first row
  input  wire               row,             // a first row is given
  input  wire [22:0]        row_leaf_a,      // first row: node number of A's leaf
  input  wire [22:0]        row_leaf_b,      // first row: node number of B's leaf
  input  wire [3:0]         row_a,           // first row: triangle a in A's leaf
  input  wire [3:0]         row_b,           // first row: triangle b in B's leaf
  // near pairs to the cores, verdicts from them
  output wire               pair_valid,      // a near pair
  input  wire               pair_ready,      // it is taken in this cycle
  output wire [9*W-1:0]     pair_a,          // A's vertices {2, 1, 0}, {z, y, x} each, z thinnest
  output wire [9*W-1:0]     pair_b,          // B's vertices in the same order
  output wire               pair_outside,    // a coordinate of B does not fit W bits
  input  wire               in_flight,       // the cores have pairs
  input  wire               verdict_valid,   // a verdict, in the order of the pairs
  output wire               verdict_ready,   // it is taken in this cycle
  input  wire               collision,       // the triangles collide
  input  wire               coplanar,        // the triangles are coplanar
  input  wire               warning,         // the pair is in the warning band
  input  wire               verdict_outside, // pair_outside of the pair
  // results
  output wire               result_valid,    // a result
  input  wire               result_ready,    // it is taken in this cycle
  output wire [31:0]        result_a,        // number of A's triangle in its tree
  output wire [23:0]        result_b,        // number of B's triangle in its tree
  output wire               result_coplanar, // the triangles are coplanar
  output wire               result_outside,  // a coordinate of B does not fit W bits
  output wire               result_warning,  // the pair is in the warning band
  // status and counters
  output wire               any,             // a collision was found
  output wire               stopped,         // first, budget or stop ended the run
  output wire               damaged,         // a node or triangle is damaged
  output wire               error,           // the memory answered with an error
  output wire [31:0]        entries,         // entries finished
  output wire [31:0]        steps,           // boxes turned
  output wire [31:0]        rows,            // rows
  output wire [31:0]        pairs,           // pairs tested
  output wire [31:0]        near,            // near pairs with a verdict
  output wire [31:0]        collisions,      // near pairs that collide or are out of range
  output wire [31:0]        out_of_range,    // near pairs that are out of range
  output wire [31:0]        warnings,        // near pairs in the warning band
  output wire [31:0]        cycles,          // cycles from start on
  output wire [31:0]        first_a,         // first collision: A's triangle
  output wire [23:0]        first_b,         // first collision: B's triangle
  output wire [22:0]        first_leaf_a,    // first collision: A's leaf
  output wire [22:0]        first_leaf_b,    // first collision: B's leaf
  output wire [3:0]         first_row_a,     // first collision: number a in A's leaf
  output wire [3:0]         first_row_b,     // first collision: number b in B's leaf
  // bursts of the host
  input  wire               host_valid,      // a burst is wanted
  output wire               host_ready,      // it is taken in this cycle
  input  wire [ADDRESS-5:0] host_address,    // place of its first beat, in units of 16 bytes
  input  wire [3:0]         host_beats,      // its beats less 1; it does not cross 4 KB
  output wire               host_fill,       // a beat of the host has come
  output wire [127:0]       host_data,       // the beat
  output wire [3:0]         host_beat,       // its number in the burst
  output wire               host_last,       // the last beat of its burst
  output wire               host_error,      // it came with an error
  // AXI4, 128 bits, read only: ARSIZE 4, ARBURST INCR, one ID
  output wire               arvalid,         // an address
  input  wire               arready,         // it is taken in this cycle
  output wire [ADDRESS-1:0] araddr,          // byte address, a multiple of 16
  output wire [7:0]         arlen,           // beats less 1, 0 ... 15
  input  wire               rvalid,          // a beat
  output wire               rready,          // it is taken in this cycle
  input  wire [127:0]       rdata,           // its data
  input  wire [1:0]         rresp,           // 0: OKAY; otherwise an error
  input  wire               rlast            // the last beat of its burst
);
  localparam SLOT = NODE_SETS + 2;      // bits of a slot of the node cache
  localparam LEAF_SLOT = LEAF_SETS + 2; // bits of a slot of the leaf buffers
  localparam INFO = 102;                // bits that go with a pair of leaves
  wire                 drop, memory_idle;
  wire                 clear = rst || drop;
  wire [395:0]         matrix = {matrix_k, matrix_m};

  // --------------------------------------------------------------------- walk
  wire                 walk_over, walk_damaged, walk_error;
  wire                 node_in_valid, node_in_ready, node_out_valid, node_out_ready;
  wire                 node_out_error, node_release, head_read;
  wire [63:0]          node_in, node_out;
  wire [SLOT-1:0]      node_out_a, node_out_b;
  wire [1023:0]        node_a, node_b; //@ !fpga
  wire [255:0]         node_a, node_b; //@ fpga
  wire                 in_valid, in_ready, in_side;
  wire [15:0]          in_mask;
  wire [SLOT-1:0]      in_a, in_b;
  wire                 out_valid, out_ready, out_last, unused_side, out_columns, out_leaves;
  wire [3:0]           out_index;
  wire [15:0]          out_mask;
  reg                  any_q, few_q; // the mask has ones; it has at most 8 //@ fpga
  wire [SLOT-1:0]      unused_a, unused_b;
  wire                 leaf_in_valid, leaf_in_ready;
  wire [31:0]          leaf_in_a, leaf_in_b;
  wire [3:0]           leaf_in_beats_a, leaf_in_beats_b;
  wire [INFO-1:0]      leaf_in_info;
  wire                 row_valid, row_ready, row_last;
  wire [3:0]           row_child;
  wire [15:0]          row_mask;
  wire                 entry_counted, row_counted, pair_counted;
  wire [4:0]           steps_counted;

  sepax_tree_walk #(.STACK(STACK), .LINE(LINE), .SLOT(SLOT)) walk (
    .clk(clk), .start(start), .probe(probe), .clear(clear), .over(walk_over),
    .damaged(walk_damaged), .error(walk_error), .nodes_a(nodes_a), .triangles_a(triangles_a),
    .beats_a(beats_a), .nodes_b(nodes_b), .triangles_b(triangles_b), .beats_b(beats_b), .row(row),
    .row_leaf_a(row_leaf_a), .row_leaf_b(row_leaf_b), .row_a(row_a), .row_b(row_b),
    .node_in_valid(node_in_valid), .node_in_ready(node_in_ready), .node_in(node_in),
    .node_out_valid(node_out_valid), .node_out_ready(node_out_ready), .node_out(node_out),
    .node_out_a(node_out_a), .node_out_b(node_out_b), .node_out_error(node_out_error),
    .node_release(node_release), .head_read(head_read),
    .head_a({node_a[191:128], node_a[119:108]}), .head_b({node_b[191:128], node_b[119:108]}),
    .in_valid(in_valid), .in_ready(in_ready), .in_side(in_side),
    .in_mask(in_mask), .in_a(in_a), .in_b(in_b), .out_valid(out_valid), .out_ready(out_ready),
    .out_last(out_last), .out_columns(out_columns), .out_leaves(out_leaves),
    .out_any(any_q), .out_half(out_mask & {16{few_q}}), //@ fpga
    .out_index(out_index), .out_mask(out_mask), .leaf_in_valid(leaf_in_valid),
    .leaf_in_ready(leaf_in_ready), .leaf_in_a(leaf_in_a), .leaf_in_beats_a(leaf_in_beats_a),
    .leaf_in_b(leaf_in_b), .leaf_in_beats_b(leaf_in_beats_b), .leaf_in_info(leaf_in_info),
    .row_valid(row_valid), .row_ready(row_ready), .row_last(row_last), .row_child(row_child),
    .row_mask(row_mask), .entry_counted(entry_counted), .steps_counted(steps_counted),
    .row_counted(row_counted)
  );

  // ----------------------------- compare; sepax_turn_vertex, which the rows use, too
  //@ if fpga
  wire                 box_read, boxes_read;
  wire [SLOT:0]        box_slot, boxes_slot;
  wire [3:0]           box_index;
  wire [47:0]          box;
  wire [767:0]         boxes;
  //@ else
  wire                 boxes_read_a, boxes_read_b;
  wire [SLOT-1:0]      boxes_slot_a, boxes_slot_b;
  //@ end
  wire                 setup_turn, setup_side, rows_turn, rows_damaged;
  wire [3*W-1:0]       setup_point, setup_origin, rows_point;
  wire [134:0]         turned;
  reg  [@turn_last@:0]           setup_q, rows_q, damaged_q; // for set-up, for a row; damaged
  reg                  item_q;  // an item waits for the walk
  reg  [22:0]          items_q; // {last, columns, leaves, index, mask}
  wire                 item_valid;
  //@ if fpga
  wire                 item_ready, listed_valid;
  reg                  listing_q; // an item goes to the list
  reg  [22:0]          listing_in_q;
  wire                 item_free = !item_q || out_ready;
  wire [22:0]          item, listed;
  wire                 any_listed, few_listed;
  wire [2:0]           ones [0:3]; // number of ones in four bits of the mask
  wire [3:0]           ones_low = {1'b0, ones[0]} + {1'b0, ones[1]};
  wire [3:0]           ones_high = {1'b0, ones[2]} + {1'b0, ones[3]};
  wire [4:0]           all_ones = {1'b0, ones_low} + {1'b0, ones_high};
  //@ else
  wire                 item_ready = !item_q || out_ready;
  wire [22:0]          item;
  //@ end

  assign out_valid = item_q;
  assign {out_last, out_columns, out_leaves, out_index, out_mask} = items_q;

  sepax_tree_compare #(.W(W), .SLOT(SLOT)) compare (
    .clk(clk), .rst(rst), .drop(drop), .matrix(matrix), .sigma({sigma_b, sigma_a}),
    .in_valid(in_valid), .in_ready(in_ready), .in_side(in_side), .in_mask(in_mask), .in_a(in_a),
    //@ if fpga
    .in_b(in_b), .head_a(node_a), .head_b(node_b), .box_read(box_read), .box_slot(box_slot),
    .box_index(box_index), .box(box), .boxes_read(boxes_read), .boxes_slot(boxes_slot),
    .boxes(boxes), .turn_valid(setup_turn),
    //@ else
    .in_b(in_b), .head_a(node_a[255:0]), .head_b(node_b[255:0]), .boxes_read_a(boxes_read_a),
    .boxes_read_b(boxes_read_b), .boxes_slot_a(boxes_slot_a), .boxes_slot_b(boxes_slot_b),
    .boxes_a(node_a[1023:256]), .boxes_b(node_b[1023:256]), .turn_valid(setup_turn),
    //@ end
    .turn_ready(1'b1), .turn_side(setup_side), .turn_point(setup_point),
    .turn_origin(setup_origin), .turned_valid(setup_q[@turn_last@]), .turned(turned),
    .out_valid(item_valid), .out_ready(item_ready), .out_last(item[22]),
    .out_side(unused_side), .out_columns(item[21]), .out_leaves(item[20]),
    .out_index(item[19:16]), .out_mask(item[15:0]), .out_a(unused_a), .out_b(unused_b)
  );
  sepax_turn_vertex #(.W(W)) turner (
    .clk(clk), .matrix(matrix), .shift({shift_u, shift_t}), .side(setup_turn && setup_side),
    .point(setup_turn ? setup_point : rows_point),
    .origin(setup_origin & {(3*W){setup_turn}}), .sum(turned)
  );

//@ if fpga
  sepax_fifo #(.WIDTH(25), .ADDRESS(3), .MARGIN(2)) items (
    .clk(clk), .clear(clear), .push(listing_q), .in({
      |listing_in_q[15:0], !all_ones[4] && !(all_ones[3] && (|all_ones[2:0])), listing_in_q
    }), .free(item_ready), .valid(listed_valid), .pop(listed_valid && item_free),
    .out({any_listed, few_listed, listed})
  );
  genvar k;
  generate
    for (k = 0; k < 4; k = k + 1) begin : quarter
      wire [3:0] some = listing_in_q[4*k +: 4];
      wire       odd = ^some;
      wire       pair = (some[3] && some[2]) || (some[3] && some[1]) || (some[3] && some[0]) ||
                        (some[2] && some[1]) || (some[2] && some[0]) || (some[1] && some[0]);
      assign ones[k] = {&some, pair && !(&some), odd};
    end
  endgenerate

//@ end
  always @(posedge clk) begin
    if (clear) begin
      setup_q <= @turn@'d0; //@ fpga
      rows_q <= @turn@'d0; //@ fpga
      {item_q, listing_q} <= 2'd0; //@ fpga
      {setup_q, rows_q, item_q} <= 7'd0; //@ !fpga
    end else begin
      item_q <= item_valid || !item_ready; //@ !fpga
      item_q <= listed_valid || !item_free; //@ fpga
      listing_q <= item_valid && item_ready; //@ fpga
      setup_q <= {setup_q[@turn_before@:0], setup_turn};
      rows_q <= {rows_q[@turn_before@:0], rows_turn && !setup_turn};
    end
    listing_in_q <= item; //@ fpga
    if (@free@) begin
      items_q <= @item@;
      {any_q, few_q} <= {any_listed, few_listed}; //@ fpga
    end
    damaged_q <= {damaged_q[@turn_before@:0], rows_damaged};
  end

  // -------------------------------------------------------------------- pairs
  wire                 leaf_out_valid, leaf_out_ready, leaf_out_error, leaf_release;
  wire [LEAF_SLOT-1:0] leaf_out_a, leaf_out_b;
  wire [INFO-1:0]      leaf_out_info;
  wire                 triangle_read_a, triangle_read_b;
  wire [LEAF_SLOT+3:0] triangle_slot_a, triangle_slot_b;
  wire [9*W:0]         triangle_a, triangle_b;
  wire                 corners_read_b;
  wire [LEAF_SLOT+3:0] corners_slot_b;
  wire [14:0]          corners_b;
  wire                 pairs_damaged, pairs_error, pairs_busy;
  wire                 near_valid, launch_free;
  wire [INFO+7:0]      launched_info;

  assign pair_valid = near_valid && launch_free;

  sepax_tree_pairs #(
    .W(W), .MARGIN(MARGIN), .SLOT(LEAF_SLOT), .ROWS(ROWS), .INFO(INFO)
  ) near_pairs (
    .clk(clk), .clear(clear), .damaged(pairs_damaged), .error(pairs_error), .busy(pairs_busy),
    .row_valid(row_valid), .row_ready(row_ready), .row_last(row_last), .row_child(row_child),
    .row_mask(row_mask), .leaf_out_valid(leaf_out_valid), .leaf_out_ready(leaf_out_ready),
    .leaf_out_a(leaf_out_a), .leaf_out_b(leaf_out_b), .leaf_out_info(leaf_out_info),
    .leaf_out_error(leaf_out_error), .leaf_release(leaf_release),
    .triangle_read_a(triangle_read_a), .triangle_slot_a(triangle_slot_a),
    .triangle_a(triangle_a), .triangle_read_b(triangle_read_b),
    .triangle_slot_b(triangle_slot_b), .triangle_b(triangle_b),
    .corners_read_b(corners_read_b), .corners_slot_b(corners_slot_b), .corners_b(corners_b),
    .turn_valid(rows_turn),
    .turn_ready(!setup_turn), .turn_point(rows_point), .turn_damaged(rows_damaged),
    .turned_valid(rows_q[@turn_last@]),
    .turned({turned[134:110], turned[89:65], turned[44:20]}), .turned_damaged(damaged_q[@end@]),
    .pair_valid(near_valid), .pair_ready(pair_ready && launch_free), .pair_a(pair_a),
    .pair_b(pair_b), .pair_outside(pair_outside), .pair_info(launched_info),
    .pair_counted(pair_counted)
  );
  sepax_tree_run #(.FLIGHT(FLIGHT)) run (
    .clk(clk), .rst(rst), .start(start), .clear_counts(clear_counts), .stop(stop),
    .first(first), .quiet(quiet), .budget(budget), .idle(idle), .drop(drop), .done(done),
    .hit(hit), .walk_over(walk_over), .walk_damaged(walk_damaged), .walk_error(walk_error),
    .pairs_busy(pairs_busy), .pairs_damaged(pairs_damaged), .pairs_error(pairs_error),
    .memory_idle(memory_idle),
    .entry_counted(entry_counted), .steps_counted(steps_counted), .row_counted(row_counted),
    .pair_counted(pair_counted), .launched(pair_valid && pair_ready),
    .launch_free(launch_free), .launched_info(launched_info), .in_flight(in_flight),
    .verdict_valid(verdict_valid), .verdict_ready(verdict_ready), .collision(collision),
    .coplanar(coplanar), .warning(warning), .outside(verdict_outside),
    .result_valid(result_valid), .result_ready(result_ready), .result_a(result_a),
    .result_b(result_b), .result_coplanar(result_coplanar), .result_outside(result_outside),
    .result_warning(result_warning), .any(any), .stopped(stopped), .damaged(damaged),
    .error(error), .entries(entries), .steps(steps), .rows(rows), .pairs(pairs), .near(near),
    .collisions(collisions), .out_of_range(out_of_range), .warnings(warnings), .cycles(cycles),
    .first_a(first_a), .first_b(first_b), .first_leaf_a(first_leaf_a),
    .first_leaf_b(first_leaf_b), .first_row_a(first_row_a), .first_row_b(first_row_b)
  );

  // ------------------------------------------------------------------- memory
  sepax_tree_memory #(
    .W(W), .ADDRESS(ADDRESS), .NODE_INFO(64), .LEAF_INFO(INFO), .NODE_SETS(NODE_SETS),
    .LEAF_SETS(LEAF_SETS), .NODE_WINDOW(LINE), .LEAF_WINDOW(LEAF_SLOT), .OPEN(5)
  ) memory (
    .clk(clk), .rst(rst), .start(start), .cold(cold), .drop(drop), .idle(memory_idle),
    .base_a(base_a), .base_b(base_b), .node_in_valid(node_in_valid),
    .node_in_ready(node_in_ready), .node_in_a(node_in[45:23]), .node_in_b(node_in[22:0]),
    .node_in_info(node_in), .node_out_valid(node_out_valid), .node_out_ready(node_out_ready),
    .node_out_a(node_out_a), .node_out_b(node_out_b), .node_out_info(node_out),
    .node_out_error(node_out_error), .node_release(node_release), .head_read_a(head_read),
    //@ if fpga
    .head_slot_a(node_out_a), .node_a(node_a), .head_read_b(head_read), .head_slot_b(node_out_b),
    .node_b(node_b), .box_read(box_read), .box_slot(box_slot), .box_index(box_index), .box(box),
    .boxes_read(boxes_read), .boxes_slot(boxes_slot), .boxes(boxes),
    //@ else
    .head_slot_a(node_out_a), .node_read_a(boxes_read_a), .node_slot_a(boxes_slot_a),
    .node_a(node_a), .head_read_b(head_read), .head_slot_b(node_out_b),
    .node_read_b(boxes_read_b), .node_slot_b(boxes_slot_b), .node_b(node_b),
    //@ end
    .leaf_in_valid(leaf_in_valid), .leaf_in_ready(leaf_in_ready), .leaf_in_a(leaf_in_a),
    .leaf_in_beats_a(leaf_in_beats_a), .leaf_in_b(leaf_in_b),
    .leaf_in_beats_b(leaf_in_beats_b), .leaf_in_info(leaf_in_info),
    .leaf_out_valid(leaf_out_valid), .leaf_out_ready(leaf_out_ready), .leaf_out_a(leaf_out_a),
    .leaf_out_b(leaf_out_b), .leaf_out_info(leaf_out_info), .leaf_out_error(leaf_out_error),
    .leaf_release(leaf_release), .triangle_read_a(triangle_read_a),
    .triangle_slot_a(triangle_slot_a), .triangle_a(triangle_a),
    .triangle_read_b(triangle_read_b), .triangle_slot_b(triangle_slot_b),
    .triangle_b(triangle_b), .corners_read_b(corners_read_b), .corners_slot_b(corners_slot_b),
    .corners_b(corners_b), .host_valid(host_valid), .host_ready(host_ready),
    .host_address(host_address), .host_beats(host_beats), .host_fill(host_fill),
    .host_data(host_data), .host_beat(host_beat), .host_last(host_last),
    .host_error(host_error), .arvalid(arvalid), .arready(arready), .araddr(araddr), .arlen(arlen),
    .rvalid(rvalid), .rready(rready), .rdata(rdata), .rresp(rresp), .rlast(rlast)
  );
endmodule
