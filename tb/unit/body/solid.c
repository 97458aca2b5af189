/* SPDX-License-Identifier: MIT */
/* solid.c - closed bodies at random, as solids, against rational numbers and rays of random
 * direction. */
#include "solid_meshes.h"
#include "solid_oracle.h"
#include "unit/body/draws.h"

/* Nested closed parts, each given to one of the meshes; the numbers stay short, so that rays along
 * axes meet vertices and edges. */
static void add_nest(sepax_soup m[2], const double c[3], double r, int depth) {
  for (; depth > 0; depth--) {
    sepax_soup *to = &m[random_below(2)];
    int kind = random_below(5);
    if (kind < 2) {
      add_box(to, c, r, 1 + random_below(2));
      r /= kind == 0 ? 2 : 8;
    } else if (kind == 2) {
      add_octahedron(to, c, r);
      r /= 4;
    } else {
      add_torus(to, c, r / 2, r / 4);
      if (kind == 3) {
        r /= 8; /* in its hole */
      } else {
        double inside[3] = {c[0] - r / 2, c[1], c[2]};
        add_nest(m, inside, r / 32, depth - 1);
        return;
      }
    }
  }
}

static void draw_meshes(sepax_soup m[2]) {
  do {
    sepax_soup_free(&m[0]);
    sepax_soup_free(&m[1]);
    for (int nests = 1 + random_below(2); nests > 0; nests--) {
      const double c[3] = {3 * nests, random_below(2), random_below(2)};
      add_nest(m, c, 1, 2 + random_below(4));
    }
  } while (m[0].count == 0 || m[1].count == 0);
  for (int k = 0; k < 2; k++) {
    for (int times = random_below(3); times > 0; times--) {
      split_edge(&m[k]);
    }
  }
}

/* ------------------------------------------------------------------------- poses */

static void move(double v[3], const sepax_pose *p) {
  double moved[3];
  for (int i = 0; i < 3; i++) {
    moved[i] = p->rotation[i][0] * v[0] + p->rotation[i][1] * v[1] + p->rotation[i][2] * v[2] +
               p->translation[i];
  }
  memcpy(v, moved, sizeof moved);
}

/* Into its file, with rounding. */
static void move_mesh(sepax_soup *m, const sepax_pose *p) {
  for (size_t k = 0; m->facet != NULL && k < 3 * m->count; k++) {
    move(m->facet[k / 3].v[k % 3], p);
  }
}

static bool collide(sepax_body *body[2], const sepax_pose *pa, const sepax_pose *pb) {
  sepax_query query = {.size = sizeof(sepax_query), .only_any = true};
  sepax_pairs found;
  assert_works(sepax_bodies_collide(body[0], pa, body[1], pb, &query, &found, &fault));
  return found.count > 0;
}

/* ------------------------------------------------------------------------- cases */

typedef struct {
  size_t free, within[2], colliding, unknown;
} tally;

/* Of triangles whose coordinates have few digits. */
static bool is_flat(const double v[3][3]) {
  bool flat = true;
  for (int i = 0; i < 3; i++) {
    const int j = (i + 1) % 3;
    const double left = (v[1][i] - v[0][i]) * (v[2][j] - v[0][j]);
    const double right = (v[1][j] - v[0][j]) * (v[2][i] - v[0][i]);
    flat = flat && !(left < right) && !(left > right);
  }
  return flat;
}

/* A triangle without area opens and turns nothing. */
static void assert_shell(const sepax_shell *shell, const oracle_shell *o, const sepax_soup *m) {
  assert_int_equal(shell->closed, o->closed);
  assert_true(!shell->closed || shell->consistent == o->consistent);
  assert_int_equal(shell->parts, o->parts);
  assert_int_equal(shell->pieces, o->pieces);
  if (!shell->closed || !shell->consistent) {
    int count = 0;
    int turns = 0;
    bool named = false;
    for (size_t k = 0; k < 3 * m->count && m->facet != NULL; k++) {
      const double(*u)[3] = m->facet[k / 3].v;
      int way =
          is_flat(u) ? 0 : same_edge(shell->edge[0], shell->edge[1], u[k % 3], u[(k + 1) % 3]);
      count += way != 0;
      turns += way;
      named = named || (way != 0 && k / 3 == shell->facet);
    }
    assert_true(named);
    assert_true(count % 2 != 0 || (shell->closed && turns != 0));
  }
}

