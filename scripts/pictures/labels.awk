# labels.awk - names beside the points of a log-log plot of 720 x 440, none over another or over a
# point: rows "x y name" become gnuplot's `set label` lines. A name that is not next to its point
# has a line to it.
#   -v range=LEFT:RIGHT of x; -v low, high of y as powers of ten; y = 0 is drawn at 1e-7
function log10(v) { return log(v) / log(10) }
function meets(i, x0, x1, y0, y1) {
  return x0 < box_x1[i] && box_x0[i] < x1 && y0 < box_y1[i] && box_y0[i] < y1
}
function is_free(x0, x1, y0, y1, i) {
  if (x0 < 0 || x1 > 600 || y0 < 0 || y1 > 320) return 0
  for (i = 1; i <= boxes; i++) if (meets(i, x0, x1, y0, y1)) return 0
  return 1
}
function take(x0, x1, y0, y1) {
  box_x0[++boxes] = x0; box_x1[boxes] = x1; box_y0[boxes] = y0; box_y1[boxes] = y1
}
BEGIN {
  split(range, end, ":")
  left = log10(end[1])
  right = log10(end[2])
  # Offsets in pixels from the point to the label's anchor, and how the label is aligned there.
  places = split("9,0,left -9,0,right 0,13,center 0,-13,center 6,13,left 6,-13,left " \
    "-6,13,right -6,-13,right 0,28,center 0,-28,center 6,28,left -6,28,right " \
    "6,-28,left -6,-28,right", place, " ")
}
{
  x[NR] = $1; y[NR] = $2 > 0 ? $2 : 1e-7
  px[NR] = (log10(x[NR]) - left) / (right - left) * 600
  py[NR] = (log10(y[NR]) - low) / (high - low) * 320
  $1 = $2 = ""
  name[NR] = substr($0, 3)
  take(px[NR] - 5, px[NR] + 5, py[NR] - 5, py[NR] + 5)
}
END {
  for (n = 1; n <= NR; n++) {
    width = 7 * length(name[n])
    for (p = 1; p <= places; p++) {
      split(place[p], at, ",")
      x0 = px[n] + at[1] - (at[3] == "right" ? width : at[3] == "center" ? width / 2 : 0)
      y0 = py[n] + at[2] - 7
      if (is_free(x0, x0 + width, y0, y0 + 14) || p == places) break
    }
    take(x0, x0 + width, y0, y0 + 14)
    printf "set label \"%s\" at %g,%g %s offset screen %g,%g\n", name[n], x[n], y[n], at[3], \
      at[1] / 720, at[2] / 440
    if (at[2] >= 28 || at[2] <= -28)
      printf "set arrow from %g,%g to %g,%g nohead lc rgb \"gray50\" back\n", x[n], y[n], \
        x[n] * 10 ^ (at[1] / 600 * (right - left)), \
        y[n] * 10 ^ (at[2] * 0.75 / 320 * (high - low))
  }
}
