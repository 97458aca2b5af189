# SPDX-License-Identifier: MIT
# tables.awk - the bars of the tree engine, from sweep.csv, trees.csv and software.csv.
function grouped(x) {
  x = sprintf("%.0f", x)
  while (x ~ /^[0-9][0-9][0-9][0-9]/) {
    sub(/[0-9][0-9][0-9](,|$)/, ",&", x)
  }
  return x
}
function cold(scene, size) { return scene "," size ",3,100,cold" }
# A bar is met where the value is not above what is demanded.
function bar(what, text, value, demand) {
  printf "| %s | %s | <= %s%s |\n", what, text, demand ~ /\./ ? demand : grouped(demand), \
    (value + 0 <= demand + 0 ? "" : ": **missed**")
}
function worst(what, key, demand) {
  if (key in poses) {
    bar(what ", worst of " grouped(poses[key]), grouped(hit_worst[key]), hit_worst[key], demand)
  }
}
function one(what, key, demand) {
  if (key in poses) {
    bar(what, grouped(hit_worst[key]), hit_worst[key], demand)
  }
}
# b of the least squares of log(value) = a + b log(triangles).
function exponent(scene, value,   k, x, y, n, a, b, c, d) {
  for (k = 1; k <= sizes; k++) {
    if (cold(scene, size[k]) in poses && size[k] >= 4000) {
      x = log(size[k])
      y = log(value[cold(scene, size[k])])
      n++; a += x; b += y; c += x * x; d += x * y
    }
  }
  return n > 1 ? sprintf("%.3f", (n * d - a * b) / (n * c - a * a)) : ""
}
function rate(caches, demand,   key, value, other, last) {
  key = "free,100000,3,100," caches
  if (key in poses) {
    value = 500 * poses[key] / all[key]
    key = "holder,100000,3,100," caches
    other = key in poses ? 500 * poses[key] / all[key] : 0
    key = "gouge,100000,3,100," caches
    last = key in poses ? 500 / (free_mean[key] + between) : 0
    printf "| free poses a second, 100,000, %s: free; holder; before the gouge | %.2f M; " \
      "%.2f M; %.2f M | >= %.1f M%s |\n", caches " caches", value, other, last, demand, \
      (value >= demand && other >= demand && last >= demand ? "" : ": **missed**")
  }
}
function us(x) { return sprintf(x >= 100 ? "%.0f" : x >= 10 ? "%.1f" : "%.2f", x) }
function beside(x) { return x == "-" ? "-" : us(x) sprintf(", %.1f", x / engine) }
function row(first, key) {
  printf "| %s | %s | %d | %d | %s | %s | %s | %s | %s | %s | %s | %s |\n", scene[key], \
    grouped(triangles[key]), ii[key], latency[key], caches[key], grouped(free[key]), \
    free[key] ? grouped(free_mean[key]) : "-", free[key] ? grouped(free_p99[key]) : "-", \
    grouped(hits[key]), hits[key] ? grouped(hit_mean[key]) : "-", \
    hits[key] ? grouped(hit_worst[key]) : "-", grouped(near[key])
}

