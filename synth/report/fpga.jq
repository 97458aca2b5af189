# synth/report/fpga.jq - designs mapped to FPGAs, routed or not, as synth/fpga/route says, beside
# the paper.

include "netlist";

def engine: if .lanes then ", \(.lanes) lanes" + (.options
    | capture("--memory-a=(?<a>[0-9]+)").a | ", memories of \(.)") else "" end;
def of_a_second: "\(. | rounded(10)) M";
def clock: if .fmax_mhz then "\(.fmax_mhz) MHz" else "not routed" end;
# The clock that the delay model placed registers for is met at 100 %.
def kept: if .fmax_mhz then "\(.fmax_mhz / .asked_mhz * 100 | round) %" else "-" end;
def used: .used | to_entries
  | map(select(.key | test("^(ICESTORM_(LC|RAM)|TRELLIS_(COMB|FF)|MULT18X18D|DP16KD)$"))
    | "\(.key) \(.value.used) of \(.value.available)") | join(", ");

([.designs[].tools | .yosys, (.nextpnr | if . then "nextpnr \(.)" else empty end)] | unique
  | join(", ")),
"cells of the design alone; a carry is one bit of a chain; pairs: those that the core decides\n",
(["target", "design", "W", "II", "latency", "for", "LUT", "FF", "carry", "DSP", "BRAM", "Fmax",
  "of asked", "pairs a second"],
 ["TN40G", "paper, table 4", 18, 3, 13, "2 ns", "-", "-", "-", "-", "-", "500 MHz", "-", "166.7 M"],
 (.designs[]
  | [.part, .arch + engine, .word, .ii, .latency, "\(.clock_ns) ns", .lut, .ff, .carry, .dsp, .bram,
     clock, kept, (if .fmax_mhz then .fmax_mhz * .cores / .ii | of_a_second else "-" end)]) | @tsv),
(.designs[] | select(.fmax_mhz) | .critical_path as $p
  | "\n\(.part), \(.arch)\(engine), W = \(.word), II = \(.ii): \(used); "
    + "module of pins: \(.pins.lut) LUT, \(.pins.ff) FF; seeds: "
    + ([.seeds[] | "\(.seed): \(.mhz) MHz"] | join(", ")),
    "longest path: \($p.logic_ns) ns logic, \($p.routing_ns) ns wires, from \($p.from) to \($p.to)",
    (["signals on it", ""], ($p.signals[] | [., ""]) | @tsv))
