// SPDX-License-Identifier: MIT
// The exact cores: a pair goes to the first that is ready; verdicts leave in the order of the
// pairs, which the in-flight FIFO keeps.
module sepax_cores (
  input  wire            clk,           // clock
  input  wire            rst,           // synchronous reset of the control, active high
  input  wire            pair_valid,    // a pair is here
  output wire            pair_ready,    // it is taken in this cycle
  input  wire [9*@word@-1:0] pair_a, // A: signed, @word@ bits each, x of the first vertex lowest
  input  wire [9*@word@-1:0] pair_b, // B, likewise
  input  wire [@info@-1:0]   pair_info, // goes with the pair
  output wire            in_flight,     // there are pairs in the cores
  output wire            verdict_valid, // a verdict is here
  input  wire            verdict_ready, // it is taken in this cycle
  output wire            exceeds,       // an AABB exceeds its extent //@ extents
  output wire            warning,       // in the band between clearance and warning //@ limits
  output wire            collision,     // the triangles collide
  output wire            coplanar,      // they are in one plane
  output wire [@info@-1:0]   verdict_info   // pair_info of the pair
);
  localparam W = @word@;     // bits of a coordinate
  localparam CORES = @cores@;
  localparam INFO = @info@;
  localparam [CORES-1:0] ONE = 1; //@ several
  wire [CORES-1:0] core_ready, core_valid, core_collision, core_coplanar;
  wire [CORES-1:0] core_exceeds; //@ extents
  wire [CORES-1:0] core_warning; //@ limits
  wire [CORES-1:0] chosen; // one-hot: the core that takes a pair
  wire [CORES-1:0] oldest; // one-hot: the core that has the oldest pair
  wire [CORES-1:0] due = oldest & {CORES{in_flight}};
  wire             free;

  assign chosen = core_ready & (~core_ready + ONE); // the first that is ready //@ several
  assign chosen = 1'b1; //@ !several
  assign pair_ready = (|core_ready) && free;
  assign verdict_valid = |(core_valid & due);
  assign collision = |(core_collision & due);
  assign coplanar = |(core_coplanar & due);
  assign exceeds = |(core_exceeds & due); //@ extents
  assign warning = |(core_warning & due); //@ limits

  sepax_fifo #(.WIDTH(CORES + INFO), .ADDRESS(@flight_log2@), .MARGIN(2)) in_flight_fifo (
    .clk(clk), .clear(rst), .push(pair_valid && pair_ready), .in({chosen, pair_info}),
    .free(free), .valid(in_flight), .pop(verdict_valid && verdict_ready),
    .out({oldest, verdict_info})
  );

  genvar k;
  generate
    for (k = 0; k < CORES; k = k + 1) begin : core
      wire [3:0] unused_axis;
      wire       unused_collision; //@ limits
      sepax_top top (
        .clk(clk), .rst(rst), .in_valid(chosen[k] && pair_valid && free), .in_ready(core_ready[k]),
        .in_a1_x(pair_a[0*W +: W]), .in_a1_y(pair_a[1*W +: W]), .in_a1_z(pair_a[2*W +: W]),
        .in_a2_x(pair_a[3*W +: W]), .in_a2_y(pair_a[4*W +: W]), .in_a2_z(pair_a[5*W +: W]),
        .in_a3_x(pair_a[6*W +: W]), .in_a3_y(pair_a[7*W +: W]), .in_a3_z(pair_a[8*W +: W]),
        .in_b1_x(pair_b[0*W +: W]), .in_b1_y(pair_b[1*W +: W]), .in_b1_z(pair_b[2*W +: W]),
        .in_b2_x(pair_b[3*W +: W]), .in_b2_y(pair_b[4*W +: W]), .in_b2_z(pair_b[5*W +: W]),
        .in_b3_x(pair_b[6*W +: W]), .in_b3_y(pair_b[7*W +: W]), .in_b3_z(pair_b[8*W +: W]),
        .out_valid(core_valid[k]), .out_ready(due[k] && verdict_ready),
        .out_coplanar(core_coplanar[k]), .out_axis(unused_axis),
        .out_of_range(core_exceeds[k]), //@ extents
        .out_band({core_collision[k], core_warning[k]}), .out_collision(unused_collision) //@ limits
        .out_collision(core_collision[k]) //@ !limits
      );
    end
  endgenerate
endmodule
