// SPDX-License-Identifier: MIT
// Tests the entries of the walk in order (docs/reference/tree-engine.md, Compare): turns the boxes
// of node S in the mask, or S's own box, and finds the children of node T that they hit. Up to 4
// entries are in progress: one whose heads are read, one that is set up, the others' boxes.
//@ if fpga
// A box takes a cycle.
//@ else
// A box takes a cycle. The first item of a single entry comes 11 cycles after the entry.
//@ end
module sepax_tree_compare #(
  parameter W = 18,   // bits of a coordinate
  parameter SLOT = 6  // bits of a slot
) (
  input  wire            clk,          // clock
  input  wire            rst,          // synchronous reset, active high
  input  wire            drop,         // forget all entries
  input  wire [395:0]    matrix,       // M, K: (i, k) of a side at 22 (9 side + 3 i + k)
  input  wire [143:0]    sigma,        // i of a side at 24 (3 side + i)
  input  wire            in_valid,     // an entry; its heads are read in this cycle
  output wire            in_ready,     // it is taken in this cycle
  input  wire            in_side,      // 0: S is B's node, T is A's
  input  wire [15:0]     in_mask,      // children of S; 0: S's own box
  input  wire [SLOT-1:0] in_a,         // slot of A's node
  input  wire [SLOT-1:0] in_b,         // slot of B's node
  input  wire [255:0]    head_a,       // bytes 0 ... 31 of A's node, in the next cycle
  input  wire [255:0]    head_b,       // bytes 0 ... 31 of B's node, in the next cycle
  //@ if fpga
  output wire            box_read,     // read a child's box
  output wire [SLOT:0]   box_slot,     // {is B's, slot} of its node
  output wire [3:0]      box_index,    // number of the child
  input  wire [47:0]     box,          // {high z, y, x, low z, y, x}, 3 cycles later
  output wire            boxes_read,   // read bytes 32 ... 127 of a node
  output wire [SLOT:0]   boxes_slot,   // {is B's, slot}
  input  wire [767:0]    boxes,        // the boxes, from the second cycle after the read on
  //@ else
  output wire            boxes_read_a, // read bytes 32 ... 127 of a node of A
  output wire [SLOT-1:0] boxes_slot_a, // slot of the node
  input  wire [767:0]    boxes_a,      // the boxes, from the next cycle on
  output wire            boxes_read_b, // read bytes 32 ... 127 of a node of B
  output wire [SLOT-1:0] boxes_slot_b, // slot of the node
  input  wire [767:0]    boxes_b,      // the boxes, from the next cycle on
  //@ end
  output wire            turn_valid,   // a vertex is to be turned
  input  wire            turn_ready,   // it is taken in this cycle
  output wire            turn_side,    // 0: turn with M and t; 1: with K and u
  output wire [3*W-1:0]  turn_point,   // origin of S, {z, y, x}
  output wire [3*W-1:0]  turn_origin,  // origin of T, {z, y, x}
  input  wire            turned_valid, // the sum X of this vertex has come
  input  wire [134:0]    turned,       // {X_2, X_1, X_0}, 45 bits each
  output wire            out_valid,    // an item
  input  wire            out_ready,    // it is taken in this cycle
  output wire            out_last,     // the last item of its entry
  output wire            out_side,     // the entry's side
  output wire            out_columns,  // items are columns: S is a leaf, and T is not or side is 1
  output wire            out_leaves,   // S and T are leaves
  output wire [3:0]      out_index,    // number i of a row or j of a column
  output wire [15:0]     out_mask,     // the row or column; 0 only in the last item
  output wire [SLOT-1:0] out_a,        // slot of A's node
  output wire [SLOT-1:0] out_b         // slot of B's node
);
  localparam RING = 2 * SLOT + 1; // bits of an entry in the ring: side, slots
  localparam [8:0] BIAS = 9'd@bias@; //@ !fpga
  localparam ROW = 21; // bits of a row that waits: last, index, hits

  wire clear = rst || drop;

  // The entries in progress: a ring, and for each step its place in the ring.
  reg [RING-1:0] ring_q [0:3];  // {side, slot of B, slot of A}
  reg [5:0]      head_q [0:3];  // {columns, leaves, children of T less 1}
  reg [1:0]      in_q, stream_q, lanes_q, out_q; // the next entry to come in, stream, ...
  reg [2:0]      count_q;
  wire           taken_in = in_valid && in_ready;
  wire           taken_out = out_valid && out_ready && out_last;
  wire           unused_side, t_side;
  wire [SLOT-1:0] s_slot_a, s_slot_b, t_slot_a, t_slot_b; // of the next that streams, in lanes
  wire [3:0]     children;
  wire [1:0]     unused_kind;
  wire [1:0]     newest = in_q - 2'd1;

  // Heads of the newest entry.
  reg            heads_q;  // the heads are here
  reg            asked_q;  // X is to be computed
  reg            side_q, own_q;
  reg [23:0]     mask_q;   // the mask, or the own box {z, y, x}
  reg [3*W-1:0]  point_q, origin_q;
  reg [11:0]     s_exponents_q, t_exponents_q;
  wire [255:0]   head_s = side_q ? head_a : head_b;
  wire [255:0]   head_t = side_q ? head_b : head_a;
  wire [255:0]   unused_s = head_s;
  wire [255:0]   unused_t = head_t;
  wire           leaf_s = head_s[115:112] == 4'd0;
  wire           leaf_t = head_t[115:112] == 4'd0;
  wire           set_up = turn_valid && turn_ready;

  assign {unused_side, s_slot_b, s_slot_a} = ring_q[stream_q];
  assign {t_side, t_slot_b, t_slot_a} = ring_q[lanes_q];
  assign {unused_kind, children} = head_q[lanes_q];
  assign in_ready = !heads_q && !asked_q && !count_q[2];
  assign turn_side = side_q;
  assign turn_point = point_q;
  assign turn_origin = origin_q;

  // Set-up of the entry that streams next, or whose first box was not taken yet.
  reg            busy_q;   // there is such an entry
  reg            ready_q;  // its X is here
  reg            loaded_q; // its boxes wait in todo_q, and none of them was taken
  reg            next_side_q, next_own_q;
  reg [23:0]     next_mask_q;
  wire [233:0]   high_bits; // M / 2^9 of the matrices
  wire [104:0]   x;         // X / 2^10
  wire [107:0]   n;
  wire [62:0]    low, high;
  wire [11:0]    shift;

  // Boxes of S.
  reg  [15:0]    todo_q;   // children whose boxes wait
  reg            own_todo_q; // the own box waits
  reg            s_side_q; // side of the streaming entry //@ !fpga
  wire [15:0]    pick = todo_q & (~todo_q + 16'd1); //@ !fpga
  wire [15:0]    pick; //@ fpga
  wire           some = own_todo_q || (|todo_q); //@ !fpga
  reg            some_q; // boxes wait //@ fpga
  wire           some = some_q; //@ fpga
  wire           last = (todo_q & ~pick) == 16'd0; //@ !fpga
  wire           many; // two or more children wait //@ fpga
  wire           last = !many; //@ fpga
  wire           hand; // a box may be taken
  wire           take = some && hand;
  wire           first = take && loaded_q;
  wire           load, read_s; //@ !fpga
  wire           load; //@ fpga
  wire [23:0]    box_low, box_high;

  // Later stages: ends of boxes to be turned, their cells, lanes, hits.
  reg            turn_q, turn_last_q, turn_first_q, turn_side_q; //@ !fpga
  reg            turn_q, turn_last_q, turn_first_q; //@ fpga
  reg  [3:0]     turn_index_q; //@ !fpga
  reg  [26:0]    lows_q, highs_q;
  reg            cell_q, cell_last_q, cell_first_q, cell_side_q; //@ !fpga
  reg            cell_q, cell_last_q, cell_first_q; //@ fpga
  reg  [3:0]     cell_index_q;
  reg  [11:0]    cell_shift_q;
  reg            lane_q, lane_last_q;
  reg  [3:0]     lane_index_q;
  reg            t_side_q; // side of the entry in the lanes //@ !fpga
  reg  [3:0]     children_q;
  reg            row_q, row_last_q;
  reg  [3:0]     row_index_q;
  reg  [15:0]    hits_q;
  //@ if fpga
  // A box comes 3 cycles after turn_q asked for it. Two registers follow the lanes.
  localparam BEFORE = @turn@; // cycles from turn_q to cell_q
  localparam BOX = 6;     // bits of a box: first, last, index
  reg  [SLOT:0]  s_slot_q, t_slot_q; // S of the streaming entry, T of the next
  reg  [15:0]    pick_q;     // one-hot: the box that is asked for
  reg  [3:0]     own_turn_q; // the own box takes the place of a box that was read
  reg  [23:0]    own_mask_q;
  reg  [107:0]   n_q;        // set-up of the boxes that come
  reg  [62:0]    low_q, high_q;
  reg  [11:0]    shift_q;
  reg  [BEFORE-2:0] turning_q;
  reg  [BOX*(BEFORE-1)-1:0] turns_q;
  reg  [12*(BEFORE-5)-1:0] shifts_q;
  reg            cell_q2, cell_last_q2, lane_q2, lane_last_q2;
  reg  [3:0]     cell_index_q2, lane_index_q2;
  reg  [3:0]     children_q2;
  reg  [15:0]    present_q;
  //@ end
  wire [1:0]     beyond; // bit 0: of the lower end; bit 1: of the upper end
  wire [47:0]    cells;
  wire [31:0]    end_hits;
  wire [15:0]    present;
  wire           read_t = cell_q && cell_first_q;
  wire           free, row_valid, row_ready, row_last;
  wire           row_waits; //@ fpga
  wire [3:0]     row_index;
  wire [15:0]    row;

  assign turn_valid = asked_q && (!busy_q || first); //@ !fpga
  assign turn_valid = asked_q && !busy_q; //@ fpga
  assign hand = free;
  //@ if fpga
  assign load = (turned_valid || ready_q) && !loaded_q && !some;
  //@ else
  // The memories' outputs hold S and T. S is loaded only when no earlier box needs a T of the same
  // body there.
  assign load = (turned_valid || ready_q) && !loaded_q && (!some || (take && last)) &&
                (next_own_q || !((some && (s_side_q != next_side_q)) ||
                                 (turn_q && (turn_side_q != next_side_q)) ||
                                 (cell_q && (cell_side_q != next_side_q))));
  //@ end
  //@ if fpga
  assign box_read = turn_q;
  assign box_slot = s_slot_q;
  assign box_index = {
    |(pick_q & 16'hff00), |(pick_q & 16'hf0f0), |(pick_q & 16'hcccc), |(pick_q & 16'haaaa)
  };
  assign boxes_read = read_t;
  assign boxes_slot = t_slot_q;
  //@ else
  assign read_s = load && !next_own_q;
  assign boxes_read_a = (read_s && next_side_q) || (read_t && !t_side);
  assign boxes_read_b = (read_s && !next_side_q) || (read_t && t_side);
  assign boxes_slot_a = (read_s && next_side_q) ? s_slot_a : t_slot_a;
  assign boxes_slot_b = (read_s && !next_side_q) ? s_slot_b : t_slot_b;
  //@ end

  sepax_several left (.mask(todo_q), .many(many), .lowest(pick)); //@ fpga
  sepax_tree_setup setup (
    .clk(clk), .matrix(high_bits), .sigma(sigma), .begin_in(set_up), .side(side_q),
    .s_exponents(s_exponents_q), .t_exponents(t_exponents_q), .x_valid(turned_valid), .x(x),
    .load(@load@), .n(n), .low(low), .high(high), .shift(shift)
  );

  genvar i, j, k;
  generate
    for (i = 0; i < 18; i = i + 1) begin : matrix_entry
      wire [8:0] unused_low = matrix[22*i +: 9];
      assign high_bits[13*i +: 13] = matrix[22*i+9 +: 13];
    end
    for (i = 0; i < 3; i = i + 1) begin : turned_axis
      wire [9:0] unused_low = turned[45*i +: 10];
      assign x[35*i +: 35] = turned[45*i+10 +: 35];
    end
    for (i = 0; i < 24; i = i + 1) begin : box_bit
      //@ if fpga
      assign box_low[i] = own_turn_q[3] ? !own_mask_q[i] : box[i];
      assign box_high[i] = own_turn_q[3] ? own_mask_q[i] : box[24+i];
      //@ else
      wire [15:0] low_a, low_b, high_a, high_b;
      for (j = 0; j < 16; j = j + 1) begin : of_child
        assign low_a[j] = boxes_a[48*j+i];
        assign low_b[j] = boxes_b[48*j+i];
        assign high_a[j] = boxes_a[48*j+24+i];
        assign high_b[j] = boxes_b[48*j+24+i];
      end
      assign box_low[i] = (s_side_q ? |(low_a & pick) : |(low_b & pick)) ||
                          (own_todo_q && !next_mask_q[i]);
      assign box_high[i] = (s_side_q ? |(high_a & pick) : |(high_b & pick)) ||
                           (own_todo_q && next_mask_q[i]);
      //@ end
    end
    for (k = 0; k < 3; k = k + 1) begin : bias_axis
      always @(posedge clk) begin
        //@ if fpga
        lows_q[9*k +: 9] <= {box_low[8*k+7], box_low[8*k +: 8]};
        highs_q[9*k +: 9] <= {box_high[8*k+7], box_high[8*k +: 8]} + 9'd1;
        //@ else
        if (take) begin
          lows_q[9*k +: 9] <= {box_low[8*k+7], box_low[8*k +: 8]} + BIAS;
          highs_q[9*k +: 9] <= {box_high[8*k+7], box_high[8*k +: 8]} + BIAS + 9'd1;
        end
        //@ end
      end
    end
    for (k = 0; k < 2; k = k + 1) begin : box_end
      wire [383:0] bounds;
      sepax_turn_box turn (
        .clk(clk), .upper(k[0]), .lows(lows_q), .highs(highs_q), .n(n), //@ !fpga
        .start(k[0] ? high : low), .shift(cell_shift_q), .cells(cells[24*k +: 24]), //@ !fpga
        .clk(clk), .upper(k[0]), .lows(lows_q), .highs(highs_q), .n(n_q), //@ fpga
        .start(k[0] ? high_q : low_q), .shift(cell_shift_q), .cells(cells[24*k +: 24]), //@ fpga
        .beyond(beyond[k])
      );
      for (j = 0; j < 16; j = j + 1) begin : lane
        //@ if fpga
        wire [23:0] upper = boxes[48*j+24 +: 24];
        wire [23:0] below = boxes[48*j +: 24];
        //@ else
        wire [23:0] upper = t_side_q ? boxes_b[48*j+24 +: 24] : boxes_a[48*j+24 +: 24];
        wire [23:0] below = t_side_q ? boxes_b[48*j +: 24] : boxes_a[48*j +: 24];
        //@ end
        assign bounds[24*j +: 24] = k[0] ? ~below : upper;
      end
      sepax_lanes lanes (
        .clk(clk), //@ fpga
        .cells(cells[24*k +: 24]), .beyond(beyond[k]), .bounds(bounds),
        .hits(end_hits[16*k +: 16])
      );
    end
    for (j = 1; j < 16; j = j + 1) begin : child
      assign present[j] = children_q >= j[3:0]; //@ !fpga
      assign present[j] = children_q2 >= j[3:0]; //@ fpga
    end
  endgenerate

  assign present[0] = 1'b1;
  sepax_fifo #(.WIDTH(ROW), .ADDRESS(3), .MARGIN(5)) rows ( //@ !fpga
  sepax_fifo #(.WIDTH(ROW), .ADDRESS(@rows@), .MARGIN(@turn@+6)) rows ( //@ fpga
    .clk(clk), .clear(clear), .push(row_q && ((|hits_q) || row_last_q)),
    .in({row_last_q, row_index_q, hits_q}), .free(free), .valid(row_valid), //@ !fpga
    .in({row_last_q, row_index_q, hits_q}), .free(free), .valid(row_waits), //@ fpga
    .pop(row_valid && row_ready), .out({row_last, row_index, row})
  );
  sepax_hits hits (
    .clk(clk), .clear(clear), .in_valid(row_valid), .in_ready(row_ready), .in_last(row_last),
    .in_index(row_index), .in_row(row), .columns(out_columns), .out_valid(out_valid),
    .out_ready(out_ready), .out_last(out_last), .out_index(out_index), .out_mask(out_mask)
  );

  assign {out_side, out_b, out_a} = ring_q[out_q];
  wire [3:0] unused_children;
  //@ if fpga
  // The kind of an entry is known a cycle after the last item of the entry before was taken.
  reg        kind_q, columns_q, leaves_q;
  wire       next_columns, next_leaves;
  assign row_valid = row_waits && kind_q;
  assign {out_columns, out_leaves} = {columns_q, leaves_q};
  assign {next_columns, next_leaves, unused_children} = head_q[out_q];
  //@ else
  assign {out_columns, out_leaves, unused_children} = head_q[out_q];
  //@ end

  always @(posedge clk) begin
    if (clear) begin
      {in_q, stream_q, lanes_q, out_q} <= 8'd0;
      count_q <= 3'd0;
      {heads_q, asked_q, busy_q, ready_q, loaded_q} <= 5'd0;
      todo_q <= 16'd0;
      own_todo_q <= 1'b0;
      some_q <= 1'b0; //@ fpga
      s_side_q <= 1'b0; //@ !fpga
      {turn_q, cell_q, lane_q, row_q} <= 4'd0;
      turning_q <= {(BEFORE-1){1'b0}}; //@ fpga
      {cell_q2, lane_q2} <= 2'd0; //@ fpga
    end else begin
      in_q <= in_q + {1'b0, taken_in};
      stream_q <= stream_q + {1'b0, load};
      lanes_q <= lanes_q + {1'b0, read_t};
      out_q <= out_q + {1'b0, taken_out};
      count_q <= count_q + {2'd0, taken_in} - {2'd0, taken_out};
      heads_q <= taken_in;
      asked_q <= heads_q || (asked_q && !set_up);
      busy_q <= set_up || (busy_q && !first);
      ready_q <= turned_valid || (ready_q && !first);
      loaded_q <= load || (loaded_q && !first);
      if (load) begin
        todo_q <= next_mask_q[15:0] & {16{!next_own_q}};
        own_todo_q <= next_own_q;
        s_side_q <= next_side_q; //@ !fpga
      end else if (take) begin
        todo_q <= todo_q & ~pick;
        own_todo_q <= 1'b0;
      end
      turn_q <= take;
      //@ if fpga
      some_q <= load || (some_q && !(take && last));
      {cell_q, turning_q} <= {turning_q, turn_q};
      {row_q, lane_q2, lane_q, cell_q2} <= {lane_q2, lane_q, cell_q2, cell_q};
      //@ else
      cell_q <= turn_q;
      lane_q <= cell_q;
      row_q <= lane_q;
      //@ end
    end
    if (taken_in) begin
      ring_q[in_q] <= {in_side, in_b, in_a};
      side_q <= in_side;
      mask_q <= {8'd0, in_mask};
      own_q <= in_mask == 16'd0;
    end
    if (heads_q) begin
      head_q[newest] <= {leaf_s && !(leaf_t && !side_q) && !own_q, leaf_s && leaf_t && !own_q,
                         head_t[111:108]};
      if (own_q) begin
        mask_q <= head_s[247:224];
      end
      point_q <= {head_s[64 +: W], head_s[32 +: W], head_s[0 +: W]};
      origin_q <= {head_t[64 +: W], head_t[32 +: W], head_t[0 +: W]};
      s_exponents_q <= head_s[107:96];
      t_exponents_q <= head_t[107:96];
    end
    if (set_up) begin
      next_side_q <= side_q;
      next_own_q <= own_q;
      next_mask_q <= mask_q;
    end
    if (take) begin
      turn_first_q <= loaded_q;
      turn_last_q <= last;
      turn_side_q <= s_side_q; //@ !fpga
      pick_q <= pick; //@ fpga
      //@ if !fpga
      turn_index_q <= {|pick[15:8], |{pick[15:12], pick[7:4]},
                       |{pick[15:14], pick[11:10], pick[7:6], pick[3:2]},
                       |{pick[15], pick[13], pick[11], pick[9], pick[7], pick[5], pick[3],
                         pick[1]}};
      //@ end
    end
    //@ if fpga
    kind_q <= !taken_out;
    {columns_q, leaves_q} <= {next_columns, next_leaves};
    own_turn_q <= {own_turn_q[2:0], own_todo_q};
    if (take) begin
      own_mask_q <= next_mask_q;
    end
    if (load) begin
      s_slot_q <= next_side_q ? {1'b0, s_slot_a} : {1'b1, s_slot_b};
    end
    t_slot_q <= t_side ? {1'b1, t_slot_b} : {1'b0, t_slot_a};
    {cell_first_q, cell_last_q, cell_index_q, turns_q} <= {
      turns_q, turn_first_q, turn_last_q, box_index
    };
    if (turning_q[2] && turns_q[3*BOX-1]) begin
      {n_q, low_q, high_q, shift_q} <= {n, low, high, shift};
    end
    {cell_shift_q, shifts_q} <= {shifts_q, shift_q};
    {cell_last_q2, cell_index_q2} <= {cell_last_q, cell_index_q};
    children_q2 <= children_q;
    present_q <= present;
    //@ else
    cell_first_q <= turn_first_q;
    cell_last_q <= turn_last_q;
    cell_side_q <= turn_side_q;
    cell_index_q <= turn_index_q;
    cell_shift_q <= shift;
    //@ end
    if (read_t) begin
      t_side_q <= t_side; //@ !fpga
      children_q <= children;
    end
    //@ if fpga
    {lane_last_q, lane_index_q} <= {cell_last_q2, cell_index_q2};
    {lane_last_q2, lane_index_q2} <= {lane_last_q, lane_index_q};
    {row_last_q, row_index_q} <= {lane_last_q2, lane_index_q2};
    hits_q <= present_q & end_hits[15:0] & end_hits[31:16];
    //@ else
    lane_last_q <= cell_last_q;
    lane_index_q <= cell_index_q;
    row_last_q <= lane_last_q;
    row_index_q <= lane_index_q;
    hits_q <= present & end_hits[15:0] & end_hits[31:16];
    //@ end
  end
endmodule