BEGIN { between = 3 } # cycles from a pose of a batch to the next
FNR == 1 { file++; next }
file == 1 {
  key = $1 "," $2 "," $3 "," $4 "," $5
  keys[++rows] = key
  scene[key] = $1; triangles[key] = $2; ii[key] = $3; latency[key] = $4; caches[key] = $5
  poses[key] = $6; free[key] = $7; free_mean[key] = $8; free_p99[key] = $9
  hits[key] = $10; hit_mean[key] = $11; hit_worst[key] = $12; near[key] = $13
  all[key] = $14; stopped[key] = $15
  if ($1 == "gouge" && $3 == 3 && $4 == 100 && $5 == "cold") { size[++sizes] = $2 }
  if (key == cold($1, $2) && $7 > 0) {
    if ($8 > most_mean) { most_mean = $8; mean_of = $1 " " grouped($2) }
    if ($9 > most_p99) { most_p99 = $9; p99_of = $1 " " grouped($2) }
  }
}
file == 2 {
  slowest = $5 > slowest ? $5 : slowest
  bytes = $4 >= 3000 && $6 > bytes ? $6 : bytes
  builds = builds sprintf("| %s, %s | %s | %s | %s |\n", $1, $3, grouped($4), $5, $6)
}
# Software: times those of the engine with cold caches.
file == 3 {
  key = cold($1, $2)
  engine = ($3 == "free" ? free_mean[key] : hit_mean[key]) / 500
  key = $1 "," $2 ",3,100,warm"
  warm = key in poses ? us(($3 == "free" ? free_mean[key] : hit_mean[key]) / 500) : "-"
  line = "| %s | %s | %s | %s | %s | %s | %s | %s | %s | %s |\n"
  software = software sprintf(line, $1, grouped($2), $3, grouped($4), us(engine), warm, \
    beside($5), beside($6), beside($7), beside($8))
  fast = $7 / engine
  fcl = $8 / engine
  own = ($7 != "-" && $7 + 0 < $5 + 0 ? $7 : $5) / engine
  if ($3 == "contact") {
    contacts++
    least_own = contacts == 1 || own < least_own ? own : least_own
    product_own += log(own)
    if ($7 != "-") {
      least_fast = fasts == 0 || fast < least_fast ? fast : least_fast
      product_fast += log(fast)
      fasts++
    }
    if ($8 != "-") {
      least_fcl = fcls == 0 || fcl < least_fcl ? fcl : least_fcl
      product_fcl += log(fcl)
      fcls++
    }
  } else {
    least_free = least_free == "" || own < least_free ? own : least_free
    most_free = own > most_free ? own : most_free
    if ($8 != "-") {
      least_far = least_far == "" || fcl < least_far ? fcl : least_far
      most_far = fcl > most_far ? fcl : most_far
    }
  }
}
END {
  print "## Bars\n"
  print "| | cycles | demand |\n| --- | --- | --- |"
  one("mould as in its files, II = 3", cold("file", 4090), 110000)
  one("the same, II = 1", "file,4090,1,100,cold", 45000)
  one("the same, II = 3, latency of 200 cycles", "file,4090,3,200,cold", 120000)
  worst("gouge, 400 triangles", cold("gouge", 400), 1500)
  if (most_mean) {
    what = "free poses, mean of the worst scene (" mean_of ")"
    bar(what, grouped(most_mean), most_mean, 3000)
    bar("99 % of them in the worst scene (" p99_of ")", grouped(most_p99), most_p99, 8000)
  }
  worst("gouge, 100,000", cold("gouge", 100000), 14000)
  worst("gouge, 1,000,000", cold("gouge", 1000000), 40000)
  key = cold("pushed", 1000000)
  one("mould, 1,000,000, pushed in, " grouped(near[key]) " near pairs", key, 350000)
  key = cold("file", 1000000)
  if (key in poses) {
    value = hit_worst[key] / near[key]
    bar("mould, 1,000,000, as in its files, " grouped(hit_worst[key]) " cycles, a near pair", \
      sprintf("%.2f", value), value, "3.1")
  }
  key = "file,1000000,3,100,budget"
  if (key in poses) {
    printf "| the same with BUDGET = 500,000 | %s | stopped, undecided%s |\n", \
      grouped(hit_worst[key] + free_mean[key]), stopped[key] ? "" : ": **missed**"
  }
  value = exponent("gouge", hit_worst)
  what = "growth from 4,000 triangles, gouge, worst: b of n^b"
  if (value != "") { bar(what, value, value, "0.55") }
  value = exponent("free", free_mean)
  if (value != "") { bar("growth, free, mean", value, value, "0.05") }
  value = exponent("gouge", free_mean)
  if (value != "") { bar("growth, free poses on the way to the gouge, mean", value, value, "0.05") }
  rate("warm", 1.5)
  rate("cold", 0.5)
  if (bytes) {
    bar("bytes a triangle, most, above 3,000 triangles", bytes, bytes, 22)
    bar("microseconds a triangle to build a tree, most", slowest, slowest, 3)
  }
  if (contacts) {
    printf "| engine at 500 MHz over the faster of bodies and trees, contact, least; " \
      "geometric mean | %.1f, %.1f | >= 8%s |\n", least_own, exp(product_own / contacts), \
      (least_own >= 8 ? "" : ": **missed**")
    if (fasts) {
      printf "| over the fast walk of the same trees, contact, least; geometric mean | %.1f, " \
        "%.1f | |\n", least_fast, exp(product_fast / fasts)
    }
    if (fcls) {
      printf "| over FCL, contact, least; geometric mean | %.1f, %.1f | >= 12, 50%s |\n", \
        least_fcl, exp(product_fcl / fcls), \
        (least_fcl >= 12 && exp(product_fcl / fcls) >= 50 ? "" : ": **missed**")
    }
    printf "| free poses: over bodies or trees, over FCL | %.1f ... %.1f, %.1f ... %.1f | |\n", \
      least_free, most_free, least_far, most_far
  }
  print "\n## Runs\n"
  print "| scene | triangles | II | latency | caches | free poses | mean | 99 % | that collide | " \
    "mean | worst | near pairs |"
  print "| --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- |"
  for (k = 1; k <= rows; k++) { row("", keys[k]) }
  if (software != "") {
    print "\n## Software\n"
    print "| scene | triangles | | poses | engine | warm | bodies | walk | fast walk | FCL |"
    print "| --- | --- | --- | --- | --- | --- | --- | --- | --- | --- |"
    printf "%s", software
  }
  if (builds != "") {
    print "\n## Trees\n"
    print "| bodies | triangles | microseconds a triangle | bytes a triangle |"
    print "| --- | --- | --- | --- |"
    printf "%s", builds
  }
}
