// SPDX-License-Identifier: MIT
// AXI4 read master: bursts of 1 to 16 beats of 16 bytes, one ID, up to 2^OPEN open bursts. A burst
// enters the list of open bursts before its address goes out. A beat goes out in the cycle after it
// came, and cannot be stopped. There is one exception: while `pause` is 1, the first beat of a
// burst whose tag has the highest bit set waits on the bus. Bursts whose tag has the second highest
// bit set are the host's: `idle` does not wait for them.
module sepax_axi_read #(
  parameter ADDRESS = 40, // bits of a byte address
  parameter TAG = 8,      // bits of a tag
  parameter OPEN = 4      // log2 of the most open bursts
) (
  input  wire               clk,        // clock
  input  wire               rst,        // synchronous reset, active high
  input  wire               in_valid,   // a burst is wanted
  output wire               in_ready,   // it is taken in this cycle
  input  wire [ADDRESS-5:0] in_address, // place of its first beat, in units of 16 bytes
  input  wire [3:0]         in_beats,   // its beats less 1; it does not cross 4 KB
  input  wire [TAG-1:0]     in_tag,     // tag that comes back with the data
  input  wire               pause,      // 1: see above
  output reg                out_valid,  // a beat
  output reg  [127:0]       out_data,   // its data
  output reg  [3:0]         out_beat,   // its number in the burst
  output reg                out_last,   // the beat is the last of its burst
  output reg                out_error,  // not OKAY, or RLAST at the wrong beat
  output reg  [TAG-1:0]     out_tag,    // the burst's tag
  output wire               idle,       // no burst is open but the host's
  output reg                arvalid,    // AXI4: an address
  input  wire               arready,    // it is taken in this cycle
  output wire [ADDRESS-1:0] araddr,     // byte address, a multiple of 16
  output wire [7:0]         arlen,      // beats less 1
  input  wire               rvalid,     // AXI4: a beat
  output wire               rready,     // it is taken in this cycle
  input  wire [127:0]       rdata,      // its data
  input  wire [1:0]         rresp,      // 0: OKAY; otherwise an error
  input  wire               rlast       // the last beat of its burst
);
  reg  [ADDRESS-5:0] address_q;
  reg  [3:0]         beats_q;
  reg  [OPEN:0]      open_q; // number of open bursts
  reg  [OPEN:0]      own_q;  // number of open bursts that are not the host's
  reg                gone_q; // the last beat of a burst came in the cycle before //@ fpga
  reg  [3:0]         beat_q; // number of the next beat in its burst
  wire               take = in_valid && in_ready;
  wire               known;
  wire [3:0]         beats;
  wire [TAG-1:0]     tag;
  wire               last = (beat_q == beats);
  wire               beat = rvalid && rready;
  wire               own_in = take && !in_tag[TAG-2];
  wire               own_out = beat && last && !tag[TAG-2];

  assign in_ready = !arvalid && !open_q[OPEN];
  assign rready = known && !(!(|beat_q) && tag[TAG-1] && pause);
  assign idle = !(|own_q) && !(out_valid && !out_tag[TAG-2]);
  assign araddr = {address_q, 4'd0};
  assign arlen = {4'd0, beats_q};

  sepax_ram_fifo #(.WIDTH(TAG+4), .ADDRESS(OPEN)) bursts (
    .clk(clk), .clear(rst), .push(take), .in({in_beats, in_tag}), .valid(known),
    .pop(beat && last), .out({beats, tag})
  );

  always @(posedge clk) begin
    if (rst) begin
      arvalid <= 1'b0;
      out_valid <= 1'b0;
      beat_q <= 4'd0;
      open_q <= {(OPEN+1){1'b0}};
      own_q <= {(OPEN+1){1'b0}};
      gone_q <= 1'b0; //@ fpga
    end else begin
      arvalid <= take || (arvalid && !arready);
      out_valid <= beat;
      if (beat) begin
        beat_q <= last ? 4'd0 : beat_q + 4'd1;
      end
      open_q <= open_q + {{OPEN{1'b0}}, take} - {{OPEN{1'b0}}, beat && last}; //@ !fpga
      open_q <= open_q + {{OPEN{1'b0}}, take} - {{OPEN{1'b0}}, gone_q}; //@ fpga
      own_q <= own_q + {{OPEN{1'b0}}, own_in} - {{OPEN{1'b0}}, own_out};
      gone_q <= beat && last; //@ fpga
    end
    if (take) begin
      address_q <= in_address;
      beats_q <= in_beats;
    end
    out_data <= rdata;
    out_beat <= beat_q;
    out_last <= last;
    out_error <= (|rresp) || (rlast != last);
    out_tag <= tag;
  end
endmodule
