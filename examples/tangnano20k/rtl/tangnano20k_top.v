// SPDX-License-Identifier: MIT
// tangnano20k_top.v
//
// The object engine on the board Tang Nano 20K: requests come over USB (the BL616's serial line),
// collisions go back. The engine's clock is 27 MHz * MULTIPLY / DIVIDE. All but the pins and the
// PLL is that of examples/ulx3s.

`default_nettype none

module tangnano20k_top #(
  parameter MULTIPLY = 40, // the PLL: board_pll.v
  parameter DIVIDE = 9,
  parameter OUTPUT = 8,
  parameter BAUD = 3000000, // of the serial line, a hundredth above or below at most
  parameter CLOCKS = (27000000 / DIVIDE * MULTIPLY + BAUD / 2) / BAUD, // cycles a bit
  parameter IDLE = 22, // 2^IDLE cycles without a byte cut a packet short
  parameter RESULTS = 10 // 2^RESULTS results wait without holding up a run
) (
  input  wire       clk_27mhz, // the oscillator
  input  wire       uart_rx,   // from the BL616
  output wire       uart_tx,   // to it
  input  wire       button,    // S1, 1 while it is pressed: reset
  output wire [5:0] led        // 0: on; 0 ... 5 of ulx3s_leds.v
);
  wire       clk, locked;
  wire [7:0] on;
  wire       unused_leds = &on[7:6];

  assign led = ~on[5:0];

  board_pll #(.MULTIPLY(MULTIPLY), .DIVIDE(DIVIDE), .OUTPUT(OUTPUT)) pll (
    .clk_in(clk_27mhz), .clk(clk), .locked(locked)
  );

  ulx3s_board #(
    .CLOCK_HZ(27000000 / DIVIDE * MULTIPLY), .CLOCKS(CLOCKS), .IDLE(IDLE), .RESULTS(RESULTS)
  ) board (
    .clk(clk), .run({!button, locked}), .line_in(uart_rx), .line_out(uart_tx), .led(on)
  );
endmodule

`default_nettype wire
