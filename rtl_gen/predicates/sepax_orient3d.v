// orient3d of @points@: six times the signed volume of the tetrahedron, modulo //@ whole
// 2^V_W, from the signed prism volumes of its faces: //@ whole
// Sign of the orient3d of @points@: six times the signed volume of the //@ !whole
// tetrahedron, modulo 2^V_W, from the signed prism volumes of its faces: //@ !whole
//   volume = @formula@. Latency @latency@.
module @name@ #(
  parameter V_W = @v_w@ // bits of an orient3d
) (
  input  wire                  clk,    // clock
  input  wire signed [V_W-1:0] p,      // signed prism volume
  input  wire signed [V_W-1:0] q,      // signed prism volume
  input  wire signed [V_W-1:0] r,      // signed prism volume
  input  wire signed [V_W-1:0] s,      // signed prism volume //@ four
  output reg  signed [V_W-1:0] volume  // orient3d //@ whole
  output reg         [1:0]     sign    // {volume > 0, volume < 0} //@ !whole
);
  wire [V_W-1:0] three_sum;
  wire [V_W-1:0] three_carry;
  wire [V_W-1:0] sum;
  wire [V_W-1:0] carry;

  sepax_csa #(.N(V_W)) three (
    .a(p), .b(q),
    .c(~r), //@ minus_r
    .carry_in(1'b1), //@ minus_r
    .c(r), //@ !minus_r
    .carry_in(1'b0), //@ !minus_r
    .sum(three_sum), .carry(three_carry)
  );
//@ if four
  sepax_csa #(.N(V_W)) four (
    .a(three_sum), .b(three_carry), .c(~s), .carry_in(1'b1), .sum(sum), .carry(carry)
  );
//@ else
  assign sum = three_sum;
  assign carry = three_carry;
//@ end
//@ if rows

  reg [V_W-1:0] sum_q;
  reg [V_W-1:0] carry_q;

  always @(posedge clk) begin
    sum_q <= sum;
    carry_q <= carry;
  end
//@ end
//@ if whole

  always @(posedge clk) begin
    volume <= @sum@;
  end
//@ else
//@ if registered

  reg [V_W-1:0] volume;

  always @(posedge clk) begin
    volume <= @sum@;
  end
//@ else

  wire [V_W-1:0] volume;

  assign volume = @sum@;
//@ end

  always @(posedge clk) begin
    sign <= {!volume[V_W-1] && (volume != {V_W{1'b0}}), volume[V_W-1]};
  end
//@ end
endmodule
