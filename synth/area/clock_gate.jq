# SPDX-License-Identifier: MIT
# synth/area/clock_gate.jq - how synth/area/gate gates a clock with the cells of a library, as
# build/liberty tells them; nothing, where it has no cells for that.
#
#   jq -L synth -r -f synth/area/clock_gate.jq CELLS.json
#
# The smallest clock gate, with a pin for test if there is one. A library without one: its smallest
# latch with an output that follows the data, one that is open while its clock is low if there is
# such, and the largest AND, as it drives the clock of a whole bank.

include "netlist";

def by_direction($direction): [.pins | to_entries[] | select(.value.direction == $direction)];

def clock_gate:
  [.[] | (.value.pins | map_values(.clock_gate) | to_entries
          | map({key: (.value // ""), value: .key}) | from_entries) as $pin
   | select($pin.clock and $pin.enable and $pin.out)
   | {cell: .key, $pin, rank: [$pin.test == null, .value.area]}] | min_by(.rank) // empty
  | "cell=\(.cell) \(.pin.clock) \(.pin.enable) \(.pin.out) \(.pin.test // "")";

def latch:
  [.[] | (.value.state | if length == 1 then .[0] else {} end) as $state
   | select($state.kind == "latch" and ($state | .clear // .preset | not) and .value.area > 0)
   | ($state.enable | plain) as $enable | ($enable | gsub("[!']"; "")) as $clock
   | ($state.data_in | plain) as $data
   | (.value | by_direction("output")
      | map(select((.value.function | plain) == ($state.names | split(",")[0] | plain)))) as $out
   | select(($out | length) > 0 and .value.pins[$clock] and .value.pins[$data])
   | {low: ($enable != $clock), area: .value.area,
      words: "\(.key) \($clock) \($data) \($out[0].key)"}]
  | min_by([(.low | not), .area]) // empty;

def and_cell:
  [.[] | (.value | by_direction("input") | map(.key)) as $in
   | (.value | by_direction("output")) as $out
   | select(($in | length) == 2 and ($out | length) == 1 and .value.area > 0)
   | select($out[0].value.function | plain | gsub("[&*]"; "")
       | IN($in[0] + $in[1], $in[1] + $in[0]))
   | {area: .value.area, words: "\(.key) \($in | join(" ")) \($out[0].key)"}]
  | max_by(.area) // empty;

.cells
| (inverters | to_entries | map(select(.value.area > 0)) | min_by(.value.area)) as $inverter
| to_entries
| [clock_gate,
   (latch as $latch | and_cell as $gates
    | if $latch.low then "" elif $inverter then
        " \($inverter.key) \($inverter.value.in) \($inverter.value.out)" else empty end
    | "latch=\($latch.words) \($gates.words)" + .)][0] // empty
