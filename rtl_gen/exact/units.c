/* gen_exact_units.c - the modules of architecture exact below its core. */
#include "exact.h"
#include "sepax_design.h"

#include <string.h>

static void width_parameter(emit_module *m, const char *name, int format, const char *about) {
  emit_parameter(m, EMIT_PARAMETER, name, m->emitter->design->format[format].width, about);
}

static void multiply(emit_module *m, const arith_plan *plan, const char *a, const char *b,
                     const char *p) {
  char name[EMIT_NAME];
  arith_name(plan, name);
  emit_instance(m, name, "multiply", "", "%sa=%s, b=%s, p=%s", plan->ranks > 0 ? "clk=clk, " : "",
                a, b, p);
}

/* With `order`, the sign of the difference in x comes out, too. */
static void gen_strip(emitter *e, const exact_plan *p, bool order) {
  char banner[512];
  snprintf(banner, sizeof banner,
           "Twice the area between an edge and the x axis in the projection on x and y:\n"
           "t = (x_to - x_from) (y_from + y_to - K) modulo 2^G_W, the axis moved by K / 2 as the\n"
           "multiplier likes it; areas do not depend on K. Latency %d.%s",
           p->class[EXACT_STRIP].latency,
           order ? "\nBeside it the order of the edge's ends in x." : "");
  emit_module *m = emit_begin(e, order ? "sepax_strip_ab" : "sepax_strip", banner);
  width_parameter(m, "W", SEPAX_X_COORDINATE, "bits of a coordinate");
  width_parameter(m, "S_W", SEPAX_X_SPAN, "bits of a sum or difference, W + 1");
  width_parameter(m, "G_W", SEPAX_X_ORIENT2D, "bits of t");
  emit_signal(m, EMIT_INPUT, false, "clk", "", "clock");
  static const char *const port[] = {"x_from", "x_to", "y_from", "y_to"};
  for (int i = 0; i < 4; i++) {
    emit_signal(m, EMIT_INPUT, true, port[i], "W", "coordinate");
  }
  emit_signal(m, EMIT_OUTPUT_REG, true, "t", "G_W", "twice the area under the edge");
  if (order) {
    emit_signal(m, EMIT_OUTPUT_REG, false, "order", "2",
                "{x_to > x_from, x_to < x_from}, 1 clock later");
  }
  emit_net(m, EMIT_WIRE, true, "run", "S_W");
  emit_net(m, EMIT_WIRE, true, "height", "S_W");
  emit_net(m, EMIT_WIRE, true, "product", "G_W");
  emit_text(m, "\nassign run = {x_to[W-1], x_to} - {x_from[W-1], x_from};\n"
               "assign height = {y_to[W-1], y_to} + {y_from[W-1], y_from};\n");
  if (p->strip_rank) {
    emit_net(m, EMIT_REG, true, "run_q", "S_W");
    emit_net(m, EMIT_REG, true, "height_q", "S_W");
    emit_text(m, "\nalways @(posedge clk) begin\n  run_q <= run;\n  height_q <= height;\nend\n");
  }
  multiply(m, &p->strip_mul, p->strip_rank ? "run_q" : "run", p->strip_rank ? "height_q" : "height",
           "product");
  emit_text(m, "\nalways @(posedge clk) begin\n  t <= product;");
  if (order) {
    emit_text(m, "  order <= {!run[S_W-1] && (run != {S_W{1'b0}}), run[S_W-1]};");
  }
  emit_text(m, "end");
  emit_end(m);
}

static void sum_ports(emit_module *m, const char *width, int terms, const char *about) {
  emit_signal(m, EMIT_INPUT, false, "clk", "", "clock");
  for (int i = 0; i < terms; i++) {
    char name[8];
    snprintf(name, sizeof name, "%c", "pqrs"[i]);
    emit_signal(m, EMIT_INPUT, true, name, width, "%s", about);
  }
}

