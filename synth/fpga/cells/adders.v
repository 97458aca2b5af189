// SPDX-License-Identifier: MIT
// Additions and subtractions as one carry chain each. Yosys's own alumacc merges those of a sum of
// several terms into compressors of look-up tables, which take a table or two more a bit, and
// leaves no place for the multiplexer in front of an operand. For techmap in front of synth_*, in
// all modules but those of products, whose additions a DSP takes.
(* techmap_celltype = "$add $sub" *)
module _80_sepax_adder (A, B, Y);
  parameter A_SIGNED = 0;
  parameter B_SIGNED = 0;
  parameter A_WIDTH = 1;
  parameter B_WIDTH = 1;
  parameter Y_WIDTH = 1;
  parameter _TECHMAP_CELLTYPE_ = "";
  localparam SUB = _TECHMAP_CELLTYPE_ == "$sub";

  input [A_WIDTH-1:0] A;
  input [B_WIDTH-1:0] B;
  output [Y_WIDTH-1:0] Y;
  wire [Y_WIDTH-1:0] x, co;

  \$alu #(
    .A_SIGNED(A_SIGNED), .B_SIGNED(B_SIGNED), .A_WIDTH(A_WIDTH), .B_WIDTH(B_WIDTH),
    .Y_WIDTH(Y_WIDTH)
  ) _TECHMAP_REPLACE_ (.A(A), .B(B), .CI(SUB), .BI(SUB), .X(x), .Y(Y), .CO(co));
endmodule
