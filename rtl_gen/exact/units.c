/* SPDX-License-Identifier: MIT */
/* units.c - the modules of architecture exact below its core: templates and their holes. */
#include "clearance.h"
#include "exact.h"

/* Which results are wires, since no register follows their units. */
static void set_chained(emit_holes *h, const exact_plan *p) {
  const exact_stages *s = &p->stages;
  unsigned chained = s->chained;
  bool own_wire = exact_is_chained(chained, EXACT_CHAIN_G) && !p->running;
  emit_hole_numbers(
      h, (emit_number[]){{"chained_t", exact_is_chained(chained, EXACT_CHAIN_T)},
                         {"chained_g", exact_is_chained(chained, EXACT_CHAIN_G)},
                         {"chained_h", exact_is_chained(chained, EXACT_CHAIN_H)},
                         {"chained_d", exact_is_chained(chained, EXACT_CHAIN_D)},
                         {"diff_wire", s->zdiff_shared || exact_is_chained(chained, EXACT_CHAIN_G)},
                         {"own_wire", own_wire},
                         {NULL, 0}});
  emit_hole_set(h, "net_g", exact_is_chained(chained, EXACT_CHAIN_G) ? "wire" : "reg ");
  emit_hole_set(h, "net_h", exact_is_chained(chained, EXACT_CHAIN_H) ? "wire" : "reg ");
  emit_hole_set(h, "net_d", exact_is_chained(chained, EXACT_CHAIN_D) ? "wire" : "reg ");
  emit_hole_set(h, "net_own", own_wire ? "wire" : "reg ");
  emit_hole_set(h, "zsum_latency",
                exact_is_chained(chained, EXACT_CHAIN_G) ? "Combinational." : "Latency 1.");
  emit_hole_set(h, "own_latency", own_wire ? "Combinational." : "Latency %d.", 1 + s->own_zsum);
}

/* What several modules ask for. Those that ask for more set it before them. */
static void set_shared(emit_holes *h, const exact_plan *p) {
  const sepax_format *f = p->design->exact_format;
  const exact_stages *s = &p->stages;
  emit_hole_numbers(h, (emit_number[]){{"w", f[SEPAX_X_COORDINATE].width},
                                       {"s_w", f[SEPAX_X_SPAN].width},
                                       {"g_w", f[SEPAX_X_ORIENT2D].width},
                                       {"z_w", f[SEPAX_X_Z_SUM].width},
                                       {"o_w", f[SEPAX_X_OWN_Z_SUM].width},
                                       {"v_w", f[SEPAX_X_ORIENT3D].width},
                                       {"digits", f[SEPAX_X_Z_SUM].digits},
                                       {"own_digits", f[SEPAX_X_OWN_Z_SUM].digits},
                                       {"shared", s->zdiff_shared},
                                       {"biased", !p->delay->family},
                                       {"chain", p->delay->family},
                                       {"running", p->running},
                                       {"six", !s->zdiff_shared && !p->running},
                                       {"running_biased", p->running && !p->own_running},
                                       {"running_diffs", p->own_running},
                                       {"coordinates", !s->zdiff_shared && !p->own_running},
                                       {"sums", s->trapezoid_sums},
                                       {"fetch_2d", s->fetch_2d},
                                       {"fetch_3d", s->fetch_3d},
                                       {"whole", p->limits > 0},
                                       {"limits", p->limits},
                                       {"gated", p->datapath.advance.gated},
                                       {"two_limits", p->limits > 1},
                                       {"ahead", exact_axis_latency(p)},
                                       {"axis_none", SEPAX_AXIS_NONE},
                                       {"axis_edges", SEPAX_AXIS_EDGES},
                                       {"axis_normal_a", SEPAX_AXIS_NORMAL_A},
                                       {"axis_normal_b", SEPAX_AXIS_NORMAL_B},
                                       {"axis_plane", SEPAX_AXIS_PLANE},
                                       {"axis_aabb", SEPAX_AXIS_AABB},
                                       {NULL, 0}});
  set_chained(h, p);
  emit_hole_set(h, "plus_bias", p->delay->family ? "" : " + BIAS");
  emit_hole_set(h, "q", p->delay->family ? "_q" : "");
  emit_hole_set(h, "band_latency", p->delay->family ? "Latency 1." : "Combinational.");
  emit_hole_set(h, "so_far", p->delay->family ? "0" : "BIAS");
}

