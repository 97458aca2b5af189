/* SPDX-License-Identifier: MIT */
/* objects.c - objects that show one thing each: of which all AABBs overlap, that are in one plane,
 * that meet in stretches or not at all, that leave the word. */
#include "bench.h"

#include <stdio.h>

/* Else what is away may be near enough. */
#ifdef SEPAX_BANDS
enum { EXACTLY = 0 };
#else
enum { EXACTLY = 1 };
#endif

/* The longest edge that both objects may have along an axis. */
#ifdef SEPAX_EXTENT_A
#define LONGEST ((int64_t)(SEPAX_EXTENT_A < SEPAX_EXTENT_B ? SEPAX_EXTENT_A : SEPAX_EXTENT_B))
#else
#define LONGEST (2 * (int64_t)sepax_word_max(SEPAX_WORD))
#endif

/* Triangles that all hold the middle of the space. */
static void draw_about_middle(sepax_tri *a, sepax_tri *b, size_t count_a, size_t count_b) {
  const int64_t low = -(LONGEST / 2);
  const int64_t high = LONGEST + low;
  for (size_t i = 0; i < count_a + count_b; i++) {
    sepax_tri *t = i < count_a ? &a[i] : &b[i - count_a];
    t->v[0] =
        (sepax_vec){(int32_t)-range(0, -low), (int32_t)-range(0, -low), (int32_t)-range(0, -low)};
    t->v[1] =
        (sepax_vec){(int32_t)range(0, high), (int32_t)range(0, high), (int32_t)range(0, high)};
    t->v[2] = (sepax_vec){(int32_t)range(low, high), (int32_t)range(low, high),
                          (int32_t)range(low, high)};
  }
}

/* A triangle that meets itself and nothing on the other side of the middle. */
static sepax_tri there(void) {
  return LONGEST > 1 ? (sepax_tri){{{-3, -1, -1}, {-1, 1, 0}, {-2, 0, 1}}}
                     : (sepax_tri){{{-2, -1, -1}, {-1, 0, -1}, {-1, 0, 0}}};
}

/* Every AABB overlaps every other. */
void overlap(sepax_tri *a, sepax_tri *b, size_t count_a, size_t count_b, bool paced) {
  draw_about_middle(a, b, count_a, count_b);
  const task t = {a, b, count_a, count_b, {0, 0, 0}, false};
  sepax_counts counts = run_task(&t, paced);
  expect("candidates where all AABBs overlap", counts.candidates,
         (unsigned long long)count_a * count_b);
  printf("all AABBs overlap: %zu x %zu triangles, %llu collisions in %llu cycles, %.4f a pair\n",
         count_a, count_b, (unsigned long long)counts.collisions, (unsigned long long)counts.cycles,
         (double)counts.cycles / (double)(count_a * count_b));
}

static int32_t *coordinate(sepax_vec *v, int axis) {
  return axis == 0 ? &v->x : axis == 1 ? &v->y : &v->z;
}

/* Lay a triangle into the plane across an axis; false: it is a line or a point. */
static bool lay(sepax_tri *t, int axis, int32_t height) {
  int64_t c[3][2];
  for (int i = 0; i < 3; i++) {
    *coordinate(&t->v[i], axis) = height;
    for (int k = 0; k < 2; k++) {
      c[i][k] = *coordinate(&t->v[i], (axis + 1 + k) % 3);
    }
  }
  return (c[1][0] - c[0][0]) * (c[2][1] - c[0][1]) != (c[1][1] - c[0][1]) * (c[2][0] - c[0][0]);
}

/* Every AABB overlaps every other, and all triangles are in one plane across x, across y, across z:
 * the time of a pass a pair. */
static void one_plane(sepax_tri *a, sepax_tri *b, size_t count, bool paced) {
  for (int axis = 0; axis < 3; axis++) {
    task t = {a, b, count, count, {0, 0, 0}, false};
    t.move[axis] = 1;
    draw_about_middle(a, b, count, count);
    for (size_t k = 0; k < count; k++) {
      while (!lay(&a[k], axis, 1)) {
        draw_about_middle(&a[k], b, 1, 0);
      }
      (void)lay(&b[k], axis, 0);
    }
    sepax_counts counts = run_task(&t, paced);
    expect("candidates in one plane", counts.candidates, count * count);
  }
}

