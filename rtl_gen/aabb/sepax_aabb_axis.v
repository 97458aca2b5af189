//@ if extents
// One axis of a pair: are the AABBs disjoint@margin_about@,
// does one exceed its extent; and if neither, the coordinates from a local origin near the lower
// end of the larger kind:
//   near = coordinate - low + origin, modulo 2^N
// Latency 2.
//@ else
// One axis of a pair: are the AABBs disjoint@margin_about@? Combinational.
//@ end
module sepax_aabb_axis (
  //@ if extents
  input  wire         clk,      // clock
  input  wire         enable_1, // the first stage takes the coordinates
  input  wire         enable_2, // the second stage takes them from the first
  //@ end
  input  wire [6*@word@-1:0] points,   // coordinates of A_1 (lowest) ... A_3, B_1 ... B_3
  output reg          exceeds,  // A is longer than @extent_a@, or B than @extent_b@ //@ extents
  output reg  [6*@core_word@-1:0] near, // coordinates from the local origin //@ extents
  output reg          disjoint  // the AABBs are disjoint //@ extents
  output wire         disjoint  // the AABBs are disjoint //@ !extents
);
  localparam W = @word@; // bits of a coordinate
  wire signed [W-1:0] low_a, high_a, low_b, high_b;
  wire separate;

  sepax_bounds #(.W(W)) bounds_a (
    .x_1(points[0*W +: W]), .x_2(points[1*W +: W]), .x_3(points[2*W +: W]),
    .low(low_a), .high(high_a)
  );
  sepax_bounds #(.W(W)) bounds_b (
    .x_1(points[3*W +: W]), .x_2(points[4*W +: W]), .x_3(points[5*W +: W]),
    .low(low_b), .high(high_b)
  );
  //@ if extents

  localparam N = @core_word@; // bits of a coordinate from the local origin
  reg signed [W-1:0] low_a_q, high_a_q, low_b_q, high_b_q;
  reg [6*N-1:0] points_q; // lowest N bits
  wire [W-1:0] length_a = high_a_q - low_a_q;
  wire [W-1:0] length_b = high_b_q - low_b_q;
  wire [N-1:0] base = low_@larger@_q[N-1:0];
  integer k;

  always @(posedge clk) begin
    if (enable_1) begin
      low_a_q <= low_a;
      high_a_q <= high_a;
      low_b_q <= low_b;
      high_b_q <= high_b;
      for (k = 0; k < 6; k = k + 1) begin
        points_q[k*N +: N] <= points[k*W +: N];
      end
    end
    if (enable_2) begin
      disjoint <= separate;
      exceeds <= (length_a > @word@'d@extent_a@) || (length_b > @word@'d@extent_b@);
      for (k = 0; k < 6; k = k + 1) begin
        near[k*N +: N] <= points_q[k*N +: N] - base + @core_word@'d@origin@;
      end
    end
  end
  //@ else

  assign disjoint = separate;
  //@ end

  //@ if limits
  // B's is @margin@ LSB longer at both ends.
  wire signed [W:0] lower_b = {low_b@stage@[W-1], low_b@stage@} - @margin_w@'d@margin@;
  wire signed [W:0] higher_b = {high_b@stage@[W-1], high_b@stage@} + @margin_w@'d@margin@;
  sepax_disjoint #(.W(W + 1)) test (
    .low_a({low_a@stage@[W-1], low_a@stage@}), .high_a({high_a@stage@[W-1], high_a@stage@}),
    .low_b(lower_b), .high_b(higher_b), .disjoint(separate)
  );
  //@ else
  sepax_disjoint #(.W(W)) test (
    .low_a(low_a@stage@), .high_a(high_a@stage@), .low_b(low_b@stage@), .high_b(high_b@stage@),
    .disjoint(separate)
  );
  //@ end
endmodule