/* What a module with a multiplier asks for. */
static void set_product(emit_holes *h, const char *name, const arith_plan *multiplier,
                        int latency) {
  emit_hole_set(h, "name", "%s", name);
  emit_hole_set(h, "multiplier", "%s", arith_name(multiplier).text);
  emit_hole_set(h, "bias", "%s", arith_bias(multiplier).text);
  emit_hole_numbers(h, (emit_number[]){{"latency", latency + multiplier->latency},
                                       {"two", multiplier->less == 2},
                                       {"clocked", multiplier->latency > 0},
                                       {NULL, 0}});
}

static void gen_trapezoid(emitter *e, const exact_plan *p, emit_holes *h, bool order) {
  int registers = exact_is_chained(p->stages.chained, EXACT_CHAIN_T) ? 0 : 1;
  set_product(h, order ? "sepax_trapezoid_ab" : "sepax_trapezoid", &p->stages.trapezoid,
              registers + p->stages.trapezoid_sums);
  emit_hole_set(h, "order", "%d", order);
  bool of_sums = exact_order_latency(p) > 1;
  emit_hole_set(h, "order_q", of_sums ? "_q" : "");
  emit_hole_set(h, "order_clocks", of_sums ? "2 clocks later" : "1 clock later");
  emit_template(e, "sepax_trapezoid", h->hole);
}

static void gen_prism(emitter *e, const exact_plan *p, emit_holes *h, const char *name,
                      const arith_plan *multiplier) {
  set_product(h, name, multiplier, exact_is_chained(p->stages.chained, EXACT_CHAIN_H) ? 0 : 1);
  emit_hole_set(h, "z_w", "%d", multiplier->b_w);
  emit_template(e, "sepax_prism", h->hole);
}

/* A sum of three terms, one a cycle. */
static void gen_running_sum(emitter *e, const exact_plan *p, emit_holes *h, bool of_prisms) {
  int of = of_prisms ? SEPAX_X_ORIENT3D : SEPAX_X_ORIENT2D;
  emit_hole_set(h, "name", of_prisms ? "sepax_orient3d_a" : "sepax_own_orient2d");
  emit_hole_set(h, "bits", of_prisms ? "V_W" : "G_W");
  emit_hole_set(h, "bits_value", "%d", p->design->exact_format[of].width);
  emit_hole_set(h, "terms",
                of_prisms ? "the signed prism volumes of the faces of a tetrahedron over A"
                          : "the trapezoid terms of the edges of A or of B");
  emit_hole_set(h, "term", of_prisms ? "signed prism volume" : "trapezoid term");
  emit_hole_set(h, "short_term", of_prisms ? "prism" : "term");
  emit_hole_set(h, "whole_sum", of_prisms ? "orient3d" : "orient2d");
  emit_template(e, "sepax_running_sum", h->hole);
}

/* A sum of operands, or of the registers that they are fetched to. */
static gen_line of_operands(const char *sum, bool fetch) {
  gen_line text = {""};
  for (; *sum != '\0'; sum++) {
    bool operand = *sum >= 'p' && *sum <= 's';
    text =
        gen_format("%s%c%s", gen_format("%s", text.text).text, *sum, operand && fetch ? "_q" : "");
  }
  return text;
}

static void gen_orient2d(emitter *e, const exact_plan *p, emit_holes *h, bool own) {
  if (own && p->own_running) {
    gen_running_sum(e, p, h, false);
    return;
  }
  emit_hole_set(h, "name", own ? "sepax_own_orient2d" : "sepax_orient2d");
  emit_hole_set(h, "plus_r", own ? "+" : "-");
  emit_hole_set(h, "own", "%d", own);
  emit_hole_set(h, "clocks_2d", "%d", exact_orient2d_latency(p));
  emit_hole_set(h, "orient2d_sum", "%s",
                of_operands(own ? "p + q + r" : "p + q - r", p->stages.fetch_2d).text);
  emit_template(e, "sepax_orient2d", h->hole);
}

