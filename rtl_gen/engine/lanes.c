/* gen_engine_lanes.c - the box lanes of the engine: sepax_walk, sepax_lane, sepax_lanes,
 * sepax_pick. */
#include "engine.h"

#include <string.h>

/* B's numbers run on to the number of lanes where B has fewer triangles. */
static int step_bits(const engine_plan *p) { return p->index_b + 1; }
/* A's run on by two rounds of lanes. */
static int number_bits(const engine_plan *p) { return p->index_a + 2; }

static void gen_walk(emitter *e, const engine_plan *p) {
  emit_module *m = emit_begin(
      e, "sepax_walk",
      gen_format(
          "The order of the pairs. B's triangles come one a cycle, round and round; lane k takes\n"
          "A's next triangle when B_k comes, so that it sees each B once. In round g it holds\n"
          "  A_(%d g + k) from B_k on, before that A_(%d (g - 1) + k)\n"
          "A round is count_b steps long, or %d if that is more.",
          p->lanes, p->lanes, p->lanes)
          .text);
  int number = number_bits(p);
  int step = step_bits(p);
  const gen_line number_text = gen_format("%d", number);
  const gen_line step_text = gen_format("%d", step);
  emit_signal(m, EMIT_INPUT, false, "clk", "", "clock");
  emit_signal(m, EMIT_INPUT, false, "rst", "", "synchronous reset, active high");
  emit_signal(m, EMIT_INPUT, false, "start", "", "begin");
  emit_signal(m, EMIT_INPUT, false, "halt", "", "end");
  emit_signal(m, EMIT_INPUT, false, "room", "", "a step may be made");
  emit_signal(m, EMIT_INPUT, false, "count_a", gen_format("%d", p->index_a + 1).text,
              "triangles of A, 1 ...");
  emit_signal(m, EMIT_INPUT, false, "count_b", gen_format("%d", p->index_b + 1).text,
              "triangles of B, 1 ...");
  emit_signal(m, EMIT_OUTPUT_REG, false, "running", "", "not at the end");
  emit_signal(m, EMIT_OUTPUT, false, "step", "", "a step is made");
  emit_signal(m, EMIT_OUTPUT_REG, false, "j", step_text.text, "number of B's triangle");
  emit_signal(m, EMIT_OUTPUT, false, "is_b", "", "there is one");
  emit_signal(m, EMIT_OUTPUT, false, "address_b", gen_format("%d", p->index_b).text, "where it is");
  emit_signal(m, EMIT_OUTPUT, false, "round_base", gen_format("%d", p->index_a).text,
              "%d g, lowest bits", p->lanes);
  emit_signal(m, EMIT_OUTPUT, false, "address_a", gen_format("%d", p->index_a).text,
              "number of A's triangle for lane j");
  emit_signal(m, EMIT_OUTPUT, false, "load", "", "lane j takes it");
  emit_signal(m, EMIT_OUTPUT, false, "is_a", "", "there is one");
  emit_signal(m, EMIT_REG, false, "base", number_text.text, "%d g", p->lanes);
  emit_signal(m, EMIT_REG, false, "n", number_text.text, "base + j");
  emit_signal(m, EMIT_REG, false, "last_j", step_text.text, "end of a round");
  emit_signal(m, EMIT_REG, false, "last_n", number_text.text,
              "would take the last of A's out of its lane");
  emit_signal(m, EMIT_REG, false, "emptying", "", "the last round: no triangle of A is left");
  emit_net(m, EMIT_WIRE, false, "next_base", number_text.text);
  emit_net(m, EMIT_WIRE, false, "wide_a", number_text.text);
  emit_net(m, EMIT_WIRE, false, "finished", "");
  emit_text(
      m,
      "\nassign address_a = n[%d:0];\nassign address_b = j[%d:0];\nassign round_base = base[%d:0];\n"
      "assign wide_a = {%d'd0, count_a};\n"
      "assign next_base = base + %d'd%d;\n"
      "assign finished = emptying && (n == last_n);\n"
      "assign step = running && room && !finished;\n"
      "assign is_b = j < count_b;\n"
      "assign load = j < %d'd%d;\n"
      "assign is_a = !emptying && (n < wide_a);",
      p->index_a - 1, p->index_b - 1, p->index_a - 1, number - p->index_a - 1, number, p->lanes,
      step, p->lanes);
  emit_text(m,
            "\nalways @(posedge clk) begin\n"
            "  if (rst || halt) begin\n    running <= 1'b0;\n"
            "  end else if (start) begin\n    running <= 1'b1;\n"
            "  end else if (finished) begin\n    running <= 1'b0;\n  end\n"
            "  if (start) begin\n"
            "    j <= %d'd0;\n    n <= %d'd0;\n    base <= %d'd0;\n    emptying <= 1'b0;\n"
            "    last_j <= ((count_b > %d'd%d) ? count_b : %d'd%d) - %d'd1;\n"
            "    last_n <= wide_a + %d'd%d;\n"
            "  end else if (step) begin\n"
            "    if (j == last_j) begin\n"
            "      j <= %d'd0;\n      n <= next_base;\n      base <= next_base;\n"
            "      emptying <= !(next_base < wide_a);\n"
            "    end else begin\n      j <= j + %d'd1;\n      n <= n + %d'd1;\n    end\n"
            "  end\nend",
            step, number, number, step, p->lanes, step, p->lanes, step, number, p->lanes - 1, step,
            step, number);
  emit_end(m);
}

