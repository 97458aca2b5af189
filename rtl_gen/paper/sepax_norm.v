// SPDX-License-Identifier: MIT
// Block floating point: the three components move left in common by the
// leading bits that none of them needs, so that truncation keeps their top bits.
// Combinational; a binary search for the first used bit, one shift a step.
module sepax_norm #(
  parameter S_W = @axis_exact@ // bits of a component
) (
  input  wire [3*S_W-1:0] exact,  // {z, y, x}, signed each
  output wire [3*S_W-1:0] shifted // {z, y, x} times one power of 2
);
  localparam STEPS = $clog2(S_W);

  reg [S_W-1:0] x, y, z;
  reg [S_W-1:0] used; // bits that differ from their sign, of any component
  integer s;

  always @(*) begin
    {z, y, x} = exact;
    used = {S_W{1'b0}};
    for (s = STEPS - 1; s >= 0; s = s - 1) begin
      used = (x ^ {S_W{x[S_W-1]}}) | (y ^ {S_W{y[S_W-1]}}) | (z ^ {S_W{z[S_W-1]}});
      if (!(|(used >> (S_W - 1 - (1 << s))))) begin
        x = x << (1 << s);
        y = y << (1 << s);
        z = z << (1 << s);
      end
    end
  end

  assign shifted = {z, y, x};
endmodule