/* Points, segments and triangles on grids of 1 ... 3 places an axis, anywhere in the word: all that
 * is coplanar, on a line, or touches. */
static void small_grids(sepax_tri *a, sepax_tri *b, size_t count, bool paced) {
  static const int most[5][2][3] = {{{1, 1, 1}, {1, 1, 1}}, /* places of A, of B, less one */
                                    {{2, 2, 2}, {2, 2, 2}},
                                    {{0, 2, 1}, {0, 2, 2}},
                                    {{0, 2, 0}, {0, 2, 2}},
                                    {{2, 0, 0}, {2, 0, 1}}};
  for (int n = 0; n < 5; n++) {
    int32_t low[3];
    for (int axis = 0; axis < 3; axis++) {
      low[axis] = (int32_t)range(sepax_word_min(SEPAX_WORD), sepax_word_max(SEPAX_WORD) - 2);
    }
    for (size_t k = 0; k < 6 * count; k++) {
      sepax_vec *v = k < 3 * count ? &a[k / 3].v[k % 3] : &b[k / 3 - count].v[k % 3];
      for (int axis = 0; axis < 3; axis++) {
        *coordinate(v, axis) = low[axis] + (int32_t)range(0, most[n][k >= 3 * count][axis]);
      }
    }
    const task t = {a, b, count, count, {0, 0, 0}, false};
    run_task(&t, paced);
  }
}

/* All in one plane along an axis, at an angle to the others: `thin`, that axis is A's longest side,
 * and a pass a pair is enough; else anywhere in the plane. */
static void slanted_planes(sepax_tri *a, sepax_tri *b, size_t count, bool paced) {
  for (int n = 0; n < 6; n++) {
    int axis = n % 3;
    bool thin = n < 3;
    const int32_t far = thin ? 1 : 4; /* extents are no less */
    for (size_t k = 0; k < 2 * count; k++) {
      sepax_tri *t = k < count ? &a[k] : &b[k - count];
      sepax_tri flat;
      do {
        for (int i = 0; i < 3; i++) {
          int32_t s = (int32_t)range(-far, far);
          int32_t along = (int32_t)range(i < 2 && thin ? 2 : -3, 3);
          *coordinate(&t->v[i], axis) = i == 0 && thin ? -along : along;
          *coordinate(&t->v[i], (axis + 1) % 3) = s;
          *coordinate(&t->v[i], (axis + 2) % 3) = s;
        }
        flat = *t;
      } while (thin && k < count && !lay(&flat, (axis + 1) % 3, 0));
    }
    const task t = {a, b, count, count, {0, 0, 0}, false};
    run_task(&t, paced);
  }
}

/* Stretches of B of which A meets all, and none: queues fill, and run empty behind the last step.
 */
static void bursts(sepax_tri *a, sepax_tri *b, bool paced) {
  static const sepax_tri away = {{{2, 1, -1}, {4, -1, 0}, {3, 0, 1}}};
  size_t most = device.capacity[1] < 256 ? device.capacity[1] : 256;
  for (int n = 0; n < 8; n++) {
    task t = {a, b, n < 3 ? 1 : (size_t)range(2, 2 * SEPAX_LANES + 2), most, {0, 0, 0}, false};
    t.count_a = t.count_a < device.capacity[0] ? t.count_a : device.capacity[0];
    size_t stretch = (size_t)range(20, 60);
    for (size_t i = 0; i < t.count_a; i++) {
      a[i] = there();
    }
    for (size_t j = 0; j < t.count_b; j++) {
      bool meets = n == 0 ? j + 1 == t.count_b : n == 1 ? j < stretch : j / stretch % 2 == 0;
      b[j] = meets ? there() : away;
    }
    run_task(&t, paced);
  }
}

