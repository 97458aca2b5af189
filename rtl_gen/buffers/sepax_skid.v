// SPDX-License-Identifier: MIT
// Skid buffer: in_ready is a register, so that no path leads from out_ready, in_valid or data to
// it. A word passes at once while the buffer is empty; one that is not taken waits in it.
// Latency 0.
module sepax_skid #(
  parameter WIDTH = 8 // bits of a word
) (
  input  wire             clk,       // clock
  input  wire             rst,       // synchronous reset, active high
  input  wire             in_valid,  // a word is here
  output reg              in_ready,  // it is taken in this cycle
  input  wire [WIDTH-1:0] in,        // the word
  output wire             out_valid, // a word is here
  input  wire             out_ready, // it is taken in this cycle
  output wire [WIDTH-1:0] out        // the word
);
  reg [WIDTH-1:0] word_q;

  assign out_valid = in_valid || !in_ready;
  assign out = in_ready ? in : word_q;

  always @(posedge clk) begin
    if (rst) begin
      in_ready <= 1'b1;
    end else begin
      in_ready <= out_ready || !out_valid;
    end
    if (in_valid && in_ready && !out_ready) begin
      word_q <= in;
    end
  end

`ifdef FORMAL
  // What is offered and not taken stays, on both sides; what was taken comes out.
  reg begun_q = 1'b0;
  always @(posedge clk) begin
    begun_q <= 1'b1;
    assume (begun_q || rst);
    if (begun_q && $past(begun_q && !rst && in_valid && !in_ready)) begin
      assume (in_valid && $stable(in));
    end
    if (begun_q && $past(begun_q && !rst && out_valid && !out_ready)) begin
      assert (out_valid && $stable(out));
    end
    if (begun_q && $past(begun_q && !rst && in_valid && in_ready && !out_ready)) begin
      assert (!in_ready && (out == $past(in)));
    end
    if (begun_q && $past(begun_q && rst)) begin
      assert (in_ready);
    end
  end
`endif
endmodule
