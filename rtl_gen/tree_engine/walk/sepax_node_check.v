// SPDX-License-Identifier: MIT
// Checks the head of a node (docs/reference/tree-engine.md, Checks). The node is sound if
// limit - first >= children, where limit is nodes, or triangles if the node is a leaf, and
//   an inner node: first > number;
//   a leaf: beats - record >= its beats >= 3, and the record does not cross 4096 bytes.
// The head must not change for three cycles. `bad` is valid in the third.
module sepax_node_check (
  input  wire         clk,       // clock
  input  wire [1:0]   step,      // one-hot: the first cycle, the second cycle
  input  wire [3:0]   children,  // children of the node less 1
  input  wire [3:0]   level,     // level of the node
  input  wire [3:0]   last_beat, // beats of its record less 1
  input  wire [31:0]  first,     // number of its first child
  input  wire [31:0]  record,    // place of its record in the image, in beats
  input  wire [22:0]  number,    // number of the node
  input  wire [23:0]  nodes,     // nodes of the body
  input  wire [31:0]  triangles, // triangles of the body
  input  wire [31:0]  beats,     // beats of the body's image
  output wire         bad        // the node is damaged
);
  wire        leaf = !(|level);
  wire        crosses = record[7:0] > {4'hf, ~last_beat};
  wire        fault = leaf && (crosses || (last_beat < 4'd2));
  wire [31:0] limit = step[0] ? (leaf ? triangles : {8'd0, nodes}) :
                                (leaf ? beats : {9'd0, number});
  wire [31:0] used = (step[0] || !leaf) ? first : record;
  wire [3:0]  more_than = step[1] ? children : last_beat; //@ !fpga
  reg  [3:0]  more_than; //@ fpga
  wire        unused_step = step[1]; //@ fpga
  reg  [32:0] left_q;  // limit - used
  reg         bad_q;
  wire        enough = !left_q[32] && ((|left_q[31:5]) || (left_q[4:0] > {1'b0, more_than}));

  // In an inner node, number - first must be below 0.
  assign bad = bad_q || (leaf ? !enough : !left_q[32]);

  always @(posedge clk) begin
    more_than <= step[0] ? children : last_beat; //@ fpga
    left_q <= {1'b0, limit} - {1'b0, used};
    bad_q <= step[0] ? fault : (bad_q || !enough);
  end
endmodule
