// SPDX-License-Identifier: MIT
// Keeps poses, which come in beats (docs/reference/tree-engine.md, Pose), in 2^SLOTS slots, checks
// their ranges, and holds the pose that was read last. Each part of a pose has a memory of its own,
// so a pose is read in one cycle.
module sepax_tree_pose #(
  parameter SLOTS = 4 // log2 of the slots
) (
  input  wire             clk,        // clock
  input  wire             write,      // a beat of a pose has come
  input  wire [SLOTS-1:0] write_slot, // slot of the pose
  input  wire [3:0]       beat,       // number of the beat, 0 ... 8
  input  wire [127:0]     data,       // the beat, byte 0 lowest
  input  wire             error,      // it came with an error
  input  wire             read,       // read a pose
  input  wire [SLOTS-1:0] read_slot,  // its slot
  output wire             failed,     // it came with an error; from the next cycle on
  output wire             bad,        // a number of it is out of its range; from the next cycle on
  //@ if fpga
  output wire [197:0]     matrix_m,   // M: entry (i, j) at 22 (3 i + j), signed, 2^-20
  output wire [197:0]     matrix_k,   // K, in the same order
  output wire [131:0]     shift_t,    // t, {z, y, x}, signed, 44 bits each, 2^-20 LSB
  output wire [131:0]     shift_u,    // u, in the same order
  output wire [71:0]      sigma_a,    // sigma_A, {z, y, x}, 24 bits each, 2^-10 LSB
  output wire [71:0]      sigma_b     // sigma_B, in the same order; all from the next cycle on
  //@ else
  output reg  [197:0]     matrix_m,   // M: entry (i, j) at 22 (3 i + j), signed, 2^-20
  output reg  [197:0]     matrix_k,   // K, in the same order
  output reg  [131:0]     shift_t,    // t, {z, y, x}, signed, 44 bits each, 2^-20 LSB
  output reg  [131:0]     shift_u,    // u, in the same order
  output reg  [71:0]      sigma_a,    // sigma_A, {z, y, x}, 24 bits each, 2^-10 LSB
  output reg  [71:0]      sigma_b     // sigma_B, in the same order; all 2 cycles after the read
  //@ end
);
  localparam [3:0] LAST = 4'd8; // number of the last beat
  reg  [3:0]   wide_matrix, wide_sigma; // bit k: word k of the beat is out of this range
  reg  [1:0]   wide_shift;
  reg          wrong;                   // a number of the beat is out of its range
  reg          wrong_q, error_q;        // of the beats before
  wire [263:0] shift;                   // {u, t}
  wire [395:0] matrix;                  // {K, M}
  wire [143:0] sigma;                   // {sigma_B, sigma_A}
  integer      k;
  //@ if fpga
  // The ranges are checked a cycle later.
  reg  [3:0]       wide_matrix_q, wide_sigma_q;
  reg  [1:0]       wide_shift_q;
  reg              write_q, failed_q;
  reg  [SLOTS-1:0] slot_q;
  reg  [3:0]       beat_q;
  //@ end

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

  //@ if fpga
  sepax_ram #(.WIDTH(2), .ADDRESS(SLOTS), .DISTRIBUTED(1)) marks (
    .clk(clk), .write(write_q && (beat_q == LAST)), .write_address(slot_q),
    .write_data({error_q || failed_q, wrong_q || wrong}),
    .read(read), .read_address(read_slot), .read_data({failed, bad})
  );
  //@ else
  sepax_ram #(.WIDTH(2), .ADDRESS(SLOTS)) marks (
    .clk(clk), .write(write && (beat == LAST)), .write_address(write_slot),
    .write_data({error_q || error, wrong_q || wrong}),
    .read(read), .read_address(read_slot), .read_data({failed, bad})
  );
  //@ end

  // Beats 0 ... 2 are two shifts each, beats 3 ... 6 four entries of the matrices each.
  genvar i;
  generate
    for (i = 0; i < 3; i = i + 1) begin : shifts
      sepax_ram #(.WIDTH(88), .ADDRESS(SLOTS), .DISTRIBUTED(1)) pairs ( //@ fpga
      sepax_ram #(.WIDTH(88), .ADDRESS(SLOTS)) pairs ( //@ !fpga
        .clk(clk), .write(write && (beat == i[3:0])), .write_address(write_slot),
        .write_data({data[107:64], data[43:0]}), .read(read), .read_address(read_slot),
        .read_data(shift[88*i +: 88])
      );
    end
    for (i = 0; i < 4; i = i + 1) begin : entries
      localparam [31:0] BEAT = i + 3;
      sepax_ram #(.WIDTH(88), .ADDRESS(SLOTS), .DISTRIBUTED(1)) fours ( //@ fpga
      sepax_ram #(.WIDTH(88), .ADDRESS(SLOTS)) fours ( //@ !fpga
        .clk(clk), .write(write && (beat == BEAT[3:0])), .write_address(write_slot),
        .write_data({data[117:96], data[85:64], data[53:32], data[21:0]}), .read(read),
        .read_address(read_slot), .read_data(matrix[88*i +: 88])
      );
    end
  endgenerate
  sepax_ram #(.WIDTH(92), .ADDRESS(SLOTS), .DISTRIBUTED(1)) last_entries ( //@ fpga
  sepax_ram #(.WIDTH(92), .ADDRESS(SLOTS)) last_entries ( //@ !fpga
    .clk(clk), .write(write && (beat == 4'd7)), .write_address(write_slot),
    .write_data({data[119:96], data[87:64], data[53:32], data[21:0]}), .read(read),
    .read_address(read_slot), .read_data({sigma[47:0], matrix[395:352]})
  );
  sepax_ram #(.WIDTH(96), .ADDRESS(SLOTS), .DISTRIBUTED(1)) sigmas ( //@ fpga
  sepax_ram #(.WIDTH(96), .ADDRESS(SLOTS)) sigmas ( //@ !fpga
    .clk(clk), .write(write && (beat == LAST)), .write_address(write_slot),
    .write_data({data[119:96], data[87:64], data[55:32], data[23:0]}), .read(read),
    .read_address(read_slot), .read_data(sigma[143:48])
  );

  //@ if fpga
  assign {matrix_k, matrix_m} = matrix;
  assign {shift_u, shift_t} = shift;
  assign {sigma_b, sigma_a} = sigma;
  //@ end
  always @(posedge clk) begin
    //@ if fpga
    {wide_matrix_q, wide_sigma_q, wide_shift_q} <= {wide_matrix, wide_sigma, wide_shift};
    {write_q, slot_q, beat_q, failed_q} <= {write, write_slot, beat, error};
    if (write_q) begin
      wrong_q <= wrong || (wrong_q && (|beat_q));
      error_q <= failed_q || (error_q && (|beat_q));
    end
    //@ else
    if (write) begin
      wrong_q <= wrong || (wrong_q && (|beat));
      error_q <= error || (error_q && (|beat));
    end
    // Memories answer late in the cycle.
    {matrix_k, matrix_m} <= matrix;
    {shift_u, shift_t} <= shift;
    {sigma_b, sigma_a} <= sigma;
    //@ end
  end
endmodule
