// SPDX-License-Identifier: MIT
// One row of a multiplier: with digit = b, two's complement, -2, -1, 0, 1 or 2, //@ top
// One row of a multiplier: with digit = b - 2, which is -2, -1, 0 or 1, //@ two_less
// One row of a multiplier: with digit = b - 1, which is -1, 0, 1 or 2, //@ one_less
//   digit * a = row + negative modulo 2^ROW_W.
// Combinational.
module @name@ #(
  parameter A_W   = 8, // bits of a
  parameter ROW_W = 9  // bits of the row kept, 1 ... A_W + 1
) (
  input  wire signed [A_W-1:0] a, // the factor that is selected
  input  wire [2:0]       b,       // the highest bits of the other factor //@ top
  input  wire [1:0]       b,       // two bits of the other factor //@ !top
  output wire [ROW_W-1:0] row,     // the row, two's complement but for `negative`
  output wire             negative // to be added at the row's lowest bit
);
  wire [A_W+1:0] twice = {a[A_W-1], a, 1'b0}; // 2 a
//@ if top
  wire one = b[0];
  wire two = b[1] && !b[0];
  assign negative = b[2];
  assign row = ((twice[ROW_W:1] ^ {ROW_W{negative}}) & {ROW_W{one}}) |
               ((twice[ROW_W-1:0] ^ {ROW_W{negative}}) & {ROW_W{two}});
//@ end
//@ if two_less
  wire one = b == 2'd3;
  wire two = b == 2'd0;
  assign negative = !b[1];
  assign row = (twice[ROW_W:1] & {ROW_W{one}}) | (~twice[ROW_W-1:0] & {ROW_W{two}}) |
               (~twice[ROW_W:1] & {ROW_W{negative && !two}});
//@ end
//@ if one_less
  wire one = b == 2'd2;
  wire two = b == 2'd3;
  assign negative = b == 2'd0;
  assign row = (twice[ROW_W:1] & {ROW_W{one}}) | (twice[ROW_W-1:0] & {ROW_W{two}}) |
               (~twice[ROW_W:1] & {ROW_W{negative}});
//@ end

  generate
    if (ROW_W > A_W + 1) begin : check
      @name@_row_is_wider_than_twice_a fault ();
    end
    if (A_W + 1 > ROW_W) begin : cut
      wire [A_W-ROW_W:0] unused_bits = twice[A_W+1:ROW_W+1];
    end
  endgenerate
endmodule
