// SPDX-License-Identifier: MIT
// Queue of verdicts. A pair that is taken gets an entry, so that its verdict has room whenever it
// comes; verdicts come in the order of the pairs.
module sepax_queue #(
  parameter TAG = @tag@,   // log2 of the entries
  parameter RESULT = 5 // bits of a verdict
) (
  input  wire              clk,    // clock
  input  wire              rst,    // synchronous reset, active high
  output wire              free,   // an entry is free
  input  wire              take,   // a pair is taken; only if an entry is free
  input  wire              write,  // the verdict of the oldest pair without one is here
  input  wire [RESULT-1:0] result, // the verdict
  output wire              valid,  // the oldest pair has its verdict
  input  wire              ready,  // it may leave
  output reg  [RESULT-1:0] oldest  // its verdict
);
  localparam [TAG:0] ONE = 1;
  reg  [TAG:0]      taken_q, tail_q, head_q; // pairs taken, verdicts written, verdicts left
  reg  [(RESULT<<TAG)-1:0] result_q;
  integer i, k;

  assign free = taken_q != {!head_q[TAG], head_q[TAG-1:0]};
  assign valid = tail_q != head_q;

  always @(*) begin
    oldest = {RESULT{1'b0}};
    for (i = 0; i < (1 << TAG); i = i + 1) begin
      if (head_q[TAG-1:0] == i[TAG-1:0]) begin
        oldest = result_q[i*RESULT +: RESULT];
      end
    end
  end

  always @(posedge clk) begin
    if (rst) begin
      taken_q <= {(TAG+1){1'b0}};
      tail_q <= {(TAG+1){1'b0}};
      head_q <= {(TAG+1){1'b0}};
    end else begin
      if (take) begin
        taken_q <= taken_q + ONE;
      end
      if (write) begin
        tail_q <= tail_q + ONE;
      end
      if (valid && ready) begin
        head_q <= head_q + ONE;
      end
    end
    for (k = 0; k < (1 << TAG); k = k + 1) begin
      if (write && (tail_q[TAG-1:0] == k[TAG-1:0])) begin
        result_q[k*RESULT +: RESULT] <= result;
      end
    end
  end

`ifdef FORMAL
  // A verdict comes only for a pair that was taken; it stays until it may leave.
  reg  begun_q = 1'b0;
  wire [TAG:0] pairs = taken_q - head_q;
  wire [TAG:0] verdicts = tail_q - head_q;
  always @(posedge clk) begin
    begun_q <= 1'b1;
    assume (begun_q || rst);
    assume (!take || free);
    assume (!write || (tail_q != taken_q));
    if (begun_q && !rst) begin
      assert (pairs <= {1'b1, {TAG{1'b0}}});
      assert (verdicts <= pairs);
    end
    if (begun_q && $past(begun_q && !rst && valid && !ready)) begin
      assert (valid && $stable(oldest));
    end
  end
`endif
endmodule
