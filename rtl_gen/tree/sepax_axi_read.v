// AXI4 read master: bursts of 1 to 16 beats of 16 bytes, one ID, up to 2^OPEN of them open. A
// burst's place in the list of open bursts is there before its address goes out. Data go on one
// cycle after they came and cannot be stopped; only a burst whose tag has its highest bit set
// waits, before its first beat, while `pause` is 1.
module sepax_axi_read #(
  parameter ADDRESS = 40, // bits of a byte address
  parameter TAG = 8,      // bits of a tag
  parameter OPEN = 4      // log2 of the open bursts, 2 or more
) (
  input  wire           clk,        // clock
  input  wire           rst,        // synchronous reset, active high
  input  wire           in_valid,   // a burst is wanted
  output wire           in_ready,   // it is taken
  input  wire [ADDRESS-5:0] in_address, // of its first beat, in units of 16 bytes
  input  wire [3:0]     in_beats,   // its beats less 1; it does not cross 4 KB
  input  wire [TAG-1:0] in_tag,     // comes back with its data
  input  wire           pause,      // see above
  output reg            out_valid,  // a beat
  output reg  [127:0]   out_data,   // its data
  output reg  [3:0]     out_beat,   // its number in the burst
  output reg            out_last,   // it is the burst's last
  output reg            out_error,  // not OKAY, or RLAST at the wrong beat
  output reg  [TAG-1:0] out_tag,    // the burst's tag
  output wire           idle,       // no burst is open
  output reg            arvalid,    // AXI4: an address
  input  wire           arready,    // it is taken
  output reg  [ADDRESS-1:0] araddr,     // byte address, a multiple of 16
  output reg  [7:0]     arlen,      // beats less 1
  input  wire           rvalid,     // AXI4: a beat
  output wire           rready,     // it is taken
  input  wire [127:0]   rdata,      // its data
  input  wire [1:0]     rresp,      // not 0: error
  input  wire           rlast       // the last of the burst
);
  wire           take = in_valid && in_ready;
  wire           free, open;
  wire [3:0]     beats;
  wire [TAG-1:0] tag;
  reg  [3:0]     beat_q; // the number of the beat that comes next
  wire           first = !(|beat_q);
  wire           last = (beat_q == beats);
  wire           beat = rvalid && rready;

  assign in_ready = free && (!arvalid || arready);
  assign rready = open && !(first && tag[TAG-1] && pause);
  assign idle = !open && !out_valid;

  sepax_ram_fifo #(.WIDTH(TAG+4), .ADDRESS(OPEN)) bursts (
    .clk(clk), .clear(rst), .push(take), .in({in_beats, in_tag}), .free(free), .valid(open),
    .pop(beat && last), .out({beats, tag})
  );

  always @(posedge clk) begin
    if (rst) begin
      arvalid <= 1'b0;
      out_valid <= 1'b0;
      beat_q <= 4'd0;
    end else begin
      arvalid <= take || (arvalid && !arready);
      out_valid <= beat;
      if (beat) begin
        beat_q <= last ? 4'd0 : beat_q + 4'd1;
      end
    end
    if (take) begin
      araddr <= {in_address, 4'd0};
      arlen <= {4'd0, in_beats};
    end
    if (beat) begin
      out_data <= rdata;
      out_beat <= beat_q;
      out_last <= last;
      out_error <= (|rresp) || (rlast != last);
      out_tag <= tag;
    end
  end
endmodule
