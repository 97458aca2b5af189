// SPDX-License-Identifier: MIT
// read_properties.v - bursts are asked for and come, and records become triangles, if the memory
// answers: for Yosys' SAT solver, by induction.
`default_nettype none

module bursts_properties #(
    parameter OPEN = 4
) (
    input wire clk, rst, in_valid, arready, rvalid, rlast,
    input wire [8:0] in_address,
    input wire [3:0] in_beats,
    input wire [1:0] in_tag, rresp
);
  wire in_ready, arvalid, rready;
  sepax_axi_read #(.ADDRESS(13), .TAG(2), .OPEN(OPEN)) dut (
      .clk(clk), .rst(rst), .in_valid(in_valid), .in_ready(in_ready), .in_address(in_address),
      .in_beats(in_beats), .in_tag(in_tag), .pause(1'b0), .arvalid(arvalid), .arready(arready),
      .rvalid(rvalid), .rready(rready), .rdata(128'd0), .rresp(rresp), .rlast(rlast));
  (* hierconn *) wire [OPEN:0] \dut.open_q , \dut.bursts.head_q , \dut.bursts.tail_q ;
  (* hierconn *) wire \dut.bursts.valid , \dut.bursts.read ;
  wire [OPEN:0] behind = \dut.bursts.tail_q - \dut.bursts.head_q ;
  wire sent = \dut.open_q > {{OPEN{1'b0}}, arvalid}; // a burst is on the bus
  wire free = !rst && arready && (rvalid || !sent);
  wire moves = (in_valid && in_ready) || arvalid || (rvalid && rready) || \dut.bursts.read ;
  reg begun = 1'b0;
  always @(posedge clk) begun <= 1'b1;
  always @* begin
    assume (begun == !rst);
    assume (!rvalid || sent);
    if (begun) begin
      assert (\dut.open_q <= 1 << OPEN && behind <= 1 << OPEN);
      assert (\dut.open_q == behind + \dut.bursts.valid );
      assert (!arvalid || \dut.open_q != 0);
      if (free && (in_valid || \dut.open_q != 0)) assert (moves);
    end
  end
endmodule

module records_properties (
    input wire clk, rst, fill, fill_last, fill_error,
    input wire [119:0] numbers
);
  wire busy, idle, done;
  reg [3:0] expected = 4'd0; // the beat that comes next
  sepax_leaf_fill #(.W(4), .TAG(1)) dut (
      .clk(clk), .rst(rst), .fill(fill), .fill_numbers(numbers), .fill_even(12'd0),
      .fill_odd(12'd0), .fill_beat(expected), .fill_last(fill_last), .fill_error(fill_error),
      .fill_tag(1'b0), .busy(busy), .idle(idle), .done(done));
  (* hierconn *) wire [1:0] \dut.come_q , \dut.read_q , \dut.made_q , \dut.ended_q ;
  (* hierconn *) wire \dut.start , \dut.move , \dut.make , \dut.words_q , \dut.valid_q ;
  (* hierconn *) wire [3:0] \dut.index_q , \dut.next_q ;
  wire [1:0] here = \dut.come_q - \dut.made_q , begins = \dut.read_q - \dut.made_q ;
  wire comes = expected != 4'd0; // a record is coming
  wire free = !rst && (fill || !comes);
  wire moves = fill || \dut.start || \dut.move || \dut.make ;
  reg begun = 1'b0, was_busy = 1'b0;
  always @(posedge clk) begin
    begun <= 1'b1;
    was_busy <= busy;
    if (rst) expected <= 4'd0;
    else if (fill) expected <= fill_last ? 4'd0 : expected + 4'd1;
  end
  always @* begin
    assume (begun == !rst);
    assume (!(&expected) || fill_last || !fill);
    assume (expected != 4'd0 || !fill_last || !fill);
    assume (!fill || expected != 4'd0 || !was_busy);
    if (begun) begin
      assert (here <= 2'd2 && begins <= here);
      assert (!(here == 2'd2) || was_busy || comes);
      assert (!comes || here != 2'd0);
      // All that are here have come, but for the youngest.
      if (here == 2'd2) assert (\dut.ended_q [\dut.made_q [0]]);
      if (here != 2'd0) assert (\dut.ended_q [!\dut.come_q [0]] == !comes);
      if (begins == 2'd0) assert (!\dut.valid_q || !(&\dut.index_q ));
      if (begins != 2'd0) assert (\dut.valid_q && (&\dut.index_q ));
      assert (begins <= 2'd1);
      if (\dut.words_q ) assert (begins < here);
      if (here != 2'd0 && free) assert (moves);
    end
  end
endmodule

`default_nettype wire
