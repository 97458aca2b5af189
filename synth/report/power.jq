# synth/report/power.jq - power and energy per pair of designs, as synth/power/run says.

include "netlist";

def energy: if . < 0.05 then rounded(100000) else rounded(1000) end;
def percent: . * 100 | rounded(100) | "\(.) %";
def mw: "\(. * 1000 | rounded(1000)) mW";
def extents: if .options | contains("--extent")
  then " [extents \([option("extent-a"), option("extent-b")] | join(", "))]" else "" end;
def early_out: if .options | contains("--early-out") then " [early out]" else "" end;
def lanes: [option("lanes") as $lanes | option("cores") as $cores
  | " [\($lanes) lanes\(if $cores != "1" then ", \($cores) cores" else "" end)]"][0] // "";
def tree: if .options | contains("--tree=on") then " [tree engine]" else "" end;
def name: .design | "\(.arch) W = \(.word), II = \(.ii)" + extents + early_out + lanes + tree;

([.designs[] | select(.design.arch == "paper")][0]) as $paper
| ([$paper.workloads[]? | {key: .workload, value: .pair_pj}] | from_entries) as $of_paper
| "\(.designs[0].library), OpenSTA-style sums by build/power, \(
    if any(.designs[].workloads[]; .glitch_factor) then "with" else "no" end
    ) glitches, no clock tree",
  (["design", "workload", "period", "leakage", "inside cells", "nets", "total", "registers",
    "nJ / pair", "nJ / pose", "error", "paper / it", "glitches"],
   (.designs[] | . as $d | .workloads[]
    | [($d | name), .workload, "\(.period_ns) ns", (.leakage_w | mw), (.internal_w | mw),
       (.switching_w | mw), (.total_w | mw), (.registers.total_w | mw),
       (if .pair_pj and .pose_nj == null then .pair_pj / 1000 | energy else "-" end),
       (if .pose_nj then .pose_nj | rounded(10) else "-" end),
       (if .error then .error | percent else "-" end),
       (if .undecided_percent > 1 then "beyond extents"
        elif .pair_pj and $of_paper[.workload] then $of_paper[.workload] / .pair_pj | rounded(10)
        else "-" end),
       (if .glitch_factor then "x \(.glitch_factor | rounded(100))" else "-" end)])
   | @tsv),
  "pJ a cycle by module",
  (.designs[] | . as $d | .workloads | map(.workload) as $loads
   | ([($d | name)] + $loads | @tsv),
     (. as $w | .[0].modules[0:12][].module as $m
      | [$m] + [$w[] | .period_ns as $t | .modules[] | select(.module == $m)
                | .total_w * $t * 1000 | rounded(10)] | @tsv),
     "")
