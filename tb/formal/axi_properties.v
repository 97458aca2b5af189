// axi_properties.v - what AXI asks of the engine on the channels that it drives, for
// yosys-smtbmc: every input is free in every cycle, also in reset, from any state.
`default_nettype none

// A channel: once valid, it stays, data and all, until it is taken; only reset ends that.
module stands #(
    parameter WIDTH = 1
) (
    input wire clk, rst, valid, ready,
    input wire [WIDTH-1:0] data
);
  reg begun = 1'b0;
  always @(posedge clk) begin
    begun <= 1'b1;
    if (begun && $past(valid && !ready && !rst)) begin
      assert (valid);
      assert (data == $past(data));
    end
    if (begun && $past(rst)) assert (!valid);
  end
endmodule

// A slave's side of requests and their responses: no response without its request, and not
// more than two requests under way (one that waits, one that is answered).
module answers (
    input wire clk, rst, request, valid, ready
);
  reg [2:0] open = 3'd0;
  reg begun = 1'b0;
  always @(posedge clk) begin
    begun <= 1'b1;
    assume (begun || rst);
    open  <= rst ? 3'd0 : open + {2'd0, request} - {2'd0, valid && ready};
    if (begun && !rst && !$past(rst)) begin
      if (valid) assert (open != 3'd0);
      assert (open <= 3'd2);
    end
  end
endmodule

module registers_properties (
    input wire clk, rst, awvalid, wvalid, bready, arvalid, rready, done, hit, loaded,
    input wire [6:0] awaddr, araddr,
    input wire [3:0] wstrb,
    input wire [31:0] wdata, status, number
);
  wire awready, wready, bvalid, arready, rvalid, start;
  wire [1:0] bresp, rresp;
  wire [31:0] rdata;
  sepax_registers dut (
      .clk(clk), .rst(rst), .awvalid(awvalid), .awready(awready), .awaddr(awaddr), .wvalid(wvalid),
      .wready(wready), .wdata(wdata), .wstrb(wstrb), .bvalid(bvalid), .bready(bready),
      .bresp(bresp), .arvalid(arvalid), .arready(arready), .araddr(araddr), .rvalid(rvalid),
      .rready(rready), .rdata(rdata), .rresp(rresp), .start(start), .status(status), .done(done),
      .hit(hit), .loaded(loaded), .count_a(number), .count_b(number), .pairs(number),
      .candidates(number), .collisions(number), .out_of_range(number), .warnings(number),
      .cycles(number), .first_a(number), .first_b(number));
`ifdef STANDS
  stands #(.WIDTH(2)) b (.clk(clk), .rst(rst), .valid(bvalid), .ready(bready), .data(bresp));
  stands #(.WIDTH(34)) r (
      .clk(clk), .rst(rst), .valid(rvalid), .ready(rready), .data({rresp, rdata}));
`else
  answers writes (
      .clk(clk), .rst(rst), .request(awvalid && awready), .valid(bvalid), .ready(bready));
  answers data (
      .clk(clk), .rst(rst), .request(wvalid && wready), .valid(bvalid), .ready(bready));
  answers reads (
      .clk(clk), .rst(rst), .request(arvalid && arready), .valid(rvalid), .ready(rready));
  // A run begins only by a write, and not while one goes on or objects are missing.
  reg begun = 1'b0;
  reg could = 1'b0; // in the cycle before
`ifdef FPGA
  reg could_soon = 1'b0;
`endif
  always @(posedge clk) begin
    begun <= 1'b1;
`ifdef FPGA
    {could, could_soon} <= {could_soon, !status[0] && status[4] && status[5] && !status[6]};
`else
    could <= !status[0] && status[4] && status[5] && !status[6];
`endif
    if (begun && start) assert (could);
  end
`endif
endmodule

module results_properties (
    input wire clk, rst, start, stop, first, quiet, launched, drained, valid, collision, coplanar,
    input wire outside, tready,
    input wire [6:0] tested,
    input wire [8:0] a, b
);
  wire tvalid, tlast, busy;
  wire [63:0] tdata;
  sepax_results dut (
      .clk(clk), .rst(rst), .start(start), .stop(stop), .first(first), .quiet(quiet),
      .tested(tested), .launched(launched), .drained(drained), .valid(valid),
      .collision(collision), .coplanar(coplanar), .outside(outside), .a(a), .b(b),
      .tvalid(tvalid), .tready(tready), .tdata(tdata), .tlast(tlast), .busy(busy));
`ifdef STANDS
  stands #(.WIDTH(65)) m (
      .clk(clk), .rst(rst), .valid(tvalid), .ready(tready), .data({tlast, tdata}));
