/* SPDX-License-Identifier: MIT */
#include "surfaces.h"

#include "lines.h"

#include <stdlib.h>
#include <string.h>

static const uint64_t prime = (UINT64_C(1) << 61) - 1;

static uint64_t product(uint64_t a, uint64_t b) {
  unsigned __int128 p = (unsigned __int128)a * b;
  uint64_t sum = (uint64_t)(p & prime) + (uint64_t)(p >> 61);
  return sum >= prime ? sum - prime : sum;
}

/* 1 / a = a^(prime - 2). */
static uint64_t inverse(uint64_t a) {
  uint64_t result = 1;
  for (uint64_t power = prime - 2; power > 0; power >>= 1) {
    result = (power & 1) != 0 ? product(result, a) : result;
    a = product(a, a);
  }
  return result;
}

/* Subtract rows until nothing is left, or no row has the first number that is left. Return the
 * place of this number, or `count`. */
static size_t reduce(const surfaces *f, uint64_t *v, size_t count) {
  for (size_t c = 0; c < count; c++) {
    if (v[c] == 0) {
      continue;
    }
    if (!f->has_row[c]) {
      return c;
    }
    uint64_t factor = prime - v[c];
    for (size_t k = c; k < count; k++) {
      if (f->row[c][k] != 0) {
        uint64_t sum = v[k] + product(factor, f->row[c][k]);
        v[k] = sum >= prime ? sum - prime : sum;
      }
    }
  }
  return count;
}

static size_t reduce_of_2(const surfaces *f, uint64_t *v) {
  for (size_t n = 0; n < WORDS; n++) {
    while (v[n] != 0) {
      size_t c = 64 * n + (size_t)__builtin_ctzll(v[n]);
      if (!f->has_row_of_2[c]) {
        return c;
      }
      for (size_t k = n; k < WORDS; k++) {
        v[k] ^= f->row_of_2[c][k];
      }
    }
  }
  return MOST;
}

static void add_row(surfaces *f, const int *entry) {
  size_t count = f->s->count;
  uint64_t v[MOST];
  uint64_t v_of_2[WORDS] = {0};
  for (size_t c = 0; c < count; c++) {
    v[c] = entry[c] < 0 ? prime - (uint64_t)-entry[c] : (uint64_t)entry[c];
    v_of_2[c / 64] |= (uint64_t)(entry[c] & 1) << (c % 64);
  }
  size_t c = reduce(f, v, count);
  if (c < count) {
    uint64_t factor = inverse(v[c]);
    for (size_t k = 0; k < count; k++) {
      f->row[c][k] = product(factor, v[k]);
    }
    f->has_row[c] = true;
  }
  c = reduce_of_2(f, v_of_2);
  if (c < MOST) {
    memcpy(f->row_of_2[c], v_of_2, sizeof v_of_2);
    f->has_row_of_2[c] = true;
  }
}

static void widen(surfaces *f, point p) {
  for (int i = 0; i < 3; i++) {
    f->low.x[i] = f->closed || p.x[i] < f->low.x[i] ? p.x[i] : f->low.x[i];
    f->high.x[i] = f->closed || p.x[i] > f->high.x[i] ? p.x[i] : f->high.x[i];
  }
  f->closed = false;
}

static bool runs_along(const edge *e, const line *l, size_t n) {
  return e->at[0] <= l->cut[n] && l->cut[n] < e->at[1];
}

/* The row of the segment of a line between two cuts that follow each other. */
static void add_segment(surfaces *f, const line *l, size_t n) {
  int entry[MOST] = {0};
  int edges = 0;
  int sum = 0;
  for (size_t i = 0; i < l->edges; i++) {
    const edge *e = &l->edge[i];
    if (runs_along(e, l, n)) {
      entry[e->of] += e->sign;
      sum += e->sign;
      edges++;
    }
  }
  if (edges % 2 != 0) {
    widen(f, l->where[n]);
    widen(f, l->where[n + 1]);
  }
  f->consistent = f->consistent && abs(sum) <= 1;
  if (edges > 0) {
    add_row(f, entry);
  }
}

static void add_line(void *context, const line *l) {
  for (size_t n = 0; n + 1 < l->cuts; n++) {
    add_segment(context, l, n);
  }
}

void find_surfaces(surfaces *f, const soup *s) {
  *f = (surfaces){.s = s, .closed = true, .consistent = true};
  f->row = calloc(s->count, sizeof *f->row);
  f->row_of_2 = calloc(s->count, sizeof *f->row_of_2);
  if (f->row == NULL || f->row_of_2 == NULL) {
    abort();
  }
  for_each_line(s, add_line, f);
}

void free_surfaces(surfaces *f) {
  free(f->row);
  free(f->row_of_2);
}

bool draw_surface(const surfaces *f, bool *in, generator *g) {
  size_t count = f->s->count;
  size_t loose = 0; /* triangles that may be chosen; the rows then give the others */
  for (size_t c = 0; c < count; c++) {
    in[c] = false;
    loose += !f->has_row_of_2[c];
  }
  if (loose == 0) {
    return false;
  }
  int64_t chosen = draw(g, 0, (int64_t)loose - 1);
  int64_t another = one_in(g, 3) ? draw(g, 0, (int64_t)loose - 1) : chosen;
  for (size_t c = count; c-- > 0;) {
    if (!f->has_row_of_2[c]) {
      loose--;
      in[c] = (int64_t)loose == chosen || (int64_t)loose == another;
      continue;
    }
    for (size_t k = c + 1; k < count; k++) {
      in[c] ^= in[k] && (f->row_of_2[c][k / 64] >> (k % 64) & 1) != 0;
    }
  }
  return true;
}

/* The crossing of a ray and a triangle. False if the ray may meet an edge or a corner. */
static bool cross_triangle(const triangle *t, point p, point ray, int8_t *crossing) {
  point v[3];
  int side[3];
  bool above = false;
  bool below = false;
  bool on = false;
  for (int k = 0; k < 3; k++) {
    v[k] = minus(t->v[k], p);
  }
  for (int k = 0; k < 3; k++) {
    side[k] = sign(determinant(ray, v[k], v[(k + 1) % 3]));
    above = above || side[k] > 0;
    below = below || side[k] < 0;
    on = on || side[k] == 0;
  }
  *crossing = 0;
  if (above && below) {
    return true;
  }
  if (on) {
    return false;
  }
  int way = above ? 1 : -1;
  bool ahead = sign(determinant(v[0], v[1], v[2])) == way;
  *crossing = (int8_t)(ahead ? way : 0);
  return true;
}

void find_crossings(int8_t *crossing, const soup *s, point p, generator *g) {
  for (size_t i = 0; i < s->count;) {
    point ray = {{0, 0, 0}};
    for (int k = 0; k < 3; k++) {
      ray.x[k] = draw(g, -1000, 1000);
    }
    for (i = 0; i < s->count; i++) {
      crossing[i] = 0;
      if (!is_zero(normal(s->t[i].v)) && !cross_triangle(&s->t[i], p, ray, &crossing[i])) {
        break; /* another ray */
      }
    }
  }
}

bool is_enclosed(const surfaces *f, const int8_t *crossing) {
  size_t count = f->s->count;
  uint64_t v[MOST];
  uint64_t v_of_2[WORDS] = {0};
  for (size_t i = 0; i < count; i++) {
    v[i] = crossing[i] < 0 ? prime - 1 : (uint64_t)crossing[i];
    v_of_2[i / 64] |= (uint64_t)(crossing[i] & 1) << (i % 64);
  }
  return reduce(f, v, count) < count || reduce_of_2(f, v_of_2) < MOST;
}
