// SPDX-License-Identifier: MIT
// node_properties.v - sepax_node_check calls a node damaged exactly where
// docs/reference/tree-engine.md, Checks, does: for Yosys' SAT solver. All numbers stand for the
// three cycles of a check.
`default_nettype none

module node_properties (input wire clk);
  (* anyconst *) wire [3:0] children, level, last_beat; // children and beats less 1
  (* anyconst *) wire [31:0] first, record, triangles, beats;
  (* anyconst *) wire [22:0] number;
  (* anyconst *) wire [23:0] nodes;
  reg [1:0] cycle = 2'd0; // of the check
  wire bad;
  sepax_node_check dut (
      .clk(clk), .step({cycle == 2'd1, cycle == 2'd0}), .children(children), .level(level),
      .last_beat(last_beat), .first(first), .record(record), .number(number), .nodes(nodes),
      .triangles(triangles), .beats(beats), .bad(bad));
  wire [34:0] many = {31'd0, children} + 35'd1;     // children
  wire [34:0] long = {31'd0, last_beat} + 35'd1;    // beats of the record
  wire [34:0] from = {3'd0, first};
  wire is_leaf = level == 4'd0;
  wire wrong_inner = from <= {12'd0, number} || from + many > {11'd0, nodes};
  wire wrong_leaf = from + many > {3'd0, triangles} || long < 35'd3 ||
                    {27'd0, record[7:0]} + long > 35'd256 ||
                    {3'd0, record} + long > {3'd0, beats};
  always @(posedge clk) cycle <= (&cycle) ? cycle : cycle + 2'd1;
  always @* begin
    if (cycle == 2'd2) assert (bad == (is_leaf ? wrong_leaf : wrong_inner));
  end
endmodule

`default_nettype wire
