// SPDX-License-Identifier: MIT
// lone_properties.v - where no sign stands alone, sepax_projection and sepax_decide say the same of
// all signs and of all but one bit of them.
module lone_properties (
  input wire [39:0] orient2d, // signs {> 0, < 0}
  input wire [29:0] orient3d,
  input wire [39:0] hidden_2d, // the bit that is left out
  input wire [29:0] hidden_3d
);
  wire [39:0] seen_2d = orient2d & ~hidden_2d;
  wire [29:0] seen_3d = orient3d & ~hidden_3d;
  wire [1:0] flat, coplanar;
  sepax_projection projection (
    .g_b(orient2d[17:0]), .g_a(orient2d[35:18]), .g_own(orient2d[39:36]), .x_order(18'd0),
    .z_order(18'd0), .flat(flat[0]), .separated(), .disjoint_x(), .disjoint_z());
  sepax_projection projection_seen (
    .g_b(seen_2d[17:0]), .g_a(seen_2d[35:18]), .g_own(seen_2d[39:36]), .x_order(18'd0),
    .z_order(18'd0), .flat(flat[1]), .separated(), .disjoint_x(), .disjoint_z());
  sepax_decide decide (
    .d(orient3d[17:0]), .w(orient3d[23:18]), .s(orient3d[29:24]), .second(1'b0), .in_plane(1'b0),
    .coplanar(coplanar[0]), .axis());
  sepax_decide decide_seen (
    .d(seen_3d[17:0]), .w(seen_3d[23:18]), .s(seen_3d[29:24]), .second(1'b0), .in_plane(1'b0),
    .coplanar(coplanar[1]), .axis());

  reg [19:0] used_2d; // not 0
  reg [14:0] used_3d;
  integer k;
  always @(*) begin
    for (k = 0; k < 20; k = k + 1) used_2d[k] = |orient2d[2*k +: 2];
    for (k = 0; k < 15; k = k + 1) used_3d[k] = |orient3d[2*k +: 2];
`ifndef ALONE
    assume (used_2d == 20'd0 || (used_2d & (used_2d - 20'd1)) != 20'd0);
    assume (used_3d == 15'd0 || (used_3d & (used_3d - 15'd1)) != 15'd0);
`endif
    assume ((hidden_2d & (hidden_2d - 40'd1)) == 40'd0);
    assume ((hidden_3d & (hidden_3d - 30'd1)) == 30'd0);
    assert (flat[0] == flat[1]);
    assert (coplanar[0] == coplanar[1]);
  end
endmodule
