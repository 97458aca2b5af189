// SPDX-License-Identifier: MIT
// ulx3s_board.v
//
// The object engine behind a serial line: all of a board's top but its pins and its PLL. Requests
// come over the line, collisions go back.

`default_nettype none

module ulx3s_board #(
  parameter CLOCK_HZ = 100000000, // of clk
  parameter CLOCKS = 33, // cycles a bit of the serial line
  parameter IDLE = 22, // 2^IDLE cycles without a byte cut a packet short
  parameter RESULTS = 12 // 2^RESULTS results wait without holding up a run
) (
  input  wire       clk,
  input  wire [1:0] run,      // {button released, PLL stable}: all is reset while not 2'b11
  input  wire       line_in,  // the serial line from the host
  output wire       line_out, // to it
  output wire [7:0] led       // ulx3s_leds.v, 1: on
);
  reg  [1:0] run_q, run_q2;
  reg  [3:0] awake_q;
  reg        rst, engine_rst;

  wire        in_valid, in_bad, out_valid, out_ready, hello, refused;
  wire [7:0]  in, out;
  wire        awvalid, awready, wvalid, wready, bvalid, arvalid, arready, rvalid;
  wire [6:0]  awaddr, araddr;
  wire [31:0] wdata, rdata;
  wire [1:0]  bresp, rresp;
  wire        vertex_valid, vertex_ready, vertex_last, vertex_to_b;
  wire [95:0] vertex;
  wire        result_valid, result_ready, result_last, waiting, taken;
  wire [63:0] result;
  wire [64:0] oldest;
  wire        unused_irq; // requests ask

  always @(posedge clk) begin
    run_q <= run;
    run_q2 <= run_q;
    awake_q <= (&run_q2) ? {awake_q[2:0], 1'b1} : 4'd0;
    rst <= !awake_q[3];
    engine_rst <= !awake_q[3] || hello;
  end

  ulx3s_uart_in #(.CLOCKS(CLOCKS)) uart_in (
    .clk(clk), .rst(rst), .line(line_in), .valid(in_valid), .bad(in_bad), .data(in)
  );
  ulx3s_uart_out #(.CLOCKS(CLOCKS)) uart_out (
    .clk(clk), .rst(rst), .valid(out_valid), .ready(out_ready), .data(out), .line(line_out)
  );

  ulx3s_loader #(.CLOCK_HZ(CLOCK_HZ), .IDLE(IDLE)) loader (
    .clk(clk), .rst(rst), .in_valid(in_valid), .in_bad(in_bad), .in(in), .out_valid(out_valid),
    .out_ready(out_ready), .out(out), .hello(hello), .refused(refused),
    .axi_awvalid(awvalid), .axi_awready(awready), .axi_wvalid(wvalid), .axi_wready(wready),
    .axi_awaddr(awaddr), .axi_wdata(wdata), .axi_bvalid(bvalid), .axi_bresp(bresp),
    .axi_arvalid(arvalid), .axi_arready(arready), .axi_araddr(araddr), .axi_rvalid(rvalid),
    .axi_rdata(rdata), .axi_rresp(rresp),
    .vertex_valid(vertex_valid), .vertex_ready(vertex_ready), .vertex(vertex),
    .vertex_last(vertex_last), .vertex_to_b(vertex_to_b),
    .result_valid(waiting), .result_taken(taken), .result(oldest)
  );

  sepax_engine engine (
    .aclk(clk), .aresetn(!engine_rst),
    .s_axi_awvalid(awvalid), .s_axi_awready(awready), .s_axi_awaddr(awaddr),
    .s_axi_wvalid(wvalid), .s_axi_wready(wready), .s_axi_wdata(wdata), .s_axi_wstrb(4'hf),
    .s_axi_bvalid(bvalid), .s_axi_bready(1'b1), .s_axi_bresp(bresp),
    .s_axi_arvalid(arvalid), .s_axi_arready(arready), .s_axi_araddr(araddr),
    .s_axi_rvalid(rvalid), .s_axi_rready(1'b1), .s_axi_rdata(rdata), .s_axi_rresp(rresp),
    .s_axis_tvalid(vertex_valid), .s_axis_tready(vertex_ready), .s_axis_tdata({32'd0, vertex}),
    .s_axis_tlast(vertex_last), .s_axis_tdest(vertex_to_b),
    .m_axis_tvalid(result_valid), .m_axis_tready(result_ready), .m_axis_tdata(result),
    .m_axis_tlast(result_last), .irq(unused_irq)
  );

  ulx3s_fifo #(.WIDTH(65), .ADDRESS(RESULTS)) results (
    .clk(clk), .rst(engine_rst), .in_valid(result_valid), .in_ready(result_ready),
    .in({result_last, result}), .out_valid(waiting), .out_ready(taken), .out(oldest)
  );

  ulx3s_leds leds (
    .clk(clk), .rst(engine_rst), .came(in_valid), .vertex(vertex_valid && vertex_ready),
    .vertex_last(vertex_last), .result(result_valid), .result_taken(result_ready),
    .result_last(result_last), .result_none(!(|result[31:0])), .waiting(waiting),
    .refused(refused), .led(led)
  );
endmodule

`default_nettype wire
