// SPDX-License-Identifier: MIT
// Chooses the projection in which one pass through the core decides a pair, and sees the pair along
// its axis. Let P and Q be the vertices of least and of greatest x of one triangle, x_P < x_Q, and
// R the vertex of least x of the other one, with x_P <= x_R <= x_Q. Let
//   m = (x_Q - x_P)(y_R - y_P) - (x_R - x_P)(y_Q - y_P), the orient2d of P, Q and R.
// m is not 0: the pair is seen along z. m is 0: along y, so y and z are exchanged. If all six x are
// equal, then m is 0 and y stands for x; if all six y are equal, too, then z stands for x.
// P and Q are A's if A has a length in x and no vertex of B has a lesser x than A; else they are
// B's, and then -m is computed, because only whether it is 0 is asked.
// docs/reference/exact.md has the proof. Latency @axis_latency@.
module sepax_axis #(
  parameter W = @w@,     // bits of a coordinate
  parameter S_W = @s_w@, // bits of a difference
  parameter DIGITS = @step_digits@, // radix-4 digits of a second factor //@ biased
  parameter D_W = @step_w@  // bits of a second factor
) (
  input  wire            clk,      // clock
  input  wire            last,     // the II window ends, and a pair is taken //@ shared
  input  wire            second,   // cycle @tested_cycle@ of a pair //@ in_turn
  input  wire            comes,    // a pair may be here //@ gated
  input  wire [@axis_live@:0] live, // bit t: a pair is in cycle t, or just was //@ axis_gated
  input  wire [18*W-1:0] in_pair,  // x of A_1 (lowest) ... A_3, B_1 ... B_3; y; z
  output wire [18*W-1:0] out_pair  // the pair as it is seen
);
  // Of three values that of the first vertex, the second, the third.
  function [W-1:0] pick(input [3*W-1:0] three, input is_first, input is_second);
    pick = is_first ? three[0 +: W] : is_second ? three[W +: W] : three[2*W +: W];
  endfunction
  function [D_W-1:0] wide(input [W-1:0] coordinate);
    wide = {{(D_W-W){coordinate[W-1]}}, coordinate};
  endfunction
  function [S_W-1:0] signed_of(input [W-1:0] coordinate);
    signed_of = {coordinate[W-1], coordinate};
  endfunction

  // The pair, for one II window in each register. Cycle 0 is its first in pair_q.
@banks@
  wire [5*W-1:0] y_others = pair_q[7*W +: 5*W];
  wire same_y = y_others == {5{pair_q[6*W +: W]}}; // all y are equal

  // Cycle 0: is x of a vertex at most that of the next one? Of A's, then of B's vertices.
  wire [5:0] rises;
@compared@
  // Cycle @picked_cycle@: the vertices of least and of greatest x, of A and of B.
  wire [5:0] order = rises@q_compared@;
  wire [1:0] level = {&order[5:3], &order[2:0]}; // a triangle has no length in x
  wire [2*W-1:0] low_x, low_y, high_x, high_y;
@picked@
  // Cycle @differences_cycle@: from P to Q of both triangles, and from A's P to B's.
//@ if biased
  localparam [D_W-1:0] BIAS = {{(D_W+2-2*DIGITS){1'b0}}, {(DIGITS-1){2'b01}}}; // that is deducted
//@ end
  wire [1:0] flat = level@q_picked@;
  wire [2*W-1:0] p_x = low_x@q_picked@;
  wire [2*W-1:0] p_y = low_y@q_picked@;
  wire [2*W-1:0] q_x = high_x@q_picked@;
  wire [2*W-1:0] q_y = high_y@q_picked@;
  wire [2*S_W-1:0] run;
  wire [2*D_W-1:0] fall; // y_P - y_Q + BIAS //@ biased
  wire [2*D_W-1:0] fall; // y_Q - y_P //@ !biased
  wire [S_W-1:0] step = signed_of(p_x[W +: W]) - signed_of(p_x[0 +: W]);
  wire [D_W-1:0] climb = wide(p_y[W +: W]) - wide(p_y[0 +: W])@plus_bias@;
