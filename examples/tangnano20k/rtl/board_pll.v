// SPDX-License-Identifier: MIT
// board_pll.v
//
// The board's 27 MHz to the clock of the engine: 27 MHz * MULTIPLY / DIVIDE. The PLL's oscillator
// runs at that times OUTPUT, which must be 500 ... 1250 MHz; 27 MHz / DIVIDE must be 3 MHz or more
// (Gowin, GW2AR series data sheet, PLL switching characteristics).

`default_nettype none

module board_pll #(
  parameter MULTIPLY = 40, // divider of the feedback, 1 ... 64
  parameter DIVIDE = 9,    // divider of the 27 MHz, 1 ... 9
  parameter OUTPUT = 8     // divider of the oscillator: 2, 4, 8, 16, 32, 48, 64, 80, 96, 112, 128
) (
  input  wire clk_in, // 27 MHz
  output wire clk,    // the engine's clock
  output wire locked  // it is stable
);
  wire unused_p, unused_d, unused_d3;

  rPLL #(
    .FCLKIN("27"), .IDIV_SEL(DIVIDE - 1), .FBDIV_SEL(MULTIPLY - 1), .ODIV_SEL(OUTPUT),
    .DYN_IDIV_SEL("false"), .DYN_FBDIV_SEL("false"), .DYN_ODIV_SEL("false"),
    .DYN_DA_EN("false"), .PSDA_SEL("0000"), .DUTYDA_SEL("1000"), .DYN_SDIV_SEL(2),
    .CLKOUT_FT_DIR(1'b1), .CLKOUTP_FT_DIR(1'b1), .CLKOUT_DLY_STEP(0), .CLKOUTP_DLY_STEP(0),
    .CLKFB_SEL("internal"), .CLKOUT_BYPASS("false"), .CLKOUTP_BYPASS("false"),
    .CLKOUTD_BYPASS("false"), .CLKOUTD_SRC("CLKOUT"), .CLKOUTD3_SRC("CLKOUT"),
    .DEVICE("GW2AR-18C")
  ) pll (
    .CLKIN(clk_in), .CLKFB(1'b0), .RESET(1'b0), .RESET_P(1'b0), .FBDSEL(6'd0), .IDSEL(6'd0),
    .ODSEL(6'd0), .PSDA(4'd0), .DUTYDA(4'd0), .FDLY(4'd0), .CLKOUT(clk), .LOCK(locked),
    .CLKOUTP(unused_p), .CLKOUTD(unused_d), .CLKOUTD3(unused_d3)
  );
endmodule

`default_nettype wire
