// SPDX-License-Identifier: MIT
// The registers of the engine behind AXI4-Lite; @map@.md lists them. All outputs
// are registers; a write may come with its data before its address.
module sepax_registers (
  input  wire        clk,          // clock
  input  wire        rst,          // synchronous reset, active high
  input  wire        awvalid,      // AXI4-Lite: an address to write
  output wire        awready,      // it is taken in this cycle
  input  wire [6:0]  awaddr,       // address, a multiple of 4
  input  wire        wvalid,       // data to write
  output wire        wready,       // they are taken in this cycle
  input  wire [31:0] wdata,        // data
  input  wire [3:0]  wstrb,        // byte strobes; all 1, else SLVERR
  output reg         bvalid,       // the write is done
  input  wire        bready,       // its response is taken
  output reg  [1:0]  bresp,        // 0: OKAY, 2: SLVERR, nothing was changed
  input  wire        arvalid,      // an address to read
  output wire        arready,      // it is taken in this cycle
  input  wire [6:0]  araddr,       // address, a multiple of 4
  output reg         rvalid,       // data are here
  input  wire        rready,       // they are taken in this cycle
  output reg  [31:0] rdata,        // data
  output reg  [1:0]  rresp,        // 0: OKAY, 2: SLVERR
  output wire        irq,          // interrupt, level
  output reg         start,        // a run begins
  output reg         stop,         // the run is to end
  //@ if tree
  output reg  [32:0] list,         // address of the first job / 128
  output reg  [31:0] jobs,         // how many
  //@ else
  output wire        starting,     // a run begins, or a write that asks for it is here //@ !fpga
  output reg         starting,     // a run begins, or a write that asks for it is here //@ fpga
  output reg         first,        // mode: end at the first collision
  output reg         quiet,        // mode: no result stream
  output reg  [3*(@word@+1)-1:0] move, // added to B: {z, y, x}, signed
  //@ end
@numbers@
  input  wire        done,         // a run ends in this cycle
  input  wire        hit,          // it finds its first collision in this cycle
  input  wire        ended         // a pose has ended //@ tree
  input  wire        loaded        // the last vertex of an object has come //@ !tree
);
  // Addresses of what can be written.
