// SPDX-License-Identifier: MIT
// Collision detection of two triangles by the separating axis theorem: the
// architecture of the paper, figure 5, in the @latency@ cycles of its figure 6.
//
//   cycle   1-3  input: word k brings A_k, B_k and component k of N_A and N_B
//           4-5  PROJ of all vertices on N_A and N_B
//           6-7  COP: coplanar? CMP of axes 10 and 11; operands of PSA
//           8-9  PSA: axes 1 ... 9 (table 1) or 1 ... 6 (table 2, coplanar)
//         10-11  PROJ of all vertices on the axes; 7 ... 9 are idle when coplanar
//         12-@latency@  CMP and output
//
// Latency @latency@ cycles from the first word to the verdict, initiation interval 3, no
// stall: words may come back to back or with gaps. Outputs are 0 without out_valid.
// A number at the end of a name is the first of the cycles in which it stands.
module sepax_top (
  input  wire              clk,           // clock
  input  wire              rst,           // synchronous reset of the control, active high
  input  wire              in_valid,      // an input word is here; three make a pair
  input  wire signed [@msb@:0] in_a_x,        // x of vertex A_k in word k, @min@ ... @max@
  input  wire signed [@msb@:0] in_a_y,        // y of vertex A_k in word k, @min@ ... @max@
  input  wire signed [@msb@:0] in_a_z,        // z of vertex A_k in word k, @min@ ... @max@
  input  wire signed [@msb@:0] in_b_x,        // x of vertex B_k in word k, @min@ ... @max@
  input  wire signed [@msb@:0] in_b_y,        // y of vertex B_k in word k, @min@ ... @max@
  input  wire signed [@msb@:0] in_b_z,        // z of vertex B_k in word k, @min@ ... @max@
  input  wire signed [@msb@:0] in_na,         // component k of N_A in word k, Q1.@msb@
  input  wire signed [@msb@:0] in_nb,         // component k of N_B in word k, Q1.@msb@
  output wire              out_valid,     // a verdict is here
  output wire              out_collision, // 1: no separating axis was found
  output wire              out_coplanar   // 1: judged by table 2
);
  localparam V_W = @vertex@; // bits of a coordinate
  localparam N_W = @normal@; // bits of a normal's component
  localparam NM_W = @normal_product_exact@; // coordinate x normal, exact
  localparam NP_W = @normal_product@; // kept of it
  localparam NS_W = @normal_projection_exact@; // projection on a normal, exact
  localparam ND_W = @normal_projection@; // kept of it
  localparam C_W = @axis@; // bits of an axis component
  localparam D_W = @projection@; // bits of a projection on an axis

  // Cycles 1-3: words 1 ... 3. Vertices and normals stand in cycles 5-7, 8-10, 10-12, too.
  wire [@latency@:4] step; // bit c: a pair is in cycle c
  wire [9*V_W-1:0] a, b;
  wire [3*N_W-1:0] n_a, n_b;
  reg [9*V_W-1:0] a_5, b_5, a_8, b_8;
  reg [9*V_W-1:0] a_10, b_10; // for axes 7 ... 9, held for coplanar pairs
  reg [3*N_W-1:0] n_a_5, n_b_5;

  sepax_input words (
    .clk(clk), .rst(rst), .in_valid(in_valid), .in_na(in_na), .in_nb(in_nb),
    .in_a({in_a_z, in_a_y, in_a_x}), .in_b({in_b_z, in_b_y, in_b_x}),
    .a(a), .b(b), .n_a(n_a), .n_b(n_b), .step(step)
  );

  // Cycles 4-5: PROJ on N_A, lowest, and N_B; 6: CMP of axes 10 (N_A) and 11 (N_B).
  wire [6*ND_W-1:0] on_a_normal; // t_k = A_k.N_A, u_k = A_k.N_B
  wire [6*ND_W-1:0] on_b_normal; // s_k = B_k.N_A, v_k = B_k.N_B
  wire [1:0] overlap_7;

  genvar i;
  generate
    for (i = 0; i < 2; i = i + 1) begin : normals
      wire [3*N_W-1:0] normal = i == 0 ? n_a : n_b;
      sepax_proj #(.C_W(N_W), .M_W(NM_W), .P_W(NP_W), .S_W(NS_W), .D_W(ND_W)) proj (
        .clk(clk), .product_en(step[4]), .sum_en(step[5]),
        .axis_a(normal), .axis_b(normal), .a(a), .b(b),
        .on_a(on_a_normal[3*i*ND_W +: 3*ND_W]), .on_b(on_b_normal[3*i*ND_W +: 3*ND_W])
      );
      sepax_cmp #(.D_W(ND_W)) cmp (
        .clk(clk), .en(step[6]), .idle(1'b0), .on_a(on_a_normal[3*i*ND_W +: 3*ND_W]),
        .on_b(on_b_normal[3*i*ND_W +: 3*ND_W]), .overlap(overlap_7[i])
      );
    end
  endgenerate

  // Cycle 6: COP; its verdict stands in cycles 7-9.
  wire coplanar_7;

  sepax_cop cop (
    .clk(clk), .en(step[6]), .coplanar(coplanar_7),
    .p(on_b_normal[0 +: 3*ND_W]), .q(on_a_normal[0 +: 3*ND_W]) //@ plane
    .p(on_a_normal[0 +: 3*ND_W]), .q(on_b_normal[3*ND_W +: 3*ND_W]) //@ !plane
  );

  // Cycles 7-9: operands, products and differences of PSA.
  wire [27*C_W-1:0] axis;

  sepax_psa psa (
    .clk(clk), .load_en(step[7]), .product_en(step[8]), .axis_en(step[9]),
    .coplanar(coplanar_7), .a(a_5), .b(b_5), .n_a(n_a_5), .n_b(n_b_5), .axis(axis)
  );

  // What cycle 7 knows goes along to cycles 10-12 and to the verdict in cycle @latency@.
  reg coplanar_10, coplanar_@latency@;
  reg [1:0] overlap_10, overlap_@latency@; // of axes 11 and 10

  always @(posedge clk) begin
    if (step[4]) begin
      a_5 <= a;
      b_5 <= b;
      n_a_5 <= n_a;
      n_b_5 <= n_b;
    end
    if (step[7]) begin
      a_8 <= a_5;
      b_8 <= b_5;
    end
    if (step[9]) begin
      if (!coplanar_7) begin
        a_10 <= a_8;
        b_10 <= b_8;
      end
      coplanar_10 <= coplanar_7;
      overlap_10 <= overlap_7;
    end
    if (step[12]) begin
      coplanar_@latency@ <= coplanar_10;
      overlap_@latency@ <= overlap_10;
    end
  end

  // Cycles 10-11: nine PROJ; 7 ... 9 are idle for coplanar pairs. Cycle 12: nine CMP.
  wire product_en_3 = step[10] && !coplanar_10;
  wire sum_en_3 = step[11] && !coplanar_10;
  wire [8:0] overlap;

  generate
    for (i = 0; i < 9; i = i + 1) begin : axes
      wire [3*D_W-1:0] on_a, on_b;
      sepax_proj proj (
        .clk(clk), .product_en(i < 6 ? step[10] : product_en_3),
        .sum_en(i < 6 ? step[11] : sum_en_3),
        .axis_a(axis[3*i*C_W +: 3*C_W]), .axis_b(axis[3*i*C_W +: 3*C_W]),
        .a(i < 6 ? a_8 : a_10), .b(i < 6 ? b_8 : b_10), .on_a(on_a), .on_b(on_b)
      );
      sepax_cmp cmp (
        .clk(clk), .en(step[12]), .idle(i < 6 ? 1'b0 : coplanar_10),
        .on_a(on_a), .on_b(on_b), .overlap(overlap[i])
      );
    end
  endgenerate

  // Cycle @latency@: the verdict.
  wire separated;

  sepax_nand last (.overlap({overlap_@latency@, overlap}), .separated(separated));

  assign out_valid = step[@latency@];
  assign out_collision = out_valid && !separated;
  assign out_coplanar = out_valid && coplanar_@latency@;
endmodule
