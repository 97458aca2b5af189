/* gen_exact_near.c - the box test before architecture exact. For any triangle: sepax_apart and the
 * sepax_top around it. For triangles that are no larger than the design's extents: sepax_approach
 * and its sepax_top. */
#include "exact/exact.h"
#include "sepax_design.h"

#include <string.h>

/* Cycles from a pair taken to the core that it is offered to. */
enum { APPROACH_CYCLES = 2, APART_CYCLES = 1 };

void gen_bounds(emitter *e) {
  if (emit_find(e, "sepax_bounds") != NULL) {
    return;
  }
  emit_module *m =
      emit_begin(e, "sepax_bounds", "Least and greatest of three coordinates. Combinational.");
  emit_parameter(m, EMIT_PARAMETER, "W", e->design->config.word, "bits of a coordinate");
  emit_signal(m, EMIT_INPUT, true, "p", "W", "coordinate");
  emit_signal(m, EMIT_INPUT, true, "q", "W", "coordinate");
  emit_signal(m, EMIT_INPUT, true, "r", "W", "coordinate");
  emit_signal(m, EMIT_OUTPUT, true, "low", "W", "the least");
  emit_signal(m, EMIT_OUTPUT, true, "high", "W", "the greatest");
  emit_net(m, EMIT_WIRE, false, "p_q", "");
  emit_net(m, EMIT_WIRE, false, "p_r", "");
  emit_net(m, EMIT_WIRE, false, "q_r", "");
  emit_text(m, "assign p_q = p < q;\nassign p_r = p < r;\nassign q_r = q < r;\n"
               "assign low = p_q ? (p_r ? p : r) : (q_r ? q : r);\n"
               "assign high = p_q ? (q_r ? r : q) : (p_r ? r : p);");
  emit_end(m);
}

/* Boxes from low_a to high_a and from low_b to high_b, each with this suffix: apart by more than
 * the margin? */
static gen_line apart_text(emit_module *m, const sepax_design *design, const char *suffix) {
  if (design->limits == 0) {
    return gen_format("(high_a%s < low_b%s) || (high_b%s < low_a%s)", suffix, suffix, suffix,
                      suffix);
  }
  int word = design->config.word;
  long long margin = (long long)design->margin[1];
  for (int k = 0; k < 2; k++) {
    const char *name = k == 0 ? "up" : "down";
    char upper = "ba"[k];
    char lower = "ab"[k];
    emit_net(m, EMIT_WIRE, false, name, gen_format("%d", word + 1).text);
    emit_text(m, "assign %s = {low_%c%s[W-1], low_%c%s} - {high_%c%s[W-1], high_%c%s};", name,
              upper, suffix, upper, suffix, lower, suffix, lower, suffix);
  }
  return gen_format("(!up[W] && (up[W-1:0] > %d'd%lld)) || (!down[W] && (down[W-1:0] > %d'd%lld))",
                    word, margin, word, margin);
}

