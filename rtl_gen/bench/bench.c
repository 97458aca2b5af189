/* SPDX-License-Identifier: MIT */
/* bench.c - see bench.h. sepax_tb.v is the bench without its pairs. */
#include "bench/bench.h"
#include "bench/draw.h"

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
    const sepax_pair pair = bench_draw(kind->design, n, &random);
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
