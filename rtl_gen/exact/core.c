/* gen_exact_core.c - sepax_core: the units of the exact datapath, and what connects them. */
#include "core.h"
#include "sepax_design.h"

#include <stdlib.h>
#include <string.h>

/* ------------------------------------------------------------------------- stages */

static void declare_outputs(core *c) {
  static const exact_class_id wires[] = {
      EXACT_STRIP,      EXACT_ORDER_X, EXACT_AREA,      EXACT_WEIGHT,  EXACT_OWN,
      EXACT_OWN_WEIGHT, EXACT_PRISM,   EXACT_OWN_PRISM, EXACT_ABOVE_A, EXACT_ABOVE_B,
      EXACT_BETWEEN,    EXACT_ORDER_Z, EXACT_AREA_SIGN, EXACT_OWN_SIGN};
  bool flag = c->p->single;
  emit_text(
      c->m,
      "\n// What the units give; _q1, _q2 ... is the same, so many cycles later, _held stays\n"
      "// until it has been read.");
  for (size_t i = 0; i < sizeof wires / sizeof wires[0]; i++) {
    exact_class_id id = wires[i];
    bool sign =
        id == EXACT_ORDER_X || id == EXACT_ORDER_Z || id == EXACT_AREA_SIGN || id == EXACT_OWN_SIGN;
    bool registered = c->p->sign_rank && (id == EXACT_AREA_SIGN || id == EXACT_OWN_SIGN);
    int units = id == EXACT_ABOVE_A && c->p->running ? 3 : exact_units(c->p, id);
    for (int k = 0; k < units && !(sign && flag); k++) {
      const schedule_stream *t = &c->p->schedule.stream[c->p->class[id].stream + k];
      bool crosses = id != EXACT_ORDER_X || (k + 1) * c->ii > 6;
      bool over_edges = id != EXACT_ORDER_Z || k * c->ii < 9;
      if (crosses && over_edges) {
        emit_net(c->m, registered ? EMIT_REG : EMIT_WIRE, t->is_signed, t->name, t->width);
      }
    }
  }
  if (c->p->limits > 0) {
    core_declare_clear(c);
  }
}

static void strip_vertices(int operation, int *from, int *to) {
  int k = operation % 3;
  if (operation < 6) {
    *from = operation;
    *to = operation / 3 * 3 + (k + 1) % 3;
  } else {
    *from = k;
    *to = 3 + (k + operation / 3 - 2) % 3;
  }
}

static void strips(core *c, int projection) {
  exact_class_id id = exact_projected(EXACT_STRIP, projection);
  const char *axes = exact_projection_name(projection);
  emit_text(
      c->m,
      projection > 0
          ? "\n// The same in %s."
          : "\n// t: the area between an edge and the x axis; ox: the order of its ends in x.",
      axes);
  for (int n = 0; n < exact_units(c->p, id); n++) {
    unit u = core_unit_of(c, id, n);
    int from[SEPAX_II_MAX] = {0};
    int to[SEPAX_II_MAX] = {0};
    source text[4];
    for (int k = 0; k < u.slots; k++) {
      strip_vertices(u.operation[k], &from[k], &to[k]);
    }
    core_describe(c, &u);
    core_point(c, &u, "x_from", axes[0], from, text[0]);
    core_point(c, &u, "x_to", axes[0], to, text[1]);
    core_point(c, &u, "y_from", axes[1], from, text[2]);
    core_point(c, &u, "y_to", axes[1], to, text[3]);
    bool order = !c->p->single && (n + 1) * c->ii > 6;
    char name[EMIT_NAME];
    char more[EMIT_NAME] = "";
    snprintf(name, sizeof name, projection > 0 ? "strip_%.30s_%s" : "strip_%.30s", u.suffix, axes);
    if (order) {
      int stream = c->p->class[EXACT_ORDER_X].stream + n;
      snprintf(more, sizeof more, ", order=%.36s", c->p->schedule.stream[stream].name);
    }
    emit_instance(c->m, order ? "sepax_strip_ab" : "sepax_strip", name, "W=W, S_W=S_W, G_W=G_W",
                  "clk=clk, x_from=%s, x_to=%s, y_from=%s, y_to=%s, t=%s%s", text[0], text[1],
                  text[2], text[3], u.out->name, more);
  }
}

