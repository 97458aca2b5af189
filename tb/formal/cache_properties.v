// SPDX-License-Identifier: MIT
// cache_properties.v - a pair of blocks waits for the memory alone, or for pairs before it to be
// released; for Yosys' SAT solver, by induction. Two pairs may be in; tags are any.
`default_nettype none

// Where it has pairs of the cache: two words; else any data.
module sepax_ram #(
    parameter WIDTH = 8, ADDRESS = 7
) (
    input wire clk, write, read,
    input wire [ADDRESS-1:0] write_address, read_address,
    input wire [WIDTH-1:0] write_data,
    output reg [WIDTH-1:0] read_data
);
  (* anyseq *) wire [WIDTH-1:0] any;
  reg [WIDTH-1:0] word_0, word_1;
  wire is_pairs = WIDTH == 13;
  always @(posedge clk) begin
    if (write && !write_address[0]) word_0 <= write_data;
    if (write && write_address[0]) word_1 <= write_data;
    if (read) read_data <= !is_pairs ? any : read_address[0] ? word_1 : word_0;
  end
endmodule

module moving_properties (
    input wire clk, rst, in_valid, out_ready, done, miss_ready, filled, filled_is_b, filled_error,
    input wire [3:0] in_a, in_b
);
  wire in_ready, out_valid, miss_valid, miss_is_b;
`ifdef QUICK
  localparam QUICK = 1;
