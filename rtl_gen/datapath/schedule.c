/* schedule.c - delay lines and holding registers behind the outputs of units. */
#include "schedule.h"

#include "delay.h"
#include "sepax_design.h"

#include <stdlib.h>
#include <string.h>

int schedule_add(schedule *s, const schedule_stream *stream) {
  if (s->streams == SCHEDULE_STREAMS) {
    abort(); /* more streams than SCHEDULE_STREAMS */
  }
  s->stream[s->streams] = *stream;
  return s->streams++;
}

int schedule_defined(const schedule *s, schedule_value v) {
  return s->stream[v.stream].first + v.slot;
}

void schedule_need(schedule *s, schedule_value v, int cycle) {
  int *oldest = &s->stream[v.stream].age[v.slot];
  int age = cycle - schedule_defined(s, v);
  if (age < 0) {
    abort(); /* read before it is defined */
  }
  *oldest = age > *oldest ? age : *oldest;
}

/* Holding registers of a value beyond the delay line. */
static int holds(const schedule *s, const schedule_stream *t, int slot, int line) {
  int beyond = t->age[slot] - line;
  return beyond > 0 ? (beyond + s->ii - 1) / s->ii : 0;
}

void schedule_store(schedule *s) {
  for (int i = 0; i < s->streams; i++) {
    schedule_stream *t = &s->stream[i];
    int longest = 0;
    for (int k = 0; k < s->ii; k++) {
      longest = t->age[k] > longest ? t->age[k] : longest;
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
    snprintf(text, EMIT_NAME, "%s", t->name);
  } else {
    snprintf(text, EMIT_NAME, place == 1 ? "%s_q" : "%s_q%d", t->name, place);
  }
}

static void hold_name(const schedule_stream *t, int slot, int copy, char text[EMIT_NAME]) {
  int used = snprintf(text, EMIT_NAME, "%s_%s_hold", t->symbol, t->label[slot]);
  if (copy > 0) {
    snprintf(text + used, EMIT_NAME - (size_t)used, "%d", copy + 1);
  }
}

void schedule_source(const schedule *s, schedule_value v, int cycle, char text[EMIT_NAME]) {
  const schedule_stream *t = &s->stream[v.stream];
  int place = cycle - schedule_defined(s, v);
  if (place <= t->line) {
    line_name(t, place, text);
  } else {
    hold_name(t, v.slot, (place - t->line - 1) / s->ii, text);
  }
}

void schedule_declare(const schedule *s, FILE *out) {
  char name[EMIT_NAME];
  for (int i = 0; i < s->streams; i++) {
    const schedule_stream *t = &s->stream[i];
    const char *kind = t->is_signed ? "reg signed" : "reg";
    for (int place = 1; place <= t->line; place++) {
      line_name(t, place, name);
      emit_net(out, kind, t->width, name);
    }
    for (int k = 0; k < s->ii; k++) {
      for (int copy = 0; copy < holds(s, t, k, t->line); copy++) {
        hold_name(t, k, copy, name);
        emit_net(out, kind, t->width, name);
      }
    }
  }
}

void schedule_clock(const schedule *s, FILE *out) {
  char name[EMIT_NAME];
  char from[EMIT_NAME];
  for (int i = 0; i < s->streams; i++) {
    const schedule_stream *t = &s->stream[i];
    for (int place = 1; place <= t->line; place++) {
      line_name(t, place, name);
      line_name(t, place - 1, from);
      fprintf(out, "    %s <= %s;\n", name, from);
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
            fprintf(out, "    if (slot[%d]) begin\n", phase);
            open = true;
          }
          fprintf(out, "      %s <= %s;\n", name, from);
          snprintf(from, sizeof from, "%s", name);
        }
      }
    }
    if (open) {
      fprintf(out, "    end\n");
    }
  }
}