static void areas(core *c, int projection) {
  exact_class_id id = exact_projected(EXACT_AREA, projection);
  exact_class_id own = exact_projected(EXACT_OWN, projection);
  const char *axes = exact_projection_name(projection);
  emit_text(c->m,
            projection > 0
                ? "\n// The same in %s."
                : "\n// g: the area of a triangle of both, from the strips under its edges.",
            axes);
  for (int n = 0; n < exact_units(c->p, id); n++) {
    unit u = core_unit_of(c, id, n);
    source text[3];
    char name[EMIT_NAME];
    core_describe(c, &u);
    for (int i = 0; i < 3; i++) {
      core_operand(c, &u, i, "G_W", text[i]);
    }
    snprintf(name, sizeof name, projection > 0 ? "area_%.30s_%s" : "area_%.30s", u.suffix, axes);
    emit_instance(c->m, "sepax_area", name, "G_W=G_W", "clk=clk, p=%s, q=%s, r=%s, g=%s", text[0],
                  text[1], text[2], u.out->name);
  }
  for (int n = 0; n < exact_units(c->p, own); n++) {
    unit u = core_unit_of(c, own, n);
    source text[3];
    char name[EMIT_NAME];
    core_describe(c, &u);
    for (int i = 0; i < 3; i++) {
      core_operand(c, &u, i, "G_W", text[i]);
    }
    snprintf(name, sizeof name, projection > 0 ? "own_area_%.30s_%s" : "own_area_%.30s", u.suffix,
             axes);
    emit_instance(c->m, "sepax_own_area", name, "G_W=G_W", "clk=clk, p=%s, q=%s, r=%s, g=%s",
                  text[0], text[1], text[2], u.out->name);
  }
}

/* Of an edge of A and a vertex of B: from A's third vertex to that. */
static void rise_name(const core *c, int operation, char text[EMIT_NAME]) {
  const exact_plan *p = c->p;
  snprintf(text, EMIT_NAME, "rise_%.30s",
           strchr(p->schedule.stream[p->class[EXACT_WEIGHT].stream + operation].name, '_') + 1);
}

/* II = 1: a rise, which all read, or a weight from two of them. */
static void shared_weight(core *c, const unit *u) {
  char name[EMIT_NAME];
  char rise[2][EMIT_NAME];
  int operation = u->operation[0];
  int i = operation % 3;
  int j = i + operation % 9 / 3;
  if (operation < 9) {
    int third[SEPAX_II_MAX] = {(i + 2) % 3};
    int vertex[SEPAX_II_MAX] = {3 + j % 3};
    source p;
    source r;
    core_describe(c, u);
    core_point(c, u, "p", 'z', vertex, p);
    core_point(c, u, "r", 'z', third, r);
    rise_name(c, operation, rise[0]);
    emit_net(c->m, EMIT_WIRE, true, rise[0], "Z_W");
    snprintf(name, sizeof name, "of_%.40s", rise[0]);
    emit_instance(c->m, "sepax_rise", name, "W=W, Z_W=Z_W, DIGITS=DIGITS",
                  "clk=clk, z_p=%s, z_r=%s, z=%s, rise=%s", p, r, u->out->name, rise[0]);
  } else {
    core_describe(c, u);
    rise_name(c, exact_edge_area(i + 2, j), rise[0]);
    rise_name(c, exact_edge_area(i, j + 1), rise[1]);
    snprintf(name, sizeof name, "weight_%.30s", u->suffix);
    emit_instance(c->m, "sepax_weight", name, "Z_W=Z_W", "clk=clk, rise_pr=%s, rise_qs=%s, z=%s",
                  rise[0], rise[1], u->out->name);
  }
}

