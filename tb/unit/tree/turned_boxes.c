/* SPDX-License-Identifier: MIT */
/* turned_boxes.c - a turned box holds every vertex of the box that was turned, against 128-bit
 * integers. TREE_BOXES: how many boxes. */
#include "unit/tree/scenes.h"

#include "tree_engine/walk.h"

typedef struct {
  tree_node s, t;
  sepax_tree_pose pose;
  int word, side;
  int32_t margin;
} drawn_boxes;

static int32_t random_in(int32_t low, int32_t high) {
  return low + (int32_t)(((double)high - low + 1) * (random_unit() + 1) / 2 * 0.9999999);
}

/* Any rotation, some exact, some a little smaller than a rotation; B's origin near A's. */
static void draw_pose(drawn_boxes *d, double reach) {
  sepax_pose p = posed(random_below(5), reach);
  double scale = random_below(8) == 0 ? 1 - 0x1p-10 * fabs(random_unit()) : 1;
  for (int k = 0; k < 9; k++) {
    d->pose.side[0].matrix[k / 3][k % 3] = (int32_t)rint(scale * 0x1p20 * p.rotation[k / 3][k % 3]);
    double back = p.rotation[k % 3][k / 3] / scale;
    d->pose.side[1].matrix[k / 3][k % 3] = (int32_t)rint(fmax(-1, fmin(1, back)) * 0x1p20);
  }
  for (int i = 0; i < 3; i++) {
    d->pose.side[0].shift[i] = (int64_t)(p.translation[i] * 0x1p20) + (1 << 19);
    d->pose.side[0].sigma[i] = (uint32_t)d->margin << 10;
  }
  for (int i = 0; i < 3; i++) {
    wide sum = 0;
    for (int j = 0; j < 3; j++) {
      sum -= (wide)d->pose.side[1].matrix[i][j] * (d->pose.side[0].shift[j] - (1 << 19));
    }
    d->pose.side[1].shift[i] = (int64_t)(sum >> 20) + random_below(1 << 22) - (1 << 21);
  }
}

static void draw_node(tree_node *n, int word, int finest) {
  for (int i = 0; i < 3; i++) {
    int32_t most = sepax_word_max(word);
    n->origin[i] = random_in(-most / 2, most / 2);
    n->exponent[i] = finest + random_below(3);
  }
}

static void draw_cell_box(int8_t low[3], int8_t high[3]) {
  for (int i = 0; i < 3; i++) {
    int a = random_below(256) - 128;
    int b = random_below(4) == 0 ? random_below(256) - 128 : a + random_below(8);
    b = b > 127 ? 127 : b;
    low[i] = (int8_t)(a < b ? a : b);
    high[i] = (int8_t)(a < b ? b : a);
  }
}

/* A point of a box, often a corner, which is a point of the word, or false. */
static bool draw_point(sepax_vec *p, const tree_node *n, const int8_t low[3], const int8_t high[3],
                       int word) {
  for (int i = 0; i < 3; i++) {
    int64_t step = INT64_C(1) << n->exponent[i];
    int64_t from = n->origin[i] + low[i] * step;
    int64_t to = n->origin[i] + (high[i] + 1) * step - 1;
    int which = random_below(4);
    int64_t x = which == 0 ? from : which < 3 ? to : random_in((int32_t)from, (int32_t)to);
    if (x < sepax_word_min(word) || x > sepax_word_max(word)) {
      return false;
    }
    *coordinate(p, i) = (int32_t)x;
  }
  return true;
}

/* The cell of a point in a node, beyond all cells as -129 and 128. */
static int cell_of(const tree_node *n, int axis, int64_t x) {
  int64_t step = INT64_C(1) << n->exponent[axis];
  int64_t from = x - n->origin[axis];
  int64_t cell = from / step;
  cell = cell * step > from ? cell - 1 : cell;
  return cell < -129 ? -129 : cell > 128 ? 128 : (int)cell;
}

static void assert_holds(const drawn_boxes *d, const tree_cells *box, const int64_t p[3]) {
  for (int i = 0; i < 3; i++) {
    int cell = cell_of(&d->t, i, p[i]);
    if (cell < box->low[i] || cell > box->high[i]) {
      fail_msg("side %d, axis %d: cell %d is not in %d ... %d (margin %d)", d->side, i, cell,
               box->low[i], box->high[i], d->margin);
    }
  }
}

