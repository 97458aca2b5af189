/* gen_exact_top.c - sepax_queue and sepax_top of architecture exact: the handshake, the
 * passes of a pair, and the order of the verdicts. */
#include "engine/engine.h"
#include "exact.h"

#include <stdlib.h>
#include <string.h>

static int frames_to(const exact_plan *p, int cycle) { return cycle / p->design->config.ii; }

/* Places in the queue: a power of two that never makes a full stream wait. Cores side by side take
 * pairs in bunches, of which the verdicts wait for each other. */
static int places_log2(const exact_plan *p) {
  int bunch = p->design->config.cores > 1 ? 2 : 0;
  int needed = (p->latency - 1) / p->design->config.ii + 1 + bunch;
  int log2 = 1;
  while (1 << log2 < needed) {
    log2++;
  }
  return log2;
}

/* A verdict: the band, if there are any, coplanar, the axis. */
static int result_bits(const exact_plan *p) { return p->limits > 0 ? 7 : 5; }

/* What the box test found out of a pair: apart, and with extents beyond. */
static int note_bits(const exact_plan *p) {
  return p->design->config.extent_a > 0 ? 2 : p->design->aabb_test ? 1 : 0;
}
static const char *note_width(int bits) { return bits > 1 ? "2" : ""; }

static void gen_queue(emitter *e, const exact_plan *p) {
  int tag = places_log2(p);
  int places = 1 << tag;
  int note = note_bits(p);
  bool near = note > 0;
  int result = result_bits(p);
  char result_text[16];
  char note_text[16];
  char places_text[16];
  char tag_text[16];
  char count_text[16];
  char name[EMIT_NAME];
  snprintf(places_text, sizeof places_text, "%d", places);
  snprintf(result_text, sizeof result_text, "%d", result);
  snprintf(note_text, sizeof note_text, "%s", note_width(note));
  snprintf(tag_text, sizeof tag_text, "%d", tag);
  snprintf(count_text, sizeof count_text, "%d", tag + 1);
  emit_module *m =
      emit_begin(e, "sepax_queue",
                 "Verdicts in the order of their pairs. A pair gets a place when it is taken; its\n"
                 "verdict is written there whenever it comes, and leaves when all before it have.");
  emit_signal(m, EMIT_INPUT, false, "clk", "", "clock");
  emit_signal(m, EMIT_INPUT, false, "rst", "", "synchronous reset, active high");
  emit_signal(m, EMIT_OUTPUT, false, "room", "", "a place is free");
  emit_signal(m, EMIT_INPUT, false, "take", "", "a pair takes the next place; only with room");
  emit_signal(m, EMIT_OUTPUT_REG, false, "tail", tag_text, "the next place");
  emit_signal(m, EMIT_INPUT, false, "write", "", "a verdict is here");
  emit_signal(m, EMIT_INPUT, false, "tag", tag_text, "its pair's place");
  emit_signal(m, EMIT_INPUT, false, "result", result_text, "the verdict");
  emit_signal(m, EMIT_OUTPUT, false, "valid", "", "the oldest pair has its verdict");
  emit_signal(m, EMIT_INPUT, false, "ready", "", "it may leave");
  emit_signal(m, EMIT_OUTPUT, false, "oldest", result_text, "the verdict of the oldest pair");
  if (near) {
    emit_signal(m, EMIT_INPUT, false, "note", note_text,
                "what is known of the pair that takes a place");
    emit_signal(m, EMIT_OUTPUT, false, "oldest_note", note_text, "that of the oldest pair");
  }
  emit_signal(m, EMIT_REG, false, "head", places_text, "the oldest place, one-hot");
  emit_signal(m, EMIT_REG, false, "count", count_text, "places taken, 0 ... %d", places);
  emit_signal(m, EMIT_REG, false, "done", places_text, "bit k: place k holds a verdict");
  for (int k = 0; k < places; k++) {
    snprintf(name, sizeof name, "result_%d", k);
    emit_net(m, EMIT_REG, false, name, result_text);
    if (near) {
      snprintf(name, sizeof name, "note_%d", k);
      emit_net(m, EMIT_REG, false, name, note_text);
    }
  }
  emit_net(m, EMIT_WIRE, false, "leave", "");
  emit_text(m, "\nassign room = !count[%d];\nassign leave = valid && ready;", tag);
  emit_text(m, "assign valid = |(head & done);");
  for (int k = 0; k < places; k++) {
    emit_text(m, "%s(result_%d & {%d{head[%d]}})%s",
              k == 0 ? "assign oldest = " : "                ", k, result, k,
              k < places - 1 ? " |" : ";");
  }
  for (int k = 0; k < places && near; k++) {
    emit_text(m, "%s(note_%d & {%d{head[%d]}})%s",
              k == 0 ? "assign oldest_note = " : "                ", k, note, k,
              k < places - 1 ? " |" : ";");
  }
  emit_text(m,
            "\nalways @(posedge clk) begin\n"
            "  if (rst) begin\n"
            "    head <= %d'd1;\n    tail <= %d'd0;\n    count <= %d'd0;\n    done <= %d'd0;\n"
            "  end else begin\n"
            "    if (leave) begin\n      head <= {head[%d:0], head[%d]};\n    end\n"
            "    if (take) begin\n      tail <= tail + %d'd1;\n    end\n"
            "    if (take && !leave) begin\n      count <= count + %d'd1;\n    end\n"
            "    if (leave && !take) begin\n      count <= count - %d'd1;\n    end",
            places, tag, tag + 1, places, places - 2, places - 1, tag, tag + 1, tag + 1);
  for (int k = 0; k < places; k++) {
    emit_text(
        m,
        "    if (write && (tag == %d'd%d)) begin\n      done[%d] <= 1'b1;\n    end else if (leave && head[%d]) "
        "begin\n      done[%d] <= 1'b0;\n    end",
        tag, k, k, k, k);
  }
  emit_text(m, "  end");
  for (int k = 0; k < places; k++) {
    emit_text(m, "  if (write && (tag == %d'd%d)) begin\n    result_%d <= result;\n  end", tag, k,
              k);
    if (near) {
      emit_text(m, "  if (take && (tail == %d'd%d)) begin\n    note_%d <= note;\n  end", tag, k, k);
    }
  }
  emit_text(m, "end");
  emit_end(m);
}