static void gen_lane(emitter *e, const engine_plan *p) {
  emit_module *m = emit_begin(
      e, "sepax_lane",
      "A box lane: holds the box of a triangle of A and tells at once whether that of a\n"
      "triangle of B meets it. Boxes are packed {high, low} of z, y, x, x lowest.");
  int w = p->word;
  int v = p->moved;
  emit_signal(m, EMIT_INPUT, false, "clk", "", "clock");
  emit_signal(m, EMIT_INPUT, false, "clear", "", "no box is held any more");
  emit_signal(m, EMIT_INPUT, false, "load", "", "take the next box of A");
  emit_signal(m, EMIT_INPUT, false, "is_a", "", "there is one");
  emit_signal(m, EMIT_INPUT, false, "box_a", gen_format("%d", 6 * w).text, "signed, %d bits each",
              w);
  emit_signal(m, EMIT_INPUT, false, "is_b", "", "a box of B is here");
  emit_signal(m, EMIT_INPUT, false, "box_b", gen_format("%d", 6 * v).text, "signed, %d bits each",
              v);
  emit_signal(m, EMIT_OUTPUT_REG, false, "live", "", "a box is held");
  emit_signal(m, EMIT_OUTPUT, false, "meets", "", "they share a point");
  emit_net(m, EMIT_REG, false, "held", gen_format("%d", 6 * w).text);
  for (int k = 0; k < 6; k++) {
    emit_net(m, EMIT_WIRE, true, gen_format("%s_a_%c", k % 2 ? "high" : "low", 'x' + k / 2).text,
             gen_format("%d", v).text);
    emit_net(m, EMIT_WIRE, true, gen_format("%s_b_%c", k % 2 ? "high" : "low", 'x' + k / 2).text,
             gen_format("%d", v).text);
  }
  emit_blank(m);
  for (int k = 0; k < 6; k++) {
    const char *end = k % 2 ? "high" : "low";
    emit_text(m, "assign %s_a_%c = {{%d{held[%d]}}, held[%d:%d]};", end, 'x' + k / 2, v - w,
              (k + 1) * w - 1, (k + 1) * w - 1, k * w);
    emit_text(m, "assign %s_b_%c = box_b[%d:%d];", end, 'x' + k / 2, (k + 1) * v - 1, k * v);
  }
  emit_text(m, "assign meets = live && is_b &&\n"
               "               !(high_a_x < low_b_x) && !(high_b_x < low_a_x) &&\n"
               "               !(high_a_y < low_b_y) && !(high_b_y < low_a_y) &&\n"
               "               !(high_a_z < low_b_z) && !(high_b_z < low_a_z);");
  emit_text(
      m,
      "\nalways @(posedge clk) begin\n"
      "  if (clear) begin\n    live <= 1'b0;\n  end else if (load) begin\n    live <= is_a;\n  end\n"
      "  if (load) begin\n    held <= box_a;\n  end\nend");
  emit_end(m);
}

