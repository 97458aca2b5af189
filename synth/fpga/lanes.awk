# SPDX-License-Identifier: MIT
# synth/fpga/lanes.awk - gates as C: a function of bits, each of 64 lanes that are simulated at
# once. From BLIF of Yosys (write_blif -icells) with gates of one bit and $_DFF_P_ of one clock.
#
#   uint64_t gates_net[]     a net, bit by lane; what nothing drives keeps what it begins with
#   gates_settle(), gates_rise()   logic; registers
#   gates_ports[]            name of a port's bit, its net
#   gates_register[]         nets of the registers' outputs
function net(name) {
  if (!(name in number)) number[name] = nets++
  return number[name]
}
function fault(what) { print "lanes.awk: " what > "/dev/stderr"; failed = 1; exit 1 }
function function_of(i,   a, b, c, s) {
  a = "v[" in1[i] "]"; b = "v[" in2[i] "]"; s = "v[" in3[i] "]"
  if (type[i] == "AND") return a " & " b
  if (type[i] == "NAND") return "~(" a " & " b ")"
  if (type[i] == "OR") return a " | " b
  if (type[i] == "NOR") return "~(" a " | " b ")"
  if (type[i] == "XOR") return a " ^ " b
  if (type[i] == "XNOR") return "~(" a " ^ " b ")"
  if (type[i] == "ANDNOT") return a " & ~" b
  if (type[i] == "ORNOT") return a " | ~" b
  if (type[i] == "NOT") return "~" a
  if (type[i] == "BUF") return a
  if (type[i] == "MUX") return "(" a " & ~" s ") | (" b " & " s ")"
  fault("no gate " type[i])
}
BEGIN {
  net("$false"); net("$true"); net("$undef")
  driven[0] = driven[1] = 1
}
$1 == ".inputs" || $1 == ".outputs" {
  for (f = 2; f <= NF; f++) {
    port[++ports] = $f
    if ($1 == ".inputs") driven[net($f)] = 1
  }
}
$1 == ".subckt" {
  split("", of)
  for (f = 3; f <= NF; f++) {
    at = index($f, "=")
    of[substr($f, 1, at - 1)] = substr($f, at + 1)
  }
  if ($2 == "$_DFF_P_") {
    q[++registers] = net(of["Q"]); d[registers] = net(of["D"]); driven[q[registers]] = 1
    if (registers > 1 && of["C"] != clock) fault("two clocks")
    clock = of["C"]
    next
  }
  gates++
  type[gates] = $2
  gsub(/[$_]/, "", type[gates])
  in1[gates] = net(of["A"])
  in2[gates] = "B" in of ? net(of["B"]) : 0
  in3[gates] = "S" in of ? net(of["S"]) : 0
  y[gates] = net(of["Y"])
}
$1 == ".conn" || ($1 == ".names" && NF == 3) {
  type[++gates] = "BUF"; in1[gates] = net($2); in2[gates] = in3[gates] = 0; y[gates] = net($3)
}
function wait_for(i, k, n) {
  if (driven[n] || !made[n]) return
  waits[i]++
  after[i, k] = head[n]; head[n] = i SUBSEP k
}
END {
  if (failed) exit 1
  for (i = 1; i <= gates; i++) {
    if (driven[y[i]] || made[y[i]]) fault("two drivers")
    made[y[i]] = 1
  }
  for (i = 1; i <= gates; i++) {
    wait_for(i, 1, in1[i]); wait_for(i, 2, in2[i]); wait_for(i, 3, in3[i])
    if (!waits[i]) order[++ready] = i
  }
  for (at = 1; at <= ready; at++) {
    for (link = head[y[order[at]]]; link != ""; link = after[link]) {
      split(link, part, SUBSEP)
      if (--waits[part[1]] == 0) order[++ready] = part[1]
    }
  }
  if (ready != gates) fault("a loop of gates")
  print "#include <stdint.h>\n#define v gates_net"
  print "const int gates_nets = " nets ";\nuint64_t v[" nets "];"
  for (at = 1; at <= gates; at++) {
    if (at % 400 == 1) print "static void part_" ++parts "(void) {"
    print "  v[" y[order[at]] "] = " function_of(order[at]) ";"
    if (at % 400 == 0 || at == gates) print "}"
  }
  print "void gates_settle(void) {\n  v[0] = 0;\n  v[1] = ~(uint64_t)0;"
  for (i = 1; i <= parts; i++) print "  part_" i "();"
  print "}\nconst int gates_registers = " registers ";\nconst int gates_register[] = {"
  for (i = 1; i <= registers; i++) print "  " q[i] ","
  print "};\nstatic const int next_of[] = {"
  for (i = 1; i <= registers; i++) print "  " d[i] ","
  print "};\nvoid gates_rise(void) {\n  static uint64_t now[" registers "];"
  print "  for (int i = 0; i < " registers "; i++) now[i] = v[next_of[i]];"
  print "  for (int i = 0; i < " registers "; i++) v[gates_register[i]] = now[i];\n}"
  print "const struct { const char *name; int net; } gates_ports[] = {"
  for (i = 1; i <= ports; i++) print "  {\"" port[i] "\", " net(port[i]) "},"
  print "  {0, 0}};"
}
