// Priority encoder: one pair after the other out of a candidate mask, the lowest lane first. Lane k
// holds A_(base + k), or, if B_k has not come yet, that of the round before.
module sepax_priority (
  input  wire          clk,       // clock
  input  wire          clear,     // drop what is left
  input  wire          more,      // a mask is here
  output wire          pop,       // it is taken
  input  wire [@lanes@-1:0] next_mask, // lanes, not 0
  input  wire [@index_b@-1:0]  next_j,    // number of B's triangle
  input  wire [@index_a@-1:0]  next_base, // base of its round
  output reg           valid,     // a pair is here
  input  wire          take,      // it is taken
  output wire [@index_a@-1:0]  a,         // number of A's triangle
  output wire [@index_b@-1:0]  b          // number of B's triangle
);
  localparam LANES = @lanes@;
  localparam A = @index_a@; // bits of the number of a triangle of A
  localparam B = @index_b@; // of B
  localparam [LANES-1:0] ONE = 1;
  reg  [LANES-1:0] mask_q;
  reg  [B-1:0]     j_q;
  reg  [A-1:0]     base_q;
  wire [LANES-1:0] lowest = mask_q & (~mask_q + ONE);
  wire [LANES-1:0] others = mask_q & ~lowest;
  wire             last = !(|others); // lane of the mask

  assign b = j_q;
  assign pop = more && (!valid || (take && last));

  //@ if lane_bits
  localparam LANE = @lane_bits@; // bits of a lane's number
  localparam [A-1:0] ROUND = @round@; // LANES, modulo 2^A
  reg  [LANE-1:0] lane;
  wire            early = j_q < {{(B-LANE){1'b0}}, lane};
  integer         k;
  always @(*) begin
    lane = {LANE{1'b0}};
    for (k = 0; k < LANES; k = k + 1) begin
      lane = lane | (k[LANE-1:0] & {LANE{lowest[k]}});
    end
  end
  assign a = base_q + {{(A-LANE){1'b0}}, lane} - (ROUND & {A{early}});
  //@ else
  assign a = base_q;
  //@ end

  always @(posedge clk) begin
    valid <= !clear && (pop || (valid && !(take && last)));
    if (pop) begin
      mask_q <= next_mask;
      j_q <= next_j;
      base_q <= next_base;
    end else if (take) begin
      mask_q <= others;
    end
  end
endmodule