/* B's weight, from all z at once, or one vertex of each triangle a cycle. */
static void own_weight(core *c) {
  unit u = core_unit_of(c, EXACT_OWN_WEIGHT, 0);
  source z[6];
  emit_blank(c->m);
  if (c->p->running) {
    u.slots = 3;
    for (int t = 0; t < 2; t++) {
      int vertex[SEPAX_II_MAX];
      for (int k = 0; k < 3; k++) {
        vertex[k] = 3 * t + (u.start + k) % 3;
      }
      core_point(c, &u, t == 0 ? "a" : "b", 'z', vertex, z[t]);
    }
    emit_instance(c->m, "sepax_own_weight", "own_weight", "W=W, O_W=O_W, DIGITS=OWN_DIGITS",
                  "clk=clk, first=at[%d], z_a=%s, z_b=%s, z=%s", u.start % 3, z[0], z[1],
                  u.out->name);
    return;
  }
  if (c->p->shared_rises) {
    char rise[3][EMIT_NAME];
    for (int i = 0; i < 3; i++) {
      rise_name(c, exact_edge_area(i + 1, i), rise[i]);
    }
    emit_instance(c->m, "sepax_own_weight", "own_weight",
                  "Z_W=Z_W, RISE_DIGITS=DIGITS, O_W=O_W, DIGITS=OWN_DIGITS",
                  "clk=clk, rise_1=%s, rise_2=%s, rise_3=%s, z=%s", rise[0], rise[1], rise[2],
                  u.out->name);
    return;
  }
  for (int v = 0; v < 6; v++) {
    core_coordinate(c, 'z', v, exact_z_bank(c->p, u.start), u.start, z[v]);
  }
  emit_instance(c->m, "sepax_own_weight", "own_weight", "W=W, O_W=O_W, DIGITS=OWN_DIGITS",
                "clk=clk, z_a1=%s, z_a2=%s, z_a3=%s, z_b1=%s, z_b2=%s, z_b3=%s, z=%s", z[0], z[1],
                z[2], z[3], z[4], z[5], u.out->name);
}

static void weights(core *c) {
  emit_text(c->m, "\n// z: the weights of the prisms.");
  for (int n = 0; n < exact_units(c->p, EXACT_WEIGHT); n++) {
    unit u = core_unit_of(c, EXACT_WEIGHT, n);
    if (c->p->shared_rises) {
      shared_weight(c, &u);
      continue;
    }
    int v[4][SEPAX_II_MAX] = {{0}};
    source text[4];
    char name[EMIT_NAME];
    for (int k = 0; k < u.slots; k++) {
      int operation = u.operation[k];
      int i = operation % 3;
      int r = operation % 9 / 3;
      bool edge_of_a = operation < 9;
      v[0][k] = 3 + (i + r) % 3;
      v[2][k] = (i + 2) % 3;
      v[1][k] = edge_of_a ? v[0][k] : 3 + (i + r + 1) % 3;
      v[3][k] = edge_of_a ? v[0][k] : (i + 1) % 3;
    }
    core_describe(c, &u);
    snprintf(name, sizeof name, "weight_%.30s", u.suffix);
    core_point(c, &u, "p", 'z', v[0], text[0]);
    core_point(c, &u, "r", 'z', v[2], text[2]);
    if ((n + 1) * c->ii <= 9) {
      emit_instance(c->m, "sepax_rise", name, "W=W, Z_W=Z_W, DIGITS=DIGITS",
                    "clk=clk, z_p=%s, z_r=%s, z=%s", text[0], text[2], u.out->name);
      continue;
    }
    core_point(c, &u, "q", 'z', v[1], text[1]);
    core_point(c, &u, "s", 'z', v[3], text[3]);
    emit_instance(c->m, "sepax_weight", name, "W=W, Z_W=Z_W, DIGITS=DIGITS",
                  "clk=clk, z_p=%s, z_q=%s, z_r=%s, z_s=%s, z=%s", text[0], text[1], text[2],
                  text[3], u.out->name);
  }
  own_weight(c);
}

static void sign_of(core *c, const char *sign, const char *value, const char *width,
                    const char *clocked) {
  emit_text(c->m, "%s%s %s {!%s[%s-1] && (%s != {%s{1'b0}}), %s[%s-1]};",
            clocked[0] != '\0' ? "  " : "assign ", sign, clocked[0] != '\0' ? "<=" : "=", value,
            width, value, width, value, width);
}

