# SPDX-License-Identifier: MIT
# synth/fpga/dsps/exchange.awk - shorter wires of DSPs, which nextpnr places far from what they are
# wired to: one moves to a free site, or two exchange theirs, while that shortens their wires. Reads
# what wires.jq tells of a placement, writes a line a DSP: its cell's name and its site.
function away(a, b) { return a > b ? a - b : b - a }
function length_at(dsp, place, sum, k) {
  for (k = 1; k <= wires[dsp]; k++) {
    sum += away(wire_x[dsp, k], x[place]) + away(wire_y[dsp, k], y[place])
  }
  return sum + 0
}
$1 == "site" {
  sites++
  number[$2] = sites
  site[sites] = $2
  split($2, part, /[XY\/]+/)
  x[sites] = part[2]
  y[sites] = part[3]
}
$1 == "dsp" {
  dsps++
  name[dsps] = $2
  at[dsps] = number[$3]
  taken[$3] = 1
  wires[dsps] = (NF - 3) / 2
  for (k = 1; k <= wires[dsps]; k++) {
    wire_x[dsps, k] = $(2 * k + 2)
    wire_y[dsps, k] = $(2 * k + 3)
  }
}
END {
  all = dsps
  for (j = 1; j <= sites; j++) {
    if (!(site[j] in taken)) at[++all] = j # like a DSP without wires
  }
  for (i = 1; i <= dsps; i++) {
    was += length_at(i, at[i])
    for (j = 1; j <= sites; j++) far[i, j] = length_at(i, j)
  }
  do {
    better = 0
    for (i = 1; i <= dsps; i++) {
      for (j = i + 1; j <= all; j++) {
        if (far[i, at[j]] + far[j, at[i]] < far[i, at[i]] + far[j, at[j]]) {
          k = at[i]
          at[i] = at[j]
          at[j] = k
          better = 1
        }
      }
    }
  } while (better)
  for (i = 1; i <= dsps; i++) {
    print name[i], site[at[i]]
    is += far[i, at[i]]
  }
  printf "wires of %d DSPs: %d tiles, then %d\n", dsps, was, is > "/dev/stderr"
}