static void gen_approach(emitter *e) {
  const sepax_config *c = &e->design->config;
  int near = e->design->core_word;
  bool of_a = c->extent_a > c->extent_b;
  int64_t lesser = (of_a ? c->extent_b : c->extent_a) + e->design->margin[1];
  char name[EMIT_NAME];
  emit_module *m = emit_begin(
      e, "sepax_approach",
      "One coordinate of a pair: are the boxes apart, is one larger than its extent; and if\n"
      "neither, the coordinates from a point near the lower end of the larger kind:\n"
      "  near = coordinate - low + origin, modulo 2^N\n"
      "Latency 2.");
  emit_parameter(m, EMIT_PARAMETER, "W", c->word, "bits of a coordinate");
  emit_parameter(m, EMIT_PARAMETER, "N", near, "bits of a coordinate from nearby");
  emit_signal(m, EMIT_INPUT, false, "clk", "", "clock");
  emit_signal(m, EMIT_INPUT, false, "en_1", "", "the first stage takes the coordinates");
  emit_signal(m, EMIT_INPUT, false, "en_2", "", "the second stage takes them from the first");
  for (int i = 0; i < 6; i++) {
    snprintf(name, sizeof name, "%c_%d", "ab"[i / 3], i % 3 + 1);
    emit_signal(m, EMIT_INPUT, true, name, "W", "coordinate of %c_%d", "AB"[i / 3], i % 3 + 1);
  }
  emit_signal(m, EMIT_OUTPUT_REG, false, "apart", "", "the boxes are disjoint in this coordinate");
  emit_signal(m, EMIT_OUTPUT_REG, false, "beyond", "", "A is longer than %d, or B than %d",
              c->extent_a, c->extent_b);
  for (int i = 0; i < 6; i++) {
    snprintf(name, sizeof name, "near_%c_%d", "ab"[i / 3], i % 3 + 1);
    emit_signal(m, EMIT_OUTPUT_REG, true, name, "N", "%c_%d from nearby", "AB"[i / 3], i % 3 + 1);
  }
  for (int t = 0; t < 2; t++) {
    static const char *const end[] = {"low", "high"};
    for (int k = 0; k < 2; k++) {
      snprintf(name, sizeof name, "%s_%c", end[k], "ab"[t]);
      emit_net(m, EMIT_WIRE, true, name, "W");
      snprintf(name, sizeof name, "%s_%c_1", end[k], "ab"[t]);
      emit_net(m, EMIT_REG, true, name, "W");
    }
    snprintf(name, sizeof name, "size_%c", "ab"[t]);
    emit_net(m, EMIT_WIRE, false, name, "W");
    for (int k = 0; k < 3; k++) {
      snprintf(name, sizeof name, "%c_%d_1", "ab"[t], k + 1);
      emit_net(m, EMIT_REG, true, name, "N");
    }
  }
  emit_net(m, EMIT_WIRE, true, "origin", "N");
  emit_net(m, EMIT_WIRE, true, "base", "N");
  emit_blank(m);
  for (int t = 0; t < 2; t++) {
    char x = "ab"[t];
    snprintf(name, sizeof name, "bounds_%c", x);
    emit_instance(m, "sepax_bounds", name, "W=W",
                  "p=%c_1, q=%c_2, r=%c_3, low=low_%c, high=high_%c", x, x, x, x, x);
  }
  emit_text(m, "\nassign size_a = high_a_1 - low_a_1;\nassign size_b = high_b_1 - low_b_1;");
  emit_text(m, "assign origin = %d'd%lld;", near,
            (long long)((lesser + (INT64_C(1) << (near - 1))) & ((INT64_C(1) << near) - 1)));
  emit_text(m, "assign base = low_%c_1[N-1:0];", of_a ? 'a' : 'b');
  const gen_line apart = apart_text(m, e->design, "_1");
  emit_text(
      m,
      "\nalways @(posedge clk) begin\n  if (en_1) begin\n"
      "    low_a_1 <= low_a;\n    high_a_1 <= high_a;\n    low_b_1 <= low_b;\n    high_b_1 <= high_b;");
  for (int i = 0; i < 6; i++) {
    char x = "ab"[i / 3];
    emit_text(m, "    %c_%d_1 <= %c_%d[N-1:0];", x, i % 3 + 1, x, i % 3 + 1);
  }
  emit_text(m,
            "  end\n  if (en_2) begin\n"
            "    apart <= %s;\n"
            "    beyond <= (size_a > %d'd%d) || (size_b > %d'd%d);",
            apart.text, c->word, c->extent_a, c->word, c->extent_b);
  for (int i = 0; i < 6; i++) {
    char x = "ab"[i / 3];
    emit_text(m, "    near_%c_%d <= %c_%d_1 - base + origin;", x, i % 3 + 1, x, i % 3 + 1);
  }
  emit_text(m, "  end\nend");
  emit_end(m);
}

