// SPDX-License-Identifier: MIT
// Reorder buffer: verdicts in the order of their pairs. A pair gets an entry when it is taken; its
// verdict is written there whenever it comes, and leaves when all before it have.
module sepax_reorder #(
  parameter NOTE = @note@,   // bits that come with a pair //@ note
  parameter TAG = @tag@,    // log2 of the entries
  parameter RESULT = @result@  // bits of a verdict
) (
  input  wire              clk,    // clock
  input  wire              rst,    // synchronous reset, active high
  output wire              free,   // an entry is free
  input  wire              take,   // a pair takes the next entry; only if one is free
  input  wire [NOTE-1:0]   note,   // what is known of this pair //@ note
  output reg  [TAG-1:0]    tail,   // the next entry
  input  wire              write,  // a verdict is here
  input  wire [TAG-1:0]    tag,    // entry of its pair
  input  wire [RESULT-1:0] result, // the verdict
  output wire              valid,  // the oldest pair has its verdict
  input  wire              ready,  // it may leave
  output reg  [NOTE-1:0]   oldest_note, // note of the oldest pair //@ note
  output reg  [RESULT-1:0] oldest  // verdict of the oldest pair
);
  localparam ENTRIES = 1 << TAG;
  localparam [TAG:0] ONE = 1;
  localparam [ENTRIES-1:0] FIRST = 1;
  reg  [ENTRIES-1:0]        head_q;   // the oldest entry, one-hot
  reg  [TAG:0]              count_q;  // entries taken
  reg  [ENTRIES-1:0]        done_q;   // entries that hold a verdict
  reg  [ENTRIES*RESULT-1:0] result_q; // verdicts
  reg  [ENTRIES*NOTE-1:0]   note_q; //@ note
  wire                      leave = valid && ready;
  integer                   i, k;

  assign free = !count_q[TAG];
  assign valid = |(head_q & done_q);

  always @(*) begin
    oldest = {RESULT{1'b0}};
    oldest_note = {NOTE{1'b0}}; //@ note
    for (i = 0; i < ENTRIES; i = i + 1) begin
      oldest = oldest | (result_q[i*RESULT +: RESULT] & {RESULT{head_q[i]}});
      oldest_note = oldest_note | (note_q[i*NOTE +: NOTE] & {NOTE{head_q[i]}}); //@ note
    end
  end

  always @(posedge clk) begin
    if (rst) begin
      head_q <= FIRST;
      tail <= {TAG{1'b0}};
      count_q <= {(TAG+1){1'b0}};
      done_q <= {ENTRIES{1'b0}};
    end else begin
      if (leave) begin
        head_q <= {head_q[ENTRIES-2:0], head_q[ENTRIES-1]};
      end
      if (take) begin
        tail <= tail + ONE[TAG-1:0];
      end
      if (take && !leave) begin
        count_q <= count_q + ONE;
      end
      if (leave && !take) begin
        count_q <= count_q - ONE;
      end
      for (k = 0; k < ENTRIES; k = k + 1) begin
        if (write && (tag == k[TAG-1:0])) begin
          done_q[k] <= 1'b1;
        end else if (leave && head_q[k]) begin
          done_q[k] <= 1'b0;
        end
      end
    end
    for (k = 0; k < ENTRIES; k = k + 1) begin
      if (write && (tag == k[TAG-1:0])) begin
        result_q[k*RESULT +: RESULT] <= result;
      end
      //@ if note
      if (take && (tail == k[TAG-1:0])) begin
        note_q[k*NOTE +: NOTE] <= note;
      end
      //@ end
    end
  end

`ifdef FORMAL
  // A verdict comes once, to an entry that was taken and has none; it stays until it may leave.
  reg               begun_q = 1'b0;
  reg [ENTRIES-1:0] open_q; // entries whose verdict is outstanding
  always @(posedge clk) begin
    begun_q <= 1'b1;
    assume (begun_q || rst);
    assume (!take || free);
    assume (!write || open_q[tag]);
    for (k = 0; k < ENTRIES; k = k + 1) begin
      open_q[k] <= !rst && ((take && (tail == k[TAG-1:0])) ||
                            (open_q[k] && !(write && (tag == k[TAG-1:0]))));
    end
    if (begun_q && !rst) begin
      assert (!(|(open_q & done_q)));
      assert (!(leave && !(|count_q)));
      assert (!(take && open_q[tail]) && !(take && done_q[tail]));
      assert (!(count_q[TAG] && (|count_q[TAG-1:0])));
    end
    if (begun_q && $past(begun_q && !rst && valid && !ready)) begin
      assert (valid && $stable(oldest));
    end
  end
`endif
endmodule
