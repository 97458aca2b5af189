/* SPDX-License-Identifier: MIT */
/* walk.c - the walk finds the pairs that brute force finds for the same rounded vertices, all of
 * them, once. TREE_COLLISIONS: as many collisions as are to be compared. */
#include "unit/tree/scenes.h"

/* Which pairs of triangles, by their numbers in the mesh, collide. */
typedef struct {
  size_t (*pair)[2];
  size_t count, capacity;
} pair_list;

typedef struct {
  const triangles *a, *b;
  const sepax_tree *tree_a, *tree_b;
  const sepax_design *design;
  sepax_tree_pose pose;
  pair_list found;
  size_t out_of_range;
} search;

static void add_pair(pair_list *l, size_t i, size_t j) {
  if (l->count == l->capacity) {
    l->capacity = 2 * l->capacity + 1000;
    l->pair = realloc(l->pair, l->capacity * sizeof *l->pair);
    assert_non_null(l->pair);
  }
  l->pair[l->count][0] = i;
  l->pair[l->count++][1] = j;
}

static int by_numbers(const void *p, const void *q) {
  const size_t *a = p;
  const size_t *b = q;
  return a[0] != b[0] ? (a[0] > b[0]) - (a[0] < b[0]) : (a[1] > b[1]) - (a[1] < b[1]);
}

typedef struct {
  int64_t low[3], high[3];
} bounds;

static bounds bounds_of(const sepax_tri *t) {
  bounds b;
  for (int i = 0; i < 3; i++) {
    sepax_tri copy = *t;
    int64_t c[3] = {*coordinate(&copy.v[0], i), *coordinate(&copy.v[1], i),
                    *coordinate(&copy.v[2], i)};
    b.low[i] = c[0];
    b.high[i] = c[0];
    for (int k = 1; k < 3; k++) {
      b.low[i] = c[k] < b.low[i] ? c[k] : b.low[i];
      b.high[i] = c[k] > b.high[i] ? c[k] : b.high[i];
    }
  }
  return b;
}

static bool are_near(const bounds *a, const bounds *b, int64_t margin) {
  return b->low[0] - a->high[0] <= margin && a->low[0] - b->high[0] <= margin &&
         b->low[1] - a->high[1] <= margin && a->low[1] - b->high[1] <= margin &&
         b->low[2] - a->high[2] <= margin && a->low[2] - b->high[2] <= margin;
}

/* Triangle j of B in A's coordinates; false if it is beyond the word. */
static bool turn(const search *s, size_t j, sepax_tri *t) {
  int word = s->design->config.word;
  bool fits = true;
  for (int k = 0; k < 3; k++) {
    int64_t v[3];
    turn_exactly(v, &s->pose.side[0], &s->b->tri[j].v[k]);
    for (int i = 0; i < 3; i++) {
      fits = fits && v[i] >= sepax_word_min(word) && v[i] <= sepax_word_max(word);
      *coordinate(&t->v[k], i) = (int32_t)v[i];
    }
  }
  return fits;
}

static bool is_found(const search *s, size_t i, const sepax_tri *t) {
  return s->design->limits > 0
             ? sepax_clearance(s->design, &s->a->tri[i], t).band != SEPAX_BAND_FREE
             : sepax_exact(&s->a->tri[i], t).collision;
}

/* A near pair out of range is called a collision; it is compared only if it is one. */
static bool keep(void *context, const sepax_tree_pair *p) {
  search *s = context;
  size_t i = sepax_tree_number(s->tree_a, p->triangle[0]);
  size_t j = sepax_tree_number(s->tree_b, p->triangle[1]);
  sepax_tri t;
  assert_int_equal(p->out_of_range, !turn(s, j, &t));
  s->out_of_range += p->out_of_range;
  bool found = p->collision || p->band != SEPAX_BAND_FREE;
  if (p->out_of_range ? is_found(s, i, &t) : found) {
    add_pair(&s->found, i, j);
  }
  return true;
}