/* The origin of T to where the box is, so that not all is clamped. */
static void put_near(drawn_boxes *d, const int64_t p[3]) {
  for (int i = 0; i < 3; i++) {
    int64_t at = p[i] + ((random_below(400) - 200) * (INT64_C(1) << d->t.exponent[i]));
    int64_t most = sepax_word_max(d->word);
    d->t.origin[i] = (int32_t)(at < -most ? -most : at > most ? most : at);
  }
}

/* Side 0: a vertex of B in a box of S, turned, and points within the margin of it. */
static bool draw_side_0(drawn_boxes *d, int64_t held[3], int8_t low[3], int8_t high[3]) {
  sepax_vec p;
  if (!draw_point(&p, &d->s, low, high, d->word)) {
    return false;
  }
  turn_exactly(held, &d->pose.side[0], &p);
  for (int i = 0; i < 3; i++) {
    held[i] += random_in(-d->margin, d->margin);
  }
  return true;
}

/* Side 1: a vertex of A in a box of S is within the margin of a turned vertex of B, which is held.
 * So B's vertex comes first, and S is put round its turned place. */
static bool draw_side_1(drawn_boxes *d, int64_t held[3], const int8_t low[3],
                        const int8_t high[3]) {
  sepax_vec p;
  int64_t v[3];
  int32_t most = sepax_word_max(d->word);
  for (int i = 0; i < 3; i++) {
    *coordinate(&p, i) = random_in(-most, most);
    held[i] = *coordinate(&p, i);
  }
  turn_exactly(v, &d->pose.side[0], &p);
  for (int i = 0; i < 3; i++) {
    int64_t x = v[i] + (random_below(2) == 0   ? random_in(-d->margin, d->margin)
                        : random_below(2) == 0 ? d->margin
                                               : -d->margin);
    int64_t step = INT64_C(1) << d->s.exponent[i];
    int64_t in = random_below(2) == 0 ? low[i] * step : (high[i] + 1) * step - 1;
    if (x - in > most || x - in < -most) {
      return false;
    }
    d->s.origin[i] = (int32_t)(x - in);
  }
  return true;
}

CASE(boxes_hold_their_vertices) {
  static const int32_t margins[] = {0, 0, 5, 300};
  size_t wanted = count_of_run("TREE_BOXES", 1000000);
  size_t inside = 0;
  for (size_t n = 0; n < wanted;) {
    drawn_boxes d = {.word = 8 + random_below(14), .side = random_below(2)};
    d.margin = d.word > 12 ? margins[random_below(4)] : 0;
    int finest = random_below(d.word > 10 ? d.word - 8 : 2);
    draw_node(&d.s, d.word, finest);
    draw_node(&d.t, d.word, random_below(3) == 0 ? random_below(13) : finest);
    draw_pose(&d, 0.3 * sepax_word_max(d.word));
    assert_works(sepax_tree_pose_close(&d.pose, d.word, d.margin, &fault));
    for (int k = 0; k < 20; k++) {
      int8_t low[3];
      int8_t high[3];
      int64_t held[3];
      draw_cell_box(low, high);
      if (d.side == 0 ? draw_side_0(&d, held, low, high) : draw_side_1(&d, held, low, high)) {
        put_near(&d, held);
        tree_setting g = sepax__tree_set_up(&d.pose.side[d.side], &d.s, &d.t);
        tree_cells box = sepax__tree_turn_box(&g, low, high);
        assert_holds(&d, &box, held);
        inside += box.low[0] > -129 && box.high[0] < 128;
        n++;
      }
    }
  }
  assert_true(inside > wanted / 20);
}

/* Roundings of N that add up at a corner, seen in cells of T that are far smaller than S's: all of
 * the slack is needed, but for one unit. */