static void gen_lanes(emitter *e, const engine_plan *p) {
  emit_module *m = emit_begin(
      e, "sepax_lanes",
      gen_format("%d box lanes. Boxes come from the memories one cycle after the step that\n"
                 "asked for them; B's is moved in another; its mask, bit k for lane k, leaves two\n"
                 "cycles later.",
                 p->lanes)
          .text);
  const gen_line step = gen_format("%d", step_bits(p));
  const gen_line base = gen_format("%d", p->index_a);
  const gen_line number = gen_format("%d", p->index_b);
  const gen_line mask = gen_format("%d", p->lanes);
  int w = p->word;
  int v = p->moved;
  emit_signal(m, EMIT_INPUT, false, "clk", "", "clock");
  emit_signal(m, EMIT_INPUT, false, "clear", "", "drop all that is under way");
  emit_signal(m, EMIT_INPUT, false, "step", "", "a step is made");
  emit_signal(m, EMIT_INPUT, false, "j", step.text, "number of B's triangle");
  emit_signal(m, EMIT_INPUT, false, "is_b", "", "there is one");
  emit_signal(m, EMIT_INPUT, false, "base", base.text, "first of A's triangles in this round");
  emit_signal(m, EMIT_INPUT, false, "load", "", "lane j takes a triangle of A");
  emit_signal(m, EMIT_INPUT, false, "is_a", "", "there is one");
  emit_signal(m, EMIT_INPUT, false, "box_a", gen_format("%d", 6 * w).text,
              "box of A, one cycle behind the step");
  emit_signal(m, EMIT_INPUT, false, "box_b", gen_format("%d", 6 * w).text, "box of B, likewise");
  for (int axis = 'x'; axis <= 'z'; axis++) {
    emit_signal(m, EMIT_INPUT, true, gen_format("move_%c", axis).text, gen_format("%d", w + 1).text,
                "added to %c of B", axis);
  }
  emit_signal(m, EMIT_OUTPUT, false, "busy", "", "a step is under way");
  emit_signal(m, EMIT_OUTPUT, false, "push", "", "some boxes meet");
  emit_signal(m, EMIT_OUTPUT_REG, false, "mask", mask.text, "which lanes'");
  emit_signal(m, EMIT_OUTPUT_REG, false, "mask_j", number.text, "number of B's triangle");
  emit_signal(m, EMIT_OUTPUT_REG, false, "mask_base", base.text, "its base");
  emit_signal(m, EMIT_OUTPUT, false, "tested", "7", "pairs that are tested in this cycle");
  static const char *const flags[] = {"valid_1", "is_b_1",  "load_1",
                                      "is_a_1",  "valid_2", "valid_3"};
  for (size_t i = 0; i < sizeof flags / sizeof flags[0]; i++) {
    emit_net(m, EMIT_REG, false, flags[i], "");
  }
  emit_net(m, EMIT_REG, false, "j_1", step.text);
  emit_net(m, EMIT_REG, false, "j_2", number.text);
  emit_net(m, EMIT_REG, false, "base_1", base.text);
  emit_net(m, EMIT_REG, false, "base_2", base.text);
  emit_net(m, EMIT_REG, false, "box_2", gen_format("%d", 6 * v).text);
  emit_signal(m, EMIT_REG, false, "held", "7", "lanes that hold a box");
  emit_net(m, EMIT_WIRE, false, "meets", mask.text);
  emit_net(m, EMIT_WIRE, false, "live", mask.text);
  emit_net(m, EMIT_WIRE, false, "taken", mask.text);
  emit_net(m, EMIT_WIRE, false, "lost", "");
  for (int k = 0; k < 6; k++) {
    emit_net(m, EMIT_WIRE, true, gen_format("moved_%d", k).text, gen_format("%d", v).text);
    if (p->design->limits > 0) {
      emit_net(m, EMIT_WIRE, true, gen_format("widened_%d", k).text, gen_format("%d", v).text);
    }
  }
  emit_text(
      m,
      "\nassign busy = valid_1 || valid_2 || valid_3;\nassign push = |mask;\nassign lost = |(taken & live);\n"
      "assign tested = held & {7{valid_2}};");
  for (int k = 0; k < p->lanes; k++) {
    emit_text(m, "assign taken[%d] = valid_1 && load_1 && (j_1 == %d'd%d);", k, step_bits(p), k);
  }
  for (int k = 0; k < 6; k++) {
    int axis = 'x' + k / 2;
    emit_text(m, "assign moved_%d = {{2{box_b[%d]}}, box_b[%d:%d]} + {move_%c[%d], move_%c};", k,
              (k + 1) * w - 1, (k + 1) * w - 1, k * w, axis, w, axis);
    if (p->design->limits > 0) { /* boxes nearer than the margin meet */
      emit_text(m, "assign widened_%d = moved_%d %c %d'd%lld;", k, k, k % 2 ? '+' : '-', v,
                (long long)p->design->margin[1]);
    }
  }
  emit_blank(m);
  for (int k = 0; k < p->lanes; k++) {
    emit_instance(
        m, "sepax_lane", gen_format("lane_%d", k).text, "",
        "clk=clk, clear=clear, load=taken[%d], is_a=is_a_1, box_a=box_a, is_b=valid_2, box_b=box_2, "
        "live=live[%d], meets=meets[%d]",
        k, k, k);
  }
  emit_text(
      m,
      "\nalways @(posedge clk) begin\n"
      "  if (clear) begin\n"
      "    valid_1 <= 1'b0;\n    valid_2 <= 1'b0;\n    valid_3 <= 1'b0;\n    mask <= %d'd0;\n"
      "    held <= 7'd0;\n"
      "  end else begin\n"
      "    valid_1 <= step;\n    valid_2 <= valid_1 && is_b_1;\n    valid_3 <= valid_2;\n    mask <= meets;\n"
      "    held <= held + {6'd0, valid_1 && load_1 && is_a_1} - {6'd0, lost};\n"
      "  end\n"
      "  j_1 <= j;\n  is_b_1 <= is_b;\n  base_1 <= base;\n  load_1 <= load;\n  is_a_1 <= is_a;\n"
      "  j_2 <= j_1[%d:0];\n  base_2 <= base_1;\n"
      "  mask_j <= j_2;\n  mask_base <= base_2;\n"
      "  box_2 <= {%s};\nend",
      p->lanes, p->index_b - 1,
      p->design->limits > 0 ? "widened_5, widened_4, widened_3, widened_2, widened_1, widened_0"
                            : "moved_5, moved_4, moved_3, moved_2, moved_1, moved_0");
  emit_end(m);
}

