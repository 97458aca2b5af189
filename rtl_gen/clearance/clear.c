/* gen_exact_clear.c - what a clearance adds to architecture exact: the modules, and their
 * places in sepax_core (docs/clearance.md). */
#include "exact/core.h"
#include "sepax_design.h"

#include <stdlib.h>
#include <string.h>

/* -------------------------------------------------------------------------- modules */

static int width_of(const emitter *e, int format) { return e->design->format[format].width; }

/* One digit of a factor, -1, 0 or 1, and what is left of it, halved. */
static int digit_of(int64_t *factor) {
  int digit = (*factor & 1) == 0 ? 0 : (*factor & 3) == 3 ? -1 : 1;
  *factor = (*factor - digit) / 2;
  return digit;
}

/* `factor` times a value of `width` bits, as a sum of its shifts modulo 2^bits; to be freed. */
static char *multiple(const char *value, int width, int64_t factor, int bits) {
  char *text = NULL;
  size_t size = 0;
  bool first = true;
  FILE *out = open_memstream(&text, &size);
  if (out == NULL) {
    abort();
  }
  for (int shift = 0; factor != 0; shift++) {
    int digit = digit_of(&factor);
    if (digit == 0 || shift >= bits) {
      continue;
    }
    fprintf(out, "%s{", first ? (digit < 0 ? "-" : "") : digit < 0 ? " - " : " + ");
    first = false;
    if (bits > shift + width) {
      fprintf(out, "%d'd0, ", bits - shift - width);
    }
    fputs(value, out);
    if (bits < shift + width) {
      fprintf(out, "[%d:0]", bits - shift - 1);
    }
    if (shift > 0) {
      fprintf(out, ", %d'd0", shift);
    }
    fputc('}', out);
  }
  if (first) {
    fprintf(out, "%d'd0", bits);
  }
  fclose(out);
  return text;
}

/* For each clearance D a register name_K: (2 + D) sum + D most, in one stage or two. */
static void limits_of(emit_module *m, const exact_plan *p, const char *name, const char *sum,
                      int sum_width, const char *most, int most_width, int bits) {
  char width[16];
  char part[EMIT_NAME];
  snprintf(width, sizeof width, "%d", bits);
  for (int k = 0; k < p->limits; k++) {
    int64_t d = p->design->margin[k] - 1;
    char *of_sum = multiple(sum, sum_width, 2 + d, bits);
    char *of_most = multiple(most, most_width, d, bits);
    const char *text[2] = {of_sum, of_most};
    snprintf(part, sizeof part, "%s_%d", name, k + 1);
    emit_net(m, EMIT_REG, false, part, width);
    for (int i = 0; i < 2 && p->total_rank; i++) {
      snprintf(part, sizeof part, "%s_part_%d_%d", name, i, k + 1);
      emit_net(m, EMIT_REG, false, part, width);
    }
    emit_text(m, "always @(posedge clk) begin");
    if (p->total_rank) {
      emit_text(
          m,
          "  %s_part_0_%d <= %s;\n  %s_part_1_%d <= %s;\n  %s_%d <= %s_part_0_%d + %s_part_1_%d;",
          name, k + 1, text[0], name, k + 1, text[1], name, k + 1, name, k + 1, name, k + 1);
    } else if (d > 0) {
      emit_text(m, "  %s_%d <= %s +\n    %s;", name, k + 1, text[0], text[1]);
    } else {
      emit_text(m, "  %s_%d <= %s;", name, k + 1, text[0]);
    }
    emit_text(m, "end");
    free(of_sum);
    free(of_most);
  }
}

static bool most_matters(const exact_plan *p) { return p->design->margin[1] > 1; }

/* reg `out` <= the size of a number of `width` bits. */
static void size_of(emit_module *m, const char *value, const char *out, int width) {
  emit_text(m, "  %s <= %s[%d] ? -%s : %s;", out, value, width - 1, value, value);
}