@differences@
  // Cycle @chosen_cycle@: whose P and Q they are.
  wire [1:0] flat_of = flat@q_differences@;
  wire [S_W-1:0] step_of = step@q_differences@;
  wire [D_W-1:0] climb_of = climb@q_differences@;
  wire [2*S_W-1:0] runs = run@q_differences@;
  wire [2*D_W-1:0] falls = fall@q_differences@;
  wire of_a = !step_of[S_W-1] && !flat_of[0];
  wire same_x = (&flat_of) && (step_of == {S_W{1'b0}}); // all x are equal
  wire [S_W-1:0] run_of = of_a ? runs[0 +: S_W] : runs[S_W +: S_W];
  wire [D_W-1:0] fall_of = of_a ? falls[0 +: D_W] : falls[D_W +: D_W];
@chosen@
  // From cycle @product_cycle@ on; in cycle @tested_cycle@: is m zero?
  wire across;
//@ if biased
  wire [2*W-1:0] sum, carry; // m is what they add up to
//@ if in_turn
@summed@
  @axis_product@ each ( // and what the first has left
    .clk(clk), //@ product_clocked
    .a(second ? step_of@q_chosen@ : run_of@q_chosen@),
    .b(second ? fall_of@q_chosen@ : climb_of@q_chosen@),
    .c(sum_q & {(2*W){second}}), .d(carry_q & {(2*W){second}}), .p(sum), .q(carry)
  );
//@ else
  @axis_product@ both (
    .clk(clk), //@ product_clocked
    .a({step_of@q_chosen@, run_of@q_chosen@}), .b({fall_of@q_chosen@, climb_of@q_chosen@}),
    .p(sum), .q(carry)
  );
//@ end
  // They cancel if each bit of their sum is 0; then a bit's carry is 1 if either has the bit below.
  wire [2*W-1:0] carried = {sum[2*W-2:0] | carry[2*W-2:0], 1'b0};
  assign across = (sum ^ carry ^ carried) == {(2*W){1'b0}};
//@ else
  wire [@product_w@-1:0] by_climb, by_fall;
  @axis_product@ first (.clk(clk), .a(run_of@q_chosen@), .b(climb_of@q_chosen@), .p(by_climb));
  @axis_product@ second (.clk(clk), .a(step_of@q_chosen@), .b(fall_of@q_chosen@), .p(by_fall));
  assign across = by_climb == by_fall;
//@ end
@waits@

  genvar t, k;
  generate
    for (t = 0; t < 2; t = t + 1) begin : triangle
      wire [3*W-1:0] x = @picked_bank@[3*t*W +: 3*W];
      wire [3*W-1:0] y = @picked_bank@[(6+3*t)*W +: 3*W];
      wire [2:0] up = order[3*t +: 3];
      for (k = 0; k < 3; k = k + 1) begin : edge_of
        assign rises[3*t+k] = $signed(pair_q[(3*t+k)*W +: W]) <=
                              $signed(pair_q[(3*t+(k+1)%3)*W +: W]);
      end
      assign low_x[t*W +: W] = pick(x, up[0] && !up[2], up[1] && !up[0]);
      assign low_y[t*W +: W] = pick(y, up[0] && !up[2], up[1] && !up[0]);
      assign high_x[t*W +: W] = pick(x, up[2] && !up[0], up[0] && !up[1]);
      assign high_y[t*W +: W] = pick(y, up[2] && !up[0], up[0] && !up[1]);
      assign run[t*S_W +: S_W] = signed_of(q_x[t*W +: W]) - signed_of(p_x[t*W +: W]);
      assign fall[t*D_W +: D_W] = wide(p_y[t*W +: W]) - wide(q_y[t*W +: W]) + BIAS; //@ biased
      assign fall[t*D_W +: D_W] = wide(q_y[t*W +: W]) - wide(p_y[t*W +: W]); //@ !biased
    end
  endgenerate

  // Cycle @out_cycle@: the pair leaves.
  wire [6*W-1:0] all_x = @out_bank@[0 +: 6*W];
  wire [6*W-1:0] all_y = @out_bank@[6*W +: 6*W];
  wire [6*W-1:0] all_z = @out_bank@[12*W +: 6*W];
  assign out_pair = {across@q_late@ ? all_y : all_z, across@q_late@ ? all_z : all_y,
                     !same_x@q_same_x@ ? all_x : same_y@q_same_y@ ? all_z : all_y};
endmodule
