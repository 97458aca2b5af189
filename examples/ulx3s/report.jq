# SPDX-License-Identifier: MIT
# What a routed design takes, out of nextpnr's report.
def row($name; $cell): .utilization[$cell] | "| \($name) | \(.used) | \(.available) |";
"| | used | of |\n| --- | --- | --- |",
row("LUT4 (with those of carry chains)"; "TRELLIS_COMB"),
row("flip-flops"; "TRELLIS_FF"),
row("MULT18X18D"; "MULT18X18D"),
row("EBR of 18 Kbit"; "DP16KD"),
row("PLL"; "EHXPLLL"),
(.fmax | to_entries[] | "clock \(.key): " +
  "\(.value.achieved * 100 | floor / 100) MHz, asked for \(.value.constraint * 100 | floor / 100)")
