// SPDX-License-Identifier: MIT
// soc_top.v
//
// A CPU (PicoRV32), its memory and the object engine on one bus:
//   00000000  memory, 4 * 2^ADDRESS bytes: the program, its data, its stack
//   10000000  write: a character for the console; 10000004  write: the program ends with this code
//   20000000  the engine: soc_bridge.v
// Another address ends the program with code 255, as a trap of the CPU does.

`default_nettype none

module soc_top #(
  parameter FIRMWARE = "firmware.hex", // soc_ram.v
  parameter ADDRESS = 14
) (
  input  wire       clk,           // clock
  input  wire       rst,           // synchronous reset, active high
  output reg        console_valid, // a character for the console, for one cycle
  output reg  [7:0] console,       // the character
  output reg        ended,         // the program has ended
  output reg  [7:0] code           // its code
);
  wire        mem_valid, trap;
  wire [31:0] mem_addr, mem_wdata;
  wire [3:0]  mem_wstrb;
  wire        is_ram = mem_addr[31:ADDRESS+2] == {(30-ADDRESS){1'b0}};
  wire        is_engine = mem_addr[31:8] == 24'h200000;
  wire        is_console = mem_addr[31:3] == 29'h02000000;
  reg         ram_ready_q;
  wire        engine_ready;
  wire [31:0] ram_rdata, engine_rdata;
  wire        begins = mem_valid && !ram_ready_q;

  wire        awvalid, awready, wvalid, wready, bvalid, arvalid, arready, rvalid;
  wire [31:0] rdata;
  wire [1:0]  bresp, rresp;
  wire        vertex_valid, vertex_ready, vertex_last, vertex_to_b;
  wire [95:0] vertex;
  wire        result_valid, result_ready, result_last;
  wire [63:0] result;
  wire        unused_instr, unused_irq; // the driver asks
  wire        unused_la_read, unused_la_write, unused_pcpi_valid, unused_trace_valid;
  wire [31:0] unused_la_addr, unused_la_wdata, unused_insn, unused_rs1, unused_rs2, unused_eoi;
  wire [3:0]  unused_la_wstrb;
  wire [35:0] unused_trace;

  picorv32 #(
    .STACKADDR(4 << ADDRESS), .ENABLE_COUNTERS(0), .ENABLE_COUNTERS64(0), .BARREL_SHIFTER(1)
  ) cpu (
    .clk(clk), .resetn(!rst && !ended), .trap(trap),
    .mem_valid(mem_valid), .mem_instr(unused_instr), .mem_ready(ram_ready_q || engine_ready),
    .mem_addr(mem_addr), .mem_wdata(mem_wdata), .mem_wstrb(mem_wstrb),
    .mem_rdata(engine_ready ? engine_rdata : ram_rdata),
    .mem_la_read(unused_la_read), .mem_la_write(unused_la_write), .mem_la_addr(unused_la_addr),
    .mem_la_wdata(unused_la_wdata), .mem_la_wstrb(unused_la_wstrb),
    .pcpi_valid(unused_pcpi_valid), .pcpi_insn(unused_insn), .pcpi_rs1(unused_rs1),
    .pcpi_rs2(unused_rs2), .pcpi_wr(1'b0), .pcpi_rd(32'd0), .pcpi_wait(1'b0), .pcpi_ready(1'b0),
    .irq(32'd0), .eoi(unused_eoi), .trace_valid(unused_trace_valid), .trace_data(unused_trace)
  );

  soc_ram #(.FIRMWARE(FIRMWARE), .ADDRESS(ADDRESS)) ram (
    .clk(clk), .address(mem_addr[ADDRESS+1:2]),
    .strobes(mem_wstrb & {4{begins && is_ram}}), .wdata(mem_wdata), .rdata(ram_rdata)
  );

  soc_bridge bridge (
    .clk(clk), .rst(rst), .valid(mem_valid && is_engine), .ready(engine_ready),
    .word(mem_addr[7:2]), .strobes(mem_wstrb), .wdata(mem_wdata), .rdata(engine_rdata),
    .awvalid(awvalid), .awready(awready), .wvalid(wvalid), .wready(wready), .bvalid(bvalid),
    .bresp(bresp), .arvalid(arvalid), .arready(arready), .rvalid(rvalid), .rdata_in(rdata),
    .rresp(rresp), .vertex_valid(vertex_valid), .vertex_ready(vertex_ready), .vertex(vertex),
    .vertex_last(vertex_last), .vertex_to_b(vertex_to_b), .result_valid(result_valid),
    .result_ready(result_ready), .result(result), .result_last(result_last)
  );

  sepax_engine engine (
    .aclk(clk), .aresetn(!rst),
    .s_axi_awvalid(awvalid), .s_axi_awready(awready), .s_axi_awaddr(mem_addr[6:0]),
    .s_axi_wvalid(wvalid), .s_axi_wready(wready), .s_axi_wdata(mem_wdata), .s_axi_wstrb(mem_wstrb),
    .s_axi_bvalid(bvalid), .s_axi_bready(1'b1), .s_axi_bresp(bresp),
    .s_axi_arvalid(arvalid), .s_axi_arready(arready), .s_axi_araddr(mem_addr[6:0]),
    .s_axi_rvalid(rvalid), .s_axi_rready(1'b1), .s_axi_rdata(rdata), .s_axi_rresp(rresp),
    .s_axis_tvalid(vertex_valid), .s_axis_tready(vertex_ready), .s_axis_tdata({32'd0, vertex}),
    .s_axis_tlast(vertex_last), .s_axis_tdest(vertex_to_b),
    .m_axis_tvalid(result_valid), .m_axis_tready(result_ready), .m_axis_tdata(result),
    .m_axis_tlast(result_last), .irq(unused_irq)
  );

  always @(posedge clk) begin
    ram_ready_q <= begins && (is_ram || is_console) && !rst;
    console_valid <= begins && is_console && (|mem_wstrb) && !mem_addr[2];
    console <= mem_wdata[7:0];
    if (rst) begin
      ended <= 1'b0;
    end else if (!ended && begins && is_console && (|mem_wstrb) && mem_addr[2]) begin
      ended <= 1'b1;
      code <= mem_wdata[7:0];
    end else if (!ended && (trap || (mem_valid && !is_ram && !is_console && !is_engine))) begin
      ended <= 1'b1;
      code <= 8'd255;
    end
  end
endmodule

`default_nettype wire
