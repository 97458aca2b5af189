// SPDX-License-Identifier: MIT
// A copy of one bit of the slot register, for the operands of one group of units: less fan-out. It
// is a module that keeps its place in the hierarchy, lest synthesis merge the copies.
(* keep_hierarchy *)
module sepax_slot_copy (
  input  wire clk,    // clock
  input  wire slot,   // the slot before
  output reg  slot_q  // the slot
);
  always @(posedge clk) begin
    slot_q <= slot;
  end
endmodule
