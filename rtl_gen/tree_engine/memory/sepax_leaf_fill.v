// SPDX-License-Identifier: MIT
// Converts the beats of a leaf's record to triangles, with vertices instead of vertex numbers. The
// first two beats have the numbers of 16 triangles. Each other beat has two vertices, which go to
// three copies of a memory. Each cycle makes a triangle if its vertices have come. If the vertices
//@ if fpga
// are numbered in the order of the triangles, the last triangle is made 3 cycles after the last
// beat or 20 after the third; otherwise up to 16 cycles later. Two records can be in progress.
//@ else
// are numbered in the order of the triangles, the last triangle is made 1 cycle after the last beat
// or 18 after the third; otherwise up to 16 cycles later. Two records can be in progress.
//@ end
module sepax_leaf_fill #(
  parameter W = 18, // bits of a coordinate, 4 ... 21
  parameter TAG = 4 // bits of a tag
) (
  input  wire           clk,          // clock
  input  wire           rst,          // synchronous reset, active high
  input  wire           fill,         // a beat has come
  input  wire [119:0]   fill_numbers, // the beat as vertex numbers, 15 bits a triangle
  input  wire [3*W-1:0] fill_even,    // the beat's first vertex, {z, y, x}
  input  wire [3*W-1:0] fill_odd,     // the beat's second vertex
  input  wire [3:0]     fill_beat,    // number of the beat in its record
  input  wire           fill_last,    // the last beat of its record
  input  wire           fill_error,   // the beat came with an error
  input  wire [TAG-1:0] fill_tag,     // tag of the record
  output wire           busy,         // no other record may begin to come
  output wire           idle,         // no record is here
  output reg            write,        // a triangle is written
  output wire [9*W:0]   triangle,     // {damaged, z, y, x of vertex 2, of 1, of 0}
  output reg  [14:0]    corners,      // vertex numbers of the triangle
  output reg  [3:0]     index,        // number of the triangle in the leaf
  output reg  [TAG-1:0] tag,          // tag of the record
  output reg            done,         // with write: the triangle is the last of its record
  output reg            error         // with done: a beat came with an error
);
  // Numbers of records, modulo 4: that began to come; whose vertex numbers were all read; that are
  // finished. The lowest bit is the place of the record.
  reg  [1:0]     come_q, read_q, made_q;
  reg  [3:0]     beats_q [0:1];  // beats of vertices that have come, of each record
  reg  [1:0]     ended_q;        // the last beat of the record has come
  reg  [1:0]     error_q;        // a beat of the record came with an error
  reg  [TAG-1:0] tag_q [0:1];
  reg            words_q;        // the memory's output has the numbers of the next triangle
  reg  [3:0]     next_q;         // number of the next triangle
  //@ if fpga
  reg            asked_q;        // a triangle waits for the one that is being made
  reg  [3:0]     asked_index_q;  // number of this triangle
  reg  [14:0]    asked_numbers_q; // vertex numbers of this triangle
  //@ end
  reg            valid_q;        // there is a triangle that is made when its vertices have come
  reg  [3:0]     index_q;        // number of this triangle
  reg  [14:0]    numbers_q;      // vertex numbers of this triangle
  reg            damaged_q;
  wire [119:0]   words; //@ !fpga
  wire [14:0]    word [0:7]; //@ !fpga
  wire [239:0]   words; //@ fpga
  wire [14:0]    word [0:15]; //@ fpga
  wire [2:0]     there;          // bit k: vertex k has come //@ !fpga
  reg  [2:0]     there;          // bit k: vertex k has come //@ fpga
  wire           first = fill && (fill_beat == 4'd0); //@ !fpga
  reg            begin_q;        // the next beat is the first of a record //@ fpga
  wire           first = fill && begin_q; //@ fpga
  wire           vertices = fill && (|fill_beat[3:1]);
  wire           place = first ? come_q[0] : !come_q[0];
  wire [1:0]     here = come_q - made_q;
  //@ if fpga
  // State of the record whose triangles are made, one cycle late. Signals from it are two cycles
  // late.
  reg  [3:0]     beats_here_q;
  reg            ended_here_q, ended_q2, late_q, late_q2;
  wire           ended = ended_q2;
  reg            all_q;          // all vertices of a triangle that is not the last have come
  wire           make = valid_q && !late_q && !late_q2 && (all_q || ended);
  wire           follow = asked_q && (make || !valid_q);
  //@ else
  wire           ended = ended_q[made_q[0]];
  wire           make = valid_q && (((&there) && !(&index_q)) || ended);
  //@ end
  wire [2:0]     there_now;      // bit k: vertex k has come, as seen in this cycle //@ fpga
  wire           last = make && (&index_q);
  wire           move = words_q && (make || !valid_q); //@ !fpga
  wire           move = words_q && (follow || !asked_q); //@ fpga
  wire           start = !words_q && (read_q != come_q) &&
                         ((|beats_q[read_q[0]]) || ended_q[read_q[0]]);

  assign busy = here[1] || (here[0] && first); //@ !fpga
  assign busy = here[1]; // a record has three beats or more //@ fpga
  assign idle = !(|here) && !fill && !write;
  assign triangle[9*W] = damaged_q;

//@ if fpga
  sepax_ram #(.WIDTH(120), .ADDRESS(1)) low_numbers (
    .clk(clk), .write(fill && (fill_beat == 4'd0)), .write_address(place),
    .write_data(fill_numbers), .read(start), .read_address(read_q[0]), .read_data(words[119:0])
  );
  sepax_ram #(.WIDTH(120), .ADDRESS(1)) high_numbers (
    .clk(clk), .write(fill && (fill_beat == 4'd1)), .write_address(place),
    .write_data(fill_numbers), .read(start), .read_address(read_q[0]), .read_data(words[239:120])
  );
//@ else
  sepax_ram #(.WIDTH(120), .ADDRESS(2)) numbers (
    .clk(clk), .write(fill && !(|fill_beat[3:1])), .write_address({place, fill_beat[0]}),
    .write_data(fill_numbers), .read(start || (move && (next_q == 4'd7))),
    .read_address({read_q[0], !start}), .read_data(words)
  );
//@ end

  genvar k;
  generate
    for (k = 0; k < @words@; k = k + 1) begin : half
      assign word[k] = words[15*k +: 15];
    end
    for (k = 0; k < 3; k = k + 1) begin : vertex
      wire [4:0]     number = numbers_q[5*k +: 5];
      wire [3*W-1:0] even, odd;
      reg            odd_q;
      assign there[k] = number[4:1] < beats_q[made_q[0]]; //@ !fpga
      //@ if fpga
      wire           there_next = asked_numbers_q[5*k+1 +: 4] < beats_here_q;
      wire           there_here = number[4:1] < beats_here_q;
      assign there_now[k] = follow ? there_next : there_here;
      //@ end
      sepax_ram #(.WIDTH(3*W), .ADDRESS(5)) evens (
        .clk(clk), .write(vertices), .write_address({place, fill_beat}), .write_data(fill_even),
        .read(make), .read_address({made_q[0], number[4:1] + 4'd2}), .read_data(even)
      );
      sepax_ram #(.WIDTH(3*W), .ADDRESS(5)) odds (
        .clk(clk), .write(vertices), .write_address({place, fill_beat}), .write_data(fill_odd),
        .read(make), .read_address({made_q[0], number[4:1] + 4'd2}), .read_data(odd)
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
      come_q <= 2'd0;
      read_q <= 2'd0;
      made_q <= 2'd0;
      {words_q, valid_q, write, done} <= 4'd0;
      {begin_q, asked_q} <= 2'd2; //@ fpga
    end else begin
      begin_q <= fill ? fill_last : begin_q; //@ fpga
      come_q <= come_q + {1'b0, first};
      read_q <= read_q + {1'b0, move && (&next_q)};
      made_q <= made_q + {1'b0, last};
      words_q <= start || (words_q && !(move && (&next_q)));
      valid_q <= move || (valid_q && !make); //@ !fpga
      asked_q <= move || (asked_q && !follow); //@ fpga
      valid_q <= follow || (valid_q && !make); //@ fpga
      write <= make;
      done <= last;
    end
    //@ if fpga
    if (fill && !place) begin
      {ended_q[0], error_q[0]} <= {fill_last, fill_error || (error_q[0] && !first)};
    end
    if (fill && place) begin
      {ended_q[1], error_q[1]} <= {fill_last, fill_error || (error_q[1] && !first)};
    end
    //@ end
    if (fill) begin
      ended_q[place] <= fill_last; //@ !fpga
      error_q[place] <= fill_error || (error_q[place] && !first); //@ !fpga
      beats_q[place] <= (|fill_beat) ? fill_beat - 4'd1 : 4'd0;
      tag_q[place] <= fill_tag;
    end
    //@ if fpga
    beats_here_q <= beats_q[made_q[0]];
    ended_here_q <= ended_q[made_q[0]];
    ended_q2 <= ended_here_q;
    there <= there_now;
    all_q <= (&there_now) && !(follow ? &asked_index_q : &index_q);
    {late_q2, late_q} <= {late_q, last};
    //@ end
    if (start) begin
      next_q <= 4'd0;
    end else if (move) begin
      next_q <= next_q + 4'd1;
    end
    //@ if fpga
    if (move) begin
      asked_numbers_q <= word[next_q];
      asked_index_q <= next_q;
    end
    if (follow) begin
      numbers_q <= asked_numbers_q;
      index_q <= asked_index_q;
    end
    //@ else
    if (move) begin
      numbers_q <= word[next_q[2:0]];
      index_q <= next_q;
    end
    //@ end
    if (make) begin
      corners <= numbers_q;
      index <= index_q;
      tag <= tag_q[made_q[0]];
      error <= error_q[made_q[0]];
      damaged_q <= !(&there);
    end
  end
endmodule