int gen_exact_near(emitter *e, const exact_plan *p) {
  const sepax_config *c = &e->design->config;
  char banner[1024];
  char every[24];
  char connections[2048];
  char name[EMIT_NAME];
  gen_bounds(e);
  gen_approach(e);
  gen_exact_every(p, every);
  char apart[96] = "with disjoint boxes are separated (axis 13); of the";
  if (e->design->limits > 0) {
    snprintf(apart, sizeof apart, "with boxes more than %lld LSB apart are free (axis 13); of the",
             (long long)e->design->margin[1]);
  }
  snprintf(banner, sizeof banner,
           "Exact collision detection of two triangles of which the boxes are at most %d (A)\n"
           "and %d (B) LSB long. Pairs %s\n"
           "others those that are larger are called collisions, undecided, and flagged\n"
           "(out_of_range, axis 14); for the rest %d bits of %d are enough.\n"
           "valid/ready on both sides; a pair every %s, verdicts in order.\n"
           "Latency %d cycles from the one in which a pair is taken to its verdict, both\n"
           "counted%s. Outputs are 0 without out_valid.",
           c->extent_a, c->extent_b, apart, e->design->core_word, c->word, every,
           p->latency + APPROACH_CYCLES, c->ii > 1 ? ", when the machine was empty" : "");
  emit_module *m = emit_begin(e, "sepax_top", banner);
  gen_exact_ports(m, c->word);
  emit_signal(m, EMIT_OUTPUT, false, "out_of_range", "",
              "1: a triangle is larger than its extent; a collision, undecided");
  static const char *const wires[] = {"en_1",   "en_2", "ready",        "apart",
                                      "beyond", "work", "near_coplanar"};
  emit_net(m, EMIT_REG, false, "valid_1", "");
  emit_net(m, EMIT_REG, false, "valid_2", "");
  for (size_t i = 0; i < sizeof wires / sizeof wires[0]; i++) {
    emit_net(m, EMIT_WIRE, false, wires[i], "");
  }
  emit_net(m, EMIT_WIRE, false, "near_axis", "4");
  emit_net(m, EMIT_WIRE, false, "near_collision", "");
  bool bands = e->design->limits > 0;
  if (bands) {
    emit_signal(m, EMIT_OUTPUT, false, "out_band", "2", "0 free, 1 warning, 2 collision");
    emit_net(m, EMIT_WIRE, false, "near_band", "2");
  }
  emit_net(m, EMIT_WIRE, false, "note", "2");
  for (int axis = 'x'; axis <= 'z'; axis++) {
    char bits[16];
    snprintf(bits, sizeof bits, "%d", e->design->core_word);
    for (int i = 0; i < 6; i++) {
      snprintf(name, sizeof name, "near_%c%d_%c", "ab"[i / 3], i % 3 + 1, axis);
      emit_net(m, EMIT_WIRE, true, name, bits);
      snprintf(name, sizeof name, "core_%c%d_%c", "ab"[i / 3], i % 3 + 1, axis);
      emit_net(m, EMIT_WIRE, true, name, bits);
    }
    snprintf(name, sizeof name, "apart_%c", axis);
    emit_net(m, EMIT_WIRE, false, name, "");
    snprintf(name, sizeof name, "beyond_%c", axis);
    emit_net(m, EMIT_WIRE, false, name, "");
  }
  emit_text(
      m,
      "\nassign en_2 = !valid_2 || ready;\nassign en_1 = !valid_1 || en_2;\nassign in_ready = en_1;\n"
      "assign apart = apart_x || apart_y || apart_z;\n"
      "assign beyond = !apart && (beyond_x || beyond_y || beyond_z);");
  emit_text(
      m,
      "\nalways @(posedge clk) begin\n  if (rst) begin\n    valid_1 <= 1'b0;\n    valid_2 <= 1'b0;\n"
      "  end else begin\n    if (en_1) begin\n      valid_1 <= in_valid;\n    end\n"
      "    if (en_2) begin\n      valid_2 <= valid_1;\n    end\n  end\nend");
  for (int axis = 'x'; axis <= 'z'; axis++) {
    size_t used = (size_t)snprintf(
        connections, sizeof connections,
        "clk=clk, en_1=en_1, en_2=en_2, apart=apart_%c, beyond=beyond_%c", axis, axis);
    for (int i = 0; i < 6; i++) {
      char x = "ab"[i / 3];
      int k = i % 3 + 1;
      used += (size_t)snprintf(connections + used, sizeof connections - used,
                               ", %c_%d=in_%c%d_%c, near_%c_%d=near_%c%d_%c", x, k, x, k, axis, x,
                               k, x, k, axis);
    }
    snprintf(name, sizeof name, "approach_%c", axis);
    emit_blank(m);
    emit_instance(m, "sepax_approach", name, "", "%s", connections);
  }
  emit_text(
      m,
      "\n// Pairs that the boxes decide enter the core as zeros, which it passes on without a transition.\n"
      "assign work = valid_2 && !apart;");
  for (int k = 0; k < 18; k++) {
    char end[8];
    snprintf(end, sizeof end, "%c%d_%c", "ab"[k / 3 % 2], k % 3 + 1, "xyz"[k / 6]);
    emit_text(m, "assign core_%s = near_%s & {%d{work}};", end, end, e->design->core_word);
  }
  size_t used =
      (size_t)snprintf(connections, sizeof connections,
                       "clk=clk, rst=rst, in_valid=valid_2, in_ready=ready, in_apart=apart, "
                       "in_beyond=beyond, out_valid=out_valid, out_ready=out_ready, "
                       "out_collision=near_collision, out_coplanar=near_coplanar, "
                       "out_axis=near_axis, out_note=note%s",
                       bands ? ", out_band=near_band" : "");
  for (int axis = 'x'; axis <= 'z'; axis++) {
    for (int i = 0; i < 6; i++) {
      char x = "ab"[i / 3];
      int k = i % 3 + 1;
      used += (size_t)snprintf(connections + used, sizeof connections - used,
                               ", in_%c%d_%c=core_%c%d_%c", x, k, axis, x, k, axis);
    }
  }
  emit_blank(m);
  emit_instance(m, "sepax_near", "near", "", "%s", connections);
  emit_text(
      m,
      "\nassign out_of_range = out_valid && note[0];\n"
      "assign out_coplanar = near_coplanar && (note == 2'd0);\n"
      "assign out_collision = out_of_range || (near_collision && (note == 2'd0));\n"
      "assign out_axis = (note == 2'd0) ? near_axis : ({2'b11, note[0], note[1]} & {4{out_valid}});");
  if (bands) {
    emit_text(m, "assign out_band = (note == 2'd0) ? near_band : {out_of_range, 1'b0};");
  }
  emit_end(m);
  return APPROACH_CYCLES;
}