static pair_list by_brute_force(const search *s) {
  pair_list wanted = {0};
  bounds *of_a = malloc(s->a->count * sizeof *of_a);
  assert_non_null(of_a);
  for (size_t i = 0; i < s->a->count; i++) {
    of_a[i] = bounds_of(&s->a->tri[i]);
  }
  for (size_t j = 0; j < s->b->count; j++) {
    sepax_tri t;
    turn(s, j, &t);
    bounds of_b = bounds_of(&t);
    for (size_t i = 0; i < s->a->count; i++) {
      if (are_near(&of_a[i], &of_b, s->design->margin[1]) && is_found(s, i, &t)) {
        add_pair(&wanted, i, j);
      }
    }
  }
  free(of_a);
  return wanted;
}

static void assert_same(pair_list *found, pair_list *wanted) {
  assert_int_equal(found->count, wanted->count);
  if (found->pair != NULL && wanted->pair != NULL) {
    qsort(found->pair, found->count, sizeof *found->pair, by_numbers);
    qsort(wanted->pair, wanted->count, sizeof *wanted->pair, by_numbers);
    assert_memory_equal(found->pair, wanted->pair, found->count * sizeof *found->pair);
  }
  free(found->pair);
  free(wanted->pair);
}

/* How many pairs are found. */
static size_t compare(search *s, const sepax_pose *pose) {
  assert_works(sepax_tree_pose_make(&s->pose, s->tree_a, NULL, s->tree_b, pose,
                                    s->design->margin[1], &fault));
  s->found = (pair_list){0};
  s->out_of_range = 0;
  const sepax_tree_walk_options how = {.design = s->design, .each = keep, .context = s};
  sepax_tree_run run;
  assert_works(sepax_tree_walk(s->tree_a, s->tree_b, &s->pose, &how, &run, &fault));
  assert_false(run.damaged || run.ended);
  assert_int_equal(run.out_of_range, s->out_of_range);
  assert_true(run.cycles >= run.near * (uint64_t)s->design->config.ii &&
              run.cycles >= 3 * run.rows);
  assert_true(run.near >= run.collisions && run.pairs >= run.near && run.pairs >= run.rows);
  pair_list wanted = by_brute_force(s);
  size_t count = wanted.count;
  assert_same(&s->found, &wanted);
  return count;
}

CASE(random_bodies) {
  static const char *const designs[] = {"", "--clearance=4", "--clearance=50 --warning=299"};
  size_t wanted = count_of_run("TREE_COLLISIONS", 50000);
  size_t collisions = 0;
  for (size_t n = 0; collisions < wanted; n++) {
    int word = n % 5 == 4 ? 12 + random_below(10) : 18;
    sepax_design design = design_of("--word=%d %s", word, designs[n % 3]);
    double most = sepax_word_max(word);
    double reach = most * (n % 2 == 0 ? 0.4 : 0.02);
    double size = reach * (n % 7 == 0 ? 1 : 0.1);
    triangles a = drawn(1 + (size_t)random_below(400), (int)(n % 5), reach, size, word);
    triangles b = drawn(1 + (size_t)random_below(400), (int)(n / 5 % 5), reach, size, word);
    sepax_tree *tree_a = tree_of(&a, word);
    sepax_tree *tree_b = tree_of(&b, word);
    for (int k = 0; k < 10; k++) {
      sepax_pose pose = posed(k % 5, reach * 0.4);
      search s = {.a = &a, .b = &b, .tree_a = tree_a, .tree_b = tree_b, .design = &design};
      collisions += compare(&s, &pose);
    }
    sepax_tree_free(tree_a);
    sepax_tree_free(tree_b);
    free(a.tri);
    free(b.tri);
  }
}

/* ------------------------------------------------------- ends, first rows, stack */

typedef struct {
  sepax_tree_pair pair[10000];
  size_t count;
} near_pairs;

static bool keep_near(void *context, const sepax_tree_pair *p) {
  near_pairs *l = context;
  assert_true(l->count < LENGTH(l->pair));
  l->pair[l->count++] = *p;
  return true;
}