void gen_exact_ports(emit_module *m, int word) {
  char bits[16];
  snprintf(bits, sizeof bits, "%d", word);
  emit_signal(m, EMIT_INPUT, false, "clk", "", "clock");
  emit_signal(m, EMIT_INPUT, false, "rst", "", "synchronous reset of the control, active high");
  emit_signal(m, EMIT_INPUT, false, "in_valid", "", "a pair is here");
  emit_signal(m, EMIT_OUTPUT, false, "in_ready", "", "it is taken in this cycle");
  for (int v = 0; v < 6; v++) {
    for (int axis = 'x'; axis <= 'z'; axis++) {
      char name[EMIT_NAME];
      snprintf(name, sizeof name, "in_%c%d_%c", "ab"[v / 3], v % 3 + 1, axis);
      emit_signal(m, EMIT_INPUT, true, name, bits, "%c of %c_%d, %ld ... %ld", axis, "AB"[v / 3],
                  v % 3 + 1, (long)sepax_word_min(word), (long)sepax_word_max(word));
    }
  }
  emit_signal(m, EMIT_OUTPUT, false, "out_valid", "", "a verdict is here");
  emit_signal(m, EMIT_INPUT, false, "out_ready", "", "it is taken in this cycle");
  bool bands = m->emitter->design->limits > 0;
  const char *more = "";
  if (!bands && strcmp(m->name, "sepax_top") == 0 && m->emitter->design->aabb_test) {
    more =
        m->emitter->design->config.extent_a > 0 ? ", 13 boxes, 14 none, undecided" : ", 13 boxes";
  }
  emit_signal(m, EMIT_OUTPUT, false, "out_collision", "", "%s",
              bands ? "1: not proved to be farther apart than the clearance"
                    : "1: the triangles share a point");
  emit_signal(m, EMIT_OUTPUT, false, "out_coplanar", "", "1: all six points are in one plane");
  emit_signal(
      m, EMIT_OUTPUT, false, "out_axis", "4",
      bands
          ? "what proves the band: 1 ... 9 e_i x f_j, 10 N_A, 11 N_B, 12 of an edge, 13 boxes; 0 none%s"
          : "what separates: 1 ... 9 e_i x f_j, 10 N_A, 11 N_B, 12 in the plane%s; 0 none",
      more);
}