/* Objects of 1, 2, 4 ... triangles, and one less, without a candidate: the time of the lanes. */
static void stay_away(sepax_tri *a, sepax_tri *b, bool paced) {
  const int32_t high = sepax_word_max(SEPAX_WORD);
  const int32_t low = sepax_word_min(SEPAX_WORD);
  for (size_t i = 0; i < device.capacity[0]; i++) {
    a[i] = (sepax_tri){{{low, 0, 0}, {low + 1, 1, 0}, {low + 1, 0, 1}}};
  }
  for (size_t j = 0; j < device.capacity[1]; j++) {
    b[j] = (sepax_tri){{{high, 0, 0}, {high - 1, 1, 0}, {high - 1, 0, 1}}};
  }
  for (int of_b = 0; of_b < 2; of_b++) {
    for (size_t power = 2; power <= device.capacity[of_b]; power *= 2) {
      for (size_t count = power - 1; count <= power; count++) {
        size_t other = 1 + (size_t)range(0, 2 * SEPAX_LANES);
        task t = {a, b, count, other < device.capacity[1] ? other : 1, {0, 0, 0}, false};
        if (of_b) {
          t.count_b = count;
          t.count_a = other < device.capacity[0] ? other : 1;
        }
        uint64_t candidates = run_task(&t, paced).candidates;
        expect("candidates of objects that do not meet", EXACTLY ? candidates : 0, 0);
      }
    }
  }
}

/* One triangle of A and one of B meet, in each place whose number is a power of 2, or one less: the
 * numbers of the first collision. */
static void one_pair(sepax_tri *a, sepax_tri *b, bool paced) {
  const int32_t high = sepax_word_max(SEPAX_WORD);
  const int32_t low = sepax_word_min(SEPAX_WORD);
  const sepax_tri away[2] = {{{{low, 0, 0}, {low + 1, 1, 0}, {low + 1, 0, 1}}},
                             {{{high, 0, 0}, {high - 1, 1, 0}, {high - 1, 0, 1}}}};
  sepax_tri *object[2] = {a, b};
  for (int which = 0; which < 2; which++) {
    for (size_t power = 1; power <= device.capacity[which]; power *= 2) {
      for (size_t at = power - 1; at <= power && at < device.capacity[which]; at++) {
        size_t count[2] = {1, 1};
        count[which] = at + 1;
        for (size_t k = 0; k <= at; k++) {
          object[which][k] = away[which];
        }
        a[count[0] - 1] = b[count[1] - 1] = there();
        const task t = {a, b, count[0], count[1], {0, 0, 0}, false};
        uint64_t collisions = run_task(&t, paced).collisions;
        expect("one pair that collides", EXACTLY ? collisions : 1, 1);
      }
    }
  }
}

/* 1, 2, 4 ... triangles of B leave the word, and one of A overlaps them all; then all do. */
static void leave_the_word(sepax_tri *a, sepax_tri *b, size_t size, bool paced) {
  const int32_t high = sepax_word_max(SEPAX_WORD);
  for (size_t i = 0; i < device.capacity[0] || i < device.capacity[1]; i++) {
    const sepax_tri tri = {{{high, 0, 0}, {high - 1, 1, 0}, {high - 1, 0, 1}}};
    if (i < device.capacity[0]) {
      a[i] = tri;
    }
    if (i < device.capacity[1]) {
      b[i] = tri;
    }
  }
  for (size_t count = 1; count <= device.capacity[1] && count <= 256; count *= 2) {
    const task t = {a, b, 1, count, {1, 0, 0}, false};
    expect("triangles that leave the word", run_task(&t, paced).out_of_range, count);
  }
  const task t = {a, b, size, size, {1, 0, 0}, false};
  expect("pairs that leave the word", run_task(&t, paced).out_of_range, size * size);
}

void objects(sepax_tri *a, sepax_tri *b, size_t size, bool paced) {
  one_plane(a, b, size, paced);
  size_t some = size < 30 || size > 100 ? size : 30;
  small_grids(a, b, some, paced);
  slanted_planes(a, b, some, paced);
  bursts(a, b, paced);
  stay_away(a, b, paced);
  one_pair(a, b, paced);
  leave_the_word(a, b, size, paced);
}
