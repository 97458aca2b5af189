// One end of a turned box against those of 16 boxes: lane j is hit iff cells_i <= bounds_ji for the
// three axes i, and not beyond.
// Combinational.
module sepax_lanes (
  input  wire [23:0]  cells,  // {2, 1, 0}, 8 bits each, signed
  input  wire         beyond, // above all bounds
  input  wire [383:0] bounds, // of lane j at 24 j: {2, 1, 0}, 8 bits each, signed
  output wire [15:0]  hits    // bit j: lane j
);
  // a <= b, signed, by a carry that runs up.
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

  genvar j;
  generate
    for (j = 0; j < 16; j = j + 1) begin : lane
      assign hits[j] = !beyond && not_above(cells[7:0], bounds[24*j +: 8]) &&
                       not_above(cells[15:8], bounds[24*j+8 +: 8]) &&
                       not_above(cells[23:16], bounds[24*j+16 +: 8]);
    end
  endgenerate
endmodule
