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
  //@ if extents
  output wire            exceeds,       // an AABB exceeds its extent
  //@ end
  //@ if limits
  output wire            warning,       // in the band between clearance and warning
  //@ end
  output wire            collision,     // the triangles collide
  output wire            coplanar,      // they are in one plane
  output wire [@info@-1:0]   verdict_info   // pair_info of the pair
);
  localparam W = @word@;     // bits of a coordinate
  localparam CORES = @cores@;
  localparam INFO = @info@;
  //@ if several
  localparam [CORES-1:0] ONE = 1;
  //@ end
  wire [CORES-1:0]      core_ready;
  wire [CORES-1:0]      chosen;   // one-hot: the core that takes a pair
  wire [CORES-1:0]      oldest;   // one-hot: the core that has the oldest pair
  wire [CORES-1:0]      offered;
  wire [CORES-1:0]      due;
  wire [CORES-1:0]      wanted;
  wire [CORES-1:0]      core_valid;
  wire [CORES-1:0]      core_collision;
  wire [CORES-1:0]      core_coplanar;
  //@ if extents
  wire [CORES-1:0]      core_exceeds;
  //@ end
  //@ if limits
  wire [CORES-1:0]      core_warning;
  //@ end
  wire                  free;
  wire                  launch;
  wire                  land;
  genvar                k;

  assign pair_ready = (|core_ready) && free;
  assign offered = chosen & {CORES{pair_valid && free}};
  assign launch = pair_valid && pair_ready;
  assign due = oldest & {CORES{in_flight}};
  assign verdict_valid = |(core_valid & due);
  assign wanted = due & {CORES{verdict_ready}};
  assign land = verdict_valid && verdict_ready;
  assign collision = |(core_collision & due);
  assign coplanar = |(core_coplanar & due);
  //@ if extents
  assign exceeds = |(core_exceeds & due);
  //@ end
  //@ if limits
  assign warning = |(core_warning & due);
  //@ end
  //@ if several
  assign chosen = core_ready & (~core_ready + ONE); // the first that is ready
  //@ else
  assign chosen = 1'b1;
  //@ end

  sepax_fifo #(.WIDTH(CORES + INFO), .ADDRESS(@flight_log2@), .MARGIN(2)) in_flight_fifo (
    .clk(clk), .clear(rst), .push(launch), .in({chosen, pair_info}), .free(free),
    .valid(in_flight), .pop(land), .out({oldest, verdict_info})
  );

  generate
    for (k = 0; k < CORES; k = k + 1) begin : core
      wire [3:0] unused_axis;
      //@ if limits
      wire [1:0] band;
      wire       unused_collision;
      assign core_collision[k] = band[1];
      assign core_warning[k] = band[0];
      //@ end
      sepax_top top (
        .clk(clk), .rst(rst), .in_valid(offered[k]), .in_ready(core_ready[k]),
        .in_a1_x(pair_a[0*W +: W]), .in_a1_y(pair_a[1*W +: W]), .in_a1_z(pair_a[2*W +: W]),
        .in_a2_x(pair_a[3*W +: W]), .in_a2_y(pair_a[4*W +: W]), .in_a2_z(pair_a[5*W +: W]),
        .in_a3_x(pair_a[6*W +: W]), .in_a3_y(pair_a[7*W +: W]), .in_a3_z(pair_a[8*W +: W]),
        .in_b1_x(pair_b[0*W +: W]), .in_b1_y(pair_b[1*W +: W]), .in_b1_z(pair_b[2*W +: W]),
        .in_b2_x(pair_b[3*W +: W]), .in_b2_y(pair_b[4*W +: W]), .in_b2_z(pair_b[5*W +: W]),
        .in_b3_x(pair_b[6*W +: W]), .in_b3_y(pair_b[7*W +: W]), .in_b3_z(pair_b[8*W +: W]),
        .out_valid(core_valid[k]), .out_ready(wanted[k]), .out_coplanar(core_coplanar[k]),
        //@ if extents
        .out_of_range(core_exceeds[k]),
        //@ end
        //@ if limits
        .out_collision(unused_collision), .out_band(band),
        //@ else
        .out_collision(core_collision[k]),
        //@ end
        .out_axis(unused_axis)
      );
    end
  endgenerate
endmodule