static void gen_limit(emitter *e, const exact_plan *p, const char *name, int format,
                      const char *what) {
  char banner[600];
  char text[EMIT_NAME];
  int bits = width_of(e, SEPAX_X_LIMIT);
  int width = width_of(e, format);
  snprintf(banner, sizeof banner,
           "What twice a gap on %s must exceed: (2 + D) (|x| + |y| + |z|) + D max(|x|, |y|, |z|),\n"
           "for each clearance D%s. Latency %d.",
           what, p->limits > 1 ? ", the inner in the lower half" : "",
           3 + p->most_rank + p->total_rank);
  emit_module *m = emit_begin(e, name, banner);
  char component[16];
  char sum[16];
  snprintf(component, sizeof component, "%d", width);
  snprintf(sum, sizeof sum, "%d", width + 2);
  emit_signal(m, EMIT_INPUT, false, "clk", "", "clock");
  for (int i = 0; i < 3; i++) {
    snprintf(text, sizeof text, "%c", "xyz"[i]);
    emit_signal(m, EMIT_INPUT, true, text, component, "component");
  }
  snprintf(text, sizeof text, "%d", p->limits * bits);
  emit_signal(m, EMIT_OUTPUT, false, "limit", text, "for each clearance %d bits", bits);
  for (int i = 0; i < 3; i++) {
    snprintf(text, sizeof text, "size_%c", "xyz"[i]);
    emit_net(m, EMIT_REG, false, text, component);
  }
  emit_net(m, EMIT_REG, false, "sum", sum);
  emit_text(m, "\nalways @(posedge clk) begin");
  size_of(m, "x", "size_x", width);
  size_of(m, "y", "size_y", width);
  size_of(m, "z", "size_z", width);
  emit_text(m, "  sum <= {2'd0, size_x} + {2'd0, size_y} + {2'd0, size_z};\nend");
  const char *of_sum = "sum";
  if (most_matters(p)) {
    emit_net(m, EMIT_REG, false, "most", component);
    emit_net(m, p->most_rank ? EMIT_REG : EMIT_WIRE, false, "most_xy", component);
    if (p->most_rank) {
      emit_net(m, EMIT_REG, false, "size_z_q", component);
      emit_net(m, EMIT_REG, false, "sum_q", sum);
      of_sum = "sum_q";
      emit_text(m,
                "always @(posedge clk) begin\n  most_xy <= (size_x > size_y) ? size_x : size_y;\n"
                "  size_z_q <= size_z;\n  sum_q <= sum;\n"
                "  most <= (most_xy > size_z_q) ? most_xy : size_z_q;\nend");
    } else {
      emit_text(
          m, "assign most_xy = (size_x > size_y) ? size_x : size_y;\n"
             "always @(posedge clk) begin\n  most <= (most_xy > size_z) ? most_xy : size_z;\nend");
    }
  } else if (p->most_rank) {
    emit_net(m, EMIT_REG, false, "sum_q", sum);
    of_sum = "sum_q";
    emit_text(m, "always @(posedge clk) begin\n  sum_q <= sum;\nend");
  }
  limits_of(m, p, "total", of_sum, width + 2, "most", width, bits);
  emit_text(m, p->limits == 1 ? "assign limit = total_1;" : "assign limit = {total_2, total_1};");
  emit_end(m);
}

static void gen_edge_limit(emitter *e, const exact_plan *p) {
  int word = e->design->core_word;
  int bits = width_of(e, SEPAX_X_EDGE_LIMIT);
  char banner[600];
  char text[4 * EMIT_NAME];
  char width[16];
  char sum[16];
  snprintf(
      banner, sizeof banner,
      "What twice an area over an edge (X, Y, Z) must exceed, in the projection on x and y:\n"
      "(2 + D) (|X| + |Y|) + D max(|X|, |Y|), on y and z, on z and x; for each clearance D.\nLatency %d.",
      3 + p->total_rank);
  emit_module *m = emit_begin(e, "sepax_edge_limit", banner);
  snprintf(width, sizeof width, "%d", word);
  snprintf(sum, sizeof sum, "%d", word + 1);
  emit_signal(m, EMIT_INPUT, false, "clk", "", "clock");
  for (int i = 0; i < 6; i++) {
    snprintf(text, sizeof text, "%c_%s", "xyz"[i / 2], i % 2 == 0 ? "from" : "to");
    emit_signal(m, EMIT_INPUT, true, text, width, "coordinate");
  }
  snprintf(text, sizeof text, "%d", 3 * p->limits * bits);
  emit_signal(m, EMIT_OUTPUT, false, "limit", text,
              "zx, yz, xy; in each for each clearance %d bits", bits);
  for (int i = 0; i < 3; i++) {
    snprintf(text, sizeof text, "size_%c", "xyz"[i]);
    emit_net(m, EMIT_REG, false, text, width);
  }
  emit_text(m, "\nalways @(posedge clk) begin");
  for (int i = 0; i < 3; i++) {
    char c = "xyz"[i];
    emit_text(m, "  size_%c <= (%c_to < %c_from) ? %c_from - %c_to : %c_to - %c_from;", c, c, c, c,
              c, c, c);
  }
  emit_text(m, "end");
  for (int i = 0; i < 3; i++) {
    const char *name = exact_projection_name(i);
    char most[EMIT_NAME] = "";
    snprintf(text, sizeof text, "sum_%s", name);
    emit_net(m, EMIT_REG, false, text, sum);
    if (most_matters(p)) {
      snprintf(most, sizeof most, "most_%s", name);
      emit_net(m, EMIT_REG, false, most, width);
    }
    emit_text(m, "always @(posedge clk) begin\n  sum_%s <= {1'b0, size_%c} + {1'b0, size_%c};",
              name, name[0], name[1]);
    if (most_matters(p)) {
      emit_text(m, "  most_%s <= (size_%c > size_%c) ? size_%c : size_%c;", name, name[0], name[1],
                name[0], name[1]);
    }
    emit_text(m, "end");
    limits_of(m, p, name, text, word + 1, most, word, bits);
  }
  if (p->limits == 1) {
    emit_text(m, "assign limit = {zx_1, yz_1, xy_1};");
  } else {
    emit_text(m, "assign limit = {zx_2, zx_1, yz_2, yz_1, xy_2, xy_1};");
  }
  emit_end(m);
}

