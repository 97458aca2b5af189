// SPDX-License-Identifier: MIT
// Compares one end of a turned box with 16 boxes: lane j is hit if and only if cells_i <= bounds_ji
// for the three axes i, and `beyond` is 0.
// Combinational. //@ !fpga
// Latency 1. //@ fpga
module sepax_lanes (
  input  wire         clk,    // clock //@ fpga
  input  wire [23:0]  cells,  // {2, 1, 0}, 8 bits each, signed
  input  wire         beyond, // cells are above all bounds
  input  wire [383:0] bounds, // lane j at 24 j: {2, 1, 0}, 8 bits each, signed
  output wire [15:0]  hits    // bit j: lane j is hit
);
//@ if !fpga
  // a <= b, signed, by a carry from bit 0 upwards.
  function not_above(input [7:0] a, input [7:0] b);
    integer n;
    begin
      not_above = 1'b1;
      for (n = 0; n < 7; n = n + 1) begin
        not_above = (!a[n] && b[n]) || ((!a[n] || b[n]) && not_above);
      end
      not_above = (a[7] && !b[7]) || ((a[7] || !b[7]) && not_above);
    end
  endfunction

//@ else
  reg         beyond_q;
  reg  [47:0] hit_q; // lane j at 3 j, axis by axis
//@ end
  genvar j;
  genvar i; //@ fpga
  generate
    for (j = 0; j < 16; j = j + 1) begin : lane
      //@ if fpga
      for (i = 0; i < 3; i = i + 1) begin : axis
        always @(posedge clk) begin
          hit_q[3*j+i] <= $signed(cells[8*i +: 8]) <= $signed(bounds[24*j+8*i +: 8]);
        end
      end
      assign hits[j] = !beyond_q && (&hit_q[3*j +: 3]);
      //@ else
      assign hits[j] = !beyond && not_above(cells[7:0], bounds[24*j +: 8]) &&
                       not_above(cells[15:8], bounds[24*j+8 +: 8]) &&
                       not_above(cells[23:16], bounds[24*j+16 +: 8]);
      //@ end
    end
  endgenerate
//@ if fpga

  always @(posedge clk) begin
    beyond_q <= beyond;
  end
//@ end
endmodule