static void assert_within(const sepax_soup m[2], const sepax_pose *pa, const sepax_pose *pb,
                          tally *seen) {
  sepax_body *body[2];
  sepax_shell shell[2];
  oracle_shell expected[2];
  for (int k = 0; k < 2; k++) {
    assert_works(sepax_body_new(&body[k], SEPAX_SOUP_MESH(&m[k]), NULL, &fault));
    assert_works(sepax_shell_find(&shell[k], body[k], &fault));
    find_oracle_shell(&expected[k], &m[k]);
    assert_shell(&shell[k], &expected[k], &m[k]);
  }
  if (collide(body, pa, pb)) {
    seen->colliding++;
  } else {
    sepax_inside within[2];
    assert_works(sepax_bodies_within(&shell[0], pa, &shell[1], pb, within, &fault));
    space s;
    place(&s, m, (const sepax_pose *const[]){pa, pb});
    for (int i = 0; i < 2; i++) {
      oracle_answer expected_answer = oracle_within(&s, i, &expected[!i]);
      if (!expected[!i].closed) {
        assert_may_be_within(within[i], &m[i], i == 0 ? pa : pb, &m[!i], i == 0 ? pb : pa,
                             &expected[!i], expected_answer);
      } else {
        assert_answer(within[i], expected_answer);
      }
      seen->unknown += within[i] == SEPAX_INSIDE_UNKNOWN;
    }
    leave(&s);
    seen->within[0] += within[0] == SEPAX_INSIDE;
    seen->within[1] += within[1] == SEPAX_INSIDE;
    seen->free += within[0] == SEPAX_OUTSIDE && within[1] == SEPAX_OUTSIDE;
  }
  for (int k = 0; k < 2; k++) {
    sepax_shell_free(&shell[k]);
    sepax_body_free(body[k]);
    free_oracle_shell(&expected[k]);
  }
}

CASE(nested) {
  tally seen = {0};
  sepax_soup m[2] = {{0}};
  for (int n = 0; n < FEWER(40); n++) {
    draw_meshes(m);
    if (n % 3 == 0) { /* any triangle may be turned round */
      for (size_t k = 0; k < m[0].count; k++) {
        if (random_below(2) == 0) {
          turn_round(&m[0].facet[k]);
        }
      }
    }
    double size = n % 2 == 0 ? 1 : 0.1;
    for (int k = 0; k < 2; k++) {
      for (size_t i = 0; i < 9 * m[k].count; i++) {
        m[k].facet[i / 9].v[i / 3 % 3][i % 3] *= size;
      }
    }
    sepax_pose p = turned_and_moved(100);
    sepax_pose q = p;
    assert_within(m, NULL, NULL, &seen);
    assert_within(m, &p, &q, &seen);
    for (int i = 0; i < 3; i++) {
      q.translation[i] += size * 0.01 * random_unit();
    }
    assert_within(m, &p, &q, &seen);
    sepax_pose away = turned_and_moved(0.01);
    assert_within(m, n % 2 == 0 ? NULL : &p, n % 2 == 0 ? &away : NULL, &seen);
  }
  sepax_soup_free(&m[0]);
  sepax_soup_free(&m[1]);
  print_message("%zu free, %zu %zu within, %zu colliding\n", seen.free, seen.within[0],
                seen.within[1], seen.colliding);
  assert_true(seen.free > FEWER(20) && seen.within[0] > FEWER(20) && seen.within[1] > FEWER(20));
}

/* Edges divided on one side only, again and again: closed as they are while nothing is rounded.
 * Some have a triangle turned round, some one less or one that is a segment; some are rounded. */
