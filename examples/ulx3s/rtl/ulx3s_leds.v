// SPDX-License-Identifier: MIT
// ulx3s_leds.v
//
// What the eight LEDs show; short events are drawn out so that one can see them.
//   0 blinks: there is a clock    4 results wait to be fetched
//   1 bytes come                  5 a run has ended
//   2 an object is on its way     6 a run waited for the line, since HELLO
//   3 the last run found pairs    7 a request was refused, since HELLO

`default_nettype none

module ulx3s_leds #(
  parameter SLOW = 25 // 2^SLOW cycles: two blinks
) (
  input  wire        clk,          // clock
  input  wire        rst,          // synchronous reset, active high; HELLO, too
  input  wire        came,         // a byte comes
  input  wire        vertex,       // a vertex goes to the engine
  input  wire        vertex_last,  // with it: the last of its object
  input  wire        result,       // the engine has a result
  input  wire        result_taken, // the FIFO has an entry free for it
  input  wire        result_last,  // it is the end of a run
  input  wire        result_none,  // with that: it found nothing
  input  wire        waiting,      // results wait in the FIFO
  input  wire        refused,      // a request is refused
  output reg  [7:0]  led           // 1: on
);
  reg [SLOW-1:0] time_q;
  reg            came_q; // since time_q was a multiple of 2^(SLOW - 4)

  always @(posedge clk) begin
    time_q <= time_q + {{(SLOW-1){1'b0}}, 1'b1};
    if (!(|time_q[SLOW-5:0])) begin
      came_q <= came;
      led[1] <= came_q;
    end else begin
      came_q <= came_q || came;
    end
    led[0] <= time_q[SLOW-1];
    led[4] <= waiting;
    if (rst) begin
      {led[7:5], led[3:2]} <= 5'd0;
    end else begin
      if (vertex) begin
        led[2] <= !vertex_last;
      end
      if (result && result_taken && result_last) begin
        led[3] <= !result_none;
        led[5] <= 1'b1;
      end
      led[6] <= led[6] || (result && !result_taken);
      led[7] <= led[7] || refused;
    end
  end
endmodule

`default_nettype wire
