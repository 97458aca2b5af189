/* SPDX-License-Identifier: MIT */
/* schedule.c - delay lines and holding registers behind the outputs of units. */
#include "schedule.h"

#include "delay.h"
#include "sepax_design.h"

#include <string.h>

int schedule_add(schedule *s, const schedule_producer *producer) {
  if (s->producers == SCHEDULE_PRODUCERS) {
    s->fault = "more producers than SCHEDULE_PRODUCERS";
    return 0;
  }
  s->producer[s->producers] = *producer;
  return s->producers++;
}

int schedule_defined(const schedule *s, schedule_value v) {
  return s->producer[v.producer].first + v.slot;
}

void schedule_need(schedule *s, schedule_value v, int cycle) {
  int *oldest = &s->producer[v.producer].age[v.slot];
  int age = cycle - schedule_defined(s, v);
  if (age < 0) {
    s->fault = "a value that is read before it is defined";
  }
  *oldest = age > *oldest ? age : *oldest;
}

/* Holding registers of a value beyond the delay line. */
static int holds(const schedule *s, const schedule_producer *t, int slot, int line) {
  int beyond = t->age[slot] - line;
  return beyond > 0 ? (beyond + s->ii - 1) / s->ii : 0;
}

int schedule_holds(const schedule *s, const schedule_producer *producer) {
  int all = 0;
  for (int k = 0; k < s->ii; k++) {
    all += holds(s, producer, k, producer->line);
  }
  return all;
}

void schedule_store(schedule *s, const delay_model *m) {
  for (int i = 0; i < s->producers; i++) {
    schedule_producer *t = &s->producer[i];
    int longest = 0;
    for (int k = 0; k < s->ii; k++) {
      longest = t->age[k] > longest ? t->age[k] : longest;
    }
    int least = 0;
    for (int line = 0; line <= longest; line++) {
      int cost = line * m->flip_flop;
      for (int k = 0; k < s->ii; k++) {
        cost += holds(s, t, k, line) * m->enabled_flip_flop;
      }
      if (line == 0 || cost < least) {
        least = cost;
        t->line = line;
      }
    }
  }
}

/* Register n behind the output (0): of the delay line, then the holding registers of a slot. */
static gen_line register_name(const schedule_producer *t, int slot, int n) {
  int copy = n - t->line;
  if (n == 0) {
    return gen_format("%s", t->name);
  }
  if (copy <= 0) {
    return gen_format(n > 1 ? "%s_q%d" : "%s_q", t->name, n);
  }
  return gen_format(copy > 1 ? "%s_%s_hold%d" : "%s_%s_hold", t->symbol, t->label[slot], copy);
}

gen_line schedule_source(const schedule *s, schedule_value v, int cycle) {
  const schedule_producer *t = &s->producer[v.producer];
  int place = cycle - schedule_defined(s, v);
  int beyond = place - t->line;
  return register_name(t, v.slot, beyond > 0 ? t->line + (beyond + s->ii - 1) / s->ii : place);
}

void schedule_declare(const schedule *s, emit_text *out) {
  for (const schedule_producer *t = s->producer; t < s->producer + s->producers; t++) {
    const char *kind = t->is_signed ? "reg signed" : "reg";
    for (int n = 1; n <= t->line; n++) {
      emit_net(out, kind, t->width, register_name(t, 0, n).text);
    }
    for (int k = 0; k < s->ii; k++) {
      for (int n = t->line + 1; n <= t->line + holds(s, t, k, t->line); n++) {
        emit_net(out, kind, t->width, register_name(t, k, n).text);
      }
    }
  }
}

static void move(emit_text *out, const char *indent, const schedule_producer *t, int slot, int n) {
  text_printf(out, "%s%s <= %s;\n", indent, register_name(t, slot, n).text,
              register_name(t, slot, n - 1).text);
}

/* Delay lines; with enables those of this cycle. */
static void move_lines(const schedule *s, advance *a, int cycle, emit_text *out) {
  bool open = false;
  for (const schedule_producer *t = s->producer; t < s->producer + s->producers; t++) {
    for (int n = 1; n <= t->line; n++) {
      if (a->gated && t->first + n != cycle) {
        continue;
      }
      if (a->gated && !open) {
        text_printf(out, "    if (%s) begin\n", advance_name(a, cycle).text);
        open = true;
      }
      move(out, a->gated ? "      " : "    ", t, 0, n);
    }
  }
  text_puts(out, open ? "    end\n" : "");
}

/* Holding registers that are loaded in this phase of the II window; with enables those of this
 * cycle, with copies of the slot those of this copy. */
static void move_holds(const schedule *s, advance *a, int phase, int cycle, emit_text *out) {
  bool open = false;
  for (const schedule_producer *t = s->producer; t < s->producer + s->producers; t++) {
    for (int k = 0; k < s->ii; k++) {
      int loaded = t->first + k + t->line;
      for (int n = t->line + 1; loaded % s->ii == phase && n <= t->line + holds(s, t, k, t->line);
           n++) {
        int read = loaded + (n - t->line - 1) * s->ii;
        if (a->gated ? read + 1 != cycle : advance_copy(a, read) != cycle) {
          continue;
        }
        if (!open) {
          text_printf(out, "    if (%s%s%s) begin\n", advance_slot(a, read, read).text,
                      a->gated ? " && " : "", a->gated ? advance_name(a, cycle).text : "");
          open = true;
        }
        move(out, "      ", t, k, n);
      }
    }
  }
  text_puts(out, open ? "    end\n" : "");
}

void schedule_clock(const schedule *s, advance *a, emit_text *out) {
  for (int cycle = 0; cycle < (a->gated ? ADVANCE_CYCLES : 1); cycle++) {
    move_lines(s, a, cycle, out);
  }
  for (int phase = 0; phase < s->ii; phase++) {
    for (int cycle = 0; cycle < (a->gated || a->copied ? ADVANCE_CYCLES : 1); cycle++) {
      move_holds(s, a, phase, cycle, out);
    }
  }
}
