# SPDX-License-Identifier: MIT
# synth/multivt/swaps.jq - which cells of two libraries may take each other's place.
#
#   jq -ns -f synth/multivt/swaps.jq FAST.json LOW_LEAKAGE.json     as build/liberty prints them
#
# Makes {FAST: {cell, leakage: [FAST's, its own], ...}} of cells whose names differ in the mark of
# the threshold at their end (LVT, SVT, RVT, HVT, LL, or _L, _R, _H, _SL), with the same pins
# (names, directions, functions), the same state, the same area and, where both have one, the
# same footprint. Any other cell stays.

def stem: sub("_?(ULVT|SLVT|LVT|SVT|RVT|HVT|UHVT|lvt|svt|rvt|hvt)$"; "") as $bare
  | if $bare != . then $bare else sub("_(LL|SL|L|R|H)$"; "") end;
def alike: {area, state: [.state[] | del(.names)], pins: (.pins | map_values(del(.capacitance)))};
def by_stem: reduce (.cells | to_entries[]) as $c ({};
  ($c.key | stem) as $stem
  | if .[$stem] then
      error("\($c.key) and \(.[$stem].key) are one cell but for the threshold")
    else .[$stem] = $c end);

[inputs | by_stem] as [$fast, $low]
| [$fast | to_entries[] | .value as $f | $low[.key] | select(.) as $l
   | select(($f.value | alike) == ($l.value | alike))
   | select($f.value.footprint == null or $l.value.footprint == null
            or $f.value.footprint == $l.value.footprint)
   | {key: $f.key, value: {cell: $l.key,
                           leakage: [$f.value.leakage // 0, $l.value.leakage // 0]}}]
| if . == [] then error("no cell of one library may take another's place") else from_entries end
