/* SPDX-License-Identifier: MIT */
/* batch.c - the verdicts of batches and of meshes against sepax_exact, one by one. */
#include "oracle/geometry.h"
#include "oracle/pair_tools.h"
#include "harness.h"

#include <fcntl.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <unistd.h>

enum { MOST = 500 };

/* ------------------------------------------------------------ guarded memory */

/* `size` bytes, the last right before a page that cannot be touched, the page before the
 * first cannot be either. */
typedef struct {
  uint8_t *all;
  size_t pages, page;
} guarded;

static void *guard(guarded *g, size_t size) {
  g->page = (size_t)sysconf(_SC_PAGESIZE);
  g->pages = (size + g->page - 1) / g->page + 2;
  int zero = open("/dev/zero", O_RDWR);
  g->all = mmap(NULL, g->pages * g->page, PROT_NONE, MAP_PRIVATE, zero, 0);
  assert_true(zero >= 0 && g->all != MAP_FAILED);
  close(zero);
  if (g->pages > 2) {
    assert_int_equal(mprotect(g->all + g->page, (g->pages - 2) * g->page, PROT_READ | PROT_WRITE),
                     0);
  }
  return g->all + (g->pages - 1) * g->page - size;
}

static void release(guarded *g) { munmap(g->all, g->pages * g->page); }

/* ------------------------------------------------------------------- batches */

typedef struct {
  sepax_tri t[2][MOST];
  guarded memory[COORDINATES + 1];
  int32_t *column[COORDINATES];
  sepax_columns a, b;
  uint64_t *bits;
} batch;

static void begin(batch *s, size_t count) {
  for (int i = 0; i < COORDINATES; i++) {
    s->column[i] = guard(&s->memory[i], count * sizeof *s->column[i]);
    (i < 9 ? &s->a : &s->b)->c[i / 3 % 3][i % 3] = s->column[i];
  }
  s->bits = guard(&s->memory[COORDINATES], (count + 63) / 64 * sizeof *s->bits);
}

static void fill(batch *s, size_t count, size_t family, int word, sepax_random *random) {
  for (size_t n = 0; n < count; n++) {
    sepax_pair pair = sepax_family_pair(family, word, random);
    s->t[0][n] = pair.a;
    s->t[1][n] = pair.b;
    for (int i = 0; i < COORDINATES; i++) {
      s->column[i][n] = field_of(&pair, i);
    }
  }
}

static void end(batch *s) {
  for (int i = 0; i <= COORDINATES; i++) {
    release(&s->memory[i]);
  }
}

/* One of A against all, or pairs: 0 different, nothing behind the end. */
static void assert_judged(batch *s, sepax_simd way, size_t count, bool one) {
  memset(s->bits, 0xa5, (count + 63) / 64 * sizeof *s->bits);
  if (one) {
    sepax_exact_one_to_many(way, &s->t[0][0], &s->b, count, s->bits);
  } else {
    sepax_exact_pairs(way, &s->a, &s->b, count, s->bits);
  }
  for (size_t n = 0; n < (count + 63) / 64 * 64; n++) {
    bool expected = n < count && sepax_exact(&s->t[0][one ? 0 : n], &s->t[1][n]).collision;
    if (((s->bits[n / 64] >> n % 64 & 1) != 0) != expected) {
      fail_msg("%s, pair %zu of %zu: %d expected", sepax_simd_name(way), n, count, expected);
    }
  }
}

static void assert_all_ways(batch *s, size_t count) {
  for (sepax_simd way = SEPAX_SIMD_BEST; way <= SEPAX_SIMD_AVX512; way++) {
    if (sepax_simd_runs(way)) {
      assert_judged(s, way, count, false);
      assert_judged(s, way, count, count > 0);
    }
  }
}

CASE(every_family_at_every_word) {
  static batch s;
  for (sepax_simd way = SEPAX_SIMD_PORTABLE; way <= SEPAX_SIMD_AVX512; way++) {
    print_message("%s: %s\n", sepax_simd_name(way), sepax_simd_runs(way) ? "runs" : "not here");
  }
  begin(&s, FEWER(MOST));
  for (size_t family = 0; family < family_count(); family++) {
    for (int word = SEPAX_WORD_MIN; word <= SEPAX_WORD_MAX; word++) {
      sepax_random random = seeded(family, word);
      fill(&s, FEWER(MOST), family, word, &random);
      assert_all_ways(&s, FEWER(MOST));
    }
  }
  end(&s);
}

