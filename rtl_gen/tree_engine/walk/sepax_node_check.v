// Is the head of a node sound (docs/reference/tree-engine.md, Checks)? limit - first >= children,
// and
//   of an inner node: first > number,
//   of a leaf: beats - record >= its beats >= 3, and the record does not cross 4096 bytes.
// The head stands for three cycles; `bad` is right in the third.
module sepax_node_check (
  input  wire         clk,       // clock
  input  wire [1:0]   step,      // one-hot: the first, the second cycle
  input  wire [3:0]   children,  // of the node, its children less 1
  input  wire [3:0]   level,     // its level
  input  wire [3:0]   last_beat, // its record's beats less 1
  input  wire [31:0]  first,     // its first child
  input  wire [31:0]  record,    // where its record begins
  input  wire [22:0]  number,    // of the node
  input  wire [23:0]  nodes,     // of the body
  input  wire [31:0]  triangles, // of the body
  input  wire [31:0]  beats,     // of the body's image
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

  // Of an inner node number - first must be below 0.
  assign bad = bad_q || (leaf ? !enough : !left_q[32]);

  always @(posedge clk) begin
    more_than <= step[0] ? children : last_beat; //@ fpga
    left_q <= {1'b0, limit} - {1'b0, used};
    bad_q <= step[0] ? fault : (bad_q || !enough);
  end
endmodule