/* Wire `out`: twice the size of a number of `width` bits is above bits from `low` of a limit. Of
 * value and sign s, with ~value for value below 0: {x, s, s} > {limit, 0}. */
static void exceeds(emit_module *m, const char *value, int width, const char *limit, int low,
                    int bits, const char *out) {
  char x[EMIT_NAME];
  char wide[16];
  int wanted = (width > bits ? width : bits) + 2;
  snprintf(x, sizeof x, "%s_x", out);
  snprintf(wide, sizeof wide, "%d", wanted);
  emit_net(m, EMIT_WIRE, false, x, wide);
  snprintf(x, sizeof x, "%s_t", out);
  emit_net(m, EMIT_WIRE, false, x, wide);
  emit_net(m, EMIT_WIRE, false, out, "");
  char pad_x[24] = "";
  char pad_t[24] = "";
  if (wanted > width + 2) {
    snprintf(pad_x, sizeof pad_x, "%d'd0, ", wanted - width - 2);
  }
  snprintf(pad_t, sizeof pad_t, "%d'd0, ", wanted - bits - 1);
  emit_text(m,
            "assign %s_x = {%s%s ^ {%d{%s[%d]}}, {2{%s[%d]}}};\n"
            "assign %s_t = {%s%s[%d:%d], 1'b0};\n"
            "assign %s = %s_x > %s_t;",
            out, pad_x, value, width, value, width - 1, value, width - 1, out, pad_t, limit,
            low + bits - 1, low, out, out, out);
}

/* A module that holds a value `x` of a format against limits: {flags, twice its size exceeds the
 * limit of each clearance}. */
static void gen_comparison(emitter *e, const exact_plan *p, const char *module, const char *banner,
                           const char *x, const char *about, int width, int bits, const char *flags,
                           int flag_bits) {
  char name[EMIT_NAME];
  emit_module *m = emit_begin(e, module, banner);
  snprintf(name, sizeof name, "%d", width);
  emit_signal(m, EMIT_INPUT, false, "clk", "", "clock");
  emit_signal(m, EMIT_INPUT, true, x, name, "%s", about);
  snprintf(name, sizeof name, "%d", p->limits * bits);
  emit_signal(m, EMIT_INPUT, false, "limit", name, "for each clearance %d bits", bits);
  snprintf(name, sizeof name, "%d", p->limits + flag_bits);
  emit_signal(m, EMIT_OUTPUT_REG, false, "far", name, "what is found");
  for (int k = 0; k < p->limits; k++) {
    exceeds(m, x, width, "limit", k * bits, bits, k == 0 ? "far_1" : "far_2");
  }
  emit_text(m, "\nalways @(posedge clk) begin\n  far <= {%s%s, far_1};\nend", flags,
            p->limits > 1 ? ", far_2" : "");
  emit_end(m);
}

static void gen_beyond(emitter *e, const exact_plan *p) {
  int area = width_of(e, SEPAX_X_ORIENT2D);
  gen_comparison(
      e, p, "sepax_beyond",
      "An area against the limit of an edge: {it is below 0, twice its size exceeds the limit,\n"
      "for each clearance}. Latency 1.",
      "g", "area", area, width_of(e, SEPAX_X_EDGE_LIMIT), gen_format("g[%d]", area - 1).text, 1);
}

