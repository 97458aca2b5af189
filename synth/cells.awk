# The cells of a Liberty file: name, area (0: not given), 1 if it is a flip-flop.
function flush_cell() {
  if (name != "") print name, area, ff
}
/^[ \t]*cell[ \t]*\(/ {
  flush_cell()
  name = $0
  sub(/^[^(]*\([ \t"]*/, "", name)
  sub(/[ \t"]*\).*/, "", name)
  area = ff = 0
}
/^[ \t]*area[ \t]*:/ && area == 0 {
  area = $0
  sub(/^[^:]*:[ \t"]*/, "", area)
  area += 0
}
/^[ \t]*ff(_bank)?[ \t]*\(/ { ff = 1 }
END { flush_cell() }
