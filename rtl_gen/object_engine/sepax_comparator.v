// SPDX-License-Identifier: MIT
// Comparator lane: holds the AABB of a triangle of A and tells @told@ whether that of a triangle
// of B overlaps it. AABBs are packed {high, low} of z, y, x, x lowest.
module sepax_comparator (
  input  wire            clk,    // clock
  input  wire            clear,  // no AABB is held any more
  input  wire            load,   // take the next AABB of A
  input  wire            is_a,   // there is one
  input  wire [6*@word@-1:0] aabb_a, // signed, @word@ bits each
  input  wire            is_b,   // an AABB of B is here
  input  wire [6*@moved@-1:0] aabb_b, // signed, @moved@ bits each
  output reg             live,   // an AABB is held
  output wire            overlap // they share a point
);
  localparam W = @word@;  // bits of a coordinate
  localparam V = @moved@; // of one that was moved
  reg  [6*W-1:0] aabb_q;
  wire [6*V-1:0] wide_a;
  wire [2:0]     disjoint; //@ !fpga
  reg  [2:0]     above_q, below_q; // B's side //@ fpga
  reg            both_q;     // there were two AABBs //@ fpga

  genvar k;
  generate
    for (k = 0; k < 6; k = k + 1) begin : side
      assign wide_a[k*V +: V] = {{(V-W){aabb_q[k*W+W-1]}}, aabb_q[k*W +: W]};
    end
    for (k = 0; k < 3; k = k + 1) begin : axis
      //@ if fpga
      wire signed [V-1:0] low_a = wide_a[2*k*V +: V];
      wire signed [V-1:0] high_a = wide_a[(2*k+1)*V +: V];
      wire signed [V-1:0] low_b = aabb_b[2*k*V +: V];
      wire signed [V-1:0] high_b = aabb_b[(2*k+1)*V +: V];
      always @(posedge clk) begin
        above_q[k] <= high_a < low_b;
        below_q[k] <= high_b < low_a;
      end
      //@ else
      sepax_disjoint #(.W(V)) test (
        .low_a(wide_a[2*k*V +: V]), .high_a(wide_a[(2*k+1)*V +: V]),
        .low_b(aabb_b[2*k*V +: V]), .high_b(aabb_b[(2*k+1)*V +: V]), .disjoint(disjoint[k])
      );
      //@ end
    end
  endgenerate

  assign overlap = live && is_b && !(|disjoint); //@ !fpga
  assign overlap = both_q && !(|above_q) && !(|below_q); //@ fpga

  always @(posedge clk) begin
    if (clear) begin
      live <= 1'b0;
    end else if (load) begin
      live <= is_a;
    end
    if (load) begin
      aabb_q <= aabb_a;
    end
    //@ if fpga
    both_q <= live && is_b && !clear;
    //@ end
  end
endmodule
