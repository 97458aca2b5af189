// SPDX-License-Identifier: MIT
// Simulation model of DSP48E2, of which Yosys has only a black box, as far as Yosys makes use of
// it: A times B, sums of X, Y, Z and W, registers of A, B, C, the product and P (Xilinx UG579). No
// pre-adder, patterns, SIMD; control is constant.
module DSP48E2 (
  output [29:0] ACOUT, output [17:0] BCOUT, output CARRYCASCOUT, output [3:0] CARRYOUT,
  output MULTSIGNOUT, output OVERFLOW, output [47:0] P, output PATTERNBDETECT,
  output PATTERNDETECT, output [47:0] PCOUT, output UNDERFLOW, output [7:0] XOROUT,
  input [29:0] A, input [29:0] ACIN, input [3:0] ALUMODE, input [17:0] B, input [17:0] BCIN,
  input [47:0] C, input CARRYCASCIN, input CARRYIN, input [2:0] CARRYINSEL,
  input CEA1, input CEA2, input CEAD, input CEALUMODE, input CEB1, input CEB2, input CEC,
  input CECARRYIN, input CECTRL, input CED, input CEINMODE, input CEM, input CEP, input CLK,
  input [26:0] D, input [4:0] INMODE, input MULTSIGNIN, input [8:0] OPMODE, input [47:0] PCIN,
  input RSTA, input RSTALLCARRYIN, input RSTALUMODE, input RSTB, input RSTC, input RSTCTRL,
  input RSTD, input RSTINMODE, input RSTM, input RSTP
);
  parameter ACASCREG = 1;
  parameter ADREG = 1;
  parameter ALUMODEREG = 1;
  parameter AREG = 1;
  parameter BCASCREG = 1;
  parameter BREG = 1;
  parameter CARRYINREG = 1;
  parameter CARRYINSELREG = 1;
  parameter CREG = 1;
  parameter DREG = 1;
  parameter INMODEREG = 1;
  parameter MREG = 1;
  parameter OPMODEREG = 1;
  parameter PREG = 1;
  parameter AMULTSEL = "A";
  parameter AUTORESET_PATDET = "NO_RESET";
  parameter AUTORESET_PRIORITY = "RESET";
  parameter A_INPUT = "DIRECT";
  parameter BMULTSEL = "B";
  parameter B_INPUT = "DIRECT";
  parameter PREADDINSEL = "A";
  parameter SEL_MASK = "MASK";
  parameter SEL_PATTERN = "PATTERN";
  parameter USE_MULT = "MULTIPLY";
  parameter USE_PATTERN_DETECT = "NO_PATDET";
  parameter USE_SIMD = "ONE48";
  parameter USE_WIDEXOR = "FALSE";
  parameter XORSIMD = "XOR24_48_96";
  parameter MASK = 0;
  parameter PATTERN = 0;
  parameter RND = 0;
  parameter IS_ALUMODE_INVERTED = 0;
  parameter IS_CARRYIN_INVERTED = 0;
  parameter IS_CLK_INVERTED = 0;
  parameter IS_INMODE_INVERTED = 0;
  parameter IS_OPMODE_INVERTED = 0;
  parameter IS_RSTALLCARRYIN_INVERTED = 0;
  parameter IS_RSTALUMODE_INVERTED = 0;
  parameter IS_RSTA_INVERTED = 0;
  parameter IS_RSTB_INVERTED = 0;
  parameter IS_RSTCTRL_INVERTED = 0;
  parameter IS_RSTC_INVERTED = 0;
  parameter IS_RSTD_INVERTED = 0;
  parameter IS_RSTINMODE_INVERTED = 0;
  parameter IS_RSTM_INVERTED = 0;
  parameter IS_RSTP_INVERTED = 0;
  wire [29:0] a = A_INPUT == "CASCADE" ? ACIN : A;
  wire [17:0] b = B_INPUT == "CASCADE" ? BCIN : B;
  reg [29:0] a_1, a_2;
  reg [17:0] b_1, b_2;
  reg [47:0] c_1, p_1;
  reg [44:0] m_1;
  wire [29:0] a_now = AREG == 0 ? a : a_2;
  wire [17:0] b_now = BREG == 0 ? b : b_2;
  wire [47:0] c_now = CREG == 0 ? C : c_1;
  wire signed [44:0] product = $signed(a_now[26:0]) * $signed(b_now);
  wire signed [44:0] m = MREG == 0 ? product : m_1;
  wire [47:0] m_now = {{3{m[44]}}, m};
  wire [47:0] x = OPMODE[1:0] == 2'd1 ? m_now : OPMODE[1:0] == 2'd2 ? P :
                  OPMODE[1:0] == 2'd3 ? {a_now, b_now} : 48'd0;
  wire [47:0] y = OPMODE[3:2] == 2'd3 ? c_now : OPMODE[3:2] == 2'd2 ? ~48'd0 : 48'd0;
  wire [47:0] z = OPMODE[6:4] == 3'd1 ? PCIN : OPMODE[6:4] == 3'd2 ? P :
                  OPMODE[6:4] == 3'd3 ? c_now :
                  OPMODE[6:4] == 3'd5 ? {{17{PCIN[47]}}, PCIN[47:17]} :
                  OPMODE[6:4] == 3'd6 ? {{17{P[47]}}, P[47:17]} : 48'd0;
  wire [47:0] w = OPMODE[8:7] == 2'd1 ? P : OPMODE[8:7] == 2'd3 ? c_now : 48'd0;
  wire [47:0] rest = x + y + w + CARRYIN;
  wire [47:0] sum = ALUMODE == 4'd3 ? z - rest : z + rest;
  assign P = PREG == 0 ? sum : p_1;
  assign PCOUT = P;
  assign ACOUT = ACASCREG == 1 && AREG == 2 ? a_1 : a_now;
  assign BCOUT = BCASCREG == 1 && BREG == 2 ? b_1 : b_now;
  always @(posedge CLK) begin
    if (RSTA) a_1 <= 30'd0; else if (CEA1) a_1 <= a;
    if (RSTA) a_2 <= 30'd0; else if (CEA2) a_2 <= AREG == 2 ? a_1 : a;
    if (RSTB) b_1 <= 18'd0; else if (CEB1) b_1 <= b;
    if (RSTB) b_2 <= 18'd0; else if (CEB2) b_2 <= BREG == 2 ? b_1 : b;
    if (RSTC) c_1 <= 48'd0; else if (CEC) c_1 <= C;
    if (RSTM) m_1 <= 45'd0; else if (CEM) m_1 <= product;
    if (RSTP) p_1 <= 48'd0; else if (CEP) p_1 <= sum;
  end
  generate if (AMULTSEL != "A" || BMULTSEL != "B" || USE_SIMD != "ONE48" || INMODEREG != 0 ||
               IS_CLK_INVERTED != 0) begin : other
    no_model_of_this_use use_of ();
  end endgenerate
endmodule