/* a + b + c + first modulo 2^width as two rows: name_sum + name_carry. */
static void compress(emit_module *m, const char *name, const char *a, const char *b, const char *c,
                     const char *first, const char *width) {
  char net[EMIT_NAME];
  char below[EMIT_NAME];
  char parameters[EMIT_NAME];
  snprintf(below, sizeof below, "%s-1", width);
  snprintf(parameters, sizeof parameters, "N=%s-1", width);
  snprintf(net, sizeof net, "%s_sum", name);
  emit_net(m, EMIT_WIRE, false, net, width);
  snprintf(net, sizeof net, "%s_up", name);
  emit_net(m, EMIT_WIRE, false, net, below);
  snprintf(net, sizeof net, "%s_carry", name);
  emit_net(m, EMIT_WIRE, false, net, width);
  emit_text(m,
            "assign %s_sum[%s-1] = %s[%s-1] ^ %s[%s-1] ^ %s[%s-1];\n"
            "assign %s_carry = {%s_up, %s};",
            name, width, a, width, b, width, c, width, name, name, first);
  emit_instance(m, "sepax_fa", name, parameters,
                "a=%s[%s-2:0], b=%s[%s-2:0], c=%s[%s-2:0], sum=%s_sum[%s-2:0], carry=%s_up", a,
                width, b, width, c, width, name, width, name);
}

static void gen_area(emitter *e) {
  emit_module *m =
      emit_begin(e, "sepax_area",
                 "Twice the area of a triangle in the projection on x and y, from the strips\n"
                 "under its edges: g = p + q - r modulo 2^G_W.\n"
                 "Latency 1.");
  width_parameter(m, "G_W", SEPAX_X_ORIENT2D, "bits of an area");
  sum_ports(m, "G_W", 3, "strip under an edge");
  emit_signal(m, EMIT_OUTPUT_REG, true, "g", "G_W", "twice the area");
  emit_blank(m);
  compress(m, "three", "p", "q", "~r", "1'b1", "G_W");
  emit_text(m, "\nalways @(posedge clk) begin\n  g <= three_sum + three_carry;\nend");
  emit_end(m);

  m = emit_begin(e, "sepax_own_area",
                 "Twice the area of A or of B in the projection on x and y: g = p + q + r modulo\n"
                 "2^G_W of the strips under its edges. Latency 1.");
  width_parameter(m, "G_W", SEPAX_X_ORIENT2D, "bits of an area");
  sum_ports(m, "G_W", 3, "strip under an edge");
  emit_signal(m, EMIT_OUTPUT_REG, true, "g", "G_W", "twice the area");
  emit_blank(m);
  compress(m, "three", "p", "q", "r", "1'b0", "G_W");
  emit_text(m, "\nalways @(posedge clk) begin\n  g <= three_sum + three_carry;\nend");
  emit_end(m);
}

static void weight_ports(emit_module *m, const char *const port[], int count) {
  emit_signal(m, EMIT_INPUT, false, "clk", "", "clock");
  for (int i = 0; i < count; i++) {
    emit_signal(m, EMIT_INPUT, true, port[i], "W", "coordinate");
  }
}

/* Coordinates z_... sign-extended: wide_... */
static void widen(emit_module *m, const char *const port[], int count, const char *width,
                  const char *more) {
  char name[EMIT_NAME];
  for (int i = 0; i < count; i++) {
    snprintf(name, sizeof name, "wide%s", port[i] + 1);
    emit_net(m, EMIT_WIRE, true, name, width);
  }
  emit_blank(m);
  for (int i = 0; i < count; i++) {
    emit_text(m, "assign wide%s = {{(%s){%s[W-1]}}, %s};", port[i] + 1, more, port[i], port[i]);
  }
}

/* What is added to a weight for its digits' sake: `offset`. */
static void declare_offset(emit_module *m, const char *width) {
  emit_signal(m, EMIT_WIRE, true, "offset", width,
              "1 + 4 + 16 ...: 1 for each digit but the highest");
  emit_text(m, "\nassign offset = {{(%s+2-2*DIGITS){1'b0}}, {(DIGITS-1){2'b01}}};", width);
}

