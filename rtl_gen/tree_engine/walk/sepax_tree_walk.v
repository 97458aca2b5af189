// SPDX-License-Identifier: MIT
// The walk down two trees (docs/reference/tree-engine.md, Order): a stack of entries that wait, and
// a line of entries whose nodes were asked for. sepax_tree_compare tests the oldest entry of the
// line. Each of its items becomes a new entry or a row. Entries are popped only when an entry is
// finished.
//   entry = {direct, side, mask, number of A's node, of B's}
// direct marks the first row; its mask is {a, b}.
module sepax_tree_walk #(
  parameter STACK = 10, // log2 of the places of the stack, 9 or more
  parameter LINE = 5,   // log2 of the places of the line, 2 or more
  parameter SLOT = 6    // bits of a slot of the node cache
) (
  input  wire         clk,            // clock
  input  wire         start,          // a run begins
  input  wire         probe,          // with start: the bodies may be others than before
  input  wire         clear,          // drop all work: reset, or the end of a run
  output wire         over,           // the walk has ended, by itself or by a fault
  output reg          damaged,        // a node is damaged, or the stack is full
  output reg          error,          // a node came with an error
  // bodies
  input  wire [23:0]  nodes_a,        // nodes of A
  input  wire [31:0]  triangles_a,    // triangles of A
  input  wire [31:0]  beats_a,        // beats of A's image
  input  wire [23:0]  nodes_b,        // nodes of B
  input  wire [24:0]  triangles_b,    // triangles of B
  input  wire [31:0]  beats_b,        // beats of B's image
  input  wire         row,            // a first row is given
  input  wire [22:0]  row_leaf_a,     // first row: node number of A's leaf
  input  wire [22:0]  row_leaf_b,     // first row: node number of B's leaf
  input  wire [3:0]   row_a,          // first row: triangle a in A's leaf
  input  wire [3:0]   row_b,          // first row: triangle b in B's leaf
  // nodes
  output wire         node_in_valid,  // a pair of nodes is wanted
  input  wire         node_in_ready,  // it is taken in this cycle
  output wire [63:0]  node_in,        // the entry that wants them
  input  wire         node_out_valid, // the oldest pair is here, or has an error
  output wire         node_out_ready, // it is taken in this cycle
  input  wire [63:0]  node_out,       // the entry of the pair
  input  wire [SLOT-1:0] node_out_a,  // slot of A's node
  input  wire [SLOT-1:0] node_out_b,  // slot of B's node
  input  wire         node_out_error, // a node of the pair was not read
  output wire         node_release,   // the oldest pair that was taken is released
  output wire         head_read,      // read the heads of nodes node_out_a, node_out_b
  input  wire [75:0]  head_a,         // A's {record, first, beats - 1, level, children - 1}
  input  wire [75:0]  head_b,         // the same of B's; both from the next cycle on
  // compare
  output wire         in_valid,       // an entry is to be compared; its heads are read
  input  wire         in_ready,       // it is taken in this cycle
  output wire         in_side,        // side of the entry
  output wire [15:0]  in_mask,        // mask of the entry; 0: the node's own box
  output wire [SLOT-1:0] in_a,        // slot of A's node
  output wire [SLOT-1:0] in_b,        // slot of B's node
  input  wire         out_valid,      // an item
  output wire         out_ready,      // it is taken in this cycle
  input  wire         out_last,       // the last item of its entry
  input  wire         out_columns,    // items are columns: S is a leaf and T is not
  input  wire         out_leaves,     // S and T are leaves
  input  wire [3:0]   out_index,      // child of S; if columns, or leaves on side 1, child of T
  input  wire [15:0]  out_mask,       // the children of the other node that are hit
  input  wire         out_any,        // out_mask is not 0 //@ fpga
  input  wire [15:0]  out_half,       // out_mask, or 0 if it has more than 8 ones //@ fpga
  // rows
  output wire         leaf_in_valid,  // a pair of leaves is wanted
  input  wire         leaf_in_ready,  // it is taken in this cycle
  output wire [31:0]  leaf_in_a,      // place of A's record in the image, in beats
  output wire [3:0]   leaf_in_beats_a, // its beats less 1
  output wire [31:0]  leaf_in_b,      // place of B's record in the image, in beats
  output wire [3:0]   leaf_in_beats_b, // its beats less 1
  output wire [101:0] leaf_in_info,   // {leaf B, leaf A, first triangle of B, of A}
  output wire         row_valid,      // a row; with mask 0, only the end of a pair of leaves
  input  wire         row_ready,      // it is taken in this cycle
  output wire         row_last,       // the last row of its pair of leaves
  output wire [3:0]   row_child,      // number b of B's triangle
  output wire [15:0]  row_mask,       // mask of A's triangles
  // counts
  output wire         entry_counted,  // an entry was finished
  output reg  [4:0]   steps_counted,  // number of boxes that are turned
  output wire         row_counted     // a row was served
);
  localparam LOAD = STACK + 2; // bits of stack + 16 line + 15 HEIGHT
  localparam INFO = 220; // bits of an entry that are kept in a memory
  localparam FLAGS = 7;  // bits of an entry that are kept in registers
  localparam [LOAD-1:0] MOST = (1 << STACK) - 16; // highest load at which an entry is popped
  localparam [2:0] IDLE = 3'd0, PROBE = 3'd1, ROOT = 3'd2, FIRST = 3'd3, WALK = 3'd4, OVER = 3'd5;

  function [4:0] ones(input [15:0] mask);
    integer k;
    begin
      ones = 5'd0;
      for (k = 0; k < 16; k = k + 1) begin
        ones = ones + {4'd0, mask[k]};
      end
    end
  endfunction

  // If a box hits more than 8 children of a node, the node's own box is tested first.
  function [15:0] half(input [15:0] mask);
    half = mask & {16{ones(mask) <= 5'd8}};
  endfunction

  reg  [2:0]      state_q;
  reg  [LINE:0]   line_q;      // number of entries in the line
  reg  [LOAD-1:0] load_q;
  reg  [8:0]      height_q;    // 15 HEIGHT of the bodies
  reg  [3:0]      children_q;  // children of B's root less 1
  reg             roots_q;     // both are known: a probe of these bodies has ended
  wire            probes = probe || !roots_q; // with start: the roots are read first
  reg             filling_q;   // an entry was finished: entries may be popped
  reg             current_q;   // there is an entry whose items are served
  reg             opened_q;    // the leaves of this entry were asked for
  reg             wanted_q;    // this request has not been taken
  wire            walking = (state_q == WALK);

  wire [15:0]  first_mask = half(~(16'hfffe << children_q)); // of the root of B //@ !fpga
  //@ if fpga
  wire [15:0]  first_mask = ~(16'hfffe << children_q) & {16{!children_q[3]}}; // of the root of B
  //@ end

  // ------------------------------------------------------------- stack, line
  wire         push, pop, empty, full;
  wire [63:0]  pushed, top;
  wire         can_pop = !empty && !line_q[LINE] && (!(|line_q) || (load_q <= MOST));
  wire         finish;      // the oldest entry is finished

  assign pop = walking && filling_q && can_pop; //@ !fpga
  //@ if fpga
  // can_pop_q is valid (known_q) a cycle after a pop and two cycles after an entry was finished,
  // because a finished entry is counted a cycle later.
  reg             known_q, can_pop_q, finish_q, push_q;
  wire            filling = filling_q && !(known_q && !can_pop_q);

  assign pop = walking && filling_q && known_q && can_pop_q;
  //@ end

  sepax_tree_stack #(.WIDTH(64), .ADDRESS(STACK)) stack (
    .clk(clk), .clear(clear || start), .push(push), .in(pushed), .pop(pop), .top(top),
    .empty(empty), .full(full)
  );
  // First the probe, which reads both roots; then the popped entries. Without probe and first row,
  // the root's entry is the first one, and is not pushed on the stack.
  wire            direct_root = start && !probes && !row;
  sepax_ram_fifo #(.WIDTH(64), .QUICK(1), .ADDRESS(LINE)) line (
    .clk(clk), .clear(clear), .push(direct_root || (start && probes) || pop),
    .in(!start ? top : {2'd0, first_mask & {16{!probes}}, 46'd0}),
    .valid(node_in_valid), .pop(node_in_valid && node_in_ready), .out(node_in)
  );

  // --------------------------------------- heads, checked while the entry is set up
  reg  [2:0]   step_q; // one-hot: cycles since the heads were read
  reg  [1:0]   head_q, tail_q; // oldest entry and next free place in `compared`
  reg  [2:0]   stored_q; // number of entries in `compared`
  wire         bad_a, bad_b;
  wire         direct = node_out[63] || (state_q == PROBE);
  wire         begins = node_out_valid && !(|step_q) && !stored_q[2];
  wire         store = step_q[2] || (begins && node_out_error);
  wire         fetch = (|stored_q) && (!current_q || finish); //@ !fpga
  wire         fetch = (|stored_q) && !current_q; //@ fpga
  wire         is_error, is_bad, is_direct, is_own, side, leaf_a, leaf_b;
  wire [7:0]   child; // {a, b} of a first row
  wire [22:0]  node_a, node_b;
  wire [31:0]  first_a;
  wire [23:0]  first_b;
  wire [18:0]  after_a, after_b; // bits 22 ... 4 of first_a, of first_b, plus 1
  reg  [4*FLAGS-1:0] flags_q;    // flags of the entries in `compared` //@ !fpga
  reg  [FLAGS-1:0]   flags_q [0:3]; // flags of the entries in `compared` //@ fpga
  reg  [FLAGS-1:0]   flag_q;     // flags of the oldest entry

  assign head_read = begins && !node_out_error && (direct || in_ready);
  assign in_valid = begins && !node_out_error && !direct;
  assign {in_side, in_mask} = node_out[62:46];
  assign {in_a, in_b} = {node_out_a, node_out_b};
  assign node_out_ready = store;

  sepax_node_check check_a (
    .clk(clk), .step(step_q[1:0]), .children(head_a[3:0]), .level(head_a[7:4]),
    .last_beat(head_a[11:8]), .first(head_a[43:12]), .record(head_a[75:44]),
    .number(node_out[45:23]), .nodes(nodes_a), .triangles(triangles_a), .beats(beats_a),
    .bad(bad_a)
  );
  sepax_node_check check_b (
    .clk(clk), .step(step_q[1:0]), .children(head_b[3:0]), .level(head_b[7:4]),
    .last_beat(head_b[11:8]), .first(head_b[43:12]), .record(head_b[75:44]),
    .number(node_out[22:0]), .nodes(nodes_b), .triangles({7'd0, triangles_b}), .beats(beats_b),
    .bad(bad_b)
  );
  sepax_ram #(.WIDTH(INFO), .ADDRESS(2)) compared (
    .clk(clk), .write(store), .write_address(tail_q),
    .write_data({
      head_a[34:16] + 19'd1, head_b[34:16] + 19'd1, node_out[53:46], node_out[45:0],
      head_a[43:12], head_b[35:12], head_a[75:44], head_a[11:8], head_b[75:44], head_b[11:8]
    }),
    .read(fetch), .read_address(head_q),
    .read_data({
      after_a, after_b, child, node_a, node_b, first_a, first_b, leaf_in_a, leaf_in_beats_a,
      leaf_in_b, leaf_in_beats_b
    })
  );
  assign {is_error, is_bad, is_direct, is_own, side, leaf_a, leaf_b} = flag_q;

  // ------------------------------------------------------ items of the oldest entry
  wire         faulty = current_q && (is_error || is_bad);
  wire         served = current_q && !faulty && !(filling_q && can_pop); //@ !fpga
  //@ if fpga
  reg          probe_q, first_q, items_q; // served now: the probe, a first row, items
  wire         serves = current_q && !faulty && !filling && !finish;
  wire         first_row = first_q;
  wire         item = items_q && out_valid;
  wire         hit = out_any;
  //@ else
  wire         first_row = served && walking && is_direct;
  wire         item = served && walking && !is_direct && out_valid;
  wire         hit = |out_mask;
  //@ end
  wire         is_push = item && hit && (is_own || !out_leaves);
  wire         is_row = item && out_leaves && !is_own;
  wire         has_rows = first_row || (is_row && hit);
  wire         last = first_row || out_last;
  // The leaves are asked for with the first row. The last row waits until this request was taken.
  wire         leaves_due = leaf_in_valid && !leaf_in_ready; //@ !fpga
  wire         no_leaves = first_row && !(leaf_a && leaf_b);
  wire         no_nodes = ({1'b0, row_leaf_a} >= nodes_a) || ({1'b0, row_leaf_b} >= nodes_b);
  wire         of_b = out_columns ? side : !side; // the new node is a child of B's node
  wire [4:0]   low_a = {1'b0, first_a[3:0]} + {1'b0, out_index};
  wire [4:0]   low_b = {1'b0, first_b[3:0]} + {1'b0, out_index};
  wire [22:0]  next_a = {low_a[4] ? after_a : first_a[22:4], low_a[3:0]};
  wire [22:0]  next_b = {low_b[4] ? after_b : first_b[22:4], low_b[3:0]};
  //@ if fpga
  reg          release_q;
  reg  [15:0]  boxes_q;   // boxes that are turned
  reg          own_box_q; // the box is an own box
  //@ end
  wire         rows_ready = row_ready && !(last && leaves_due); //@ !fpga
  wire         leaves_gone = opened_q && !wanted_q; // the request for the leaves was taken //@ fpga
  wire         rows_wait = last && !leaves_gone; //@ fpga

  assign leaf_in_valid = (has_rows && !no_leaves && !opened_q) || wanted_q; //@ !fpga
  assign leaf_in_valid = wanted_q; //@ fpga
  assign leaf_in_info = {node_b, node_a, first_b, first_a};
  assign row_valid = (has_rows || (is_row && last && opened_q)) && !no_leaves &&
                     !(last && leaves_due); //@ !fpga
                     !rows_wait; //@ fpga
  assign row_last = last;
  assign row_child = first_row ? child[3:0] : out_index;
  assign row_mask = first_row ? 16'd1 << child[7:4] : out_mask;
  assign out_ready = item && (is_row ? (!(has_rows || opened_q) || rows_ready) : 1'b1); //@ !fpga
  //@ if fpga
  wire         rows_here = row_ready && !(out_last && !leaves_gone); // a row may go
  assign out_ready = item && (!out_leaves || is_own || !(hit || opened_q) || rows_here);
  //@ end
  assign finish = served && (state_q == PROBE || (item && out_ready && last) || //@ !fpga
                             (first_row && !no_leaves && rows_ready)); //@ !fpga
  //@ if fpga
  // The last item is a push, a row after the leaves' request was taken, or neither.
  assign finish = probe_q || (first_q && leaf_a && leaf_b && row_ready && leaves_gone) ||
                  (item && out_last && (!out_leaves || is_own || !(hit || opened_q) ||
                                        (row_ready && leaves_gone)));
  //@ end
  assign node_release = finish; //@ !fpga
  assign node_release = release_q; //@ fpga
  assign push = (is_push && !full) || (state_q == ROOT) || (state_q == FIRST);
  assign pushed = (state_q == ROOT) ? {2'd0, first_mask, 46'd0} :
    (state_q == FIRST) ? {2'd2, 8'd0, row_a, row_b, row_leaf_a, row_leaf_b} :
    is_own ? {1'b0, !side, out_mask, node_a, node_b} :
    {1'b0, side ^ !out_columns, @half@, of_b ? node_a : next_a, of_b ? next_b : node_b};
  assign over = (state_q == OVER);
  assign entry_counted = finish && walking && !is_direct;
  assign row_counted = has_rows && !no_leaves && row_valid && row_ready;

  always @(posedge clk) begin
    if (clear) begin
      state_q <= IDLE;
    end else begin
      case (state_q)
        IDLE: state_q <= !start ? IDLE : probes ? PROBE : row ? ROOT : WALK;
        PROBE: state_q <= faulty ? OVER : finish ? ROOT : PROBE;
        ROOT: state_q <= row ? FIRST : WALK;
        FIRST: state_q <= no_nodes ? OVER : WALK;
        WALK: begin
          if (faulty || no_leaves || (is_push && full) ||
              (filling_q && empty && !(|line_q))) begin
            state_q <= OVER;
          end
        end
        default: state_q <= OVER;
      endcase
    end
    if (clear) begin
      line_q <= {(LINE+1){1'b0}};
      step_q <= 3'd0;
      {head_q, tail_q, stored_q} <= 7'd0;
      {filling_q, current_q, opened_q, wanted_q} <= 4'd0;
      {known_q, can_pop_q, release_q, probe_q, first_q, items_q} <= 6'd0; //@ fpga
      {finish_q, push_q} <= 2'd0; //@ fpga
    end else begin
      if (state_q == IDLE) begin
        line_q <= {{LINE{1'b0}}, direct_root};
      end else if (walking) begin
        //@ if fpga
        line_q <= finish_q ? line_q - {{LINE{1'b0}}, 1'b1} : line_q + {{LINE{1'b0}}, pop};
        //@ else
        line_q <= line_q + {{LINE{1'b0}}, pop} - {{LINE{1'b0}}, finish};
        //@ end
      end
      step_q <= {step_q[1:0], head_read};
      tail_q <= tail_q + {1'b0, store};
      head_q <= head_q + {1'b0, fetch};
      stored_q <= stored_q + {2'd0, store} - {2'd0, fetch};
      filling_q <= finish || ((state_q == ROOT) && !row) || (state_q == FIRST) ||
                   @filling@;
      //@ if fpga
      probe_q <= serves && (state_q == PROBE);
      first_q <= serves && walking && is_direct;
      items_q <= serves && walking && !is_direct;
      known_q <= walking && filling_q && !pop && !finish && !finish_q;
      {can_pop_q, release_q, finish_q, push_q} <= {can_pop, finish, finish && walking, push};
      //@ end
      current_q <= fetch || (current_q && !finish);
      opened_q <= !finish && (opened_q || (has_rows && !no_leaves));
      wanted_q <= leaves_due; //@ !fpga
      wanted_q <= wanted_q ? !leaf_in_ready : has_rows && !no_leaves && !opened_q; //@ fpga
    end
    if (start) begin
      {damaged, error} <= 2'd0;
    end else if (state_q != OVER) begin
      damaged <= (faulty && !is_error) || no_leaves || (is_push && full) ||
                 ((state_q == FIRST) && no_nodes);
      error <= faulty && is_error;
    end
    if (state_q == PROBE) begin
      height_q <= {{1'b0, head_a[7:4]} + {1'b0, head_b[7:4]}, 4'd0} -
                  {4'd0, {1'b0, head_a[7:4]} + {1'b0, head_b[7:4]}};
      children_q <= head_b[3:0];
    end
    if (start && probe) begin
      roots_q <= 1'b0;
    end else if (finish && (state_q == PROBE)) begin
      roots_q <= 1'b1;
    end
    if ((state_q == IDLE) || (state_q == PROBE)) begin
      load_q <= {{(LOAD-9){1'b0}}, height_q} + {{(LOAD-5){1'b0}}, direct_root, 4'd0};
    //@ if fpga
    end else if (finish_q) begin // of the cycle before; never with pop
      load_q <= load_q + {{(LOAD-4){1'b1}}, 3'd0, push_q};
    end else begin
      load_q <= load_q + {{(LOAD-4){1'b0}}, {3{pop}}, pop || push_q};
    end
    //@ else
    end else begin
      load_q <= load_q + {{(LOAD-1){1'b0}}, push} - {{(LOAD-1){1'b0}}, pop} +
                {{(LOAD-5){1'b0}}, pop, 4'd0} -
                {{(LOAD-5){1'b0}}, finish && walking, 4'd0};
    end
    //@ end
    //@ if fpga
    if (store) begin
      flags_q[tail_q] <= {
        node_out_error, bad_a || bad_b, direct, !(|node_out[61:46]), node_out[62],
        !(|head_a[7:4]), !(|head_b[7:4])
      };
    end
    if (fetch) begin
      flag_q <= flags_q[head_q];
    end
    //@ else
    if (store) begin
      flags_q[5'd7 * {3'd0, tail_q} +: FLAGS] <= {
        node_out_error, bad_a || bad_b, direct, !(|node_out[61:46]), node_out[62],
        !(|head_a[7:4]), !(|head_b[7:4])
      };
    end
    if (fetch) begin
      flag_q <= flags_q[5'd7 * {3'd0, head_q} +: FLAGS];
    end
    //@ end
    steps_counted <= ((|in_mask) ? ones(in_mask) : 5'd1) & {5{in_valid && in_ready}}; //@ !fpga
    //@ if fpga
    boxes_q <= in_mask & {16{in_valid && in_ready}};
    own_box_q <= in_valid && in_ready && !(|in_mask);
    steps_counted <= own_box_q ? 5'd1 : ones(boxes_q);
    //@ end
  end
endmodule
