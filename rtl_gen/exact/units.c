/* units.c - the modules of architecture exact below its core. */
#include "clearance/clearance.h"
#include "emit/template.h"
#include "exact.h"

#define NUMBER(value) gen_format("%d", (value)).text
#define LIST(...) ((emit_hole[]){__VA_ARGS__, {NULL, NULL}})

static const char *flag(bool set) { return set ? "1" : ""; }

static int width_of(const exact_plan *p, int format) { return p->design->format[format].width; }

static void gen_trapezoid(emitter *e, const exact_plan *p, bool order) {
  const arith_plan *multiplier = &p->stages.trapezoid;
  char name[EMIT_NAME];
  arith_name(multiplier, name);
  int64_t bias = 0; /* 1 for each digit but the highest */
  for (int digit = 0; digit < multiplier->rows - 1; digit++) {
    bias = 4 * bias + 1;
  }
  emit_template(e, "sepax_trapezoid",
                LIST({"name", order ? "sepax_trapezoid_ab" : "sepax_trapezoid"},
                     {"order", flag(order)}, {"w", NUMBER(width_of(p, SEPAX_X_COORDINATE))},
                     {"s_w", NUMBER(width_of(p, SEPAX_X_SPAN))},
                     {"g_w", NUMBER(width_of(p, SEPAX_X_ORIENT2D))},
                     {"bias", gen_format("%lld", (long long)bias).text},
                     {"latency", NUMBER(1 + p->stages.trapezoid_sums + multiplier->ranks)},
                     {"sums", flag(p->stages.trapezoid_sums)}, {"multiplier", name},
                     {"clocked", flag(multiplier->ranks > 0)}));
}

static void gen_zsums(emitter *e, const exact_plan *p) {
  const sepax_format *zsum = &p->design->format[SEPAX_X_Z_SUM];
  const sepax_format *own = &p->design->format[SEPAX_X_OWN_Z_SUM];
  const gen_line w = gen_format("%d", width_of(p, SEPAX_X_COORDINATE));
  const gen_line z_w = gen_format("%d", zsum->width);
  const gen_line o_w = gen_format("%d", own->width);
  const gen_line digits = gen_format("%d", zsum->digits);
  const gen_line own_digits = gen_format("%d", own->digits);
  const emit_hole hole_w = {"w", w.text};
  const emit_hole hole_z_w = {"z_w", z_w.text};
  const emit_hole hole_o_w = {"o_w", o_w.text};
  bool shared = p->stages.zdiff_shared;
  const emit_hole hole_shared = {"shared", flag(shared)};
  const emit_hole running = {"running", flag(p->running)};
  const emit_hole six = {"six", flag(!shared && !p->running)};
  const emit_hole registered = {"registered", flag(p->stages.own_zsum)};
  emit_template(e, "sepax_zdiff", LIST(hole_w, hole_z_w, {"digits", digits.text}, hole_shared));
  if (shared) {
    emit_template(e, "sepax_zsum", LIST(hole_z_w, hole_shared));
    emit_template(e, "sepax_own_zsum",
                  LIST(hole_z_w, {"diff_digits", digits.text}, hole_o_w,
                       {"digits", own_digits.text}, hole_shared, running, six, registered));
    return;
  }
  emit_template(e, "sepax_zsum", LIST(hole_w, hole_z_w, {"digits", digits.text}, hole_shared));
  if (p->running) {
    emit_template(e, "sepax_own_zsum",
                  LIST(hole_w, hole_o_w, hole_shared, running, six, registered));
  } else {
    emit_template(e, "sepax_own_zsum",
                  LIST(hole_w, hole_o_w, {"digits", own_digits.text}, hole_shared, running, six,
                       registered, {"latency", NUMBER(1 + p->stages.own_zsum)}));
  }
}

static void gen_prism(emitter *e, const exact_plan *p, const char *name,
                      const arith_plan *multiplier, int zsum) {
  char multiply[EMIT_NAME];
  arith_name(multiplier, multiply);
  emit_template(
      e, "sepax_prism",
      LIST({"name", name}, {"multiplier", multiply}, {"g_w", NUMBER(width_of(p, SEPAX_X_ORIENT2D))},
           {"z_w", NUMBER(width_of(p, zsum))}, {"v_w", NUMBER(width_of(p, SEPAX_X_ORIENT3D))},
           {"latency", NUMBER(1 + multiplier->ranks)}, {"two", flag(multiplier->less == 2)},
           {"clocked", flag(multiplier->ranks > 0)}));
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
  const gen_line v_w = gen_format("%d", width_of(p, SEPAX_X_ORIENT3D));
  bool whole = p->limits > 0;
  if (p->running) {
    emit_template(e, "sepax_running_sum", LIST({"v_w", v_w.text}));
  }
  for (int i = p->running; i < 3; i++) {
    int registers = p->stages.orient3d;
    emit_template(
        e, "sepax_orient3d",
        LIST({"name", row[i].name}, {"points", row[i].points}, {"formula", row[i].formula},
             {"four", flag(row[i].four)}, {"minus_r", flag(row[i].minus_r)}, {"v_w", v_w.text},
             {"latency", NUMBER(1 + (whole ? registers / 2 : registers))}, {"whole", flag(whole)},
             {"rows", flag(registers > 1)}, {"registered", flag(registers > 0)},
             {"sum", registers > 1 ? "sum_q + carry_q" : "sum + carry"}));
  }
}

static void gen_multipliers(emitter *e, const exact_stages *s) {
  gen_fa(e);
  gen_digits(e, s->zdiff_shared);
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
  const gen_line g_w = gen_format("%d", width_of(p, SEPAX_X_ORIENT2D));
  gen_multipliers(e, &p->stages);
  emit_template(e, "sepax_csa", NULL);
  gen_trapezoid(e, p, false);
  if (!p->single) {
    gen_trapezoid(e, p, true);
  }
  emit_template(e, "sepax_orient2d", LIST({"own", ""}, {"g_w", g_w.text}));
  emit_template(e, "sepax_orient2d", LIST({"own", "1"}, {"g_w", g_w.text}));
  gen_zsums(e, p);
  gen_prism(e, p, "sepax_prism", &p->stages.prism, SEPAX_X_Z_SUM);
  if (p->stages.zdiff_shared) {
    gen_prism(e, p, "sepax_prism_2", &p->stages.prism_of_two, SEPAX_X_Z_SUM);
  }
  gen_prism(e, p, "sepax_own_prism", &p->stages.own_prism, SEPAX_X_OWN_Z_SUM);
  gen_orient3d(e, p);
  if (p->limits > 0) {
    gen_clearance_units(e, p);
    return;
  }
  emit_template(e, "sepax_decide",
                LIST({"axis_none", NUMBER(SEPAX_AXIS_NONE)},
                     {"axis_edges", NUMBER(SEPAX_AXIS_EDGES)},
                     {"axis_normal_a", NUMBER(SEPAX_AXIS_NORMAL_A)},
                     {"axis_normal_b", NUMBER(SEPAX_AXIS_NORMAL_B)},
                     {"axis_plane", NUMBER(SEPAX_AXIS_PLANE)}));
  if (!p->single) {
    emit_template(e, "sepax_projection", NULL);
  }
}
