// SPDX-License-Identifier: MIT
// Turns B's triangles of the rows, in order. Of each row (b, mask), triangle b is read and its
// vertices are turned, one a cycle. Vertices that the row before of the same leaves has, too, are
// not turned again. AABB and vertices of the triangle go to a ring of 8 places, where they are used
// and freed in order.
module sepax_tree_rows #(
  parameter W = 18,   // bits of a coordinate, 4 ... 21
  parameter SLOT = 3, // bits of a slot of the leaf buffers
  parameter INFO = 102 // bits that go with a pair of leaves
) (
  input  wire             clk,             // clock
  input  wire             clear,           // drop all work
  output reg              error,           // a pair of leaves came with an error: no more rows
  output wire             busy,            // a row is in progress
  // rows in
  input  wire             in_valid,        // a row; with mask 0, only the end of a pair of leaves
  output wire             in_ready,        // it is taken in this cycle
  input  wire             in_last,         // the last row of its pair of leaves
  input  wire [3:0]       in_child,        // number b of B's triangle
  input  wire [15:0]      in_mask,         // mask of A's triangles
  // leaves
  input  wire             leaf_out_valid,  // the oldest pair of leaves is here, or has an error
  output wire             leaf_out_ready,  // it is taken in this cycle
  input  wire [SLOT-1:0]  leaf_out_a,      // slot of A's leaf
  input  wire [SLOT-1:0]  leaf_out_b,      // slot of B's leaf
  input  wire [INFO-1:0]  leaf_out_info,   // bits that go with the pair
  input  wire             leaf_out_error,  // a leaf of the pair was not read
  output wire             triangle_read_b, // read a triangle of B
  output wire [SLOT+3:0]  triangle_slot_b, // {slot of its leaf, its number in the leaf}
  input  wire [9*W:0]     triangle_b,      // {damaged, its vertices}, from the next cycle on
  output wire             corners_read_b,  // read the vertex numbers of this triangle
  output wire [SLOT+3:0]  corners_slot_b,  // {slot of its leaf, its number in the leaf}
  input  wire [14:0]      corners_b,       // {number of vertex 2, of 1, of 0}
  // vertices to sepax_turn_vertex and back
  output wire             turn_valid,      // a vertex is to be turned
  input  wire             turn_ready,      // it is taken in this cycle
  output wire [3*W-1:0]   turn_point,      // {z, y, x}
  output wire             turn_damaged,    // its triangle is damaged
  input  wire             turned_valid,    // a vertex has been turned
  input  wire [74:0]      turned,          // {z, y, x}, 25 bits each, signed
  input  wire             turned_damaged,  // its triangle is damaged
  // rows out
  output wire             out_valid,       // a row; its AABB is in the ring
  input  wire             out_ready,       // it is taken in this cycle
  output wire             out_last,        // as in_last
  output wire [3:0]       out_child,       // as in_child
  output wire [15:0]      out_mask,        // as in_mask
  output wire [SLOT-1:0]  out_slot,        // slot of A's leaf
  // the ring and the info of leaves: each is valid from the cycle after its read on
  input  wire             box_read,        // read the next AABB
  output wire [6*W+13:0]  box,             // {damaged, outside, high, low}
  input  wire             vertices_read,   // read the next vertices, free their place
  output wire [9*W-1:0]   vertices,        // cut to W bits
  input  wire             info_read,       // read the info of the next pair of leaves
  output wire [INFO-1:0]  info             // the bits that went in with the pair
);
  localparam FLIGHT = 14; // bits that go with a vertex: {same, place, last, first}
  // Pairs of leaves of which the info waits: each of at most 8 rows that wait may be of another
  // pair, one pair has no row yet, and four rows are on their way to the pair test. There are no
  // more of them than leaves of a body.
  localparam INFOS = SLOT < 4 ? SLOT : 4;
  reg                 leaf_q;               // there is a pair of leaves
  reg                 fresh_q;              // none of its rows was taken
  reg  [SLOT-1:0]     slot_a_q, slot_b_q;
  reg                 match_q;              // the vertex numbers of a row have been read
  reg                 first_q;              // the row is the first of its leaves
  reg  [SLOT+3:0]     triangle_q;           // place of its triangle
  reg  [14:0]         corners_q;            // vertex numbers of the row before
  reg  [2:0]          new_q;                // vertices of the triangle that are still to be turned
  reg                 begin_q;              // none of them was turned yet
  reg  [8:0]          same_q;               // bit 3 k + j: vertex k is j of the row before
  reg  [@turn@*FLIGHT-1:0] flight_q;             // FLIGHT bits of each vertex that is being turned
  reg  [3:0]          used_q;               // places of the ring in use
  reg  [3:0]          waiting_q;            // rows that came in and did not go out
  reg  [3:0]          here_q;               // rows that are in the ring and did not go out
  reg  [2:0]          turned_q, box_q, vertices_q; // the next places
  reg  [INFOS-1:0]    info_in_q, info_q;    // the next places
  wire                done;
  wire                real_row = |in_mask;
  wire [2:0]          pick = new_q & (~new_q + 3'd1);
  wire [2:0]          others = new_q & ~pick;
  wire                turn_done = turn_ready && !(|others); //@ !fpga
  //@ if fpga
  // The memory's output goes to a register. read_q says that a triangle waits for this register.
  reg                 read_q;
  reg  [2:0]          read_new_q;
  reg  [8:0]          read_same_q;
  reg  [9*W:0]        triangle_b_q;
  wire                move = read_q && !(|new_q);
  wire                match = match_q && !read_q && !used_q[3];
  //@ else
  wire                match = match_q && (!(|new_q) || turn_done) && !used_q[3];
  //@ end
  wire                take = in_valid && in_ready;
  wire [8:0]          same;
  wire [2:0]          fresh; // vertices that the row before does not have
  wire                row_here, out_real;
  wire [8:0]          flight_same;
  wire [2:0]          flight_place;
  wire                flight_last, flight_first;
  wire [9*W-1:0]      points;
  wire [6*W+13:0]     turned_box;

  assign in_ready = leaf_q && !waiting_q[3] && (!match_q || match || !real_row); //@ !fpga
  assign in_ready = leaf_q && !waiting_q[3] && (!match_q || !real_row); //@ fpga
  assign busy = leaf_q || (|waiting_q) || (|used_q);
  assign leaf_out_ready = !error && (!leaf_q || (take && in_last)); //@ !fpga
  assign leaf_out_ready = !error && !leaf_q; //@ fpga
  assign corners_read_b = take && real_row;
  assign corners_slot_b = {slot_b_q, in_child};
  assign triangle_read_b = match;
  assign triangle_slot_b = triangle_q;
  assign turn_valid = |new_q;
  assign turn_damaged = @triangle@[9*W];
  assign turn_point = (@triangle@[0 +: 3*W] & {(3*W){pick[0]}}) |
                      (@triangle@[3*W +: 3*W] & {(3*W){pick[1]}}) |
                      (@triangle@[6*W +: 3*W] & {(3*W){pick[2]}});
  assign {flight_same, flight_place, flight_last, flight_first} = flight_q[@out@];
  assign out_real = |out_mask; //@ !fpga
  assign out_valid = row_here && (!out_real || (|here_q));

  //@ if fpga
  sepax_ram_fifo #(.WIDTH(SLOT+22), .ADDRESS(3)) rows (
    .clk(clk), .clear(clear), .push(take), .in({real_row, slot_a_q, in_last, in_child, in_mask}),
    .valid(row_here), .pop(out_valid && out_ready),
    .out({out_real, out_slot, out_last, out_child, out_mask})
  );
  //@ else
  sepax_ram_fifo #(.WIDTH(SLOT+21), .ADDRESS(3)) rows (
    .clk(clk), .clear(clear), .push(take), .in({slot_a_q, in_last, in_child, in_mask}),
    .valid(row_here), .pop(out_valid && out_ready),
    .out({out_slot, out_last, out_child, out_mask})
  );
  //@ end
  sepax_turned_box #(.W(W)) turned_triangle (
    .clk(clk), .clear(clear), .valid(turned_valid), .first(flight_first), .last(flight_last),
    .place(flight_place), .same(flight_same), .damaged(turned_damaged), .turned(turned),
    .done(done), .vertices(points), .box(turned_box)
  );
  sepax_ram #(.WIDTH(6*W+14), .ADDRESS(3)) boxes (
    .clk(clk), .write(done), .write_address(turned_q), .write_data(turned_box),
    .read(box_read), .read_address(box_q), .read_data(box)
  );
  sepax_ram #(.WIDTH(9*W), .ADDRESS(3)) triangles (
    .clk(clk), .write(done), .write_address(turned_q), .write_data(points),
    .read(vertices_read), .read_address(vertices_q), .read_data(vertices)
  );
  genvar j, k;
  generate
    for (k = 0; k < 3; k = k + 1) begin : corner
      for (j = 0; j < 3; j = j + 1) begin : of_row_before
        assign same[3*k+j] = !first_q && (corners_b[5*k +: 5] == corners_q[5*j +: 5]);
      end
      assign fresh[k] = !(|same[3*k +: 3]);
    end
  endgenerate
  sepax_ram #(.WIDTH(INFO), .ADDRESS(INFOS)) infos (
    .clk(clk), .write(leaf_out_valid && leaf_out_ready), .write_address(info_in_q),
    .write_data(leaf_out_info), .read(info_read), .read_address(info_q), .read_data(info)
  );

  always @(posedge clk) begin
    if (clear) begin
      {leaf_q, match_q, error} <= 3'd0;
      read_q <= 1'b0; //@ fpga
      new_q <= 3'd0;
      {used_q, waiting_q, here_q} <= 12'd0;
      {turned_q, box_q, vertices_q} <= 9'd0;
      {info_in_q, info_q} <= {(2*INFOS){1'b0}};
    end else begin
      leaf_q <= leaf_out_ready ? leaf_out_valid && !leaf_out_error : leaf_q; //@ !fpga
      leaf_q <= leaf_q ? !(take && in_last) : !error && leaf_out_valid && !leaf_out_error; //@ fpga
      error <= error || (leaf_out_valid && leaf_out_ready && leaf_out_error);
      match_q <= corners_read_b || (match_q && !match);
      // At least one vertex is turned, because a turned vertex carries the row to the ring.
      read_q <= match || (read_q && !move); //@ fpga
      if (@move@) begin
        new_q <= {fresh[2:1], fresh[0] || !(|fresh)}; //@ !fpga
        new_q <= read_new_q; //@ fpga
      end else if (turn_ready) begin
        new_q <= others;
      end
      used_q <= used_q + {3'd0, triangle_read_b} - {3'd0, vertices_read};
      waiting_q <= waiting_q + {3'd0, take} - {3'd0, out_valid && out_ready};
      here_q <= here_q + {3'd0, done} - {3'd0, out_valid && out_ready && out_real};
      turned_q <= turned_q + {2'd0, done};
      box_q <= box_q + {2'd0, box_read};
      vertices_q <= vertices_q + {2'd0, vertices_read};
      info_in_q <= info_in_q + {{(INFOS-1){1'b0}}, leaf_out_valid && leaf_out_ready};
      info_q <= info_q + {{(INFOS-1){1'b0}}, info_read};
    end
    if (leaf_out_ready) begin
      slot_a_q <= leaf_out_a;
      slot_b_q <= leaf_out_b;
    end
    fresh_q <= leaf_out_ready || (fresh_q && !corners_read_b);
    if (corners_read_b) begin
      triangle_q <= corners_slot_b;
      first_q <= fresh_q;
    end
    if (match) begin
      corners_q <= corners_b;
      same_q <= same; //@ !fpga
      read_same_q <= same; //@ fpga
      read_new_q <= {fresh[2:1], fresh[0] || !(|fresh)}; //@ fpga
    end
    //@ if fpga
    if (move) begin
      triangle_b_q <= triangle_b;
      same_q <= read_same_q;
    end
    //@ end
    begin_q <= @move@ || (begin_q && !turn_ready);
    flight_q <= {flight_q[@turn_last@*FLIGHT-1:0], same_q, pick, !(|others), begin_q};
  end
endmodule
