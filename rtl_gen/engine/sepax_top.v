// Which triangles of object A collide with which of object B: all pairs go through @lanes@
// comparator lanes, those whose AABBs overlap to @cores@ exact core@plural@ behind a FIFO.
// @memory_a@ triangles of A, @memory_b@ of B at most. Objects come over AXI4-Stream, a vertex a
// transfer; AXI4-Lite starts a run and reads its counts; collisions leave over AXI4-Stream. No
// ready is reached from an input without a register. A run takes about
// ceil(a / @lanes@) max(b, @lanes@) + @fill@ cycles and the latency of the core, more where the
// cores do not keep up.
module sepax_engine (
  input  wire        clk,           // clock of everything
  input  wire        rst,           // synchronous reset of the control, active high
  input  wire        s_axi_awvalid, // AXI4-Lite, registers: address to write
  output wire        s_axi_awready, // taken in this cycle
  input  wire [6:0]  s_axi_awaddr,  // sepax_registers.md
  input  wire        s_axi_wvalid,  // data to write
  output wire        s_axi_wready,  // taken in this cycle
  input  wire [31:0] s_axi_wdata,   // data
  input  wire [3:0]  s_axi_wstrb,   // byte strobes, all 1
  output wire        s_axi_bvalid,  // response to a write
  input  wire        s_axi_bready,  // taken in this cycle
  output wire [1:0]  s_axi_bresp,   // 0: OKAY, 2: SLVERR
  input  wire        s_axi_arvalid, // address to read
  output wire        s_axi_arready, // taken in this cycle
  input  wire [6:0]  s_axi_araddr,  // sepax_registers.md
  output wire        s_axi_rvalid,  // data that were read
  input  wire        s_axi_rready,  // taken in this cycle
  output wire [31:0] s_axi_rdata,   // data
  output wire [1:0]  s_axi_rresp,   // 0: OKAY, 2: SLVERR
  input  wire        s_axis_tvalid, // AXI4-Stream, triangles: a vertex
  output wire        s_axis_tready, // taken in this cycle
  input  wire [95:0] s_axis_tdata,  // {z, y, x}, signed, 32 bits each
  input  wire        s_axis_tlast,  // last vertex of the object
  input  wire        s_axis_tdest,  // 0: object A, 1: object B
  output wire        m_axis_tvalid, // AXI4-Stream, results: a colliding pair, or the end
  input  wire        m_axis_tready, // taken in this cycle
  output wire [63:0] m_axis_tdata,  // sepax_results.v
  output wire        m_axis_tlast,  // end of the run
  output wire        irq            // interrupt, level: PENDING and ENABLE
);
  localparam W = @word@;     // bits of a coordinate
  localparam A = @index_a@; // bits of the number of a triangle of A
  localparam B = @index_b@; // of B
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
    .clk(clk), .rst(rst),
    .s_axi_awvalid(s_axi_awvalid), .s_axi_awready(s_axi_awready), .s_axi_awaddr(s_axi_awaddr),
    .s_axi_wvalid(s_axi_wvalid), .s_axi_wready(s_axi_wready), .s_axi_wdata(s_axi_wdata),
    .s_axi_wstrb(s_axi_wstrb), .s_axi_bvalid(s_axi_bvalid), .s_axi_bready(s_axi_bready),
    .s_axi_bresp(s_axi_bresp), .s_axi_arvalid(s_axi_arvalid), .s_axi_arready(s_axi_arready),
    .s_axi_araddr(s_axi_araddr), .s_axi_rvalid(s_axi_rvalid), .s_axi_rready(s_axi_rready),
    .s_axi_rdata(s_axi_rdata), .s_axi_rresp(s_axi_rresp),
    .s_axis_tvalid(s_axis_tvalid), .s_axis_tready(s_axis_tready), .s_axis_tdata(s_axis_tdata),
    .s_axis_tlast(s_axis_tlast), .s_axis_tdest(s_axis_tdest),
    .m_axis_tvalid(m_axis_tvalid), .m_axis_tready(m_axis_tready), .m_axis_tdata(m_axis_tdata),
    .m_axis_tlast(m_axis_tlast), .irq(irq),
    .write_address(write_address), .write_triangle(write_triangle), .write_aabb(write_aabb),
    .write_a(write_a), .write_b(write_b), .step(step), .fetch(fetch),
    .aabb_address_a(aabb_address_a), .aabb_address_b(aabb_address_b),
    .read_aabb_a(read_aabb_a), .read_aabb_b(read_aabb_b), .fetch_a(fetch_a), .fetch_b(fetch_b),
    .read_triangle_a(read_triangle_a), .read_triangle_b(read_triangle_b)
  );

  sepax_ram #(.WIDTH(6*W), .ADDRESS(A)) aabbs_a (
    .clk(clk), .write(write_a), .write_address(write_address[A-1:0]), .write_data(write_aabb),
    .read(step), .read_address(aabb_address_a), .read_data(read_aabb_a)
  );
  sepax_ram #(.WIDTH(6*W), .ADDRESS(B)) aabbs_b (
    .clk(clk), .write(write_b), .write_address(write_address[B-1:0]), .write_data(write_aabb),
    .read(step), .read_address(aabb_address_b), .read_data(read_aabb_b)
  );
  sepax_ram #(.WIDTH(T), .ADDRESS(A)) triangles_a (
    .clk(clk), .write(write_a), .write_address(write_address[A-1:0]), .write_data(write_triangle),
    .read(fetch), .read_address(fetch_a), .read_data(read_triangle_a)
  );
  sepax_ram #(.WIDTH(9*W), .ADDRESS(B)) triangles_b (
    .clk(clk), .write(write_b), .write_address(write_address[B-1:0]),
    .write_data(write_triangle[9*W-1:0]), .read(fetch), .read_address(fetch_b),
    .read_data(read_triangle_b)
  );
endmodule