@addresses@
  localparam M = @word@ + 1; // bits of a move //@ !tree
  reg         address_full_q, data_full_q, read_full_q; // a request has come
  reg  [6:0]  address_q, read_address_q;
  reg  [31:0] data_q;
  reg         whole_q; // all byte strobes were 1
  reg  [2:0]  enable_q, pending_q;
  reg         accepted, known; //@ !fpga
  reg         accepted; //@ fpga
  reg  [31:0] shown; //@ !fpga
  wire [95:0] shown_move; // {z, y, x} //@ !tree
  wire        fits;       // a move of data_q //@ !tree
  //@ if fpga
  // What a request does is found in three cycles, in which a vertex that was taken arrives.
  reg         full_q, full_q2, checked_q, accepted_q, asked_q, shown_q, known_q;
  reg  [31:0] next_q; // to be read
  reg  [131:0] some_q; // of each quarter of the addresses
  reg         asked_q2; // what is read is found in four //@ !tree
  wire        write = checked_q && (!bvalid || bready);
  wire        read = shown_q && (!rvalid || rready);
  wire        accept = write && accepted_q;
  //@ else
  wire        write = address_full_q && data_full_q && (!bvalid || bready);
  wire        read = read_full_q && (!rvalid || rready);
  wire        accept = write && whole_q && accepted;
  //@ end
  wire        idle = !status[0] && !start;
  wire        can_start = idle && (|jobs); //@ tree
  wire        can_start = idle && status[4] && status[5] && !status[6]; //@ !tree

  assign awready = !address_full_q;
  assign wready = !data_full_q;
  assign arready = !read_full_q;
  assign irq = |(pending_q & enable_q);
  //@ if !tree
  //@ if !fpga
  assign starting = start || (address_full_q && data_full_q && (address_q == COMMAND) && data_q[0]);
  //@ end
  //@ if move_is_word
  assign fits = 1'b1;
  assign shown_move = {move[2*M +: 32], move[M +: 32], move[0 +: 32]};
  //@ else
  assign fits = !(|data_q[31:M-1]) || (&data_q[31:M-1]);
  genvar k;
  generate
    for (k = 0; k < 3; k = k + 1) begin : axis
      assign shown_move[32*k +: 32] = {{(32-M){move[k*M+M-1]}}, move[k*M +: M]};
    end
  endgenerate
  //@ end
  //@ end

  always @(*) begin
    case (address_q)
      COMMAND: accepted = ((data_q == 32'd1) && can_start) || (data_q == 32'd2);
      ENABLE, PENDING: accepted = !(|data_q[31:3]);
      //@ if tree
      LIST_LOW: accepted = idle && !(|data_q[6:0]);
      LIST_HIGH: accepted = idle && !(|data_q[31:8]);
      JOBS: accepted = idle;
      //@ else
      MODE: accepted = idle && !(|data_q[31:2]);
      MOVE_X, MOVE_Y, MOVE_Z: accepted = idle && fits;
      //@ end
      default: accepted = 1'b0;
    endcase
  end

  //@ if fpga
  // What is read at an address, and whether anything is there.
  function [32:0] reading(input [6:0] at);
    reg [31:0] shown;
    reg        known;
    begin
      known = 1'b1;
      case (at)
@readable@
        default: begin
          shown = 32'd0;
          known = 1'b0;
        end
      endcase
      reading = {known, shown};
    end
  endfunction

  //@ else
  always @(*) begin
    known = 1'b1;
    case (read_address_q)
@readable@
      default: begin
        shown = 32'd0;
        known = 1'b0;
      end
    endcase
  end

  //@ end
  always @(posedge clk) begin
    if (rst) begin
      {address_full_q, data_full_q, read_full_q, bvalid, rvalid} <= 5'd0;
      {enable_q, pending_q} <= 6'd0;
      {full_q, full_q2, checked_q, asked_q, shown_q} <= 5'd0; //@ fpga
      //@ if !tree
      asked_q2 <= 1'b0; //@ fpga
      //@ end
      //@ if tree
      {start, stop} <= 2'd0;
      {list, jobs} <= 65'd0;
      //@ else
      {start, stop, first, quiet} <= 4'd0;
      starting <= 1'b0; //@ fpga
      move <= {(3*M){1'b0}};
      //@ end
    end else begin
      address_full_q <= address_full_q ? !write : awvalid;
      data_full_q <= data_full_q ? !write : wvalid;
      //@ if fpga
      full_q <= address_full_q && data_full_q && !write;
      full_q2 <= full_q && !write;
      checked_q <= full_q2 && !write;
      asked_q <= read_full_q && !read;
      shown_q <= asked_q && !read; //@ tree
      asked_q2 <= asked_q && !read; //@ !tree
      shown_q <= asked_q2 && !read; //@ !tree
      //@ if !tree
      starting <= start || (address_full_q && data_full_q && (address_q == COMMAND) && data_q[0]);
      //@ end
      //@ end
      bvalid <= write || (bvalid && !bready);
      read_full_q <= read_full_q ? !read : arvalid;
      rvalid <= read || (rvalid && !rready);
      start <= accept && (address_q == COMMAND) && data_q[0];
      stop <= accept && (address_q == COMMAND) && data_q[1];
      if (accept) begin
        case (address_q)
          ENABLE: enable_q <= data_q[2:0];
          //@ if tree
          LIST_LOW: list[24:0] <= data_q[31:7];
          LIST_HIGH: list[32:25] <= data_q[7:0];
          JOBS: jobs <= data_q;
          //@ else
          MODE: {quiet, first} <= data_q[1:0];
          MOVE_X: move[0*M +: M] <= @data@;
          MOVE_Y: move[1*M +: M] <= @data@;
          MOVE_Z: move[2*M +: M] <= @data@;
          //@ end
          default: ;
        endcase
      end
      pending_q <= (pending_q & ~(data_q[2:0] & {3{accept && (address_q == PENDING)}})) |
                   {ended, hit, done}; //@ tree
                   {loaded, hit, done}; //@ !tree
    end
    if (awvalid && awready) begin
      address_q <= awaddr;
    end
    if (wvalid && wready) begin
      data_q <= wdata;
      whole_q <= &wstrb;
    end
    //@ if fpga
    accepted_q <= whole_q && accepted;
    some_q <= {
      reading({2'd3, read_address_q[4:0]}), reading({2'd2, read_address_q[4:0]}),
      reading({2'd1, read_address_q[4:0]}), reading({2'd0, read_address_q[4:0]})
    };
    {known_q, next_q} <= some_q[8'd33 * {6'd0, read_address_q[6:5]} +: 33];
    //@ end
    if (write) begin
      bresp <= {!accept, 1'b0};
    end
    if (arvalid && arready) begin
      read_address_q <= araddr;
    end
    if (read) begin
      rdata <= shown; //@ !fpga
      rresp <= {!known, 1'b0}; //@ !fpga
      rdata <= next_q; //@ fpga
      rresp <= {!known_q, 1'b0}; //@ fpga
    end
  end
endmodule
