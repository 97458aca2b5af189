// SPDX-License-Identifier: MIT
// ulx3s_uart_out.v
//
// Transmitter of a serial line, 8 data bits, no parity, lowest bit first, one stop bit: 10 bits a
// byte, back to back.

`default_nettype none

module ulx3s_uart_out #(
  parameter CLOCKS = 33 // clock cycles a bit, 4 ... 65535
) (
  input  wire       clk,   // clock
  input  wire       rst,   // synchronous reset, active high
  input  wire       valid, // a byte is here
  output wire       ready, // it is taken in this cycle
  input  wire [7:0] data,  // the byte
  output wire       line   // the line, from a register; 1 when idle
);
  localparam BIT = CLOCKS - 1;
  reg [9:0]  shift_q; // what is left to send, lowest bit first, ones behind it
  reg [3:0]  left_q;  // bits that are left
  reg [15:0] wait_q;  // cycles to the next bit
  wire       next = wait_q == 16'd0;
  wire       idle = left_q == 4'd0;

  assign ready = idle || (next && (left_q == 4'd1));
  assign line = shift_q[0];

  always @(posedge clk) begin
    if (rst) begin
      shift_q <= 10'h3ff;
      left_q <= 4'd0;
    end else if (valid && ready) begin
      shift_q <= {1'b1, data, 1'b0};
      left_q <= 4'd10;
    end else if (next && !idle) begin
      shift_q <= {1'b1, shift_q[9:1]};
      left_q <= left_q - 4'd1;
    end
    wait_q <= (ready || next) ? BIT[15:0] : wait_q - 16'd1;
  end
endmodule

`default_nettype wire
