# SPDX-License-Identifier: MIT
# scripts/results: the tables of docs/developers/results and of README.md, from report.json (make
# report).
#   $what: readme | designs | energy

# The published designs as the paper's table 4 and section IV have them. Throughput is what every
# row of the tables means by it, clock / II; the II of the conference paper is not known.
def published: [
  {name: "conference [20]", latency: 20, clock: "2.5 ns", ge: "1961K", cost: "-",
   speed: "not stated", missed: "not stated", alarms: "not stated", made: "paper, table 4"},
  {name: "the paper", latency: 13, clock: "2 ns", ge: "1212K", cost: "3636K", speed: "167 M",
   missed: "not stated", alarms: "not stated", made: "paper, table 4 and section IV",
   in_readme: true}];

def digits($n): . * pow(10; $n) | round / pow(10; $n);
def k: . / 1000 * 10 | round / 10 | tostring | if test("[.]") then . else . + ".0" end + "K";
def speed: if . >= 1e9 then "\(. / 1e9 | digits(2)) G" else "\(. / 1e6 | round) M" end;
def share($n; $of):
  if $n == 0 then "none"
  else "\($n / $of * 100 | if . >= 0.095 then digits(1) else digits(4) end) %" end;
def nj:
  if . == null then "-" else . / 1000 | digits(if . < 0.05 then 5 else 3 end) | tostring end;
# The rows of README.md beside the paper's: paper in full precision, exact at both II and 2 ns.
def in_readme: .lanes == null and .period_ns == 2
  and (.variables | test("PRECISION=word|EARLY_OUT") | not);
def precision:
  if test("PRECISION=full") then "full precision" else "W bits a number" end;
def name:
  (if .arch != "exact" then "our `\(.arch)`, \(.variables | precision)"
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
   made: "`\(.variables)`", in_readme: in_readme};
def entries: published + (.rows | map(entry));

def line: "| \(map(tostring) | join(" | ")) |";
def table($heads; rows; fields):
  ($heads | line), "|\($heads | map(" --- |") | join(""))", (rows | [fields] | line);
def library: .library | sub("[.]lib([.]gz)?$"; "");
def tools: "\(library), \(.yosys), OpenSTA \(.sta), \(.verilator | sub(" 2.*"; ""))";
def errors: .rows[0].errors;

def readme:
  table(["design", "latency", "clock", "GE", "pairs/s", "missed", "false alarms"];
    entries[] | select(.in_readme);
    .name, .latency, .clock, .ge, .speed, .missed, .alarms);

def designs:
  "# Every design in one table", "",
  "W = \(.rows[-1].word), \(tools);", "1 GE = \(.nand2), \(.nand2_area) um2.", "",
  table(["design", "latency", "clock", "GE", "GE x II", "pairs/s", "missed", "false alarms",
      "made by, or where"]; entries[];
    .name, .latency, .clock, .ge, .cost, .speed, .missed, .alarms, .made), "",
  "- **Latency** is in cycles.",
  "- **GE** is the area of the cells in gate equivalents. The memories of the engine are not",
  "  counted.",
  "- **Clock** is the period that OpenSTA confirms, with sized cells, buffered fan-out and the",
  "  wire load of the library. If a row says \"not timed\", the design was mapped for area only,",
  "  and the clock is the published one.",
  "- **Pairs/s** is the clock frequency divided by the II, that is one pair every II cycles. (In",
  "  `exact`, a pair that needs a second pass takes the place of two pairs.) The",
  "  paper starts a pair every 3 cycles (section IV). Its table 4 prints 38.46 M for itself and",
  "  20 M for [20], because its formula (7) divides the frequency by the latency.",
  (.rows | map(select(.lanes))[0]
    | "  The figure of the engine is measured: the \(.mesh_pairs) pairs of the sample objects take",
      "  \(.mesh_cycles) cycles."),
  "- **Missed** is the share of the collisions, and **false alarms** the share of the separated",
  "  pairs, among \(errors.pairs) [hard pairs](../../reference/vectors.md), of which",
  "  \(errors.collisions) collide.",
  "- All designs of ours have multipliers from the same generator. With the variables of the last",
  "  column, `make area` finds gates and clock, and `make cosim` finds speed and verdicts.";

def error($share): if $share then " ± \($share * 100 | digits(if . < 0.1 then 2 else 1 end)) %"
  else "" end;
def ratio($paper; $pj): if $pj then " (\($paper / $pj | digits(1)))" else "" end;
def energy:
  ((.rows | map(select(.arch == "paper" and (.variables | test("=full"))))[0].energy_pj) // {})
    as $paper
  | "# Energy per pair", "",
  "Energy of the mapped gates in nJ, at W = 18, in \(library). The number in brackets says how",
  "many times as much `paper` at full precision needs.",
  "[How it is measured](../power.md).", "",
  (["design", "GE", "separated", "colliding", "coplanar"] | line, "|\(map(" --- |") | join(""))"),
  (.rows[] | .energy_pj as $own | .energy_error as $error
    | [name, (.ge | k), (["separated", "colliding", "coplanar"][]
        | ($own[.] | nj) + error($error[.])
          + (if $paper[.] then ratio($paper[.]; $own[.]) else "" end))] | line),
  "", "The paper states 81.14 mW at 500 MHz and II = 3, that is 0.49 nJ a pair. It does not state",
  "for which pairs.";

if $what == "readme" then readme elif $what == "designs" then designs else energy end