CASE(vertices_on_edges) {
  tally seen = {0};
  size_t closed[2] = {0};
  for (int n = 0; n < FEWER(150); n++) {
    sepax_soup m[2] = {{0}};
    const double c[3] = {1, 1, 1};
    const double small[3] = {1.25, 0.75, 1.125};
    if (n % 3 == 0) {
      add_octahedron(&m[1], c, 4);
    } else {
      add_box(&m[1], c, 2, n % 3);
    }
    for (int times = 1 + random_below(12); times > 0; times--) {
      tear_edge(&m[1]);
    }
    switch (random_below(5)) {
    case 0:
      turn_round(&m[1].facet[random_below((int)m[1].count)]);
      break;
    case 1:
      m[1].count--;
      break;
    case 2:
      add_segment(&m[1]);
      break;
    default:
      break;
    }
    add_octahedron(&m[0], small, n % 7 == 0 ? 4 : 0.5);
    sepax_pose p = turned_and_moved(10);
    if (n % 6 == 5) {
      move_mesh(&m[0], &p);
      move_mesh(&m[1], &p);
    }
    sepax_body *body;
    sepax_shell shell;
    assert_works(sepax_body_new(&body, SEPAX_SOUP_MESH(&m[1]), NULL, &fault));
    assert_works(sepax_shell_find(&shell, body, &fault));
    closed[shell.closed]++;
    sepax_shell_free(&shell);
    sepax_body_free(body);
    assert_within(m, NULL, NULL, &seen);
    assert_within(m, &p, &p, &seen);
    sepax_soup_free(&m[0]);
    sepax_soup_free(&m[1]);
  }
  print_message("%zu closed, %zu open; %zu free, %zu within\n", closed[1], closed[0], seen.free,
                seen.within[0]);
  assert_true(closed[1] > FEWER(70) && closed[0] > FEWER(25) && seen.within[0] > FEWER(90));
}

/* Boxes that overlap at random, some inside out, on a lattice, so that they touch in faces and
 * edges, too; a small body somewhere. */
CASE(overlapping) {
  tally seen = {0};
  for (int n = 0; n < FEWER(600); n++) {
    sepax_soup m[2] = {{0}};
    for (int boxes = 1 + random_below(4); boxes > 0; boxes--) {
      double low[3];
      double high[3];
      for (int i = 0; i < 3; i++) {
        low[i] = random_below(3);
        high[i] = low[i] + 2 + random_below(3);
      }
      add_block(&m[1], low, high, random_below(3) == 0);
    }
    for (int tools = 1 + random_below(2); tools > 0; tools--) {
      const double c[3] = {random_below(5) + 0.5, random_below(5) + 0.5, random_below(5) + 0.5};
      add_octahedron(&m[0], c, 0.25);
    }
    if (n % 8 == 0) {
      m[1].count--; /* open */
    }
    sepax_pose p = turned_and_moved(10);
    sepax_pose q = p;
    if (n % 3 == 0) { /* what touched may touch, overlap or be free now */
      move_mesh(&m[0], &p);
      move_mesh(&m[1], &p);
    }
    assert_within(m, NULL, NULL, &seen);
    assert_within(m, &p, &q, &seen);
    sepax_soup_free(&m[0]);
    sepax_soup_free(&m[1]);
  }
  print_message("%zu free, %zu %zu within, %zu colliding, %zu unknown\n", seen.free, seen.within[0],
                seen.within[1], seen.colliding, seen.unknown);
  assert_true(seen.free > FEWER(250) && seen.within[0] > FEWER(200) && seen.unknown > FEWER(6));
}

/* A vertex in the middle of an edge, exactly: in doubles, on either side of its triangles. */
CASE(vertex_on_an_edge) {
  const double far[3] = {9, 9, 9};
  tally seen = {0};
  for (int n = 0; n < FEWER(200); n++) {
    sepax_soup m[2] = {{0}};
    double p[4][3];
    double t[3][3];
    for (int i = 0; i < 3; i++) {
      for (int k = 0; k < 4; k++) {
        p[k][i] = (float)random_unit(); /* so that the middle is a double */
      }
      t[0][i] = p[0][i] / 2 + p[1][i] / 2;
      t[1][i] = t[0][i] + (t[0][i] - p[2][i] / 2 - p[3][i] / 2) + 0.1 * random_unit();
      t[2][i] = t[0][i] + (t[0][i] - p[2][i] / 2 - p[3][i] / 2) + 0.1 * random_unit();
    }
    for (int k = 0; k < 4; k++) {
      add_triangle(&m[1], p[k], p[(k + 1) % 4], p[(k + 2) % 4]);
    }
    add_triangle(&m[1], t[0], t[1], t[2]);
    add_triangle(&m[1], t[0], t[2], t[1]);
    add_octahedron(&m[0], far, 1);
    assert_within(m, NULL, NULL, &seen);
    sepax_soup_free(&m[0]);
    sepax_soup_free(&m[1]);
  }
}

