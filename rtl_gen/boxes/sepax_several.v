// Are two or more bits set? Combinational, without a carry chain.
module sepax_several (
  input  wire [15:0] mask, // the bits
  output wire        many  // two or more are 1
);
  function many_of_4(input [3:0] a);
    many_of_4 = (a[3] && (|a[2:0])) || (a[2] && (|a[1:0])) || (a[1] && a[0]);
  endfunction

  assign many = many_of_4(mask[15:12]) || many_of_4(mask[11:8]) || many_of_4(mask[7:4]) ||
                many_of_4(mask[3:0]) ||
                many_of_4({|mask[15:12], |mask[11:8], |mask[7:4], |mask[3:0]});
endmodule
