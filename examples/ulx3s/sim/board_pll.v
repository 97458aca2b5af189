// SPDX-License-Identifier: MIT
// board_pll.v
//
// In place of a board's rtl/board_pll.v in a simulation, where the clock that is given is the
// engine's. It is stable after 16 cycles. board.mk refuses a PLL that the FPGA does not have.

`default_nettype none

module board_pll #(
  parameter MULTIPLY = 1, // as in rtl/board_pll.v
  parameter DIVIDE = 1,
  parameter OUTPUT = 1
) (
  input  wire clk_in, // the clock
  output wire clk,    // the same
  output wire locked  // it is stable
);
  localparam unused_dividers = MULTIPLY + DIVIDE + OUTPUT;
  reg [4:0] count_q = 5'd0;

  assign clk = clk_in;
  assign locked = count_q[4];

  always @(posedge clk_in) begin
    count_q <= count_q + {4'd0, !count_q[4]};
  end
endmodule

`default_nettype wire