static void weight_parameters(emit_module *m, const char *width, int format) {
  width_parameter(m, "W", SEPAX_X_COORDINATE, "bits of a coordinate");
  width_parameter(m, width, format, "bits of the weight");
  emit_parameter(m, EMIT_PARAMETER, "DIGITS", m->emitter->design->format[format].digits,
                 "radix-4 digits of the weight");
}

static void gen_whole_weight(emitter *e) {
  static const char *const four[] = {"z_p", "z_q", "z_r", "z_s"};
  emit_module *m = emit_begin(
      e, "sepax_weight",
      "Weight of the prism under a vertex of A and an edge of B, the origin of z moved\n"
      "to the mean of A: z = z_p + z_q - z_r - z_s + offset, pq that edge and rs A's other\n"
      "edge. Latency 1.");
  weight_parameters(m, "Z_W", SEPAX_X_Z_SUM);
  weight_ports(m, four, 4);
  emit_signal(m, EMIT_OUTPUT_REG, true, "z", "Z_W", "weight and offset");
  widen(m, four, 4, "Z_W", "Z_W-W");
  declare_offset(m, "Z_W");
  compress(m, "three", "wide_p", "wide_q", "~wide_r", "1'b1", "Z_W");
  compress(m, "four", "three_sum", "three_carry", "~wide_s", "1'b1", "Z_W");
  emit_text(m, "\nalways @(posedge clk) begin\n  z <= four_sum + four_carry + offset;\nend");
  emit_end(m);
}

static void gen_own_weight(emitter *e, const exact_plan *p) {
  static const char *const six[] = {"z_a1", "z_a2", "z_a3", "z_b1", "z_b2", "z_b3"};
  emit_module *m = emit_begin(
      e, "sepax_own_weight",
      p->own_weight_rank
          ? "Weight of the prism under B, the origin of z moved to the mean of A: the sum of\n"
            "B's z less the sum of A's, plus offset. Latency 2."
          : "Weight of the prism under B, the origin of z moved to the mean of A: the sum of\n"
            "B's z less the sum of A's, plus offset. Latency 1.");
  weight_parameters(m, "O_W", SEPAX_X_OWN_Z_SUM);
  weight_ports(m, six, 6);
  emit_signal(m, EMIT_OUTPUT_REG, true, "z", "O_W", "weight and offset");
  widen(m, six, 6, "O_W", "O_W-W");
  declare_offset(m, "O_W");
  compress(m, "of_b", "wide_b1", "wide_b2", "wide_b3", "1'b1", "O_W");
  compress(m, "of_a", "~wide_a1", "~wide_a2", "~wide_a3", "1'b1", "O_W");
  compress(m, "five", "of_b_sum", "of_b_carry", "of_a_sum", "1'b1", "O_W");
  compress(m, "six", "five_sum", "five_carry", "of_a_carry", "1'b0", "O_W");
  const char *rank = p->own_weight_rank ? "_q" : "";
  if (p->own_weight_rank) {
    emit_net(m, EMIT_REG, false, "six_sum_q", "O_W");
    emit_net(m, EMIT_REG, false, "six_carry_q", "O_W");
    emit_text(m, "\nalways @(posedge clk) begin\n  six_sum_q <= six_sum;\n"
                 "  six_carry_q <= six_carry;\nend");
  }
  emit_text(m, "\nalways @(posedge clk) begin\n  z <= six_sum%s + six_carry%s + offset;\nend", rank,
            rank);
  emit_end(m);
}

