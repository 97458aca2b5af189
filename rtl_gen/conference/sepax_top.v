// SPDX-License-Identifier: MIT
// Collision detection of two triangles by the separating axis theorem: the design that
// the paper improves on, with nothing shared between its two tables of axes.
//
//   cycle   1-3  input: word k brings A_k, B_k and component k of N_A and N_B
//           4-6  PSA of table 1: nine axes across edges
//           7-8  PROJ of all vertices on these, N_A and N_B
//             9  CMP of the eleven
//         10-11  PROJ of all vertices on normals, for COP alone
//         12-13  COP: coplanar? operands of the six axes, if so
//         14-15  PSA of table 2: six axes across normals and edges
//         16-17  PROJ of all vertices on these
//            18  CMP of the six
//         19-@latency@  the verdict of the six or of the eleven, and output
//
// Latency @latency@ cycles from the first word to the verdict, initiation interval 3, no stall:
// words may come back to back or with gaps. Outputs are 0 without out_valid.
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

  // Cycles 1-3: words 1 ... 3. Vertices and normals stand in cycles 5-7, 8-10, 11-13, too;
  // vertices of coplanar pairs in 14-16.
  wire [@latency@:4] step; // bit c: a pair is in cycle c
  wire [9*V_W-1:0] a, b;
  wire [3*N_W-1:0] n_a, n_b;
  reg [9*V_W-1:0] a_5, b_5, a_8, b_8, a_11, b_11, a_14, b_14;
  reg [3*N_W-1:0] n_a_5, n_b_5, n_a_8, n_b_8, n_a_11, n_b_11;

  sepax_input words (
    .clk(clk), .rst(rst), .in_valid(in_valid), .in_na(in_na), .in_nb(in_nb),
    .in_a({in_a_z, in_a_y, in_a_x}), .in_b({in_b_z, in_b_y, in_b_x}),
    .a(a), .b(b), .n_a(n_a), .n_b(n_b), .step(step)
  );

  // Cycles 4-6: the nine axes across edges; 10 is N_A, 11 is N_B.
  wire [27*C_W-1:0] axis;

  sepax_psa_9 psa_9 (
    .clk(clk), .load_en(step[4]), .product_en(step[5]), .axis_en(step[6]),
    .a(a), .b(b), .axis(axis)
  );

  // Cycles 7-8: eleven PROJ. Cycle 9: eleven CMP, which stand in cycles 10-12.
  wire [10:0] overlap;

  genvar i;
  generate
    for (i = 0; i < 9; i = i + 1) begin : axes
      wire [3*D_W-1:0] on_a, on_b;
      sepax_proj proj (
        .clk(clk), .product_en(step[7]), .sum_en(step[8]),
        .axis_a(axis[3*i*C_W +: 3*C_W]), .axis_b(axis[3*i*C_W +: 3*C_W]),
        .a(a_5), .b(b_5), .on_a(on_a), .on_b(on_b)
      );
      sepax_cmp cmp (
        .clk(clk), .en(step[9]), .idle(1'b0), .on_a(on_a), .on_b(on_b), .overlap(overlap[i])
      );
    end
    for (i = 0; i < 2; i = i + 1) begin : normals
      wire [3*N_W-1:0] normal = i == 0 ? n_a_5 : n_b_5;
      wire [3*ND_W-1:0] on_a, on_b;
      sepax_proj #(.C_W(N_W), .M_W(NM_W), .P_W(NP_W), .S_W(NS_W), .D_W(ND_W)) proj (
        .clk(clk), .product_en(step[7]), .sum_en(step[8]),
        .axis_a(normal), .axis_b(normal), .a(a_5), .b(b_5), .on_a(on_a), .on_b(on_b)
      );
      sepax_cmp #(.D_W(ND_W)) cmp (
        .clk(clk), .en(step[9]), .idle(1'b0), .on_a(on_a), .on_b(on_b), .overlap(overlap[9+i])
      );
    end
  endgenerate

  // Cycles 10-11: inner products for COP alone. 12: COP; its verdict stands in cycles 13-15.
  wire [3*ND_W-1:0] on_a_cop, on_b_cop;
  wire coplanar_13;

  sepax_proj #(.C_W(N_W), .M_W(NM_W), .P_W(NP_W), .S_W(NS_W), .D_W(ND_W)) proj_cop (
    .clk(clk), .product_en(step[10]), .sum_en(step[11]),
    .axis_a(n_a_8), .axis_b(n_a_8), //@ plane
    .axis_a(n_a_8), .axis_b(n_b_8), //@ !plane
    .a(a_8), .b(b_8), .on_a(on_a_cop), .on_b(on_b_cop)
  );
  sepax_cop cop (
    .clk(clk), .en(step[12]), .coplanar(coplanar_13),
    .p(on_b_cop), .q(on_a_cop) //@ plane
    .p(on_a_cop), .q(on_b_cop) //@ !plane
  );

  // Cycles 13-15: the six axes of table 2; 16-17: six PROJ; 18: six CMP, which stand in cycles
  // 19-21. All of them are idle for pairs that are not coplanar.
  reg coplanar_16;
  wire flat_load = step[13] && coplanar_13;
  wire flat_product = step[14] && coplanar_13;
  wire flat_axis = step[15] && coplanar_13;
  wire flat_proj = step[16] && coplanar_16;
  wire flat_sum = step[17] && coplanar_16;
  wire flat_cmp = step[18] && coplanar_16;
  wire [18*C_W-1:0] axis_flat;
  wire [5:0] overlap_flat;

  sepax_psa_6 psa_6 (
    .clk(clk), .load_en(flat_load), .product_en(flat_product), .axis_en(flat_axis),
    .a(a_11), .b(b_11), .n_a(n_a_11), .n_b(n_b_11), .axis(axis_flat)
  );

  generate
    for (i = 0; i < 6; i = i + 1) begin : flat
      wire [3*D_W-1:0] on_a, on_b;
      sepax_proj proj (
        .clk(clk), .product_en(flat_proj), .sum_en(flat_sum),
        .axis_a(axis_flat[3*i*C_W +: 3*C_W]), .axis_b(axis_flat[3*i*C_W +: 3*C_W]),
        .a(a_14), .b(b_14), .on_a(on_a), .on_b(on_b)
      );
      sepax_cmp cmp (
        .clk(clk), .en(flat_cmp), .idle(1'b0), .on_a(on_a), .on_b(on_b), .overlap(overlap_flat[i])
      );
    end
  endgenerate

  // What cycles 10 and 13 know goes along to the choice in cycle 19: eleven axes or six.
  reg separated_13, separated_16, separated_19;
  reg coplanar_19, coplanar_@latency@;
  reg collision_@latency@;

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
      n_a_8 <= n_a_5;
      n_b_8 <= n_b_5;
    end
    if (step[10]) begin
      a_11 <= a_8;
      b_11 <= b_8;
      n_a_11 <= n_a_8;
      n_b_11 <= n_b_8;
    end
    if (step[12]) begin
      separated_13 <= ~(&overlap);
    end
    if (flat_load) begin
      a_14 <= a_11;
      b_14 <= b_11;
    end
    if (step[15]) begin
      separated_16 <= separated_13;
      coplanar_16 <= coplanar_13;
    end
    if (step[18]) begin
      separated_19 <= separated_16;
      coplanar_19 <= coplanar_16;
    end
    if (step[19]) begin
      collision_@latency@ <= coplanar_19 ? (&overlap_flat) : !separated_19;
      coplanar_@latency@ <= coplanar_19;
    end
  end

  // Cycle @latency@: the verdict.
  assign out_valid = step[@latency@];
  assign out_collision = out_valid && collision_@latency@;
  assign out_coplanar = out_valid && coplanar_@latency@;
endmodule
