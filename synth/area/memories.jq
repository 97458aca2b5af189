# SPDX-License-Identifier: MIT
# memories.jq - a design (yosys' JSON) whose memories are outside of it: the ports of each become
# ports of the module that holds it, and so on up to the top. Inputs from memories are called
# read_data_..., outputs to them to_memory_....

def plain: sub("^\\$paramod(\\$[0-9a-f]+)?\\\\"; "") | split("\\")[0];

def next_bit: [.netnames[].bits[], (.cells[].connections[][]) | numbers] | (max // 1) + 1;

def prefixed($path; $port):
  (if $port | startswith("read_data") then "read_data_" else "to_memory_" end) as $head
  | $head + ($path | gsub("[^A-Za-z0-9_]"; "_")) + "_" + ($port | ltrimstr($head));

# A module with ports {name: {direction, bits}} more.
def with_ports($more):
  .ports += $more
  | .netnames += ($more | map_values({hide_name: 0, bits, attributes: {}}));

# Of one module: its memories' ports and those that its instances have got. `extra`: of all
# modules below {name: {port: {direction, width}}}.
def evert($all; $extra; $memory):
  . as $was
  | reduce (.cells | to_entries[] | select($all[.value.type])) as $cell (
      {made: $was, free: ($was | next_bit), ports: {}};
      if $cell.value.type | plain == $memory then
        .ports += ($cell.value.connections | del(.clk) | with_entries(
            .key as $port
            | {key: prefixed($cell.key; $port),
               value: {direction: (if $port == "read_data" then "input" else "output" end),
                       bits: .value}}))
        | del(.made.cells[$cell.key])
      else
        reduce ($extra[$cell.value.type] | to_entries[]) as $port (.;
          .free as $bit
          | [range($bit; $bit + $port.value.width)] as $bits
          | .free += $port.value.width
          | .made.cells[$cell.key].connections[$port.key] = $bits
          | .made.cells[$cell.key].port_directions[$port.key] = $port.value.direction
          | .ports[prefixed($cell.key; $port.key)] =
              {direction: $port.value.direction, bits: $bits})
      end)
  | .ports as $ports
  | {made: (.made | with_ports($ports)),
     ports: ($ports | map_values({direction, width: (.bits | length)}))};

.modules as $all
| {extra: {}, modules: {}}
| until((.modules | length) + ([$all | keys[] | select(plain == $memory)] | length)
        == ($all | length);
    reduce ($all | to_entries[] | select(.key | plain != $memory)) as $m (.;
      .extra as $extra
      | if $extra[$m.key] == null and
           all($m.value.cells[].type | select($all[.] and (plain != $memory)); $extra[.] != null)
        then ($m.value | evert($all; $extra; $memory)) as $done
          | .modules[$m.key] = $done.made | .extra[$m.key] = $done.ports
        else . end))
| {creator: "memories.jq", modules}