static void gen_shared_own_weight(emitter *e) {
  emit_module *m = emit_begin(
      e, "sepax_own_weight",
      "Weight of the prism under B, the origin of z moved to the mean of A: the sum of\n"
      "B's z less the sum of A's, plus its own offset, from three rises, which have brought\n"
      "an offset of theirs each. Latency 1.");
  width_parameter(m, "Z_W", SEPAX_X_Z_SUM, "bits of a rise");
  emit_parameter(m, EMIT_PARAMETER, "RISE_DIGITS", e->design->format[SEPAX_X_Z_SUM].digits,
                 "radix-4 digits of a rise");
  width_parameter(m, "O_W", SEPAX_X_OWN_Z_SUM, "bits of the weight");
  emit_parameter(m, EMIT_PARAMETER, "DIGITS", e->design->format[SEPAX_X_OWN_Z_SUM].digits,
                 "radix-4 digits of the weight");
  emit_signal(m, EMIT_INPUT, false, "clk", "", "clock");
  for (int i = 1; i <= 3; i++) {
    char name[EMIT_NAME];
    snprintf(name, sizeof name, "rise_%d", i);
    emit_signal(m, EMIT_INPUT, true, name, "Z_W", "z of B_%d less z of A_%d, and offset", i, i);
    snprintf(name, sizeof name, "wide_%d", i);
    emit_net(m, EMIT_WIRE, true, name, "O_W");
  }
  emit_signal(m, EMIT_OUTPUT_REG, true, "z", "O_W", "weight and offset");
  declare_offset(m, "O_W");
  emit_net(m, EMIT_WIRE, true, "rise_offset", "O_W");
  emit_net(m, EMIT_WIRE, true, "difference", "O_W");
  emit_text(m, "assign rise_offset = {{(O_W+2-2*RISE_DIGITS){1'b0}}, {(RISE_DIGITS-1){2'b01}}};\n"
               "assign difference = offset - (rise_offset + rise_offset + rise_offset);");
  for (int i = 1; i <= 3; i++) {
    emit_text(m, "assign wide_%d = {{(O_W-Z_W+1){rise_%d[Z_W-1]}}, rise_%d[Z_W-2:0]};", i, i, i);
  }
  compress(m, "three", "wide_1", "wide_2", "wide_3", "1'b0", "O_W");
  emit_text(m, "\nalways @(posedge clk) begin\n  z <= three_sum + three_carry + difference;\nend");
  emit_end(m);
}

static void gen_running_own_weight(emitter *e) {
  static const char *const two[] = {"z_a", "z_b"};
  emit_module *m =
      emit_begin(e, "sepax_own_weight",
                 "Weight of the prism under B, the origin of z moved to the mean of A: the sum of\n"
                 "B's z less the sum of A's, plus offset, one vertex of each a cycle. Latency 3.");
  weight_parameters(m, "O_W", SEPAX_X_OWN_Z_SUM);
  weight_ports(m, two, 2);
  emit_signal(m, EMIT_INPUT, false, "first", "", "the first vertex of each");
  emit_signal(m, EMIT_OUTPUT_REG, true, "z", "O_W", "weight and offset");
  emit_net(m, EMIT_WIRE, true, "so_far", "O_W");
  widen(m, two, 2, "O_W", "O_W-W");
  declare_offset(m, "O_W");
  emit_text(m, "assign so_far = first ? offset : z;");
  compress(m, "three", "so_far", "wide_b", "~wide_a", "1'b1", "O_W");
  emit_text(m, "\nalways @(posedge clk) begin\n  z <= three_sum + three_carry;\nend");
  emit_end(m);
}

