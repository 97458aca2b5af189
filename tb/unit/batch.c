/* batch.c - the verdicts of batches and of meshes against sepax_exact, one by one. */
#include "oracle/pair_tools.h"
#include "sepax_design.h"
#include "sepax_vectors.h"
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
  guarded memory[18], bits_memory;
  int32_t *column[18];
  sepax_columns a, b;
  uint64_t *bits;
} batch;

static void begin(batch *s, size_t count) {
  for (int i = 0; i < 18; i++) {
    s->column[i] = guard(&s->memory[i], count * sizeof *s->column[i]);
    (i < 9 ? &s->a : &s->b)->c[i / 3 % 3][i % 3] = s->column[i];
  }
  s->bits = guard(&s->bits_memory, (count + 63) / 64 * sizeof *s->bits);
}

static void fill(batch *s, size_t count, size_t family, int word, sepax_random *random) {
  for (size_t n = 0; n < count; n++) {
    sepax_pair pair = sepax_family_pair(family, word, random);
    s->t[0][n] = pair.a;
    s->t[1][n] = pair.b;
    for (int i = 0; i < 18; i++) {
      sepax_vec v = s->t[i / 9][n].v[i / 3 % 3];
      s->column[i][n] = i % 3 == 0 ? v.x : i % 3 == 1 ? v.y : v.z;
    }
  }
}

static void end(batch *s) {
  for (int i = 0; i < 18; i++) {
    release(&s->memory[i]);
  }
  release(&s->bits_memory);
}

/* One of A against all, or pairs: 0 different, nothing behind the end. */
static void assert_judged(batch *s, sepax_path path, size_t count, bool one) {
  memset(s->bits, 0xa5, (count + 63) / 64 * sizeof *s->bits);
  if (one) {
    sepax_exact_one_to_many(path, &s->t[0][0], &s->b, count, s->bits);
  } else {
    sepax_exact_pairs(path, &s->a, &s->b, count, s->bits);
  }
  for (size_t n = 0; n < (count + 63) / 64 * 64; n++) {
    bool expected = n < count && sepax_exact(&s->t[0][one ? 0 : n], &s->t[1][n]).collision;
    if (((s->bits[n / 64] >> n % 64 & 1) != 0) != expected) {
      fail_msg("%s, pair %zu of %zu: %d expected", sepax_path_name(path), n, count, expected);
    }
  }
}

static void assert_all_ways(batch *s, size_t count) {
  for (sepax_path path = SEPAX_PATH_BEST; path <= SEPAX_PATH_AVX512; path++) {
    if (sepax_path_runs(path)) {
      assert_judged(s, path, count, false);
      assert_judged(s, path, count, count > 0);
    }
  }
}

