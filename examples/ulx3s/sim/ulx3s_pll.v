// SPDX-License-Identifier: MIT
// ulx3s_pll.v
//
// In place of ../rtl/ulx3s_pll.v in a simulation, where the clock that is given is the engine's. It
// is stable after 16 cycles. A PLL that the ECP5 cannot make ends the simulation.

`default_nettype none

module ulx3s_pll #(
  parameter MULTIPLY = 4, // as in ../rtl/ulx3s_pll.v
  parameter DIVIDE = 1,
  parameter OUTPUT = 6
) (
  input  wire clk_25mhz, // the clock
  output wire clk,       // the same
  output wire locked     // it is stable
);
  localparam MHZ = 25 * MULTIPLY * OUTPUT / DIVIDE; // of the oscillator
  reg [4:0] count_q = 5'd0;

  assign clk = clk_25mhz;
  assign locked = count_q[4];

  always @(posedge clk_25mhz) begin
    count_q <= count_q + {4'd0, !count_q[4]};
  end

  initial begin
    if ((MHZ < 400) || (MHZ > 800) || (DIVIDE > 8)) begin
      $display("ulx3s_pll: no such PLL: 25 MHz * %0d / %0d, times %0d", MULTIPLY, DIVIDE, OUTPUT);
      $finish;
    end
  end
endmodule

`default_nettype wire
