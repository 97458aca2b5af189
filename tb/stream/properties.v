// SPDX-License-Identifier: MIT
// properties.v - sepax_stream around any core that gives verdicts in order, for
// yosys-smtbmc: its inputs are free in every cycle from a reset on.
`default_nettype none

// Takes and gives when it likes; a verdict that it has offered stands.
module sepax_top (
    input wire clk, rst, in_valid, out_ready,
    input wire signed [3:0] in_a1_x, in_a1_y, in_a1_z, in_a2_x, in_a2_y, in_a2_z,
    input wire signed [3:0] in_a3_x, in_a3_y, in_a3_z, in_b1_x, in_b1_y, in_b1_z,
    input wire signed [3:0] in_b2_x, in_b2_y, in_b2_z, in_b3_x, in_b3_y, in_b3_z,
    output wire in_ready, out_valid, out_collision, out_coplanar,
    output wire [3:0] out_axis
);
  (* anyseq *) wire takes, gives;
  (* anyseq *) wire [5:0] any;
  reg [4:0] flight;
  reg       stands;
  reg [5:0] verdict;
  assign in_ready = takes && !flight[4];
  assign out_valid = stands || (gives && flight != 5'd0);
  assign {out_collision, out_coplanar, out_axis} =
      (stands ? verdict : any) & {6{out_valid}};
  always @(posedge clk) begin
    flight <= rst ? 5'd0 : flight + {4'd0, in_valid && in_ready} - {4'd0, out_valid && out_ready};
    stands <= !rst && out_valid && !out_ready;
    verdict <= {out_collision, out_coplanar, out_axis};
  end
endmodule

module stream_properties (
    input wire clk, aresetn, s_tvalid, s_tlast, m_tready,
    input wire [511:0] s_tdata,
    input wire [2:0] s_tuser
);
  wire s_tready, m_tvalid, m_tlast;
  wire [31:0] m_tdata;
  wire [2:0] m_tuser;
  sepax_stream dut (
      .aclk(clk), .aresetn(aresetn), .s_axis_tvalid(s_tvalid), .s_axis_tready(s_tready),
      .s_axis_tdata(s_tdata), .s_axis_tuser(s_tuser), .s_axis_tlast(s_tlast),
      .m_axis_tvalid(m_tvalid), .m_axis_tready(m_tready), .m_axis_tdata(m_tdata),
      .m_axis_tuser(m_tuser), .m_axis_tlast(m_tlast));

  // A verdict stands until it is taken.
  reg begun = 1'b0;
  always @(posedge clk) begin
    begun <= 1'b1;
    assume (begun || !aresetn);
    if (begun && $past(m_tvalid && !m_tready && aresetn)) begin
      assert (m_tvalid);
      assert ({m_tdata, m_tuser, m_tlast} == $past({m_tdata, m_tuser, m_tlast}));
    end
    if (begun && $past(!aresetn)) assert (!m_tvalid);
    if (m_tvalid) assert (m_tdata[31:12] == 20'd0 && m_tdata[7:4] == 4'd0);
  end

  // A triangle that comes: does each coordinate fit four bits?
  reg fits;
  integer v, k;
  always @(*) begin
    fits = 1'b1;
    for (v = 0; v < 3; v = v + 1) begin
      for (k = 0; k < 3; k = k + 1) begin
        if ($signed(s_tdata[128*v+32*k +: 32]) < -8 || $signed(s_tdata[128*v+32*k +: 32]) > 7)
          fits = 1'b0;
      end
    end
  end

  // What goes with one of the pairs, whichever, goes with its verdict.
  (* anyconst *) wire [2:0] watched;
  wire taken = s_tvalid && s_tready;
  wire whole = second && taken;
  reg second, first_fits; // the triangle that comes is B; A's fit
  reg [2:0] pairs, verdicts;
  reg [2:0] tag;
  reg last, bad, cut;
  always @(posedge clk) begin
    if (!aresetn) begin
      {second, pairs, verdicts} <= 7'd0;
    end else begin
      assume (pairs != 3'd7 || !taken);
      if (taken) begin
        second <= !second && !s_tlast;
        first_fits <= fits;
      end
      if (whole || (taken && s_tlast)) begin
        pairs <= pairs + 3'd1;
        if (pairs == watched) begin
          {tag, last} <= {s_tuser, s_tlast};
          cut <= !second;
          bad <= !fits || (second && !first_fits) || !second;
        end
      end
      if (m_tvalid) assert (verdicts < pairs);
      if (m_tvalid && verdicts == watched) begin
        assert (m_tuser == tag && m_tlast == last);
        assert (m_tdata[3] == cut && m_tdata[2] == bad);
        assert (!bad || (m_tdata[11:8] == 4'd14 && m_tdata[1:0] == 2'b01));
      end
      if (m_tvalid && m_tready) verdicts <= verdicts + 3'd1;
    end
  end
endmodule

`default_nettype wire