`else
  localparam QUICK = 0;
`endif
  sepax_cache #(.ADDRESS(4), .INFO(1), .QUICK(QUICK), .SETS(1), .WINDOW(1)) dut (
      .clk(clk), .rst(rst), .start(1'b0), .cold(1'b0), .drop(1'b0), .in_valid(in_valid),
      .in_ready(in_ready), .in_a(in_a), .in_b(in_b), .in_info(1'b0), .out_valid(out_valid),
      .out_ready(out_ready), .done(done), .miss_valid(miss_valid), .miss_ready(miss_ready),
      .miss_is_b(miss_is_b), .filled(filled), .filled_is_b(filled_is_b),
      .filled_error(filled_error));
  (* hierconn *) wire [3:0] \dut.used_q ;
  (* hierconn *) wire [2:0] \dut.asked_a_q , \dut.asked_b_q , \dut.filled_a_q , \dut.filled_b_q ;
  (* hierconn *) wire [1:0] \dut.pairs.head_q , \dut.pairs.tail_q ;
  (* hierconn *) wire \dut.error_a_q , \dut.error_b_q ;
  (* hierconn *) wire \dut.pairs.valid , \dut.pairs.read , \dut.is_here ;
  (* hierconn *) wire [12:0] \dut.pairs.words.word_0 , \dut.pairs.words.word_1 ;
  (* hierconn *) wire [12:0] \dut.pairs.out ;
  (* hierconn *) wire [1:0] \dut.waiting_q ;
  (* hierconn *) wire [1:0] \dut.tags_a.state_q , \dut.tags_b.state_q ;
  (* hierconn *) wire \dut.tags_a.forget_q , \dut.tags_b.forget_q ;
  (* hierconn *) wire [3:0] \dut.tags_a.pinned_q , \dut.tags_b.pinned_q ;
  localparam [1:0] READ = 2'd0, COMPARE = 2'd1, DECIDE = 2'd2, FOUND = 2'd3;
  wire [3:0] used = \dut.used_q ;
  wire shown = \dut.pairs.valid ;
  wire [1:0] behind = \dut.pairs.tail_q - \dut.pairs.head_q ;
  wire [1:0] waiting = behind + {1'b0, shown}; // pairs that were not taken
  wire take = out_valid && out_ready;
  wire moved_a, moved_b, still_a, still_b;
  side_properties a (
      .clk(clk), .rst(rst), .asked(\dut.asked_a_q ), .filled(\dut.filled_a_q ),
      .fill(filled && !filled_is_b), .ask(miss_valid && miss_ready && !miss_is_b), .take(in_ready),
      .shown(shown), .behind(behind), .first(\dut.pairs.head_q [0]),
      .out(\dut.pairs.out [5:3]), .word_0(\dut.pairs.words.word_0 [5:3]),
      .word_1(\dut.pairs.words.word_1 [5:3]), .state(\dut.tags_a.state_q ),
      .pinned(\dut.tags_a.pinned_q ), .used(used));
  side_properties b (
      .clk(clk), .rst(rst), .asked(\dut.asked_b_q ), .filled(\dut.filled_b_q ),
      .fill(filled && filled_is_b), .ask(miss_valid && miss_ready && miss_is_b), .take(in_ready),
      .shown(shown), .behind(behind), .first(\dut.pairs.head_q [0]),
      .out(\dut.pairs.out [2:0]), .word_0(\dut.pairs.words.word_0 [2:0]),
      .word_1(\dut.pairs.words.word_1 [2:0]), .state(\dut.tags_b.state_q ),
      .pinned(\dut.tags_b.pinned_q ), .used(used));
  wire open = \dut.asked_a_q != \dut.filled_a_q || \dut.asked_b_q != \dut.filled_b_q ;
  wire work = waiting != 2'd0 || (in_valid && held == 4'd0);
  wire free = !rst && miss_ready && (!open || filled) && (out_ready || !out_valid);
  // What can happen only so often before a pair goes in or out: tags are looked up once more only
  // if some pair was in when they were.
  wire moves = take || filled || in_ready || (miss_valid && miss_ready) || \dut.pairs.read ||
               (shown && \dut.is_here && !out_valid) || \dut.tags_a.forget_q ||
               \dut.tags_b.forget_q || (held == 4'd0 && in_valid && (
               \dut.tags_a.state_q == READ || \dut.tags_b.state_q == READ ||
               \dut.tags_a.state_q == COMPARE || \dut.tags_b.state_q == COMPARE || before));
  reg before = 1'b0; // pairs were in a cycle before
  reg begun = 1'b0;
  reg asking = 1'b0; // a pair is being looked up
  reg [3:0] held = 4'd0; // pairs that were taken and not released
  always @(posedge clk) begin
    begun <= 1'b1;
    before <= used != 4'd0;
    asking <= !rst && in_valid && !in_ready;
    held <= rst ? 4'd0 : held + {3'd0, take} - {3'd0, done};
  end
  always @* begin
    assume (begun == !rst);
    assume (!asking || in_valid);
    assume (!filled_error); // an error ends the run
    assume (!done || held != 4'd0);
    if (begun) begin
      assert (used == held + {2'd0, waiting} && held <= 4'd2 && used <= 4'd2 && behind <= 2'd2);
      assert (\dut.waiting_q == waiting);
      assert (!out_valid || (shown && \dut.is_here ));
      assert (!\dut.error_a_q && !\dut.error_b_q );
      assert (asking || (\dut.tags_a.state_q == READ && \dut.tags_b.state_q == READ));
      if (work && free) assert (moves);
    end
  end
endmodule

// Counts of the blocks of a body: in order of the pairs each waits for at most one more.
module side_properties (
    input wire clk, rst, fill, ask, take, shown, first,
    input wire [2:0] asked, filled, out, word_0, word_1,
    input wire [1:0] behind, state,
    input wire [3:0] pinned, used
);
  wire [2:0] next = first ? word_1 : word_0, last = first ? word_0 : word_1;
  wire [2:0] oldest = shown ? out : behind != 2'd0 ? next : asked - {2'd0, now};
  wire [2:0] newest = behind == 2'd2 ? last : behind == 2'd1 ? next : out;
  reg now = 1'b0;    // the pair that is looked up has asked for its block
  reg before = 1'b0; // pairs were in a cycle before
  reg begun = 1'b0;
  always @(posedge clk) begin
    begun <= 1'b1;
    before <= used != 4'd0;
    now <= !rst && (now || ask) && !take;
  end
  always @* begin
    assume (!fill || asked != filled);
    if (begun) begin
      assert (!now || state == 2'd3);
      if (behind == 2'd2) assert (last - next <= 3'd1);
      if (shown && behind != 2'd0) assert (next - out <= 3'd1);
      if (shown || behind != 2'd0) assert (asked - newest == {2'd0, now});
      // Not more than the oldest's own is to come before it is here.
      assert (asked - filled <= (asked - oldest) + 3'd1);
      assert (asked - oldest <= 3'd3);
      if (!shown && behind == 2'd0) assert (asked - filled <= {2'd0, now});
      if (state == 2'd2 && (&pinned)) assert (before);
    end
  end
endmodule

`default_nettype wire
