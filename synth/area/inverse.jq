# SPDX-License-Identifier: MIT
# synth/area/inverse.jq - the other outputs of registers in place of inverters, in a netlist of
# synth/netlist.jq; abc, which maps what is between registers, knows only one.
#
#   jq -L synth --slurpfile library CELLS.json -f synth/area/inverse.jq NETLIST.json > NETLIST
#
# An inverter that a register's output drives gives way to its other output. One that nothing
# reads but a register's data input goes, and the register's outputs change places.
#
# Both is done through the hierarchy: what is inverted inside of a module comes inverted through a
# port inverse_PORT_INDEX, where some instance has it so; others get an inverter outside, so that
# there are never more. So it is with what comes out of a module and is inverted outside.
#
# A net's key is "MODULE NET".

include "netlist";

$library[0].cells as $cell

# {TYPE: {in, out}}, and the smallest.
| ($cell | inverters) as $inverter
| ($inverter | to_entries | min_by(.value.area).key) as $smallest

# Flip-flops with two outputs: {TYPE: {data, other: {PIN: PIN}}}.
| ($cell | with_entries(
    (.value.state | if length == 1 then .[0] else {} end) as $state
    | select($state.kind == "ff" and ($state | .clear // .preset | not))
    | ([$state.names | scan("\\w+")]) as $names
    | (.value.pins | to_entries | map({key: (.value.function | plain), value: .key})
       | from_entries) as $pin
    | [$pin[$names[0]], $pin[$names[1]]] as [$q, $qn]
    | select($q and $qn)
    | .value |= {data: ($state.next_state | plain), other: {($q): $qn, ($qn): $q}})) as $register

| .modules as $original
| def reads($type; $pin):
    if $cell[$type] then $cell[$type].pins[$pin].direction != "output"
    else $original[$type].ports[$pin].direction != "output" end;

  # How often each net is read, in a module, also by its outputs.
  def readers:
    reduce ((.cells[] | .type as $type | .connections | to_entries[]
             | select(.key as $pin | reads($type; $pin)) | .value[] | numbers),
            (.ports[] | select(.direction == "output") | .bits[] | numbers)) as $net
      ({}; .["\($net)"] += 1);

  # A module whose registers have no outputs that nothing reads, nor data from an inverter that
  # nothing else reads.
  def turned:
    readers as $readers
    | ([.cells | to_entries[] | .key as $name | $inverter[.value.type] as $pin | select($pin)
        | .value.connections | select($readers["\(.[$pin.out][0])"] == 1)
        | {key: "\(.[$pin.out][0])", value: {$name, in: .[$pin.in]}}] | from_entries) as $before
    | (.cells | with_entries(
        $register[.value.type] as $of | select($of)
        | .value.connections |= with_entries(
            select(($of.other[.key] | not) or $readers["\(.value[0])"]))
        | $before["\(.value.connections[$of.data][0])"] as $was
        | if $was and ([.value.connections | keys[] | select($of.other[.])] | length) == 1 then
            .value |= (.turned = $was.name
              | .connections |= (.[$of.data] = $was.in | with_entries(.key |= ($of.other[.] // .))))
          else . end)) as $registers
    | ([$registers[].turned | values | {key: ., value: true}] | from_entries) as $gone
    | .next = ([.netnames[].bits[] | numbers] | max // 1) + 1
    | .cells |= (. + ($registers | map_values(del(.turned)))
                 | with_entries(select($gone[.key] | not)));

  def net_key($in): "\($in) \(.)";

  (.modules | map_values(turned)) as $modules

# What drives each net: a cell, or a port of the module.
| ([$modules | to_entries[] | .key as $in | .value
    | (.ports | to_entries[] | select(.value.direction == "input") | .value.bits[]
       | {key: net_key($in), value: "port"})] | from_entries) as $from_port
| ([$modules | to_entries[] | .key as $in | .value.ports[] | select(.direction == "output")
    | .bits[] | {key: net_key($in), value: true}] | from_entries) as $to_port
| ([$modules | to_entries[] | .key as $in | .value.cells | to_entries[] | .key as $name
    | $inverter[.value.type] as $pin | select($pin) | .value.connections
    | .[$pin.in][0] as $net | .[$pin.out][0] as $inverse | select($net | numbers)
    | {$in, $name, $net, $inverse, of: ($net | net_key($in)),
       by: ($inverse | net_key($in))}]) as $inverters

# Each bit of each port of each instance: the net inside, the net outside or a constant.
| ([$modules | to_entries[] | .key as $in | .value.cells | to_entries[]
    | .key as $name | .value as $instance | $original[$instance.type].ports // {} | to_entries[]
    | .key as $port | .value as $of | range($of.bits | length) as $i
    | ($modules[$instance.type].ports[$port].bits[$i] | numbers) as $net
    | ($instance.connections[$port][$i] // empty) as $outside
    | {$in, $name, port: "inverse_\($port)_\($i)", direction: $of.direction, $outside,
       type: $instance.type, inside: ($net | net_key($instance.type)),
       outer: ([$outside | numbers | net_key($in)][0])}]) as $links
| [$links[] | select(.direction == "input")] as $inputs
| [$links[] | select(.direction == "output" and .outer)] as $outputs

# Nets whose inverse is there: {NET: where}, a number if it is a net. An output that is an input, or
# its inverse, has none: a module would have a wire from port to port.
| def through($in; $there): any($from_port[., ($there[.] | net_key($in))]; .);
  def spread:
    . as $there
    | [($inputs[] | select($there[.inside] | not) | select($there[.outer // ""] or .outer == null)
        | .inside),
       ($outputs[] | select(($there[.outer] | not) and $there[.inside]
          and (.type as $in | .inside | through($in; $there) | not))
        | .outer)]
    | if . == [] then $there else reduce .[] as $net ($there; .[$net] = "hierarchy") | spread end;
  (reduce ($modules | to_entries[] | .key as $in | .value.cells[]
     | $register[.type].other as $other | select($other)
     | .connections | to_entries[] as $one | select($other[$one.key])
     | [($one.value[0] | net_key($in)), .[$other[$one.key]][0] // "register"])
     as [$net, $inverse] ({}; .[$net] = $inverse)
   | reduce $inverters[] as $one (.; .[$one.by] = $one.net)
   | spread) as $there

# The inverters that go, what they need, and what is inverted outside for it.
| [$inverters[] | select($there[.of]
    and (($to_port[.by] and (.in as $in | .of | through($in; $there))) | not))] as $gone
| def need:
    . as $needed
    | [($inputs[] | select($needed[.inside] and .outer and $there[.outer]) | .outer),
       ($outputs[] | select($needed[.outer]) | .inside)]
    | map(select($needed[.] | not))
    | if . == [] then $needed else reduce .[] as $net ($needed; .[$net] = true) | need end;
  (reduce ($gone[].of | select($there[.] | strings)) as $net ({}; .[$net] = true) | need) as $needed
| [$inputs[] | select($needed[.inside] and .outer and ($there[.outer] | not))
   | {in, net: .outside, of: .outer}] as $outside

# A number for each inverse that is not there yet.
| (reduce ([($needed | keys_unsorted[] | select($there[.] | type != "number")
             | {key: ., in: split(" ")[0]}),
            ($outside | unique[] | {key: .of, in})] | group_by(.in)[] | to_entries[])
     as {key: $i, value: $net} ({}; .[$net.key] = $modules[$net.in].next + $i)) as $new
| (reduce $gone[] as $one ({}; .[$one.by] = ($new[$one.of] // $there[$one.of]))) as $now
| def moved($in): $now[net_key($in)] as $to | if $to then $to | moved($in) else . end;
  def inverse($in): net_key($in) as $key | $new[$key] // ($there[$key] | numbers | moved($in));

# What each module gets: {MODULE: {CELL: {PIN: [NET]}}}, {MODULE: {PORT: {direction, bits}}}.
  [($inputs[] | select($needed[.inside])), ($outputs[] | select($needed[.outer]))] as $crossing
| (reduce $crossing[] as $link ({};
     .[$link.in][$link.name][$link.port] = [$link.outside
       | {"0": "1", "1": "0"}["\(.)"] // if type == "string" then . else inverse($link.in) end]
   )) as $pins
| (reduce $crossing[] as $link ({}; .[$link.type][$link.port] = {direction: $link.direction,
     bits: [$link.inside | split(" ")[1] | tonumber | inverse($link.type)]})) as $ports
| ([$gone[] | {in, name}] | group_by(.in) | map({key: .[0].in,
     value: (map({key: .name, value: true}) | from_entries)}) | from_entries) as $without
| ([$outside | unique[] | {in, key: "inverter_\($new[.of])", value: {type: $smallest, connections: {
     ($inverter[$smallest].in): [.net], ($inverter[$smallest].out): [$new[.of]]}}}]
   | group_by(.in) | map({key: .[0].in, value: from_entries}) | from_entries) as $with

| .modules = ($modules | with_entries(.key as $in | .value |= (
    (.ports | map_values(.bits |= map(moved($in))) + ($ports[$in] // {})) as $ports
    | (.cells | with_entries(select($without[$in][.key] | not) | .key as $name
        | .value |= (
            $register[.type].other as $other
            | .connections |= (map_values(map(moved($in)))
                + ($pins[$in][$name] // {})
                + if $other then [to_entries[] | select($other[.key])]
                    | if length == 1 and $new[.[0].value[0] | net_key($in)] then
                        {($other[.[0].key]): [.[0].value[0] | inverse($in)]} else {} end
                  else {} end)))
       + ($with[$in] // {})) as $cells
    | {ports: $ports, cells: $cells,
       netnames: (.netnames
         | with_entries(select(all(.value.bits[]; $now[net_key($in)] | not))))})))