/* --------------------------------------------------------------------- any triangle */

static void gen_apart(emitter *e) {
  emit_module *m =
      emit_begin(e, "sepax_apart", "One coordinate of a pair: are the boxes apart? Combinational.");
  emit_parameter(m, EMIT_PARAMETER, "W", e->design->config.word, "bits of a coordinate");
  for (int i = 0; i < 6; i++) {
    emit_signal(m, EMIT_INPUT, true, gen_format("%c_%d", "ab"[i / 3], i % 3 + 1).text, "W",
                "coordinate of %c_%d", "AB"[i / 3], i % 3 + 1);
  }
  emit_signal(m, EMIT_OUTPUT, false, "apart", "", "the boxes are disjoint in this coordinate");
  for (int t = 0; t < 2; t++) {
    emit_net(m, EMIT_WIRE, true, gen_format("low_%c", "ab"[t]).text, "W");
    emit_net(m, EMIT_WIRE, true, gen_format("high_%c", "ab"[t]).text, "W");
  }
  emit_blank(m);
  for (int t = 0; t < 2; t++) {
    char x = "ab"[t];
    emit_instance(m, "sepax_bounds", gen_format("bounds_%c", x).text, "W=W",
                  "p=%c_1, q=%c_2, r=%c_3, low=low_%c, high=high_%c", x, x, x, x, x);
  }
  emit_blank(m);
  const gen_line apart = apart_text(m, e->design, "");
  emit_text(m, "assign apart = %s;", apart.text);
  emit_end(m);
}