static void gen_weights(emitter *e, const exact_plan *p) {
  static const char *const two[] = {"z_p", "z_r"};
  emit_module *m =
      emit_begin(e, "sepax_rise",
                 "Weight of the prism under an edge of A and a vertex of B, the origin of z\n"
                 "moved to the mean of A: z = z_p - z_r + offset, p that vertex, r A's third.\n"
                 "Latency 1.");
  weight_parameters(m, "Z_W", SEPAX_X_Z_SUM);
  weight_ports(m, two, 2);
  emit_signal(m, EMIT_OUTPUT_REG, true, "z", "Z_W", "weight and offset");
  emit_signal(m, p->shared_rises ? EMIT_OUTPUT : EMIT_WIRE, true, "rise", "Z_W",
              "the same at once");
  widen(m, two, 2, "Z_W", "Z_W-W");
  declare_offset(m, "Z_W");
  emit_text(m, "assign rise = wide_p - wide_r + offset;\n"
               "\nalways @(posedge clk) begin\n  z <= rise;\nend");
  emit_end(m);

  if (p->shared_rises) {
    m = emit_begin(
        e, "sepax_weight",
        "Weight of the prism under a vertex of A and an edge of B, the origin of z moved\n"
        "to the mean of A: z = z_p + z_q - z_r - z_s + 2 offset, pq that edge and rs A's\n"
        "other edge, as a sum of two rises. Latency 1.");
    width_parameter(m, "Z_W", SEPAX_X_Z_SUM, "bits of the weight");
    emit_signal(m, EMIT_INPUT, false, "clk", "", "clock");
    emit_signal(m, EMIT_INPUT, true, "rise_pr", "Z_W", "z_p - z_r + offset");
    emit_signal(m, EMIT_INPUT, true, "rise_qs", "Z_W", "z_q - z_s + offset");
    emit_signal(m, EMIT_OUTPUT_REG, true, "z", "Z_W", "weight and 2 offset");
    emit_text(m, "\nalways @(posedge clk) begin\n  z <= rise_pr + rise_qs;\nend");
    emit_end(m);
  } else {
    gen_whole_weight(e);
  }

  if (p->running) {
    gen_running_own_weight(e);
  } else if (p->shared_rises) {
    gen_shared_own_weight(e);
  } else {
    gen_own_weight(e, p);
  }
}

static void gen_prism(emitter *e, const char *name, const arith_plan *plan) {
  bool own = strcmp(name, "sepax_own_prism") == 0;
  const char *width = own ? "O_W" : "Z_W";
  char banner[400];
  snprintf(banner, sizeof banner,
           "Six times the signed volume of the prism between a triangle and the plane z = 0:\n"
           "h = g (z - K) modulo 2^V_W, g twice its area in the projection, z the sum of its z\n"
           "plus K (%s, see sepax_mul_...). Latency %d.",
           plan->less == 2 ? "two offsets" : "an offset", 1 + plan->ranks);
  emit_module *m = emit_begin(e, name, banner);
  width_parameter(m, "G_W", SEPAX_X_ORIENT2D, "bits of an area");
  width_parameter(m, width, own ? SEPAX_X_OWN_Z_SUM : SEPAX_X_Z_SUM, "bits of a weight");
  width_parameter(m, "V_W", SEPAX_X_ORIENT3D, "bits of a volume");
  emit_signal(m, EMIT_INPUT, false, "clk", "", "clock");
  emit_signal(m, EMIT_INPUT, true, "g", "G_W", "twice the area");
  emit_signal(m, EMIT_INPUT, true, "z", width, "weight");
  emit_signal(m, EMIT_OUTPUT_REG, true, "h", "V_W", "six times the volume");
  emit_net(m, EMIT_WIRE, true, "product", "V_W");
  emit_blank(m);
  multiply(m, plan, "g", "z", "product");
  emit_text(m, "\nalways @(posedge clk) begin\n  h <= product;\nend");
  emit_end(m);
}

/* The last steps of a volume: the sum of two rows, its sign. */
static void signs(emit_module *m, const exact_plan *p, const char *left, const char *right) {
  int ranks = p->volume_ranks;
  bool whole = p->limits > 0; /* the volume is the output, always a register */
  if (!whole) {
    emit_net(m, ranks > 0 ? EMIT_REG : EMIT_WIRE, false, "volume", "V_W");
  }
  if (ranks > 1) {
    emit_net(m, EMIT_REG, false, "row_0", "V_W");
    emit_net(m, EMIT_REG, false, "row_1", "V_W");
    emit_text(m, "\nalways @(posedge clk) begin\n  row_0 <= %s;\n  row_1 <= %s;\nend", left, right);
    left = "row_0";
    right = "row_1";
  }
  if (ranks > 0 || whole) {
    emit_text(m, "\nalways @(posedge clk) begin\n  volume <= %s + %s;\nend", left, right);
  } else {
    emit_text(m, "\nassign volume = %s + %s;", left, right);
  }
  if (whole) {
    return;
  }
  emit_text(m, "\nalways @(posedge clk) begin\n"
               "  sign <= {!volume[V_W-1] && (volume != {V_W{1'b0}}), volume[V_W-1]};\nend");
}

