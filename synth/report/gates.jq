# synth/report/gates.jq - the gates of designs, as synth/area/map counts them, beside the paper's.

include "netlist";

def share($all): . / $all * 1000 | round / 10 | tostring + " %";
def over: rounded(100) | tostring;
def clock: if .timing == null then "-" else
  "\(.timing.period_ns) ns" + if .timing.met then "" else " missed by \(-.timing.slack_ns)" end end;
def version: split("\n")[0] | split(" ")[0];
def same_choices($a; $b): ($a.options | ltrimstr("--arch=paper"))
  == ($b.options | ltrimstr("--arch=conference"))
  and $a.multipliers == $b.multipliers and $a.timing.period_ns == $b.timing.period_ns;

([.designs[] | select(.arch == "paper" and .precision == "full" and .word == 18)
  | {key: .multipliers, value: (.ge * .ii)}] | from_entries) as $full
| "\(.library): 1 GE = \(.nand2) = \(.nand2_area) um2; \(.tools.yosys | split(" (")[0])"
    + (if .tools.sta != "" then ", OpenSTA \(.tools.sta | version)" else "" end),
  "area of cells, without the clock tree; "
    + "clock: that OpenSTA says is met (-: none, area alone)\n",
  (["design", "W", "II", "precision", "multipliers", "latency", "clock", "GE", "FF", "GE x II",
    "1212K x 3 / it", "own full / it"],
   ["conference [20]", 18, "-", "?", "?", 20, "2.5 ns", "1961.0K", "-", "-", "-", "-"],
   ["paper, table 4", 18, 3, "?", "?", 13, "2 ns", "1212.0K", "-", "3636.0K", "1", "-"],
   (.designs[] | (.ge * .ii) as $cost
    | [.arch, .word, .ii, .precision, .multipliers, .latency, clock, (.ge | k), .ff, ($cost | k),
       (3636000 / $cost | over),
       (if $full[.multipliers] then $full[.multipliers] / $cost | over else "-" end)]) | @tsv),
  (.designs | map(select(.arch == "paper")) as $paper | .[] | select(.arch == "conference")
    | . as $it | $paper[] | select(same_choices(.; $it))
    | "\nconference : paper in GE, W = \(.word), \(.precision), multipliers \(.multipliers): "
      + "\($it.ge / .ge | over) (table 4: 1961K : 1212K = 1.62)"),
  (.designs[] | .ge as $all
    | "\n\(.arch), W = \(.word), II = \(.ii), \(.precision)"
      + (if .arch != "exact" then ", multipliers \(.multipliers)" else "" end)
      + (if .memory_bits then ", and memories of \(.memory_bits) bits" else "" end) + ":",
    (["module", "instances", "GE each", "GE in all", "share", "FF each"],
     (.modules[] | [.name, .instances, (.ge | round), (.ge_total | round),
       (.ge_total | share($all)), .ff]) | @tsv))