int gen_exact_boxes(emitter *e, const exact_plan *p) {
  const sepax_config *c = &e->design->config;
  bool bands = e->design->limits > 0;
  char connections[2048];
  char every[24];
  gen_bounds(e);
  gen_apart(e);
  gen_exact_every(p, every);
  gen_line margin = {""};
  if (bands) {
    margin = gen_format(" by more than %lld", (long long)e->design->margin[1]);
  }
  emit_module *m = emit_begin(
      e, "sepax_top",
      gen_format(
          "Exact collision detection of two triangles: the verdict is the mathematical one\n"
          "for every input%s. Pairs of which the boxes are disjoint%s are told at\n"
          "once (axis 13) and enter the core as zeros, which it passes on without a transition.\n"
          "valid/ready on both sides; a pair every %s, verdicts in order.\n"
          "Latency %d cycles from the one in which a pair is taken to its verdict, both\n"
          "counted%s. Outputs are 0 without out_valid.",
          c->flag ? " but coplanar ones, which are called collisions and flagged" : "", margin.text,
          every, p->latency + APART_CYCLES, c->ii > 1 ? ", when the machine was empty" : "")
          .text);
  gen_exact_ports(m, c->word);
  static const char *const wires[] = {"ready",          "take",          "apart", "work",
                                      "near_collision", "near_coplanar", "note"};
  emit_net(m, EMIT_REG, false, "valid", "");
  for (size_t i = 0; i < sizeof wires / sizeof wires[0]; i++) {
    emit_net(m, EMIT_WIRE, false, wires[i], "");
  }
  emit_net(m, EMIT_WIRE, false, "near_axis", "4");
  if (bands) {
    emit_signal(m, EMIT_OUTPUT, false, "out_band", "2", "0 free, 1 warning, 2 collision");
  }
  const gen_line width = gen_format("%d", c->word);
  gen_line end[18]; /* x of all vertices first */
  for (int k = 0; k < 18; k++) {
    end[k] = gen_format("%c%d_%c", "ab"[k / 3 % 2], k % 3 + 1, "xyz"[k / 6]);
    emit_net(m, EMIT_REG, true, end[k].text, width.text);
    emit_net(m, EMIT_WIRE, true, gen_format("core_%s", end[k].text).text, width.text);
  }
  for (int axis = 'x'; axis <= 'z'; axis++) {
    emit_net(m, EMIT_WIRE, false, gen_format("apart_%c", axis).text, "");
  }
  emit_text(m, "\nassign in_ready = !valid || ready;\nassign take = in_valid && in_ready;\n"
               "assign apart = apart_x || apart_y || apart_z;\nassign work = valid && !apart;");
  emit_text(m, "\nalways @(posedge clk) begin\n  if (rst) begin\n    valid <= 1'b0;\n"
               "  end else if (in_ready) begin\n    valid <= in_valid;\n  end\n  if (take) begin");
  for (int k = 0; k < 18; k++) {
    emit_text(m, "    %s <= in_%s;", end[k].text, end[k].text);
  }
  emit_text(m, "  end\nend");
  for (int axis = 0; axis < 3; axis++) {
    size_t used = (size_t)snprintf(connections, sizeof connections, "apart=apart_%c", 'x' + axis);
    for (int i = 0; i < 6; i++) {
      used += (size_t)snprintf(connections + used, sizeof connections - used, ", %c_%d=%s",
                               "ab"[i / 3], i % 3 + 1, end[6 * axis + i].text);
    }
    emit_blank(m);
    emit_instance(m, "sepax_apart", gen_format("boxes_%c", 'x' + axis).text, "", "%s", connections);
  }
  emit_blank(m);
  size_t used =
      (size_t)snprintf(connections, sizeof connections,
                       "clk=clk, rst=rst, in_valid=valid, in_ready=ready, in_apart=apart, "
                       "out_valid=out_valid, out_ready=out_ready, out_collision=near_collision, "
                       "out_coplanar=near_coplanar, out_axis=near_axis, out_note=note%s",
                       bands ? ", out_band=near_band" : "");
  for (int k = 0; k < 18; k++) {
    emit_text(m, "assign core_%s = %s & {%d{work}};", end[k].text, end[k].text, c->word);
    used += (size_t)snprintf(connections + used, sizeof connections - used, ", in_%s=core_%s",
                             end[k].text, end[k].text);
  }
  if (bands) {
    emit_net(m, EMIT_WIRE, false, "near_band", "2");
  }
  emit_blank(m);
  emit_instance(m, "sepax_near", "near", "", "%s", connections);
  emit_text(
      m,
      "\nassign out_coplanar = near_coplanar && !note;\nassign out_collision = near_collision && !note;\n"
      "assign out_axis = note ? (4'd%d & {4{out_valid}}) : near_axis;",
      SEPAX_AXIS_AABB);
  if (bands) {
    emit_text(m, "assign out_band = note ? 2'd0 : near_band;");
  }
  emit_end(m);
  return APART_CYCLES;
}