static void gen_edge_clear(emitter *e, const exact_plan *p) {
  int area = width_of(e, SEPAX_X_ORIENT2D);
  int n = p->limits;
  char width[16];
  char name[EMIT_NAME];
  emit_module *m = emit_begin(
      e, "sepax_edge_clear",
      "In a projection: is the other triangle farther from an edge than its limit, all of it\n"
      "on the side where the edge's own triangle is not? For each clearance. Latency 1.");
  snprintf(width, sizeof width, "%d", n + 1);
  emit_signal(m, EMIT_INPUT, false, "clk", "", "clock");
  for (int i = 1; i <= 3; i++) {
    snprintf(name, sizeof name, "b_%d", i);
    emit_signal(m, EMIT_INPUT, false, name, width, "area of the edge and vertex %d of the other",
                i);
  }
  snprintf(width, sizeof width, "%d", area);
  emit_signal(m, EMIT_INPUT, true, "own", width, "area of the edge's own triangle");
  snprintf(width, sizeof width, "%d", n);
  emit_signal(m, EMIT_OUTPUT_REG, false, "clear", width, "bit k: of clearance k");
  emit_net(m, EMIT_WIRE, false, "one_side", "");
  emit_text(m,
            "assign one_side = (b_1[%d] == b_2[%d]) && (b_1[%d] == b_3[%d]) &&\n"
            "                  ((own == %d'd0) || (own[%d] != b_1[%d]));",
            n, n, n, n, area, area - 1, n);
  if (n == 1) {
    emit_text(
        m,
        "\nalways @(posedge clk) begin\n  clear <= one_side && b_1[0] && b_2[0] && b_3[0];\nend");
  } else {
    emit_text(m,
              "\nalways @(posedge clk) begin\n  clear <= {one_side && b_1[1] && b_2[1] && b_3[1],\n"
              "            one_side && b_1[0] && b_2[0] && b_3[0]};\nend");
  }
  emit_end(m);
}

static void gen_far(emitter *e, const exact_plan *p) {
  int volume = width_of(e, SEPAX_X_ORIENT3D);
  gen_comparison(
      e, p, "sepax_far",
      "A volume against the limit of its axis: {it is 0, it is below 0, twice its size exceeds\n"
      "the limit, for each clearance}. Latency 1.",
      "v", "volume", volume, width_of(e, SEPAX_X_LIMIT),
      gen_format("v == %d'd0, v[%d]", volume, volume - 1).text, 2);
}

static void gen_small(emitter *e, const exact_plan *p) {
  char area[16];
  char volume[16];
  char cross[16];
  snprintf(area, sizeof area, "%d", width_of(e, SEPAX_X_ORIENT2D));
  snprintf(volume, sizeof volume, "%d", width_of(e, SEPAX_X_ORIENT3D));
  snprintf(cross, sizeof cross, "%d", width_of(e, SEPAX_X_CROSS));
  emit_module *m =
      emit_begin(e, "sepax_cross",
                 "A component of e x f, from the areas of e and both ends of f: p - q. Latency 1.");
  emit_signal(m, EMIT_INPUT, false, "clk", "", "clock");
  emit_signal(m, EMIT_INPUT, true, "p", area, "area with the end of f");
  emit_signal(m, EMIT_INPUT, true, "q", area, "area with its beginning");
  emit_signal(m, EMIT_OUTPUT_REG, true, "c", cross, "component");
  int more = width_of(e, SEPAX_X_CROSS) - width_of(e, SEPAX_X_ORIENT2D);
  int top = width_of(e, SEPAX_X_ORIENT2D) - 1;
  emit_text(m, "\nalways @(posedge clk) begin\n  c <= {{%d{p[%d]}}, p} - {{%d{q[%d]}}, q};\nend",
            more, top, more, top);
  emit_end(m);

  m = emit_begin(e, "sepax_slope",
                 "How volumes go along an edge: {not down, not up} from p to q. Latency 1.");
  emit_signal(m, EMIT_INPUT, false, "clk", "", "clock");
  emit_signal(m, EMIT_INPUT, true, "p", volume, "volume at its beginning");
  emit_signal(m, EMIT_INPUT, true, "q", volume, "volume at its end");
  emit_signal(m, EMIT_OUTPUT_REG, false, "slope", "2", "{q >= p, q <= p}");
  emit_text(m, "\nalways @(posedge clk) begin\n  slope <= {q >= p, q <= p};\nend");
  emit_end(m);

  char word[16];
  char name[EMIT_NAME];
  int w = e->design->core_word;
  snprintf(word, sizeof word, "%d", w);
  m = emit_begin(
      e, "sepax_box_clear",
      "One coordinate: is the gap of the boxes above 1 + D, for each clearance D? Latency 2.");
  emit_signal(m, EMIT_INPUT, false, "clk", "", "clock");
  for (int i = 0; i < 6; i++) {
    snprintf(name, sizeof name, "%c_%d", "ab"[i / 3], i % 3 + 1);
    emit_signal(m, EMIT_INPUT, true, name, word, "coordinate");
  }
  snprintf(name, sizeof name, "%d", p->limits);
  emit_signal(m, EMIT_OUTPUT_REG, false, "clear", name, "bit k: of clearance k");
  for (int i = 0; i < 4; i++) {
    static const char *const end[] = {"low_a", "high_a", "low_b", "high_b"};
    emit_net(m, EMIT_WIRE, true, end[i], word);
    snprintf(name, sizeof name, "%s_q", end[i]);
    emit_net(m, EMIT_REG, true, name, word);
  }
  for (int t = 0; t < 2; t++) {
    char c = "ab"[t];
    snprintf(name, sizeof name, "bounds_%c", c);
    char word_of[24];
    snprintf(word_of, sizeof word_of, "W=%d", w);
    emit_instance(m, "sepax_bounds", name, word_of,
                  "p=%c_1, q=%c_2, r=%c_3, low=low_%c, high=high_%c", c, c, c, c, c);
  }
  snprintf(name, sizeof name, "%d", w + 1);
  emit_net(m, EMIT_WIRE, false, "up", name);
  emit_net(m, EMIT_WIRE, false, "down", name);
  emit_text(m,
            "assign up = {low_b_q[%d], low_b_q} - {high_a_q[%d], high_a_q};\n"
            "assign down = {low_a_q[%d], low_a_q} - {high_b_q[%d], high_b_q};",
            w - 1, w - 1, w - 1, w - 1);
  for (int k = 0; k < p->limits; k++) {
    long long margin = (long long)p->design->margin[k];
    snprintf(name, sizeof name, "clear_%d", k + 1);
    emit_net(m, EMIT_WIRE, false, name, "");
    emit_text(
        m,
        "assign %s = (!up[%d] && (up[%d:0] > %d'd%lld)) || (!down[%d] && (down[%d:0] > %d'd%lld));",
        name, w, w - 1, w, margin, w, w - 1, w, margin);
  }
  emit_text(
      m,
      "always @(posedge clk) begin\n  low_a_q <= low_a;\n  high_a_q <= high_a;\n  low_b_q <= low_b;\n"
      "  high_b_q <= high_b;\n  clear <= %s;\nend",
      p->limits == 1 ? "clear_1" : "{clear_2, clear_1}");
  emit_end(m);
}