static bool is_same(const sepax_tree_pair *p, const sepax_tree_pair *q) {
  return p->triangle[0] == q->triangle[0] && p->triangle[1] == q->triangle[1] &&
         p->leaf[0] == q->leaf[0] && p->leaf[1] == q->leaf[1] && p->child[0] == q->child[0] &&
         p->child[1] == q->child[1];
}

typedef struct {
  triangles t[2];
  sepax_tree *tree[2];
  sepax_tree_pose pose;
} scene;

/* Kind 5: all triangles are the same, so that all meets all. */
static void draw_scene(scene *s, size_t count, int kind) {
  for (int i = 0; i < 2; i++) {
    s->t[i] = drawn(count, kind % 5, 30000, 3000, 18);
    for (size_t n = 1; n < count && kind == 5; n++) {
      s->t[i].tri[n] = s->t[0].tri[0];
    }
    s->t[i].tri[0] = kind == 5 ? s->t[0].tri[0] : s->t[i].tri[0];
    s->tree[i] = tree_of(&s->t[i], 18);
  }
  sepax_pose pose = posed(random_below(5), kind == 5 ? 0 : 20000);
  assert_works(sepax_tree_pose_make(&s->pose, s->tree[0], NULL, s->tree[1], &pose, 0, &fault));
}

static void free_scene(scene *s) {
  for (int i = 0; i < 2; i++) {
    sepax_tree_free(s->tree[i]);
    free(s->t[i].tri);
  }
}

static sepax_tree_run walked(const scene *s, const sepax_tree_walk_options *how) {
  sepax_tree_run run;
  assert_works(sepax_tree_walk(s->tree[0], s->tree[1], &s->pose, how, &run, &fault));
  assert_false(run.damaged);
  return run;
}

/* `first` ends at the first collision of the order; where its pair is the first row, it is told
 * at once, and without `first` all others follow. */
CASE(first_collisions) {
  static near_pairs all;
  sepax_design design = design_of("--word=18");
  size_t hits = 0;
  for (int n = 0; n < 60; n++) {
    scene s;
    draw_scene(&s, 1 + (size_t)random_below(300), n % 5);
    all.count = 0;
    const sepax_tree_walk_options whole = {.design = &design, .each = keep_near, .context = &all};
    sepax_tree_run run = walked(&s, &whole);
    size_t at = 0;
    while (at < all.count && !all.pair[at].collision) {
      at++;
    }
    const sepax_tree_walk_options first = {.design = &design, .first = true};
    sepax_tree_run ended = walked(&s, &first);
    assert_int_equal(run.near, all.count);
    assert_int_equal(ended.ended, at < all.count);
    assert_int_equal(ended.near, at < all.count ? at + 1 : at);
    if (at < all.count) {
      hits++;
      assert_true(is_same(&ended.found, &all.pair[at]) && is_same(&run.found, &all.pair[at]));
      const sepax_tree_pair *last = &all.pair[all.count - 1];
      const sepax_tree_walk_options known = {.design = &design, .first = true, .row = last};
      const sepax_tree_walk_options more = {.design = &design, .row = last};
      ended = walked(&s, &known);
      assert_int_equal(ended.near, last->collision ? 1 : at + 2);
      assert_true(!last->collision || (is_same(&ended.found, last) && ended.entries == 0));
      sepax_tree_run again = walked(&s, &more);
      assert_int_equal(again.near, run.near + 1);
      assert_int_equal(again.rows, run.rows + 1);
      assert_int_equal(again.entries, run.entries);
    }
    free_scene(&s);
  }
  assert_true(hits > 20);
}