static emit_module *begin_volume(emitter *e, const exact_plan *p, const char *name,
                                 const char *formula, int terms) {
  char banner[400];
  bool whole = p->limits > 0;
  snprintf(
      banner, sizeof banner, "%s%s, modulo 2^V_W, from the prisms\nunder its faces. Latency %d.",
      whole ? "V" : "Sign of the v", formula, 1 + (whole ? p->volume_ranks / 2 : p->volume_ranks));
  emit_module *m = emit_begin(e, name, banner);
  width_parameter(m, "V_W", SEPAX_X_ORIENT3D, "bits of a volume");
  sum_ports(m, "V_W", terms, "prism under a face");
  if (whole) {
    emit_signal(m, EMIT_OUTPUT_REG, true, "volume", "V_W", "six times the volume");
  } else {
    emit_signal(m, EMIT_OUTPUT_REG, false, "sign", "2", "{volume > 0, volume < 0}");
  }
  emit_blank(m);
  return m;
}

static void gen_volumes(emitter *e, const exact_plan *p) {
  emit_module *m;
  if (p->running) {
    m = emit_begin(e, "sepax_above_a",
                   "Running sum of the prisms under the faces of a tetrahedron over A:\n"
                   "sum = p + q modulo 2^V_W. Latency 1.");
    width_parameter(m, "V_W", SEPAX_X_ORIENT3D, "bits of a volume");
    sum_ports(m, "V_W", 2, "prism, or sum so far");
    emit_signal(m, EMIT_OUTPUT_REG, true, "sum", "V_W", "sum");
    emit_text(m, "\nalways @(posedge clk) begin\n  sum <= p + q;\nend");
    emit_end(m);
  } else {
    m = begin_volume(e, p, "sepax_above_a",
                     "olume of A and a vertex of B: p + q + r (A's own prism is zero)", 3);
    compress(m, "three", "p", "q", "r", "1'b0", "V_W");
    signs(m, p, "three_sum", "three_carry");
    emit_end(m);
  }
  m = begin_volume(e, p, "sepax_above_b",
                   "olume of B and a vertex of A: p + q + r - s, s the prism of B", 4);
  compress(m, "three", "p", "q", "r", "1'b0", "V_W");
  compress(m, "four", "three_sum", "three_carry", "~s", "1'b1", "V_W");
  signs(m, p, "four_sum", "four_carry");
  emit_end(m);
  m = begin_volume(e, p, "sepax_between", "olume of an edge of A and an edge of B: p + q - r - s",
                   4);
  compress(m, "three", "p", "q", "~r", "1'b1", "V_W");
  compress(m, "four", "three_sum", "three_carry", "~s", "1'b1", "V_W");
  signs(m, p, "four_sum", "four_carry");
  emit_end(m);
}

/* A 2-bit sign per name, printf-like in i and j (1 ... 3). */
static void sign_ports(emit_module *m, const char *format, bool two, const char *about) {
  for (int i = 1; i <= 3; i++) {
    for (int j = 1; j <= (two ? 3 : 1); j++) {
      char name[EMIT_NAME];
      snprintf(name, sizeof name, format, i, j);
      emit_signal(m, EMIT_INPUT, false, name, "2", about, i, j);
    }
  }
}

