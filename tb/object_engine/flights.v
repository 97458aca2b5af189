// SPDX-License-Identifier: MIT
// flights.v - sepax_cores around any cores that give verdicts in order, for yosys-smtbmc:
// its inputs are free in every cycle from a reset on.
`default_nettype none

// Takes up to 16 pairs and gives verdicts when it likes; a verdict is bit 0 of its pair.
module sepax_top (
    input wire clk, rst, in_valid, out_ready,
    input wire signed [3:0] in_a1_x, in_a1_y, in_a1_z, in_a2_x, in_a2_y, in_a2_z,
    input wire signed [3:0] in_a3_x, in_a3_y, in_a3_z, in_b1_x, in_b1_y, in_b1_z,
    input wire signed [3:0] in_b2_x, in_b2_y, in_b2_z, in_b3_x, in_b3_y, in_b3_z,
    output wire in_ready, out_valid, out_collision, out_coplanar,
    output wire [3:0] out_axis
);
  (* anyseq *) wire takes, gives;
  reg [15:0] bits;
  reg [4:0] first, next; // pairs given, taken
  reg stands;
  wire [4:0] inside = next - first;
  assign in_ready = takes && !inside[4];
  assign out_valid = stands || (gives && inside != 5'd0);
  assign out_collision = out_valid && bits[first[3:0]];
  assign out_coplanar = 1'b0;
  assign out_axis = 4'd0;
  always @(posedge clk) begin
    first <= rst ? 5'd0 : first + {4'd0, out_valid && out_ready};
    next <= rst ? 5'd0 : next + {4'd0, in_valid && in_ready};
    stands <= !rst && out_valid && !out_ready;
    if (in_valid && in_ready) bits[next[3:0]] <= in_a1_x[0];
  end
endmodule

module flights (
    input wire clk, rst, pair_valid, verdict_ready,
    input wire [35:0] pair_a, pair_b,
    input wire [14:0] pair_info
);
  wire pair_ready, in_flight, verdict_valid, collision;
  wire [14:0] verdict_info;
  sepax_cores dut (
      .clk(clk), .rst(rst), .pair_valid(pair_valid), .pair_ready(pair_ready), .pair_a(pair_a),
      .pair_b(pair_b), .pair_info(pair_info), .in_flight(in_flight),
      .verdict_valid(verdict_valid), .verdict_ready(verdict_ready), .collision(collision),
      .verdict_info(verdict_info));

  // What goes with one of the pairs, whichever, goes with its verdict; none is lost.
  (* anyconst *) wire [4:0] watched;
  reg [4:0] pairs, verdicts;
  reg [15:0] came; // {pair_info, the verdict}
  reg begun = 1'b0;
  wire take = pair_valid && pair_ready;
  always @(posedge clk) begin
    begun <= 1'b1;
    assume (begun || rst);
    if (rst) begin
      {pairs, verdicts} <= 10'd0;
    end else begin
      assume (pairs != 5'd31 || !take);
      pairs <= pairs + {4'd0, take};
      verdicts <= verdicts + {4'd0, verdict_valid && verdict_ready};
      if (take && pairs == watched) came <= {pair_info, pair_a[0]};
      assert (in_flight == (pairs != verdicts));
      assert (!verdict_valid || in_flight);
      if (verdict_valid && verdicts == watched) assert ({verdict_info, collision} == came);
    end
  end
endmodule

`default_nettype wire