static void area_signs(core *c) {
  const schedule *s = &c->p->schedule;
  const exact_class *class = c->p->class;
  const char *clocked = c->p->sign_rank ? "clocked" : "";
  emit_text(c->m, "\n// gs, oz: signs {> 0, < 0} of areas and of differences in z.");
  if (c->p->sign_rank) {
    emit_text(c->m, "always @(posedge clk) begin");
  }
  for (int n = 0; n < exact_units(c->p, EXACT_AREA); n++) {
    sign_of(c, s->stream[class[EXACT_AREA_SIGN].stream + n].name,
            s->stream[class[EXACT_AREA].stream + n].name, "G_W", clocked);
  }
  for (int n = 0; n < exact_units(c->p, EXACT_OWN); n++) {
    sign_of(c, s->stream[class[EXACT_OWN_SIGN].stream + n].name,
            s->stream[class[EXACT_OWN].stream + n].name, "G_W", clocked);
  }
  if (c->p->sign_rank) {
    emit_text(c->m, "end");
  }
  emit_net(c->m, EMIT_WIRE, true, "no_rise", "Z_W");
  emit_text(c->m, "assign no_rise = {{(Z_W+2-2*DIGITS){1'b0}}, {(DIGITS-1){2'b01}}};");
  for (int n = 0; n * c->ii < 9; n++) {
    const char *z = s->stream[class[EXACT_WEIGHT].stream + n].name;
    emit_text(c->m, "assign %s = {%s > no_rise, %s < no_rise};",
              s->stream[class[EXACT_ORDER_Z].stream + n].name, z, z);
  }
}

static void prisms(core *c) {
  emit_text(c->m, "\n// h: the prisms under the triangles.");
  for (int n = 0; n < exact_units(c->p, EXACT_PRISM); n++) {
    unit u = core_unit_of(c, EXACT_PRISM, n);
    source g;
    source z;
    char name[EMIT_NAME];
    core_describe(c, &u);
    core_operand(c, &u, 0, "G_W", g);
    core_operand(c, &u, 1, "Z_W", z);
    snprintf(name, sizeof name, "prism_%.30s", u.suffix);
    bool two_less = c->p->shared_rises && n >= 9;
    emit_instance(c->m, two_less ? "sepax_prism_2" : "sepax_prism", name,
                  "G_W=G_W, Z_W=Z_W, V_W=V_W", "clk=clk, g=%s, z=%s, h=%s", g, z, u.out->name);
  }
  unit u = core_unit_of(c, EXACT_OWN_PRISM, 0);
  source g;
  source z;
  core_operand(c, &u, 0, "G_W", g);
  core_operand(c, &u, 1, "O_W", z);
  emit_instance(c->m, "sepax_own_prism", "own_prism", "G_W=G_W, O_W=O_W, V_W=V_W",
                "clk=clk, g=%s, z=%s, h=%s", g, z, u.out->name);
}

static void volumes_of(core *c, exact_class_id id, const char *module, int operands) {
  static const char *const port = "pqrs";
  for (int n = 0; n < exact_units(c->p, id); n++) {
    unit u = core_unit_of(c, id, n);
    char name[EMIT_NAME];
    char connections[512] = "clk=clk";
    core_describe(c, &u);
    for (int i = 0; i < operands; i++) {
      source text;
      core_operand(c, &u, i, "V_W", text);
      size_t used = strlen(connections);
      snprintf(connections + used, sizeof connections - used, ", %c=%s", port[i], text);
    }
    snprintf(name, sizeof name, "%s_%.30s", module + strlen("sepax_"), u.suffix);
    emit_instance(c->m, module, name, "V_W=V_W", "%s, %s=%s", connections,
                  c->p->limits > 0 ? "volume" : "sign", u.out->name);
  }
}

/* Volumes over A at II = 3: in cycle k of the prisms unit r takes the sum of unit r + 1
 * over, none in cycle 0, and adds the prism over edge k; after cycle 2 the sums are whole. */
