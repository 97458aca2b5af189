// SPDX-License-Identifier: MIT
// pairs_properties.v - entries become items if the turner turns and the walk takes items; rows
// become pairs if leaves come, the turner turns and the cores take pairs: for Yosys' SAT solver,
// by induction. Data are any; an error or damage ends the run.
`default_nettype none

// What turns and compares boxes is left out, so hits are any.
module compare_properties (
    input wire clk, rst, in_valid, turn_ready, turned_valid, out_ready, in_side,
    input wire [15:0] in_mask,
    input wire [255:0] head_a, head_b
);
  wire in_ready, turn_valid, out_valid, out_last;
  reg flight = 1'b0; // the turner
  sepax_tree_compare #(.W(4), .SLOT(2)) dut (
      .clk(clk), .rst(rst), .drop(1'b0), .in_valid(in_valid), .in_ready(in_ready),
      .in_side(in_side), .in_mask(in_mask), .in_a(2'd0), .in_b(2'd0), .head_a(head_a),
      .head_b(head_b), .turn_valid(turn_valid), .turn_ready(turn_ready),
      .turned_valid(turned_valid), .out_valid(out_valid), .out_ready(out_ready),
      .out_last(out_last));
  (* hierconn *) wire \dut.heads_q , \dut.asked_q , \dut.busy_q , \dut.ready_q , \dut.loaded_q ;
  (* hierconn *) wire \dut.turn_q , \dut.cell_q , \dut.lane_q , \dut.row_q , \dut.some ;
  (* hierconn *) wire \dut.turn_last_q , \dut.cell_last_q , \dut.lane_last_q , \dut.row_last_q ;
  (* hierconn *) wire \dut.own_q , \dut.next_own_q , \dut.load , \dut.take , \dut.set_up ;
  (* hierconn *) wire \dut.row_valid , \dut.row_ready , \dut.row_last , \dut.out_columns ;
  (* hierconn *) wire \dut.hits.full_q , \dut.rows.push , \dut.rows.free ;
  (* hierconn *) wire [1:0] \dut.in_q , \dut.out_q ;
  (* hierconn *) wire [2:0] \dut.count_q , \dut.rows.head_q , \dut.rows.tail_q ;
  (* hierconn *) wire [3:0] \dut.rows.count_q ;
  (* hierconn *) wire [23:0] \dut.mask_q , \dut.next_mask_q ;
  reg [7:0] lasts_q = 8'd0; // rows that wait, the oldest lowest: which are the last of an entry
  wire pop = \dut.row_valid && \dut.row_ready ;
  wire [3:0] place = \dut.rows.count_q - {3'd0, pop};
  wire [3:0] steps = {3'd0, \dut.turn_q } + {3'd0, \dut.cell_q } + {3'd0, \dut.lane_q } +
                     {3'd0, \dut.row_q };
  wire [3:0] ends = {3'd0, \dut.turn_q && \dut.turn_last_q } +
                    {3'd0, \dut.cell_q && \dut.cell_last_q } +
                    {3'd0, \dut.lane_q && \dut.lane_last_q } +
                    {3'd0, \dut.row_q && \dut.row_last_q };
  wire [3:0] waiting = {3'd0, lasts_q[0]} + {3'd0, lasts_q[1]} + {3'd0, lasts_q[2]} +
                       {3'd0, lasts_q[3]} + {3'd0, lasts_q[4]} + {3'd0, lasts_q[5]} +
                       {3'd0, lasts_q[6]} + {3'd0, lasts_q[7]};
  wire free = !rst && turn_ready && (turned_valid || !flight) && out_ready;
  wire moves = \dut.heads_q || \dut.set_up || turned_valid || \dut.load || \dut.take ||
               \dut.turn_q || \dut.cell_q || \dut.lane_q || \dut.row_q || pop ||
               (out_valid && out_ready);
  reg begun = 1'b0;
  always @(posedge clk) begin
    begun <= 1'b1;
    flight <= !rst && (\dut.set_up || (flight && !turned_valid));
    lasts_q <= rst ? 8'd0 : (pop ? lasts_q >> 1 : lasts_q) |
                            ({7'd0, \dut.rows.push && \dut.row_last_q } << place);
  end
  always @* begin
    assume (begun == !rst);
    assume (!turned_valid || flight);
    // fifo_properties: words come out as they went in.
    assume (!\dut.row_valid || \dut.row_last == lasts_q[0]);
    if (begun) begin
      assert (!(\dut.heads_q && \dut.asked_q ));
      assert (!(\dut.heads_q || \dut.asked_q ) || \dut.own_q || (|\dut.mask_q [15:0]));
      assert (!\dut.busy_q || \dut.next_own_q || (|\dut.next_mask_q [15:0]));
      assert (\dut.busy_q == (flight || \dut.ready_q ) && !(flight && \dut.ready_q ));
      assert (!\dut.loaded_q || (\dut.ready_q && \dut.some ));
      assert (\dut.rows.free == (\dut.rows.count_q <= 4'd3));
      assert (\dut.rows.count_q <= 4'd8 && \dut.rows.count_q + steps <= 5'd8);
      assert (lasts_q >> \dut.rows.count_q == 8'd0);
      assert (!\dut.hits.full_q || \dut.out_columns );
      assert (\dut.count_q <= 3'd4 && \dut.in_q == \dut.out_q + \dut.count_q [1:0]);
      assert (\dut.count_q == {3'd0, \dut.heads_q || \dut.asked_q } + {3'd0, \dut.busy_q } +
              {3'd0, \dut.some && !\dut.loaded_q } + ends + waiting +
              {3'd0, \dut.hits.full_q });
      if (\dut.count_q != 3'd0 && free) assert (moves);
    end
  end
endmodule

module pairs_properties (
    input wire clk, rst, row_valid, row_last, leaf_out_valid, turn_ready, pair_ready,
    input wire [3:0] row_child,
    input wire [15:0] row_mask,
    input wire [14:0] corners_b,
    input wire [36:0] triangle_a, triangle_b
);
  wire turn_valid, pair_valid, leaf_out_ready;
  reg [2:0] turned = 3'd0; // the turner
  sepax_tree_pairs #(.W(4), .SLOT(2), .ROWS(2), .INFO(1)) dut (
      .clk(clk), .clear(rst), .row_valid(row_valid), .row_last(row_last), .row_child(row_child),
      .row_mask(row_mask), .leaf_out_valid(leaf_out_valid), .leaf_out_ready(leaf_out_ready),
      .leaf_out_a(2'd0), .leaf_out_b(2'd0), .leaf_out_info(1'b0), .leaf_out_error(1'b0),
      .triangle_a(triangle_a), .triangle_b(triangle_b), .corners_b(corners_b),
      .turn_valid(turn_valid), .turn_ready(turn_ready), .turned_valid(turned[2]),
      .turned(75'd0), .turned_damaged(1'b0), .pair_valid(pair_valid), .pair_ready(pair_ready));
  (* hierconn *) wire \dut.issue , \dut.next , \dut.spoilt , \dut.damaged , \dut.read ;
  (* hierconn *) wire \dut.valid_q , \dut.valid_q2 , \dut.valid_q3 , \dut.out_q ;
  (* hierconn *) wire \dut.first_q , \dut.first_q1 , \dut.error ;
  (* hierconn *) wire [15:0] \dut.mask_q ;
  (* hierconn *) wire [4:0] \dut.free_q , \dut.count_q ;
  (* hierconn *) wire [2:0] \dut.rows_q , \dut.row_queue.head_q , \dut.row_queue.tail_q ;
  (* hierconn *) wire \dut.row_queue.valid , \dut.row_queue.read ;
  (* hierconn *) wire \dut.rows.take , \dut.rows.match , \dut.rows.match_q , \dut.rows.done ;
  (* hierconn *) wire \dut.rows.real_row , \dut.rows.row_here , \dut.rows.out_real ;
  (* hierconn *) wire \dut.rows.out_valid , \dut.rows.rows.read , \dut.rows.flight_last ;
  (* hierconn *) wire \dut.rows.leaf_q ;
  (* hierconn *) wire [2:0] \dut.rows.new_q , \dut.rows.others ;
  (* hierconn *) wire [3:0] \dut.rows.used_q , \dut.rows.waiting_q , \dut.rows.here_q ;
  (* hierconn *) wire [3:0] \dut.rows.rows.head_q , \dut.rows.rows.tail_q ;
  wire [4:0] waiting = \dut.rows.waiting_q ;
  wire [2:0] behind = \dut.row_queue.tail_q - \dut.row_queue.head_q ;
  wire [3:0] rows_behind = \dut.rows.rows.tail_q - \dut.rows.rows.head_q ;
  wire some = |\dut.mask_q ;
  wire pop = \dut.rows.out_valid && \dut.next ;
  reg [2:0] last = 3'd0; // of its triangle, of the vertices in the turner
  reg [8:0] real_q = 9'd0; // rows that wait, the oldest lowest: which are not a mere end
  wire [8:0] left = pop ? real_q >> 1 : real_q;
  wire [4:0] place = waiting - {4'd0, pop};
  wire [4:0] turning = {4'd0, |\dut.rows.new_q } + {4'd0, turned[0] && last[0]} +
                       {4'd0, turned[1] && last[1]} + {4'd0, turned[2] && last[2]} +
                       {4'd0, \dut.rows.done };
  wire [4:0] reals = {4'd0, real_q[0]} + {4'd0, real_q[1]} + {4'd0, real_q[2]} +
                     {4'd0, real_q[3]} + {4'd0, real_q[4]} + {4'd0, real_q[5]} +
                     {4'd0, real_q[6]} + {4'd0, real_q[7]};
  wire work = \dut.rows_q != 3'd0 || waiting != 5'd0 || some || \dut.valid_q || \dut.valid_q2 ||
              \dut.valid_q3 || \dut.count_q != 5'd0 || \dut.out_q ;
  wire free = !rst && (pair_ready || !pair_valid) && turn_ready &&
              (leaf_out_valid || \dut.rows.leaf_q );
  wire moves = \dut.issue || \dut.next || \dut.read || (pair_valid && pair_ready) ||
               \dut.valid_q || \dut.valid_q2 || \dut.valid_q3 || \dut.row_queue.read ||
               \dut.rows.take || \dut.rows.match || \dut.rows.done || \dut.rows.rows.read ||
               (turn_valid && turn_ready) || turned != 3'd0 ||
               (leaf_out_valid && leaf_out_ready);
  reg begun = 1'b0;
  always @(posedge clk) begin
    begun <= 1'b1;
    turned <= rst ? 3'd0 : {turned[1:0], turn_valid && turn_ready};
    last <= {last[1:0], !(|\dut.rows.others )};
    real_q <= rst ? 9'd0 : left | ({8'd0, \dut.rows.take && \dut.rows.real_row } << place);
  end
  always @* begin
    assume (begun == !rst);
    assume (!\dut.spoilt );
    // fifo_properties: words come out as they went in.
    assume (!\dut.rows.row_here || \dut.rows.out_real == real_q[0]);
    assume (!turned[2] || \dut.rows.flight_last == last[2]);
    if (begun) begin
      assert (!\dut.damaged && !\dut.error );
      assert (\dut.rows_q <= 3'd4 && behind <= 3'd4);
      assert (\dut.rows_q == behind + {2'd0, \dut.row_queue.valid });
      assert (waiting <= 5'd8 && rows_behind <= 4'd8);
      assert (waiting == {1'b0, rows_behind} + {4'd0, \dut.rows.row_here });
      assert (real_q >> waiting == 9'd0);
      assert (reals == \dut.rows.here_q + {4'd0, \dut.rows.match_q } + turning);
      assert (\dut.rows.used_q <= 4'd8);
      assert (\dut.rows.used_q == turning + \dut.rows.here_q + {4'd0, \dut.first_q && some} +
              {4'd0, \dut.valid_q && \dut.first_q1 });
      assert (\dut.count_q <= 5'd16 && \dut.free_q <= 5'd16);
      assert (\dut.free_q + \dut.count_q + {4'd0, \dut.valid_q } + {4'd0, \dut.valid_q2 } +
              {4'd0, \dut.valid_q3 } == 6'd16);
      if (work && free) assert (moves);
    end
  end
endmodule

`default_nettype wire
