// SPDX-License-Identifier: MIT
// Memory with one port to write and one to read, which keeps what it read last. Its contents are
// not reset. Latency 1.
module sepax_ram #(
  parameter WIDTH = 8,  // bits of a word
  parameter DISTRIBUTED = 0, // of tables, whose output is a register //@ distributed
  parameter ADDRESS = 7 // bits of an address
) (
  input  wire               clk,           // clock
  input  wire               write,         // write a word
  input  wire [ADDRESS-1:0] write_address, // where
  input  wire [WIDTH-1:0]   write_data,    // the word
  input  wire               read,          // read a word
  input  wire [ADDRESS-1:0] read_address,  // where
  output reg  [WIDTH-1:0]   read_data      // the word, from the next cycle on
);
  // No word is read while it is written. //@ fpga
  (* no_rw_check *) //@ fpga
//@ if !distributed
  reg [WIDTH-1:0] word_q [0:(1<<ADDRESS)-1];

  always @(posedge clk) begin
    if (write) begin
      word_q[write_address] <= write_data;
    end
    if (read) begin
      read_data <= word_q[read_address];
    end
  end
//@ else
  generate
    if (DISTRIBUTED != 0) begin : tables
      // No word is read while it is written.
      (* no_rw_check *)
      (* ram_style = "distributed" *)
      reg [WIDTH-1:0] word_q [0:(1<<ADDRESS)-1];
      always @(posedge clk) begin
        if (write) begin
          word_q[write_address] <= write_data;
        end
        if (read) begin
          read_data <= word_q[read_address];
        end
      end
    end else begin : block
      (* no_rw_check *)
      reg [WIDTH-1:0] word_q [0:(1<<ADDRESS)-1];
      always @(posedge clk) begin
        if (write) begin
          word_q[write_address] <= write_data;
        end
        if (read) begin
          read_data <= word_q[read_address];
        end
      end
    end
  endgenerate
//@ end
endmodule