`else
  // With verdicts only in a run and none once it is drained: the last transfer counts those
  // before it, and it alone has bit 63.
  reg [31:0] sent = 32'd0;
  reg begun = 1'b0;
  always @(posedge clk) begin
    begun <= 1'b1;
    assume (begun || rst);
    if (busy) assume (!start);
    assume (!quiet);
    if (!busy) assume (!valid);
    if (valid) assume (!drained);
    if (begun && $past(drained && !start && !rst)) assume (drained);
    if (rst || start) sent <= 32'd0;
    else if (tvalid && tready && !tlast) sent <= sent + 32'd1;
    if (begun && !rst && !$past(rst) && tvalid && tlast) begin
      assert (tdata[31:0] == sent);
      assert (tdata[63]);
    end
    if (begun && !rst && !$past(rst) && tvalid && !tlast) assert (!tdata[63]);
  end
`endif
endmodule

module load_properties (
    input wire clk, rst, busy, tvalid, tlast, tdest,
    input wire [95:0] tdata
);
  wire tready, write_a, write_b;
  wire [9:0] count_a, count_b;
  sepax_load dut (
      .clk(clk), .rst(rst), .busy(busy), .tvalid(tvalid), .tready(tready), .tdata(tdata),
      .tlast(tlast), .tdest(tdest), .write_a(write_a), .write_b(write_b), .count_a(count_a),
      .count_b(count_b));
  // Ready does not wait for valid, and nothing is taken or changed during a run; what came in the
  // cycle before one is written in its first.
  reg begun = 1'b0;
  reg was_busy = 1'b0; // two cycles ago
  wire shut; // no vertex is on its way
`ifdef FPGA
  reg shut_q = 1'b0; // a vertex waits a cycle in registers
  always @(posedge clk) shut_q <= busy && !rst;
  assign shut = shut_q && busy;
`else
  assign shut = busy;
`endif
  always @(posedge clk) begin
    begun <= 1'b1;
    was_busy <= begun && $past(shut && !rst);
    assert (tready == !busy);
    if (begun && $past(shut && !rst)) begin
      assert (!was_busy || (!write_a && !write_b));
      assert (count_a == $past(count_a) && count_b == $past(count_b));
    end
    if (begun) assert (!(write_a && write_b));
  end
endmodule

// A run finds both objects whole, and they stay so: a vertex does not slip in as it begins.
module start_properties (
    input wire clk, rst, awvalid, wvalid, bready, over, tvalid, tlast, tdest,
    input wire [6:0] awaddr,
    input wire [31:0] wdata,
    input wire [95:0] tdata
);
  wire start, starting, loading, ended;
  wire [9:0] count_a, count_b;
  wire [31:0] status = {25'd0, loading, |count_b, |count_a, 3'd0, busy};
  reg busy = 1'b0;
  reg begun = 1'b0;
  sepax_registers registers (
      .clk(clk), .rst(rst), .awvalid(awvalid), .awaddr(awaddr), .wvalid(wvalid), .wdata(wdata),
      .wstrb(4'hf), .bready(bready), .arvalid(1'b0), .araddr(7'd0), .rready(1'b0), .start(start),
      .starting(starting), .status(status), .done(1'b0), .hit(1'b0), .loaded(ended),
      .count_a(32'd0), .count_b(32'd0), .pairs(32'd0), .candidates(32'd0), .collisions(32'd0),
      .out_of_range(32'd0), .warnings(32'd0), .cycles(32'd0), .first_a(32'd0), .first_b(32'd0));
  sepax_load load (
      .clk(clk), .rst(rst), .busy(busy || starting), .tvalid(tvalid), .tdata(tdata), .tlast(tlast),
      .tdest(tdest), .count_a(count_a), .count_b(count_b), .loading(loading), .ended(ended));
  always @(posedge clk) begin
    begun <= 1'b1;
    assume (begun || rst);
    busy <= !rst && (start || (busy && !over));
    if (begun && !rst && (start || busy)) begin
      assert (!loading && count_a != 10'd0 && count_b != 10'd0);
    end
  end
endmodule

`default_nettype wire
