// SPDX-License-Identifier: MIT
// The numbers of a pose stand at the tree engine, as they came from the memory, when a run begins
// and when it ends (docs/reference/tree-engine.md, the record of a pose).
module sepax_pose_check (
  input wire clk, resetn, fill, take, start, done,
  input wire [3:0] fill_slot, take_slot, beat,
  input wire [127:0] data,
  input wire [197:0] matrix_m, matrix_k,
  input wire [131:0] shift_t, shift_u,
  input wire [71:0] sigma_a, sigma_b
);
  reg [1151:0] records [0:15], record;
  reg same;
  integer k;

  always @(*) begin
    same = 1'b1;
    for (k = 0; k < 9; k = k + 1) begin
      same = same && matrix_m[22*k +: 22] == record[32*(12+k) +: 22] &&
             matrix_k[22*k +: 22] == record[32*(21+k) +: 22];
    end
    for (k = 0; k < 3; k = k + 1) begin
      same = same && shift_t[44*k +: 44] == record[64*k +: 44] &&
             shift_u[44*k +: 44] == record[64*(3+k) +: 44] &&
             sigma_a[24*k +: 24] == record[32*(30+k) +: 24] &&
             sigma_b[24*k +: 24] == record[32*(33+k) +: 24];
    end
  end

  always @(posedge clk) begin
    if (fill) records[fill_slot][128*beat +: 128] <= data;
    if (take) record <= records[take_slot];
    if (resetn && (start || done) && !same) $fatal(1, "a number of the pose is another one");
  end
endmodule

bind sepax_engine sepax_pose_check pose_check (
  .clk(aclk), .resetn(aresetn), .fill(pose_fill), .take(take_pose), .start(run_start),
  .done(run_done), .fill_slot(fill_slot), .take_slot(take_slot), .beat(host_beat),
  .data(host_data), .matrix_m(matrix_m), .matrix_k(matrix_k), .shift_t(shift_t),
  .shift_u(shift_u), .sigma_a(sigma_a), .sigma_b(sigma_b)
);