/* Each count has pages of its own right at the ends: a read beyond them is a fault. */
CASE(every_count) {
  static batch s;
  sepax_random random = {7};
  for (size_t count = 0; count <= 200; count++) {
    begin(&s, count);
    fill(&s, count, count % family_count(), count % 3 == 0 ? 30 : 18, &random);
    assert_all_ways(&s, count);
    end(&s);
  }
}

/* Short, long and very long coordinates in one batch; the ends of the range of each kind. */
CASE(words_mixed) {
  static const int word[] = {8, 20, 21, 25, 26, 32};
  static batch s;
  sepax_random random = {8};
  size_t corners = family_number("corners");
  begin(&s, MOST);
  for (int round = 0; round < FEWER(200); round++) {
    fill(&s, MOST, corners, word[round % (int)LENGTH(word)], &random);
    for (int i = 0; i < 9; i++) {
      size_t n = (size_t)sepax_random_range(&random, 0, MOST - 1);
      s.t[0][n].v[i / 3].x = s.column[i / 3 * 3][n] = INT32_MIN;
    }
    assert_all_ways(&s, MOST);
  }
  end(&s);
}

/* -------------------------------------------------------------------- meshes */

static sepax_tri *soup(size_t count, int word, int64_t size, sepax_random *random) {
  sepax_tri *t = calloc(count > 0 ? count : 1, sizeof *t);
  assert_non_null(t);
  for (size_t n = 0; n < count; n++) {
    for (int axis = 0; axis < 3; axis++) {
      int64_t at =
          sepax_random_range(random, sepax_word_min(word) + size, sepax_word_max(word) - size);
      for (int k = 0; k < 3; k++) {
        *coordinate(&t[n].v[k], axis) = (int32_t)(at + sepax_random_range(random, -size, size));
      }
    }
  }
  return t;
}

/* What a double loop finds: collisions, or with a design pairs that it does not call free; how many
 * in each band. */
typedef struct {
  size_t of[3];
} bands;

static bands assert_all_pairs(const sepax_design *design, bool tight, const sepax_tri *a,
                              size_t count_a, const sepax_tri *b, size_t count_b,
                              const sepax_search *how) {
  sepax_pairs found;
  bands count = {{0}};
  assert_works(design == NULL
                   ? sepax_colliding_pairs(a, count_a, b, count_b, how, &found, &fault)
                   : sepax_near_pairs(design, tight, a, count_a, b, count_b, how, &found, &fault));
  size_t k = 0;
  for (size_t i = 0; i < count_a; i++) {
    for (size_t j = 0; j < count_b; j++) {
      sepax_band band =
          design != NULL
              ? (tight ? sepax_clearance_tight : sepax_clearance)(design, &a[i], &b[j]).band
          : sepax_exact(&a[i], &b[j]).collision ? SEPAX_BAND_COLLISION
                                                : SEPAX_BAND_FREE;
      count.of[band]++;
      if (band != SEPAX_BAND_FREE) {
        assert_true(k < found.count && found.pair[k][0] == i && found.pair[k][1] == j);
        k++;
      }
    }
  }
  assert_int_equal(k, found.count);
  sepax_pairs_free(&found);
  return count;
}

CASE(meshes_of_every_size) {
  static const size_t counts[][2] = {{0, 0},    {0, 5},    {5, 0},     {1, 1},
                                     {1, 200},  {64, 64},  {65, 63},   {200, 1},
                                     {2, 2100}, {2100, 2}, {129, 700}, {FEWER(500), FEWER(4200)}};
  static const int word[] = {5, 18, 24, 32};
  sepax_random random = {9};
  for (size_t c = 0; c < LENGTH(counts); c++) {
    for (size_t w = 0; w < LENGTH(word); w++) {
      int64_t size = INT64_C(1) << (word[w] - 4);
      sepax_tri *a = soup(counts[c][0], word[w], size, &random);
      sepax_tri *b = soup(counts[c][1], word[w], size, &random);
      for (int way = 0; way < 5; way++) {
        sepax_search how = {
            .size = sizeof(sepax_search), .threads = way < 2 ? 1 : 3, .brute_force = way % 2 == 1};
        assert_all_pairs(NULL, false, a, counts[c][0], b, counts[c][1], way < 4 ? &how : NULL);
      }
      free(a);
      free(b);
    }
  }
}

