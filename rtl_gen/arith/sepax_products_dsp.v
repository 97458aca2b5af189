// SPDX-License-Identifier: MIT
// Sum of products: p = sum over k of a_k b_k + c@minus_d@ modulo 2^@p_w@, for the
// @terms@ factors a_k and b_k of a and b. For multipliers of @family@.
// Latency @latency@.
module @name@ (
  input  wire               clk, // clock
  input  wire [@a_msb@:0] a, // first factors, signed, the first lowest
  input  wire [@b_msb@:0] b, // second factors, signed, the first lowest
  input  wire signed [@c_msb@:0] c, // addend
  input  wire signed [@d_msb@:0] d, // addend //@ d
  output wire signed [@p_msb@:0] p  // sum, @latency@ clocks later
);
  localparam A_W = @a_w@;
  localparam B_W = @b_w@;
  localparam ONE_W = @one_w@;  // bits of a product
  localparam P_W = @p_w@;
  localparam STAGES = @stages@; // of a product
  wire [P_W-1:0]        product [0:@terms@-1];
  reg  [STAGES*P_W-1:0] addends_q; // the sum of c and d, as long as products are made
  wire [P_W-1:0]        low = product[0] + product[1];
  wire [P_W-1:0]        high = product[2] + addends_q[STAGES*P_W-1 -: P_W];
  reg  [P_W-1:0]        low_q, high_q; //@ two_sums

  assign p = low + high; //@ !two_sums
  assign p = low_q + high_q; //@ two_sums

  genvar k;
  generate
    for (k = 0; k < @terms@; k = k + 1) begin : term
      wire [ONE_W-1:0] one;
      @product@ product_of (
        .clk(clk), .a(a[A_W*k +: A_W]), .b(b[B_W*k +: B_W]), .p(one)
      );
      assign product[k] = {{(P_W-ONE_W){one[ONE_W-1]}}, one};
    end
  endgenerate

  always @(posedge clk) begin
    addends_q <= {
      addends_q[(STAGES-1)*P_W-1:0],
      {{@c_above@{c[@c_msb@]}}, c} - {{@d_above@{d[@d_msb@]}}, d, @d_place@'d0} //@ d
      {{@c_above@{c[@c_msb@]}}, c} //@ !d
    };
    {low_q, high_q} <= {low, high}; //@ two_sums
  end
endmodule
