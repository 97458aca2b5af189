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
  input  wire [@index_b@-1:0]  next_j,    // number of B's triangle
  input  wire [@index_a@-1:0]  next_base, // base of its round
  output wire          busy,      // a pair is in flight //@ staged
  output reg           valid,     // a pair is here
  input  wire          take,      // it is taken
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
  wire             last = !(|others); // lane of the mask

  //@ if staged
  reg              live_q, live_q2, live_q3; // a mask is here, a lane, its number
  reg  [LANES-1:0] lowest_q2;
  reg  [B-1:0]     j_q2, j_q3;
  reg  [A-1:0]     base_q2, base_q3;
  wire             enable_3 = !valid || take;
  wire             enable_2 = !live_q3 || enable_3;
  wire             enable_1 = !live_q2 || enable_2;

  assign busy = live_q || live_q2 || live_q3 || valid;
  assign pop = more && (!live_q || (enable_1 && last));
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
    end else begin
      live_q <= pop || (live_q && !(enable_1 && last));
      live_q2 <= enable_1 ? live_q : live_q2;
      live_q3 <= enable_2 ? live_q2 : live_q3;
      valid <= enable_3 ? live_q3 : valid;
    end
    //@ else
    valid <= !clear && (pop || (valid && !(take && last)));
    //@ end
    if (pop) begin
      mask_q <= next_mask;
      others_q <= next_mask & (next_mask - ONE); //@ staged
      j_q <= next_j;
      base_q <= next_base;
    end else if (take) begin //@ !staged
    end else if (enable_1) begin //@ staged
      mask_q <= others;
      others_q <= others & (others - ONE); //@ staged
    end
    //@ if staged
    if (enable_1) begin
      lowest_q2 <= lowest;
      j_q2 <= j_q;
      base_q2 <= base_q;
    end
    if (enable_2) begin
      lane_q3 <= lane;
      j_q3 <= j_q2;
      base_q3 <= base_q2;
    end
    if (enable_3) begin
      a <= base_q3 + {{(A-LANE){1'b0}}, lane_q3} - (ROUND & {A{early}});
      b <= j_q3;
    end
    //@ end
  end
endmodule
