# SPDX-License-Identifier: MIT
# synth/fpga/dsps/wires.jq - what exchange.awk reads of a design that nextpnr has placed:
#   site SITE              each place of a MULT18X18D on the device ($blocks of families.json)
#   dsp CELL SITE X Y ...  each DSP, and the tile of the other end of each of its wires

def is_data: test("^(CLK|CE|RST|SIGNED|SOURCE)[AB]?[0-9]?$") | not;
def tile: capture("^X(?<x>[0-9]+)/Y(?<y>[0-9]+)/") | "\(.x) \(.y)";
def bits($way): .port_directions as $is
  | [.connections | to_entries[] | select($is[.key] == $way and (.key | is_data)).value[]
      | tostring];

[.modules[] | select(.cells | length > 1).cells | to_entries[]
  | select(.key | test("PACKER") | not)
  | .value.attributes.NEXTPNR_BEL as $site | select($site != null)
  | {name: .key, dsp: (.value.type == "MULT18X18D"), $site,
     in: (.value | bits("input")), out: (.value | bits("output"))}] as $cells
| (reduce ($cells[] | select(.dsp | not)) as $cell ({}; reduce $cell.out[] as $bit (.;
    .[$bit] = ($cell.site | tile)))) as $drivers
| ([$cells[] | select(.dsp).out[] | {(.): []}] | add // {}) as $read
| (reduce ($cells[] | select(.dsp | not)) as $cell ($read; reduce $cell.in[] as $bit (.;
    if has($bit) then .[$bit] += [$cell.site | tile] else . end))) as $readers
| ($blocks.rows[] as $y | $blocks.columns[] as $x | (0, 1, 4, 5)
    | "site X\($x + .)/Y\($y)/MULT18_\(.)"),
  ($cells[] | select(.dsp)
    | (["dsp", .name, .site] + [.in[] | $drivers[.] // empty] + [.out[] | $readers[.][]])
    | join(" "))
