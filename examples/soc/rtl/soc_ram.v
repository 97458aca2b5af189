// SPDX-License-Identifier: MIT
// soc_ram.v
//
// The CPU's memory, which begins with the program. Latency 1.

`default_nettype none

module soc_ram #(
  parameter FIRMWARE = "firmware.hex", // the program, a word of 32 bits a line
  parameter ADDRESS = 14               // log2 of the words
) (
  input  wire               clk,     // clock
  input  wire [ADDRESS-1:0] address, // of a word
  input  wire [3:0]         strobes, // bytes to write
  input  wire [31:0]        wdata,   // data to write
  output reg  [31:0]        rdata    // the word, from the next cycle on
);
  reg [31:0] word_q [0:(1<<ADDRESS)-1];

  initial begin
    $readmemh(FIRMWARE, word_q);
  end

  always @(posedge clk) begin
    if (strobes[0]) begin
      word_q[address][7:0] <= wdata[7:0];
    end
    if (strobes[1]) begin
      word_q[address][15:8] <= wdata[15:8];
    end
    if (strobes[2]) begin
      word_q[address][23:16] <= wdata[23:16];
    end
    if (strobes[3]) begin
      word_q[address][31:24] <= wdata[31:24];
    end
    rdata <= word_q[address];
  end
endmodule

`default_nettype wire