static void running_volumes(core *c) {
  const schedule *s = &c->p->schedule;
  const exact_class *class = &c->p->class[EXACT_ABOVE_A];
  char name[EMIT_NAME];
  for (int r = 0; r < 3; r++) {
    snprintf(name, sizeof name, "sum_%d", r);
    emit_net(c->m, EMIT_WIRE, true, name, "V_W");
  }
  bool whole = c->p->limits > 0; /* the sums are the volumes, not their signs */
  for (int r = 0; r < 3; r++) {
    source sum[3];
    source prism[3];
    source p;
    source q;
    for (int k = 0; k < 3; k++) {
      snprintf(sum[k], EMIT_NAME, k == 0 ? "{V_W{1'b0}}" : "sum_%d", (r + 1) % 3);
      schedule_source(s, exact_value(c->p, EXACT_PRISM, exact_edge_area(k, r + k)),
                      class->start[0] + k, prism[k]);
    }
    snprintf(name, sizeof name, "sum_%d_p", r);
    core_choose(c, name, "V_W", true, class->start[0], 3, sum, p);
    snprintf(name, sizeof name, "sum_%d_q", r);
    core_choose(c, name, "V_W", true, class->start[0], 3, prism, q);
    snprintf(name, sizeof name, "above_a_%d", r);
    emit_instance(c->m, "sepax_above_a", name, "V_W=V_W", "clk=clk, p=%s, q=%s, sum=sum_%d", p, q,
                  r);
    snprintf(name, sizeof name, "sum_%d", r);
    if (whole) {
      emit_text(c->m, "assign %s = %s;", s->stream[class->stream + r].name, name);
    } else {
      sign_of(c, s->stream[class->stream + r].name, name, "V_W", "");
    }
  }
}

static void volumes(core *c) {
  emit_text(c->m, "\n// s, w, d: signs of the tetrahedra over A, over B, and between the edges.");
  if (c->p->running) {
    running_volumes(c);
  } else {
    volumes_of(c, EXACT_ABOVE_A, "sepax_above_a", 3);
  }
  volumes_of(c, EXACT_ABOVE_B, "sepax_above_b", 4);
  volumes_of(c, EXACT_BETWEEN, "sepax_between", 4);
}

static void bind(core *c, FILE *out, const char *port, exact_class_id id, int operation,
                 int cycle) {
  source text;
  schedule_source(&c->p->schedule, exact_value(c->p, id, operation), cycle, text);
  fprintf(out, ", %s=%s", port, text);
}

static void decide(core *c) {
  char text[4096];
  char port[EMIT_NAME];
  FILE *out = fmemopen(text, sizeof text, "w");
  if (out == NULL) {
    abort();
  }
  int cycle = c->p->verdict_cycle;
  for (int i = 0; i < 3; i++) {
    snprintf(port, sizeof port, "s_%d", i + 1);
    bind(c, out, port, EXACT_ABOVE_A, i, cycle);
    snprintf(port, sizeof port, "w_%d", i + 1);
    bind(c, out, port, EXACT_ABOVE_B, i, cycle);
    for (int j = 0; j < 3; j++) {
      snprintf(port, sizeof port, "d_%d%d", i + 1, j + 1);
      bind(c, out, port, EXACT_BETWEEN, exact_between(i, j), cycle);
    }
  }
  fclose(out);
  emit_text(c->m, "\n// The verdict, in cycle %d of a pair.", cycle);
  emit_instance(c->m, "sepax_decide", "decide", "",
                "second=%s, in_plane=in_plane, coplanar=coplanar, axis=axis%s",
                c->p->single ? "1'b0" : "second", text);
}

static void plane(core *c) {
  char text[4096];
  char port[EMIT_NAME];
  FILE *out = fmemopen(text, sizeof text, "w");
  if (out == NULL) {
    abort();
  }
  int cycle = c->p->plane_cycle;
  bind(c, out, "g_b", EXACT_OWN_SIGN, 0, cycle);
  bind(c, out, "g_a", EXACT_OWN_SIGN, 1, cycle);
  for (int i = 0; i < 3; i++) {
    for (int j = 0; j < 3; j++) {
      snprintf(port, sizeof port, "g_a%d_b%d", i + 1, j + 1);
      bind(c, out, port, EXACT_AREA_SIGN, exact_edge_area(i, j), cycle);
      snprintf(port, sizeof port, "g_b%d_a%d", j + 1, i + 1);
      bind(c, out, port, EXACT_AREA_SIGN, exact_vertex_area(i, j), cycle);
      snprintf(port, sizeof port, "x_%d%d", i + 1, j + 1);
      bind(c, out, port, EXACT_ORDER_X, exact_cross_strip(i, j), cycle);
      snprintf(port, sizeof port, "z_%d%d", i + 1, j + 1);
      bind(c, out, port, EXACT_ORDER_Z, exact_edge_area((i + 1) % 3, j), cycle);
    }
  }
  fclose(out);
  emit_text(c->m, "\n// The pair as if coplanar, in cycle %d.", cycle);
  emit_instance(c->m, "sepax_plane", "plane", "",
                "flat=flat, apart=apart, apart_x=apart_x, apart_z=apart_z%s", text);
}

