# scripts/results: the tables of docs/developers/results and of README.md, from report.json (make
# report).
#   $what: readme | designs | energy

# The published designs as the paper's table 4 and section IV have them.
def published: [
  {name: "conference [20]", latency: 20, clock: "2.5 ns", ge: "1961K", cost: "-",
   speed: "20 M (printed)", missed: "not told", alarms: "not told", made: "paper, table 4"},
  {name: "the paper", latency: 13, clock: "2 ns", ge: "1212K", cost: "3636K", speed: "167 M",
   missed: "not told", alarms: "not told", made: "paper, table 4; 0.96 ms"}];

def digits($n): . * pow(10; $n) | round / pow(10; $n);
def k: . / 1000 * 10 | round / 10 | tostring | if test("[.]") then . else . + ".0" end + "K";
def speed: if . >= 1e9 then "\(. / 1e9 | digits(2)) G" else "\(. / 1e6 | round) M" end;
def share($n; $of):
  if $n == 0 then "none"
  else "\($n / $of * 100 | if . >= 0.095 then digits(1) else digits(4) end) %" end;
def nj:
  if . == null then "-" else . / 1000 | digits(if . < 0.05 then 5 else 3 end) | tostring end;
def name:
  (if .arch != "exact" then "our `\(.arch)`, \(.variables | capture("PRECISION=(?<p>[a-z]+)").p)"
   elif .lanes then "engine, \(.lanes) lanes, II = \(.ii)"
   else "**exact**, II = \(.ii)" end)
  + (if .variables | test("EARLY_OUT=boxes") then ", AABB early-out" else "" end);
def entry:
  {name: name, latency: (if .lanes then "-" else .latency end),
   clock: ("\(.period_ns) ns"
     + if .timed | not then ", not timed" elif .met then "" else ", missed" end),
   ge: (.ge | k), cost: (if .lanes then "-" else .ge * .ii | k end), speed: (.pairs_per_s | speed),
   missed: share(.errors.missed; .errors.collisions),
   alarms: share(.errors.false_alarms; .errors.pairs - .errors.collisions),
   made: "`\(.variables)`"};
def entries: published + (.rows | map(entry));

def line: "| \(map(tostring) | join(" | ")) |";
def table($heads; fields):
  ($heads | line), "|\($heads | map(" --- |") | join(""))", (entries[] | [fields] | line);
def library: .library | sub("[.]lib([.]gz)?$"; "");
def tools: "\(library), \(.yosys), OpenSTA \(.sta), \(.verilator | sub(" 2.*"; ""))";
def errors: .rows[0].errors;

def readme:
  table(["design", "latency", "clock", "GE", "pairs/s", "missed", "false alarms"];
    .name, .latency, .clock, .ge, .speed, .missed, .alarms);

def designs:
  "# Every design in one table", "",
  "W = \(.rows[-1].word), \(tools);", "1 GE = \(.nand2), \(.nand2_area) um2.", "",
  table(["design", "latency", "clock", "GE", "GE x II", "pairs/s", "missed", "false alarms",
      "made by, or where"];
    .name, .latency, .clock, .ge, .cost, .speed, .missed, .alarms, .made), "",
  "- Latency in cycles. GE: area of the cells; the engine's memories are not in it.",
  "- Clock: the period that OpenSTA says is met, cells sized, fan-out buffered, the library's wire",
  "  load. Not timed: area alone, at the published clock.",
  (.rows | map(select(.lanes))[0]
    | "- Pairs/s: clock / II; the engine's are the \(.mesh_pairs) pairs of the sample objects in",
      "  \(.mesh_cycles) cycles."),
  "- Missed: share of the collisions; false alarms: share of the separated pairs, among",
  "  \(errors.pairs) [hard pairs](../../reference/vectors.md), of which",
  "  \(errors.collisions) collide.",
  "- All of ours have the same multipliers. `make area` finds gates and clock, `make cosim` and",
  "  `make engine` speed and verdicts, with the variables of the last column.";

def error($share): if $share then " ± \($share * 100 | digits(if . < 0.1 then 2 else 1 end)) %"
  else "" end;
def ratio($paper; $pj): if $pj then " (\($paper / $pj | digits(1)))" else "" end;
def energy:
  ((.rows | map(select(.arch == "paper" and (.variables | test("=full"))))[0].energy_pj) // {})
    as $paper
  | "# Energy per pair", "",
  "nJ of the mapped gates, in brackets `paper` at full precision over it; W = 18, \(library).",
  "[How it is measured](../power.md).", "",
  (["design", "GE", "separated", "colliding", "coplanar"] | line, "|\(map(" --- |") | join(""))"),
  (.rows[] | .energy_pj as $own | .energy_error as $error
    | [name, (.ge | k), (["separated", "colliding", "coplanar"][]
        | ($own[.] | nj) + error($error[.])
          + (if $paper[.] then ratio($paper[.]; $own[.]) else "" end))] | line),
  "", "The paper states 81.14 mW at 500 MHz and II = 3, that is 0.49 nJ a pair; it does not tell",
  "the pairs.";

if $what == "readme" then readme elif $what == "designs" then designs else energy end