static void gen_orient3d(emitter *e, const exact_plan *p, emit_holes *h) {
  static const struct {
    const char *name, *points, *formula;
    bool four, minus_r;
    const char *sum, *second, *of_both; /* on carry chains */
  } row[] = {{"sepax_orient3d_a", "A and a vertex of B", "p + q + r (A's own prism is zero)", false,
              false, "p + q + r", "r", "first_q + second_q"},
             {"sepax_orient3d_b", "B and a vertex of A", "p + q + r - s, s the prism of B", true,
              false, "p + q + r - s", "r - s", "first_q + second_q"},
             {"sepax_orient3d_edges", "an edge of A and an edge of B", "p + q - r - s", true, true,
              "p + q - r - s", "r + s", "first_q - second_q"}};
  int registers = p->stages.orient3d;
  bool chain = p->delay->family;
  emit_hole_set(h, "what", p->limits > 0 ? "orient3d" : "Sign of the orient3d");
  emit_hole_set(h, "sum", registers > 1 ? "sum_q + carry_q" : "sum + carry");
  emit_hole_numbers(h, (emit_number[]){{"latency", exact_orient3d_latency(p)},
                                       {"rows", registers > 1},
                                       {"registered", registers > 0 || p->limits > 0},
                                       {NULL, 0}});
  for (int i = 0; i < 3; i++) {
    emit_hole_set(h, "name", "%s", row[i].name);
    emit_hole_set(h, "points", "%s", row[i].points);
    emit_hole_set(h, "formula", "%s", row[i].formula);
    emit_hole_set(h, "four", "%d", row[i].four);
    emit_hole_set(h, "minus_r", "%d", row[i].minus_r);
    if (chain) {
      bool fetch = p->stages.fetch_3d;
      emit_hole_set(h, "sum", "%s",
                    registers > 1 ? row[i].of_both : of_operands(row[i].sum, fetch).text);
      emit_hole_set(h, "first", "%s", of_operands("p + q", fetch).text);
      emit_hole_set(h, "second", "%s", of_operands(row[i].second, fetch).text);
      emit_hole_set(h, "fetch_four", "%d", fetch && row[i].four);
    }
    if (i == 0 && p->running) {
      gen_running_sum(e, p, h, true);
    } else {
      emit_template(e, chain ? "sepax_orient3d_chain" : "sepax_orient3d", h->hole);
    }
  }
}

static void gen_multipliers(emitter *e, const exact_stages *s) {
  if (s->trapezoid.delay->family) {
    gen_dsp(e, s->trapezoid.delay);
  } else {
    gen_multiplier_parts(e, s->zdiff_shared);
  }
  gen_multiplier(e, &s->trapezoid);
  gen_multiplier(e, &s->prism);
  if (!arith_same(&s->own_prism, &s->prism)) { /* they are where W is odd */
    gen_multiplier(e, &s->own_prism);
  }
  if (s->zdiff_shared) {
    gen_multiplier(e, &s->prism_of_two);
  }
}

void gen_exact_units(emitter *e, const exact_plan *p, emit_holes *h) {
  static const char *const sums[] = {"sepax_zdiff", "sepax_zsum", "sepax_own_zsum"};
  const exact_stages *s = &p->stages;
  gen_multipliers(e, s);
  set_shared(h, p);
  if (!p->delay->family) {
    emit_template(e, "sepax_csa", h->hole);
  }
  gen_trapezoid(e, p, h, false);
  if (!p->single) {
    gen_trapezoid(e, p, h, true);
  }
  gen_orient2d(e, p, h, false);
  gen_orient2d(e, p, h, true);
  emit_hole_set(h, "sum",
                !p->delay->family ? s->own_zsum ? "sum_q + carry_q" : "sum + carry"
                : s->own_zsum     ? "b_q - a_q"
                                  : "wide(z_b1) + wide(z_b2) + wide(z_b3) -\n"
                                    "      wide(z_a1) - wide(z_a2) - wide(z_a3)");
  emit_hole_set(h, "registered", "%d", s->own_zsum);
  for (size_t i = 0; i < sizeof sums / sizeof sums[0]; i++) {
    emit_template(e, sums[i], h->hole);
  }
  if (s->slot_copies && p->limits == 0) { /* with a clearance it is there anyway */
    emit_template(e, "sepax_slot_copy", h->hole);
  }
  gen_prism(e, p, h, "sepax_prism", &s->prism);
  if (s->zdiff_shared) {
    gen_prism(e, p, h, "sepax_prism_2", &s->prism_of_two);
  }
  gen_prism(e, p, h, "sepax_own_prism", &s->own_prism);
  gen_orient3d(e, p, h);
  if (p->limits > 0) {
    gen_clearance_units(e, p, h);
    return;
  }
  emit_template(e, "sepax_decide", h->hole);
  if (!p->single) {
    gen_axis(e, p, h);
    emit_template(e, "sepax_projection", h->hole);
  }
}
