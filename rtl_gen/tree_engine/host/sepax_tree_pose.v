// SPDX-License-Identifier: MIT
// Holds the current pose, which comes in beats (docs/reference/tree-engine.md, Pose), and checks
// its ranges.
module sepax_tree_pose (
  input  wire         clk,      // clock
  input  wire         clear,    // another pose begins
  input  wire         load,     // a beat of the pose is here
  input  wire [3:0]   beat,     // number of the beat, 0 ... 8
  input  wire [127:0] data,     // the beat, byte 0 lowest
  output reg          bad,      // a number of the pose is out of its range
  output reg  [197:0] matrix_m, // M: entry (i, j) at 22 (3 i + j), signed, 2^-20
  output reg  [197:0] matrix_k, // K, in the same order
  output reg  [131:0] shift_t,  // t, {z, y, x}, signed, 44 bits each, 2^-20 LSB
  output reg  [131:0] shift_u,  // u, in the same order
  output reg  [71:0]  sigma_a,  // sigma_A, {z, y, x}, 24 bits each, 2^-10 LSB
  output reg  [71:0]  sigma_b   // sigma_B, in the same order
);
  reg  [3:0]  wide_matrix, wide_sigma; // bit k: word k of the beat is out of this range
  reg  [1:0]  wide_shift;
  reg         wrong;
  //@ if fpga
  reg  [3:0]  wide_matrix_q, wide_sigma_q;
  reg  [1:0]  wide_shift_q;
  reg         load_q, wrong_q;
  reg  [3:0]  beat_q;
  //@ end
  integer     k;

  always @(*) begin
    for (k = 0; k < 4; k = k + 1) begin
      wide_matrix[k] = data[32*k+31] ? !(&data[32*k+20 +: 11]) :
                       (|data[32*k+21 +: 10]) || (data[32*k+20] && (|data[32*k +: 20]));
      wide_sigma[k] = |data[32*k+24 +: 8];
    end
    for (k = 0; k < 2; k = k + 1) begin
      wide_shift[k] = (|data[64*k+43 +: 21]) && !(&data[64*k+43 +: 21]);
    end
    //@ if fpga
    case (beat_q)
      4'd0, 4'd1, 4'd2: wrong = |wide_shift_q;
      4'd3, 4'd4, 4'd5, 4'd6: wrong = |wide_matrix_q;
      4'd7: wrong = (|wide_matrix_q[1:0]) || (|wide_sigma_q[3:2]);
      default: wrong = |wide_sigma_q;
    endcase
    //@ else
    case (beat)
      4'd0, 4'd1, 4'd2: wrong = |wide_shift;
      4'd3, 4'd4, 4'd5, 4'd6: wrong = |wide_matrix;
      4'd7: wrong = (|wide_matrix[1:0]) || (|wide_sigma[3:2]);
      default: wrong = |wide_sigma;
    endcase
    //@ end
  end

  always @(posedge clk) begin
    bad <= !clear && (bad || (load && wrong)); //@ !fpga
    bad <= !clear && (bad || wrong_q); //@ fpga
    //@ if fpga
    {wide_matrix_q, wide_sigma_q, wide_shift_q} <= {wide_matrix, wide_sigma, wide_shift};
    {load_q, beat_q, wrong_q} <= {load, beat, load_q && wrong};
    //@ end
    if (load) begin
      case (beat)
        4'd0: shift_t[87:0] <= {data[107:64], data[43:0]};
        4'd1: begin
          shift_t[131:88] <= data[43:0];
          shift_u[43:0] <= data[107:64];
        end
        4'd2: shift_u[131:44] <= {data[107:64], data[43:0]};
        4'd3: matrix_m[87:0] <= {data[117:96], data[85:64], data[53:32], data[21:0]};
        4'd4: matrix_m[175:88] <= {data[117:96], data[85:64], data[53:32], data[21:0]};
        4'd5: begin
          matrix_m[197:176] <= data[21:0];
          matrix_k[65:0] <= {data[117:96], data[85:64], data[53:32]};
        end
        4'd6: matrix_k[153:66] <= {data[117:96], data[85:64], data[53:32], data[21:0]};
        4'd7: begin
          matrix_k[197:154] <= {data[53:32], data[21:0]};
          sigma_a[47:0] <= {data[119:96], data[87:64]};
        end
        default: begin
          sigma_a[71:48] <= data[23:0];
          sigma_b <= {data[119:96], data[87:64], data[55:32]};
        end
      endcase
    end
  end
endmodule
