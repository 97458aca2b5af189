/* SPDX-License-Identifier: MIT */
/* unit.c - see draw.h: pairs of unit size whose verdict hangs on an orient3d of 1 or -1. */
#include "bench/draw.h"

#include "verdict/signs.h"

enum { UNITS = 15, TRIES = 50000 };

static sepax_vec from_to(sepax_vec p, sepax_vec q) {
  return (sepax_vec){q.x - p.x, q.y - p.y, q.z - p.z};
}

/* (p x q).r of vectors with components of -2 ... 2. */
static int triple(sepax_vec p, sepax_vec q, sepax_vec r) {
  return (p.y * q.z - p.z * q.y) * r.x + (p.z * q.x - p.x * q.z) * r.y +
         (p.x * q.y - p.y * q.x) * r.z;
}

/* The orient3d s_0 ... s_2, w_0 ... w_2, d_00 ... d_22. */
static void find_volumes(const sepax_pair *p, int volume[UNITS]) {
  const sepax_vec *a = p->a.v;
  const sepax_vec *b = p->b.v;
  for (int i = 0; i < 3; i++) {
    const sepax_vec e = from_to(a[i], a[next[i]]);
    volume[i] = triple(from_to(a[0], a[1]), from_to(a[1], a[2]), from_to(a[0], b[i]));
    volume[3 + i] = triple(from_to(b[0], b[1]), from_to(b[1], b[2]), from_to(b[0], a[i]));
    for (int j = 0; j < 3; j++) {
      volume[6 + 3 * i + j] = triple(e, from_to(b[j], b[next[j]]), from_to(a[i], b[j]));
    }
  }
}

static int sign_of(int volume) { return (volume > 0) - (volume < 0); }

static int axis_of(const int volume[UNITS]) {
  orient3d_signs v;
  for (int i = 0; i < 3; i++) {
    v.s[i] = sign_of(volume[i]);
    v.w[i] = sign_of(volume[3 + i]);
    for (int j = 0; j < 3; j++) {
      v.d[i][j] = sign_of(volume[6 + 3 * i + j]);
    }
  }
  return axis_in_space(&v);
}

/* Were this orient3d, which is `value`, 0, then a pair that is separated would be a collision; and
 * the design finds it by its orient3d, not by its bounding boxes. */
static bool hangs_on(const sepax_design *d, const sepax_pair *pair, int unit, int value) {
  int volume[UNITS];
  find_volumes(pair, volume);
  if (volume[unit] != value) {
    return false;
  }
  const int axis = axis_of(volume);
  volume[unit] = 0;
  return axis != SEPAX_AXIS_NONE && axis_of(volume) == SEPAX_AXIS_NONE &&
         sepax_judge(d, pair).axis == axis;
}

static void draw_near_origin(sepax_pair *pair, sepax_random *random) {
  for (int i = 0; i < 6; i++) {
    sepax_vec *v = i < 3 ? &pair->a.v[i] : &pair->b.v[i - 3];
    v->x = (int32_t)sepax_random_range(random, -1, 1);
    v->y = (int32_t)sepax_random_range(random, -1, 1);
    v->z = (int32_t)sepax_random_range(random, -1, 1);
  }
}

static void move(sepax_pair *pair, sepax_vec by) {
  for (int i = 0; i < 6; i++) {
    sepax_vec *v = i < 3 ? &pair->a.v[i] : &pair->b.v[i - 3];
    *v = (sepax_vec){v->x + by.x, v->y + by.y, v->z + by.z};
  }
}

bool bench_draw_unit(const sepax_design *d, int n, sepax_pair *pair, sepax_random *random) {
  const int unit = n / 2 % UNITS;
  const int value = n % 2 == 0 ? 1 : -1;
  const int word = d->config.word;
  sepax_pair drawn = {0};
  for (int i = 0; i < TRIES; i++) {
    draw_near_origin(&drawn, random);
    if (hangs_on(d, &drawn, unit, value)) {
      const int64_t least = n / 2 % 2 == 0 ? 0 : sepax_word_min(word) + 1;
      const int64_t most = n / 2 % 2 == 0 ? 0 : sepax_word_max(word) - 1;
      move(&drawn, (sepax_vec){(int32_t)sepax_random_range(random, least, most),
                               (int32_t)sepax_random_range(random, least, most),
                               (int32_t)sepax_random_range(random, least, most)});
      *pair = drawn;
      return true;
    }
  }
  return false;
}
