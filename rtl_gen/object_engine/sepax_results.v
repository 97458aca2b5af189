// SPDX-License-Identifier: MIT
// Counts verdicts and sends those that are collisions as AXI4-Stream, 64 bits each:
//   [31:0] number in A, [55:32] number in B, [56] coplanar, [57] out of range, [58] warning
// A run ends with a transfer with TLAST: [31:0] how many there were, [62] stopped, [63] 1.
module sepax_results (
  input  wire         clk,          // clock
  input  wire         rst,          // synchronous reset, active high
  input  wire         start,        // a run begins
  input  wire         stop,         // it is to end
  input  wire         first,        // it is to end at its first collision
  input  wire         quiet,        // nothing is sent
  input  wire [6:0]   tested,       // pairs that the lanes test in this cycle
  input  wire         launched,     // a pair goes on to a core
  input  wire         drained,      // no pair is left anywhere
  input  wire         valid,        // a verdict is here
  output wire         ready,        // it is taken
  input  wire         collision,    // the verdict
  input  wire         coplanar,     // the triangles are in one plane
  input  wire         exceeds,      // an AABB exceeds its extent //@ extents
  input  wire         warning,      // in the band between clearance and warning //@ limits
  input  wire         outside,      // B was moved out of the word
  input  wire [@index_a@-1:0] a,            // the pair: number in A
  input  wire [@index_b@-1:0] b,            // number in B
  output reg          tvalid,       // a result is here
  input  wire         tready,       // it is taken in this cycle
  output reg  [63:0]  tdata,        // the result
  output reg          tlast,        // the end of the run
  output wire         halt,         // make no more pairs and drop those in flight
  output wire         done,         // the run ends in this cycle
  output wire         hit,          // its first collision is here //@ !fpga
  output wire         hit,          // its first collision was here //@ fpga
  output reg          busy,         // a run is going on
  output reg          stopped,      // it ends before all pairs are tested
  output reg          any,          // a collision was found
  output reg  [31:0]  pairs,        // pairs tested
  output reg  [31:0]  candidates,   // pairs that went to the cores
  output reg  [31:0]  collisions,   // pairs that collide
  output reg  [31:0]  out_of_range, // of these, undecided
  output reg  [31:0]  warnings,     // pairs that are too near
  output reg  [31:0]  cycles,       // clock cycles of the run; stays at its largest value
  output reg  [31:0]  first_a,      // first collision: number in A
  output reg  [31:0]  first_b       // first collision: number in B
);
  localparam A = @index_a@; // bits of the number of a triangle of A
  localparam B = @index_b@; // of B
  reg         ending_q;
  //@ if fpga
  // A verdict waits in registers: what it is, and of which pair.
  reg         valid_q, meets_q, outside_q, coplanar_q, drained_q, hit_q;
  reg         near_q; //@ limits
  reg [A-1:0] a_q;
  reg [B-1:0] b_q;
  //@ end
  wire        free = !tvalid || tready;
  wire        counted = valid@held@ && free && !stopped;
  wire        undecided = outside || exceeds; //@ extents
  wire        undecided = outside; //@ !extents
  wire        found = counted && (collision || undecided); //@ !fpga
  wire        found = counted && meets_q; //@ fpga
  //@ if fpga
  wire        warned = counted && near_q; //@ limits
  //@ else
  wire        warned = counted && warning && !collision && !undecided; //@ limits
  //@ end
  wire        warned = 1'b0; //@ !limits
  reg         found_q, undecided_q, warned_q; // to be counted //@ fpga
  wire        finish = busy && !ending_q && drained && free; //@ !fpga
  //@ if fpga
  wire        finish = busy && !ending_q && drained_q && free && !valid_q && !found_q && !warned_q;
  //@ end
  wire [31:0] sent = collisions + warnings;

  assign ready = free; //@ !fpga
  //@ if fpga
  assign ready = free || !valid_q; //@ each_cycle
  assign ready = !valid_q; // a verdict in every other cycle is enough //@ !each_cycle
  //@ end
  assign hit = found && !any; //@ !fpga
  assign halt = stop || (first && hit); //@ !fpga
  assign hit = hit_q; //@ fpga
  assign halt = stop || (first && found && !any); //@ fpga
  assign done = (finish && quiet) || (ending_q && free);

  always @(posedge clk) begin
    if (rst) begin
      {busy, ending_q, stopped, any, tvalid} <= 5'd0;
      valid_q <= 1'b0; //@ fpga
    end else begin
      busy <= start || (busy && !done);
      ending_q <= (finish && !quiet) || (ending_q && !free);
      stopped <= !start && (stopped || (busy && !ending_q && !finish && halt));
      any <= !start && (any || found);
      valid_q <= ready ? valid : !free; //@ fpga
      if (free) begin
        tvalid <= (found || warned || finish) && !quiet;
      end
    end
    if (free) begin
      tlast <= finish;
      tdata <= finish ? {1'b1, stopped, 30'd0, sent} :
               {5'd0, warned, @undecided@, @coplanar@,
                {(24-B){1'b0}}, b@held@, {(32-A){1'b0}}, a@held@};
    end
    //@ if fpga
    {found_q, undecided_q, warned_q} <= {found, outside_q, warned} & {3{!rst}};
    drained_q <= drained && !start;
    hit_q <= found && !any && !rst;
    if (ready) begin
      {meets_q, outside_q} <= {collision || undecided, undecided};
      near_q <= warning && !collision && !undecided; //@ limits
      coplanar_q <= coplanar && !undecided;
      a_q <= a;
      b_q <= b;
    end
    //@ end
    if (hit) begin
      //@ if fpga
      first_a <= tdata[31:0];
      first_b <= {8'd0, tdata[55:32]};
      //@ else
      first_a <= {{(32-A){1'b0}}, a};
      first_b <= {{(32-B){1'b0}}, b};
      //@ end
    end
    if (start) begin
      {pairs, candidates, collisions, out_of_range, warnings, cycles} <= 192'd0;
    end else begin
      pairs <= pairs + {25'd0, tested};
      candidates <= candidates + {31'd0, launched};
      collisions <= collisions + {31'd0, found@counted@};
      out_of_range <= out_of_range + {31'd0, found@counted@ && undecided@counted@};
      warnings <= warnings + {31'd0, warned@counted@};
      cycles <= cycles + {31'd0, busy && !(&cycles)};
    end
  end
endmodule
