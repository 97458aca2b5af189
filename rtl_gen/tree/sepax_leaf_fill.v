// From the beats of a leaf's record to its triangles: vertices in place of their numbers. The
// first two beats have the numbers of 16 triangles, each other beat has two vertices. Vertices go
// to a memory of three copies; a triangle is made in each cycle, as soon as its vertices are
// there. A record that numbers its vertices in the order of the triangles is done 2 cycles after
// its last beat, others take up to 16 more.
module sepax_leaf_fill #(
  parameter W = 18,  // bits of a coordinate, 4 ... 21
  parameter TAG = 4  // bits of a tag
) (
  input  wire           clk,        // clock
  input  wire           rst,        // synchronous reset, active high
  input  wire           fill,       // a beat has come
  input  wire [119:0]   fill_numbers, // its data as numbers of vertices, 15 bits a triangle
  input  wire [3*W-1:0] fill_even,  // its data as a vertex, {z, y, x}
  input  wire [3*W-1:0] fill_odd,   // its data as the next vertex
  input  wire [3:0]     fill_beat,  // its number
  input  wire           fill_last,  // the last of its record
  input  wire           fill_error, // with an error
  input  wire [TAG-1:0] fill_tag,   // of the record
  output wire           busy,       // the first beat of the next record is not taken
  output reg            write,      // a triangle
  output wire [9*W:0]   triangle,   // {damaged, z, y, x of vertex 2, of 1, of 0}
  output reg  [3:0]     index,      // its number in the record
  output reg  [TAG-1:0] tag,        // of the record
  output reg            done,       // with its last triangle: the record is done
  output reg            error       // a beat came with an error
);
  reg          busy_q;
  reg          ended_q;    // the last beat has come
  reg  [239:0] numbers_q;  // three numbers a triangle, 5 bits each; the next triangle's lowest
  reg  [3:0]   index_q;    // the next triangle
  reg  [3:0]   beats_q;    // beats of vertices that have come
  reg          damaged_q;
  wire         first = fill && (fill_beat == 4'd0);
  wire         vertices = fill && (|fill_beat[3:1]);
  wire [3:0]   row = fill_beat - 4'd2;
  wire [2:0]   here;       // the vertices of the next triangle have come
  wire         make = busy_q && ((&here) || ended_q);
  wire         last = make && (&index_q);

  assign busy = busy_q || fill;
  assign triangle[9*W] = damaged_q;

  genvar k;
  generate
    for (k = 0; k < 3; k = k + 1) begin : vertex
      wire [4:0]     number = numbers_q[5*k +: 5];
      wire [3*W-1:0] even, odd;
      reg            odd_q;
      assign here[k] = number[4:1] < beats_q;
      sepax_ram #(.WIDTH(3*W), .ADDRESS(4)) evens (
        .clk(clk), .write(vertices), .write_address(row), .write_data(fill_even), .read(make),
        .read_address(number[4:1]), .read_data(even)
      );
      sepax_ram #(.WIDTH(3*W), .ADDRESS(4)) odds (
        .clk(clk), .write(vertices), .write_address(row), .write_data(fill_odd), .read(make),
        .read_address(number[4:1]), .read_data(odd)
      );
      assign triangle[3*W*k +: 3*W] = odd_q ? odd : even;
      always @(posedge clk) begin
        if (make) begin
          odd_q <= number[0];
        end
      end
    end
  endgenerate

  always @(posedge clk) begin
    if (rst) begin
      {busy_q, write, done} <= 3'd0;
    end else begin
      busy_q <= first || (busy_q && !last);
      write <= make;
      done <= last;
    end
    if (first) begin
      tag <= fill_tag;
      index_q <= 4'd0;
      beats_q <= 4'd0;
    end else begin
      if (make) begin
        index_q <= index_q + 4'd1;
      end
      if (vertices) begin
        beats_q <= fill_beat - 4'd1;
      end
    end
    if (fill) begin
      ended_q <= fill_last;
      error <= fill_error || (error && !first);
    end
    if (make) begin
      index <= index_q;
      damaged_q <= !(&here);
    end
    if (first) begin
      numbers_q[119:0] <= fill_numbers;
    end else if (fill && (fill_beat == 4'd1)) begin
      numbers_q[239:120] <= fill_numbers;
    end else if (make) begin
      numbers_q <= {15'd0, numbers_q[239:15]};
    end
  end
endmodule
