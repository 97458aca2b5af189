// Is the head of a node sound (docs/tree.md, Checks)? limit - first >= children, and
//   of an inner node: first > number,
//   of a leaf: beats - record >= its beats >= 3, and the record does not cross 4096 bytes.
// The head stands for three cycles; `bad` is right in the third.
module sepax_node_check (
  input  wire         clk,       // clock
  input  wire [1:0]   step,      // one-hot: the first, the second cycle
  input  wire [255:0] head,      // of the node
  input  wire [22:0]  number,    // of the node
  input  wire [23:0]  nodes,     // of the body
  input  wire [31:0]  triangles, // of the body
  input  wire [31:0]  beats,     // of the body's image
  output wire         bad        // the node is damaged
);
  wire [4:0]  children = {1'b0, head[111:108]} + 5'd1;
  wire        leaf = !(|head[115:112]);
  wire [3:0]  last_beat = head[119:116];
  wire [31:0] first = head[159:128];
  wire [31:0] record = head[191:160];
  wire [8:0]  end_of_record = {1'b0, record[7:0]} + {5'd0, last_beat};
  wire        fault = leaf && (end_of_record[8] || (last_beat < 4'd2));
  wire [31:0] limit = step[0] ? (leaf ? triangles : {8'd0, nodes}) :
                                (leaf ? beats : {9'd0, number});
  wire [31:0] used = (step[0] || !leaf) ? first : record;
  wire [4:0]  least = step[1] ? children : {1'b0, last_beat} + 5'd1;
  reg  [32:0] left_q;  // limit - used
  reg         bad_q;
  wire        enough = !left_q[32] && ((|left_q[31:5]) || (left_q[4:0] >= least));

  // Of an inner node number - first must be below 0.
  assign bad = bad_q || (leaf ? !enough : !left_q[32]);

  always @(posedge clk) begin
    left_q <= {1'b0, limit} - {1'b0, used};
    bad_q <= step[0] ? fault : (bad_q || !enough);
  end
endmodule
