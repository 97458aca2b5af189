# synth/report/layout.jq - what was placed and routed, as synth/layout/run says.

include "netlist";

def named: sub("^sepax_"; "");
def shown: if . == null then "-" else . end;

(["block", "cells", "die um", "cells um2", "share", "wire mm", "vias", "failed", "violations",
  "clock", "slack", "placed", "routed", "least", "hold", "larger cells"],
 (.blocks[] | [(.name | named), .cells, "\(.width_um | rounded(10)) x \(.height_um | rounded(10))",
   (.cell_um2 | round), (.cell_um2 / .die_um2 | rounded(100)), (.wire_mm | rounded(100)), .vias,
   .failed_routes, (.violations | shown), "\(.period_ns) ns", .slack_wireload_ns,
   .slack_placed_ns, .slack_routed_ns, "\(.least_routed_ns) ns", (.hold_routed_ns | shown),
   .resized_cells])
 | @tsv),
"\nslack: by the library's wire loads and an ideal clock; with the wires of the placement, and as"
  + " routed, with the clock's tree"