/* Bit k of what has a bit for each clearance. */
static void of_limit(const exact_plan *p, const char *name, int k, char text[EMIT_NAME]) {
  if (p->limits == 1) {
    snprintf(text, EMIT_NAME, "%.30s", name);
  } else {
    snprintf(text, EMIT_NAME, "%.30s[%d]", name, k);
  }
}

static void decide_ports(emit_module *m, const exact_plan *p) {
  char found[16];
  char each[16];
  char name[EMIT_NAME];
  snprintf(found, sizeof found, "%d", p->limits + 2);
  snprintf(each, sizeof each, "%d", p->limits);
  for (int i = 1; i <= 3; i++) {
    for (int t = 0; t < 2; t++) {
      snprintf(name, sizeof name, "f_%c%d", "sw"[t], i);
      emit_signal(m, EMIT_INPUT, false, name, found, "volume of %c and %c_%d", "AB"[t], "BA"[t], i);
      snprintf(name, sizeof name, "r_%c%d", "sw"[t], i);
      emit_signal(m, EMIT_INPUT, false, name, "2", "how that goes along edge %d of %c", i, "BA"[t]);
    }
    for (int j = 1; j <= 3; j++) {
      snprintf(name, sizeof name, "f_d%d%d", i, j);
      emit_signal(m, EMIT_INPUT, false, name, found, "volume of e_%d and f_%d", i, j);
    }
  }
  for (int i = 0; i < 3; i++) {
    snprintf(name, sizeof name, "box_%c", "xyz"[i]);
    emit_signal(m, EMIT_INPUT, false, name, each, "boxes are clear");
    for (int k = 0; k < 6; k++) {
      snprintf(name, sizeof name, "e_%s_%c%d", exact_projection_name(i), "ab"[k / 3], k % 3 + 1);
      emit_signal(m, EMIT_INPUT, false, name, each, "clear by edge %d of %c", k % 3 + 1,
                  "AB"[k / 3]);
    }
  }
  emit_signal(m, EMIT_OUTPUT, false, "coplanar", "", "all volumes are zero");
  emit_signal(m, EMIT_OUTPUT, false, "band", "2", "0 free, 1 warning, 2 collision");
  emit_signal(m, EMIT_OUTPUT, false, "axis", "4", "0 ... 13");
}

