// SPDX-License-Identifier: MIT
// tree_properties.v - what the memory side of the tree engine keeps to, for yosys-smtbmc: every
// input is free in every cycle but for what its source must keep to, which is assumed.
`default_nettype none

// AXI4: an address stands until it is taken; bursts do not cross 4 KB if requests do not; not more
// than 2^OPEN are open; a beat is taken in the cycle in which it comes, but for the first of a
// burst that is to wait; beats have the tags and numbers of their requests, in order.
module read_properties (
    input wire clk, rst, in_valid, pause, arready, rvalid, rlast,
    input wire [8:0] in_address,
    input wire [3:0] in_beats,
    input wire [1:0] in_tag, rresp
);
  wire in_ready, out_valid, out_last, out_error, arvalid, rready, idle;
  wire [3:0] out_beat;
  wire [1:0] out_tag;
  wire [12:0] araddr;
  wire [7:0] arlen;
  sepax_axi_read #(.ADDRESS(13), .TAG(2), .OPEN(1)) dut (
      .clk(clk), .rst(rst), .in_valid(in_valid), .in_ready(in_ready), .in_address(in_address),
      .in_beats(in_beats), .in_tag(in_tag), .pause(pause), .out_valid(out_valid),
      .out_beat(out_beat), .out_last(out_last), .out_error(out_error), .out_tag(out_tag),
      .idle(idle),
      .arvalid(arvalid), .arready(arready), .araddr(araddr), .arlen(arlen), .rvalid(rvalid),
      .rready(rready), .rdata(128'd0), .rresp(rresp), .rlast(rlast));
  wire take = in_valid && in_ready;
  wire last = out_valid && out_last;
  wire [8:0] end_of_request = {1'b0, in_address[7:0]} + {5'd0, in_beats};
  wire [8:0] end_of_burst = {1'b0, araddr[11:4]} + {1'b0, arlen};
  (* anyconst *) wire [2:0] watched; // a request
  reg [2:0] taken = 3'd0, done = 3'd0; // requests, bursts that came
  reg [2:0] own_taken = 3'd0, own_done = 3'd0; // of them not the host's: of tags without bit 0
  reg [2:0] sent = 3'd0, come = 3'd0;  // addresses, bursts on the bus
  reg wrong;                           // the beat before was not OKAY, or its RLAST not right
  reg [3:0] beat = 4'd0;               // of the burst that comes, as the memory counts
  reg [1:0] tag;
  reg [3:0] beats;
  reg [3:0] length [0:7];
  reg waits [0:7];
  wire open = sent != come;
  wire bus_last = beat == length[come];
  reg begun = 1'b0;
  always @(posedge clk) begin
    begun <= 1'b1;
    assume (begun || rst);
    assume (!begun || !rst);
    assume (!end_of_request[8]);
    assume (taken != 3'd7);
    assume (!rvalid || open);
    if (begun && take) begin
      length[taken] <= in_beats;
      waits[taken] <= in_tag[1];
      taken <= taken + 3'd1;
      if (!in_tag[0]) own_taken <= own_taken + 3'd1;
      if (taken == watched) begin
        tag <= in_tag;
        beats <= in_beats;
      end
    end
    if (begun && arvalid && arready) sent <= sent + 3'd1;
    if (begun && rvalid && rready) begin
      beat <= bus_last ? 4'd0 : beat + 4'd1;
      if (bus_last) come <= come + 3'd1;
    end
    if (begun && last) done <= done + 3'd1;
    if (begun && last && !out_tag[0]) own_done <= own_done + 3'd1;
    wrong <= rresp != 2'd0 || rlast != bus_last;
    if (begun) begin
      if ($past(begun && arvalid && !arready)) begin
        assert (arvalid);
        assert (araddr == $past(araddr));
        assert (arlen == $past(arlen));
      end
      if (arvalid) assert (!end_of_burst[8] && arlen < 8'd16 && araddr[3:0] == 4'd0);
      assert (taken - come <= 3'd2);
      if (rvalid && !(pause && waits[come] && beat == 4'd0)) assert (rready);
      if (rvalid && pause && waits[come] && beat == 4'd0) assert (!rready);
      if (out_valid && done == watched) begin
        assert (out_tag == tag && out_last == (out_beat == beats));
      end
      if (out_valid) assert (out_error == wrong);
      assert (idle == (own_taken == own_done));
    end
  end
endmodule

// A FIFO in a memory: words in order, none lost, none from nowhere, at out in time.
module fifo_properties (
    input wire clk, clear, push, pop,
    input wire [1:0] in
);
  wire valid;
  wire [1:0] out;
`ifdef QUICK
  localparam QUICK = 1;