/* The least stack and any line: no overflow, the same pairs. */
CASE(small_stacks) {
  static const unsigned lines[] = {1, 2, 32, 200};
  sepax_design design = design_of("--word=18");
  for (int n = 0; n < 40; n++) {
    scene s;
    draw_scene(&s, n == 0 ? 300 : 100 + (size_t)random_below(2000),
               n == 0       ? 5
               : n % 2 == 0 ? 1
                            : 4);
    unsigned height = 0;
    for (int i = 0; i < 2; i++) {
      size_t bytes;
      height += sepax_tree_image(s.tree[i], &bytes)[14] & 15U;
    }
    const sepax_tree_walk_options usual = {.design = &design};
    sepax_tree_run wanted = walked(&s, &usual);
    for (size_t k = 0; k < LENGTH(lines); k++) {
      const sepax_tree_walk_options how = {
          .design = &design, .line = lines[k], .stack = 15 * height + 16};
      sepax_tree_run run = walked(&s, &how);
      assert_true(run.deepest <= how.stack);
      assert_int_equal(run.near, wanted.near);
      assert_int_equal(run.steps, wanted.steps);
      assert_int_equal(run.collisions, wanted.collisions);
    }
    const sepax_tree_walk_options less = {.design = &design, .stack = 15 * height + 15};
    sepax_tree_run run;
    assert_fault(sepax_tree_walk(s.tree[0], s.tree[1], &s.pose, &less, &run, &fault), "a stack of");
    free_scene(&s);
  }
}

/* ------------------------------------------------------------------- meshes */

/* Two meshes on one grid, B in poses near that of the file. */
static size_t compare_meshes(const sepax_soup mesh[2], const sepax_grid *grid, size_t wanted,
                             const char *clearance, double away) {
  sepax_design design = design_of("--word=%d %s", grid->word, clearance);
  triangles t[2];
  sepax_tree *tree[2];
  size_t collisions = 0;
  for (int i = 0; i < 2; i++) {
    t[i] = (triangles){malloc(mesh[i].count * sizeof(sepax_tri)), mesh[i].count};
    assert_non_null(t[i].tri);
    assert_works(sepax_quantise(SEPAX_SOUP_MESH(&mesh[i]), grid, t[i].tri, &fault));
    assert_works(sepax_tree_new(&tree[i], t[i].tri, t[i].count, grid, &fault));
  }
  for (int n = 0; collisions < wanted && n < 100000; n++) {
    sepax_pose pose = posed(n % 2 == 0 ? 3 : 4, away);
    search s = {.a = &t[0], .b = &t[1], .tree_a = tree[0], .tree_b = tree[1], .design = &design};
    collisions += compare(&s, &pose);
  }
  for (int i = 0; i < 2; i++) {
    sepax_tree_free(tree[i]);
    free(t[i].tri);
  }
  return collisions;
}

CASE(sample_bodies) {
  static const char *const designs[] = {"", "--clearance=4", "--clearance=299"};
  size_t wanted = count_of_run("TREE_COLLISIONS", 50000) / 50;
  const double at[3] = {0, 0, 0};
  const double tip[3] = {34, 0, -15};
  const sepax_grid grid = {.resolution = 0.002, .word = 18};
  sepax_soup mesh[2];
  assert_works(sepax_sample(&mesh[0], "pocket", 2000, at, 0, &fault));
  assert_works(sepax_sample(&mesh[1], "ball-end", 2000, tip, 0, &fault));
  for (size_t k = 0; k < LENGTH(designs); k++) {
    compare_meshes(mesh, &grid, wanted, designs[k], 1);
  }
  sepax_soup_free(&mesh[0]);
  sepax_soup_free(&mesh[1]);
}

/* The mould, where it is at hand: faces of both halves lie in each other. */
CASE(real_bodies) {
  static const char *const files[2] = {"../shared/meshes/ktoolcav.stl",
                                       "../shared/meshes/ktoolcor.stl"};
  sepax_soup mesh[2];
  if (!sepax_stl_read(&mesh[0], files[0], false, &fault)) {
    skip();
  }
  assert_works(sepax_stl_read(&mesh[1], files[1], false, &fault));
  const sepax_mesh *const both[2] = {SEPAX_SOUP_MESH(&mesh[0]), SEPAX_SOUP_MESH(&mesh[1])};
  sepax_grid grid;
  assert_works(sepax_grid_fit(&grid, both, 2, 18, &fault));
  compare_meshes(mesh, &grid, count_of_run("TREE_COLLISIONS", 50000) / 5 * 2, "", 1e-3);
  sepax_soup_free(&mesh[0]);
  sepax_soup_free(&mesh[1]);
}
