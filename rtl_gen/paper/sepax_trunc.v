// SPDX-License-Identifier: MIT
// Drop the low bits of a number: kept = floor(value / 2^(IN_W - OUT_W)).
// Combinational; no gates. The only place where the datapath loses bits.
module sepax_trunc #(
  parameter IN_W  = 8, // bits of the exact value
  parameter OUT_W = 8  // bits kept, 1 ... IN_W
) (
  input  wire signed [IN_W-1:0]  value, // exact value
  output wire signed [OUT_W-1:0] kept   // its OUT_W most significant bits
);
  generate
    if (OUT_W > IN_W) begin : check
      sepax_trunc_keeps_more_bits_than_there_are fault ();
    end
    if (IN_W > OUT_W) begin : dropped
      wire [IN_W-OUT_W-1:0] unused_bits = value[IN_W-OUT_W-1:0];
    end
  endgenerate

  assign kept = value[IN_W-1:IN_W-OUT_W];
endmodule
