# SPDX-License-Identifier: MIT
# scripts/experiments/report: `what` is "design", one of them from what
# scripts/experiments/report-task found of it, or "table"
# or "page", from report.json.

def number($text): $text | tonumber;
def of_pairs(value): [$ARGS.named.power[0].workloads[] | select(.pair_pj)
  | {key: .workload, value: value}] | from_entries;

def design:
  ($ARGS.named.area[0].design) as $d
  | ($ARGS.named.meshes
     | [scan("([0-9]+) pairs, [0-9]+ (?:mismatches|candidates)")][0][0] // "160000"
     | tonumber) as $pairs # of a tree engine: the sample objects
  | ([$ARGS.named.meshes | scan("II = [0-9]+: ([0-9]+) cycles = [0-9.]+ ms at"),
                           scan("poses, 0 mismatches, mean ([0-9]+) cycles")][0][0]
     // null) as $cycles
  | ($d.timing.period_ns // ([$d.options | capture("--clock-ns=(?<ns>[^ ]+)").ns | tonumber][0])
     // (if $d.arch == "conference" then 2.5 else 2 end)) as $period
  | ([$ARGS.named.wrong | split("\n")[1:][] | split(",") | select(.[2] == "all")
      | {pairs: number(.[3]), collisions: number(.[4]), missed: number(.[5]),
         false_alarms: number(.[9])}][0]) as $errors
  | {number: number($ARGS.named.number), variables: $ARGS.named.variables, arch: $d.arch,
     word: $d.word, ii: $d.ii, latency: $d.latency, period_ns: $period,
     timed: ($d.timing != null), met: ($d.timing.met // null), ge: $d.ge, ff: $d.ff,
     multipliers: $d.multipliers,
     tree: ($d.options | test("--tree=on")), pose_nj: $ARGS.named.power[0].workloads[0].pose_nj,
     lanes: ([$d.options | capture("--lanes=(?<k>[0-9]+)").k | tonumber][0]),
     mesh_pairs: $pairs, mesh_cycles: (if $cycles then number($cycles) else null end),
     pairs_per_s: (1e9 / $period * (if $cycles then $pairs / number($cycles) else 1 / $d.ii end)),
     simulated: [$ARGS.named.meshes, $ARGS.named.families
                 | scan("[^\n]*(?:mismatches|wrong)[^\n]*")],
     energy_pj: of_pairs(.pair_pj), energy_error: of_pairs(.error),
     errors: $errors};

# The published designs as the paper's table 4 (and section 6) has them; 81.14 mW at 500 MHz and
# II = 3.
def published: [
  {name: "conference [20]", latency: 20, clock: "2.5 ns", ge: "1961K", cost: "-",
   speed: "20 M (printed)", separated: "-", colliding: "-", missed: "not told",
   alarms: "not told", made: "paper, table 4"},
  {name: "the paper", latency: 13, clock: "2 ns", ge: "1212K", cost: "3636K", speed: "167 M",
   separated: "0.49", colliding: "0.49", missed: "not told", alarms: "not told",
   made: "paper, table 4; power: table 3; 0.96 ms"}];

def digits($n): . * pow(10; $n) | round / pow(10; $n);
def k: . / 1000 * 10 | round / 10 | tostring | if test("[.]") then . else . + ".0" end + "K";
def speed: if . >= 1e9 then "\(. / 1e9 | digits(2)) G" else "\(. / 1e6 | round) M" end;
def share($n; $of):
  if $n == 0 then "none"
  else "\($n / $of * 100 | if . >= 0.095 then digits(1) else digits(4) end) %" end;
def nj:
  if . == null then "-"
  else . / 1000 | digits(if . < 0.05 then 5 else 3 end) | tostring end;
def name:
  .variables as $v
  | if .arch == "exact"
    then (if .lanes then "engine, \(.lanes) lanes, exact"
          elif .tree then "tree engine, exact" else "**exact**" end) + ", II = \(.ii)"
      + (if $v | test("EARLY_OUT=boxes") then ", early out" else "" end)
    else "our `\(.arch)`, \($v | capture("PRECISION=(?<p>[a-z]+)").p)" end;
def entry:
  {name: name, latency: (if .lanes or .tree then "-" else .latency end),
   clock: ("\(.period_ns) ns"
           + if .timed | not then ", not timed" elif .met then "" else ", missed" end),
   ge: (.ge | k), cost: (if .lanes or .tree then "-" else .ge * .ii | k end),
   speed: (.pairs_per_s | speed),
   separated: (.energy_pj.separated | nj), colliding: (.energy_pj.colliding | nj),
   missed: share(.errors.missed; .errors.collisions),
   alarms: share(.errors.false_alarms; .errors.pairs - .errors.collisions), made: .variables};
def heads: ["design", "latency", "clock", "GE", "GE x II", "pairs/s", "nJ, separated",
  "nJ, colliding", "missed", "false alarms", "made by, or where"];
def cells: [.name, .latency, .clock, .ge, .cost, .speed, .separated, .colliding, .missed, .alarms,
  .made];
def entries: published + (.rows | map(entry));

def markdown:
  "| \(heads | join(" | ")) |", "|\(heads | map(" --- |") | join(""))",
  (entries[] | cells | map(tostring)
    | .[:-1] + [.[-1] | if startswith("ARCH=") then "`\(.)`" else . end]
    | "| \(join(" | ")) |");

def bare: gsub("[*]{2}|`"; "");
def html:
  "<table><tr>\(heads | map("<th>\(.)</th>") | join(""))</tr>",
  (entries[] | "<tr>\(cells | map("<td>\(tostring | bare | @html)</td>") | join(""))</tr>"),
  "</table>";

def tools:
  "\(.library) (1 GE = \(.nand2) = \(.nand2_area) um2); \(.yosys); OpenSTA \(.sta); "
  + "\(.verilator); sepax \(.version)" + if .commit != "" then ", commit \(.commit)" else "" end;
def hard: .rows[0].errors
  | "\(.pairs) pairs of all families of hard cases, of which \(.collisions) collide";
def section($step; $title; $command):
  $ARGS.named["\($step)_txt"] as $text
  | if $text == null then empty
    else "<h2>\($title)</h2><p><code>\($command)</code></p>",
      ($ARGS.named["\($step)_svg"] // "" | sub("^<[?]xml[^>]*>"; "")),
      "<pre>\($text | @html)</pre>" end;
def page:
  "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">"
  + "<title>sepax: every design</title>",
  "<style>body{font:15px/1.5 sans-serif;max-width:80em;margin:2em auto;padding:0 1em}"
  + "table{border-collapse:collapse;margin:1em 0}",
  "td,th{border:1px solid #ccc;padding:.2em .6em;text-align:right}"
  + "td:first-child,th:first-child,td:last-child,th:last-child{text-align:left}",
  "pre{background:#f6f6f6;padding:1em;overflow-x:auto}svg{max-width:100%;height:auto}</style>"
  + "</head><body>",
  "<h1>Every design in one table</h1>",
  "<p>W = \(.rows[-1].word). Made by <code>make report LIBERTY=\(.liberty | @html)</code> in "
  + "\(.seconds / 60 | ceil) minutes with \(tools | @html).</p>",
  html,
  "<p><b>Made by</b>: <code>make area</code> (GE, clock), <code>make power</code> (energy), "
  + "<code>make cosim</code> (speed, verdicts) with these variables. ",
  "<b>Clock</b>: the one that OpenSTA says is met, cells sized, fan-out buffered, the default wire "
  + "load of the library; <i>not timed</i>: the published one, and gates for area alone. ",
  (.rows | map(select(.lanes))[0]
   | "<b>GE</b>: area of the cells; memories of the engine are not in it. <b>Pairs/s</b>: clock / "
     + "II; of the engine the \(.mesh_pairs // "-") pairs of the sample objects in "
     + "\(.mesh_cycles // "-") cycles. "),
  (.rows | map(select(.tree))[0] | if . == null then empty else
     "Of the <b>tree engine</b>: these pairs, in the mean of 64 poses in contact: \(.mesh_cycles) "
     + "cycles, \(.pose_nj | round) nJ a pose. " end),
  "<b>nJ</b>: energy of a pair, of the mapped gates with pairs that are mostly separated or all "
  + "collide (docs/developers/power.md); the paper does not tell its pairs. ",
  "<b>Missed</b>: share of the collisions, <b>false alarms</b>: of the separated pairs, among "
  + "\(hard); each design's Verilog gave the verdicts of its golden model:</p>",
  "<pre>\(.rows | map(.variables + "\n" + (.simulated | map("  " + .) | join("\n")))
    | join("\n") | @html)</pre>",
  section("corners"; "Clock at each corner"; "make timing"),
  section("energy"; "Energy by workload and module"; "make power"),
  section("thresholds"; "Multi-Vt"; "make experiment NAME=multivt"),
  section("lanes"; "The engine over its lanes, and on meshes"; "make experiment NAME=engine-sweep"),
  section("scene"; "A core for a scene"; "make experiment NAME=scene"),
  section("errors"; "Speed against error"; "make experiment NAME=accuracy QUICK=1"),
  section("clearance"; "Conservative clearance"; "make experiment NAME=clearance"),
  "</body></html>";

if $ARGS.named.what == "design" then design
elif $ARGS.named.what == "table" then markdown
else page end
