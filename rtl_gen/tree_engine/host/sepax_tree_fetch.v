// SPDX-License-Identifier: MIT
// Reads a job or a pose into a memory of 16 beats, through the AXI4 read port that it shares with
// the engine. A burst is asked for only while the engine has no open burst. Its address goes out
// before those of the engine, and answers come in order, so its beats are the next ones.
module sepax_tree_fetch #(
  parameter ADDRESS = 40 // bits of a byte address
) (
  input  wire               clk,            // clock
  input  wire               rst,            // synchronous reset, active high
  input  wire               ask,            // ask for a burst; only while not busy
  input  wire [ADDRESS-1:0] ask_address,    // address of the burst, a multiple of 128
  input  wire [3:0]         ask_beats,      // beats of the burst less 1; it does not cross 4 KB
  output wire               busy,           // the burst has not come completely //@ !fpga
  output reg                busy,           // it has not come whole, until a cycle later //@ fpga
  output reg                error,          // a beat of the burst came with an error
  input  wire               read,           // read a beat of the burst
  input  wire [3:0]         read_beat,      // number of the beat
  output wire [127:0]       read_data,      // the beat, from the next cycle on
  input  wire               engine_arvalid, // AXI4 read port of the engine: an address
  output wire               engine_arready, // it is taken in this cycle
  input  wire [ADDRESS-1:0] engine_araddr,  // byte address
  input  wire [7:0]         engine_arlen,   // beats less 1
  output wire               engine_rvalid,  // a beat
  input  wire               engine_rready,  // it is taken in this cycle
  output wire               arvalid,        // AXI4 read port: an address
  input  wire               arready,        // it is taken in this cycle
  output wire [ADDRESS-1:0] araddr,         // byte address
  output wire [7:0]         arlen,          // beats less 1
  input  wire               rvalid,         // a beat
  output wire               rready,         // it is taken in this cycle
  input  wire [127:0]       rdata,          // its data
  input  wire [1:0]         rresp,          // 0: OKAY; otherwise an error
  input  wire               rlast           // the last beat of its burst
);
  reg                asked_q, coming_q; // the address waits; beats are expected
  reg  [ADDRESS-1:0] address_q;
  reg  [3:0]         last_q, beat_q;    // number of the last beat, of the next beat
  wire               take = coming_q && rvalid;
  wire               last = (beat_q == last_q);

  assign busy = asked_q || coming_q; //@ !fpga
  assign arvalid = asked_q || engine_arvalid;
  assign araddr = asked_q ? address_q : engine_araddr;
  assign arlen = asked_q ? {4'd0, last_q} : engine_arlen;
  assign engine_arready = arready && !asked_q;
  assign rready = coming_q || engine_rready;
  assign engine_rvalid = rvalid && !coming_q;

  sepax_ram #(.WIDTH(128), .ADDRESS(4)) beats (
    .clk(clk), .write(take), .write_address(beat_q), .write_data(rdata), .read(read),
    .read_address(read_beat), .read_data(read_data)
  );

  always @(posedge clk) begin
    if (rst) begin
      {asked_q, coming_q} <= 2'd0;
      busy <= 1'b0; //@ fpga
    end else begin
      busy <= ask || asked_q || coming_q; //@ fpga
      asked_q <= ask || (asked_q && !arready);
      coming_q <= ask || (coming_q && !(take && last));
    end
    if (ask) begin
      address_q <= ask_address;
      last_q <= ask_beats;
      {error, beat_q} <= 5'd0;
    end else if (take) begin
      error <= error || (|rresp) || (rlast != last);
      beat_q <= beat_q + 4'd1;
    end
  end
endmodule
