// SPDX-License-Identifier: MIT
// Collects the turned vertices of B's triangles, which come one by one. A vertex that the triangle
// before has, too, does not come: it is copied. The AABB and the vertices are valid in the cycle
// after the last vertex. The AABB is saturated to W + 2 bits, and the vertices are cut to W bits.
module sepax_turned_box #(
  parameter W = 18 // bits of a coordinate, 4 ... 21
) (
  input  wire             clk,     // clock
  input  wire             clear,   // drop all work
  input  wire             valid,   // a turned vertex
  input  wire             first,   // the first vertex of its triangle that comes
  input  wire             last,    // the last vertex of its triangle
  input  wire [2:0]       place,   // one-hot: which vertex it is
  input  wire [8:0]       same,    // with the first: bit 3 k + j: vertex k equals vertex j before
  input  wire             damaged, // its triangle is damaged
  input  wire [74:0]      turned,  // {z, y, x}, 25 bits each, signed
  output reg              done,    // a pulse: a triangle is complete
  output wire [9*W-1:0]   vertices, // {vertex 2, 1, 0}, {z, y, x} each, cut to W bits
  output wire [6*W+13:0]  box      // {damaged, outside W bits, high, low}, high z highest
);
  localparam V = W + 2;
  reg  [9*V-1:0] point_q;
  reg  [2:0]     outside_q;
  reg            damaged_q;
  wire [2:0]     outside;
  wire [3*V-1:0] point;

  assign box[6*W+12] = |outside_q;
  assign box[6*W+13] = damaged_q;

  genvar i, k;
  generate
    for (i = 0; i < 3; i = i + 1) begin : axis
      wire [24:0] v = turned[25*i +: 25];
      wire        beyond = (|(v[24:V-1] ^ {(26-V){v[24]}}));
      assign outside[i] = |(v[24:W-1] ^ {(26-W){v[24]}});
      assign point[V*i +: V] = beyond ? {v[24], {(V-1){!v[24]}}} : v[V-1:0];
      sepax_bounds #(.W(V)) bounds (
        .x_1(point_q[V*i +: V]), .x_2(point_q[V*(i+3) +: V]), .x_3(point_q[V*(i+6) +: V]),
        .low(box[V*i +: V]), .high(box[V*(i+3) +: V])
      );
    end
    for (k = 0; k < 3; k = k + 1) begin : vertex
      wire [2:0] copied = first ? same[3*k +: 3] : 3'd1 << k;
      for (i = 0; i < 3; i = i + 1) begin : cut
        assign vertices[W*(3*k+i) +: W] = point_q[V*(3*k+i) +: W];
      end
      always @(posedge clk) begin
        if (valid) begin
          point_q[3*V*k +: 3*V] <= place[k] ? point
                                 : (point_q[0 +: 3*V] & {(3*V){copied[0]}}) |
                                   (point_q[3*V +: 3*V] & {(3*V){copied[1]}}) |
                                   (point_q[6*V +: 3*V] & {(3*V){copied[2]}});
          outside_q[k] <= place[k] ? (|outside) : |(outside_q & copied);
        end
      end
    end
  endgenerate

  always @(posedge clk) begin
    done <= !clear && valid && last;
    if (valid) begin
      damaged_q <= damaged;
    end
  end
endmodule
