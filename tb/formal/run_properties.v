// SPDX-License-Identifier: MIT
// run_properties.v - a run ends, and takes the verdicts of the cores, if results are taken: for
// Yosys' SAT solver, by induction.
`default_nettype none

module run_properties #(
    parameter FLIGHT = 5
) (
    input wire clk, rst, start, stop, first, quiet, walk_over, walk_damaged, walk_error,
    input wire pairs_busy, pairs_damaged, pairs_error, memory_idle, launched, verdict_valid,
    input wire collision, coplanar, warning, outside, result_ready,
    input wire [31:0] budget
);
  wire idle, launch_free, verdict_ready, result_valid;
  reg [7:0] cores = 8'd0; // pairs in the cores
  sepax_tree_run #(.FLIGHT(FLIGHT)) dut (
      .clk(clk), .rst(rst), .start(start), .stop(stop), .first(first), .quiet(quiet),
      .budget(budget), .idle(idle), .walk_over(walk_over), .walk_damaged(walk_damaged),
      .walk_error(walk_error), .pairs_busy(pairs_busy), .pairs_damaged(pairs_damaged),
      .pairs_error(pairs_error), .memory_idle(memory_idle), .entry_counted(1'b0),
      .steps_counted(5'd0), .row_counted(1'b0), .pair_counted(1'b0), .launched(launched),
      .launch_free(launch_free), .launched_info(110'd0), .in_flight(cores != 8'd0),
      .verdict_valid(verdict_valid), .verdict_ready(verdict_ready), .collision(collision),
      .coplanar(coplanar), .warning(warning), .outside(outside), .result_valid(result_valid),
      .result_ready(result_ready));
  (* hierconn *) wire \dut.busy_q , \dut.ending_q , \dut.leave , \dut.finish , \dut.halt ;
  (* hierconn *) wire \dut.drop , \dut.records.valid , \dut.records.read ;
  (* hierconn *) wire [1:0] \dut.dropped_q ;
  (* hierconn *) wire [FLIGHT:0] \dut.known_q , \dut.records.head_q , \dut.records.tail_q ;
  wire [FLIGHT:0] behind = \dut.records.tail_q - \dut.records.head_q ;
  wire taken = verdict_valid && verdict_ready;
  wire running = \dut.busy_q && !\dut.ending_q ;
  wire drained = !pairs_busy && (walk_over || pairs_damaged || pairs_error);
  wire work = \dut.busy_q && (\dut.ending_q || cores != 8'd0 || drained);
  wire free = !rst && result_ready && (cores == 8'd0 || verdict_valid) && memory_idle && !launched;
  wire moves = taken || \dut.records.read || \dut.finish || \dut.halt || \dut.leave ||
               \dut.drop || (\dut.ending_q && !(&\dut.dropped_q ));
  reg begun = 1'b0;
  always @(posedge clk) begin
    begun <= 1'b1;
    cores <= rst ? 8'd0 : cores + {7'd0, launched} - {7'd0, taken};
  end
  always @* begin
    assume (begun == !rst);
    assume (!verdict_valid || cores != 8'd0);
    assume (!launched || (launch_free && running));
    assume (!start || idle);
    if (begun) begin
      assert (\dut.busy_q || (!\dut.ending_q && cores == 8'd0));
      assert (cores <= 8'd1 << FLIGHT);
      if (running) begin
        assert (\dut.known_q == cores && cores == behind + \dut.records.valid );
      end
      if (work && free) assert (moves);
    end
  end
endmodule

`default_nettype wire
