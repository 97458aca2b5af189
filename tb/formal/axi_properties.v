// SPDX-License-Identifier: MIT
// axi_properties.v - what AXI asks of the engine on the channels that it drives, for ABC: every
// input is free in every cycle after a reset, also later resets.
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
    assume (begun || rst);
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
  wire awready, wready, bvalid, arready, rvalid, irq, start;
  wire [1:0] bresp, rresp;
  wire [31:0] rdata;
  sepax_registers dut (
      .clk(clk), .rst(rst), .awvalid(awvalid), .awready(awready), .awaddr(awaddr), .wvalid(wvalid),
      .wready(wready), .wdata(wdata), .wstrb(wstrb), .bvalid(bvalid), .bready(bready),
      .bresp(bresp), .arvalid(arvalid), .arready(arready), .araddr(araddr), .rvalid(rvalid),
      .rready(rready), .rdata(rdata), .rresp(rresp), .irq(irq), .start(start),
      .status(status), .done(done), .hit(hit), .loaded(loaded), .count_a(number),
      .count_b(number), .pairs(number), .candidates(number), .collisions(number),
      .out_of_range(number), .warnings(number), .cycles(number), .first_a(number),
      .first_b(number));
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

  // ENABLE and PENDING, as writes with the response OKAY make them: what sets a bit in the cycle in
  // which it is cleared wins, and the interrupt is that of both.
  localparam [6:0] ENABLE = 7'd28, PENDING = 7'd32;
  reg [6:0] written;
  reg [2:0] word, enable, pending, set;
  reg       stood = 1'b0; // the response was there before
  wire wrote = bvalid && !stood && bresp == 2'd0;
  wire [2:0] now_enabled = wrote && written == ENABLE ? word : enable;
  wire [2:0] now_pending = (wrote && written == PENDING ? pending & ~word : pending) | set;
  always @(posedge clk) begin
    if (awvalid && awready) written <= awaddr;
    if (wvalid && wready) word <= wdata[2:0];
    stood <= bvalid && !bready;
    set <= rst ? 3'd0 : {loaded, hit, done};
    enable <= rst ? 3'd0 : now_enabled;
    pending <= rst ? 3'd0 : now_pending;
    if (begun && !$past(rst)) assert (irq == |(now_pending & now_enabled));
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
  wire [`INDEX:0] count_a, count_b;
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
    assume (begun || rst);
    was_busy <= begun && $past(shut && !rst);
    assert (tready == !busy);
    if (begun && $past(shut && !rst)) begin
      assert (!was_busy || (!write_a && !write_b));
      assert (count_a == $past(count_a) && count_b == $past(count_b));
    end
    if (begun) assert (!(write_a && write_b));
  end
endmodule

// Every vertex that is taken counts, also one right behind TLAST: the triangles that are written,
// their numbers, and the counts are those of the vertices, taken by a model.
module object_properties (
    input wire clk, rst, busy, tvalid, tlast, tdest,
    input wire [95:0] tdata
);
  localparam W = `WORD;
  localparam N = `INDEX; // bits of a triangle's number; a count has one more
`ifdef FPGA
  localparam LATE = 3; // cycles from a last vertex to its triangle
`else
  localparam LATE = 2;
`endif
  wire tready, write_a, write_b, loading;
  wire [N-1:0] address;
  wire [9*W-1:0] triangle;
  wire [N:0] count_a, count_b;
  sepax_load dut (
      .clk(clk), .rst(rst), .busy(busy), .tvalid(tvalid), .tready(tready), .tdata(tdata),
      .tlast(tlast), .tdest(tdest), .write_a(write_a), .write_b(write_b), .address(address),
      .triangle(triangle), .count_a(count_a), .count_b(count_b), .loading(loading));

  // The model: the corner that comes, triangles before it in this object, all of it in range.
  localparam T = 9 * W + N + 2; // a triangle that is written: into {b, a}, its number, its corners
  reg [1:0] corner;
  reg [N:0] before;            // not above 2^N: no more are kept
  reg       fit, of_b;
  reg [6*W-1:0] corners;       // the two before
  reg [N:0] want_a, want_b;    // the counts
  reg [LATE*(2*N+2)-1:0] counts; // a cycle ago (lowest), two ago ...
  reg [LATE*T-1:0]  triangles; // in this cycle (lowest), a cycle ago ...
  wire take = tvalid && tready;
  wire first = corner == 2'd0 && before == 0;
  wire free = !before[N];
  wire third = corner == 2'd2;
  wire b = first ? tdest : of_b;
  wire [2:0] fits;
  wire [3*W-1:0] vertex;
  wire all_fit = (&fits) && (first || fit);
  genvar n;
  generate
    for (n = 0; n < 3; n = n + 1) begin : axis
      assign vertex[n*W +: W] = tdata[32*n +: W];
      assign fits[n] = $signed(tdata[32*n +: 32]) == $signed(vertex[n*W +: W]);
    end
  endgenerate
  wire [2*N+1:0] wanted = {counts, want_b, want_a} >> (2 * N + 2) * (LATE - 2);
  reg begun = 1'b0;
  always @(posedge clk) begin
    begun <= 1'b1;
    assume (begun || rst);
    if (take) begin
      corner <= tlast || third ? 2'd0 : corner + 2'd1;
      before <= tlast ? 0 : before + (third && free);
      {fit, of_b} <= {all_fit, b};
      corners <= {vertex, corners[3*W +: 3*W]};
      if (b) want_b <= tlast && third && all_fit && free ? before + 1 : 0;
      else want_a <= tlast && third && all_fit && free ? before + 1 : 0;
    end
    counts <= {counts, want_b, want_a};
    triangles <= {triangles, {b, !b} & {2{take && third && free}}, before[N-1:0], vertex, corners};
    if (rst) begin
      {corner, before, want_a, want_b, counts, triangles} <= 0;
    end
    if (begun && !$past(rst)) begin
      assert ({count_b, count_a} == wanted);
      assert ({write_b, write_a} == triangles[LATE*T-1 -: 2]);
      if (write_a || write_b) assert ({address, triangle} == triangles[LATE*T-3 -: T-2]);
    end
  end
endmodule

`ifdef INSIDE
// A run finds both objects whole, and they stay so: a vertex does not slip in as it begins. The
// assertion is inside of the engine's own wiring; what is behind that may do anything: see axi.
module engine_properties (
    input wire clk, rst, awvalid, wvalid, bready, tvalid, tlast, tdest, tready,
    input wire [6:0] awaddr,
    input wire [31:0] wdata,
    input wire [95:0] tdata
);
  sepax_engine_logic dut (
      .clk(clk), .rst(rst), .s_axi_awvalid(awvalid), .s_axi_awaddr(awaddr), .s_axi_wvalid(wvalid),
      .s_axi_wdata(wdata), .s_axi_wstrb(4'hf), .s_axi_bready(bready), .s_axi_arvalid(1'b0),
      .s_axi_araddr(7'd0), .s_axi_rready(1'b0), .s_axis_tvalid(tvalid), .s_axis_tdata(tdata),
      .s_axis_tlast(tlast), .s_axis_tdest(tdest), .m_axis_tready(tready));
endmodule
`endif

`default_nettype wire