/* The smallest and the largest bodies, far from the origin and in poses with any numbers. */
CASE(extremes) {
  static const int exponents[] = {-1070, -700, -330, 0, 340, 700, 990};
  tally seen = {0};
  for (size_t n = 0; n < 4 * LENGTH(exponents); n++) {
    double size = ldexp(1, exponents[n / 4]);
    double low[3];
    double high[3];
    double c[3];
    sepax_soup m[2] = {{0}};
    for (int i = 0; i < 3; i++) {
      c[i] = size * (1 + random_below(5));
      low[i] = 0;
      high[i] = 6 * size;
    }
    add_block(&m[1], low, high, false);
    add_octahedron(&m[0], c, n % 2 == 0 ? size : size / 2);
    sepax_pose far = turned_and_moved(0x1.fp1023);
    sepax_pose same = far;
    sepax_pose p = {{{1, -0x1p-1000, 0x1p-1074}, {0x1p-1000, 1, 0}, {0, 0, 1}},
                    {size * random_unit(), size * random_unit(), size * random_unit()}};
    assert_within(m, NULL, NULL, &seen);
    assert_within(m, NULL, &p, &seen);
    assert_within(m, &p, NULL, &seen);
    assert_within(m, &far, &same, &seen);
    assert_within(m, &far, NULL, &seen);
    sepax_soup_free(&m[0]);
    sepax_soup_free(&m[1]);
  }
  assert_true(seen.within[0] > 20 && seen.free > 5);
}

/* Points as near to a face, an edge or a vertex of a tilted solid as doubles can be; then in poses
 * of their own, far off, in which they are as near. */
CASE(near_the_surface) {
  tally seen = {0};
  const double c[3] = {0.1, 0.2, 0.3};
  for (int n = 0; n < FEWER(400); n++) {
    sepax_soup m[2] = {{0}};
    sepax_pose tilt = turned_and_moved(1);
    if (n % 2 == 0) {
      add_box(&m[1], c, 1, 1);
    } else {
      add_octahedron(&m[1], c, 1);
    }
    if (n % 3 != 0) {
      move_mesh(&m[1], &tilt);
    }
    const double(*t)[3] = m[1].facet[random_below((int)m[1].count)].v;
    double share = n % 5 == 0 ? 0 : 0.5 + random_unit() / 2;
    double rest = n % 7 == 0 ? 0 : 0.5 + random_unit() / 2;
    double p[3];
    for (int i = 0; i < 3; i++) {
      p[i] = share * t[0][i] + (1 - share) * (rest * t[1][i] + (1 - rest) * t[2][i]);
    }
    add_triangle(&m[0], p, p, p);
    assert_within(m, NULL, NULL, &seen);
    sepax_pose pose = turned_and_moved(100);
    sepax_pose back;
    for (int i = 0; i < 3; i++) {
      back.translation[i] = 0;
      for (int k = 0; k < 3; k++) {
        back.rotation[i][k] = pose.rotation[k][i];
        back.translation[i] -= pose.rotation[k][i] * pose.translation[k];
      }
    }
    for (int k = 0; k < 3; k++) {
      move(m[0].facet[0].v[k], &back);
    }
    memcpy(m[0].facet[0].v[1], m[0].facet[0].v[0], sizeof p);
    memcpy(m[0].facet[0].v[2], m[0].facet[0].v[0], sizeof p);
    assert_within(m, &pose, NULL, &seen);
    sepax_soup_free(&m[0]);
    sepax_soup_free(&m[1]);
  }
  assert_true(seen.within[0] > FEWER(200) && seen.free > FEWER(200));
}
