// SPDX-License-Identifier: MIT
// Holds the current job, which comes in beats (docs/reference/tree-engine.md, Job), and checks its
// ranges.
module sepax_tree_job #(
  parameter ADDRESS = 40 // bits of a byte address, 37 ... 63
) (
  input  wire                clk,         // clock
  input  wire                clear,       // another job begins
  input  wire                load,        // a beat of the job is here
  input  wire [2:0]          beat,        // number of the beat, 0 ... 5
  input  wire [127:0]        data,        // the beat, byte 0 lowest
  output reg                 bad,         // a number of the job is out of its range
  output reg  [ADDRESS-13:0] base_a,      // A's image / 4096
  output reg  [23:0]         nodes_a,     // A's nodes
  output reg  [31:0]         triangles_a, // A's triangles
  output reg  [31:0]         beats_a,     // beats of A's image
  output reg  [ADDRESS-13:0] base_b,      // B's image / 4096
  output reg  [23:0]         nodes_b,     // B's nodes
  output reg  [24:0]         triangles_b, // B's triangles
  output reg  [31:0]         beats_b,     // beats of B's image
  output reg  [ADDRESS-9:0]  poses,       // address of the first pose / 256
  output reg  [31:0]         count,       // number of poses
  output reg  [6:0]          modes,       // modes {LEAVE, WARM, COLD, AGAIN, ROW, QUIET, FIRST}
  output reg  [31:0]         budget,      // cycles of a pose; 0: none //@ !fpga
  output reg  [31:0]         budget,      // cycles of a pose, the most there are for none //@ fpga
  output reg  [26:0]         row_a,       // first row: {a, leaf A}
  output reg  [26:0]         row_b        // first row: {b, leaf B}
);
  wire [63:0] address = data[63:0];
  wire [31:0] number = data[95:64];
  wire [31:0] last = data[127:96];
  wire        beyond = |address[63:ADDRESS];
  wire        bad_nodes = !(|number) || (|number[31:24]) || (number[23] && (|number[22:0]));
  reg  [26:0] node_beats; // beats of the nodes of the body whose size comes
  reg         wrong;
  //@ if fpga
  reg  [31:0] budget_q;
  reg         far_q, wrong_nodes_q, none_q, many_q, above_q, wrong_poses_q;
  reg         load_q, wrong_q;
  reg  [2:0]  beat_q;
  //@ end

  always @(*) begin
    node_beats = beat[1] ? {nodes_b, 3'd0} : {nodes_a, 3'd0};
    //@ if fpga
    case (beat_q)
      3'd0: wrong = far_q || wrong_nodes_q || none_q;
      3'd2: wrong = far_q || wrong_nodes_q || none_q || many_q;
      3'd1, 3'd3: wrong = above_q;
      3'd4: wrong = far_q || wrong_poses_q;
      default: wrong = 1'b0;
    endcase
    //@ else
    case (beat)
      3'd0: wrong = beyond || (|address[11:0]) || bad_nodes || !(|last);
      3'd2: wrong = beyond || (|address[11:0]) || bad_nodes || !(|last) || (|last[31:25]) ||
                    (last[24] && (|last[23:0]));
      3'd1, 3'd3: wrong = {5'd0, node_beats} > data[31:0];
      3'd4: wrong = beyond || (|address[7:0]) || !(|number) || (|last[31:7]);
      default: wrong = 1'b0;
    endcase
    //@ end
  end

  always @(posedge clk) begin
    bad <= !clear && (bad || (load && wrong)); //@ !fpga
    bad <= !clear && (bad || wrong_q); //@ fpga
    //@ if fpga
    budget <= (|budget_q) ? budget_q : 32'hffffffff;
    far_q <= beyond || (|address[7:0]);
    wrong_nodes_q <= (|address[11:8]) || bad_nodes;
    none_q <= !(|last);
    many_q <= (|last[31:25]) || (last[24] && (|last[23:0]));
    above_q <= {5'd0, node_beats} > data[31:0];
    wrong_poses_q <= !(|number) || (|last[31:7]);
    {load_q, beat_q, wrong_q} <= {load, beat, load_q && wrong};
    //@ end
    if (load) begin
      case (beat)
        3'd0: {triangles_a, nodes_a, base_a} <= {last, number[23:0], address[ADDRESS-1:12]};
        3'd1: beats_a <= data[31:0];
        3'd2: {triangles_b, nodes_b, base_b} <= {last[24:0], number[23:0], address[ADDRESS-1:12]};
        3'd3: beats_b <= data[31:0];
        3'd4: {modes, count, poses} <= {last[6:0], number, address[ADDRESS-1:8]};
        default: {row_b, row_a, budget} <= {last[26:0], number[26:0], data[31:0]}; //@ !fpga
        default: {row_b, row_a, budget_q} <= {last[26:0], number[26:0], data[31:0]}; //@ fpga
      endcase
    end
  end
endmodule
