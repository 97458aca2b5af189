// SPDX-License-Identifier: MIT
// Input and schedule: word k = 1, 2, 3 of a pair brings A_k, B_k and component k of
// N_A and N_B. The words fill the registers that a pair's first computations read; one bit
// a cycle tells where pairs are. Vectors are {z, y, x}, triangles {vertex 3, 2, 1}, signed each.
module sepax_input #(
  parameter V_W  = @vertex@, // bits of a coordinate
  parameter N_W  = @normal@, // bits of a normal's component
  parameter LAST = @latency@  // the cycle of the verdict; the first word comes in cycle 1
) (
  input  wire             clk,      // clock
  input  wire             rst,      // synchronous reset of the control, active high
  input  wire             in_valid, // an input word is here
  input  wire [3*V_W-1:0] in_a,     // A_k
  input  wire [3*V_W-1:0] in_b,     // B_k
  input  wire [N_W-1:0]   in_na,    // component k of N_A
  input  wire [N_W-1:0]   in_nb,    // component k of N_B
  output reg  [9*V_W-1:0] a,        // triangle A
  output reg  [9*V_W-1:0] b,        // triangle B
  output reg  [3*N_W-1:0] n_a,      // N_A
  output reg  [3*N_W-1:0] n_b,      // N_B
  output reg  [LAST-4:0]  step      // bit c - 4: a pair is in cycle c
);
  reg [1:0] word_q; // words taken of the pair, 0 ... 2

  always @(posedge clk) begin
    if (rst) begin
      word_q <= 2'd0;
      step <= {(LAST-3){1'b0}};
    end else begin
      if (in_valid) begin
        word_q <= (word_q == 2'd2) ? 2'd0 : (word_q + 2'd1);
      end
      step <= {step[LAST-5:0], in_valid && (word_q == 2'd2)};
    end
    if (in_valid) begin
      a <= {in_a, a[9*V_W-1:3*V_W]};
      b <= {in_b, b[9*V_W-1:3*V_W]};
      n_a <= {in_na, n_a[3*N_W-1:N_W]};
      n_b <= {in_nb, n_b[3*N_W-1:N_W]};
    end
  end
endmodule
