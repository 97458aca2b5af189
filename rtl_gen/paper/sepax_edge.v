// Edge vector of two vertices: edge = floor((to - from) / 2^(D_W - E_W)).
// Combinational. Vectors are {z, y, x}, signed each.
module sepax_edge #(
  parameter V_W = @vertex@, // bits of a coordinate
  parameter D_W = @edge_exact@, // bits of a difference, V_W + 1
  parameter E_W = @edge@  // bits kept, 1 ... D_W
) (
  input  wire [3*V_W-1:0] from,       // vertex
  input  wire [3*V_W-1:0] to,         // vertex
  output wire [3*E_W-1:0] edge_vector // edge
);
  genvar c;
  generate
    if (D_W != V_W + 1) begin : check
      sepax_edge_D_W_is_not_V_W_plus_1 fault ();
    end
    for (c = 0; c < 3; c = c + 1) begin : component
      wire signed [V_W-1:0] head = to[c*V_W +: V_W];
      wire signed [V_W-1:0] tail = from[c*V_W +: V_W];
      wire signed [D_W-1:0] difference = {head[V_W-1], head} - {tail[V_W-1], tail};
      sepax_trunc #(.IN_W(D_W), .OUT_W(E_W)) trunc (
        .value(difference), .kept(edge_vector[c*E_W +: E_W])
      );
    end
  endgenerate
endmodule
