# SPDX-License-Identifier: MIT
# synth/multivt/summary.jq - leakage and total power before and after, for synth/multivt/assign:
# $log is that of synth/multivt/assign.tcl, $fast and $slow are the cells of both libraries, $types
# has the number of cells of each type before and after, $timing is what synth/timing/sta says of
# the netlist after.

include "netlist";

def saving($from; $to): 1 - $to / $from | . * 100 | rounded(100);
# OpenSTA adds up in single precision: of n cells it may be n / 2^25 off.
def near($a; $b; $n): ($a / $b - 1) | . * . < (1e-3 + $n / 33554432 | . * .);

[$log | split("\n")[] | [splits(" +")]] as $lines
| def told($words): first($lines[] | select(.[:$words | length] == $words)) | .[-1] | tonumber;
  # The first sum that OpenSTA reports behind a line.
  def power($when): ($lines | index([["power", $when]])) as $at
    | first($lines[$at:][] | select(.[0] == "Total")) | map(tonumber?)
    | {leakage_w: .[2], total_w: .[3]};
  # Leakage again, from the libraries alone: every cell's own.
  ([$fast[0], $slow[0] | .leakage_unit_w as $w | .cells | map_values((.leakage // 0) * $w)]
   | add) as $leak
| def leakage: [to_entries[] | $leak[.key] * .value] | add;
  $area[0] as $a | power("before") as $from | power("after") as $to
| ($types[0].before | leakage) as $leak_before
| ($types[0].after | leakage) as $leak_after
| $timing[0].design.corners[0].slack_ns as $slack
| {
    library: $a.library, low_leakage: $low, tools: ($a.tools + {$sta}),
    design: ($a.design | {arch, word, ii, options, ge}),
    period_ns: $period, $activity, met: ($slack >= 0), rounds: told(["rounds"]),
    cells: ([$types[0].before[]] | add), low_leakage_cells: $swaps,
    before: ($from + {slack_ns: told(["slack", "before"]), cell_leakage_w: $leak_before}),
    all_low_leakage: {slack_ns: told(["slack", "all_slow"])},
    after: ($to + {slack_ns: $slack, cell_leakage_w: $leak_after}),
    leakage_saving_percent: saving($from.leakage_w; $to.leakage_w),
    total_saving_percent: saving($from.total_w; $to.total_w),
    leakage_agrees: (([$types[0].before[]] | add) as $n
      | near($leak_before; $from.leakage_w; $n) and near($leak_after; $to.leakage_w; $n))
  }
