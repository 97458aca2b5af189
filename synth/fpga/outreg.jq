# SPDX-License-Identifier: MIT
# outreg.jq - a netlist of ECP5 as Yosys writes it in JSON, with registers at block RAMs in these:
# where each bit that a DP16KD reads goes to the D of a flip-flop of the same clock, without reset
# and with one enable for all, and nowhere else, these are the DP16KD's own output registers.
def plain($clock): .type == "TRELLIS_FF" and .connections.CLK == $clock
  and (.parameters.CLKMUX | test("^CLK *$")) and (.parameters.CEMUX | test("^(1|CE|INV) *$"))
  and .connections.LSR == ["0"] and .connections.M == null;
def enable: .parameters.CEMUX[0:1] as $mux
  | {net: (if $mux == "1" then ["1"] else .connections.CE end), inverted: ($mux == "I")};
def packed:
  .cells as $cells |
  (reduce ($cells | to_entries[] | .key as $name | .value | .port_directions as $way |
           .connections | to_entries[] | select($way[.key] == "input") | .key as $port |
           .value[] | numbers | [tostring, $name, $port]) as [$bit, $name, $port]
     ({}; .[$bit] = if .[$bit] then ["", ""] else [$name, $port] end)) as $load |
  reduce ($cells | to_entries[] | select(.value.type == "DP16KD")) as {key: $ram, value: $cell} (.;
    [$cell.connections | to_entries[] | select(.key | startswith("DO")) |
     .value[0] as $bit | select($bit | type == "number") | $load[$bit | tostring] as $at |
     select($at) | {port: .key, ff: $at[0], pin: $at[1]}] as $outs |
    if ($outs | length) > 0 and $cell.connections.OCEB == ["1"] and all($outs[];
         .pin == "DI" and ($cells[.ff] | plain($cell.connections.CLKB)))
       and ([$outs[] | $cells[.ff] | enable] | unique | length) == 1
    then
      ($cells[$outs[0].ff] | enable) as $enable |
      .cells[$ram].parameters += {REGMODE_A: "OUTREG", REGMODE_B: "OUTREG"} |
      reduce ("A", "B" | select(. == "B" or any($outs[].port; startswith("DOA")))) as $port (.;
        .cells[$ram].connections["OCE" + $port] = $enable.net |
        .cells[$ram].parameters["OCE" + $port + "MUX"] =
          (if $enable.inverted then "INV" else "OCE" + $port end)) |
      reduce $outs[] as $out (.;
        .cells[$ram].connections[$out.port] = $cells[$out.ff].connections.Q |
        del(.cells[$out.ff]))
    else . end);
.modules |= with_entries(.value |= packed)
