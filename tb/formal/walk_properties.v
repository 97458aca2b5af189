// SPDX-License-Identifier: MIT
`default_nettype none
module walk_properties #(parameter STACK = `STACK, parameter LINE = `LINE) (
    input wire clk, start, probe, clear, row, node_in_ready, node_out_valid, node_out_error,
    input wire in_ready, out_valid, out_last, out_columns, out_leaves, leaf_in_ready, row_ready,
    input wire [3:0] level_a, level_b, out_index,
    input wire [15:0] out_mask,
    input wire [63:0] node_out
);
  localparam [15:0] PLACES = 1 << STACK;
  sepax_tree_walk #(.STACK(STACK), .LINE(LINE), .SLOT(2)) dut (
      .clk(clk), .start(start), .probe(probe), .clear(clear), .nodes_a(24'd0),
      .triangles_a(32'd0), .beats_a(32'd0), .nodes_b(24'd0), .triangles_b(25'd0), .beats_b(32'd0),
      .row(row), .row_leaf_a(23'd0), .row_leaf_b(23'd0), .row_a(4'd0), .row_b(4'd0),
      .node_in_ready(node_in_ready), .node_out_valid(node_out_valid), .node_out(node_out),
      .node_out_a(2'd0), .node_out_b(2'd0), .node_out_error(node_out_error),
      .head_a({68'd0, level_a, 4'd0}), .head_b({68'd0, level_b, 4'd0}), .in_ready(in_ready),
      .out_valid(out_valid), .out_last(out_last), .out_columns(out_columns),
      .out_leaves(out_leaves), .out_index(out_index), .out_mask(out_mask),
      .leaf_in_ready(leaf_in_ready), .row_ready(row_ready));
  (* hierconn *) wire \dut.push , \dut.pop , \dut.finish , \dut.is_push , \dut.is_own , \dut.full ;
  (* hierconn *) wire \dut.store , \dut.current_q , \dut.filling_q , \dut.walking ;
  (* hierconn *) wire [2:0] \dut.state_q , \dut.step_q , \dut.stored_q ;
  (* hierconn *) wire [LINE:0] \dut.line_q ;
  (* hierconn *) wire [STACK+1:0] \dut.load_q ;
  (* hierconn *) wire [8:0] \dut.height_q ;
  (* hierconn *) wire \dut.roots_q , \dut.probes ;
  (* hierconn *) wire [STACK:0] \dut.stack.count_q ;
  localparam [2:0] IDLE = 3'd0, PROBE = 3'd1, ROOT = 3'd2, FIRST = 3'd3, OVER = 3'd5;
  wire push = \dut.push , pop = \dut.pop , finish = \dut.finish , item = \dut.is_push ;
  wire own = \dut.is_own , walking = \dut.walking ;
  wire [2:0] state = \dut.state_q , stored = \dut.stored_q , step = \dut.step_q ;
  wire [15:0] line = \dut.line_q , load = \dut.load_q , count = \dut.stack.count_q ;

  // Levels: sums of the levels of an entry's nodes.
  reg [15:0] height;      // of both roots
  reg asked = 1'b0;       // a run began with other bodies
  reg probed = 1'b0;      // roots were read, maybe for a run before
  reg probing = 1'b0;     // and in the cycle before
  reg [15:0] most;        // none in the line is higher
  reg [15:0] level;       // of the oldest entry
  reg [15:0] made;        // what it has pushed
  reg [15:0] away;        // entries of the line that are not compared
  (* anyconst *) wire [STACK-1:0] watched; // a place of the stack
  reg [15:0] watched_level;
  (* anyseq *) wire [5:0] any_level, pushed_level, popped_level;
  wire is_watched = count - 16'd1 == {{(16-STACK){1'b0}}, watched};
  wire [15:0] in_level = state == ROOT ? height : walking ? {10'd0, pushed_level} : 16'd0;
  wire [15:0] out_level = is_watched ? watched_level : {10'd0, popped_level};
  reg begun = 1'b0;

  // Nobody holds the walk up.
  (* hierconn *) wire \dut.head_read , \dut.fetch , \dut.row_counted , \dut.no_leaves ;
  (* hierconn *) wire \dut.is_direct , \dut.faulty , \dut.out_ready , \dut.leaf_in_valid ;
  (* hierconn *) wire \dut.in_valid ;
  wire free = node_in_ready && in_ready && leaf_in_ready && row_ready && !clear &&
              (away == 16'd0 || node_out_valid) && (!\dut.current_q || out_valid);
  // What can happen only so often in a run, if the stack is bounded.
  wire moves = push || pop || finish || \dut.store || \dut.head_read || step != 3'd0 ||
               \dut.fetch || \dut.row_counted || (out_valid && \dut.out_ready ) ||
               \dut.faulty || \dut.no_leaves || state == ROOT || state == FIRST ||
               (\dut.filling_q && !pop);
  always @(posedge clk) begin
    begun <= 1'b1;
    if (state == PROBE) height <= {12'd0, level_a} + {12'd0, level_b};
    probing <= state == PROBE;
    probed <= probed || state == PROBE;
    asked <= asked || (start && probe);
    if (finish) level <= {10'd0, any_level};
    if (push && count == {{(16-STACK){1'b0}}, watched}) watched_level <= in_level;
    made <= (clear || finish) ? 16'd0 : made + {15'd0, item && push};
    if (pop) most <= line == 16'd0 ? out_level : height;
    else if (start) most <= height;
    away <= clear ? 16'd0 : away + {15'd0, (start && (\dut.probes || !row)) || pop} -
            {15'd0, \dut.store };
  end
  always @* begin
    assume (begun || clear);
    assume (!start || state == IDLE && !clear);
    assume (!start || probe || asked);
    assume (!node_out_valid || away != 16'd0);
    if (state == PROBE) begin
      assume (16'd15 * ({12'd0, level_a} + {12'd0, level_b}) + 16'd16 <= PLACES);
      // The heads stand while they are checked.
      if (\dut.current_q ) assume (height == {12'd0, level_a} + {12'd0, level_b});
    end
    // The trees: an item is one level lower; an own box has one item and does not go down.
    if (item && walking) begin
      assume (level <= most);
      assume (made < (own ? 16'd1 : 16'd16));
      assume (own ? pushed_level <= level : pushed_level < level);
    end
    // What is watched stands for each place.
    if (pop && !is_watched) begin
      assume (count + 16'd15 * popped_level <= PLACES && popped_level <= height);
    end
    if (probing) assert (probed);
    if (asked && \dut.roots_q ) assert (probed && 16'd15 * height + 16'd16 <= PLACES);
    if (asked && \dut.roots_q ) assert (state != PROBE);
    if (begun && state != IDLE) assert (asked);
    if (probed) assert (\dut.height_q == 16'd15 * height && height <= 16'd30);
    if (begun) begin
      // What came with an error is neither read nor compared.
      if (node_out_valid && node_out_error) assert (!\dut.head_read && !\dut.in_valid );
      assert (step == 3'd0 || step == 3'd1 || step == 3'd2 || step == 3'd4);
      assert (step == 3'd0 || away != 16'd0);
      assert (stored <= 3'd4 && !(step != 3'd0 && stored == 3'd4));
      assert (state <= 3'd5);
      if (state == PROBE && !probing) assert (!\dut.current_q );
      if (state == ROOT || state == FIRST || walking) assert (probed);
      if (state == IDLE) begin
        assert (away == 16'd0 && stored == 3'd0 && !\dut.current_q && line == 16'd0);
      end
      if (state != OVER) assert (line + (state == PROBE) == away + stored + \dut.current_q );
      if (state != OVER && !walking) assert (line == 16'd0 && made == 16'd0);
      if (state == ROOT || state == PROBE) assert (count == 16'd0);
      if (state == FIRST) assert (count == 16'd1);
      if (state == ROOT || state == FIRST || walking) begin
        assert (height <= 16'd30 && 16'd15 * height + 16'd16 <= PLACES);
        assert (load == count + 16'd16 * line + 16'd15 * height);
        if (count > {{(16-STACK){1'b0}}, watched}) begin
          assert (watched_level <= height &&
                  {{(16-STACK){1'b0}}, watched} + 16'd15 * watched_level < PLACES);
        end
      end
      if (free && (state == PROBE || walking)) assert (moves);
      assert (count <= PLACES && made <= 16'd16);
      if (state != OVER) assert (away <= line + 16'd1);
      if (walking) begin
        assert (line <= (16'd1 << LINE));
        assert (!(\dut.filling_q && made != 16'd0));
        if (line == 16'd1) assert (most <= height && count - made + 16'd15 * most < PLACES);
        if (line > 16'd1) begin
          assert (most <= height);
          assert (count - made + 16'd16 * line + 16'd15 * height <= PLACES);
        end
        assert (!(item && \dut.full ));
        assert (made == 16'd0 || \dut.current_q );
        assert (line != 16'd0 || \dut.filling_q );
      end
    end
  end
endmodule
