// SPDX-License-Identifier: MIT
// sepax_engine but for its memories, which are beside it.
module sepax_engine_logic (
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
  output wire [63:0] m_axis_tdata,  // 31:0 A, 55:32 B, 56 coplanar, 57 out of range, 58 warning
  output wire        m_axis_tlast,  // end of the run: 31:0 results, 62 stopped, 63 1
  output wire        irq,           // interrupt, level: PENDING and ENABLE
  output wire [@index@-1:0]    write_address,   // number of a triangle to write
  output wire [9*@word@+1:0] write_triangle,  // {thinnest side, coordinates} //@ swaps
  output wire [9*@word@-1:0] write_triangle,  // its coordinates //@ !swaps
  output wire [6*@word@-1:0] write_aabb,      // its AABB
  output wire            write_a,         // write to both memories of A
  output wire            write_b,         // write to both memories of B
  output wire            step,            // read both memories of AABBs //@ !fpga
  output wire            running,         // read both memories of AABBs //@ fpga
  output wire            fetch,           // read both memories of triangles
  output wire [@index_a@-1:0]    aabb_address_a,  // of A's AABB to read
  output wire [@index_b@-1:0]    aabb_address_b,  // of B's
  input  wire [6*@word@-1:0] read_aabb_a,     // A's AABB, in the next cycle
  input  wire [6*@word@-1:0] read_aabb_b,     // B's
  output wire [@index_a@-1:0]    fetch_a,         // number of A's triangle to read
  output wire [@index_b@-1:0]    fetch_b,         // of B's
  input  wire [9*@word@+1:0] read_triangle_a, // A's triangle, in the next cycle //@ swaps
  input  wire [9*@word@-1:0] read_triangle_a, // A's triangle, in the next cycle //@ !swaps
  input  wire [9*@word@-1:0] read_triangle_b  // B's
);
  localparam W = @word@;     // bits of a coordinate
  localparam LANES = @lanes@;
  localparam A = @index_a@; // bits of the number of a triangle of A
  localparam B = @index_b@; // of B

  // Registers, and the objects that they let in.
  wire start, starting, stop, first, quiet, halt, done, hit, busy, stopped, any, drained;
  wire loading, ended, bad_word, partial, bad_size;
  wire [3*(W+1)-1:0] move; // {z, y, x}
  wire [31:0] pairs, candidates, collisions, out_of_range, warnings, cycles, first_a, first_b;
  wire [A:0]  count_a;
  wire [B:0]  count_b;
  wire [31:0] status = {
    21'd0, bad_size, partial, bad_word, 1'b0, loading, |count_b, |count_a, stopped,
    any && (|out_of_range), any, busy
  };
  reg  halt_q; // no verdict counts any more when it begins //@ fpga
  wire clear = rst || start || halt@after@;
  //@ if fpga

  always @(posedge clk) begin
    halt_q <= halt && busy;
  end
  //@ end

  sepax_registers registers (
    .clk(clk), .rst(rst), .awvalid(s_axi_awvalid), .awready(s_axi_awready), .awaddr(s_axi_awaddr),
    .wvalid(s_axi_wvalid), .wready(s_axi_wready), .wdata(s_axi_wdata), .wstrb(s_axi_wstrb),
    .bvalid(s_axi_bvalid), .bready(s_axi_bready), .bresp(s_axi_bresp), .arvalid(s_axi_arvalid),
    .arready(s_axi_arready), .araddr(s_axi_araddr), .rvalid(s_axi_rvalid), .rready(s_axi_rready),
    .rdata(s_axi_rdata), .rresp(s_axi_rresp), .irq(irq), .start(start), .starting(starting),
    .stop(stop), .first(first), .quiet(quiet), .move(move), .status(status), .done(done),
    .hit(hit), .loaded(ended), .count_a({{(31-A){1'b0}}, count_a}),
    .count_b({{(31-B){1'b0}}, count_b}), .pairs(pairs), .candidates(candidates),
    .collisions(collisions), .out_of_range(out_of_range), .warnings(warnings), .cycles(cycles),
    .first_a(first_a), .first_b(first_b)
  );

  sepax_load load_objects (
    .clk(clk), .rst(rst), .busy(busy || starting), .tvalid(s_axis_tvalid), .tready(s_axis_tready),
    .tdata(s_axis_tdata), .tlast(s_axis_tlast), .tdest(s_axis_tdest), .write_a(write_a),
    .write_b(write_b), .address(write_address), .triangle(write_triangle[9*W-1:0]),
    .thinnest(write_triangle[9*W +: 2]), //@ swaps
    .aabb(write_aabb),
    .count_a(count_a), .count_b(count_b), .loading(loading), .ended(ended), .bad_word(bad_word),
    .partial(partial), .bad_size(bad_size)
  );

  // Broad phase.
  wire running, is_b, load, is_a, lanes_busy, push, free, more, pop, candidate; //@ !fpga
  wire step, is_b, load, is_a, lanes_busy, push, free, more, pop, candidate; //@ fpga
  wire encoding, single, next_single; //@ staged
  wire offered, asked; //@ fpga
  wire [LANES-1:0] mask, next_mask;
  wire [B:0]   step_j; //@ !fpga
  wire [B-1:0] mask_j, next_j;
  wire [B-1:0] candidate_b; //@ fpga
  wire [A-1:0] candidate_a; //@ fpga
  wire [A-1:0] round_base, mask_base, next_base;
  wire [6:0]   tested;

  sepax_enumerator enumerator (
    .clk(clk), .rst(rst), .start(start), .halt(halt@after@), .free(free), .count_a(count_a),
    .count_b(count_b), .running(running), .step(step), .j(step_j), .is_b(is_b), //@ !fpga
    .count_b(count_b), .running(running), .step(step), .is_b(is_b), //@ fpga
    .address_b(aabb_address_b), .round_base(round_base), .address_a(aabb_address_a), .load(load),
    .is_a(is_a)
  );

  sepax_comparators comparators (
    //@ if fpga
    .clk(clk), .clear(clear), .step(step), .j(aabb_address_b), .is_b(is_b), .base(round_base),
    .load(load),
    //@ else
    .clk(clk), .clear(clear), .step(step), .j(step_j), .is_b(is_b), .base(round_base), .load(load),
    //@ end
    .is_a(is_a), .aabb_a(read_aabb_a), .aabb_b(read_aabb_b), .move(move), .busy(lanes_busy),
    .push(push), .mask(mask), .mask_j(mask_j), .mask_base(mask_base), .tested(tested)
  );

  // Six masks may come after the enumerator has seen the FIFO full. //@ !fpga
  // Eight masks may come after the enumerator has seen the FIFO full. //@ fpga
  //@ if staged
  localparam [LANES-1:0] ONE = 1;
  assign single = !(|(mask & (mask - ONE)));

  sepax_fifo #(.WIDTH(1 + LANES + A + B), .ADDRESS(4), .MARGIN(@late@)) candidates_fifo (
    .clk(clk), .clear(clear), .push(push), .in({single, mask, mask_j, mask_base}), .free(free),
    .valid(more), .pop(pop), .out({next_single, next_mask, next_j, next_base})
  );
  //@ else
  sepax_fifo #(.WIDTH(LANES + A + B), .ADDRESS(4), .MARGIN(@late@)) candidates_fifo (
    .clk(clk), .clear(clear), .push(push), .in({mask, mask_j, mask_base}), .free(free),
    .valid(more), .pop(pop), .out({next_mask, next_j, next_base})
  );
  //@ end

  sepax_priority priority_encoder (
    .clk(clk), .clear(clear), .more(more), .pop(pop), .next_mask(next_mask), .next_j(next_j),
    //@ if staged
    .busy(encoding), .next_last(next_single),
    //@ end
    //@ if fpga
    .next_base(next_base), .valid(candidate), .take(asked), .a(candidate_a), .b(candidate_b)
  );

  // No path leads from the cores to the candidates.
  sepax_skid #(.WIDTH(A + B)) skid (
    .clk(clk), .rst(clear), .in_valid(candidate), .in_ready(asked),
    .in({candidate_a, candidate_b}), .out_valid(offered), .out_ready(fetch),
    .out({fetch_a, fetch_b})
  );
  //@ else
    .next_base(next_base), .valid(candidate), .take(fetch), .a(fetch_a), .b(fetch_b)
  );
  //@ end

  // Narrow phase.
  wire fetch_busy, pair_valid, pair_ready, outside, in_flight;
  wire verdict_valid, verdict_ready, verdict_outside, collision, coplanar;
  wire exceeds; //@ extents
  wire warning; //@ limits
  wire [9*W-1:0] pair_a, pair_b;
  wire [A-1:0]   number_a, verdict_a;
  wire [B-1:0]   number_b, verdict_b;

  sepax_fetch fetch_pair (
    .clk(clk), .clear(clear), .valid(candidate), .a(fetch_a), .b(fetch_b), .read(fetch), //@ !fpga
    .clk(clk), .clear(clear), .valid(offered), .a(fetch_a), .b(fetch_b), .read(fetch), //@ fpga
    .thinnest(read_triangle_a[9*W +: 2]), //@ swaps
    .read_a(read_triangle_a[9*W-1:0]), .read_b(read_triangle_b), .move(move), .busy(fetch_busy),
    .out_valid(pair_valid), .out_ready(pair_ready), .out_a(pair_a), .out_b(pair_b),
    .out_outside(outside), .number_a(number_a), .number_b(number_b)
  );

  sepax_cores cores (
    .clk(clk), .rst(rst), .pair_valid(pair_valid), .pair_ready(pair_ready), .pair_a(pair_a),
    .pair_b(pair_b), .pair_info({outside, number_b, number_a}), .in_flight(in_flight),
    .exceeds(exceeds), //@ extents
    .warning(warning), //@ limits
    .collision(collision), .coplanar(coplanar), .verdict_valid(verdict_valid),
    .verdict_ready(verdict_ready), .verdict_info({verdict_outside, verdict_b, verdict_a})
  );

  //@ if staged
  assign drained = !running && !lanes_busy && !more && !encoding && !offered && !fetch_busy &&
                   !in_flight;
  //@ else
  //@ if fpga
  assign drained = !running && !lanes_busy && !more && !offered && !fetch_busy && !in_flight;
  //@ else
  assign drained = !running && !lanes_busy && !more && !candidate && !fetch_busy && !in_flight;
  //@ end
  //@ end

  sepax_results results (
    .clk(clk), .rst(rst), .start(start), .stop(stop), .first(first), .quiet(quiet),
    .tested(tested), .launched(pair_valid && pair_ready), .drained(drained),
    .valid(verdict_valid), .ready(verdict_ready), .collision(collision), .coplanar(coplanar),
    .exceeds(exceeds), //@ extents
    .warning(warning), //@ limits
    .outside(verdict_outside), .a(verdict_a), .b(verdict_b), .tvalid(m_axis_tvalid),
    .tready(m_axis_tready), .tdata(m_axis_tdata), .tlast(m_axis_tlast), .halt(halt), .done(done),
    .hit(hit), .busy(busy), .stopped(stopped), .any(any), .pairs(pairs), .candidates(candidates),
    .collisions(collisions), .out_of_range(out_of_range), .warnings(warnings), .cycles(cycles),
    .first_a(first_a), .first_b(first_b)
  );
endmodule
