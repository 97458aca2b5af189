// SPDX-License-Identifier: MIT
// sepax_dsp on Gowin: MULT18X18 with its own registers; Yosys 0.23 infers no multiplier there. A
// longer factor stays with the module's Verilog. For techmap before hierarchy.
module sepax_dsp (clk, a, b, p);
  parameter A_W = 18;
  parameter B_W = 18;
  parameter P_W = 36;
  input clk;
  input signed [A_W-1:0] a;
  input signed [B_W-1:0] b;
  output signed [P_W-1:0] p;
  wire _TECHMAP_FAIL_ = A_W > 18 || B_W > 18 || P_W > 36;
  wire signed [17:0] x = a, y = b;
  wire [35:0] z;

  MULT18X18 #(
    .AREG(1'b1), .BREG(1'b1), .OUT_REG(1'b1), .PIPE_REG(1'b0), .ASIGN_REG(1'b0),
    .BSIGN_REG(1'b0), .SOA_REG(1'b0), .MULT_RESET_MODE("SYNC")
  ) _TECHMAP_REPLACE_ (
    .CLK(clk), .CE(1'b1), .RESET(1'b0), .A(x), .B(y), .ASIGN(1'b1), .BSIGN(1'b1), .SIA(18'd0),
    .SIB(18'd0), .ASEL(1'b0), .BSEL(1'b0), .DOUT(z), .SOA(), .SOB()
  );
  assign p = z[P_W-1:0];
endmodule
