// SPDX-License-Identifier: MIT
// Pair enumerator. B's triangles come one a cycle, round and round; lane k takes A's next triangle
// when B_k comes, so that it sees each B once. In round g it holds
//   A_(@lanes@ g + k) from B_k on, before that A_(@lanes@ (g - 1) + k)
// A round is count_b steps long, or @lanes@ if that is more.
module sepax_enumerator (
  input  wire           clk,        // clock
  input  wire           rst,        // synchronous reset, active high
  input  wire           start,      // begin
  input  wire           halt,       // end
  input  wire           free,       // a step may be made
  input  wire [@index_a@:0]     count_a,    // triangles of A, 1 ...
  input  wire [@index_b@:0]     count_b,    // triangles of B, 1 ...
  output reg            running,    // not at the end
  output wire           step,       // a step is made
//@ if !fpga
  output reg  [@index_b@:0]     j,          // number of B's triangle, on to the number of lanes
//@ end
  output wire           is_b,       // there is one
  output wire [@index_b@-1:0]   address_b,  // where it is
  output wire [@index_a@-1:0]   round_base, // @lanes@ g, lowest bits
  output wire [@index_a@-1:0]   address_a,  // number of A's triangle for lane j
  output wire           load,       // lane j takes it
  output wire           is_a        // there is one
);
  localparam A = @index_a@; // bits of the number of a triangle of A
  localparam B = @index_b@; // of B
  localparam [A+1:0] LANES_A = @lanes@;
  localparam [B:0]   LANES_B = @lanes@;
  localparam [A+1:0] ONE = 1;
  localparam [B:0] ONE_B = 1;
  reg  [A+1:0] base_q;     // LANES g //@ !fpga
  reg  [A-1:0] base_q;     // LANES g //@ fpga
  reg  [A+1:0] n_q;        // base + j; runs on by two rounds of lanes
  reg  [B:0]   last_j_q;   // end of a round
  reg  [A+1:0] last_n_q;   // would take the last of A's out of its lane
  reg          emptying_q; // the last round: no triangle of A is left
  wire [A+1:0] wide_a = {1'b0, count_a};
  wire [A+1:0] next_base = base_q + LANES_A; //@ !fpga
  wire         finished = emptying_q && (n_q == last_n_q); //@ !fpga
  //@ if fpga
  reg  [B:0]   j;          // number of B's triangle, on to the number of lanes
  reg  [A+1:0] next_base;  // base_q + LANES
  reg  [A+1:0] late_n_q;   // last_n_q - 1
  reg  [B:0]   late_j_q;   // last_j_q - 1
  reg          wraps_q;    // j is last_j
  reg          finished;   // emptying, and n is last_n
  //@ end

  assign address_a = n_q[A-1:0];
  assign address_b = j[B-1:0];
  assign round_base = base_q[A-1:0];
  assign step = running && free && !finished;
  assign is_b = j < count_b;
  assign load = j < LANES_B;
  assign is_a = !emptying_q && (n_q < wide_a);

  always @(posedge clk) begin
    //@ if fpga
    // Objects stand still for some cycles before a run.
    last_j_q <= ((count_b > LANES_B) ? count_b : LANES_B) - ONE_B;
    late_j_q <= last_j_q - ONE_B;
    //@ end
    running <= !(rst || halt) && (start || (running && !finished));
    if (start) begin
      j <= {(B+1){1'b0}};
      n_q <= {(A+2){1'b0}};
      base_q <= {(A+2){1'b0}}; //@ !fpga
      base_q <= {A{1'b0}}; //@ fpga
      emptying_q <= 1'b0;
      last_j_q <= ((count_b > LANES_B) ? count_b : LANES_B) - ONE_B; //@ !fpga
      last_n_q <= wide_a + LANES_A - ONE;
      //@ if fpga
      late_n_q <= wide_a + LANES_A - ONE - ONE;
      next_base <= LANES_A;
      finished <= 1'b0;
      wraps_q <= last_j_q == {(B+1){1'b0}};
      //@ end
    end else if (step) begin
      if (j == last_j_q) begin //@ !fpga
      if (wraps_q) begin //@ fpga
        j <= {(B+1){1'b0}};
        n_q <= next_base;
        base_q <= next_base; //@ !fpga
        base_q <= next_base[A-1:0]; //@ fpga
        emptying_q <= !(next_base < wide_a);
        next_base <= next_base + LANES_A; //@ fpga
        finished <= !(next_base < wide_a) && (next_base == last_n_q); //@ fpga
        wraps_q <= last_j_q == {(B+1){1'b0}}; //@ fpga
      end else begin
        j <= j + ONE_B;
        n_q <= n_q + ONE;
        finished <= emptying_q && (n_q == late_n_q); //@ fpga
        wraps_q <= j == late_j_q; //@ fpga
      end
    end
  end
endmodule
