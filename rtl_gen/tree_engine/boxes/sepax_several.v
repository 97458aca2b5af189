// SPDX-License-Identifier: MIT
// Finds the lowest bit that is 1 in a mask, and whether there are others. Combinational, without a
// carry chain.
module sepax_several (
  input  wire [15:0] mask,   // the bits to look at
  output wire        many,   // two or more are 1
  output wire [15:0] lowest  // one-hot: the lowest that is 1
);
  function many_of_4(input [3:0] a);
    many_of_4 = (a[3] && (|a[2:0])) || (a[2] && (|a[1:0])) || (a[1] && a[0]);
  endfunction

  function [3:0] lowest_of_4(input [3:0] a);
    lowest_of_4 = {a[3] && !(|a[2:0]), a[2] && !(|a[1:0]), a[1] && !a[0], a[0]};
  endfunction

  wire [3:0] some = {|mask[15:12], |mask[11:8], |mask[7:4], |mask[3:0]};
  wire [3:0] four = lowest_of_4(some); // one-hot: the group of four bits

  assign many = many_of_4(mask[15:12]) || many_of_4(mask[11:8]) || many_of_4(mask[7:4]) ||
                many_of_4(mask[3:0]) || many_of_4(some);
  genvar k;
  generate
    for (k = 0; k < 4; k = k + 1) begin : of_four
      assign lowest[4*k +: 4] = lowest_of_4(mask[4*k +: 4]) & {4{four[k]}};
    end
  endgenerate
endmodule