CASE(every_family_at_every_word) {
  static batch s;
  begin(&s, MOST);
  for (size_t family = 0; family < family_count(); family++) {
    for (int word = SEPAX_WORD_MIN; word <= SEPAX_WORD_MAX; word++) {
      sepax_random random = seeded(family, word);
      fill(&s, MOST, family, word, &random);
      assert_all_ways(&s, MOST);
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
  begin(&s, MOST);
  size_t corners = 0;
  while (strcmp(sepax_family_name(corners), "corners") != 0) {
    corners++;
  }
  for (int round = 0; round < 200; round++) {
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
  sepax_tri *t = calloc(count + 1, sizeof *t);
  assert_non_null(t);
  for (size_t n = 0; n < count; n++) {
    int64_t at[3];
    for (int axis = 0; axis < 3; axis++) {
      at[axis] =
          sepax_random_range(random, sepax_word_min(word) + size, sepax_word_max(word) - size);
    }
    for (int k = 0; k < 3; k++) {
      t[n].v[k].x = (int32_t)(at[0] + sepax_random_range(random, -size, size));
      t[n].v[k].y = (int32_t)(at[1] + sepax_random_range(random, -size, size));
      t[n].v[k].z = (int32_t)(at[2] + sepax_random_range(random, -size, size));
    }
  }
  return t;
}

static void assert_all_pairs(const sepax_tri *a, size_t count_a, const sepax_tri *b, size_t count_b,
                             const sepax_search *how) {
  sepax_pairs found;
  sepax_error error = {""};
  assert_true(sepax_colliding_pairs(a, count_a, b, count_b, how, &found, &error));
  size_t k = 0;
  for (size_t i = 0; i < count_a; i++) {
    for (size_t j = 0; j < count_b; j++) {
      if (sepax_exact(&a[i], &b[j]).collision) {
        assert_true(k < found.count && found.pair[k][0] == i && found.pair[k][1] == j);
        k++;
      }
    }
  }
  assert_int_equal(k, found.count);
  sepax_pairs_free(&found);
}

CASE(meshes_of_every_size) {
  static const size_t counts[][2] = {{0, 0},   {0, 5},   {5, 0},   {1, 1},     {1, 200},
                                     {64, 64}, {65, 63}, {200, 1}, {129, 700}, {500, 4200}};
  static const int word[] = {5, 18, 24, 32};
  sepax_random random = {9};
  for (size_t c = 0; c < LENGTH(counts); c++) {
    for (size_t w = 0; w < LENGTH(word); w++) {
      int64_t size = INT64_C(1) << (word[w] - 4);
      sepax_tri *a = soup(counts[c][0], word[w], size, &random);
      sepax_tri *b = soup(counts[c][1], word[w], size, &random);
      for (int way = 0; way < 4; way++) {
        sepax_search how = {.threads = way < 2 ? 1 : 3, .brute_force = way % 2 == 1};
        assert_all_pairs(a, counts[c][0], b, counts[c][1], &how);
      }
      assert_all_pairs(a, counts[c][0], b, counts[c][1], NULL);
      free(a);
      free(b);
    }
  }
}

/* Trees end in empty leaves, for 129 triangles in the fourth of four; a triangle that reaches both
 * ends of the range on all axes meets none of them. */
CASE(empty_leaves_are_left_out) {
  enum { SMALL = 129 };
  const sepax_tri whole = {{{INT32_MIN, INT32_MIN, INT32_MIN},
                            {INT32_MAX, INT32_MAX, INT32_MAX},
                            {INT32_MIN, INT32_MAX, INT32_MIN}}};
  sepax_error error = {""};
  sepax_config config = sepax_config_default();
  sepax_design design;
  config.word = SEPAX_WORD_MAX;
  config.clearance = INT32_MAX;
  assert_true(sepax_design_init(&design, &config, &error));
  sepax_random random = {11};
  sepax_tri *many = soup(SMALL, SEPAX_WORD_MAX, 1000, &random);
  for (int way = 0; way < 2; way++) {
    sepax_search how = {.threads = 1, .brute_force = way == 1};
    assert_all_pairs(&whole, 1, many, SMALL, &how);
    assert_all_pairs(many, SMALL, &whole, 1, &how);
    sepax_pairs found;
    assert_true(sepax_near_pairs(&design, &whole, 1, many, SMALL, &how, &found, &error));
    size_t expected = 0;
    for (size_t n = 0; n < SMALL; n++) {
      expected += sepax_clearance(&design, &whole, &many[n]).band != SEPAX_BAND_FREE;
    }
    assert_true(expected > 0 && expected == found.count);
    sepax_pairs_free(&found);
  }
  free(many);
}

typedef struct {
  uint64_t calls, last, total, ends;
} watch;

static bool watched(void *context, uint64_t done, uint64_t total) {
  watch *w = context;
  w->calls++;
  w->last = done;
  w->total = total;
  return w->calls < w->ends;
}

CASE(progress_is_told_and_ends) {
  sepax_random random = {10};
  sepax_tri *a = soup(1000, 18, 5000, &random);
  sepax_pairs found;
  sepax_error error = {""};
  watch w = {.ends = UINT64_MAX};
  sepax_search how = {.threads = 1, .progress = watched, .context = &w};
  assert_true(sepax_colliding_pairs(a, 1000, a, 1000, &how, &found, &error));
  assert_true(w.calls > 5 && w.last == w.total);
  sepax_pairs_free(&found);
  w = (watch){.ends = 3};
  assert_false(sepax_colliding_pairs(a, 1000, a, 1000, &how, &found, &error));
  assert_int_equal(w.calls, 3);
  assert_non_null(strstr(error.text, "ended"));
  free(a);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(every_family_at_every_word),
      cmocka_unit_test(every_count),
      cmocka_unit_test(words_mixed),
      cmocka_unit_test(meshes_of_every_size),
      cmocka_unit_test(empty_leaves_are_left_out),
      cmocka_unit_test(progress_is_told_and_ends),
  };
  printf("paths:");
  for (sepax_path path = SEPAX_PATH_PORTABLE; path <= SEPAX_PATH_AVX512; path++) {
    printf(" %s%s", sepax_path_name(path), sepax_path_runs(path) ? "" : " (not on this machine)");
  }
  putchar('\n');
  return cmocka_run_group_tests(tests, NULL, NULL);
}
