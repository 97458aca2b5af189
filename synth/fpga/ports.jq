# SPDX-License-Identifier: MIT
# synth/fpga/ports.jq - a module with three pins around a top of many ports, as Verilog: inputs
# come out of a shift register, outputs go through registers into one that is xored with them.
#
#   jq -r --arg top TOP -f ... JSON      JSON of Yosys, before hierarchy
.modules[$top].ports | to_entries
| map({name: .key, of: .value.direction, width: (.value.bits | length)}) as $ports
| ($ports | map(select(.name | test("^a?clk$"))) | map(.name)) as $clock
| if ($clock | length) != 1 then error("\($top) has no port clk or aclk") else . end
| ($ports | map(select(.of == "input" and .name != $clock[0]))) as $in
| ($ports | map(select(.of == "output"))) as $out
| def sum: map(.width) | add // 0;
  # Where each begins in the register: rows of name, lowest bit, width.
  def placed: reduce .[] as $p ({at: 0, rows: []};
      .rows += [$p + {at}] | .at += $p.width) | .rows[];
  ($in | sum) as $ins | ($out | sum) as $outs
| "module sepax_pins (input wire clk, input wire in, output wire out);",
  "  reg [\($ins - 1):0] in_q;",
  "  wire [\($outs - 1):0] result;",
  "  reg [\($outs - 1):0] result_q, out_q;",
  "  assign out = out_q[0];",
  "  always @(posedge clk) begin",
  "    in_q <= {in_q, in};",
  "    result_q <= result;",
  "    out_q <= {out_q[0], out_q} >> 1 ^ result_q;",
  "  end",
  "  \($top) top (.\($clock[0])(clk)"
    + ([$in | placed | ", .\(.name)(in_q[\(.at + .width - 1):\(.at)])"] | join(""))
    + ([$out | placed | ", .\(.name)(result[\(.at + .width - 1):\(.at)])"] | join("")) + ");",
  "endmodule"
