// SPDX-License-Identifier: MIT
// board_pll.v
//
// The board's 25 MHz to the clock of the engine: 25 MHz * MULTIPLY / DIVIDE. The PLL's oscillator
// runs at that times OUTPUT, which must be 400 ... 800 MHz; 25 MHz / DIVIDE must be 3.125 MHz or
// more (Lattice, ECP5 family data sheet, sysCLOCK PLL timing).

`default_nettype none

module board_pll #(
  parameter MULTIPLY = 4, // divider of the feedback, 1 ... 80
  parameter DIVIDE = 1,   // divider of the 25 MHz, 1 ... 8
  parameter OUTPUT = 6    // divider of the oscillator, 1 ... 128
) (
  input  wire clk_in, // 25 MHz
  output wire clk,    // the engine's clock
  output wire locked  // it is stable
);
  (* FREQUENCY_PIN_CLKI = "25" *)
  (* ICP_CURRENT = "12" *) (* LPF_RESISTOR = "8" *)
  (* MFG_ENABLE_FILTEROPAMP = "1" *) (* MFG_GMCREF_SEL = "2" *)
  EHXPLLL #(
    .PLLRST_ENA("DISABLED"), .INTFB_WAKE("DISABLED"), .STDBY_ENABLE("DISABLED"),
    .DPHASE_SOURCE("DISABLED"), .OUTDIVIDER_MUXA("DIVA"), .CLKI_DIV(DIVIDE),
    .CLKFB_DIV(MULTIPLY), .CLKOP_ENABLE("ENABLED"), .CLKOP_DIV(OUTPUT),
    .CLKOP_CPHASE(OUTPUT / 2 - 1), .CLKOP_FPHASE(0), .FEEDBK_PATH("CLKOP")
  ) pll (
    .CLKI(clk_in), .CLKFB(clk), .RST(1'b0), .STDBY(1'b0), .PHASESEL0(1'b0), .PHASESEL1(1'b0),
    .PHASEDIR(1'b1), .PHASESTEP(1'b1), .PHASELOADREG(1'b1), .PLLWAKESYNC(1'b0), .ENCLKOP(1'b0),
    .CLKOP(clk), .LOCK(locked)
  );
endmodule

`default_nettype wire