typedef struct {
  int ii, stages, judged; /* frames a pair is in; the frame at whose end the plane is known */
  bool flag;              /* there is no second pass */
  int near; /* bits of the note that pairs come with; with a note they take no second pass */
  char tag[16];
} control;

/* What is known of the pair in each frame it passes. */
static void declare_frames(emit_module *m, const control *c) {
  char name[EMIT_NAME];
  emit_text(
      m, "\n// The pair in frame k of its way: its place in the queue%s.",
      c->flag
          ? ""
          : ", whether this is its\n// second pass, whether boxes were disjoint in the first, whether it is separated if coplanar");
  for (int k = 0; k <= c->stages; k++) {
    snprintf(name, sizeof name, "valid_%d", k);
    emit_net(m, EMIT_REG, false, name, "");
    snprintf(name, sizeof name, "tag_%d", k);
    emit_net(m, EMIT_REG, false, name, c->tag);
    if (!c->flag && k < c->judged) {
      snprintf(name, sizeof name, "boxes_%d", k);
      emit_net(m, EMIT_REG, false, name, "");
      if (c->near) {
        snprintf(name, sizeof name, "noted_%d", k);
        emit_net(m, EMIT_REG, false, name, "");
      }
    } else if (!c->flag) {
      snprintf(name, sizeof name, "in_plane_%d", k);
      emit_net(m, EMIT_REG, false, name, "");
    }
    if (!c->flag) {
      snprintf(name, sizeof name, "second_%d", k);
      emit_net(m, EMIT_REG, false, name, "");
    }
  }
}

static void clock_frames(emit_module *m, const control *c) {
  const char *indent = c->ii > 1 ? "      " : "    ";
  emit_text(m, "\nalways @(posedge clk) begin\n  if (rst) begin");
  if (c->ii > 1) {
    emit_text(m, "    at <= {1'b1, %d'd0};", c->ii - 1);
  }
  for (int k = 0; k <= c->stages; k++) {
    emit_text(m, "    valid_%d <= 1'b0;", k);
  }
  emit_text(m, "  end else begin");
  if (c->ii > 1) {
    emit_text(m,
              "    if (!last || enter || busy) begin\n"
              "      at <= {at[%d:0], at[%d]};\n    end\n    if (last) begin",
              c->ii - 2, c->ii - 1);
  }
  emit_text(m, "%svalid_0 <= enter;", indent);
  for (int k = 1; k <= c->stages; k++) {
    emit_text(m, "%svalid_%d <= valid_%d%s;", indent, k, k - 1,
              !c->flag && k == c->judged ? " && !again" : "");
  }
  emit_text(m, c->ii > 1 ? "    end\n  end" : "  end");
  const char *inner = c->ii > 1 ? "    " : "  ";
  if (c->ii > 1) {
    emit_text(m, "  if (last) begin");
  }
  if (c->flag) {
    emit_text(m, "%stag_0 <= tail;", inner);
  } else {
    emit_text(m, "%stag_0 <= again ? tag_%d : tail;", inner, c->judged - 1);
    emit_text(m, "%ssecond_0 <= again;", inner);
    emit_text(m, "%sboxes_0 <= again && boxes_so_far;", inner);
    if (c->near) {
      emit_text(m, "%snoted_0 <= !again && %s;", inner,
                c->near > 1 ? "(in_apart || in_beyond)" : "in_apart");
    }
  }
  for (int k = 1; k <= c->stages; k++) {
    emit_text(m, "%stag_%d <= tag_%d;", inner, k, k - 1);
    if (!c->flag) {
      emit_text(m, "%ssecond_%d <= second_%d;", inner, k, k - 1);
    }
    if (!c->flag && k < c->judged) {
      emit_text(m, "%sboxes_%d <= boxes_%d;", inner, k, k - 1);
      if (c->near) {
        emit_text(m, "%snoted_%d <= noted_%d;", inner, k, k - 1);
      }
    } else if (!c->flag && k > c->judged) {
      emit_text(m, "%sin_plane_%d <= in_plane_%d;", inner, k, k - 1);
    } else if (!c->flag) {
      emit_text(m, "%sin_plane_%d <= flat ? boxes_so_far : apart;", inner, k);
    }
  }
  if (c->ii > 1) {
    emit_text(m, "  end");
  }
  emit_text(m, "end");
}

