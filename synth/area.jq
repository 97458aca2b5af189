# area.json from the modules as read ($rtl), their cells as mapped
# ($count), the cells of the library ($cells) and the design ($design).

def rounded: . * 1000 | round / 1000;

# What differs: a name used for several modules gets the first parameter that tells
# them apart, or all that differ: "sepax_dot (C_W=38)".
def binary: reduce (explode[] - 48) as $bit (0; . * 2 + $bit);
def readable($modules):
  ($modules | to_entries | map({
    key,
    name: (.value.attributes.hdlname // .key | ltrimstr("\\")),
    parameters: (.value.parameter_default_values // {} | map_values(binary))
  }))
  | group_by(.name) | map(
      . as $same
      | [$same[0].parameters | keys_unsorted[] as $p
         | {$p, values: [$same[].parameters[$p]] | unique | length} | select(.values > 1)] as $differ
      | (($differ | map(select(.values == ($same | length)))[:1]) as $first
         | if $first == [] then $differ else $first end | map(.p)) as $shown
      | $same[] | . as $m
      | {key, value: (if $shown == [] then .name
          else "\(.name) (\($shown | map("\(.)=\($m.parameters[.])") | join(", ")))" end)})
  | from_entries;

# How many instances of each module there are below the top, the top being one.
def instances($modules; $top):
  def count($m): if $m == $top then 1 else
    [$modules | to_entries[] | select(.value[$m]) | .value[$m] * count(.key)] | add // 0 end;
  $modules | with_entries(.value = count(.key));

def table: split("\n") | map(select(. != "") | split(" "));

($cells | table | map({key: .[0], value: {area: (.[1] | tonumber), ff: (.[2] | tonumber)}})
  | from_entries) as $cell
| (reduce ($count | table)[] as [$m, $type, $n] ({}; .[$m][$type] += ($n | tonumber))) as $modules
| readable($rtl[0].modules) as $name
| instances($modules; $top) as $count
| [$modules | to_entries[] | .key as $m
   | [.value | to_entries[] | select($cell[.key])] as $own
   | ([$own[] | .value * $cell[.key].area] | add // 0) as $area
   | {
       name: ($name[$m] // $m),
       instances: $count[$m],
       ge: ($area / $nand2_area | rounded),
       ge_total: ($area * $count[$m] / $nand2_area | rounded),
       ff: ([$own[] | .value * $cell[.key].ff] | add // 0),
       area: ($area * $count[$m])
     }
  ] as $rows
| $design[0] as $d
| {
    library: $library,
    nand2: $nand2,
    nand2_area: $nand2_area,
    tools: {yosys: $yosys},
    design: {
      arch: $d.arch,
      word: $d.word,
      ii: $d.ii,
      precision: ($d.options | capture("--precision=(?<p>[^ ]+)").p),
      options: $d.options,
      latency: $d.latency,
      area: ([$rows[].area] | add | rounded),
      ge: ([$rows[].ge_total] | add | rounded),
      ff: ([$rows[] | .ff * .instances] | add),
      modules: ($rows | map(del(.area)) | sort_by(-.ge_total, .name))
    }
  }
