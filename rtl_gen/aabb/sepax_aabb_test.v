// SPDX-License-Identifier: MIT
// AABB test of a pair: on some axis, are the AABBs disjoint@margin_about@?
//@ if extents
// If not, does one exceed its extent; and if neither, its coordinates, on each axis from a local
// origin near the lower end of the larger kind:
//   near = coordinate - low + origin, modulo 2^N
//@ end
// A pair with disjoint AABBs leaves as zeros. valid/ready on both sides. Latency @test_latency@.
module sepax_aabb_test (
  input  wire       clk,       // clock
  input  wire       rst,       // synchronous reset of the control, active high
  input  wire       in_valid,  // a pair is here
  output wire       in_ready,  // it is taken in this cycle
  input  wire [18*@word@-1:0] in_pair, // x of A_1 (lowest) ... A_3, B_1 ... B_3; y; z
  output wire       out_valid, // a pair is here
  input  wire       out_ready, // it is taken in this cycle
  output wire [18*@core_word@-1:0] out_pair, // its coordinates, in this order
  output wire       out_exceeds, // not, but A's exceeds @extent_a@, or B's @extent_b@ //@ extents
  output wire       out_disjoint // its AABBs are disjoint
);
  localparam W = @word@; // bits of a coordinate
  localparam N = @core_word@; // bits of one that leaves
  reg valid_q;
  reg valid_q2; //@ extents
  reg [18*W-1:0] pair_q; //@ !extents
  wire [18*N-1:0] near;
  wire [2:0] disjoint;
  wire [2:0] exceeds; //@ extents
  genvar k;

  //@ if extents
  wire [18*W-1:0] pair = in_pair;
  wire enable_2 = !valid_q2 || out_ready;
  assign in_ready = !valid_q || enable_2;
  assign out_valid = valid_q2;
  assign out_exceeds = !out_disjoint && (|exceeds);
  //@ else
  wire [18*W-1:0] pair = pair_q;
  assign near = pair_q;
  assign in_ready = !valid_q || out_ready;
  assign out_valid = valid_q;
  //@ end
  assign out_disjoint = |disjoint;
  assign out_pair = near & {(18*N){out_valid && !out_disjoint}};

  always @(posedge clk) begin
    if (rst) begin
      valid_q <= 1'b0;
      valid_q2 <= 1'b0; //@ extents
    end else begin
      valid_q <= in_ready ? in_valid : valid_q;
      valid_q2 <= enable_2 ? valid_q : valid_q2; //@ extents
    end
    //@ if !extents
    if (in_valid && in_ready) begin
      pair_q <= in_pair;
    end
    //@ end
  end

  generate
    for (k = 0; k < 3; k = k + 1) begin : axis
      wire [6*W-1:0] points = pair[k*6*W +: 6*W];
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

      reg signed [W-1:0] low_a_q, high_a_q, low_b_q, high_b_q;
      reg [6*N-1:0] points_q; // lowest N bits
      reg [6*N-1:0] near_q2;
      reg disjoint_q2, exceeds_q2;
      wire [W-1:0] length_a = high_a_q - low_a_q;
      wire [W-1:0] length_b = high_b_q - low_b_q;
      integer p;
      assign near[k*6*N +: 6*N] = near_q2;
      assign disjoint[k] = disjoint_q2;
      assign exceeds[k] = exceeds_q2;

      always @(posedge clk) begin
        if (in_ready) begin
          low_a_q <= low_a;
          high_a_q <= high_a;
          low_b_q <= low_b;
          high_b_q <= high_b;
          for (p = 0; p < 6; p = p + 1) begin
            points_q[p*N +: N] <= points[p*W +: N];
          end
        end
        if (enable_2) begin
          disjoint_q2 <= separate;
          exceeds_q2 <= (length_a > @word@'d@extent_a@) || (length_b > @word@'d@extent_b@);
          for (p = 0; p < 6; p = p + 1) begin
            near_q2[p*N +: N] <= points_q[p*N +: N] - low_@larger@_q[N-1:0] + @core_word@'d@origin@;
          end
        end
      end
      //@ else
      assign disjoint[k] = separate;
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
    end
  endgenerate
endmodule
