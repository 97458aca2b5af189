/* schedule.c - lines and holds behind the outputs of shared units. */
#include "schedule.h"

#include "delay.h"
#include "sepax_design.h"

#include <string.h>

int schedule_add(schedule *s, const char *kind, const char *width, int bits, bool is_signed,
                 const char *name) {
  schedule_stream *t = &s->stream[s->streams];
  *t = (schedule_stream){.width = width, .bits = bits, .is_signed = is_signed};
  snprintf(t->name, sizeof t->name, "%s_%s", kind, name);
  snprintf(t->kind, sizeof t->kind, "%s", kind);
  for (int k = 0; k < SEPAX_II_MAX; k++) {
    t->last[k] = -1;
  }
  return s->streams++;
}

int schedule_born(const schedule *s, schedule_value v) {
  return s->stream[v.stream].first + v.slot;
}

void schedule_need(schedule *s, schedule_value v, int cycle) {
  int *last = &s->stream[v.stream].last[v.slot];
  *last = cycle > *last ? cycle : *last;
}

static int age(const schedule_stream *t, int slot) {
  return t->last[slot] < 0 ? 0 : t->last[slot] - t->first - slot;
}

/* Registers that hold a value beyond a line. */
static int holds(const schedule *s, const schedule_stream *t, int slot, int line) {
  int beyond = age(t, slot) - line;
  return beyond > 0 ? (beyond + s->ii - 1) / s->ii : 0;
}

void schedule_store(schedule *s) {
  for (int i = 0; i < s->streams; i++) {
    schedule_stream *t = &s->stream[i];
    int longest = 0;
    for (int k = 0; k < s->ii; k++) {
      longest = age(t, k) > longest ? age(t, k) : longest;
    }
    int least = 0;
    for (int line = 0; line <= longest; line++) {
      int cost = line * delay_used->flip_flop;
      for (int k = 0; k < s->ii; k++) {
        cost += holds(s, t, k, line) * delay_used->enabled_flip_flop;
      }
      if (line == 0 || cost < least) {
        least = cost;
        t->line = line;
      }
    }
  }
}

static void line_name(const schedule_stream *t, int place, char text[EMIT_NAME]) {
  if (place == 0) {
    snprintf(text, EMIT_NAME, "%.30s", t->name);
  } else {
    snprintf(text, EMIT_NAME, "%.30s_q%d", t->name, place);
  }
}

static void hold_name(const schedule_stream *t, int slot, int copy, char text[EMIT_NAME]) {
  int used = snprintf(text, EMIT_NAME, "%s_%.30s_held", t->kind, t->label[slot]);
  if (copy > 0) {
    snprintf(text + used, EMIT_NAME - (size_t)used, "_%d", copy + 1);
  }
}

void schedule_source(const schedule *s, schedule_value v, int cycle, char text[EMIT_NAME]) {
  const schedule_stream *t = &s->stream[v.stream];
  int place = cycle - schedule_born(s, v);
  if (place <= t->line) {
    line_name(t, place, text);
  } else {
    hold_name(t, v.slot, (place - t->line - 1) / s->ii, text);
  }
}

void schedule_declare(const schedule *s, emit_module *m) {
  char name[EMIT_NAME];
  for (int i = 0; i < s->streams; i++) {
    const schedule_stream *t = &s->stream[i];
    for (int place = 1; place <= t->line; place++) {
      line_name(t, place, name);
      emit_net(m, EMIT_REG, t->is_signed, name, t->width);
    }
    for (int k = 0; k < s->ii; k++) {
      for (int copy = 0; copy < holds(s, t, k, t->line); copy++) {
        hold_name(t, k, copy, name);
        emit_net(m, EMIT_REG, t->is_signed, name, t->width);
      }
    }
  }
}

void schedule_clock(const schedule *s, emit_module *m) {
  char name[EMIT_NAME];
  char from[EMIT_NAME];
  for (int i = 0; i < s->streams; i++) {
    const schedule_stream *t = &s->stream[i];
    for (int place = 1; place <= t->line; place++) {
      line_name(t, place, name);
      line_name(t, place - 1, from);
      emit_text(m, "  %s <= %s;", name, from);
    }
  }
  for (int phase = 0; phase < s->ii; phase++) {
    bool open = false;
    for (int i = 0; i < s->streams; i++) {
      const schedule_stream *t = &s->stream[i];
      for (int k = 0; k < s->ii; k++) {
        if ((t->first + k + t->line) % s->ii != phase) {
          continue;
        }
        line_name(t, t->line, from);
        for (int copy = 0; copy < holds(s, t, k, t->line); copy++) {
          hold_name(t, k, copy, name);
          if (!open) {
            emit_text(m, "  if (at[%d]) begin", phase);
            open = true;
          }
          emit_text(m, "    %s <= %s;", name, from);
          snprintf(from, sizeof from, "%s", name);
        }
      }
    }
    if (open) {
      emit_text(m, "  end");
    }
  }
}