/* Bits of by_K: 0 ... 8 e_i x f_j, 9 N_A, 10 N_B, 11 edges, 12 boxes. */
static void decide_by(emit_module *m, const exact_plan *p, int k) {
  char name[EMIT_NAME];
  char bit[6][EMIT_NAME];
  int sign = p->limits;
  snprintf(name, sizeof name, "by_%d", k + 1);
  emit_signal(m, EMIT_WIRE, false, name, "13",
              "what is clear of clearance %d: 1 ... 9, 10, 11, 12, 13", k + 1);
  for (int i = 0; i < 3; i++) {
    for (int j = 0; j < 3; j++) {
      emit_text(
          m,
          "assign by_%d[%d] = f_d%d%d[%d] && (f_d%d%d[%d] ? r_s%d[1] && r_w%d[1] : r_s%d[0] && r_w%d[0]);",
          k + 1, 3 * i + j, i + 1, j + 1, k, i + 1, j + 1, sign, j + 1, i + 1, j + 1, i + 1);
    }
  }
  for (int t = 0; t < 2; t++) {
    char c = "sw"[t];
    emit_text(m,
              "assign by_%d[%d] = f_%c1[%d] && f_%c2[%d] && f_%c3[%d] &&\n"
              "               (f_%c1[%d] == f_%c2[%d]) && (f_%c1[%d] == f_%c3[%d]);",
              k + 1, 9 + t, c, k, c, k, c, k, c, sign, c, sign, c, sign, c, sign);
  }
  emit_text(m, "assign by_%d[11] =", k + 1);
  for (int i = 0; i < 3; i++) {
    for (int n = 0; n < 6; n++) {
      snprintf(name, sizeof name, "e_%s_%c%d", exact_projection_name(i), "ab"[n / 3], n % 3 + 1);
      of_limit(p, name, k, bit[n]);
    }
    emit_text(m, "  %s || %s || %s || %s || %s || %s%s", bit[0], bit[1], bit[2], bit[3], bit[4],
              bit[5], i < 2 ? " ||" : ";");
  }
  for (int i = 0; i < 3; i++) {
    snprintf(name, sizeof name, "box_%c", "xyz"[i]);
    of_limit(p, name, k, bit[i]);
  }
  emit_text(m, "assign by_%d[12] = %s || %s || %s;", k + 1, bit[0], bit[1], bit[2]);
}

static void gen_decide_band(emitter *e, const exact_plan *p) {
  emit_module *m = emit_begin(
      e, "sepax_decide_band",
      "The band, and the axis that proves it, from what is farther apart than the limits. f: {zero,\n"
      "below zero, beyond the limit of each clearance}. Combinational. In this order:\n"
      "  13       x, y or z: the boxes are clear\n"
      "  10       N_A: all f_s are beyond on one side\n"
      "  11       N_B: all f_w\n"
      "  1 ... 9  e_i x f_j at 1 + 3 (i - 1) + (j - 1): f_d is beyond, and where it is above\n"
      "           zero s does not rise along f_j nor w along e_i; below zero, not fall\n"
      "  12       normal to an edge and to x, y or z\n"
      "  0        none: collision");
  decide_ports(m, p);
  for (int k = 0; k < p->limits; k++) {
    decide_by(m, p, k);
  }
  emit_net(m, EMIT_WIRE, false, "by", "13");
  int zero = p->limits + 1;
  emit_text(
      m,
      "assign coplanar = f_s1[%d] && f_s2[%d] && f_s3[%d] && f_w1[%d] && f_w2[%d] && f_w3[%d] &&\n"
      "                  f_d11[%d] && f_d12[%d] && f_d13[%d] && f_d21[%d] && f_d22[%d] && f_d23[%d] &&\n"
      "                  f_d31[%d] && f_d32[%d] && f_d33[%d];",
      zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero);
  if (p->limits == 1) {
    emit_text(m, "assign by = by_1;\nassign band = (by_1 != 13'd0) ? 2'd0 : 2'd2;");
  } else {
    emit_text(m, "assign by = (by_2 != 13'd0) ? by_2 : by_1;\n"
                 "assign band = (by_2 != 13'd0) ? 2'd0 : (by_1 != 13'd0) ? 2'd1 : 2'd2;");
  }
  emit_text(
      m,
      "assign axis = by[12] ? 4'd13 :\n              by[9] ? 4'd10 :\n              by[10] ? 4'd11 :");
  for (int k = 0; k < 9; k++) {
    emit_text(m, "              by[%d] ? 4'd%d :", k, k + 1);
  }
  emit_text(m, "              by[11] ? 4'd12 :\n              4'd0;");
  emit_end(m);
}

static void gen_turn(emitter *e) {
  emit_module *m = emit_begin(
      e, "sepax_turn",
      "A copy of one bit of the frame's cycle, one cycle later; a module, lest synthesis\n"
      "make one of all copies.");
  emit_signal(m, EMIT_INPUT, false, "clk", "", "clock");
  emit_signal(m, EMIT_INPUT, false, "at", "", "this is the cycle");
  emit_signal(m, EMIT_OUTPUT_REG, false, "at_q", "", "the last cycle was it");
  emit_text(m, "\nalways @(posedge clk) begin\n  at_q <= at;\nend");
  emit_end(m);
}

void gen_exact_clear_units(emitter *e, const exact_plan *p) {
  if (p->design->config.ii > 1) {
    gen_turn(e);
  }
  gen_bounds(e);
  gen_small(e, p);
  gen_limit(e, p, "sepax_limit", SEPAX_X_CROSS, "e x f");
  gen_limit(e, p, "sepax_own_limit", SEPAX_X_ORIENT2D, "N_A or N_B");
  gen_edge_limit(e, p);
  gen_beyond(e, p);
  gen_edge_clear(e, p);
  gen_far(e, p);
  gen_decide_band(e, p);
}

