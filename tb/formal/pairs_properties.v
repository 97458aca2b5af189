// pairs_properties.v - rows become pairs if leaves come, the turner turns and the cores take pairs:
// for Yosys' SAT solver, by induction. Data are any; an error or damage ends the run.
`default_nettype none

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
