# What synth/area/map found in a netlist of synth/netlist.jq, with the names of its modules ($names,
# of synth/area/names.jq), the library ($cells), the design ($design) and its timing ($timing); and
# the bits of the memories, $memory, that were moved out of it ($inside: null, or yosys' JSON
# before that).
#
# opens: inputs of clock gates that open them; of one made of a latch and an AND, an input of each.

include "netlist";

# How often each module stands below the top; the top stands once.
def instances($top):
  . as $modules
  | def times($m):
      if $m == $top then 1
      else [$modules | to_entries[] | select(.value[$m]) | .value[$m] * times(.key)] | add // 0
      end;
    with_entries(.value = times(.key));

def binary: reduce (explode[] - 48) as $bit (0; 2 * . + $bit);
def memory_bits($modules):
  . as $m
  | if sub("^\\$paramod(\\$[0-9a-f]+)?\\\\"; "") | split("\\")[0] == $memory then
      $modules[$m].parameter_default_values | (.WIDTH | binary) * pow(2; .ADDRESS | binary)
    else
      [$modules[$m].cells[].type | select($modules[.]) | memory_bits($modules)] | add // 0
    end;

$cells[0].cells as $library_cell
| ($library_cell | map_values({area: (.area // 0),
    ff: ([.state[] | select(.kind | startswith("ff"))] | length),
    latches: ([.state[] | select(.kind == "latch")] | length),
    opens: ([.pins[] | select(.clock_gate | IN("enable", "test"))] | length)}
    | if .latches > 0 then .opens = 2 else . end)) as $cell
| $library_cell[$nand2].area as $nand2_area
| count as $modules
| readable($names) as $name
| ($modules | instances($top)) as $instances
| [ $modules | to_entries[] | .key as $m
    | [.value | to_entries[] | select($cell[.key])] as $own
    | ([$own[] | .value * $cell[.key].area] | add // 0) as $area
    | {
        name: $name[$m],
        instances: $instances[$m],
        ge: ($area / $nand2_area | rounded(1000)),
        ge_total: ($area * $instances[$m] / $nand2_area | rounded(1000)),
        ff: ([$own[] | .value * $cell[.key].ff] | add // 0),
        clock_gates: ([$own[] | select($cell[.key].opens > 0).value] | add // 0),
        latches: ([$own[] | .value * $cell[.key].latches] | add // 0),
        opens: ([$own[] | .value * $cell[.key].opens] | add // 0),
        area: ($area * $instances[$m])
      }
  ] as $rows
| $design[0] as $d
| {
    unknown: ([$modules[] | keys[] | select($modules[.] == null and ($cell[.].area // 0) == 0)]
      | unique),
    repeated: [$modules | to_entries[]
      | select($instances[.key] > 1 and ([.value | keys[] | $modules[.]] | all(. == null)))
      | .key],
    area: {
      library: $library,
      nand2: $nand2,
      nand2_area: $nand2_area,
      tools: {yosys: $yosys, sta: $sta},
      design: {
        arch: $d.arch,
        word: $d.word,
        ii: $d.ii,
        precision: ([$d | option("precision")][0] // "exact"),
        options: $d.options,
        latency: $d.latency,
        timing: $timing,
        multipliers: (if $d.arch == "exact" or $multipliers != "" then "generated" else "*" end),
        area: ([$rows[].area] | add | rounded(1000)),
        ge: ([$rows[].ge_total] | add | rounded(1000)),
        ff: ([$rows[] | .ff * .instances] | add),
        clock_gates: ([$rows[] | .clock_gates * .instances] | add),
        clock_gate_inputs: ([$rows[] | .opens * .instances] | add),
        latches: ([$rows[] | .latches * .instances] | add),
        memory_bits: (if $inside[0] then $inside[0].modules as $all | $top | memory_bits($all)
                      else null end),
        modules: ($rows | map(del(.area, .opens, .latches)) | sort_by(-.ge_total, .name))
      }
    }
  }
