// SPDX-License-Identifier: MIT
// compare_tb - compare_top, W = 18, in Icarus: inputs and outputs of a trace
// (compare.cpp).
`timescale 1ns / 1ps
module compare_tb;
  reg clk = 0, rst, drop, in_valid, in_side, out_ready;
  reg [1:0] other;
  reg [15:0] in_mask;
  reg [5:0] in_a, in_b;
  reg [53:0] other_point;
  reg [395:0] matrix;
  reg [287:0] shift;
  reg [159:0] sigma;
  reg [255:0] head_a, head_b;
  reg [767:0] boxes_a, boxes_b;
  wire in_ready, read_a, read_b, out_valid, out_last, out_side, out_columns, out_leaves;
  wire [5:0] slot_a, slot_b, out_a, out_b;
  wire [3:0] out_index;
  wire [15:0] out_mask;
  reg [14:0] control, wanted_control;
  reg [35:0] item, wanted_item;
  reg e_ready, e_read_a, e_read_b, e_valid, e_last, e_side, e_columns, e_leaves;
  reg [5:0] e_slot_a, e_slot_b, e_a, e_b;
  reg [3:0] e_index;
  reg [15:0] e_mask;
  integer file, got, cycles = 0, items = 0, faults = 0;
  reg [1023:0] name;

  compare_top #(.W(18)) top (
    .clk(clk), .rst(rst), .drop(drop), .matrix(matrix), .shift(shift[263:0]),
    .sigma(sigma[143:0]), .in_valid(in_valid), .in_ready(in_ready), .in_side(in_side),
    .in_mask(in_mask), .in_a(in_a), .in_b(in_b), .head_a(head_a), .head_b(head_b),
    .boxes_read_a(read_a), .boxes_slot_a(slot_a), .boxes_a(boxes_a), .boxes_read_b(read_b),
    .boxes_slot_b(slot_b), .boxes_b(boxes_b), .out_valid(out_valid), .out_ready(out_ready),
    .out_last(out_last), .out_side(out_side), .out_columns(out_columns), .out_leaves(out_leaves),
    .out_index(out_index), .out_mask(out_mask), .out_a(out_a), .out_b(out_b), .other(other),
    .other_point(other_point), .other_valid(), .sum(), .setting_valid(), .n(), .low(), .high(),
    .cell_shift(), .cells_valid(), .cells(), .beyond()
  );

  initial begin
    if (!$value$plusargs("trace=%s", name)) begin
      $display("compare_tb: give +trace=FILE");
      $finish_and_return(2);
    end
    file = $fopen(name, "r");
    got = 31;
    while (got == 31) begin
      got = $fscanf(file, "%h %h %h %h %h %h %h %h %h %h %h %h %h %h %h %h %h", rst, drop, in_valid,
                    in_side, in_mask, in_a, in_b, out_ready, other, other_point, matrix, shift,
                    sigma, head_a, head_b, boxes_a, boxes_b);
      got = got + $fscanf(file, "%h %h %h %h %h %h %h %h %h %h %h %h %h %h", e_ready, e_read_a,
                          e_slot_a, e_read_b, e_slot_b, e_valid, e_last, e_side, e_columns,
                          e_leaves, e_index, e_mask, e_a, e_b);
      if (got == 31) begin
        #1;
        control = {in_ready, read_a, read_a ? slot_a : 6'd0, read_b, out_valid};
        wanted_control = {e_ready, e_read_a, e_read_a ? e_slot_a : 6'd0, e_read_b, e_valid};
        item = {out_last, out_side, out_columns, out_leaves, out_index, out_mask, out_a, out_b};
        wanted_item = {e_last, e_side, e_columns, e_leaves, e_index, e_mask, e_a, e_b};
        if (cycles >= 2 && (control !== wanted_control ||
                            (e_valid && item !== wanted_item) ||
                            (e_read_b && slot_b !== e_slot_b))) begin
          faults = faults + 1;
          $display("cycle %0d: %b %h, not %b %h", cycles, control, item, wanted_control,
                   wanted_item);
        end
        cycles = cycles + 1;
        items = items + ((e_valid && out_ready) ? 1 : 0);
        clk = 1;
        #1 clk = 0;
      end
    end
    $display("compare_tb: %0d cycles, %0d items, %0d faults", cycles, items, faults);
    $finish_and_return((faults > 0 || items == 0) ? 1 : 0);
  end
endmodule