static void handshake(emit_module *m, const exact_plan *p, const control *c) {
  char bits[16];
  snprintf(bits, sizeof bits, "%d", result_bits(p));
  static const char *const wires[] = {"room", "take", "enter", "coplanar"};
  for (size_t i = 0; i < sizeof wires / sizeof wires[0]; i++) {
    emit_net(m, EMIT_WIRE, false, wires[i], "");
  }
  if (c->ii > 1) {
    emit_net(m, EMIT_WIRE, false, "last", "");
    emit_net(m, EMIT_WIRE, false, "busy", "");
  }
  emit_net(m, EMIT_WIRE, false, "axis", "4");
  emit_net(m, EMIT_WIRE, false, "result", bits);
  emit_net(m, EMIT_WIRE, false, "tail", c->tag);
  emit_net(m, EMIT_WIRE, false, "oldest", bits);
  if (!c->flag) {
    static const char *const more[] = {"flat",    "apart", "apart_x",
                                       "apart_z", "again", "boxes_so_far"};
    for (size_t i = 0; i < sizeof more / sizeof more[0]; i++) {
      emit_net(m, EMIT_WIRE, false, more[i], "");
    }
  }
  emit_blank(m);
  if (c->ii > 1) {
    emit_text(m, "assign last = at[%d];", c->ii - 1);
    char busy[512] = "valid_0";
    for (int k = 1; k <= c->stages; k++) {
      size_t used = strlen(busy);
      snprintf(busy + used, sizeof busy - used, " || valid_%d", k);
    }
    emit_text(m, "assign busy = %s;", busy);
  }
  if (c->flag) {
    emit_text(
        m, "assign in_ready = %sroom;\nassign take = in_valid && in_ready;\nassign enter = take;",
        c->ii > 1 ? "last && " : "");
  } else {
    char noted[32] = "";
    if (c->near) {
      snprintf(noted, sizeof noted, " && !noted_%d", c->judged - 1);
    }
    emit_text(
        m,
        "// A pair that is flat in the projection on x and y goes round once more, as seen in\n"
        "// u and z; flat again, it is on a line, where the boxes decide.\n"
        "assign again = valid_%d && flat && !second_%d%s;\n"
        "assign boxes_so_far = apart_x || (apart_z && !second_%d) || boxes_%d;\n"
        "assign in_ready = %sroom && !again;\n"
        "assign take = in_valid && in_ready;\n"
        "assign enter = take || again;",
        c->judged - 1, c->judged - 1, noted, c->judged - 1, c->judged - 1,
        c->ii > 1 ? "last && " : "");
  }
}

