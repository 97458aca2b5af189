// sepax_tb.v - self-checking test bench of sepax_top for Icarus Verilog.
//
// +pairs=FILE  lines of 24 integers and the expected collision, coplanar (sepax judge --echo)
// +isolated=1  from the second pair on all are coplanar: check that the operands of axes 7 ... 9
//              and what depends on them are isolated: they do not toggle (not for netlists); of
//              conference, none is coplanar: the same of the six axes of table 2
//
// A verdict must come in its cycle with the expected value; X is a mismatch. Ends
// with $finish when all is well and with $stop (exit status 1 under vvp -N) if not.

`default_nettype none

module sepax_tb;
  `include "sepax_params.vh"

  localparam QUEUE = 16;

  reg clk = 1'b0;
  reg rst = 1'b1;
  reg in_valid = 1'b0;
  reg signed [WORD-1:0] in_a_x, in_a_y, in_a_z, in_b_x, in_b_y, in_b_z, in_na, in_nb;
  wire out_valid, out_collision, out_coplanar;

  sepax_top dut (
    .clk(clk), .rst(rst), .in_valid(in_valid),
    .in_a_x(in_a_x), .in_a_y(in_a_y), .in_a_z(in_a_z),
    .in_b_x(in_b_x), .in_b_y(in_b_y), .in_b_z(in_b_z),
    .in_na(in_na), .in_nb(in_nb),
    .out_valid(out_valid), .out_collision(out_collision), .out_coplanar(out_coplanar)
  );

  always #1 clk = ~clk;

  reg [8*1024-1:0] path;
  integer file, fields, i, word, cycle, sent, judged, mismatches, isolated;
  integer number [0:25];
  integer due [0:QUEUE-1];
  reg [1:0] expected [0:QUEUE-1]; // collision, coplanar

  task mismatch(input [8*40-1:0] what);
    begin
      mismatches = mismatches + 1;
      $display("icarus: pair %0d, cycle %0d: %0s (valid %b, collision %b, coplanar %b)", judged,
               cycle, what, out_valid, out_collision, out_coplanar);
      if (mismatches == 20) begin
        $stop;
      end
    end
  endtask

  // The middle of one clock cycle: judge its outputs, then wait for the next.
  task tick;
    begin
      cycle = cycle + 1;
      if (judged < sent && due[judged % QUEUE] == cycle) begin
        if (out_valid !== 1'b1) begin
          mismatch("no verdict");
        end else if (out_collision !== expected[judged % QUEUE][1]) begin
          mismatch("wrong verdict");
        end else if (out_coplanar !== expected[judged % QUEUE][0]) begin
          mismatch("wrong out_coplanar");
        end
        judged = judged + 1;
      end else if (out_valid !== 1'b0 || out_collision !== 1'b0 || out_coplanar !== 1'b0) begin
        mismatch("an output is not 0 without a verdict");
      end
      @(negedge clk);
    end
  endtask

  task read_pair;
    begin
      fields = 0;
      for (i = 0; i < 26; i = i + 1) begin
        fields = fields + ($fscanf(file, "%d", number[i]) == 1);
      end
    end
  endtask

  task send_pair;
    begin
      due[sent % QUEUE] = cycle + LATENCY;
      expected[sent % QUEUE] = {number[24] != 0, number[25] != 0};
      sent = sent + 1;
      for (word = 0; word < 3; word = word + 1) begin
        in_valid = 1'b1;
        in_a_x = number[3*word];
        in_a_y = number[3*word+1];
        in_a_z = number[3*word+2];
        in_b_x = number[3*word+9];
        in_b_y = number[3*word+10];
        in_b_z = number[3*word+11];
        in_na = number[word+18];
        in_nb = number[word+21];
        tick;
      end
      in_valid = 1'b0;
    end
  endtask

  initial begin
    cycle = 0;
    sent = 0;
    judged = 0;
    mismatches = 0;
    if (!$value$plusargs("isolated=%d", isolated)) begin
      isolated = 0;
    end
    if (!$value$plusargs("pairs=%s", path)) begin
      $display("icarus: give +pairs=FILE");
      $stop;
    end
    file = $fopen(path, "r");
    if (file == 0) begin
      $display("icarus: %0s: cannot be read", path);
      $stop;
    end
    repeat (3) @(negedge clk);
    rst = 1'b0;
    read_pair;
    while (fields == 26) begin
      send_pair;
      read_pair;
    end
    if (fields != 0) begin
      mismatch("a line without 26 integers");
    end
    repeat (2 * LATENCY) tick;
    $display("icarus: %0d pairs, %0d mismatches", judged, mismatches);
    if (sent == 0 || judged != sent || mismatches != 0) begin
      $stop;
    end
    $finish;
  end

`ifdef SEPAX_ISOLATION
`ifdef SEPAX_CONFERENCE
  // Operands, products, axes, projections and comparisons of table 2.
  wire [1023:0] operands = {dut.a_14, dut.b_14, dut.psa_6.axes[0].product.p,
                            dut.psa_6.axes[0].product.q, dut.psa_6.axes[5].product.q};
  wire [2047:0] results = {dut.psa_6.axes[0].product.axis, dut.psa_6.axes[3].product.axis,
                           dut.psa_6.axes[5].product.axis, dut.flat[0].on_a, dut.flat[3].on_b,
                           dut.flat[5].on_a, dut.overlap_flat,
                           dut.psa_6.axes[1].product.component[0].ij_q,
                           dut.flat[0].proj.vertex[0].dot_a.product_q,
                           dut.flat[5].proj.vertex[2].dot_b.product_q};
`else
  // Operands, products, projections of the three isolated PROJ, and their PSA part.
  wire [1023:0] operands = {dut.a_10, dut.b_10, dut.psa.axes[6].product.p,
                            dut.psa.axes[6].product.q, dut.psa.axes[8].product.q};
  wire [2047:0] results = {dut.psa.axes[6].product.axis, dut.psa.axes[7].product.axis,
                           dut.psa.axes[8].product.axis, dut.axes[6].on_a, dut.axes[7].on_b,
                           dut.axes[8].on_a, dut.axes[6].proj.vertex[0].dot_a.product_q,
                           dut.axes[8].proj.vertex[2].dot_b.product_q};
`endif
  reg [1023:0] operands_before;
  reg [2047:0] results_before;
  integer watched = 0;

  always @(negedge clk) begin
    if (isolated != 0 && judged >= 1) begin
      if (watched > 0 && (operands !== operands_before || results !== results_before)) begin
        mismatch("an isolated axis moved");
      end
      watched = watched + 1;
    end
    operands_before = operands;
    results_before = results;
  end
`endif
endmodule

`default_nettype wire