/* ---------------------------------------------------------------------- in the core */

void core_declare_clear(core *c) {
  for (exact_class_id id = EXACT_STRIP_YZ; id <= EXACT_SLOPE_B; id++) {
    for (int k = 0; k < exact_units(c->p, id); k++) {
      const schedule_stream *t = &c->p->schedule.stream[c->p->class[id].stream + k];
      emit_net(c->m, EMIT_WIRE, t->is_signed, t->name, t->width);
    }
  }
}

/* Units of a class that read `operands` others, by these ports. */
static void units_of(core *c, exact_class_id id, const char *module, const char *const port[],
                     const char *const width[], const char *out) {
  for (int n = 0; n < exact_units(c->p, id); n++) {
    unit u = core_unit_of(c, id, n);
    char name[EMIT_NAME];
    char connections[512] = "clk=clk";
    core_describe(c, &u);
    for (int i = 0; port[i] != NULL; i++) {
      source text;
      core_operand(c, &u, i, width[i], text);
      size_t used = strlen(connections);
      snprintf(connections + used, sizeof connections - used, ", %s=%s", port[i], text);
    }
    snprintf(name, sizeof name, "unit_%.30s", u.out->name);
    emit_instance(c->m, module, name, "", "%s, %s=%s", connections, out, u.out->name);
  }
}

static void edge_limits(core *c) {
  static const char *const from_name[] = {"x_from", "y_from", "z_from"};
  static const char *const to_name[] = {"x_to", "y_to", "z_to"};
  for (int n = 0; n < exact_units(c->p, EXACT_EDGE_LIMIT); n++) {
    unit u = core_unit_of(c, EXACT_EDGE_LIMIT, n);
    int from[SEPAX_II_MAX] = {0};
    int to[SEPAX_II_MAX] = {0};
    source text[6];
    char name[EMIT_NAME];
    for (int k = 0; k < u.slots; k++) {
      from[k] = u.operation[k];
      to[k] = from[k] / 3 * 3 + (from[k] + 1) % 3;
    }
    core_describe(c, &u);
    for (int axis = 0; axis < 3; axis++) {
      core_point(c, &u, from_name[axis], "xyz"[axis], from, text[axis]);
      core_point(c, &u, to_name[axis], "xyz"[axis], to, text[3 + axis]);
    }
    snprintf(name, sizeof name, "unit_%.30s", u.out->name);
    emit_instance(c->m, "sepax_edge_limit", name, "",
                  "clk=clk, x_from=%s, x_to=%s, y_from=%s, y_to=%s, z_from=%s, z_to=%s, limit=%s",
                  text[0], text[3], text[1], text[4], text[2], text[5], u.out->name);
  }
}

/* The part of an edge's limits that a projection reads. */
static void edge_limit_of(core *c, const unit *u, int projection, source out) {
  source text[SEPAX_II_MAX];
  char name[EMIT_NAME];
  for (int k = 0; k < u->slots; k++) {
    schedule_value v[EXACT_TERMS];
    source whole;
    exact_operands(c->p, u->id, u->operation[k], v);
    schedule_source(&c->p->schedule, v[1], u->start + k, whole);
    snprintf(text[k], EMIT_NAME, "%.30s[%d*M_W-1:%d*M_W]", whole, projection + 1, projection);
  }
  snprintf(name, sizeof name, "%.40s_t", u->out->name);
  core_choose(c, name, "M_W", false, u->start, u->slots, text, out);
}

static void edge_tests(core *c, int projection) {
  static const char *const edge[] = {"b_1", "b_2", "b_3", "own", NULL};
  static const char *const width[] = {"LIMITS+1", "LIMITS+1", "LIMITS+1", "G_W"};
  exact_class_id id = exact_projected(EXACT_BEYOND_XY, projection);
  for (int n = 0; n < exact_units(c->p, id); n++) {
    unit u = core_unit_of(c, id, n);
    source g;
    source limit;
    char name[EMIT_NAME];
    core_describe(c, &u);
    core_operand(c, &u, 0, "G_W", g);
    edge_limit_of(c, &u, projection, limit);
    snprintf(name, sizeof name, "unit_%.30s", u.out->name);
    emit_instance(c->m, "sepax_beyond", name, "", "clk=clk, g=%s, limit=%s, far=%s", g, limit,
                  u.out->name);
  }
  units_of(c, exact_projected(EXACT_EDGE_XY, projection), "sepax_edge_clear", edge, width, "clear");
}

