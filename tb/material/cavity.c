/* SPDX-License-Identifier: MIT */
#include "cavity.h"

#include "touch.h"

#include <stdio.h>
#include <stdlib.h>

void stand(standing *at, const surfaces *f, point p, generator *g) {
  static holder held[MOST];
  static enclosure e;
  *at = (standing){.held = held, .consistent = true};
  find_crossings(&e, f->s, p, g);
  for (size_t block = 0; block < f->s->count; block++) {
    int sum = 0;
    bool crossed = false;
    for (size_t i = 0; i < f->s->count; i++) {
      sum += f->block[i] == block ? e.crossing[i] : 0;
      crossed = crossed || (f->block[i] == block && e.crossing[i] != 0);
    }
    if (!crossed) {
      continue;
    }
    find_enclosure(&e, f, block);
    if (e.enclosed || e.enclosed_of_2) {
      held[at->holding++] = (holder){block, sum};
      at->consistent = at->consistent && f->signed_in[block];
      at->sum += sum;
      at->above += sum > 0;
    }
  }
  find_enclosure(&e, f, MOST);
  if ((e.enclosed || e.enclosed_of_2) != (at->holding > 0)) {
    fprintf(stderr, "material: the blocks and the whole differ\n");
    exit(2);
  }
}

static bool blocks_touch(const surfaces *f, size_t a, size_t b) {
  for (size_t i = 0; i < f->s->count; i++) {
    for (size_t j = 0; j < f->s->count && f->block[i] == a; j++) {
      const triangle *t = f->s->t;
      if (f->block[j] == b && !is_zero(normal(t[i].v)) && !is_zero(normal(t[j].v)) &&
          triangles_touch(&t[i], &t[j])) {
        return true;
      }
    }
  }
  return false;
}

static void box_of(const surfaces *f, size_t block, point *low, point *high) {
  bool first = true;
  for (size_t i = 0; i < f->s->count; i++) {
    for (int k = 0; k < 9 && f->block[i] == block; k++) {
      int64_t x = f->s->t[i].v[k / 3].x[k % 3];
      low->x[k % 3] = (first && k < 3) || x < low->x[k % 3] ? x : low->x[k % 3];
      high->x[k % 3] = (first && k < 3) || x > high->x[k % 3] ? x : high->x[k % 3];
    }
    first = first && f->block[i] != block;
  }
}

/* The box of a strictly holds that of b. */
static bool is_round(const surfaces *f, size_t a, size_t b) {
  point low[2];
  point high[2];
  box_of(f, a, &low[0], &high[0]);
  box_of(f, b, &low[1], &high[1]);
  bool round = true;
  for (int i = 0; i < 3; i++) {
    round = round && low[0].x[i] < low[1].x[i] && high[1].x[i] < high[0].x[i];
  }
  return round;
}

bool is_cavity(const surfaces *f, const standing *at) {
  bool alternate = at->consistent && at->holding % 2 == 0;
  for (size_t i = 0; i < at->holding && alternate; i++) {
    size_t outer = 0;
    for (size_t j = 0; j < at->holding && alternate; j++) {
      bool in = is_round(f, at->held[j].block, at->held[i].block);
      bool about = is_round(f, at->held[i].block, at->held[j].block);
      alternate = i == j || ((in || about) &&
                             (j < i || !blocks_touch(f, at->held[i].block, at->held[j].block)));
      outer += in;
    }
    alternate = alternate && at->held[i].sum == (outer % 2 == 0 ? 1 : -1);
  }
  return alternate;
}
