# synth/report/multivt.jq - leakage and total power of a design, all fast and multi-Vt, as
# synth/multivt/assign says.

include "netlist";

def mw: if . >= 1e-4 then "\(. * 1e6 | round / 1000) mW" else "\(. * 1e9 | round / 1000) uW" end;
def saved($percent): "\($percent) %";
# What table 3 of the paper would save in all, where leakage is 26.02 of 100.16 mW.
def of_the_papers_total: . * 26.02 / 100.16 | rounded(100);

"\(.design.arch), W = \(.design.word), II = \(.design.ii), \(.period_ns) ns; \(.library), "
  + "OpenSTA \(.tools.sta); \(.activity) transitions of an input a cycle",
(["", "leakage", "total", "slack", "slow cells", "low-leakage library"],
 ["all fast", (.before.leakage_w | mw), (.before.total_w | mw),
  "\(.before.slack_ns | rounded(10000)) ns", "0 of \(.cells)", .low_leakage],
 ["multi-Vt", (.after.leakage_w | mw), (.after.total_w | mw), "\(.after.slack_ns) ns",
  "\(.low_leakage_cells) of \(.cells)", .low_leakage],
 ["saving", saved(.leakage_saving_percent), saved(.total_saving_percent), "", "", .low_leakage],
 ["with leakage 26.0 % of the total", saved(.leakage_saving_percent),
  saved(.leakage_saving_percent | of_the_papers_total), "", "computed", .low_leakage],
 ["paper, table 3, low", "26.02 mW", "100.16 mW", "", "", "TN40G"],
 ["paper, table 3, low and high", "13.76 mW", "81.14 mW", "", "", "TN40G"],
 ["saving", "47.12 %", "18.99 %", "", "", "TN40G"] | @tsv)