void gen_exact_top(emitter *e, const exact_plan *p) {
  gen_queue(e, p);
  control c = {.ii = p->design->config.ii,
               .stages = frames_to(p, p->verdict_cycle),
               .flag = p->single,
               .near = note_bits(p)};
  c.judged = (p->plane_cycle + 1) / c.ii;
  snprintf(c.tag, sizeof c.tag, "%d", places_log2(p));
  char banner[1024];
  char every[24];
  gen_exact_every(p, every);
  snprintf(
      banner, sizeof banner,
      "Exact collision detection of two triangles: the verdict is the mathematical one\n"
      "for every input. valid/ready on both sides; a pair every %s, verdicts in\n"
      "order.\n"
      "%s\n"
      "Latency %d cycles from the one in which a pair is taken to its verdict, both\n"
      "counted%s. Outputs are 0 without out_valid.",
      every,
      p->limits > 0
          ? "With a clearance: free means that the real triangles, of which each coordinate is\n"
            "within 1/2, are farther apart than that; else the band says what is not proved."
      : c.flag ? "Coplanar pairs are called collisions, undecided, and flagged."
               : "Coplanar and degenerate pairs are decided, too; those flat in the projection on\n"
                 "x and y go round once more; in_ready is low for that turn.",
      p->latency, c.ii > 1 ? ", when the machine was empty" : "");
  emit_module *m = emit_begin(e, c.near ? "sepax_near" : "sepax_top", banner);
  gen_exact_ports(m, p->design->core_word);
  if (c.near) {
    emit_signal(m, EMIT_INPUT, false, "in_apart", "", "the boxes are disjoint; goes with the pair");
    if (c.near > 1) {
      emit_signal(m, EMIT_INPUT, false, "in_beyond", "", "a box is too long; goes with the pair");
    }
    emit_signal(m, EMIT_OUTPUT, false, "out_note", note_width(c.near),
                "in_apart%s of the pair; the verdict is none if not 0",
                c.near > 1 ? ", in_beyond" : "");
  }
  if (p->limits > 0) {
    emit_signal(m, EMIT_OUTPUT, false, "out_band", "2", "0 free, 1 warning, 2 collision");
  }
  if (c.ii > 1) {
    char turns[16];
    snprintf(turns, sizeof turns, "%d", c.ii);
    emit_signal(m, EMIT_REG, false, "at", turns, "cycle of the frame, one-hot; rests at its end");
  }
  declare_frames(m, &c);
  handshake(m, p, &c);
  clock_frames(m, &c);
  char connections[2048] = "clk=clk";
  size_t used = strlen(connections);
  if (c.ii > 1) {
    used += (size_t)snprintf(connections + used, sizeof connections - used, ", slot=at");
  }
  for (int v = 0; v < 6; v++) {
    for (int axis = 'x'; axis <= 'z'; axis++) {
      used +=
          (size_t)snprintf(connections + used, sizeof connections - used, ", in_%c%d_%c=in_%c%d_%c",
                           "ab"[v / 3], v % 3 + 1, axis, "ab"[v / 3], v % 3 + 1, axis);
    }
  }
  if (p->limits > 0) {
    emit_net(m, EMIT_WIRE, false, "band", "2");
    snprintf(connections + used, sizeof connections - used, ", band=band");
  } else if (c.flag) {
    snprintf(connections + used, sizeof connections - used, ", in_plane=1'b0");
  } else {
    snprintf(connections + used, sizeof connections - used,
             ", again=again, flat=flat, separated=apart, disjoint_x=apart_x, disjoint_z=apart_z, "
             "second=second_%d, in_plane=in_plane_%d",
             c.stages, c.stages);
  }
  emit_blank(m);
  emit_instance(m, "sepax_core", "core", "", "%s, coplanar=coplanar, axis=axis", connections);
  emit_text(m, "\nassign result = {%scoplanar, axis};", p->limits > 0 ? "band, " : "");
  if (c.near) {
    emit_net(m, EMIT_WIRE, false, "note", note_width(c.near));
    emit_text(m, "assign note = %s;", c.near > 1 ? "{in_apart, in_beyond}" : "in_apart");
  }
  char write[64];
  if (c.ii > 1) {
    snprintf(write, sizeof write, "valid_%d && at[%d]", c.stages, p->verdict_cycle % c.ii);
  } else {
    snprintf(write, sizeof write, "valid_%d", c.stages);
  }
  emit_blank(m);
  emit_instance(m, "sepax_queue", "queue", "",
                "clk=clk, rst=rst, room=room, take=take, tail=tail, write=%s, tag=tag_%d, "
                "result=result, valid=out_valid, ready=out_ready, oldest=oldest%s",
                write, c.stages, c.near ? ", note=note, oldest_note=out_note" : "");
  emit_text(m, "\nassign out_coplanar = out_valid && oldest[4];\n"
               "assign out_axis = oldest[3:0] & {4{out_valid}};\n"
               "assign out_collision = out_valid && (oldest[3:0] == 4'd0);");
  if (p->limits > 0) {
    emit_text(m, "assign out_band = oldest[6:5] & {2{out_valid}};");
  }
  emit_end(m);
}

bool gen_exact(emitter *e, int *latency) {
  exact_plan *plan = malloc(sizeof *plan);
  if (plan == NULL) {
    abort();
  }
  if (exact_plan_make(plan, e->design, &e->error)) {
    gen_exact_units(e, plan);
    gen_exact_core(e, plan);
    gen_exact_top(e, plan);
    *latency = plan->latency;
    int places = 1 << places_log2(plan);
    if (e->design->aabb_test) {
      int more =
          e->design->config.extent_a > 0 ? gen_exact_near(e, plan) : gen_exact_boxes(e, plan);
      *latency += more;
      places += more;
    }
    if (e->design->config.lanes > 0) {
      gen_engine(e, places);
    }
  }
  free(plan);
  return e->error.text[0] == '\0';
}
