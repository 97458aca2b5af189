// SPDX-License-Identifier: MIT
// Which triangles of object A collide with which of object B: all pairs go through @lanes@
// comparator lanes, those whose AABBs overlap to @cores@ exact core@plural@ behind a FIFO.
// @memory_a@ triangles of A, @memory_b@ of B at most. Objects come over AXI4-Stream, a vertex a
// transfer; AXI4-Lite starts a run and reads its counts; collisions leave over AXI4-Stream. No
// ready is reached from an input without a register. A run takes about
// ceil(a / @lanes@) max(b, @lanes@) + @fill@ cycles and the latency of the core, more where the
// cores do not keep up.
module sepax_engine (
  (* X_INTERFACE_INFO = "xilinx.com:signal:clock:1.0 aclk CLK" *)
  (* X_INTERFACE_PARAMETER = "ASSOCIATED_BUSIF s_axi:s_axis:m_axis, ASSOCIATED_RESET aresetn" *)
  input  wire         aclk,          // clock of everything
  (* X_INTERFACE_INFO = "xilinx.com:signal:reset:1.0 aresetn RST" *)
  (* X_INTERFACE_PARAMETER = "POLARITY ACTIVE_LOW" *)
  input  wire         aresetn,       // synchronous reset of the control, active low
  (* X_INTERFACE_INFO = "xilinx.com:interface:aximm:1.0 s_axi AWVALID" *)
  (* X_INTERFACE_PARAMETER = "PROTOCOL AXI4LITE" *)
  input  wire         s_axi_awvalid, // AXI4-Lite, registers: address to write
  (* X_INTERFACE_INFO = "xilinx.com:interface:aximm:1.0 s_axi AWREADY" *)
  output wire         s_axi_awready, // taken in this cycle
  (* X_INTERFACE_INFO = "xilinx.com:interface:aximm:1.0 s_axi AWADDR" *)
  input  wire [6:0]   s_axi_awaddr,  // sepax_registers.md
  (* X_INTERFACE_INFO = "xilinx.com:interface:aximm:1.0 s_axi WVALID" *)
  input  wire         s_axi_wvalid,  // data to write
  (* X_INTERFACE_INFO = "xilinx.com:interface:aximm:1.0 s_axi WREADY" *)
  output wire         s_axi_wready,  // taken in this cycle
  (* X_INTERFACE_INFO = "xilinx.com:interface:aximm:1.0 s_axi WDATA" *)
  input  wire [31:0]  s_axi_wdata,   // data
  (* X_INTERFACE_INFO = "xilinx.com:interface:aximm:1.0 s_axi WSTRB" *)
  input  wire [3:0]   s_axi_wstrb,   // byte strobes, all 1
  (* X_INTERFACE_INFO = "xilinx.com:interface:aximm:1.0 s_axi BVALID" *)
  output wire         s_axi_bvalid,  // response to a write
  (* X_INTERFACE_INFO = "xilinx.com:interface:aximm:1.0 s_axi BREADY" *)
  input  wire         s_axi_bready,  // taken in this cycle
  (* X_INTERFACE_INFO = "xilinx.com:interface:aximm:1.0 s_axi BRESP" *)
  output wire [1:0]   s_axi_bresp,   // 0: OKAY, 2: SLVERR
  (* X_INTERFACE_INFO = "xilinx.com:interface:aximm:1.0 s_axi ARVALID" *)
  input  wire         s_axi_arvalid, // address to read
  (* X_INTERFACE_INFO = "xilinx.com:interface:aximm:1.0 s_axi ARREADY" *)
  output wire         s_axi_arready, // taken in this cycle
  (* X_INTERFACE_INFO = "xilinx.com:interface:aximm:1.0 s_axi ARADDR" *)
  input  wire [6:0]   s_axi_araddr,  // sepax_registers.md
  (* X_INTERFACE_INFO = "xilinx.com:interface:aximm:1.0 s_axi RVALID" *)
  output wire         s_axi_rvalid,  // data that were read
  (* X_INTERFACE_INFO = "xilinx.com:interface:aximm:1.0 s_axi RREADY" *)
  input  wire         s_axi_rready,  // taken in this cycle
  (* X_INTERFACE_INFO = "xilinx.com:interface:aximm:1.0 s_axi RDATA" *)
  output wire [31:0]  s_axi_rdata,   // data
  (* X_INTERFACE_INFO = "xilinx.com:interface:aximm:1.0 s_axi RRESP" *)
  output wire [1:0]   s_axi_rresp,   // 0: OKAY, 2: SLVERR
  (* X_INTERFACE_INFO = "xilinx.com:interface:axis:1.0 s_axis TVALID" *)
  input  wire         s_axis_tvalid, // AXI4-Stream, triangles: a vertex
  (* X_INTERFACE_INFO = "xilinx.com:interface:axis:1.0 s_axis TREADY" *)
  output wire         s_axis_tready, // taken in this cycle
  (* X_INTERFACE_INFO = "xilinx.com:interface:axis:1.0 s_axis TDATA" *)
  input  wire [127:0] s_axis_tdata,  // {unused, z, y, x}, signed, 32 bits each
  (* X_INTERFACE_INFO = "xilinx.com:interface:axis:1.0 s_axis TLAST" *)
  input  wire         s_axis_tlast,  // last vertex of the object
  (* X_INTERFACE_INFO = "xilinx.com:interface:axis:1.0 s_axis TDEST" *)
  input  wire         s_axis_tdest,  // 0: object A, 1: object B
  (* X_INTERFACE_INFO = "xilinx.com:interface:axis:1.0 m_axis TVALID" *)
  output wire         m_axis_tvalid, // AXI4-Stream, results: a colliding pair, or the end
  (* X_INTERFACE_INFO = "xilinx.com:interface:axis:1.0 m_axis TREADY" *)
  input  wire         m_axis_tready, // taken in this cycle
  (* X_INTERFACE_INFO = "xilinx.com:interface:axis:1.0 m_axis TDATA" *)
  output wire [63:0]  m_axis_tdata,  // 31:0 A, 55:32 B, 56 coplanar, 57 out of range, 58 warning
  (* X_INTERFACE_INFO = "xilinx.com:interface:axis:1.0 m_axis TLAST" *)
  output wire         m_axis_tlast,  // end of the run: 31:0 results, 62 stopped, 63 1
  (* X_INTERFACE_INFO = "xilinx.com:signal:interrupt:1.0 irq INTERRUPT" *)
  (* X_INTERFACE_PARAMETER = "SENSITIVITY LEVEL_HIGH" *)
  output wire         irq            // interrupt, level: PENDING and ENABLE
);
  localparam W = @word@;     // bits of a coordinate
  localparam A = @index_a@; // bits of the number of a triangle of A
  localparam B = @index_b@; // of B
  wire rst = !aresetn;
  wire [31:0] unused = s_axis_tdata[127:96];
  wire write_a, write_b, step, fetch;
  wire [@index@-1:0] write_address;
  localparam T = 9 * W + 2;  // bits of a triangle of A: thinnest side, coordinates //@ swaps
  localparam T = 9 * W;      // bits of a triangle of A //@ !swaps
  wire [T-1:0] write_triangle, read_triangle_a;
  wire [9*W-1:0] read_triangle_b;
  wire [6*W-1:0] write_aabb, read_aabb_a, read_aabb_b;
  wire [A-1:0]   aabb_address_a, fetch_a;
  wire [B-1:0]   aabb_address_b, fetch_b;

  sepax_engine_logic logic_part (
    .clk(aclk), .rst(rst),
    .s_axi_awvalid(s_axi_awvalid), .s_axi_awready(s_axi_awready), .s_axi_awaddr(s_axi_awaddr),
    .s_axi_wvalid(s_axi_wvalid), .s_axi_wready(s_axi_wready), .s_axi_wdata(s_axi_wdata),
    .s_axi_wstrb(s_axi_wstrb), .s_axi_bvalid(s_axi_bvalid), .s_axi_bready(s_axi_bready),
    .s_axi_bresp(s_axi_bresp), .s_axi_arvalid(s_axi_arvalid), .s_axi_arready(s_axi_arready),
    .s_axi_araddr(s_axi_araddr), .s_axi_rvalid(s_axi_rvalid), .s_axi_rready(s_axi_rready),
    .s_axi_rdata(s_axi_rdata), .s_axi_rresp(s_axi_rresp),
    .s_axis_tvalid(s_axis_tvalid), .s_axis_tready(s_axis_tready),
    .s_axis_tdata(s_axis_tdata[95:0]),
    .s_axis_tlast(s_axis_tlast), .s_axis_tdest(s_axis_tdest),
    .m_axis_tvalid(m_axis_tvalid), .m_axis_tready(m_axis_tready), .m_axis_tdata(m_axis_tdata),
    .m_axis_tlast(m_axis_tlast), .irq(irq),
    .write_address(write_address), .write_triangle(write_triangle), .write_aabb(write_aabb),
    .write_a(write_a), .write_b(write_b), .step(step), .fetch(fetch), //@ !fpga
    .write_a(write_a), .write_b(write_b), .running(step), .fetch(fetch), //@ fpga
    .aabb_address_a(aabb_address_a), .aabb_address_b(aabb_address_b),
    .read_aabb_a(read_aabb_a), .read_aabb_b(read_aabb_b), .fetch_a(fetch_a), .fetch_b(fetch_b),
    .read_triangle_a(read_triangle_a), .read_triangle_b(read_triangle_b)
  );

  sepax_ram #(.WIDTH(6*W), .ADDRESS(A)) aabbs_a (
    .clk(aclk), .write(write_a), .write_address(write_address[A-1:0]), .write_data(write_aabb),
    .read(step), .read_address(aabb_address_a), .read_data(read_aabb_a)
  );
  sepax_ram #(.WIDTH(6*W), .ADDRESS(B)) aabbs_b (
    .clk(aclk), .write(write_b), .write_address(write_address[B-1:0]), .write_data(write_aabb),
    .read(step), .read_address(aabb_address_b), .read_data(read_aabb_b)
  );
  sepax_ram #(.WIDTH(T), .ADDRESS(A)) triangles_a (
    .clk(aclk), .write(write_a), .write_address(write_address[A-1:0]), .write_data(write_triangle),
    .read(fetch), .read_address(fetch_a), .read_data(read_triangle_a)
  );
  sepax_ram #(.WIDTH(9*W), .ADDRESS(B)) triangles_b (
    .clk(aclk), .write(write_b), .write_address(write_address[B-1:0]),
    .write_data(write_triangle[9*W-1:0]), .read(fetch), .read_address(fetch_b),
    .read_data(read_triangle_b)
  );
endmodule
