// SPDX-License-Identifier: MIT
// sepax_tree_compare with its turner of vertices, which turns other vertices, too; and what the
// blocks in between say. For test benches.
`default_nettype none
module compare_top #(
  parameter W = 18
) (
  input  wire           clk,
  input  wire           rst,
  input  wire           drop,
  input  wire [395:0]   matrix,
  input  wire [263:0]   shift,
  input  wire [143:0]   sigma,
  input  wire           in_valid,
  output wire           in_ready,
  input  wire           in_side,
  input  wire [15:0]    in_mask,
  input  wire [5:0]     in_a,
  input  wire [5:0]     in_b,
  input  wire [255:0]   head_a,
  input  wire [255:0]   head_b,
  output wire           boxes_read_a,
  output wire [5:0]     boxes_slot_a,
  input  wire [767:0]   boxes_a,
  output wire           boxes_read_b,
  output wire [5:0]     boxes_slot_b,
  input  wire [767:0]   boxes_b,
  output wire           out_valid,
  input  wire           out_ready,
  output wire           out_last,
  output wire           out_side,
  output wire           out_columns,
  output wire           out_leaves,
  output wire [3:0]     out_index,
  output wire [15:0]    out_mask,
  output wire [5:0]     out_a,
  output wire [5:0]     out_b,
  input  wire [1:0]     other,       // {side, a vertex is turned in between}
  input  wire [3*W-1:0] other_point,
  output wire           other_valid,
  output wire [134:0]   sum,
  output wire           setting_valid, // the set-up of an entry
  output wire [107:0]   n,
  output wire [62:0]    low,
  output wire [62:0]    high,
  output wire [11:0]    cell_shift,
  output wire           cells_valid, // ends of a box: the lower, the upper
  output wire [47:0]    cells,
  output wire [1:0]     beyond
);
  wire           turn_valid, turn_side;
  wire [3*W-1:0] turn_point, turn_origin;
  reg  [2:0]     turned_q, other_q;

  sepax_tree_compare #(.W(W), .SLOT(6)) compare (
    .clk(clk), .rst(rst), .drop(drop), .matrix(matrix), .sigma(sigma), .in_valid(in_valid),
    .in_ready(in_ready), .in_side(in_side), .in_mask(in_mask), .in_a(in_a), .in_b(in_b),
    .head_a(head_a), .head_b(head_b), .boxes_read_a(boxes_read_a), .boxes_slot_a(boxes_slot_a),
    .boxes_a(boxes_a), .boxes_read_b(boxes_read_b), .boxes_slot_b(boxes_slot_b),
    .boxes_b(boxes_b), .turn_valid(turn_valid), .turn_ready(!other[0]), .turn_side(turn_side),
    .turn_point(turn_point), .turn_origin(turn_origin), .turned_valid(turned_q[2]), .turned(sum),
    .out_valid(out_valid), .out_ready(out_ready), .out_last(out_last), .out_side(out_side),
    .out_columns(out_columns), .out_leaves(out_leaves), .out_index(out_index),
    .out_mask(out_mask), .out_a(out_a), .out_b(out_b)
  );
  sepax_turn_vertex #(.W(W)) turner (
    .clk(clk), .matrix(matrix), .shift(shift), .side(other[0] ? other[1] : turn_side),
    .point(other[0] ? other_point : turn_point),
    .origin(other[0] ? {(3*W){1'b0}} : turn_origin),
    .sum(sum)
  );

  always @(posedge clk) begin
    turned_q <= (rst || drop) ? 3'd0 : {turned_q[1:0], turn_valid && !other[0]};
    other_q <= rst ? 3'd0 : {other_q[1:0], other[0]};
  end

  assign other_valid = other_q[2];
  assign setting_valid = compare.turn_q && compare.turn_first_q;
  assign n = compare.n;
  assign low = compare.low;
  assign high = compare.high;
  assign cell_shift = compare.shift;
  assign cells_valid = compare.lane_q;
  assign cells = compare.cells;
  assign beyond = compare.beyond;
endmodule
`default_nettype wire