`else
  localparam QUICK = 0;
`endif
  sepax_ram_fifo #(.WIDTH(2), .QUICK(QUICK), .ADDRESS(2)) dut (
      .clk(clk), .clear(clear), .push(push), .in(in), .valid(valid), .pop(pop), .out(out));
  reg [2:0] count = 3'd0;  // words
  reg [2:0] ahead;         // of the watched word
  reg watch = 1'b0;
  reg [1:0] word;
  reg begun = 1'b0;
  (* anyseq *) wire choose;
  always @(posedge clk) begin
    begun <= 1'b1;
    assume (begun || clear);
    assume (!push || count < 3'd4);
    assume (!pop || valid);
    if (clear) begin
      count <= 3'd0;
      watch <= 1'b0;
    end else begin
      count <= count + {2'd0, push} - {2'd0, pop};
      if (!watch && choose && push) begin
        watch <= 1'b1;
        word <= in;
        ahead <= count - {2'd0, pop};
      end else if (watch && pop) begin
        ahead <= ahead - 3'd1;
        if (ahead == 3'd0) watch <= 1'b0;
      end
    end
    if (begun && !clear) begin
      if (valid) assert (count != 3'd0);
      if (watch && ahead == 3'd0 && valid) assert (out == word);
      if ($past(begun && !clear && count != 3'd0 && !pop) && count != 3'd0) assert (valid);
      if (QUICK != 0 && $past(begun && !clear)) assert (valid == (count != 3'd0));
    end
  end
endmodule

// Tags: the slot of a request that is not released is given to no other block (with PINS: requests
// follow each other and are of one set); a block that is here and was not given up is found where
// it was, without being asked for again.
module tags_properties (
    input wire clk, rst, forget, drop, valid, release_one, accept, miss_ready,
    input wire [3:0] address
);
  wire found, miss_valid;
  wire [2:0] slot;
  reg [3:0] number = 4'd0, used = 4'd0;
  wire next = found && accept && used < 4'd4;
  sepax_tags #(.ADDRESS(4), .SETS(1), .NUMBER(4)) dut (
      .clk(clk), .rst(rst), .forget(forget), .drop(drop), .valid(valid), .address(address),
      .number(number), .used(used), .found(found), .slot(slot), .next(next),
      .miss_valid(miss_valid), .miss_ready(miss_ready));
  wire take = miss_valid && miss_ready;
  reg begun = 1'b0;
  always @(posedge clk) begin
    begun <= 1'b1;
    assume (begun == !rst);
    assume (!release_one || used != 4'd0);
    if (begun) begin
      // What a request's source keeps to.
      if ($past(begun && valid && !next && !drop)) assume (valid && $stable(address));
      if (found || miss_valid) assume (valid);
      assume (!forget || drop);
      if (drop) assume (!accept);
      used <= drop ? 4'd0 : used + {3'd0, next} - {3'd0, release_one};
      number <= number + {3'd0, next};
    end
  end
`ifdef PINS
  (* anyconst *) wire [3:0] watched; // a request
  reg pins = 1'b0;                   // it is in
  reg [2:0] pinned;                  // its slot
  reg [3:0] before;                  // releases until its own
  always @(posedge clk) begin
    assume (!drop && !forget && valid && accept && miss_ready && address[0] == address[1]);
    if (begun) begin
      if (next && number == watched) begin
        pins <= 1'b1;
        pinned <= slot;
        before <= used - {3'd0, release_one};
      end else if (pins && release_one) begin
        before <= before - 4'd1;
        if (before == 4'd0) pins <= 1'b0;
      end
      if (pins && take) assert (slot != pinned);
    end
  end
`else
  (* anyconst *) wire [3:0] block;
  reg here = 1'b0; // that block is in place
  reg [2:0] place;
  always @(posedge clk) begin
    if (begun) begin
      if (forget) here <= 1'b0;
      else if (take && address == block) begin
        here <= 1'b1;
        place <= slot;
      end else if (take && slot == place) here <= 1'b0;
      if (here && miss_valid) assert (address != block);
      if (here && found && address == block) assert (slot == place);
      if (found && !take && address == block) assert (here);
    end
  end
`endif
endmodule

// Pairs: one comes out when its blocks have come; if one of them came with an error, it says so;
// not more than 2^WINDOW are in.
module cache_properties (
    input wire clk, rst, in_valid, out_ready, done, miss_ready, filled, filled_is_b, filled_error,
    input wire [3:0] in_a, in_b
);
  wire in_ready, out_valid, out_error, miss_valid, miss_is_b;
  wire [2:0] in_number;
  wire [2:0] out_number;
  reg [2:0] given = 3'd0, taken = 3'd0, released = 3'd0; // pairs
`ifdef QUICK
  localparam QUICK = 1;
`else
  localparam QUICK = 0;
`endif
  sepax_cache #(.ADDRESS(4), .INFO(3), .QUICK(QUICK), .SETS(1), .WINDOW(1)) dut (
      .clk(clk), .rst(rst), .start(1'b0), .cold(1'b0), .drop(1'b0), .in_valid(in_valid),
      .in_ready(in_ready), .in_a(in_a), .in_b(in_b), .in_info(given), .out_valid(out_valid),
      .out_ready(out_ready), .out_info(out_number), .out_error(out_error), .done(done),
      .miss_valid(miss_valid), .miss_ready(miss_ready), .miss_is_b(miss_is_b), .filled(filled),
      .filled_is_b(filled_is_b), .filled_error(filled_error));
  (* anyconst *) wire [2:0] watched; // a pair
  (* anyconst *) wire side;          // its block of B, or of A
  reg [3:0] ahead = 4'd0;            // blocks of the side that were asked for and have not come
  reg asked = 1'b0, failed = 1'b0;   // the watched pair's block is asked for; came with an error
  reg come = 1'b0;
  reg [3:0] left;                    // blocks until its own
  reg broken = 1'b0;                 // a block of the side has come with an error
  reg [2:0] since;                   // number of the first pair that is looked up after it
  wire ask = miss_valid && miss_ready && miss_is_b == side;
  wire fill = filled && filled_is_b == side;
  reg begun = 1'b0;
  always @(posedge clk) begin
    begun <= 1'b1;
    assume (begun == !rst);
    if (begun) begin
      if ($past(begun && in_valid && !in_ready)) begin
        assume (in_valid && $stable(in_a) && $stable(in_b));
      end
      if (in_ready || miss_valid) assume (in_valid);
      assume (!fill || ahead != 4'd0);
      assume (!done || taken != released);
      assume (given != 3'd7);
      ahead <= ahead + {3'd0, ask} - {3'd0, fill};
      if (in_ready) given <= given + 3'd1;
      if (out_valid && out_ready) taken <= taken + 3'd1;
      if (done) released <= released + 3'd1;
      if (ask && given == watched) begin
        asked <= 1'b1;
        left <= ahead - {3'd0, fill};
      end else if (fill && asked && !come) begin
        left <= left - 4'd1;
        if (left == 4'd0) begin
          come <= 1'b1;
          failed <= filled_error;
        end
      end
      if (fill && filled_error && !broken) begin
        broken <= 1'b1;
        since <= given;
      end
      assert (given - released <= 3'd2);
      if (out_valid) begin
        if (broken && taken >= since) assert (out_error);
        assert (taken != given);
        assert (out_number == taken);
        if (taken == watched && asked && !out_error) assert (come && !failed);
      end
    end
  end
endmodule

// Records of leaves: not more than two are here, whatever the numbers of their vertices are.
module fill_properties (
    input wire clk, rst, fill, fill_last, fill_error,
    input wire [3:0] fill_beat,
    input wire fill_tag
);
  wire busy, idle, done;
  sepax_leaf_fill #(.W(4), .TAG(1)) dut (
      .clk(clk), .rst(rst), .fill(fill), .fill_numbers(120'd0), .fill_even(12'd0),
      .fill_odd(12'd0), .fill_beat(fill_beat), .fill_last(fill_last), .fill_error(fill_error),
      .fill_tag(fill_tag), .busy(busy), .idle(idle), .done(done));
  reg [3:0] expected = 4'd0; // the beat that comes next
  reg [1:0] here = 2'd0;     // records
  wire first = fill && fill_beat == 4'd0;
  reg begun = 1'b0;
  always @(posedge clk) begin
    begun <= 1'b1;
    assume (begun == !rst);
    if (begun) begin
      assume (!fill || fill_beat == expected);
      assume (!(&fill_beat) || fill_last);
      if (first) assume (!$past(busy));
      if (fill) expected <= fill_last ? 4'd0 : fill_beat + 4'd1;
      here <= here + {1'b0, first} - {1'b0, done};
      assert (here != 2'd3);
      if (idle) assert (here == 2'd0);
    end
  end
endmodule

`default_nettype wire
