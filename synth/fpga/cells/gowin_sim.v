// SPDX-License-Identifier: MIT
// Gowin's 18 x 18 multiplier, of which Yosys has no model: what UG287 (DSP user guide) says of
// signed and unsigned factors, and of the registers behind the factors and the product. Shift
// chains and other modes are not modelled; the project does not use them.
module MULT18X18 (
  input         CLK, CE, RESET,
  input  [17:0] A, B, SIA, SIB,
  input         ASIGN, BSIGN, ASEL, BSEL,
  output [35:0] DOUT,
  output [17:0] SOA, SOB
);
  parameter AREG = 1'b0;
  parameter BREG = 1'b0;
  parameter OUT_REG = 1'b0;
  parameter PIPE_REG = 1'b0;
  parameter ASIGN_REG = 1'b0;
  parameter BSIGN_REG = 1'b0;
  parameter SOA_REG = 1'b0;
  parameter MULT_RESET_MODE = "SYNC";
  reg [17:0] a_q, b_q;
  reg [35:0] p_q;
  wire [17:0] left = AREG ? a_q : A;
  wire [17:0] right = BREG ? b_q : B;
  wire [35:0] product = {{18{ASIGN && left[17]}}, left} * {{18{BSIGN && right[17]}}, right};

  always @(posedge CLK) begin
    a_q <= A;
    b_q <= B;
    p_q <= product;
  end

  assign DOUT = OUT_REG ? p_q : product;
endmodule
