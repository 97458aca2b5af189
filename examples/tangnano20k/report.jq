# SPDX-License-Identifier: MIT
# What a routed design takes, out of nextpnr's report.
def row($name; $cell): .utilization[$cell] | "| \($name) | \(.used) | \(.available) |";
"| | used | of |\n| --- | --- | --- |",
row("LUT4"; "LUT4"),
row("ALU"; "ALU"),
row("flip-flops"; "DFF"),
row("MULT18X18"; "MULT18X18"),
row("BSRAM of 18 Kbit"; "BSRAM"),
row("PLL"; "rPLL"),
(.fmax | to_entries[] | "clock \(.key): " +
  "\(.value.achieved * 100 | floor / 100) MHz, asked for \(.value.constraint * 100 | floor / 100)")