CASE(worst_roundings) {
  for (int n = 0; n < 100000; n++) {
    drawn_boxes d = {.word = 21, .side = 0};
    int e = 8 + random_below(6);
    bool low_end = random_below(2) == 0;
    int8_t low[3];
    int8_t high[3];
    int64_t held[3];
    sepax_vec p;
    for (int k = 0; k < 3; k++) {
      bool least = random_below(2) == 0; /* the corner */
      low[k] = least ? -128 : 126;
      high[k] = least ? -127 : 127;
      d.s.exponent[k] = e;
      d.s.origin[k] = random_in(-100000, 100000);
      d.t.exponent[k] = random_below(2);
      *coordinate(&p, k) = d.s.origin[k] + (least ? -128 : 128) * (1 << e) - (least ? 0 : 1);
      for (int i = 0; i < 3; i++) {
        bool up = low_end == least; /* N >= 0 has the corner at this end */
        int32_t whole = (up ? random_below(1000) : -2 - random_below(1000)) * 1024;
        d.pose.side[0].matrix[i][k] = whole + 512 - up;
      }
    }
    for (int i = 0; i < 3; i++) {
      d.pose.side[0].shift[i] = (INT64_C(1) << 40) * (random_below(3) - 1) + random_below(1 << 30);
      d.pose.side[0].sigma[i] = 0;
    }
    turn_exactly(held, &d.pose.side[0], &p);
    for (int i = 0; i < 3; i++) {
      d.t.origin[i] = (int32_t)held[i] + random_below(100) - 50;
    }
    tree_setting g = sepax__tree_set_up(&d.pose.side[0], &d.s, &d.t);
    tree_cells box = sepax__tree_turn_box(&g, low, high);
    assert_holds(&d, &box, held);
  }
}

/* Numbers that fit the widths of docs/reference/tree-engine.md, at the ends of all ranges. */
CASE(widths) {
  for (int n = 0; n < 200000; n++) {
    sepax_tree_side side;
    tree_node s = {0};
    tree_node t = {0};
    for (int i = 0; i < 3; i++) {
      for (int k = 0; k < 3; k++) {
        side.matrix[i][k] = (random_below(3) - 1) * (1 << 20) + random_below(3) - 1;
        side.matrix[i][k] = side.matrix[i][k] > 1 << 20 ? 1 << 20 : side.matrix[i][k];
        side.matrix[i][k] = side.matrix[i][k] < -(1 << 20) ? -(1 << 20) : side.matrix[i][k];
      }
      int64_t most = (INT64_C(1) << 43) - 1;
      side.shift[i] = random_below(2) == 0 ? most : -most - 1;
      side.shift[i] = random_below(2) == 0 ? random_below(1 << 30) : side.shift[i];
      side.sigma[i] = random_below(2) == 0 ? 0 : (1U << 24) - 1;
      s.origin[i] = random_below(2) == 0 ? -(1 << 20) : (1 << 20) - 1;
      t.origin[i] = random_below(2) == 0 ? -(1 << 20) : (1 << 20) - 1;
      s.exponent[i] = random_below(16);
      t.exponent[i] = random_below(16);
    }
    tree_setting g = sepax__tree_set_up(&side, &s, &t);
    for (int i = 0; i < 3; i++) {
      assert_true(g.low[i] >= -(1 << 20) && g.high[i] < 1 << 20);
      assert_true(g.shift[i] >= -5 && g.shift[i] <= 10);
      for (int k = 0; k < 3; k++) {
        assert_true(abs(g.n[i][k]) <= 1024);
      }
    }
    int8_t low[3] = {-128, -128, -128};
    int8_t high[3] = {127, 127, 127};
    tree_cells box = sepax__tree_turn_box(&g, low, high);
    for (int i = 0; i < 3; i++) {
      assert_true(box.low[i] >= -129 && box.low[i] <= box.high[i] && box.high[i] <= 128);
    }
  }
}

CASE(sixteen_boxes_at_once) {
  for (int n = 0; n < 100000; n++) {
    tree_node t = {.children = 1 + random_below(16)};
    for (int j = 0; j < TREE_FAN_OUT; j++) {
      draw_cell_box(t.low[j], t.high[j]);
    }
    tree_cells box;
    for (int i = 0; i < 3; i++) {
      box.low[i] = random_below(3) == 0 ? -129 + random_below(3) : random_below(258) - 129;
      box.high[i] = random_below(3) == 0 ? 128 - random_below(3) : random_below(258) - 129;
    }
    const tree_lanes lanes = tree_lanes_of(&t);
    assert_int_equal(tree_lanes_hits(&lanes, &box), sepax__tree_hits(&box, &t));
  }
}
