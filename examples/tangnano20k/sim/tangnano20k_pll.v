// SPDX-License-Identifier: MIT
// tangnano20k_pll.v
//
// In place of ../rtl/tangnano20k_pll.v in a simulation, where the clock that is given is the
// engine's. It is stable after 16 cycles. A PLL that the GW2AR cannot make ends the simulation.

`default_nettype none

module tangnano20k_pll #(
  parameter MULTIPLY = 40, // as in ../rtl/tangnano20k_pll.v
  parameter DIVIDE = 9,
  parameter OUTPUT = 8
) (
  input  wire clk_27mhz, // the clock
  output wire clk,       // the same
  output wire locked     // it is stable
);
  localparam MHZ = 27 * MULTIPLY * OUTPUT / DIVIDE; // of the oscillator
  reg [4:0] count_q = 5'd0;

  assign clk = clk_27mhz;
  assign locked = count_q[4];

  always @(posedge clk_27mhz) begin
    count_q <= count_q + {4'd0, !count_q[4]};
  end

  initial begin
    if ((MHZ < 500) || (MHZ > 1250) || (DIVIDE > 9) || (MULTIPLY > 64)) begin
      $display("tangnano20k_pll: no such PLL: 27 MHz * %0d / %0d, times %0d", MULTIPLY, DIVIDE,
               OUTPUT);
      $finish;
    end
  end
endmodule

`default_nettype wire
