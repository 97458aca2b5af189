# SPDX-License-Identifier: MIT
# synth/area/fanout.jq - buffer what many cells read, in a netlist of synth/netlist.jq.
#
#   jq -L synth --slurpfile library CELLS.json --argjson limit 24 --argjson drive 2 -f ...
#
# limit  a net may drive so many pins of cells
# drive  which buffer of the library, from the smallest
#
# Every net of a module that is read by more pins of cells gets a tree of buffers. Clocks
# stay as they are. abc buffers what is between its inputs and outputs, but not its inputs. A
# register that is read by more than a third as many pins (a module counts for three) becomes the
# one of twice the drive, where the library calls it X2 for X1, or _2 for _1. An inverter that only
# modules read, as that of a reset, becomes the one of drive 8.

$library[0].cells as $cell

# The buffer: one output that is its one input.
| ([$cell | to_entries[] | .key as $name | .value.area as $area
    | (.value.pins | to_entries) as $pins
    | [$pins[] | select(.value.direction == "input").key] as $in
    | [$pins[] | select(.value.direction == "output")] as $out
    | select(($in | length) == 1 and ($out | length) == 1)
    | ($out[0].value.function // "" | gsub("[ ();]"; "")) as $function
    | select($function == $in[0] or $function == "!!" + $in[0])
    | {type: $name, $area, in: $in[0], out: $out[0].key}] | sort_by(.area)) as $buffers
| if $buffers == [] then error("the library has no buffer") else . end
| $buffers[[$drive, ($buffers | length)] | min - 1] as $buffer

| ([$cell | to_entries[] | select(any(.value.state[]; .kind == "ff")).key]) as $registers
| ([$registers[] | {key: ., value: (if test("X1$") then sub("X1$"; "X2") else sub("_1$"; "_2") end)}
    | select(.key != .value and (.value | IN($registers[])))] | from_entries) as $stronger

| ([$cell | keys[]] | map({key: ., value: true}) | from_entries) as $there
| ([$cell | to_entries[] | (.value.pins | to_entries) as $pins
    | select(($pins | length) == 2 and any($pins[]; .value.direction == "output" and
        (.value.function // "" | gsub("[ ()\"]"; "") | test("^(!\\w+|\\w+')$"))))
    | {key, value: (.key | if test("X1$") then sub("X1$"; "X8") else sub("_1$"; "_8") end)}
    | select(.key != .value and $there[.value])] | from_entries) as $strong_inverter

# The buffers between a net and its readers: leaves first, the readers dealt out in order.
| def tree($readers; $base):
    (($readers | length) as $n | (($n + $limit - 1) / $limit | floor) as $groups
     | (.next + $base) as $leaf
     | .moves += [range($n) as $i | $readers[$i]
                  | {cell, pin, net: ($leaf + ($i * $groups / $n | floor))}]
     | .next += $groups
     | if $groups <= $limit then
         .buffers += [range($groups) | {from: $readers[0].net, to: ($leaf + .)}]
       else
         (($groups + $limit - 1) / $limit | floor) as $uppers
         | (.next + $base) as $upper
         | .buffers += [range($uppers) | {from: $readers[0].net, to: ($upper + .)}]
         | .buffers += [range($groups)
                        | {from: ($upper + (. * $uppers / $groups | floor)), to: ($leaf + .)}]
         | .next += $uppers
       end);

  def buffered:
    ((.ports.aclk // .ports.clk).bits[0] // -1) as $clock
    | ([.netnames[].bits[] | numbers] | max + 1) as $base
    # Rows of a cell's pin and a net, by net.
    | ([.cells | to_entries[] | .key as $name | .value.type as $type
        | $cell[$type] as $of | .value.connections | to_entries[]
        | (if $of then $of.pins[.key].direction != "output" else null end) as $reads
        | {cell: $name, $type, pin: .key, net: (.value[] | numbers), $reads,
           gated: ($of and $of.pins[.key].clock_gate == "out")}]
       | group_by(.net) | map(select(.[0].net != $clock and all(.[]; .gated | not)))) as $nets
    | ([$nets[] | select(([.[] | if .reads then 1 elif .reads == null then 3 else 0 end] | add)
                         > $limit / 3)
        | .[] | select(.reads == false and $stronger[.type])
        | {key: .cell, value: $stronger[.type]}] | from_entries) as $faster
    | ([$nets[] | select(length > 3 and all(.[]; .reads != true))
        | .[] | select(.reads == false and $strong_inverter[.type])
        | {key: .cell, value: $strong_inverter[.type]}] | from_entries + $faster) as $types
    | (reduce ($nets[] | map(select(.reads)) | select(length > $limit)) as $readers
        ({next: 0, moves: [], buffers: []}; tree($readers; $base))) as $new
    | ($new.moves | group_by(.cell) | map({key: .[0].cell,
        value: (map({key: .pin, value: [.net]}) | from_entries)}) | from_entries) as $moved
    | .cells |= with_entries(
        .key as $name
        | if $types[$name] then .value.type = $types[$name] else . end
        | if $moved[$name] then .value.connections += $moved[$name] else . end)
    | .cells += ($new.buffers | map({key: "fanout_\(.to - $base)_buffer",
        value: {type: $buffer.type,
                connections: {($buffer.in): [.from], ($buffer.out): [.to]}}}) | from_entries)
    | .netnames += ([range($new.next) | {key: "fanout_\(.)", value: {bits: [. + $base]}}]
                    | from_entries);

  .modules |= with_entries(.value |= buffered)
