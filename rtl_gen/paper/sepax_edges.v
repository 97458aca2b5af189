// SPDX-License-Identifier: MIT
// Edge vectors of a triangle: edge k = floor((vertex k+1 - vertex k) / 2^(D_W - E_W)); edge 3 goes
// to vertex 1. Combinational. Vertices and edges are {3, 2, 1}, of each {z, y, x}, signed.
module sepax_edges #(
  parameter V_W = @vertex@, // bits of a coordinate
  parameter D_W = @edge_exact@, // bits of a difference, V_W + 1
  parameter E_W = @edge@  // bits kept, 1 ... D_W
) (
  input  wire [9*V_W-1:0] triangle, // vertices
  output wire [9*E_W-1:0] edges     // edges
);
  genvar k;
  generate
    if (D_W != V_W + 1) begin : check
      sepax_edges_D_W_is_not_V_W_plus_1 fault ();
    end
    for (k = 0; k < 9; k = k + 1) begin : component
      wire signed [V_W-1:0] head = triangle[((k+3)%9)*V_W +: V_W];
      wire signed [V_W-1:0] tail = triangle[k*V_W +: V_W];
      wire signed [D_W-1:0] difference = {head[V_W-1], head} - {tail[V_W-1], tail};
      sepax_trunc #(.IN_W(D_W), .OUT_W(E_W)) trunc (.value(difference), .kept(edges[k*E_W +: E_W]));
    end
  endgenerate
endmodule