static void pick_number(emit_module *m, const engine_plan *p) {
  int bits = 1;
  while (1 << bits < p->lanes) {
    bits++;
  }
  emit_net(m, EMIT_WIRE, false, "lane", gen_format("%d", bits).text);
  emit_net(m, EMIT_WIRE, false, "offset", gen_format("%d", p->index_a).text);
  emit_net(m, EMIT_WIRE, false, "early", "");
  for (int b = 0; b < bits; b++) {
    unsigned long long which = 0;
    for (int k = 0; k < p->lanes; k++) {
      which |= (unsigned long long)(k >> b & 1) << k;
    }
    emit_text(m, "assign lane[%d] = |(lowest & %d'h%llx);", b, p->lanes, which);
  }
  emit_text(m, "assign early = j < {%d'd0, lane};", p->index_b - bits);
  emit_text(m, "assign offset = {%d'd0, lane};", p->index_a - bits);
  emit_text(m, "assign a = base + offset - (early ? %d'd%d : %d'd0);", p->index_a,
            p->lanes & ((1 << p->index_a) - 1), p->index_a);
}

static void gen_pick(emitter *e, const engine_plan *p) {
  emit_module *m =
      emit_begin(e, "sepax_pick",
                 "One pair after the other out of a mask, the lowest lane first: lane k holds\n"
                 "A_(base + k), or, if B_k has not come yet, that of the round before.");
  const gen_line mask = gen_format("%d", p->lanes);
  const gen_line step = gen_format("%d", p->index_b);
  const gen_line number = gen_format("%d", p->index_a);
  emit_signal(m, EMIT_INPUT, false, "clk", "", "clock");
  emit_signal(m, EMIT_INPUT, false, "clear", "", "drop what is left");
  emit_signal(m, EMIT_INPUT, false, "more", "", "a mask is here");
  emit_signal(m, EMIT_OUTPUT, false, "pop", "", "it is taken");
  emit_signal(m, EMIT_INPUT, false, "next_mask", mask.text, "lanes, not 0");
  emit_signal(m, EMIT_INPUT, false, "next_j", step.text, "number of B's triangle");
  emit_signal(m, EMIT_INPUT, false, "next_base", number.text, "base of its round");
  emit_signal(m, EMIT_OUTPUT_REG, false, "valid", "", "a pair is here");
  emit_signal(m, EMIT_INPUT, false, "take", "", "it is taken");
  emit_signal(m, EMIT_OUTPUT, false, "a", number.text, "number of A's triangle");
  emit_signal(m, EMIT_OUTPUT, false, "b", gen_format("%d", p->index_b).text,
              "number of B's triangle");
  emit_net(m, EMIT_REG, false, "mask", mask.text);
  emit_net(m, EMIT_REG, false, "j", step.text);
  emit_net(m, EMIT_REG, false, "base", number.text);
  emit_net(m, EMIT_WIRE, false, "lowest", mask.text);
  emit_net(m, EMIT_WIRE, false, "rest", mask.text);
  emit_text(m, "\nassign lowest = mask & (~mask + %d'd1);\nassign rest = mask & ~lowest;",
            p->lanes);
  if (p->lanes > 1) {
    pick_number(m, p);
  } else {
    emit_text(m, "assign a = base;");
  }
  emit_text(m, "assign b = j;");
  emit_text(m, "assign pop = more && (!valid || (take && (rest == %d'd0)));", p->lanes);
  emit_text(m,
            "\nalways @(posedge clk) begin\n"
            "  if (clear) begin\n    valid <= 1'b0;\n"
            "  end else if (pop) begin\n    valid <= 1'b1;\n"
            "  end else if (take && (rest == %d'd0)) begin\n    valid <= 1'b0;\n  end\n"
            "  if (pop) begin\n    mask <= next_mask;\n    j <= next_j;\n    base <= next_base;\n"
            "  end else if (take) begin\n    mask <= rest;\n  end\nend",
            p->lanes);
  emit_end(m);
}

void gen_engine_lanes(emitter *e, const engine_plan *p) {
  enum { UNDER_WAY = 6 }; /* masks that come after room was last seen */
  gen_walk(e, p);
  gen_lane(e, p);
  gen_lanes(e, p);
  gen_engine_queue(e, "sepax_candidates",
                   "Masks of box pairs that meet, until their pairs are judged.",
                   p->lanes + p->index_b + p->index_a, 4, UNDER_WAY);
  gen_pick(e, p);
}
