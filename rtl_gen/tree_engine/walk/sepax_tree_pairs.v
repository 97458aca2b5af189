// SPDX-License-Identifier: MIT
// Tests the pairs of the rows (docs/reference/tree-engine.md, Pair). B's triangle of a row is
// turned. Then each triangle of A in the mask is tested against it, from 0 to 15, one a cycle. Near
// pairs go to the cores through a queue of 16, with axes exchanged so that z is the thinnest side.
module sepax_tree_pairs #(
  parameter W = 18,     // bits of a coordinate, 4 ... 21
  parameter MARGIN = 0, // largest gap of a near pair
  parameter SLOT = 3,   // bits of a slot of the leaf buffers
  parameter ROWS = 6,   // log2 of the most rows that wait
  parameter INFO = 102  // bits that go with a pair of leaves
) (
  input  wire             clk,             // clock
  input  wire             clear,           // drop all work
  output reg              damaged,         // a triangle is damaged: no pair from it on is tested
  output wire             error,           // a pair of leaves came with an error: no pair of it
  output wire             busy,            // rows or pairs are in progress
  // rows in
  input  wire             row_valid,       // a row; with mask 0, only the end of a pair of leaves
  output wire             row_ready,       // it is taken in this cycle
  input  wire             row_last,        // the last row of its pair of leaves
  input  wire [3:0]       row_child,       // number b of B's triangle
  input  wire [15:0]      row_mask,        // mask of A's triangles
  // leaves
  input  wire             leaf_out_valid,  // the oldest pair of leaves is here, or has an error
  output wire             leaf_out_ready,  // it is taken in this cycle
  input  wire [SLOT-1:0]  leaf_out_a,      // slot of A's leaf
  input  wire [SLOT-1:0]  leaf_out_b,      // slot of B's leaf
  input  wire [INFO-1:0]  leaf_out_info,   // bits that go with the pair
  input  wire             leaf_out_error,  // a leaf of the pair was not read
  output wire             leaf_release,    // the oldest pair is released
  output wire             triangle_read_a, // read a triangle of A
  output wire [SLOT+3:0]  triangle_slot_a, // {slot of its leaf, its number in the leaf}
  input  wire [9*W:0]     triangle_a,      // {damaged, its vertices}, from the next cycle on
  output wire             triangle_read_b, // read a triangle of B
  output wire [SLOT+3:0]  triangle_slot_b, // {slot of its leaf, its number in the leaf}
  input  wire [9*W:0]     triangle_b,      // {damaged, its vertices}, from the next cycle on
  output wire             corners_read_b,  // read the vertex numbers of a triangle of B
  output wire [SLOT+3:0]  corners_slot_b,  // {slot of its leaf, its number in the leaf}
  input  wire [14:0]      corners_b,       // {number of vertex 2, of 1, of 0}
  // vertices to sepax_turn_vertex and back
  output wire             turn_valid,      // a vertex is to be turned
  input  wire             turn_ready,      // it is taken in this cycle
  output wire [3*W-1:0]   turn_point,      // {z, y, x}
  output wire             turn_damaged,    // its triangle is damaged
  input  wire             turned_valid,    // a vertex has been turned
  input  wire [74:0]      turned,          // {z, y, x}, 25 bits each, signed
  input  wire             turned_damaged,  // its triangle is damaged
  // near pairs
  output wire             pair_valid,      // a near pair
  input  wire             pair_ready,      // it is taken in this cycle
  output wire [9*W-1:0]   pair_a,          // A's vertices {2, 1, 0}, {z, y, x} each
  output wire [9*W-1:0]   pair_b,          // B's vertices in the same order
  output wire             pair_outside,    // a coordinate of B is beyond W bits
  output wire [INFO+7:0]  pair_info,       // {info of the pair of leaves, b, a}
  output wire             pair_counted     // a pair is tested
);
  localparam WORD = 18 * W + INFO + 9; // bits of a word of the queue
  localparam [ROWS:0] ROW = 1;

  // --------------------------------------------------------------------- rows
  reg  [ROWS:0]     rows_q;       // rows that wait
  wire              more, take_row, more_last, rows_busy;
  wire [3:0]        more_child;
  wire [15:0]       more_mask;
  wire              next_valid, next, next_last;
  wire [3:0]        next_child;
  wire [15:0]       next_mask;
  wire [SLOT-1:0]   next_slot;
  wire              box_read, vertices_read, info_read;
  wire [6*W+13:0]   box;
  wire [9*W-1:0]    vertices;
  wire [INFO-1:0]   info;
  wire              push_row = row_valid && row_ready;
  wire              pop_row = more && take_row;

  assign row_ready = !rows_q[ROWS];

  sepax_ram_fifo #(.WIDTH(21), .ADDRESS(ROWS)) row_queue (
    .clk(clk), .clear(clear), .push(push_row), .in({row_last, row_child, row_mask}),
    .valid(more), .pop(pop_row), .out({more_last, more_child, more_mask})
  );
  sepax_tree_rows #(.W(W), .SLOT(SLOT), .INFO(INFO)) rows (
    .clk(clk), .clear(clear), .error(error), .busy(rows_busy), .in_valid(more),
    .in_ready(take_row), .in_last(more_last), .in_child(more_child), .in_mask(more_mask),
    .leaf_out_valid(leaf_out_valid), .leaf_out_ready(leaf_out_ready), .leaf_out_a(leaf_out_a),
    .leaf_out_b(leaf_out_b), .leaf_out_info(leaf_out_info), .leaf_out_error(leaf_out_error),
    .triangle_read_b(triangle_read_b), .triangle_slot_b(triangle_slot_b),
    .triangle_b(triangle_b), .corners_read_b(corners_read_b), .corners_slot_b(corners_slot_b),
    .corners_b(corners_b), .turn_valid(turn_valid), .turn_ready(turn_ready),
    .turn_point(turn_point), .turn_damaged(turn_damaged), .turned_valid(turned_valid),
    .turned(turned), .turned_damaged(turned_damaged), .out_valid(next_valid), .out_ready(next),
    .out_last(next_last), .out_child(next_child), .out_mask(next_mask), .out_slot(next_slot),
    .box_read(box_read), .box(box), .vertices_read(vertices_read), .vertices(vertices),
    .info_read(info_read), .info(info)
  );

  // ------------------------------------------------------- a pair of a row a cycle
  reg  [15:0]       mask_q;       // pairs of the row that are left
  reg  [3:0]        child_q;
  reg  [SLOT-1:0]   slot_q;
  reg               last_q, first_q, leaf_q; // last of its leaves; first pair of row, of leaves
  reg  [4:0]        free_q;       // places of the queue that are not promised to a pair
  wire [15:0]       lowest = mask_q & (~mask_q + 16'd1); //@ !fpga
  wire [15:0]       lowest; //@ fpga
  wire [15:0]       others = mask_q & ~lowest;
  wire              many;         // two or more pairs of the row are left //@ fpga
  reg               some_q;       // pairs of the row are left //@ fpga
  wire              issue = some_q && (|free_q) && !damaged; //@ fpga
  wire              issue = (|mask_q) && (|free_q) && !damaged; //@ !fpga
  wire              row_done = issue && !(|others); //@ !fpga
  wire              row_done = issue && !many; //@ fpga
  //@ if fpga
  reg               ask_q;        // a pair's triangle of A is being read
  reg  [15:0]       ask_lowest_q; // one-hot: its triangle of A
  reg  [SLOT-1:0]   ask_slot_q;
  reg  [3:0]        ask_child_q;
  reg               ask_first_q, ask_leaf_q;
  reg  [1:0]        freed_q;      // places of the queue that became free
  wire [3:0]        a = {
    |(ask_lowest_q & 16'hff00), |(ask_lowest_q & 16'hf0f0), |(ask_lowest_q & 16'hcccc),
    |(ask_lowest_q & 16'haaaa)
  };
  //@ else
  wire [3:0]        a = {
    |(lowest & 16'hff00), |(lowest & 16'hf0f0), |(lowest & 16'hcccc), |(lowest & 16'haaaa)
  };
  //@ end

  assign next = next_valid && (row_done || !(|mask_q)) && !damaged; //@ !fpga
  assign next = next_valid && !some_q && !damaged; //@ fpga
  sepax_several left (.mask(mask_q), .many(many), .lowest(lowest)); //@ fpga
  //@ if fpga
  assign triangle_read_a = ask_q;
  assign triangle_slot_a = {ask_slot_q, a};
  //@ else
  assign triangle_read_a = issue;
  assign triangle_slot_a = {slot_q, a};
  //@ end
  assign box_read = issue && first_q; //@ !fpga
  assign leaf_release = (row_done && last_q) || (next && !(|next_mask)); //@ !fpga
  //@ if fpga
  reg               release_q;
  wire              leaves_done = (row_done && last_q) || (next && !(|next_mask));
  assign leaf_release = release_q;
  //@ end
  assign pair_counted = issue;

  // -------------------- stages: vertices, AABB of A, test, thinnest side and queue
  //@ if fpga
  reg               read_q;       // the memory has read a triangle, which goes to a register
  reg               read_first_q, read_leaf_q;
  reg  [3:0]        read_a_q, read_child_q;
  reg  [9*W:0]      triangle_q;
  //@ end
  reg               valid_q, valid_q2, valid_q3;
  reg  [3:0]        a_q, a_q2, child_q1, child_q2;
  reg               first_q1, leaf_q1, damaged_q2;
  reg  [9*W-1:0]    triangle_q2;
  reg  [6*W-1:0]    box_a_q2;
  reg  [6*W+13:0]   box_q2;
  wire [6*W-1:0]    box_a;
  wire              near, commit;
  wire [1:0]        thinnest, thinnest_out;
  wire              spoilt = valid_q2 && (damaged_q2 || box_q2[6*W+13]);

  assign box_read = read_q && read_first_q; //@ fpga
  assign vertices_read = valid_q && first_q1;
  assign info_read = valid_q && leaf_q1;
  assign commit = valid_q3 && near;

  genvar k;
  generate
    for (k = 0; k < 3; k = k + 1) begin : axis
      sepax_bounds #(.W(W)) bounds_a (
        .x_1(@of_a@[W*k +: W]), .x_2(@of_a@[W*(k+3) +: W]),
        .x_3(@of_a@[W*(k+6) +: W]), .low(box_a[W*k +: W]), .high(box_a[W*(k+3) +: W])
      );
    end
  endgenerate
  sepax_pair_test #(.W(W), .MARGIN(MARGIN)) test (
    .clk(clk), .box_a(box_a_q2), .box_b(box_q2[6*W+11:0]), .near(near),
    .thinnest(thinnest)
  );

  // -------------------------------------------------------------------- queue
  reg  [3:0]        tail_q, head_q;
  reg  [4:0]        count_q;      // near pairs in the queue's memory
  reg               out_q;        // the memory's output is a pair
  wire [3:0]        tail = tail_q + {3'd0, commit};
  wire              take = pair_valid && pair_ready; //@ !fpga
  wire              read = (|count_q) && (!out_q || take); //@ !fpga
  wire              read = (|count_q) && !out_q; //@ fpga
  wire [9*W-1:0]    out_a, out_b;

  assign pair_valid = out_q;
  assign busy = ((|rows_q) && !error && !damaged) || (rows_busy && !damaged) || (|mask_q) ||
                ask_q || read_q || //@ fpga
                valid_q || valid_q2 || valid_q3 || (|count_q) || out_q;

  // A pair is written before it is known to be near. If it is not near, the next pair overwrites
  // it.
  sepax_ram #(.WIDTH(WORD), .ADDRESS(4)) queue (
    .clk(clk), .write(valid_q2), .write_address(tail),
    .write_data({info, child_q2, a_q2, box_q2[6*W+12], vertices, triangle_q2}), .read(read),
    .read_address(head_q), .read_data({pair_info, pair_outside, out_b, out_a})
  );
  sepax_ram #(.WIDTH(2), .ADDRESS(4)) sides (
    .clk(clk), .write(commit), .write_address(tail_q), .write_data(thinnest), .read(read),
    .read_address(head_q), .read_data(thinnest_out)
  );
  sepax_swap_axes #(.W(W)) axes_a (.thinnest(thinnest_out), .in(out_a), .out(pair_a));
  sepax_swap_axes #(.W(W)) axes_b (.thinnest(thinnest_out), .in(out_b), .out(pair_b));

  always @(posedge clk) begin
    if (clear) begin
      rows_q <= {(ROWS+1){1'b0}};
      mask_q <= 16'd0;
      leaf_q <= 1'b1;
      {valid_q, valid_q2, valid_q3, damaged, out_q} <= 5'd0;
      {ask_q, read_q, release_q, some_q} <= 4'd0; //@ fpga
      freed_q <= 2'd0; //@ fpga
      free_q <= 5'd16;
      {tail_q, head_q} <= 8'd0;
      count_q <= 5'd0;
    end else begin
      rows_q <= rows_q + (push_row ? ROW : {(ROWS+1){1'b0}}) -
                (pop_row ? ROW : {(ROWS+1){1'b0}});
      some_q <= !(spoilt || damaged) && (next ? (|next_mask) : some_q && !row_done); //@ fpga
      if (spoilt || damaged) begin
        mask_q <= 16'd0;
      end else if (next) begin
        mask_q <= next_mask;
      end else if (issue) begin
        mask_q <= others;
      end
      if (issue) begin
        leaf_q <= 1'b0;
      end
      release_q <= leaves_done; //@ fpga
      if (@leaves@) begin
        leaf_q <= 1'b1;
      end
      damaged <= damaged || spoilt;
      valid_q <= issue && !spoilt; //@ !fpga
      ask_q <= issue && !spoilt; //@ fpga
      read_q <= ask_q && !spoilt && !damaged; //@ fpga
      valid_q <= read_q && !spoilt && !damaged; //@ fpga
      valid_q2 <= valid_q && !spoilt && !damaged;
      valid_q3 <= valid_q2 && !spoilt && !damaged;
      //@ if fpga
      freed_q <= {1'b0, valid_q3 && !near} + {1'b0, read};
      free_q <= free_q - {4'd0, issue} + {3'd0, freed_q};
      if (commit != read) begin
        count_q <= count_q + {{4{read}}, 1'b1};
      end
      //@ else
      free_q <= free_q - {4'd0, issue} + {4'd0, valid_q3 && !near} + {4'd0, read};
      count_q <= count_q + {4'd0, commit} - {4'd0, read};
      //@ end
      tail_q <= tail;
      head_q <= head_q + {3'd0, read};
      out_q <= read || (out_q && !pair_ready);
    end
    if (next) begin
      child_q <= next_child;
      slot_q <= next_slot;
      last_q <= next_last;
    end
    first_q <= next || (first_q && !issue);
    //@ if fpga
    {ask_lowest_q, ask_slot_q, ask_child_q} <= {lowest, slot_q, child_q};
    {ask_first_q, ask_leaf_q} <= {first_q, leaf_q};
    {read_first_q, read_leaf_q} <= {ask_first_q, ask_leaf_q};
    {read_a_q, read_child_q} <= {a, ask_child_q};
    {first_q1, leaf_q1} <= {read_first_q, read_leaf_q};
    {a_q, child_q1} <= {read_a_q, read_child_q};
    triangle_q <= triangle_a;
    //@ else
    {first_q1, leaf_q1} <= {first_q, leaf_q};
    {a_q, child_q1} <= {a, child_q};
    //@ end
    {a_q2, child_q2} <= {a_q, child_q1};
    triangle_q2 <= @of_a@[9*W-1:0];
    damaged_q2 <= @of_a@[9*W];
    box_a_q2 <= box_a;
    if (vertices_read) begin
      box_q2 <= box;
    end
  end
endmodule
