# synth/report/timing.jq - clock, slack and critical paths of designs, as synth/timing/sta says.

include "netlist";

def named: if . == "" then "-" else . end;
def end_of_path: "\(.instance | named) \(.signal)";

"\(.library), OpenSTA \(.tools.sta), \(.tools.yosys | split(" (")[0])",
"inputs \(.constraints.inputs); outputs \(.constraints.outputs)",
"clock \(.constraints.clock); wires: \(.constraints.wires)\n",
(["design", "W", "II", "latency", "GE", "corner", "clock", "slack", "least", "Fmax", "hold",
  "endpoints", "late", "loads"],
 (.designs[] | . as $d | .corners[]
  | [$d.arch, $d.word, $d.ii, $d.latency, ($d.ge | k), (.library | sub("[.]lib([.]gz)?$"; "")),
     "\(.period_ns) ns", .slack_ns, "\(.least_period_ns) ns", "\(.fmax_mhz | floor) MHz",
     .hold_slack_ns, .endpoints, .late_endpoints, .most_loads]) | @tsv),
(.designs[] | . as $d | .corners[0] | .critical_path as $p
  | "\n\($d.arch), W = \($d.word), II = \($d.ii), \(.library): \(.least_period_ns) ns "
    + "from \($p.from | end_of_path) to \($p.to | end_of_path)",
    (["instance", "module", "cells", "ns", "up to signal"],
     ($p.steps[] | [(.instance | named), .module, .cells, .ns, (.signal | named)]) | @tsv))
