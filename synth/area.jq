# What synth/area found, from the modules as read ($rtl), the number of cells in each as
# mapped ($count), the library ($cells) and the design ($design).

def table: split("\n") | map(select(. != "") | split(" "));
def rounded: . * 1000 | round / 1000;
def binary: reduce (explode[] - 48) as $bit (0; . * 2 + $bit);

# Names of the modules to read. Variants of one module get the first parameter that
# tells them apart, or all that differ: "sepax_dot (C_W=38)".
def readable:
  to_entries
  | map({
      key,
      name: (.value.attributes.hdlname // .key | ltrimstr("\\")),
      parameters: (.value.parameter_default_values // {} | map_values(binary))
    })
  | group_by(.name)
  | map(
      . as $variants
      | [.[0].parameters | keys_unsorted[] as $p
          | {$p, values: ([$variants[].parameters[$p]] | unique | length)} | select(.values > 1)]
      | . as $differ
      | (map(select(.values == ($variants | length)))[:1] | if . == [] then $differ else . end)
      | map(.p) as $shown
      | $variants[]
      | .parameters as $value
      | {key, value: (.name + if $shown == [] then ""
          else " (" + ($shown | map("\(.)=\($value[.])") | join(", ")) + ")" end)}
    )
  | from_entries;

# How often each module stands below the top; the top stands once.
def instances($top):
  . as $modules
  | def times($m):
      if $m == $top then 1
      else [$modules | to_entries[] | select(.value[$m]) | .value[$m] * times(.key)] | add // 0
      end;
    with_entries(.value = times(.key));

($cells | table
  | map({key: .[0], value: {area: (.[1] | tonumber), ff: (.[2] | tonumber)}}) | from_entries
  ) as $cell
| (reduce ($count | table)[] as [$m, $type, $n] ({};
    if $type == "-" then .[$m] = {} else .[$m][$type] = ($n | tonumber) end)) as $modules
| ($rtl[0].modules | readable) as $name
| ($modules | instances($top)) as $instances
| ($name | map_values(gsub("[^A-Za-z0-9_]+"; "_") | rtrimstr("_"))) as $plain
| [ $modules | to_entries[] | .key as $m
    | [.value | to_entries[] | select($cell[.key])] as $own
    | ([$own[] | .value * $cell[.key].area] | add // 0) as $area
    | {
        name: $name[$m],
        instances: $instances[$m],
        ge: ($area / $nand2_area | rounded),
        ge_total: ($area * $instances[$m] / $nand2_area | rounded),
        ff: ([$own[] | .value * $cell[.key].ff] | add // 0),
        area: ($area * $instances[$m])
      }
  ] as $rows
| $design[0] as $d
| {
    unknown: ([$modules[] | keys[] | select($modules[.] == null and ($cell[.].area // 0) == 0)]
      | unique),
    names: $plain,
    repeated: [$modules | to_entries[]
      | select($instances[.key] > 1 and ([.value | keys[] | $modules[.]] | all(. == null)))
      | $plain[.key]],
    area: {
      library: $library,
      nand2: $nand2,
      nand2_area: $nand2_area,
      tools: {yosys: $yosys},
      design: {
        arch: $d.arch,
        word: $d.word,
        ii: $d.ii,
        precision: ([$d.options | capture("--precision=(?<bits>[^ ]+)").bits][0]),
        options: $d.options,
        latency: $d.latency,
        area: ([$rows[].area] | add | rounded),
        ge: ([$rows[].ge_total] | add | rounded),
        ff: ([$rows[] | .ff * .instances] | add),
        modules: ($rows | map(del(.area)) | sort_by(-.ge_total, .name))
      }
    }
  }
