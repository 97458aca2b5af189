/* SPDX-License-Identifier: MIT */
/* float_guigue.h - the predicates of guigue.h in floating point, for one type (private; float.c
 * includes it once per type, behind float_sat.h and float_interval.h). */

static int NAME(orient3d)(void *points, int p, int q, int r, int s) {
  const NAME(vec) *v = points;
  REAL volume = NAME(dot)(NAME(cross)(NAME(subtract)(v[q], v[p]), NAME(subtract)(v[r], v[p])),
                          NAME(subtract)(v[s], v[p]));
  return (volume > 0) - (volume < 0);
}

static bool NAME(coplanar)(void *points) {
  const NAME(vec) *v = points;
  NAME(vec) normal = NAME(cross)(NAME(subtract)(v[1], v[0]), NAME(subtract)(v[2], v[0]));
  return NAME(in_plane)(v, NAME(longest)(normal));
}

static bool NAME(guigue)(const sepax_tri *a, const sepax_tri *b) {
  NAME(vec) p[6];
  NAME(load)(p, a, b);
  return guigue_collide(p, NAME(orient3d), NAME(coplanar));
}
