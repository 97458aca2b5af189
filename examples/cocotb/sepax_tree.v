// SPDX-License-Identifier: MIT
// sepax_tree.v - the tree engine as cocotbext-axi wants its memory port: with IDs, which are 0.
`default_nettype none

module sepax_tree (
  input  wire         aclk, aresetn,
  input  wire         s_axi_awvalid, s_axi_wvalid, s_axi_bready, s_axi_arvalid, s_axi_rready,
  output wire         s_axi_awready, s_axi_wready, s_axi_bvalid, s_axi_arready, s_axi_rvalid,
  input  wire [6:0]   s_axi_awaddr, s_axi_araddr,
  input  wire [31:0]  s_axi_wdata,
  input  wire [3:0]   s_axi_wstrb,
  output wire [31:0]  s_axi_rdata,
  output wire [1:0]   s_axi_bresp, s_axi_rresp,
  output wire [0:0]   m_axi_arid,
  input  wire [0:0]   m_axi_rid,
  output wire         m_axi_arvalid, m_axi_rready,
  input  wire         m_axi_arready, m_axi_rvalid, m_axi_rlast,
  output wire [39:0]  m_axi_araddr,
  output wire [7:0]   m_axi_arlen,
  output wire [2:0]   m_axi_arsize,
  output wire [1:0]   m_axi_arburst,
  input  wire [127:0] m_axi_rdata,
  input  wire [1:0]   m_axi_rresp,
  output wire         m_axis_tvalid, m_axis_tlast,
  input  wire         m_axis_tready,
  output wire [63:0]  m_axis_tdata,
  output wire         irq
);
  assign m_axi_arid = 1'b0;

  sepax_engine engine (
    .aclk(aclk), .aresetn(aresetn), .irq(irq),
    .s_axi_awvalid(s_axi_awvalid), .s_axi_awready(s_axi_awready), .s_axi_awaddr(s_axi_awaddr),
    .s_axi_wvalid(s_axi_wvalid), .s_axi_wready(s_axi_wready), .s_axi_wdata(s_axi_wdata),
    .s_axi_wstrb(s_axi_wstrb), .s_axi_bvalid(s_axi_bvalid), .s_axi_bready(s_axi_bready),
    .s_axi_bresp(s_axi_bresp), .s_axi_arvalid(s_axi_arvalid), .s_axi_arready(s_axi_arready),
    .s_axi_araddr(s_axi_araddr), .s_axi_rvalid(s_axi_rvalid), .s_axi_rready(s_axi_rready),
    .s_axi_rdata(s_axi_rdata), .s_axi_rresp(s_axi_rresp),
    .m_axi_arvalid(m_axi_arvalid), .m_axi_arready(m_axi_arready), .m_axi_araddr(m_axi_araddr),
    .m_axi_arlen(m_axi_arlen), .m_axi_arsize(m_axi_arsize), .m_axi_arburst(m_axi_arburst),
    .m_axi_rvalid(m_axi_rvalid), .m_axi_rready(m_axi_rready), .m_axi_rdata(m_axi_rdata),
    .m_axi_rresp(m_axi_rresp), .m_axi_rlast(m_axi_rlast),
    .m_axis_tvalid(m_axis_tvalid), .m_axis_tready(m_axis_tready), .m_axis_tdata(m_axis_tdata),
    .m_axis_tlast(m_axis_tlast)
  );
endmodule

`default_nettype wire
