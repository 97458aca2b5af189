// SPDX-License-Identifier: MIT
// Gives the hits of an entry as items: its rows as they come, or, if the entry wants columns, its
// columns when all rows are here. Items with mask 0 are left out, except the last of an entry.
// Latency 0 of a row, 1 of a column. //@ !fpga
// Latency 0 of a row, 2 of a column. //@ fpga
module sepax_hits (
  input  wire        clk,       // clock
  input  wire        clear,     // drop all rows
  input  wire        in_valid,  // a row
  output wire        in_ready,  // it is taken in this cycle
  input  wire        in_last,   // the last row of its entry
  input  wire [3:0]  in_index,  // its number i, ascending
  input  wire [15:0] in_row,    // bit j: box i hits child j
  input  wire        columns,   // the current entry's items are columns
  output wire        out_valid, // an item
  input  wire        out_ready, // it is taken in this cycle
  output wire        out_last,  // the last item of its entry
  output wire [3:0]  out_index, // number of the row or column
  output wire [15:0] out_mask   // the row or the column
);
  reg         full_q;           // an entry with columns: all its rows are here
  reg  [15:0] hit_q;            // bit j: column j is not 0 and was not taken yet
  reg  [15:0] here_q;           // bit i: row i is here; rows that are not here count as 0
  reg  [255:0] row_q;           // the rows
  //@ if fpga
  reg         first_full_q;     // a column is picked
  reg         first_last_q;     // the picked column is the last
  reg  [15:0] first_q;          // one-hot: the picked column
  wire [15:0] first = first_q;
  wire [15:0] lowest;
  wire        many;             // at least two columns were not picked
  wire        pick = full_q && !(first_full_q && first_last_q) && (!first_full_q || out_ready);
  //@ else
  wire [15:0] first = hit_q & (~hit_q + 16'd1);
  wire [15:0] others = hit_q & ~first;
  //@ end
  wire [15:0] column;
  wire        taken = out_valid && out_ready;

  assign in_ready = columns ? !full_q : out_ready;
  //@ if fpga
  assign out_valid = columns ? first_full_q : in_valid;
  assign out_last = columns ? first_last_q : in_last;
  assign out_index = columns ? {|(first & 16'hff00), |(first & 16'hf0f0), |(first & 16'hcccc),
                                |(first & 16'haaaa)} : in_index;
  //@ else
  assign out_valid = columns ? full_q : in_valid;
  assign out_last = columns ? (others == 16'd0) : in_last;
  assign out_index = columns ? {|first[15:8], |{first[15:12], first[7:4]},
                                |{first[15:14], first[11:10], first[7:6], first[3:2]},
                                |{first[15], first[13], first[11], first[9], first[7], first[5],
                                  first[3], first[1]}} : in_index;
  //@ end
  assign out_mask = columns ? column : in_row;

//@ if fpga
  sepax_several left (.mask(hit_q), .many(many), .lowest(lowest));

//@ end
  genvar i;
  generate
    for (i = 0; i < 16; i = i + 1) begin : row
      assign column[i] = here_q[i] && (|(row_q[16*i +: 16] & first));
      always @(posedge clk) begin
        if (in_valid && !full_q && (in_index == i[3:0])) begin
          row_q[16*i +: 16] <= in_row;
        end
      end
    end
  endgenerate

  always @(posedge clk) begin
    if (clear) begin
      full_q <= 1'b0;
      first_full_q <= 1'b0; //@ fpga
      hit_q <= 16'd0;
      here_q <= 16'd0;
    end else if (columns && !full_q && in_valid) begin
      full_q <= in_last;
      hit_q <= hit_q | in_row;
      here_q <= here_q | (16'd1 << in_index);
    end else if (columns && taken) begin
      full_q <= !out_last;
      hit_q <= others; //@ !fpga
      here_q <= here_q & {16{!out_last}};
    end
    //@ if fpga
    if (!clear && (pick || taken)) begin
      first_full_q <= pick;
    end
    if (!clear && pick) begin
      hit_q <= hit_q & ~lowest;
      first_q <= lowest;
      first_last_q <= !many;
    end
    //@ end
  end
endmodule
