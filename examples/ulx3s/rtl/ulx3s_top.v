// SPDX-License-Identifier: MIT
// ulx3s_top.v
//
// The object engine on the board ULX3S: requests come over USB (the FT231X's serial line),
// collisions go back. The engine's clock is 25 MHz * MULTIPLY / DIVIDE.

`default_nettype none

module ulx3s_top #(
  parameter MULTIPLY = 4, // the PLL: board_pll.v
  parameter DIVIDE = 1,
  parameter OUTPUT = 6,
  parameter BAUD = 3000000, // of the serial line, a hundredth above or below at most
  parameter CLOCKS = (25000000 / DIVIDE * MULTIPLY + BAUD / 2) / BAUD, // cycles a bit
  parameter IDLE = 22, // 2^IDLE cycles without a byte cut a packet short
  parameter RESULTS = 12 // 2^RESULTS results wait without holding up a run
) (
  input  wire       clk_25mhz,  // the oscillator
  input  wire       ftdi_txd,   // from the FT231X
  output wire       ftdi_rxd,   // to it
  input  wire [0:0] btn,        // FIRE 0, 0 while it is pressed: reset
  output wire [7:0] led,        // ulx3s_leds.v
  output wire       wifi_gpio0  // 1: the ESP32 lets the board be
);
  wire clk, locked;

  assign wifi_gpio0 = 1'b1;

  board_pll #(.MULTIPLY(MULTIPLY), .DIVIDE(DIVIDE), .OUTPUT(OUTPUT)) pll (
    .clk_in(clk_25mhz), .clk(clk), .locked(locked)
  );

  ulx3s_board #(
    .CLOCK_HZ(25000000 / DIVIDE * MULTIPLY), .CLOCKS(CLOCKS), .IDLE(IDLE), .RESULTS(RESULTS)
  ) board (
    .clk(clk), .run({btn[0], locked}), .line_in(ftdi_txd), .line_out(ftdi_rxd), .led(led)
  );
endmodule

`default_nettype wire
