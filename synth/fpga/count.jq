# SPDX-License-Identifier: MIT
# synth/fpga/count.jq - what synth/fpga/map found: cells of Yosys' `stat -json`, the design
# ($design) as a row of build/fpga.json. $top is the design's module, $whole that around it.

include "netlist";

$families[0][$target] as $family
| ["lut", "ff", "carry", "dsp", "bram"] as $classes
# How many of a class a type of cell is; null: it is none of the class.
| def worth($class; $type):
    first($family[$class] | to_entries[] | select(.key as $k | $type | test("^(\($k))$")).value);
  def cells($name): .modules | to_entries[]
    | select(.key | ltrimstr("\\") == $name).value.num_cells_by_type;
  def counted: to_entries as $cells
    | [$classes[] | . as $class
       | {key: ., value: ([$cells[] | (worth($class; .key) // 0) * .value] | add // 0)}]
    | from_entries;
  cells($top) as $own
| (if $whole == $top then null else cells($whole) | with_entries(select(.key != $top)) end)
  as $around
| $design[0] as $d
| def number_of($name; $otherwise): [$d | option($name)][0] // null
    | if . == null then $otherwise else tonumber end;
  {
    unknown: ([$own, $around // {} | keys[] | . as $type
      | select([($classes + ["other"])[] | worth(.; $type)] | length == 0)] | unique
      - (if $whole != $top then [$top] else [] end)),
    fpga: {
      design: ({
        $target, family: $family.family, part: $family.part,
        arch: $d.arch, word: $d.word, ii: $d.ii,
        lanes: number_of("lanes"; null), cores: number_of("cores"; 1),
        options: $d.options, latency: $d.latency, clock_ns: $period,
        asked_mhz: (1000 / $period | rounded(10))
      } + ($own | counted) + {
        cells: $own,
        pins: (if $around then $around | counted else null end),
        fmax_mhz: null,
        tools: {yosys: ($yosys | split(" (")[0]), nextpnr: null}
      })
    }
  }
