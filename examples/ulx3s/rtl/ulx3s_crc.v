// SPDX-License-Identifier: MIT
// ulx3s_crc.v
//
// CRC of one more byte: polynomial x^16 + x^12 + x^5 + 1, highest bit first (CRC-16/CCITT-FALSE
// where it begins with ffff). The CRC of a packet followed by its own CRC, high byte first, is 0.
// Combinational.

`default_nettype none

module ulx3s_crc (
  input  wire [15:0] crc,  // of the bytes before
  input  wire [7:0]  data, // a byte
  output wire [15:0] next  // of all
);
  wire [7:0] high = crc[15:8] ^ data;
  wire [7:0] mixed = high ^ {4'd0, high[7:4]};

  assign next = {crc[7:0], 8'd0} ^ {mixed[3:0], 12'd0} ^ {3'd0, mixed, 5'd0} ^ {8'd0, mixed};
endmodule

`default_nettype wire
