// SPDX-License-Identifier: MIT
// Comparisons as the sign of a difference on one carry chain. Yosys's own alumacc asks a chain for
// equality, too, where "less or equal" or "greater" is wanted, which takes tables; and for Gowin
// Yosys 0.23 maps that equality wrongly. For techmap in front of synth_*, in all modules.
(* techmap_celltype = "$lt $gt $le $ge" *)
module _80_sepax_compare (A, B, Y);
  parameter A_SIGNED = 0;
  parameter B_SIGNED = 0;
  parameter A_WIDTH = 1;
  parameter B_WIDTH = 1;
  parameter Y_WIDTH = 1;
  parameter _TECHMAP_CELLTYPE_ = "";
  localparam GREATER = _TECHMAP_CELLTYPE_ == "$gt" || _TECHMAP_CELLTYPE_ == "$le";
  localparam NOT = _TECHMAP_CELLTYPE_ == "$le" || _TECHMAP_CELLTYPE_ == "$ge";
  localparam N = (A_WIDTH > B_WIDTH ? A_WIDTH : B_WIDTH) + 1;

  input [A_WIDTH-1:0] A;
  input [B_WIDTH-1:0] B;
  output [Y_WIDTH-1:0] Y;
  wire [N-1:0] a, b, difference, x, co;

  \$pos #(.A_SIGNED(A_SIGNED), .A_WIDTH(A_WIDTH), .Y_WIDTH(N)) of_a (.A(A), .Y(a));
  \$pos #(.A_SIGNED(B_SIGNED), .A_WIDTH(B_WIDTH), .Y_WIDTH(N)) of_b (.A(B), .Y(b));
  \$alu #(
    .A_SIGNED(0), .B_SIGNED(0), .A_WIDTH(N), .B_WIDTH(N), .Y_WIDTH(N)
  ) subtract (
    .A(GREATER ? b : a), .B(GREATER ? a : b), .CI(1'b1), .BI(1'b1), .X(x), .Y(difference), .CO(co)
  );
  assign Y = difference[N-1] ^ NOT;
endmodule
