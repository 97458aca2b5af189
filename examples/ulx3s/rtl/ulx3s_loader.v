// SPDX-License-Identifier: MIT
// ulx3s_loader.v
//
// Requests from the serial line to the buses of the engine, and replies; examples/ulx3s/README.md
// has the packets. A request is carried out when all of it is here and sound, in some 10 cycles; it
// gets one reply, and a reply is shorter than a request, so that none has to wait. What is cut
// short or damaged is refused with a reply, too, and changes nothing.

`default_nettype none

module ulx3s_loader #(
  parameter CLOCK_HZ = 100000000, // of the engine; HELLO tells it
  parameter IDLE = 22             // a packet is cut short after 2^IDLE cycles without a byte
) (
  input  wire         clk,            // clock
  input  wire         rst,            // synchronous reset, active high
  input  wire         in_valid,       // a byte came
  input  wire         in_bad,         // its stop bit was 0
  input  wire [7:0]   in,             // the byte
  output wire         out_valid,      // a byte is to be sent
  input  wire         out_ready,      // it is taken in this cycle
  output wire [7:0]   out,            // the byte
  output reg          hello,          // HELLO: reset the engine and the FIFO
  output reg          refused,        // a request is refused, for one cycle
  output reg          axi_awvalid,    // AXI4-Lite of the engine
  input  wire         axi_awready,
  output reg          axi_wvalid,
  input  wire         axi_wready,
  output wire [6:0]   axi_awaddr,
  output wire [31:0]  axi_wdata,
  input  wire         axi_bvalid,
  input  wire [1:0]   axi_bresp,
  output reg          axi_arvalid,
  input  wire         axi_arready,
  output wire [6:0]   axi_araddr,
  input  wire         axi_rvalid,
  input  wire [31:0]  axi_rdata,
  input  wire [1:0]   axi_rresp,
  output reg          vertex_valid,   // AXI4-Stream of the engine, vertices
  input  wire         vertex_ready,
  output wire [95:0]  vertex,         // {z, y, x}
  output wire         vertex_last,
  output wire         vertex_to_b,
  input  wire         result_valid,   // results, from the FIFO
  output reg          result_taken,
  input  wire [64:0]  result          // {TLAST, TDATA}
);
  localparam [7:0] HELLO = 8'd1, READ = 8'd2, WRITE = 8'd3, VERTEX = 8'd4, RECEIVE = 8'd8;
  localparam [7:0] DONE = 8'd0, LAST = 8'd1, NOT_NOW = 8'd2, ERROR = 8'd3, DAMAGED = 8'd4,
                   ORDER = 8'd5, UNKNOWN = 8'd6;
  localparam [31:0] NAME = 32'h756c7831; // "ulx1", this protocol
  localparam [31:0] CLOCK = CLOCK_HZ;

  // The request: what came of it, its CRC, and whether a byte of it was bad.
  reg  [3:0]    count_q;
  reg  [111:0]  request_q;
  reg  [15:0]   crc_q;
  reg           bad_q, complete_q, cut_q;
  reg  [IDLE:0] idle_q;
  wire [15:0]   next_crc;
  wire          cut = idle_q[IDLE] && !in_valid;
  wire [7:0]    operation = request_q[7:0];
  wire [7:0]    number = request_q[15:8];
  wire [31:0]   word_0 = request_q[47:16];

  // What is done with it, and the reply.
  reg           write_q, read_q, begin_q; // an access goes on; a reply begins
  reg  [7:0]    expected_q;               // number of the next request
  reg  [7:0]    code_q;
  reg  [63:0]   words_q;
  reg  [3:0]    left_q;                   // bytes of the reply that are left
  reg  [79:0]   reply_q;
  reg  [15:0]   reply_crc_q;
  wire [15:0]   next_reply_crc;
  wire          is_vertex = operation[7:2] == VERTEX[7:2];
  wire          sound = (crc_q == 16'd0) && !bad_q && !cut_q;
  wire          in_order = (number == expected_q) || (operation == HELLO);
  wire          sent = out_valid && out_ready;

  assign axi_awaddr = word_0[6:0];
  assign axi_araddr = word_0[6:0];
  assign axi_wdata = request_q[79:48];
  assign vertex = request_q[111:16];
  assign vertex_last = operation[0];
  assign vertex_to_b = operation[1];
  assign out_valid = |left_q;
  assign out = (left_q == 4'd2) ? reply_crc_q[15:8] :
               (left_q == 4'd1) ? reply_crc_q[7:0] : reply_q[7:0];

  ulx3s_crc crc_in (.crc(crc_q), .data(in), .next(next_crc));
  ulx3s_crc crc_out (.crc(reply_crc_q), .data(reply_q[7:0]), .next(next_reply_crc));

  // Packets.
  always @(posedge clk) begin
    complete_q <= !rst && ((in_valid && (&count_q)) || (cut && (|count_q)));
    cut_q <= cut;
    idle_q <= (in_valid || cut) ? {(IDLE+1){1'b0}} : idle_q + {{IDLE{1'b0}}, 1'b1};
    if (rst || cut) begin
      count_q <= 4'd0;
    end else begin
      count_q <= count_q + {3'd0, in_valid};
    end
    if (complete_q || rst) begin
      crc_q <= 16'hffff;
      bad_q <= 1'b0;
    end else if (in_valid) begin
      crc_q <= next_crc;
      bad_q <= bad_q || in_bad;
    end
    if (in_valid && !(&count_q[3:1])) begin
      request_q <= {in, request_q[111:8]};
    end
  end

  // Requests.
  always @(posedge clk) begin
    hello <= 1'b0;
    refused <= 1'b0;
    result_taken <= 1'b0;
    begin_q <= 1'b0;
    if (rst) begin
      {axi_awvalid, axi_wvalid, axi_arvalid, vertex_valid, write_q, read_q} <= 6'd0;
      expected_q <= 8'd0;
    end else begin
      axi_awvalid <= axi_awvalid && !axi_awready;
      axi_wvalid <= axi_wvalid && !axi_wready;
      axi_arvalid <= axi_arvalid && !axi_arready;
      vertex_valid <= vertex_valid && !vertex_ready;
      if (complete_q) begin
        words_q <= 64'd0;
        code_q <= DONE;
        if (!sound || !in_order) begin
          code_q <= sound ? ORDER : DAMAGED;
          refused <= 1'b1;
          begin_q <= 1'b1;
        end else begin
          expected_q <= number + 8'd1;
          if (operation == HELLO) begin
            hello <= 1'b1;
            words_q <= {CLOCK, NAME};
            begin_q <= 1'b1;
          end else if (((operation == READ) || (operation == WRITE)) && (|word_0[31:7])) begin
            code_q <= ERROR;
            begin_q <= 1'b1;
          end else if (operation == READ) begin
            axi_arvalid <= 1'b1;
            read_q <= 1'b1;
          end else if (operation == WRITE) begin
            {axi_awvalid, axi_wvalid} <= 2'b11;
            write_q <= 1'b1;
          end else if (is_vertex) begin
            vertex_valid <= vertex_ready;
            code_q <= vertex_ready ? DONE : NOT_NOW;
            begin_q <= 1'b1;
          end else if (operation == RECEIVE) begin
            result_taken <= result_valid;
            code_q <= !result_valid ? NOT_NOW : (result[64] ? LAST : DONE);
            words_q <= result[63:0] & {64{result_valid}};
            begin_q <= 1'b1;
          end else begin
            code_q <= UNKNOWN;
            refused <= 1'b1;
            begin_q <= 1'b1;
          end
        end
      end
      if (read_q && axi_rvalid) begin
        read_q <= 1'b0;
        words_q <= {32'd0, axi_rdata};
        code_q <= (|axi_rresp) ? ERROR : DONE;
        begin_q <= 1'b1;
      end
      if (write_q && axi_bvalid) begin
        write_q <= 1'b0;
        code_q <= (|axi_bresp) ? ERROR : DONE;
        begin_q <= 1'b1;
      end
    end
  end

  // Replies.
  always @(posedge clk) begin
    if (rst) begin
      left_q <= 4'd0;
    end else if (begin_q) begin
      left_q <= 4'd12;
    end else begin
      left_q <= left_q - {3'd0, sent};
    end
    if (begin_q) begin
      reply_q <= {words_q, number, code_q};
      reply_crc_q <= 16'hffff;
    end else if (sent && (left_q > 4'd2)) begin
      reply_q <= {8'd0, reply_q[79:8]};
      reply_crc_q <= next_reply_crc;
    end
  end
endmodule

`default_nettype wire