/* ----------------------------------------------------------------------- the module */

static void ports(core *c) {
  emit_module *m = c->m;
  char bits[16];
  snprintf(bits, sizeof bits, "%d", c->p->design->core_word);
  emit_signal(m, EMIT_INPUT, false, "clk", "", "clock");
  if (c->ii > 1) {
    char turns[16];
    snprintf(turns, sizeof turns, "%d", c->ii);
    emit_signal(m, EMIT_INPUT, false, "at", turns, "bit k: cycle k of the frame, one-hot");
  }
  for (int v = 0; v < 6; v++) {
    for (int axis = 'x'; axis <= 'z'; axis++) {
      char name[EMIT_NAME];
      snprintf(name, sizeof name, "in_%s_%c", core_vertex_name(v), axis);
      emit_signal(m, EMIT_INPUT, true, name, bits, "taken at the end of a frame");
    }
  }
  if (!c->p->single) {
    emit_signal(m, EMIT_INPUT, false, "again", "",
                "take the pair in the last banks once more, u for x and z for y");
    emit_signal(m, EMIT_OUTPUT, false, "flat", "", "in cycle %d: all areas are zero",
                c->p->plane_cycle);
    emit_signal(m, EMIT_OUTPUT, false, "apart", "", "with it: separated in the projection");
    emit_signal(m, EMIT_OUTPUT, false, "apart_x", "", "with it: boxes disjoint in x");
    emit_signal(m, EMIT_OUTPUT, false, "apart_z", "", "with it: boxes disjoint in z");
    emit_signal(m, EMIT_INPUT, false, "second", "", "in cycle %d: the pair's second pass",
                c->p->verdict_cycle);
  }
  if (c->p->limits > 0) {
    emit_signal(m, EMIT_OUTPUT, false, "coplanar", "", "in cycle %d: all volumes are zero",
                c->p->verdict_cycle);
    emit_signal(m, EMIT_OUTPUT, false, "band", "2", "with it: 0 free, 1 warning, 2 collision");
    emit_signal(m, EMIT_OUTPUT, false, "axis", "4", "with it: the axis that proves the band, or 0");
    return;
  }
  emit_signal(m, EMIT_INPUT, false, "in_plane", "", "in cycle %d: separated if coplanar",
              c->p->verdict_cycle);
  emit_signal(m, EMIT_OUTPUT, false, "coplanar", "",
              "in cycle %d: all volumes are zero, or a second pass", c->p->verdict_cycle);
  emit_signal(m, EMIT_OUTPUT, false, "axis", "4", "in cycle %d: the axis that separates, or 0",
              c->p->verdict_cycle);
}