CASE(near_pairs_are_found) {
  enum { COUNT = 300 };
  sepax_random random = {11};
  sepax_design design = design_of("--clearance=20 --warning=60");
  sepax_tri *a = soup(COUNT, 10, 90, &random);
  sepax_tri *b = soup(COUNT, 10, 90, &random);
  bands count = assert_all_pairs(&design, false, a, COUNT, b, COUNT, NULL);
  assert_true(count.of[SEPAX_BAND_WARNING] > 50 && count.of[SEPAX_BAND_COLLISION] > 50);
  bands tight = assert_all_pairs(&design, true, a, COUNT, b, COUNT, NULL);
  assert_true(tight.of[SEPAX_BAND_FREE] > count.of[SEPAX_BAND_FREE]);
  free(a);
  free(b);
}

/* Trees end in empty leaves, for 129 triangles in the fourth of four; a triangle that reaches both
 * ends of the range on all axes meets none of them. */
CASE(empty_leaves_are_left_out) {
  enum { SMALL = 129 };
  const sepax_tri whole = {{{INT32_MIN, INT32_MIN, INT32_MIN},
                            {INT32_MAX, INT32_MAX, INT32_MAX},
                            {INT32_MIN, INT32_MAX, INT32_MIN}}};
  sepax_design design = design_of("--word=32 --clearance=%d", INT32_MAX);
  sepax_random random = {11};
  sepax_tri *many = soup(SMALL, SEPAX_WORD_MAX, 1000, &random);
  for (int way = 0; way < 2; way++) {
    sepax_search how = {.size = sizeof(sepax_search), .threads = 1, .brute_force = way == 1};
    assert_all_pairs(NULL, false, &whole, 1, many, SMALL, &how);
    assert_all_pairs(NULL, false, many, SMALL, &whole, 1, &how);
    bands count = assert_all_pairs(&design, false, &whole, 1, many, SMALL, &how);
    assert_true(count.of[SEPAX_BAND_FREE] < SMALL);
  }
  free(many);
}

typedef struct {
  uint64_t calls, last, total, ends, between;
} watch;

static bool watched(void *context, uint64_t done, uint64_t total) {
  watch *w = context;
  assert_true(done >= w->last && done <= total);
  w->between += done > w->last && done < total;
  w->calls++;
  w->last = done;
  w->total = total;
  return w->calls < w->ends;
}

CASE(progress_is_told_and_ends) {
  sepax_random random = {10};
  sepax_tri *a = soup(1000, 18, 5000, &random);
  sepax_pairs found;
  watch w = {.ends = UINT64_MAX};
  sepax_search how = {
      .size = sizeof(sepax_search), .threads = 1, .progress = watched, .context = &w};
  assert_works(sepax_colliding_pairs(a, 1000, a, 1000, &how, &found, &fault));
  assert_true(w.calls > 5 && w.between > 3 && w.last == w.total);
  sepax_pairs_free(&found);
  for (int way = 0; way < 2; way++) {
    how.brute_force = way == 1;
    w = (watch){.ends = 3};
    assert_fault(sepax_colliding_pairs(a, 1000, a, 1000, &how, &found, &fault), "ended");
    assert_int_equal(w.calls, 3);
    assert_true(found.count == 0 && found.pair == NULL);
  }
  /* Tasks of 64 triangles of A with 4,096 of B: the numbers of those that are done, then all. */
  w = (watch){.ends = UINT64_MAX};
  assert_works(sepax_colliding_pairs(a, 129, a, 1000, &how, &found, &fault));
  assert_true(w.calls == 4 && w.last == 3 && w.total == 3);
  sepax_pairs_free(&found);
  assert_true(found.count == 0 && found.pair == NULL);
  free(a);
}

/* A search for the first pair ends with it, also where other candidates wait. */
CASE(first_pair_alone) {
  static const size_t counts[] = {4, 12, 60, 1000};
  sepax_random random = {12};
  sepax_tri *a = soup(1000, 18, 50000, &random);
  for (int way = 0; way < 8; way++) {
    sepax_search how = {
        .size = sizeof(sepax_search), .threads = 3, .first = true, .brute_force = way % 2 == 1};
    const size_t count = counts[way / 2];
    sepax_pairs found;
    assert_works(sepax_colliding_pairs(a, count, a, count, &how, &found, &fault));
    assert_int_equal(found.count, 1);
    const size_t *pair = found.pair[0];
    assert_true(sepax_exact(&a[pair[0]], &a[pair[1]]).collision);
    sepax_pairs_free(&found);
  }
  free(a);
}

CASE(too_many_are_refused) {
  static const sepax_tri one = {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}};
  const size_t many = (size_t)UINT32_MAX + 1;
  sepax_pairs found;
  assert_fault(sepax_colliding_pairs(&one, many, &one, 1, NULL, &found, &fault), "2^32 - 1");
  assert_fault(sepax_colliding_pairs(&one, 1, &one, many, NULL, &found, &fault), "2^32 - 1");
}
