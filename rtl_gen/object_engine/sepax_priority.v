// SPDX-License-Identifier: MIT
// Priority encoder: one pair after the other out of a candidate mask, the lowest lane first. Lane k
// holds A_(base + k), or, if B_k has not come yet, that of the round before.
//@ if staged
// A pair comes three cycles after its lane was found: registers behind the lane as one bit of a
// mask, behind its number, behind the number of A's triangle.
//@ end
module sepax_priority (
  input  wire          clk,       // clock
  input  wire          clear,     // drop what is left
  input  wire          more,      // a mask is here
  output wire          pop,       // it is taken
  input  wire [@lanes@-1:0] next_mask, // lanes, not 0
  input  wire          next_last, // there is one lane in it //@ staged
  input  wire [@index_b@-1:0]  next_j,    // number of B's triangle
  input  wire [@index_a@-1:0]  next_base, // base of its round
  output wire          busy,      // a pair is in flight //@ staged
  output reg           valid,     // a pair is here
  input  wire          take,      // it is taken //@ !staged
  input  wire          take,      // it is taken; all stands still without //@ staged
  output wire [@index_a@-1:0]  a,         // number of A's triangle //@ !staged
  output wire [@index_b@-1:0]  b          // number of B's triangle //@ !staged
  output reg  [@index_a@-1:0]  a,         // number of A's triangle //@ staged
  output reg  [@index_b@-1:0]  b          // number of B's triangle //@ staged
);
  localparam LANES = @lanes@;
  localparam A = @index_a@; // bits of the number of a triangle of A
  localparam B = @index_b@; // of B
  localparam [LANES-1:0] ONE = 1;
  reg  [LANES-1:0] mask_q;
  reg  [B-1:0]     j_q;
  reg  [A-1:0]     base_q;
  wire [LANES-1:0] lowest = mask_q & (~mask_q + ONE); //@ !staged
  wire [LANES-1:0] others = mask_q & ~lowest; //@ !staged
  reg  [LANES-1:0] others_q; //@ staged
  wire [LANES-1:0] others = others_q; //@ staged
  wire [LANES-1:0] lowest = mask_q & ~others; //@ staged
  wire             last = !(|others); // lane of the mask //@ !staged

  //@ if staged
  reg              live_q, live_q2, live_q3; // a mask is here, a lane, its number
  reg  [LANES-1:0] lowest_q2;
  reg  [B-1:0]     j_q2, j_q3;
  reg  [A-1:0]     base_q2, base_q3;
  reg              load; // another mask, not another lane: none is here, or its last lane

  assign busy = live_q || live_q2 || live_q3 || valid;
  assign pop = more && take && load;
  //@ else
  assign b = j_q;
  assign pop = more && (!valid || (take && last));
  //@ end

  //@ if lane_bits
  localparam LANE = @lane_bits@; // bits of a lane's number
  localparam [A-1:0] ROUND = @round@; // LANES, modulo 2^A
  reg  [LANE-1:0] lane;
  reg  [LANE-1:0] lane_q3; //@ staged
  wire            early = j_q < {{(B-LANE){1'b0}}, lane}; //@ !staged
  wire            early = j_q3 < {{(B-LANE){1'b0}}, lane_q3}; //@ staged
  integer         k;
  always @(*) begin
    lane = {LANE{1'b0}};
    for (k = 0; k < LANES; k = k + 1) begin
      lane = lane | (k[LANE-1:0] & {LANE{lowest[k]}}); //@ !staged
      lane = lane | (k[LANE-1:0] & {LANE{lowest_q2[k]}}); //@ staged
    end
  end
  assign a = base_q + {{(A-LANE){1'b0}}, lane} - (ROUND & {A{early}}); //@ !staged
  //@ else
  assign a = base_q;
  //@ end

  always @(posedge clk) begin
    //@ if staged
    if (clear) begin
      {live_q, live_q2, live_q3, valid} <= 4'd0;
      load <= 1'b1;
    end else begin
      if (take) begin
        {live_q, live_q2, live_q3, valid} <= {more || !load, live_q, live_q2, live_q3};
        load <= load ? !more || next_last : !(|(others & (others - ONE)));
      end
    end
    //@ else
    valid <= !clear && (pop || (valid && !(take && last)));
    //@ end
    //@ if staged
    if (take) begin
      mask_q <= load ? next_mask : others;
      others_q <= load ? next_mask & (next_mask - ONE) : others & (others - ONE);
      if (load) begin
        j_q <= next_j;
        base_q <= next_base;
      end
      lowest_q2 <= lowest;
      j_q2 <= j_q;
      base_q2 <= base_q;
      lane_q3 <= lane;
      j_q3 <= j_q2;
      base_q3 <= base_q2;
      a <= base_q3 + {{(A-LANE){1'b0}}, lane_q3} - (ROUND & {A{early}});
      b <= j_q3;
    end
    //@ else
    if (pop) begin
      mask_q <= next_mask;
      j_q <= next_j;
      base_q <= next_base;
    end else if (take) begin
      mask_q <= others;
    end
    //@ end
  end
endmodule
