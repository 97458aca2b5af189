# SPDX-License-Identifier: MIT
# synth/fpga/routed.jq - what nextpnr says of a routed design: its reports, one a seed, each with
# `seed`; the counts ($mapped) with the clock, the critical path and what of the device is used.

include "netlist";

# The name of a signal of the Verilog in one of a cell that Yosys named after it.
def signal: sub("_(LUT4|SB|TRELLIS|CCU2C|PFUMX|L6MUX21|MULT18X18D|DP16KD)_.*$"; "")
  | sub("\\$.*$"; "") | ltrimstr("top.");
def total(f): map(select(f).delay) | add // 0 | rounded(1000);

. as $reports
| (map(select(.seed == $best))[0]) as $report
| (first($report.critical_paths[]
    | select((.from | startswith("posedge")) and .from == .to)).path) as $path
| def mhz: [.fmax[].achieved] | min | rounded(10);
  $mapped[0]
| .design.tools.nextpnr = $nextpnr
| .design |= . + {
    part: (($part | sub("%s"; $device | ascii_upcase | sub("^(?<size>[0-9]+)K$"; "\(.size)F")))
      + (if $grade == "" then "" else ", grade \($grade)" end)),
    $device, $package, placer: (if $placer == "" then null else $placer end), $placements,
    seed: $best,
    seeds: [$reports[] | {seed, mhz: mhz}],
    used: ($report.utilization | map_values(select(.used > 0))),
    fmax_mhz: ($report | mhz),
    critical_path: {
      from: ($path[0].to.cell | signal), to: ($path[-1].to.cell | signal),
      logic_ns: ($path | total(.type != "routing")),
      routing_ns: ($path | total(.type == "routing")),
      levels: ($path | map(select(.type == "logic")) | length),
      signals: (reduce ($path[] | select(.type == "routing").net | signal) as $net ([];
        if .[-1] == $net then . else . + [$net] end))
    }
  }
