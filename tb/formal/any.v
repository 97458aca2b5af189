// SPDX-License-Identifier: MIT
// any.v - modules whose data may be any: what holds with them holds with the real ones.
`default_nettype none

// A memory that forgets, but keeps what it read last.
module sepax_ram #(
    parameter WIDTH = 8, ADDRESS = 7
) (
    input wire clk, write, read,
    input wire [ADDRESS-1:0] write_address, read_address,
    input wire [WIDTH-1:0] write_data,
    output reg [WIDTH-1:0] read_data
);
  (* anyseq *) wire [WIDTH-1:0] any;
  always @(posedge clk) if (read) read_data <= any;
endmodule

module sepax_node_check (
    input wire clk,
    input wire [1:0] step,
    input wire [3:0] children, level, last_beat,
    input wire [31:0] first, record,
    input wire [22:0] number,
    input wire [23:0] nodes,
    input wire [31:0] triangles, beats,
    output wire bad
);
  (* anyseq *) wire any;
  assign bad = any;
endmodule

`default_nettype wire
