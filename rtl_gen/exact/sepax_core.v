// SPDX-License-Identifier: MIT
// The exact datapath: the 15 orient3d of the six vertices from 34 products, a pair every
// @every@. Names say which vertices: t_a1b2 is the trapezoid term of the edge from A_1
// to B_2, g_a1b2b3 the orient2d of that triangle, h its signed prism volume.
//   cycle @t_cycle@  trapezoid terms t: 15 products in @t_units@ multipliers
//   cycle @g_cycle@  orient2d g, z sums z
//   cycle @h_cycle@  signed prism volumes h: 19 products in @h_units@ multipliers
//   cycle @d_cycle@  orient3d d of edges
//   cycle @v_cycle@  the verdict
// Cycle 0 is the first in which a pair stands in the first registers.
module sepax_core (
  input  wire       clk,        // clock
//@ if slots
  input  wire [@last_slot@:0] slot,       // bit k: cycle k of the II window, one-hot@slot_rests@
  input  wire       last,       // the II window ends //@ begins_at_last
//@ end
@advances@ //@ gated
@inputs@
  output wire       coplanar,   // in cycle @result_cycle@: all orient3d are zero
  output wire [1:0] band,       // with it: 0 free, 1 warning, 2 collision //@ limits
  output wire [3:0] axis        // with it: the axis that @axis_about@, or 0
);

  localparam W = @w@;     // bits of a coordinate
  localparam G_W = @g_w@; // of a trapezoid term or an orient2d
  localparam Z_W = @z_w@; // of a z sum
  localparam O_W = @o_w@; // of B's z sum
  localparam V_W = @v_w@; // of a signed prism volume or an orient3d
//@ if running
//@ if biased
  localparam OWN_DIGITS = @own_digits@; // of B's z sum
  localparam signed [O_W-1:0] OWN_BIAS =
    {{(O_W+2-2*OWN_DIGITS){1'b0}}, {(OWN_DIGITS-1){2'b01}}};
//@ else
  localparam signed [O_W-1:0] OWN_BIAS = {O_W{1'b0}};
//@ end
//@ end
//@ if limits
  localparam LIMITS = @limits@; // clearances
  localparam C_W = @c_w@; // bits of a component of e x f
  localparam L_W = @l_w@; // of a limit
  localparam M_W = @m_w@; // of an edge's limits in one projection
//@ end

@slot_copies@ //@ copied
  // Coordinates. _hold, _hold2 ... stand for one II window more each.
  // The vertices of each triangle rotate, one place a cycle. //@ rotate
@coordinates@

  // Outputs of the units. _q, _q2 ... are their delay lines; _hold is a holding register.
@outputs@
  always @(posedge clk) begin
@coordinate_moves@
  end

  always @(posedge clk) begin
@output_moves@
  end
@units@
//@ if plane

  // In cycle @projection_cycle@ of a pair:
@plane@
  wire separated; // in cycle @plane_cycle@: the pair is separated, if it is coplanar
  sepax_projection in_plane (
    .clk(clk), //@ chain
    .g_a(all_g_a), .g_b(all_g_b), .g_own(all_g_own), .x_order(all_x_order), .separated(separated)
  );
//@ if waits
  reg [@waits@-1:0] separated_q; // until cycle @verdict_cycle@
  always @(posedge clk) begin
    if (@plane_slot@) begin //@ slots
    separated_q <= @separated_next@;
    end //@ slots
  end
//@ end
//@ end

  // In cycle @verdict_cycle@ of a pair:
@verdict@
//@ if limits
  sepax_decide_band decide_band (
    .clk(clk), //@ chain
    .coplanar(coplanar), .band(band), .axis(axis),
    .f_s(all_f_s), .f_w(all_f_w), .f_d(all_f_d), .r_s(all_r_s), .r_w(all_r_w),
    .e_xy(all_e_xy), .e_yz(all_e_yz), .e_zx(all_e_zx), .box(all_box)
  );
//@ else
  sepax_decide decide (
    .clk(clk), //@ chain
    .in_plane(@in_plane@), .coplanar(coplanar), .axis(axis),
    .s(all_s), .w(all_w), .d(all_d)
  );
//@ end

endmodule