static void gen_decide(emitter *e) {
  emit_module *m = emit_begin(
      e, "sepax_decide",
      "The axis that separates, from the signs of the 15 volumes; {> 0, < 0} each, so\n"
      "that 00 is zero. Combinational. In this order:\n"
      "  10       N_A: all of s have one sign\n"
      "  11       N_B: all of w have one sign\n"
      "  1 ... 9  e_i x f_j at 1 + 3 (i - 1) + (j - 1): d_ij has a sign that puts the edges\n"
      "           apart, and on it s falls (rises) along f_j and w along e_i\n"
      "  12       an axis in the common plane: all volumes are zero, in_plane says so\n"
      "  0        none: collision");
  sign_ports(m, "s_%d", false, "volume of A and B_%d");
  sign_ports(m, "w_%d", false, "volume of B and A_%d");
  sign_ports(m, "d_%d%d", true, "volume of e_%d and f_%d");
  emit_signal(m, EMIT_INPUT, false, "second", "", "second pass: known to be coplanar");
  emit_signal(m, EMIT_INPUT, false, "in_plane", "", "should the pair be coplanar: it is separated");
  emit_signal(m, EMIT_OUTPUT, false, "coplanar", "", "all volumes are zero, or a second pass");
  emit_signal(m, EMIT_OUTPUT, false, "axis", "4", "0 ... 12");
  static const char *const wires[] = {"normal_a", "normal_b"};
  for (int i = 0; i < 2; i++) {
    emit_net(m, EMIT_WIRE, false, wires[i], "");
  }
  for (int k = 0; k < 4; k++) {
    static const char *const slope[] = {"s_falls", "s_rises", "w_falls", "w_rises"};
    emit_signal(m, EMIT_WIRE, false, slope[k], "3", "along edge 1, 2, 3: bit 0, 1, 2");
  }
  emit_signal(m, EMIT_WIRE, false, "apart", "9", "axis k separates: bit k - 1");
  emit_text(m, "\n"
               "assign normal_a = (s_1[1] && s_2[1] && s_3[1]) || (s_1[0] && s_2[0] && s_3[0]);\n"
               "assign normal_b = (w_1[1] && w_2[1] && w_3[1]) || (w_1[0] && w_2[0] && w_3[0]);");
  for (int v = 0; v < 2; v++) {
    char c = "sw"[v];
    emit_text(m, "assign %c_falls = ~{%c_3[0] | %c_1[1], %c_2[0] | %c_3[1], %c_1[0] | %c_2[1]};", c,
              c, c, c, c, c, c);
    emit_text(m, "assign %c_rises = ~{%c_3[1] | %c_1[0], %c_2[1] | %c_3[0], %c_1[1] | %c_2[0]};", c,
              c, c, c, c, c, c);
  }
  for (int i = 0; i < 3; i++) {
    for (int j = 0; j < 3; j++) {
      emit_text(m,
                "assign apart[%d] = (d_%d%d[1] && s_falls[%d] && w_falls[%d]) ||\n"
                "                  (d_%d%d[0] && s_rises[%d] && w_rises[%d]);",
                3 * i + j, i + 1, j + 1, j, i, i + 1, j + 1, j, i);
    }
  }
  emit_text(
      m,
      "\nassign coplanar = second ||\n                  ({s_1, s_2, s_3, w_1, w_2, w_3, d_11, d_12, d_13, d_21, d_22, d_23,\n"
      "                    d_31, d_32, d_33} == 30'd0);\n"
      "assign axis = coplanar ? (in_plane ? 4'd12 : 4'd0) :\n"
      "              normal_a ? 4'd10 :\n"
      "              normal_b ? 4'd11 :");
  for (int k = 0; k < 9; k++) {
    emit_text(m, "              apart[%d] ? 4'd%d :", k, k + 1);
  }
  emit_text(m, "              4'd0;");
  emit_end(m);
}

