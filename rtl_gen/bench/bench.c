/* SPDX-License-Identifier: MIT */
/* bench.c - see bench.h. sepax_tb.v is the bench without its pairs. */
#include "bench/bench.h"

#include "sepax_vectors.h"

#include <inttypes.h>
#include <string.h>

/* What of a design its bench depends on. */
typedef struct {
  const sepax_design *design;
  int word;    /* bits of a number in the text of a pair */
  int numbers; /* of a pair */
  bool stream, published;
} bench_kind;

/* The numbers of a pair in the order of the inputs, the lowest first. */
enum { NUMBERS_MOST = 24 };
typedef struct {
  int32_t number[NUMBERS_MOST];
} bench_numbers;

/* --------------------------------------------------------------------------- pairs */

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
    const int64_t of_a = *component(&pair->a.v[i], axis);
    const int64_t of_b = *component(&pair->b.v[i], axis);
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

/* Pair n: the families of hard pairs in turn. */
static sepax_pair draw_pair(const sepax_design *d, int n, sepax_random *random) {
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
  if (kind == 2 || (kind == 6 && d->limits == 0)) {
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

static void put_vector(int32_t *number, sepax_vec v) {
  number[0] = v.x;
  number[1] = v.y;
  number[2] = v.z;
}

/* Coordinates by vertex; of the published architectures word k is {N_B, N_A, B_k, A_k}. */
static bench_numbers numbers_of(const sepax_pair *pair, bool published) {
  bench_numbers all = {{0}};
  const int32_t na[3] = {pair->na.x, pair->na.y, pair->na.z};
  const int32_t nb[3] = {pair->nb.x, pair->nb.y, pair->nb.z};
  for (int k = 0; k < 3; k++) {
    put_vector(all.number + (published ? 8 * k : 3 * k), pair->a.v[k]);
    put_vector(all.number + (published ? 8 * k + 3 : 9 + 3 * k), pair->b.v[k]);
    if (published) {
      all.number[8 * k + 6] = na[k];
      all.number[8 * k + 7] = nb[k];
    }
  }
  return all;
}

/* ------------------------------------------------------------------------ verdicts */

/* As m_axis_tdata has them. */
enum { DATA_COPLANAR = 1, DATA_RANGE = 2, DATA_CUT = 3, DATA_BAND = 4, DATA_AXIS = 8 };

static unsigned undecided(const sepax_design *d) {
  const unsigned band = d->limits > 0 ? SEPAX_BAND_COLLISION : 0;
  return 1U | 1U << DATA_RANGE | band << DATA_BAND | (unsigned)SEPAX_AXIS_EXTENT << DATA_AXIS;
}

static void print_verdict(const bench_kind *kind, const sepax_judgement *v, bool outside,
                          emit_text *out) {
  const bool range = v->axis == SEPAX_AXIS_EXTENT;
  const unsigned band = kind->design->limits > 0 ? (unsigned)v->band : 0;
  const unsigned axis = (unsigned)v->axis;
  if (kind->published) {
    text_printf(out, "2'b%d_%d", v->collision, v->coplanar);
  } else if (kind->stream) {
    text_printf(out, "32'h%08x",
                outside
                    ? undecided(kind->design)
                    : (unsigned)v->collision | (unsigned)v->coplanar << DATA_COPLANAR |
                          (unsigned)range << DATA_RANGE | band << DATA_BAND | axis << DATA_AXIS);
  } else {
    text_printf(out, "9'b%d_%u%u_%d_%d_%u%u%u%u", range, band / 2, band % 2, v->collision,
                v->coplanar, axis / 8, axis / 4 % 2, axis / 2 % 2, axis % 2);
  }
}

/* The numbers of so many bits each as hexadecimal digits, the last number first. */
static void print_numbers(const bench_numbers *all, int numbers, int bits, emit_text *out) {
  const int total = numbers * bits;
  text_printf(out, "%d'h", total);
  for (int digit = (total - 1) / 4; digit >= 0; digit--) {
    unsigned value = 0;
    for (int k = 0; k < 4; k++) {
      const int bit = 4 * digit + k;
      const unsigned number = bit < total ? (unsigned)all->number[bit / bits] : 0;
      value |= (number >> bit % bits & 1) << k;
    }
    text_putc(out, "0123456789abcdef"[value]);
  }
}

/* Now and then a coordinate of a stream does not fit the word. */
static bool put_outside(bench_numbers *all, const bench_kind *kind, int n, sepax_random *random) {
  const int word = kind->design->config.word;
  if (!kind->stream || word == 32 || n % 8 != 5) {
    return false;
  }
  const int64_t least = (int64_t)sepax_word_max(word) + 1;
  const int64_t most = n % 16 == 5 ? least : INT32_MAX;
  const int64_t beyond = sepax_random_range(random, least, most);
  const bool negative = sepax_random_range(random, 0, 1) != 0;
  all->number[sepax_random_range(random, 0, 17)] = (int32_t)(negative ? -beyond - 1 : beyond);
  return true;
}

static void print_pairs(const bench_kind *kind, int vectors, emit_text *out) {
  sepax_random random = {1};
  for (int n = 0; n < vectors; n++) {
    const sepax_pair pair = draw_pair(kind->design, n, &random);
    bench_numbers all = numbers_of(&pair, kind->published);
    const bool outside = put_outside(&all, kind, n, &random);
    const sepax_judgement verdict = sepax_judge(kind->design, &pair);
    text_printf(out, "    pair[%d] = ", n);
    print_numbers(&all, kind->numbers, kind->word, out);
    text_printf(out, ";\n    verdict[%d] = ", n);
    print_verdict(kind, &verdict, outside, out);
    text_puts(out, ";\n");
  }
}

/* ----------------------------------------------------------------------- the bench */

static void set_holes(emit_holes *h, const bench_kind *kind, int vectors) {
  const sepax_design *d = kind->design;
  const sepax_config *c = &d->config;
  const int parts = kind->stream ? sepax_stream_transfers(c) : kind->published ? 3 : 1;
  const int out = kind->published ? 2 : kind->stream ? 33 + c->tag : 9;
  emit_hole_numbers(h, (emit_number[]){{"word", c->word},
                                       {"vectors", vectors},
                                       {"parts", parts},
                                       {"latency", d->latency},
                                       {"gap", parts > c->ii ? parts : c->ii},
                                       {"ii", c->ii},
                                       {"in", kind->numbers * kind->word},
                                       {"out", out},
                                       {"verdict", kind->stream ? 32 : out},
                                       {"stream", kind->stream},
                                       {"published", kind->published},
                                       {"exact", !kind->stream && !kind->published},
                                       {"extents", c->extent_a > 0},
                                       {"limits", d->limits},
                                       {"engine", c->lanes > 0 || c->tree},
                                       {"tag", c->tag},
                                       {"bits", parts == 6 ? 128 : 1024 / parts},
                                       {"cut", undecided(d) | 1U << DATA_CUT},
                                       {NULL, 0}});
  emit_hole_set(h, "top", kind->stream ? "sepax_stream" : "sepax_top");
  emit_hole_set(h, "always", kind->published ? "1'b1" : "1'b0");
  emit_hole_set(h, "drawn_tag", c->tag > 32 ? "{random[%d:0], random}" : "random[%d:0]",
                (c->tag - 1) % 32);
  emit_hole_set(h, "pair_about",
                kind->published ? "{n_b, n_a, b_z, b_y, b_x, a_z, a_y, a_x} of words 3, 2, 1"
                                : "{b3_z, b3_y, b3_x, b2_z ... a1_y, a1_x}");
  emit_hole_set(h, "verdict_about",
                kind->published ? "{collision, coplanar}"
                : kind->stream  ? "m_axis_tdata"
                                : "{out_of_range, band, collision, coplanar, axis}");
}

void bench_write(emitter *e, int vectors, emit_text *out) {
  const sepax_design *d = e->design;
  const bool published = d->config.arch != SEPAX_ARCH_EXACT;
  const bool stream = d->config.stream != SEPAX_STREAM_NONE;
  const bench_kind kind = {.design = d,
                           .word = stream ? 32 : d->config.word,
                           .numbers = published ? 24 : 18,
                           .stream = stream,
                           .published = published};
  emit_holes h = {0};
  set_holes(&h, &kind, vectors);
  emit_hole_set(&h, "prefix", "%s", e->prefix);
  text_puts(out, "// sepax_tb.v\n// SPDX-License-Identifier: MIT\n//\n");
  emit_origin(e, "//", out);
  text_puts(out, "//\n");
  emit_fill(e, "bench/sepax_tb", h.hole, out);
  print_pairs(&kind, vectors, out);
  text_puts(out, "  end\nendmodule\n\n`default_nettype wire\n");
  emit_holes_free(&h);
}
