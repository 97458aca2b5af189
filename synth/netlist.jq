# SPDX-License-Identifier: MIT
# synth/netlist.jq - a mapped netlist as synth/area/map keeps it, from Yosys' write_json:
# {modules: {NAME: {ports: {NAME: {direction, bits}}, cells: {NAME: {type, connections: {PIN:
# [BIT ...]}}}, netnames: {NAME: {bits}}}}}. A bit is a number, one net of the module, or a constant
# "0", "1". Large objects are made by from_entries: jq 1.6 copies them with each |=.

# What is kept of Yosys' own: not the library's cells, which are black boxes, nor attributes.
def of_yosys:
  def only(f): with_entries(.value |= f);
  {modules: (.modules | to_entries | map(select(.value.attributes.blackbox | not) | {key,
    value: (.value | {ports, cells: (.cells | only({type, connections})),
                      netnames: (.netnames | only({bits}))})}) | from_entries)};

# The module that no other has an instance of.
def tops: .modules as $m | [$m[].cells[].type] as $used | ($m | keys_unsorted) - $used;
def top: tops | if length == 1 then .[0] else error("several top modules: \(join(" "))") end;

# Types of cells that are no module of the netlist.
def foreign: .modules as $m | [$m[].cells[].type] | unique - ($m | keys);

# ------------------------------------------------------------------ for cells of a library

# A function as Liberty writes it, without what tells nothing.
def plain: . // "" | gsub("[ ()\"]"; "");

# Of cells, as build/liberty tells them, the inverters: {TYPE: {in, out, area}}.
def inverters: with_entries(
  (.value.pins | to_entries | map({key: (.value.direction // ""), value: .key})
   | from_entries) as $pin
  | select((.value.pins | length) == 2 and $pin.output
      and (.value.pins[$pin.output].function | plain | IN("!" + $pin.input, $pin.input + "'")))
  | .value |= {in: $pin.input, out: $pin.output, area});

# ------------------------------------------------------------------ for numbers and designs

# Rounded to so many parts of one.
def rounded($parts): . * $parts | round / $parts;

# What an option of a design says, or nothing.
def option($name): .options | capture("--\($name)=(?<value>[^ ]+)").value;

# By a module's name in the netlist the one that people read; names.json of synth/area/map.
def readable($names): $names[0] | map({key: .plain, value: .readable}) | from_entries;
