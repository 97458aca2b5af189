/* SPDX-License-Identifier: MIT */
/* draw.c - see draw.h. */
#include "bench/draw.h"

/* Pairs of unit size cost more to find; by then each orient3d has had two as 1 and two as -1. */
enum { UNIT_BELOW = 512 };

static int64_t clamp(int64_t value, int word) {
  const int64_t least = sepax_word_min(word);
  const int64_t most = sepax_word_max(word);
  return value < least ? least : value > most ? most : value;
}

static int32_t *component(sepax_vec *v, int axis) {
  return axis == 0 ? &v->x : axis == 1 ? &v->y : &v->z;
}

/* Move B along an axis. Where a vertex would leave the word, it stays at its end. */
static void move_b(sepax_pair *pair, int axis, int64_t by, int word) {
  for (int i = 0; i < 3; i++) {
    int32_t *c = component(&pair->b.v[i], axis);
    *c = (int32_t)clamp(*c + by, word);
  }
}

/* Move B by up to somewhat more than the largest clearance along each axis. */
static void move_near(sepax_pair *pair, const sepax_design *d, sepax_random *random) {
  const int64_t most = 2 + d->margin[1] + d->margin[1] / 2;
  for (int axis = 0; axis < 3; axis++) {
    if (sepax_random_range(random, 0, 1) != 0) {
      move_b(pair, axis, sepax_random_range(random, -most, most), d->config.word);
    }
  }
}

/* Move B along the normal of A, by a length up to twice the largest clearance. */
static void move_off(sepax_pair *pair, const sepax_design *d, sepax_random *random) {
  const int word = d->config.word;
  const sepax_vec normal = sepax_unit_normal(&pair->a, word);
  const int64_t part[3] = {normal.x, normal.y, normal.z};
  const int64_t by = sepax_random_range(random, d->margin[0] / 2, 2 * d->margin[1] + 2);
  for (int axis = 0; axis < 3; axis++) {
    move_b(pair, axis, part[axis] * by / sepax_word_max(word), word);
  }
}

/* Move B above A along an axis, so that the gap of the AABBs is just a margin, or more by 1. */
static void move_to_margin(sepax_pair *pair, const sepax_design *d, sepax_random *random) {
  const int axis = (int)sepax_random_range(random, 0, 2);
  const int64_t gap =
      d->margin[sepax_random_range(random, 0, 1)] + sepax_random_range(random, 0, 1);
  int64_t highest = INT32_MIN;
  int64_t lowest = INT32_MAX;
  for (int i = 0; i < 3; i++) {
    const int32_t of_a = *component(&pair->a.v[i], axis);
    const int32_t of_b = *component(&pair->b.v[i], axis);
    highest = of_a > highest ? of_a : highest;
    lowest = of_b < lowest ? of_b : lowest;
  }
  move_b(pair, axis, highest + gap - lowest, d->config.word);
}

/* Into a plane x = c, y = c, z = c or x = y, or on a line along z. Hard pairs are seldom in a plane
 * along z, in which a core needs a second pass. */
static void flatten(sepax_pair *pair, int how) {
  const sepax_vec at = pair->a.v[0];
  for (int i = 0; i < 6; i++) {
    sepax_vec *v = i < 3 ? &pair->a.v[i] : &pair->b.v[i - 3];
    v->x = how == 0 || how == 4 ? at.x : how == 3 ? v->y : v->x;
    v->y = how == 1 || how == 4 ? at.y : v->y;
    v->z = how == 2 ? at.z : v->z;
  }
}

sepax_pair bench_draw(const sepax_design *d, int n, sepax_random *random) {
  size_t families = 1;
  while (sepax_family_name(families) != NULL) {
    families++;
  }
  const sepax_config *c = &d->config;
  const size_t family = (size_t)n % families;
  const int extent[2] = {c->extent_a, c->extent_b};
  sepax_pair pair = c->extent_a > 0 ? sepax_extent_pair(family, c->word, extent, n % 4 == 3, random)
                                    : sepax_family_triangles(family, c->word, random);
  const int kind = n % 8;
  if (kind == 4 && n < UNIT_BELOW && c->arch == SEPAX_ARCH_EXACT && d->limits == 0) {
    bench_draw_unit(d, n / 8, &pair, random);
  } else if (kind == 2 || (kind == 6 && d->limits == 0)) {
    flatten(&pair, n / 8 % 5);
  } else if (kind == 1) {
    move_to_margin(&pair, d, random);
  } else if (d->limits > 0 && kind % 4 != 0) {
    (kind == 5 ? move_near : move_off)(&pair, d, random);
  }
  if (c->arch != SEPAX_ARCH_EXACT) {
    pair.na = sepax_unit_normal(&pair.a, c->word);
    pair.nb = sepax_unit_normal(&pair.b, c->word);
  }
  return pair;
}