static void gen_plane(emitter *e) {
  emit_module *m = emit_begin(
      e, "sepax_plane",
      "The pair in the projection on x and y, from the signs {> 0, < 0} of its areas.\n"
      "flat: all points are on one line there. apart: an edge of one triangle has the\n"
      "other strictly on the side where its own third vertex is not. apart_x, apart_z: the\n"
      "boxes are disjoint in x, in z. Combinational.");
  sign_ports(m, "g_a%d_b%d", true, "edge %d of A with B_%d");
  sign_ports(m, "g_b%d_a%d", true, "edge %d of B with A_%d");
  emit_signal(m, EMIT_INPUT, false, "g_a", "2", "A itself");
  emit_signal(m, EMIT_INPUT, false, "g_b", "2", "B itself");
  sign_ports(m, "x_%d%d", true, "x of B less x of A: A_%d, B_%d");
  sign_ports(m, "z_%d%d", true, "z of B less z of A: A_%d, B_%d");
  emit_signal(m, EMIT_OUTPUT, false, "flat", "", "all areas are zero");
  emit_signal(m, EMIT_OUTPUT, false, "apart", "", "separated, if the projection is not flat");
  emit_signal(m, EMIT_OUTPUT, false, "apart_x", "", "boxes disjoint in x");
  emit_signal(m, EMIT_OUTPUT, false, "apart_z", "", "boxes disjoint in z");
  for (int v = 0; v < 2; v++) {
    char name[EMIT_NAME];
    snprintf(name, sizeof name, "apart_%c", "ab"[v]);
    emit_signal(m, EMIT_WIRE, false, name, "3", "by edge 1, 2, 3: bit 0, 1, 2");
  }
  emit_blank(m);
  for (int v = 0; v < 2; v++) {
    char own = "ab"[v];
    char other = "ba"[v];
    for (int i = 1; i <= 3; i++) {
      char g[3][EMIT_NAME];
      for (int k = 0; k < 3; k++) {
        snprintf(g[k], sizeof g[k], "g_%c%d_%c%d", own, i, other, k + 1);
      }
      emit_text(m,
                "assign apart_%c[%d] = (%s[1] && %s[1] && %s[1] && !g_%c[1]) ||\n"
                "                    (%s[0] && %s[0] && %s[0] && !g_%c[0]);",
                own, i - 1, g[0], g[1], g[2], own, g[0], g[1], g[2], own);
    }
  }
  char all[1024] = "{g_a, g_b";
  for (int v = 0; v < 2; v++) {
    for (int k = 0; k < 9; k++) {
      size_t used = strlen(all);
      snprintf(all + used, sizeof all - used, ",%sg_%c%d_%c%d",
               k % 3 == 0 ? "\n                " : " ", "ab"[v], k / 3 + 1, "ba"[v], k % 3 + 1);
    }
  }
  emit_text(m,
            "assign apart = (apart_a != 3'd0) || (apart_b != 3'd0);\n"
            "assign flat = (%s} == 40'd0);",
            all);
  static const char *const line =
      "%c_11[%d] && %c_12[%d] && %c_13[%d] && %c_21[%d] && %c_22[%d] &&\n"
      "                %c_23[%d] && %c_31[%d] && %c_32[%d] && %c_33[%d])";
  char term[4][256];
  for (int t = 0; t < 4; t++) {
    char c = "xz"[t / 2];
    int b = t % 2;
    snprintf(term[t], sizeof term[t], line, c, b, c, b, c, b, c, b, c, b, c, b, c, b, c, b, c, b);
  }
  for (int t = 0; t < 2; t++) {
    emit_text(m, "assign apart_%c = (%s ||\n                 (%s;", "xz"[t], term[2 * t],
              term[2 * t + 1]);
  }
  emit_end(m);
}

void gen_exact_units(emitter *e, const exact_plan *p) {
  gen_fa(e);
  gen_digits(e, p->shared_rises);
  gen_multiplier(e, &p->strip_mul);
  gen_multiplier(e, &p->prism_mul);
  if (!arith_same(&p->own_mul, &p->prism_mul)) { /* they are where W is odd */
    gen_multiplier(e, &p->own_mul);
  }
  if (p->shared_rises) {
    gen_multiplier(e, &p->low_prism_mul);
  }
  bool flag = p->single;
  gen_strip(e, p, false);
  if (!flag) {
    gen_strip(e, p, true);
  }
  gen_area(e);
  gen_weights(e, p);
  gen_prism(e, "sepax_prism", &p->prism_mul);
  if (p->shared_rises) {
    gen_prism(e, "sepax_prism_2", &p->low_prism_mul);
  }
  gen_prism(e, "sepax_own_prism", &p->own_mul);
  gen_volumes(e, p);
  if (p->limits > 0) {
    gen_exact_clear_units(e, p);
    return;
  }
  gen_decide(e);
  if (!flag) {
    gen_plane(e);
  }
}
