# SPDX-License-Identifier: MIT
# synth/timing/corner.jq - what OpenSTA says in one corner (synth/timing/sta.tcl), its critical path
# as instances, modules and signals.
#
#   jq -L synth --rawfile log STA_LOG --slurpfile names NAMES.json --arg library NAME
#     --argjson period NS -f ... NETLIST.json
#
# A step is what a path spends in one instance of a module; its signal is the last there that has
# a name, a register's the one on its Q. Modules have the names that people read.

include "netlist";

# The name of a net, "" where it has none.
def name_of($of; $bit):
  first(.modules[$of].netnames | to_entries[] | (.value.bits | index($bit)) as $k
    | select($k != null) | if .value.bits | length > 1 then "\(.key)[\($k)]" else .key end) // ""
  | if test("^_[0-9]+_$|^fanout_") then "" else . end;

. as $netlist
| readable($names) as $readable
# Rows of the first path: delay, time, edge, pin, (cell).
| [$log | split("\npath\n")[1]
   | split("data arrival time")[0] | split("\n")[] | [splits(" +")] | map(select(. != ""))
   | select(length == 5 and (.[2] | . == "^" or . == "v"))
   | (.[3] | gsub("\\\\"; "") | split("/")) as $pin
   | (.[4] | . == "(in)" or . == "(out)") as $port
   | (if $port then [] else $pin[:-2] end) as $instance
   | ($netlist | module_at($instance)) as $of
   | {instance: ($instance | join("/")), module: ($readable[$of] // $of),
      signal: (if $port then $pin[-1] else
        $netlist | .modules[$of].cells[$pin[-2]].connections
        | (.Q // .[$pin[-1]] // [-1])[0] as $bit | $netlist | name_of($of; $bit) end),
      ns: (.[0] | tonumber), $port}] as $rows
| if $rows == [] then error("no path") else . end
| def ends: {instance, module: .module, signal};
  {from: ($rows[0] | ends), to: ($rows[-1] | ends),
   steps: (reduce range($rows | length) as $k ([];
     $rows[$k] as $row
     | ($k < ($rows | length) - 1 and ($row.port | not) and ($k > 0 or $row.ns > 0)) as $cell
     | if .[-1].instance == $row.instance then . else . + [$row | ends + {ns: 0, cells: 0}] end
     | .[-1].ns += $row.ns
     | .[-1].cells += (if $cell then 1 else 0 end)
     | if $row.signal != "" then .[-1].signal = $row.signal else . end)
   | map(select(.cells > 0) | .ns |= rounded(10000)))} as $path
# Lines that begin with a word: their second column.
| [$log | split("\n")[] | split(" ")] as $lines
| def told($word): $lines[] | select(.[0] == $word)[1];
  def number($word): told($word) | tonumber;
  number("least") as $least
| {
    $library, period_ns: $period, slack_ns: ($period - $least | rounded(10000)),
    least_period_ns: ($least | rounded(10000)), fmax_mhz: (1000 / $least * 10 | floor / 10),
    hold_slack_ns: (number("hold") | rounded(10000)),
    endpoints: ([told("endpoint")] | length), constant_endpoints: ([told("constant")] | length),
    late_endpoints: ([number("endpoint") | select(. < 0)] | length),
    most_loads: number("loads"), critical_path: $path
  }
