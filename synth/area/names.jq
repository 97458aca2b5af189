# Names for the modules of a design as yosys read it: [{rtlil, readable, plain}].

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

(.modules | readable) | to_entries
| map({rtlil: .key, readable: .value,
       plain: (.value | gsub("[^A-Za-z0-9_]+"; "_") | rtrimstr("_"))})