static void boxes(core *c) {
  for (int n = 0; n < exact_units(c->p, EXACT_BOX); n++) {
    unit u = core_unit_of(c, EXACT_BOX, n);
    source text[6];
    char name[EMIT_NAME];
    core_describe(c, &u);
    for (int v = 0; v < 6; v++) {
      source from[SEPAX_II_MAX];
      for (int k = 0; k < u.slots; k++) {
        core_coordinate(c, "xyz"[u.operation[k]], v, 0, u.start + k, from[k]);
      }
      snprintf(name, sizeof name, "%.30s_%s", u.out->name, core_vertex_name(v));
      core_choose(c, name, "W", true, u.start, u.slots, from, text[v]);
    }
    snprintf(name, sizeof name, "unit_%.30s", u.out->name);
    emit_instance(c->m, "sepax_box_clear", name, "",
                  "clk=clk, a_1=%s, a_2=%s, a_3=%s, b_1=%s, b_2=%s, b_3=%s, clear=%s", text[0],
                  text[1], text[2], text[3], text[4], text[5], u.out->name);
  }
}

void core_clear(core *c) {
  static const char *const pq[] = {"p", "q", NULL};
  static const char *const xyz[] = {"x", "y", "z", NULL};
  static const char *const v_limit[] = {"v", "limit", NULL};
  static const char *const areas[] = {"G_W", "G_W", "G_W"};
  static const char *const crosses[] = {"C_W", "C_W", "C_W"};
  static const char *const volumes[] = {"V_W", "V_W"};
  static const char *const volume_limit[] = {"V_W", "LIMITS*L_W"};
  emit_text(c->m, "\n// c: components of e x f; l, lo, le: limits.");
  c->turn = TURN_LIMITS;
  for (int projection = 0; projection < 3; projection++) {
    units_of(c, exact_projected(EXACT_CROSS_XY, projection), "sepax_cross", pq, areas, "c");
  }
  units_of(c, EXACT_LIMIT, "sepax_limit", xyz, crosses, "limit");
  units_of(c, EXACT_OWN_LIMIT, "sepax_own_limit", xyz, areas, "limit");
  edge_limits(c);
  emit_text(c->m, "\n// What is beyond them; rs, rw: how volumes go along the edges.");
  c->turn = TURN_EDGES;
  for (int projection = 0; projection < 3; projection++) {
    edge_tests(c, projection);
  }
  c->turn = TURN_BOXES;
  boxes(c);
  c->turn = TURN_FAR;
  units_of(c, EXACT_FAR_A, "sepax_far", v_limit, volume_limit, "far");
  units_of(c, EXACT_FAR_B, "sepax_far", v_limit, volume_limit, "far");
  units_of(c, EXACT_FAR_BETWEEN, "sepax_far", v_limit, volume_limit, "far");
  units_of(c, EXACT_SLOPE_A, "sepax_slope", pq, volumes, "slope");
  units_of(c, EXACT_SLOPE_B, "sepax_slope", pq, volumes, "slope");
}

static void bind(core *c, FILE *out, const char *port, exact_class_id id, int operation) {
  source text;
  schedule_source(&c->p->schedule, exact_value(c->p, id, operation), c->p->verdict_cycle, text);
  fprintf(out, ", %s=%s", port, text);
}

void core_decide_band(core *c) {
  char text[4096];
  char port[EMIT_NAME];
  FILE *out = fmemopen(text, sizeof text, "w");
  if (out == NULL) {
    abort();
  }
  for (int i = 0; i < 3; i++) {
    for (int t = 0; t < 2; t++) {
      snprintf(port, sizeof port, "f_%c%d", "sw"[t], i + 1);
      bind(c, out, port, t == 0 ? EXACT_FAR_A : EXACT_FAR_B, i);
      snprintf(port, sizeof port, "r_%c%d", "sw"[t], i + 1);
      bind(c, out, port, t == 0 ? EXACT_SLOPE_A : EXACT_SLOPE_B, i);
    }
    for (int j = 0; j < 3; j++) {
      snprintf(port, sizeof port, "f_d%d%d", i + 1, j + 1);
      bind(c, out, port, EXACT_FAR_BETWEEN, exact_between(i, j));
    }
    snprintf(port, sizeof port, "box_%c", "xyz"[i]);
    bind(c, out, port, EXACT_BOX, i);
    for (int k = 0; k < 6; k++) {
      snprintf(port, sizeof port, "e_%s_%c%d", exact_projection_name(i), "ab"[k / 3], k % 3 + 1);
      bind(c, out, port, exact_projected(EXACT_EDGE_XY, i), k);
    }
  }
  fclose(out);
  emit_text(c->m, "\n// The verdict, in cycle %d of a pair.", c->p->verdict_cycle);
  emit_instance(c->m, "sepax_decide_band", "decide", "",
                "coplanar=coplanar, band=band, axis=axis%s", text);
}
