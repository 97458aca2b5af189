// SPDX-License-Identifier: MIT
// Self-checking test bench of the object engine, sepax_engine, in Verilog-2005, for any simulator.
// Compile it with the files of @prefix@.f; the top is sepax_engine_tb.
// It reads no other file. At the end it prints PASS or FAIL.
//
// It loads two objects of @count_a@ and @count_b@ triangles, which stand at the end.
// It runs the engine twice, the second time with B moved, and compares the results, their order,
// the counts and the interrupt with the golden model. Gaps on all buses are random.

`default_nettype none
/* verilator lint_off BLKSEQ */
/* verilator lint_off UNUSED */

module sepax_engine_tb;
  localparam COUNT_A = @count_a@;
  localparam COUNT_B = @count_b@;
  localparam RESULTS = @results@; // of both runs, with the transfers that end them
  localparam PATIENCE = @patience@; // cycles in which something must happen
  localparam MOST = 10; // errors after which it ends
  // Registers.
  localparam [31:0] COMMAND = 32'h@command@, MODE = 32'h@mode@, ENABLE = 32'h@enable@;
  localparam [31:0] PENDING = 32'h@pending@, MOVE_X = 32'h@move_x@, MOVE_Y = 32'h@move_y@;
  localparam [31:0] MOVE_Z = 32'h@move_z@, PAIRS = 32'h@pairs@, CANDIDATES = 32'h@candidates@;
  localparam [31:0] COLLISIONS = 32'h@collisions@, OUT_OF_RANGE = 32'h@out_of_range@;
  localparam [31:0] WARNINGS = 32'h@warnings@;

  reg aclk = 1'b0;
  reg aresetn = 1'b0;
  reg awvalid = 1'b0;
  reg wvalid = 1'b0;
  reg bready = 1'b0;
  reg arvalid = 1'b0;
  reg rready = 1'b0;
  reg [31:0] address = 32'd0;
  reg [31:0] wdata = 32'd0;
  reg in_valid = 1'b0;
  reg in_last = 1'b0;
  reg in_dest = 1'b0;
  reg [127:0] in = 128'd0;
  reg out_ready = 1'b0;
  wire awready, wready, bvalid, arready, rvalid, in_ready, out_valid, out_last, irq;
  wire [1:0] bresp, rresp;
  wire [31:0] rdata;
  wire [63:0] out;

  sepax_engine dut (
    .aclk(aclk), .aresetn(aresetn), .s_axi_awvalid(awvalid), .s_axi_awready(awready),
    .s_axi_awaddr(address[@address_msb@:0]), .s_axi_wvalid(wvalid), .s_axi_wready(wready),
    .s_axi_wdata(wdata), .s_axi_wstrb(4'hf), .s_axi_bvalid(bvalid), .s_axi_bready(bready),
    .s_axi_bresp(bresp), .s_axi_arvalid(arvalid), .s_axi_arready(arready),
    .s_axi_araddr(address[@address_msb@:0]), .s_axi_rvalid(rvalid), .s_axi_rready(rready),
    .s_axi_rdata(rdata), .s_axi_rresp(rresp), .s_axis_tvalid(in_valid), .s_axis_tready(in_ready),
    .s_axis_tdata(in), .s_axis_tlast(in_last), .s_axis_tdest(in_dest),
    .m_axis_tvalid(out_valid), .m_axis_tready(out_ready), .m_axis_tdata(out),
    .m_axis_tlast(out_last), .irq(irq)
  );

  always #5 aclk = !aclk;

  reg [95:0] vertex_a [0:3*COUNT_A-1]; // {z, y, x}
  reg [95:0] vertex_b [0:3*COUNT_B-1];
  reg [63:0] result [0:RESULTS-1];
  integer errors = 0;
  integer got = 0; // results
  integer waited = 0;
  integer i = 0;
  reg ended = 1'b0;
  reg blocked = 1'b0;
  reg aw_taken = 1'b0;
  reg w_taken = 1'b0;
  reg in_taken = 1'b0;
  reg [64:0] shown_before = 65'd0;
  reg [31:0] random = 32'd2463534242;

  task wrong(input [8*40-1:0] what, input [63:0] found, input [63:0] due);
    begin
      errors = errors + 1;
      $display("sepax_engine_tb: result %0d: %0s: %h, due %h", got, what, found, due);
      if (errors == MOST) begin
        finish;
      end
    end
  endtask

  task finish;
    if (!ended) begin
      ended = 1'b1;
      $display("sepax_engine_tb: %0d results, %0d errors", got, errors);
      if (errors == 0) begin
        $display("PASS");
      end else begin
        $display("FAIL");
      end
      $finish;
    end
  endtask

  function [31:0] next(input [31:0] of);
    reg [31:0] a, b;
    begin
      a = of ^ (of << 13);
      b = a ^ (a >> 17);
      next = b ^ (b << 5);
    end
  endfunction

  // One cycle from the falling edge; what was taken at the rising edge.
  task step;
    begin
      random = next(random);
      out_ready = random[17:16] != 2'd0;
      @(posedge aclk);
      aw_taken = awvalid && awready === 1'b1;
      w_taken = wvalid && wready === 1'b1;
      in_taken = in_valid && in_ready === 1'b1;
      waited = waited + 1;
      if (waited > PATIENCE && !ended) begin
        wrong("nothing happens", 64'd0, 64'd0);
        finish;
      end
      @(negedge aclk);
    end
  endtask

  // Results, as they come.
  always @(posedge aclk) begin
    if (aresetn && !ended) begin
      if (^{out_valid, irq} === 1'bx) begin
        wrong("an output is X", {62'd0, out_valid, irq}, 64'd0);
      end
      if (blocked && (out_valid !== 1'b1 || {out_last, out} !== shown_before)) begin
        wrong("a result moves while it waits", out, shown_before[63:0]);
      end
      blocked = out_valid === 1'b1 && !out_ready;
      shown_before = {out_last, out};
      if (out_valid === 1'b1 && out_ready) begin
        waited = 0;
        if (got >= RESULTS) begin
          wrong("a result too many", out, 64'd0);
        end else if (out !== result[got] || out_last !== result[got][63]) begin
          wrong("a wrong result", out, result[got]);
        end
        got = got + 1;
      end
    end
  end

  task write(input [31:0] at, input [31:0] data);
    begin
      {awvalid, wvalid, bready} = 3'b111;
      address = at;
      wdata = data;
      waited = 0;
      while ((awvalid || wvalid) && !ended) begin
        step;
        awvalid = awvalid && !aw_taken;
        wvalid = wvalid && !w_taken;
      end
      while (bvalid !== 1'b1 && !ended) begin
        step;
      end
      if (bresp !== 2'd0) begin
        wrong("a write is refused", {32'd0, at}, 64'd0);
      end
      step;
      bready = 1'b0;
    end
  endtask

  task expect_register(input [8*40-1:0] name, input [31:0] at, input [31:0] due);
    begin
      {arvalid, rready} = 2'b11;
      address = at;
      waited = 0;
      while (arready !== 1'b1 && !ended) begin
        step;
      end
      step;
      arvalid = 1'b0;
      while (rvalid !== 1'b1 && !ended) begin
        step;
      end
      if (rdata !== due || rresp !== 2'd0) begin
        wrong(name, {32'd0, rdata}, {32'd0, due});
      end
      step;
      rready = 1'b0;
    end
  endtask

  task load(input of_b);
    integer vertices;
    begin
      waited = 0;
      in_dest = of_b;
      vertices = of_b ? 3 * COUNT_B : 3 * COUNT_A;
      i = 0;
      while (i < vertices && !ended) begin
        if (!in_valid) begin
          in_valid = random[3:0] != 4'd0;
          in = {random, of_b ? vertex_b[i] : vertex_a[i]};
          in_last = i + 1 == vertices;
        end
        step;
        if (in_taken) begin
          i = i + 1;
          in_valid = 1'b0;
          waited = 0;
        end
      end
    end
  endtask

  // Move B, begin a run, wait for the interrupt, clear it.
  task run(input [31:0] x, input [31:0] y, input [31:0] z);
    begin
      write(MOVE_X, x);
      write(MOVE_Y, y);
      write(MOVE_Z, z);
      write(COMMAND, 32'd1);
      while (irq !== 1'b1 && !ended) begin
        step;
      end
      repeat (64) step; // the last results may wait
      write(PENDING, 32'd1);
      repeat (8) step;
      if (irq !== 1'b0) begin
        wrong("the interrupt stays", 64'd1, 64'd0);
      end
    end
  endtask

  initial begin
    repeat (3) @(negedge aclk);
    aresetn = 1'b1;
    load(1'b0);
    load(1'b1);
    repeat (8) step;
    write(MODE, 32'd0);
    write(ENABLE, 32'd1);
@runs@
    if (got != RESULTS) begin
      wrong("results are missing", RESULTS, {32'd0, got});
    end
    finish;
  end

  initial begin
