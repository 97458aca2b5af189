// SPDX-License-Identifier: MIT
// The tree engine and its cores for test benches, without registers and jobs. Faults that a test
// plants in the modules read `fault`.
module sepax_tree_bench #(
  parameter W = 18, parameter MARGIN = 0, parameter STACK = 10,
  parameter LINE = 5, parameter FLIGHT = 5, parameter NODE_SETS = 4, parameter LEAF_SETS = 2,
  parameter ROWS = 7
) (
  input wire [31:0] fault,
  input wire clk, rst, start, stop, cold, probe, first, quiet, row,
  input wire [31:0] budget, triangles_a, beats_a, triangles_b, beats_b, nodes_a, nodes_b,
  input wire [31:0] base_a, base_b, row_leaf_a, row_leaf_b, row_a, row_b,
  input wire [197:0] matrix_m, matrix_k,
  input wire [131:0] shift_t, shift_u,
  input wire [71:0] sigma_a, sigma_b,
  output wire idle, done, hit, any, stopped, damaged, error, memory_idle,
  output wire result_valid, result_coplanar, result_outside, result_warning,
  input wire result_ready,
  output wire [31:0] result_a, result_b, entries, steps, rows, pairs, near_pairs, collisions,
  output wire [31:0] out_of_range, warnings, cycles, first_a, first_b, first_leaf_a,
  output wire [31:0] first_leaf_b, first_row_a, first_row_b,
  output wire arvalid, rready,
  input wire arready, rvalid, rlast,
  output wire pair_valid, pair_ready, pair_outside,
  output wire [9*W-1:0] pair_a, pair_b,
  output wire [39:0] araddr,
  output wire [7:0] arlen,
  input wire [127:0] rdata,
  input wire [1:0] rresp
);
  wire in_flight, verdict_valid, verdict_ready;
  wire clear_counts = start, host_valid = 1'b0; // and no bursts of a host
  wire [35:0] host_address = 36'd0;
  wire [3:0] host_beats = 4'd0;
  wire host_ready, host_fill, host_last, host_error;
  wire [127:0] host_data;
  wire [3:0] host_beat;
  wire collision, coplanar, warning, verdict_outside;

  assign memory_idle = engine.memory_idle;
  assign result_b[31:24] = 8'd0;
  assign first_b[31:24] = 8'd0;
  assign first_leaf_a[31:23] = 9'd0;
  assign first_leaf_b[31:23] = 9'd0;
  assign first_row_a[31:4] = 28'd0;
  assign first_row_b[31:4] = 28'd0;

  sepax_tree_engine #(
    .W(W), .MARGIN(MARGIN), .STACK(STACK), .LINE(LINE), .FLIGHT(FLIGHT),
    .NODE_SETS(NODE_SETS), .LEAF_SETS(LEAF_SETS), .ROWS(ROWS)
  ) engine (
    .base_a(base_a[27:0]), .base_b(base_b[27:0]), .nodes_a(nodes_a[23:0]),
    .nodes_b(nodes_b[23:0]), .triangles_b(triangles_b[24:0]), .row_leaf_a(row_leaf_a[22:0]),
    .row_leaf_b(row_leaf_b[22:0]), .row_a(row_a[3:0]), .row_b(row_b[3:0]),
    .result_b(result_b[23:0]), .near(near_pairs), .first_b(first_b[23:0]),
    .first_leaf_a(first_leaf_a[22:0]), .first_leaf_b(first_leaf_b[22:0]),
    .first_row_a(first_row_a[3:0]), .first_row_b(first_row_b[3:0]), .*
  );
`ifdef SEPAX_LIMITS
`else
  assign warning = 1'b0;
`endif
  sepax_cores cores (
    .pair_info(pair_outside), .verdict_info(verdict_outside),
`ifdef SEPAX_LIMITS
    .warning(warning),
`endif
    .*
  );
endmodule