static void widths(core *c) {
  static const struct {
    const char *name;
    int format;
    const char *about;
  } row[] = {{"W", SEPAX_X_COORDINATE, "bits of a coordinate"},
             {"S_W", SEPAX_X_SPAN, "of a sum or difference of two"},
             {"G_W", SEPAX_X_ORIENT2D, "of twice an area"},
             {"Z_W", SEPAX_X_Z_SUM, "of a weight"},
             {"O_W", SEPAX_X_OWN_Z_SUM, "of B's weight"},
             {"V_W", SEPAX_X_ORIENT3D, "of six times a volume"}};
  for (size_t i = 0; i < sizeof row / sizeof row[0]; i++) {
    emit_parameter(c->m, EMIT_LOCALPARAM, row[i].name, c->p->design->format[row[i].format].width,
                   row[i].about);
  }
  emit_parameter(c->m, EMIT_LOCALPARAM, "DIGITS", c->p->design->format[SEPAX_X_Z_SUM].digits,
                 "radix-4 digits of a weight");
  emit_parameter(c->m, EMIT_LOCALPARAM, "OWN_DIGITS",
                 c->p->design->format[SEPAX_X_OWN_Z_SUM].digits, "of B's weight");
  if (c->p->limits > 0) {
    const sepax_format *f = c->p->design->format;
    emit_parameter(c->m, EMIT_LOCALPARAM, "LIMITS", c->p->limits, "clearances");
    emit_parameter(c->m, EMIT_LOCALPARAM, "C_W", f[SEPAX_X_CROSS].width,
                   "bits of a component of e x f");
    emit_parameter(c->m, EMIT_LOCALPARAM, "L_W", f[SEPAX_X_LIMIT].width, "of a limit");
    emit_parameter(c->m, EMIT_LOCALPARAM, "M_W", c->p->limits * f[SEPAX_X_EDGE_LIMIT].width,
                   "of an edge's limits in one projection");
  }
}

static int first_volumes(const exact_plan *p) {
  int first = p->class[EXACT_ABOVE_A].start[0];
  for (exact_class_id id = EXACT_ABOVE_B; id <= EXACT_BETWEEN; id++) {
    for (int k = 0; k < exact_units(p, id); k++) {
      first = p->class[id].start[k] < first ? p->class[id].start[k] : first;
    }
  }
  return first;
}

void gen_exact_every(const exact_plan *p, char text[24]) {
  if (p->design->config.ii == 1) {
    snprintf(text, 24, "cycle");
  } else {
    snprintf(text, 24, "%d cycles", p->design->config.ii);
  }
}

void gen_exact_core(emitter *e, const exact_plan *p) {
  char banner[1024];
  char every[24];
  gen_exact_every(p, every);
  snprintf(banner, sizeof banner,
           "The exact datapath: signs of the 15 tetrahedra of the six vertices from 34\n"
           "products, a pair every %s. Names say which vertices: t_a1b2 is the strip\n"
           "under the edge from A_1 to B_2, g_a1b2b3 the area of that triangle, h the prism\n"
           "over it.\n"
           "  cycle %2d  strips t (15 products in %d multipliers)\n"
           "  cycle %2d  areas g and weights z\n"
           "  cycle %2d  prisms h (19 products in %d multipliers)\n"
           "  cycle %2d  volumes\n"
           "  cycle %2d  the verdict\n"
           "Cycle 0 is the first in which a pair stands in the first banks.",
           every, p->class[EXACT_STRIP].start[0], exact_units(p, EXACT_STRIP),
           p->class[EXACT_AREA].start[0], p->class[EXACT_PRISM].start[0],
           exact_units(p, EXACT_PRISM) + 1, first_volumes(p), p->verdict_cycle);
  core c = {.m = emit_begin(e, "sepax_core", banner), .p = p, .ii = p->design->config.ii};
  ports(&c);
  widths(&c);
  core_declare_banks(&c);
  declare_outputs(&c);
  schedule_declare(&p->schedule, c.m);
  core_clock_banks(&c);
  emit_text(c.m, "\nalways @(posedge clk) begin");
  schedule_clock(&p->schedule, c.m);
  emit_text(c.m, "end");
  for (int projection = 0; projection < (p->limits > 0 ? 3 : 1); projection++) {
    c.turn = projection > 0 ? TURN_STRIPS + projection - 1 : TURN_NONE;
    strips(&c, projection);
  }
  for (int projection = 0; projection < (p->limits > 0 ? 3 : 1); projection++) {
    c.turn = projection > 0 ? TURN_AREAS + projection - 1 : TURN_NONE;
    areas(&c, projection);
  }
  c.turn = TURN_NONE;
  weights(&c);
  if (!p->single) {
    area_signs(&c);
  }
  prisms(&c);
  volumes(&c);
  if (!p->single) {
    plane(&c);
  }
  if (p->limits > 0) {
    core_clear(&c);
    core_decide_band(&c);
  } else {
    decide(&c);
  }
  emit_end(c.m);
}
