// SPDX-License-Identifier: MIT
// The core on AXI4-Stream: @words@.
// Verdicts leave in the order of the pairs, each with the tag and the TLAST of its pair.
//@ if narrow
// A pair with a coordinate that does not fit @word@ bits is called a collision, undecided, and
// flagged.
//@ end
//@ if parts
// TLAST behind less than a pair cuts it short: it is called a collision, undecided, and flagged.
//@ end
// s_axis_tready: no path leads to it from an input without a register.
// Latency @latency@ from a pair's last transfer to its verdict, both counted,
// when it was empty.
module sepax_stream (
  (* X_INTERFACE_INFO = "xilinx.com:signal:clock:1.0 aclk CLK" *)
  (* X_INTERFACE_PARAMETER = "ASSOCIATED_BUSIF s_axis:m_axis, ASSOCIATED_RESET aresetn" *)
  input  wire        aclk,          // clock of everything
  (* X_INTERFACE_INFO = "xilinx.com:signal:reset:1.0 aresetn RST" *)
  (* X_INTERFACE_PARAMETER = "POLARITY ACTIVE_LOW" *)
  input  wire        aresetn,       // synchronous reset of the control, active low
  (* X_INTERFACE_INFO = "xilinx.com:interface:axis:1.0 s_axis TVALID" *)
  input  wire        s_axis_tvalid, // AXI4-Stream: @word_about@
  (* X_INTERFACE_INFO = "xilinx.com:interface:axis:1.0 s_axis TREADY" *)
  output wire        s_axis_tready, // taken in this cycle
  (* X_INTERFACE_INFO = "xilinx.com:interface:axis:1.0 s_axis TDATA" *)
  input  wire [@bits@:0] s_axis_tdata, // @layout@
  (* X_INTERFACE_INFO = "xilinx.com:interface:axis:1.0 s_axis TUSER" *)
  input  wire [@tag_msb@:0] s_axis_tuser, // tag; that of a pair's last transfer counts
  (* X_INTERFACE_INFO = "xilinx.com:interface:axis:1.0 s_axis TLAST" *)
  input  wire        s_axis_tlast,  // end of a batch: of its last pair's last transfer
  (* X_INTERFACE_INFO = "xilinx.com:interface:axis:1.0 m_axis TVALID" *)
  output wire        m_axis_tvalid, // AXI4-Stream, verdicts
  (* X_INTERFACE_INFO = "xilinx.com:interface:axis:1.0 m_axis TREADY" *)
  input  wire        m_axis_tready, // taken in this cycle
  (* X_INTERFACE_INFO = "xilinx.com:interface:axis:1.0 m_axis TDATA" *)
  output wire [31:0] m_axis_tdata,  // @verdict_bits@
  (* X_INTERFACE_INFO = "xilinx.com:interface:axis:1.0 m_axis TUSER" *)
  output wire [@tag_msb@:0] m_axis_tuser, // tag of the pair
  (* X_INTERFACE_INFO = "xilinx.com:interface:axis:1.0 m_axis TLAST" *)
  output wire        m_axis_tlast   // TLAST of the pair
);
  localparam W = @word@;      // bits of a coordinate
  localparam TAG = @tag_bits@;
  wire rst = !aresetn;
  wire core_ready, free, ends, outside, partial, of_outside, of_partial, waits, core_valid;
  wire exceeds; //@ extents
  wire [1:0] band; //@ limits
  wire collision, coplanar;
  wire [3:0] axis;
  wire [18*W-1:0] pair; // x, y, z of A_1 (lowest) ... A_3, B_1 ... B_3
  wire decided = !of_outside && !of_partial;
  wire undecided = m_axis_tvalid && !decided;

  sepax_gather gather (
    //@ if parts
    .clk(aclk), .rst(rst), .take(s_axis_tvalid && s_axis_tready), .last(s_axis_tlast),
    .ends(ends), .partial(partial),
    //@ end
    .in(s_axis_tdata), .pair(pair), .outside(outside)
  );
  assign {ends, partial} = 2'b10; //@ !parts

  // What travels with the pairs in flight.
  sepax_fifo #(.WIDTH(TAG+3), .ADDRESS(@flight@), .MARGIN(1)) pairs (
    .clk(aclk), .clear(rst), .push(s_axis_tvalid && s_axis_tready && ends),
    .in({s_axis_tuser, s_axis_tlast, outside, partial}), .free(free), .valid(waits),
    .pop(m_axis_tvalid && m_axis_tready),
    .out({m_axis_tuser, m_axis_tlast, of_outside, of_partial})
  );

  sepax_top core (
    .clk(aclk), .rst(rst), .in_valid(s_axis_tvalid && ends && free), .in_ready(core_ready),
    .in_a1_x(pair[0*W +: W]), .in_a1_y(pair[1*W +: W]), .in_a1_z(pair[2*W +: W]),
    .in_a2_x(pair[3*W +: W]), .in_a2_y(pair[4*W +: W]), .in_a2_z(pair[5*W +: W]),
    .in_a3_x(pair[6*W +: W]), .in_a3_y(pair[7*W +: W]), .in_a3_z(pair[8*W +: W]),
    .in_b1_x(pair[9*W +: W]), .in_b1_y(pair[10*W +: W]), .in_b1_z(pair[11*W +: W]),
    .in_b2_x(pair[12*W +: W]), .in_b2_y(pair[13*W +: W]), .in_b2_z(pair[14*W +: W]),
    .in_b3_x(pair[15*W +: W]), .in_b3_y(pair[16*W +: W]), .in_b3_z(pair[17*W +: W]),
    .out_of_range(exceeds), //@ extents
    .out_band(band), //@ limits
    .out_valid(core_valid), .out_ready(m_axis_tready && waits), .out_collision(collision),
    .out_coplanar(coplanar), .out_axis(axis)
  );

  assign s_axis_tready = core_ready && free;
  assign m_axis_tvalid = core_valid && waits;
  assign m_axis_tdata = {
    20'd0, undecided ? 4'd14 : axis, 2'd0,
    undecided ? 2'd2 : band, //@ limits
    2'd0, //@ !limits
    undecided && of_partial,
    undecided || exceeds, //@ extents
    undecided, //@ !extents
    coplanar && decided, collision || undecided
  };
endmodule
