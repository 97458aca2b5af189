/* units.c - the modules of architecture exact below its core: templates and their holes. */
#include "clearance/clearance.h"
#include "exact.h"

#include <stdlib.h>

void exact_hole(exact_holes *h, const char *name, const char *text) {
  if (h->count + 1 == EXACT_HOLES) {
    abort(); /* more holes than EXACT_HOLES */
  }
  h->hole[h->count++] = (emit_hole){name, text};
}

void exact_hole_number(exact_holes *h, const char *name, int64_t number) {
  exact_hole(h, name, h->number[h->count]);
  snprintf(h->number[h->count - 1], sizeof h->number[0], "%lld", (long long)number);
}

void exact_holes_make(exact_holes *h, const exact_plan *p) {
  const sepax_format *f = p->design->exact_format;
  const exact_stages *s = &p->stages;
  const struct {
    const char *name;
    int number;
  } row[] = {{"w", f[SEPAX_X_COORDINATE].width},
             {"s_w", f[SEPAX_X_SPAN].width},
             {"g_w", f[SEPAX_X_ORIENT2D].width},
             {"o_w", f[SEPAX_X_OWN_Z_SUM].width},
             {"v_w", f[SEPAX_X_ORIENT3D].width},
             {"digits", f[SEPAX_X_Z_SUM].digits},
             {"own_digits", f[SEPAX_X_OWN_Z_SUM].digits},
             {"shared", s->zdiff_shared},
             {"running", p->running},
             {"six", !s->zdiff_shared && !p->running},
             {"sums", s->trapezoid_sums},
             {"whole", p->limits > 0},
             {"limits", p->limits},
             {"two_limits", p->limits > 1},
             {"axis_none", SEPAX_AXIS_NONE},
             {"axis_edges", SEPAX_AXIS_EDGES},
             {"axis_normal_a", SEPAX_AXIS_NORMAL_A},
             {"axis_normal_b", SEPAX_AXIS_NORMAL_B},
             {"axis_plane", SEPAX_AXIS_PLANE},
             {"axis_aabb", SEPAX_AXIS_AABB}};
  h->count = 0;
  for (size_t i = 0; i < sizeof row / sizeof row[0]; i++) {
    exact_hole_number(h, row[i].name, row[i].number);
  }
}

void exact_template(emitter *e, const char *file, exact_holes *h) {
  h->hole[h->count] = (emit_hole){NULL, NULL};
  emit_template(e, file, h->hole);
}

static void gen_trapezoid(emitter *e, const exact_plan *p, bool order) {
  const arith_plan *multiplier = &p->stages.trapezoid;
  char name[EMIT_NAME];
  exact_holes h;
  int64_t bias = 0; /* 1 for each digit but the highest */
  for (int digit = 0; digit < multiplier->rows - 1; digit++) {
    bias = 4 * bias + 1;
  }
  arith_name(multiplier, name);
  exact_holes_make(&h, p);
  exact_hole(&h, "name", order ? "sepax_trapezoid_ab" : "sepax_trapezoid");
  exact_hole(&h, "multiplier", name);
  exact_hole_number(&h, "order", order);
  exact_hole_number(&h, "bias", bias);
  exact_hole_number(&h, "latency", 1 + p->stages.trapezoid_sums + multiplier->latency);
  exact_hole_number(&h, "clocked", multiplier->latency > 0);
  exact_template(e, "sepax_trapezoid", &h);
}

static void gen_prism(emitter *e, const exact_plan *p, const char *name,
                      const arith_plan *multiplier) {
  char multiply[EMIT_NAME];
  exact_holes h;
  arith_name(multiplier, multiply);
  exact_holes_make(&h, p);
  exact_hole(&h, "name", name);
  exact_hole(&h, "multiplier", multiply);
  exact_hole_number(&h, "z_w", multiplier->b_w);
  exact_hole_number(&h, "latency", 1 + multiplier->latency);
  exact_hole_number(&h, "two", multiplier->less == 2);
  exact_hole_number(&h, "clocked", multiplier->latency > 0);
  exact_template(e, "sepax_prism", &h);
}

static void gen_orient3d(emitter *e, const exact_plan *p) {
  static const struct {
    const char *name, *points, *formula;
    bool four, minus_r;
  } row[] = {
      {"sepax_orient3d_a", "A and a vertex of B", "p + q + r (A's own prism is zero)", false,
       false},
      {"sepax_orient3d_b", "B and a vertex of A", "p + q + r - s, s the prism of B", true, false},
      {"sepax_orient3d_edges", "an edge of A and an edge of B", "p + q - r - s", true, true}};
  int registers = p->stages.orient3d;
  for (int i = 0; i < 3; i++) {
    exact_holes h;
    exact_holes_make(&h, p);
    exact_hole(&h, "name", row[i].name);
    exact_hole(&h, "points", row[i].points);
    exact_hole(&h, "formula", row[i].formula);
    exact_hole(&h, "sum", registers > 1 ? "sum_q + carry_q" : "sum + carry");
    exact_hole_number(&h, "four", row[i].four);
    exact_hole_number(&h, "minus_r", row[i].minus_r);
    exact_hole_number(&h, "latency", 1 + (p->limits > 0 ? registers / 2 : registers));
    exact_hole_number(&h, "rows", registers > 1);
    exact_hole_number(&h, "registered", registers > 0);
    exact_template(e, i == 0 && p->running ? "sepax_running_sum" : "sepax_orient3d", &h);
  }
}

static void gen_multipliers(emitter *e, const exact_stages *s) {
  gen_multiplier_parts(e, s->zdiff_shared);
  gen_multiplier(e, &s->trapezoid);
  gen_multiplier(e, &s->prism);
  if (!arith_same(&s->own_prism, &s->prism)) { /* they are where W is odd */
    gen_multiplier(e, &s->own_prism);
  }
  if (s->zdiff_shared) {
    gen_multiplier(e, &s->prism_of_two);
  }
}

void gen_exact_units(emitter *e, const exact_plan *p) {
  exact_holes h;
  exact_holes_make(&h, p);
  exact_hole_number(&h, "z_w", p->design->exact_format[SEPAX_X_Z_SUM].width);
  exact_hole_number(&h, "latency", 1 + p->stages.own_zsum);
  exact_hole_number(&h, "registered", p->stages.own_zsum);
  gen_multipliers(e, &p->stages);
  emit_template(e, "sepax_csa", NULL);
  gen_trapezoid(e, p, false);
  if (!p->single) {
    gen_trapezoid(e, p, true);
  }
  exact_template(e, "sepax_orient2d", &h);
  exact_template(e, "sepax_own_orient2d", &h);
  exact_template(e, "sepax_zdiff", &h);
  exact_template(e, "sepax_zsum", &h);
  exact_template(e, "sepax_own_zsum", &h);
  gen_prism(e, p, "sepax_prism", &p->stages.prism);
  if (p->stages.zdiff_shared) {
    gen_prism(e, p, "sepax_prism_2", &p->stages.prism_of_two);
  }
  gen_prism(e, p, "sepax_own_prism", &p->stages.own_prism);
  gen_orient3d(e, p);
  if (p->limits > 0) {
    gen_clearance_units(e, p);
    return;
  }
  exact_template(e, "sepax_decide", &h);
  if (!p->single) {
    exact_template(e, "sepax_projection", &h);
  }
}
