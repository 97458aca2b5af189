// SPDX-License-Identifier: MIT
// lone_properties.v - where no sign stands alone, sepax_decide says the same of all signs and of
// all but one bit of them.
module lone_properties (
  input wire [29:0] orient3d, // signs {> 0, < 0}
  input wire [29:0] hidden_3d // the bit that is left out
);
  wire [29:0] seen_3d = orient3d & ~hidden_3d;
  wire [1:0] coplanar;
  sepax_decide decide (
    .d(orient3d[17:0]), .w(orient3d[23:18]), .s(orient3d[29:24]), .in_plane(1'b0),
    .coplanar(coplanar[0]), .axis());
  sepax_decide decide_seen (
    .d(seen_3d[17:0]), .w(seen_3d[23:18]), .s(seen_3d[29:24]), .in_plane(1'b0),
    .coplanar(coplanar[1]), .axis());

  reg [14:0] used_3d; // not 0
  integer k;
  always @(*) begin
    for (k = 0; k < 15; k = k + 1) used_3d[k] = |orient3d[2*k +: 2];
`ifndef ALONE
    assume (used_3d == 15'd0 || (used_3d & (used_3d - 15'd1)) != 15'd0);
`endif
    assume ((hidden_3d & (hidden_3d - 30'd1)) == 30'd0);
    assert (coplanar[0] == coplanar[1]);
  end
endmodule
