// SPDX-License-Identifier: MIT
// ulx3s_uart_in.v
//
// Receiver of a serial line, 8 data bits, no parity, lowest bit first: each bit is read in its
// middle. A byte whose stop bit is 0 is told as bad. Latency 9.5 bits and 3 cycles.

`default_nettype none

module ulx3s_uart_in #(
  parameter CLOCKS = 33 // clock cycles a bit, 4 ... 65535
) (
  input  wire       clk,   // clock
  input  wire       rst,   // synchronous reset, active high
  input  wire       line,  // the line, not synchronous; 1 when idle
  output reg        valid, // a byte is here, for one cycle
  output reg        bad,   // with it: the stop bit was 0
  output reg  [7:0] data   // the byte
);
  localparam BIT = CLOCKS - 1;
  localparam HALF = CLOCKS / 2 - 1;
  reg        line_q, line_q2;
  reg        busy_q;
  reg [15:0] wait_q; // cycles to the next reading
  reg [3:0]  bit_q;  // 0: start bit, 1 ... 8: data, 9: stop bit
  wire       read = busy_q && (wait_q == 16'd0);

  always @(posedge clk) begin
    line_q <= line;
    line_q2 <= line_q;
    if (rst) begin
      busy_q <= 1'b0;
      valid <= 1'b0;
    end else begin
      valid <= read && (bit_q == 4'd9);
      if (!busy_q) begin
        busy_q <= !line_q2;
      end else if (read && ((bit_q == 4'd9) || ((bit_q == 4'd0) && line_q2))) begin
        busy_q <= 1'b0;
      end
    end
    wait_q <= !busy_q ? HALF[15:0] : (read ? BIT[15:0] : wait_q - 16'd1);
    bit_q <= !busy_q ? 4'd0 : bit_q + {3'd0, read};
    bad <= !line_q2;
    if (read && (bit_q != 4'd9)) begin
      data <= {line_q2, data[7:1]};
    end
  end
endmodule

`default_nettype wire
