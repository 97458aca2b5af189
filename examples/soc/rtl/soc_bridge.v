// SPDX-License-Identifier: MIT
// soc_bridge.v
//
// From the bus of a small CPU to the buses of the object engine, words of 32 bits only:
//   00 ... 7c  the engine's registers (sepax_registers.h), over AXI4-Lite
//   80 84 88   write: x, y, z of a vertex
//   8c         write: send it; bit 0: the last of its object, bit 1: of object B
//   90         read: bit 0: a result is here, bit 1: it is the last of a run, bit 2: the access
//              before this one was refused
//   94 98      read: the lowest, the highest 32 bits of the result; 98 takes it
// An access waits until the engine has answered or taken it. Refused is what the engine answers
// with SLVERR, part of a word, another address, and 98 without a result.

`default_nettype none

module soc_bridge (
  input  wire        clk,      // clock
  input  wire        rst,      // synchronous reset, active high
  input  wire        valid,    // an access is here, until it is ready
  output reg         ready,    // it is done in this cycle
  input  wire [5:0]  word,     // address / 4
  input  wire [3:0]  strobes,  // bytes to write; 0: read
  input  wire [31:0] wdata,    // data to write
  output reg  [31:0] rdata,    // data that were read
  output reg         awvalid,  // AXI4-Lite of the engine
  input  wire        awready,
  output reg         wvalid,
  input  wire        wready,
  input  wire        bvalid,
  input  wire [1:0]  bresp,
  output reg         arvalid,
  input  wire        arready,
  input  wire        rvalid,
  input  wire [31:0] rdata_in,
  input  wire [1:0]  rresp,
  output reg         vertex_valid, // AXI4-Stream of the engine, vertices
  input  wire        vertex_ready,
  output reg  [95:0] vertex,       // {z, y, x}
  output reg         vertex_last,
  output reg         vertex_to_b,
  input  wire        result_valid, // AXI4-Stream of the engine, results
  output wire        result_ready,
  input  wire [63:0] result,
  input  wire        result_last
);
  reg         busy_q;    // an access to the engine goes on
  reg         refused_q; // the last access was refused
  wire        begins = valid && !busy_q && !ready;
  wire        writes = |strobes;
  wire        whole = (&strobes) || !writes;
  wire        is_register = !word[5];
  wire        is_state = word == 6'h24;
  wire        is_high = word == 6'h26;
  wire        sends = begins && writes && whole && (word == 6'h23);

  assign result_ready = begins && !writes && is_high;

  always @(posedge clk) begin
    ready <= 1'b0;
    if (rst) begin
      {busy_q, refused_q, awvalid, wvalid, arvalid, vertex_valid} <= 6'd0;
    end else begin
      awvalid <= awvalid && !awready;
      wvalid <= wvalid && !wready;
      arvalid <= arvalid && !arready;
      vertex_valid <= vertex_valid && !vertex_ready;
      if (begins && is_register) begin
        busy_q <= 1'b1;
        {awvalid, wvalid} <= {2{writes}};
        arvalid <= !writes;
      end else if (sends) begin
        busy_q <= 1'b1;
        vertex_valid <= 1'b1;
      end else if (begins) begin
        ready <= 1'b1;
        refused_q <= !whole || (writes ? (word < 6'h20) || (word > 6'h23) :
                     !is_state && (word != 6'h25) && !(is_high && result_valid));
      end
      if (bvalid || rvalid || (vertex_valid && vertex_ready)) begin
        busy_q <= 1'b0;
        ready <= 1'b1;
        refused_q <= (bvalid && (|bresp)) || (rvalid && (|rresp));
      end
    end
    if (begins) begin
      rdata <= is_state ? {29'd0, refused_q, result_last && result_valid, result_valid} :
               is_high ? result[63:32] : result[31:0];
    end else if (rvalid) begin
      rdata <= rdata_in;
    end
    if (begins && writes && whole) begin
      case (word)
        6'h20: vertex[31:0] <= wdata;
        6'h21: vertex[63:32] <= wdata;
        6'h22: vertex[95:64] <= wdata;
        6'h23: {vertex_to_b, vertex_last} <= wdata[1:0];
        default: ;
      endcase
    end
  end
endmodule

`default_nettype wire
