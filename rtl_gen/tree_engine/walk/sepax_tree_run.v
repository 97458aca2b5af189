// SPDX-License-Identifier: MIT
// Begins and ends a run of the tree engine, counts verdicts, and sends the pairs that collide or
// are in the warning band. A run ends when all pairs are judged, at a fault, or when it is stopped.
module sepax_tree_run #(
  parameter FLIGHT = 5 // log2 of the most pairs in the cores
) (
  input  wire         clk,             // clock
  input  wire         rst,             // synchronous reset, active high
  input  wire         start,           // a run begins
  input  wire         clear_counts,    // set the counters to 0; not while a run counts
  input  wire         stop,            // end the run
  input  wire         first,           // end the run at its first collision
  input  wire         quiet,           // send no results
  input  wire [31:0]  budget,          // cycles after which the run ends
  output wire         idle,            // a run may begin
  output reg          drop,            // a pulse: drop all pending work of the run
  output reg          done,            // a pulse: the run has ended
  output wire         hit,             // its first collision is here //@ !fpga
  output reg          hit,             // its first collision was here in the cycle before //@ fpga
  // walk, pairs, memory
  input  wire         walk_over,       // the walk has ended
  input  wire         walk_damaged,    // the walk ended at a damaged node or a full stack
  input  wire         walk_error,      // the walk ended at a bus error
  input  wire         pairs_busy,      // rows or pairs are in progress
  input  wire         pairs_damaged,   // a triangle is damaged
  input  wire         pairs_error,     // a pair of leaves came with an error
  input  wire         memory_idle,     // no burst is open
  input  wire         entry_counted,   // an entry was finished
  input  wire [4:0]   steps_counted,   // number of boxes that were turned
  input  wire         row_counted,     // a row was served
  input  wire         pair_counted,    // a pair was tested
  // near pairs on their way to the cores
  input  wire         launched,        // a pair goes to the cores
  output wire         launch_free,     // a pair may go to the cores
  input  wire [109:0] launched_info,   // {leaf B, leaf A, first triangle of B's leaf, of A's, b, a}
  // verdicts
  input  wire         in_flight,       // the cores have pairs
  input  wire         verdict_valid,   // a verdict
  output wire         verdict_ready,   // it is taken in this cycle
  input  wire         collision,       // the triangles collide
  input  wire         coplanar,        // the triangles are coplanar
  input  wire         warning,         // the pair is in the warning band
  input  wire         outside,         // a coordinate of B does not fit W bits
  // results
  output reg          result_valid,    // a result
  input  wire         result_ready,    // it is taken in this cycle
  output reg  [31:0]  result_a,        // number of A's triangle in its tree
  output reg  [23:0]  result_b,        // number of B's triangle in its tree
  output reg          result_coplanar, // the triangles are coplanar
  output reg          result_outside,  // a coordinate of B does not fit W bits
  output reg          result_warning,  // the pair is in the warning band
  // status and counters
  output reg          any,             // a collision was found
  output reg          stopped,         // first, budget or stop ended the run
  output reg          damaged,         // a node or triangle is damaged
  output reg          error,           // the memory answered with an error
  output reg  [31:0]  entries,         // entries finished
  output reg  [31:0]  steps,           // boxes turned
  output reg  [31:0]  rows,            // rows
  output reg  [31:0]  pairs,           // pairs tested
  output reg  [31:0]  near,            // near pairs with a verdict
  output reg  [31:0]  collisions,      // near pairs that collide or are out of range
  output reg  [31:0]  out_of_range,    // near pairs that are out of range
  output reg  [31:0]  warnings,        // near pairs in the warning band
  output reg  [31:0]  cycles,          // cycles from start on
  output reg  [31:0]  first_a,         // first collision: A's triangle
  output reg  [23:0]  first_b,         // first collision: B's triangle
  output reg  [22:0]  first_leaf_a,    // first collision: A's leaf
  output reg  [22:0]  first_leaf_b,    // first collision: B's leaf
  output reg  [3:0]   first_row_a,     // first collision: number a in A's leaf
  output reg  [3:0]   first_row_b      // first collision: number b in B's leaf
);
  localparam [FLIGHT:0] ONE = 1;
  //@ if fpga
  reg          near_q, found_q, undecided_q, warned_q; // counts of the cycle before
  reg          full_q;     // a verdict waits in the registers
  reg          collision_q, coplanar_q, warning_q, outside_q;
  reg          pairs_busy_q; // pairs_busy of the cycle before
  reg          due_q;      // cycles have reached the budget
  reg  [31:0]  before_q;   // budget - 1
  //@ end
  reg          busy_q;     // a run is in progress
  reg          ending_q;   // the run ends: it waits for pending work
  reg  [1:0]   dropped_q;  // after two cycles the dropped work is gone
  reg          nothing_q;  // the run ended by itself, without a fault: no work is dropped
  reg          entry_q, row_q, pair_q; // counts of the cycle before
  reg  [4:0]   steps_q;
  reg  [FLIGHT:0] known_q; // pairs whose verdicts have not come
  wire         known;
  wire [22:0]  leaf_a, leaf_b;
  wire [31:0]  base_a;
  wire [23:0]  base_b;
  wire [3:0]   row_a, row_b;
  wire [31:0]  a = base_a + {28'd0, row_a};
  wire [23:0]  b = base_b + {20'd0, row_b};
  wire         judged = known && verdict_valid && verdict_ready; //@ !fpga
  wire         free = !result_valid || result_ready; //@ !fpga
  wire         free = !result_valid; // whoever takes results is far away //@ fpga
  //@ if fpga
  wire         counts = full_q && (ending_q || (known && free)); // the verdict is counted
  wire         judged = known && counts;
  wire         counted = counts && !ending_q;
  wire         found = counted && (collision_q || outside_q);
  wire         warned = counted && warning_q && !collision_q && !outside_q;
  wire         running = busy_q && !ending_q;
  wire         halt = running && (stop || (first && hit) || due_q);
  wire         drained = !pairs_busy_q && !in_flight && !full_q && !launched && free;
  //@ else
  wire         counted = verdict_valid && verdict_ready && !ending_q;
  wire         found = counted && (collision || outside);
  wire         warned = counted && warning && !collision && !outside;
  wire         running = busy_q && !ending_q;
  wire         halt = running && (stop || (first && hit) || (cycles == budget));
  wire         drained = !pairs_busy && !in_flight && !launched && free;
  //@ end
  wire         fault = pairs_damaged || pairs_error;
  wire         finish = running && drained && (walk_over || fault);
  wire         gone = nothing_q || (!drop && (&dropped_q));
  //@ if fpga
  wire         leave = ending_q && gone && memory_idle && !in_flight && !full_q && free;
  //@ else
  wire         leave = ending_q && gone && memory_idle && !in_flight && free;
  //@ end

  assign idle = !busy_q;
  assign hit = found && !any; //@ !fpga
  assign launch_free = !known_q[FLIGHT];
  assign verdict_ready = ending_q || (known && free); //@ !fpga
  assign verdict_ready = !full_q; //@ fpga

  sepax_ram_fifo #(.WIDTH(110), .ADDRESS(FLIGHT)) records (
    .clk(clk), .clear(rst || start), .push(launched), .in(launched_info), .valid(known),
    .pop(judged), .out({leaf_b, leaf_a, base_b, base_a, row_b, row_a})
  );

  always @(posedge clk) begin
    if (rst) begin
      {busy_q, ending_q, drop, done, result_valid} <= 5'd0;
      full_q <= 1'b0; //@ fpga
      {any, stopped, damaged, error} <= 4'd0;
    end else begin
      full_q <= full_q ? !counts : verdict_valid; //@ fpga
      busy_q <= start || (busy_q && !leave);
      ending_q <= halt || finish || (ending_q && !leave);
      drop <= halt || finish;
      done <= leave;
      if (result_valid && result_ready) begin //@ fpga
        result_valid <= 1'b0; //@ fpga
      end //@ fpga
      if (free) begin
        result_valid <= (found || warned) && !quiet;
      end
      any <= !start && (any || found);
      stopped <= !start && (stopped || halt);
      damaged <= !start && (damaged || (finish && !halt && (walk_damaged || pairs_damaged)));
      error <= !start && (error || (finish && !halt && (walk_error || pairs_error)));
    end
    if (rst || start) begin
      known_q <= {(FLIGHT+1){1'b0}};
    end else begin
      known_q <= known_q + (launched ? ONE : {(FLIGHT+1){1'b0}}) -
                 (judged ? ONE : {(FLIGHT+1){1'b0}});
    end
    //@ if fpga
    {near_q, found_q, undecided_q, warned_q} <= {counted, found, found && outside_q, warned};
    if (verdict_ready) begin
      {collision_q, coplanar_q, warning_q, outside_q} <= {collision, coplanar, warning, outside};
    end
    pairs_busy_q <= pairs_busy;
    hit <= found && !any;
    before_q <= budget - 32'd1;
    due_q <= start ? budget == 32'd1 : cycles == before_q;
    //@ end
    dropped_q <= {dropped_q[0], ending_q && !drop};
    if (!ending_q) begin
      nothing_q <= !halt && !fault && !walk_damaged && !walk_error;
    end
    {entry_q, row_q, pair_q, steps_q} <= {entry_counted, row_counted, pair_counted, steps_counted};
    if (free) begin
      result_a <= a;
      result_b <= b;
      //@ if fpga
      result_coplanar <= coplanar_q && !outside_q;
      {result_outside, result_warning} <= {outside_q, warned};
      //@ else
      {result_coplanar, result_outside, result_warning} <= {coplanar && !outside, outside, warned};
      //@ end
    end
    if (full_q && !any) begin // what was taken last //@ fpga
    if (hit) begin //@ !fpga
      first_a <= a;
      first_b <= b;
      {first_leaf_b, first_leaf_a, first_row_b, first_row_a} <= {leaf_b, leaf_a, row_b, row_a};
    end
    cycles <= start ? 32'd1 : cycles + {31'd0, busy_q && !(&cycles)};
    if (clear_counts) begin
      {entries, steps, rows, pairs, near, collisions, out_of_range, warnings} <= 256'd0;
    end else begin
      entries <= entries + {31'd0, entry_q};
      steps <= steps + {27'd0, steps_q};
      rows <= rows + {31'd0, row_q};
      pairs <= pairs + {31'd0, pair_q};
      //@ if fpga
      near <= near + {31'd0, near_q};
      collisions <= collisions + {31'd0, found_q};
      out_of_range <= out_of_range + {31'd0, undecided_q};
      warnings <= warnings + {31'd0, warned_q};
      //@ else
      near <= near + {31'd0, counted};
      collisions <= collisions + {31'd0, found};
      out_of_range <= out_of_range + {31'd0, found && outside};
      warnings <= warnings + {31'd0, warned};
      //@ end
    end
  end
endmodule
