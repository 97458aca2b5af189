/* SPDX-License-Identifier: MIT */
#include "kinds.h"

#include "faults.h"
#include "lines.h"

#include <string.h>

enum { UNIT = 12 }; /* of the small grid that corners are drawn on, so that edges can be divided */

static point grid_point(generator *g, int64_t size) {
  point p;
  for (int i = 0; i < 3; i++) {
    p.x[i] = UNIT * draw(g, 0, size);
  }
  return p;
}

static void grid_box(generator *g, int64_t size, point *low, point *high) {
  for (int i = 0; i < 3; i++) {
    low->x[i] = draw(g, 0, size - 1);
    high->x[i] = UNIT * draw(g, low->x[i] + 1, size);
    low->x[i] *= UNIT;
  }
}

static void any_simplex(generator *g, int64_t size, point p[4]) {
  for (int k = 0; k < 4; k++) {
    p[k] = grid_point(g, size);
  }
}

/* One more solid of the union: what was added to `proof` since the last one. */
static void end_solid(body *b) { b->first[++b->solids] = b->proof.count; }

static void add_solid_box(body *b, point low, point high, generator *g) {
  add_box(&b->s, low, high, false, g);
  add_box(&b->proof, low, high, false, g);
  end_solid(b);
}

static void add_solid(body *b, int64_t size, generator *g) {
  point p[4];
  if (one_in(g, 2)) {
    grid_box(g, size, &p[0], &p[1]);
    add_solid_box(b, p[0], p[1], g);
    return;
  }
  any_simplex(g, size, p);
  if (add_tetrahedron(&b->s, p, false)) {
    add_tetrahedron(&b->proof, p, false);
    end_solid(b);
  }
}

/* A union of tetrahedra and boxes; on a small grid faces are flush and edges lie on each other. */
static void draw_union(body *b, generator *g) {
  int64_t size = draw(g, 1, 6);
  for (int64_t n = draw(g, 1, 6); n > 0; n--) {
    add_solid(b, size, g);
  }
}

static void draw_outward(body *b, generator *g) {
  draw_union(b, g);
  if (one_in(g, 2)) {
    divide_some(&b->s, 6, g);
  }
}

static void draw_turned(body *b, generator *g) {
  draw_union(b, g);
  turn_some(&b->s, g);
}

/* Copies of solids: exact, mirrored, with other diagonals, of some faces only. */
static void draw_copies(body *b, generator *g) {
  int64_t size = draw(g, 1, 4);
  for (int64_t n = draw(g, 1, 3); n > 0; n--) {
    point low;
    point high;
    grid_box(g, size, &low, &high);
    int64_t copies = draw(g, 1, 3);
    for (int64_t copy = 0; copy < copies; copy++) {
      add_box(&b->s, low, high, one_in(g, 2), g);
    }
    for (int64_t faces = draw(g, 0, 2); faces > 0; faces--) {
      point c[4];
      box_face(low, high, (int)draw(g, 0, 5), c);
      add_face(&b->s, c, g);
    }
  }
  copy_some(&b->s, g);
}

/* Edges divided on one side only, in rows of several. */
static void draw_rows(body *b, generator *g) {
  draw_union(b, g);
  for (int64_t n = draw(g, 1, 5); n > 0 && b->s.count > 0; n--) {
    divide_row(&b->s, (size_t)draw(g, 0, (int64_t)b->s.count - 1), (int)draw(g, 0, 2),
               (int)draw(g, 2, 4));
  }
  if (one_in(g, 2)) {
    turn_some(&b->s, g);
  }
}

/* Boxes in boxes; some touch the next by a face, an edge or a vertex. */
static void draw_nested(body *b, generator *g) {
  point low = {{0, 0, 0}};
  point high = {{12 * UNIT, 12 * UNIT, 12 * UNIT}};
  bool alternate = one_in(g, 2);
  bool may_touch = one_in(g, 2);
  int64_t depth = draw(g, 1, 5);
  for (int64_t n = 0; n < depth; n++) {
    add_box(&b->s, low, high, alternate ? n % 2 != 0 : one_in(g, 2), g);
    for (int i = 0; i < 3; i++) {
      low.x[i] += may_touch && one_in(g, 6) ? 0 : UNIT;
      high.x[i] -= may_touch && one_in(g, 6) ? 0 : UNIT;
    }
  }
  for (int64_t n = draw(g, 0, 2); n > 0; n--) { /* tetrahedra in the last box; they may overlap */
    point p[4];
    for (int k = 0; k < 4; k++) {
      for (int i = 0; i < 3; i++) {
        int64_t rim = may_touch ? 0 : 1;
        p[k].x[i] = UNIT * draw(g, low.x[i] / UNIT + rim, high.x[i] / UNIT - rim);
      }
    }
    add_tetrahedron(&b->s, p, alternate ? depth % 2 != 0 : one_in(g, 2));
  }
  if (one_in(g, 4)) {
    turn_some(&b->s, g);
  }
}

/* A face from one side, or from both. */
static void add_plate(soup *s, const point c[4], generator *g) {
  int64_t sides = draw(g, 0, 3);
  if (sides != 1) {
    add_face(s, c, g);
  }
  if (sides != 0) {
    const point back[4] = {c[3], c[2], c[1], c[0]};
    add_face(s, back, g);
  }
}

/* A room with plates as walls, which are divided each in its own way. */
static void draw_walls(body *b, generator *g) {
  for (int64_t rooms = draw(g, 1, 2); rooms > 0; rooms--) {
    point low;
    point high;
    grid_box(g, 3, &low, &high);
    bool two_sided = one_in(g, 2);
    for (int face = 0; face < 6; face++) {
      point c[4];
      box_face(low, high, face, c);
      const point back[4] = {c[3], c[2], c[1], c[0]};
      if (two_sided) {
        add_face(&b->s, c, g);
        add_face(&b->s, back, g);
      } else if (one_in(g, 5)) {
        add_plate(&b->s, c, g);
      } else {
        add_face(&b->s, one_in(g, 8) ? back : c, g);
      }
    }
  }
  if (one_in(g, 4)) {
    turn_some(&b->s, g);
  }
}

/* Fins on the edges of solids: triangles and faces, of one side or two, or thin solids. */
static void draw_fins(body *b, generator *g) {
  draw_union(b, g);
  size_t solid = b->s.count;
  for (int64_t n = draw(g, 1, 4); n > 0 && solid > 0; n--) {
    const triangle t = b->s.t[draw(g, 0, (int64_t)solid - 1)];
    point p[4] = {t.v[0], t.v[1], grid_point(g, 6), grid_point(g, 6)};
    switch (draw(g, 0, 3)) {
    case 0:
      add(&b->s, p[0], p[1], p[2]);
      break;
    case 1:
      add(&b->s, p[0], p[1], p[2]);
      add(&b->s, p[0], p[2], p[1]);
      break;
    case 2:
      add_simplex(&b->s, p, one_in(g, 2));
      break;
    default:
      p[3] = plus(p[2], minus(p[1], p[0]));
      add_plate(&b->s, (const point[4]){p[0], p[1], p[3], p[2]}, g);
    }
  }
  if (one_in(g, 3)) {
    turn_some(&b->s, g);
  }
}

/* ------------------------------------------------------------------- cells */

enum { CELLS = 3 }; /* on each axis */
typedef struct {
  int64_t plane[3][CELLS + 1];
  int group[CELLS + 2][CELLS + 2][CELLS + 2]; /* 0: empty; the rim is */
} cells;

static void draw_cells_of(cells *c, body *b, generator *g) {
  *c = (cells){{{0}}, {{{0}}}};
  int64_t filled = draw(g, 2, 8);
  int64_t groups = one_in(g, 2) ? 1 : draw(g, 1, 4);
  for (int i = 0; i < 3; i++) {
    for (int k = 0; k < CELLS; k++) {
      c->plane[i][k + 1] = c->plane[i][k] + UNIT * draw(g, 1, 2);
    }
  }
  for (int n = 0; n < CELLS * CELLS * CELLS; n++) {
    int x = n % CELLS;
    int y = n / CELLS % CELLS;
    int z = n / CELLS / CELLS;
    if (draw(g, 1, 9) <= filled) {
      c->group[x + 1][y + 1][z + 1] = (int)draw(g, 1, groups);
      point low = {{c->plane[0][x], c->plane[1][y], c->plane[2][z]}};
      point high = {{c->plane[0][x + 1], c->plane[1][y + 1], c->plane[2][z + 1]}};
      add_box(&b->proof, low, high, false, g);
      end_solid(b);
    }
  }
}

/* The way in which group `which` has a face below cell `at` on axis `i`: 1 upwards, -1 downwards,
 * 0 none. */
static int way_of(const cells *c, int which, int i, const int at[3]) {
  int below[3] = {at[0], at[1], at[2]};
  below[i]--;
  bool here = c->group[at[0] + 1][at[1] + 1][at[2] + 1] == which;
  bool there = c->group[below[0] + 1][below[1] + 1][below[2] + 1] == which;
  return (int)there - (int)here;
}

static void add_cell_face(body *b, const cells *c, int i, const int at[3], int length, int way,
                          generator *g) {
  int j = (i + 1) % 3;
  int k = (i + 2) % 3;
  point v[4];
  for (int n = 0; n < 4; n++) {
    v[n].x[i] = c->plane[i][at[i]];
    v[n].x[j] = c->plane[j][n == 1 || n == 2 ? at[j] + length : at[j]];
    v[n].x[k] = c->plane[k][n >= 2 ? at[k] + 1 : at[k]];
  }
  const point back[4] = {v[3], v[2], v[1], v[0]};
  add_face(&b->s, way > 0 ? v : back, g);
}

/* The faces of a group on one axis. Some that are in a row are one face. */
static void add_group(body *b, const cells *c, int which, int i, bool merge, generator *g) {
  int j = (i + 1) % 3;
  int k = (i + 2) % 3;
  int at[3];
  for (at[i] = 0; at[i] <= CELLS; at[i]++) {
    for (at[k] = 0; at[k] < CELLS; at[k]++) {
      for (int first = 0, next; first < CELLS; first = next) {
        at[j] = first;
        int way = way_of(c, which, i, at);
        for (next = first + 1; next < CELLS && merge && one_in(g, 2); next++) {
          at[j] = next;
          if (way_of(c, which, i, at) != way) {
            break;
          }
        }
        at[j] = first;
        if (way != 0) {
          add_cell_face(b, c, i, at, next - first, way, g);
        }
      }
    }
  }
}

static void draw_cells(body *b, generator *g) {
  cells c;
  draw_cells_of(&c, b, g);
  bool merge = one_in(g, 2);
  for (int which = 1; which <= 4; which++) {
    for (int i = 0; i < 3; i++) {
      add_group(b, &c, which, i, merge, g);
    }
  }
}

static void draw_bad_cells(body *b, generator *g) {
  draw_cells(b, g);
  spoil(&b->s, g);
}

/* -------------------------------------------------------- many edges on one line */

/* Triangles from the points of a line to an apex: from point `from` to `to`, with some or none of
 * the points between them. */
static void add_fan(soup *s, const point *on, int64_t from, int64_t to, point apex, bool turned,
                    generator *g) {
  int64_t chance = draw(g, 1, 4);
  int64_t last = from;
  for (int64_t next = from + 1; next <= to; next++) {
    if (next == to || draw(g, 1, 4) > chance) {
      add(s, on[turned ? next : last], on[turned ? last : next], apex);
      last = next;
    }
  }
}

/* Simplices that have an edge on one line. Each of their two faces there is one triangle, or a fan
 * to some points of the line. So long and short edges share vertices, and many have one triangle.
 */
static void draw_staggered(body *b, generator *g) {
  static const point ways[3] = {{{1, 0, 0}}, {{1, 1, 0}}, {{1, 2, 1}}};
  point way = ways[draw(g, 0, 2)];
  point off[4];
  point on[6];
  for (int k = 0; k < 4; k++) {
    off[k] = grid_point(g, 3);
  }
  for (int k = 0; k < 6; k++) {
    on[k] = times(way, UNIT * k);
  }
  int64_t vertices = draw(g, 3, 6);
  for (int64_t n = draw(g, 1, 5); n > 0; n--) {
    int64_t from = draw(g, 0, vertices - 2);
    int64_t to = draw(g, from + 1, vertices - 1);
    int64_t first = draw(g, 0, 3);
    point p = off[first];
    point q = off[(first + draw(g, 1, 3)) % 4];
    bool turned = one_in(g, 2);
    add_fan(&b->s, on, from, to, p, turned, g);
    add_fan(&b->s, on, from, to, q, !turned, g);
    add(&b->s, on[from], turned ? q : p, turned ? p : q);
    add(&b->s, on[to], turned ? p : q, turned ? q : p);
  }
  if (one_in(g, 3)) {
    cancel(&b->s, one_in(g, 3));
  }
  if (one_in(g, 2)) {
    turn_some(&b->s, g);
  }
}

/* Tetrahedra that overlap and have edges on one line. Each face there is divided at few points of
 * the line, which several share: at such a point, edges of two tetrahedra end and others begin. */
static void draw_ladders(body *b, generator *g) {
  point on[6];
  int64_t vertices = draw(g, 4, 6);
  for (int k = 0; k < 6; k++) {
    on[k] = (point){{UNIT * k, 0, 0}};
  }
  for (int64_t n = draw(g, 2, 4); n > 0; n--) {
    int64_t from = draw(g, 0, vertices / 2 - 1);
    int64_t to = draw(g, vertices / 2 + 1, vertices - 1);
    point apex[2] = {{{draw(g, 0, 60), draw(g, -3, 6), draw(g, 30, 40)}},
                     {{draw(g, 0, 60), draw(g, 30, 40), draw(g, -3, 6)}}};
    bool turned = one_in(g, 2);
    for (int side = 0; side < 2; side++) {
      bool whole = one_in(g, 2);
      int64_t middle = whole || one_in(g, 4) ? draw(g, from + 1, to) : vertices / 2;
      bool back = turned != (side != 0);
      int64_t points[3] = {from, whole ? to : middle, to};
      for (int k = 0; k < 2 && points[k] < points[k + 1]; k++) {
        add(&b->s, on[points[back ? k + 1 : k]], on[points[back ? k : k + 1]], apex[side]);
      }
    }
    add(&b->s, on[from], apex[turned ? 1 : 0], apex[turned ? 0 : 1]);
    add(&b->s, on[to], apex[turned ? 0 : 1], apex[turned ? 1 : 0]);
  }
  if (one_in(g, 4)) {
    turn_some(&b->s, g);
  }
}

/* Sums of the boundaries of simplices on a grid of 2 or 3 points an axis. */
static void draw_sums(body *b, generator *g) {
  int64_t size = draw(g, 1, 2);
  for (int64_t n = draw(g, 2, 8); n > 0; n--) {
    point p[4];
    any_simplex(g, size, p);
    add_simplex(&b->s, p, one_in(g, 2));
  }
  if (!one_in(g, 3)) {
    cancel(&b->s, one_in(g, 3));
  }
  if (one_in(g, 2)) {
    turn_some(&b->s, g);
  }
}

/* What closing takes. */
typedef struct {
  soup *s;
  point apex;
  generator *g;
} closing;

static void close_line(void *context, const line *l) {
  closing *c = context;
  int sum[6 * MOST] = {0};
  for (size_t i = 0; i < l->edges; i++) {
    for (size_t n = 0; n + 1 < l->cuts; n++) {
      bool on = l->edge[i].at[0] <= l->cut[n] && l->cut[n] < l->edge[i].at[1];
      sum[n] += on ? l->edge[i].sign : 0;
    }
  }
  for (size_t n = 0; n + 1 < l->cuts;) {
    int way = sign(sum[n]);
    if (way == 0) {
      n++;
      continue;
    }
    size_t end = n;
    do {
      sum[end++] -= way;
    } while (end + 1 < l->cuts && sum[end] * way > 0 && !one_in(c->g, 3));
    add(c->s, c->apex, l->where[way > 0 ? end : n], l->where[way > 0 ? n : end]);
  }
}

/* Random triangles; some lie along one line. A cone over their boundary closes them; where they are
 * open along a line, the cone's edges are drawn anew. */
static void draw_cones(body *b, generator *g) {
  int64_t size = draw(g, 1, 3);
  point way = {{draw(g, 0, 1), 1, 0}};
  for (int64_t n = draw(g, 2, 7); n > 0; n--) {
    point p[3] = {grid_point(g, size), grid_point(g, size), grid_point(g, size)};
    if (one_in(g, 2)) {
      p[0] = times(way, UNIT * draw(g, 0, 3));
      p[1] = times(way, UNIT * draw(g, 0, 3));
    }
    add(&b->s, p[0], p[1], p[2]);
  }
  static soup open;
  open = b->s;
  closing c = {&b->s, grid_point(g, size), g};
  for_each_line(&open, close_line, &c);
  if (one_in(g, 2)) {
    turn_some(&b->s, g);
  }
}

/* Abstract surfaces with one side (projective plane, Klein's bottle) or two, with random corners.
 * They cross themselves. */
static void draw_surfaces(body *b, generator *g) {
  static const int plane[10][3] = {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 5}, {0, 5, 1},
                                   {1, 2, 4}, {2, 3, 5}, {3, 4, 1}, {4, 5, 2}, {5, 1, 3}};
  point p[16];
  int64_t size = draw(g, 1, 5);
  for (int k = 0; k < 16; k++) {
    p[k] = grid_point(g, size);
  }
  int64_t which = draw(g, 0, 2);
  for (int i = 0; i < 10 && which == 0; i++) {
    add(&b->s, p[plane[i][0]], p[plane[i][1]], p[plane[i][2]]);
  }
  for (int i = 0; i < 7 && which == 1; i++) {
    add(&b->s, p[i], p[(i + 1) % 7], p[(i + 3) % 7]);
    add(&b->s, p[i], p[(i + 3) % 7], p[(i + 2) % 7]);
  }
  for (int n = 0; n < 16 && which == 2; n++) {
    int i = n % 4;
    int j = n / 4;
    int next = (i + 1) % 4;
    int across = j < 3 ? i : (4 - i) % 4;
    int opposite = j < 3 ? next : (4 - next) % 4;
    int up = (j + 1) % 4 * 4;
    add(&b->s, p[4 * j + i], p[4 * j + next], p[up + opposite]);
    add(&b->s, p[4 * j + i], p[up + opposite], p[up + across]);
  }
  if (one_in(g, 2)) {
    point q[4];
    any_simplex(g, size, q);
    add_simplex(&b->s, q, one_in(g, 2));
  }
  if (one_in(g, 3)) {
    spoil(&b->s, g);
  }
}

/* Bodies with holes, and strewn triangles. */
static void draw_open(body *b, generator *g) {
  draw_union(b, g);
  for (int64_t n = draw(g, 1, 3); n > 0 && b->s.count > 1; n--) {
    remove_triangle(&b->s, (size_t)draw(g, 0, (int64_t)b->s.count - 1));
  }
  for (int64_t n = draw(g, 0, 2); n > 0; n--) {
    add(&b->s, grid_point(g, 6), grid_point(g, 6), grid_point(g, 6));
  }
  if (one_in(g, 2)) {
    spoil(&b->s, g);
  }
}

/* ------------------------------------------------------------ list of kinds */

typedef struct {
  const char *name;
  void (*draw)(body *b, generator *g);
  bool known; /* b->proof tells where the material is */
} row;

static void draw_mixed(body *b, generator *g);
static const row list[] = {
    {"outward", draw_outward, true},      {"cells", draw_cells, true},
    {"turned", draw_turned, false},       {"copies", draw_copies, false},
    {"rows", draw_rows, false},           {"nested", draw_nested, false},
    {"walls", draw_walls, false},         {"fins", draw_fins, false},
    {"bad-cells", draw_bad_cells, false}, {"staggered", draw_staggered, false},
    {"ladders", draw_ladders, false},     {"sums", draw_sums, false},
    {"cones", draw_cones, false},         {"surfaces", draw_surfaces, false},
    {"open", draw_open, false},           {"mixed", draw_mixed, false},
};
enum { KINDS = sizeof list / sizeof *list };

/* Two bodies in one, and faults. */
static void draw_mixed(body *b, generator *g) {
  for (int n = 0; n < 2; n++) {
    list[draw(g, 0, KINDS - 2)].draw(b, g);
    b->solids = 0;
    b->proof.count = 0;
  }
  spoil(&b->s, g);
}

size_t kinds(void) { return KINDS; }

const char *kind_name(size_t kind) { return list[kind].name; }

size_t kind_of(const char *name) {
  size_t kind = 0;
  while (kind < KINDS && strcmp(list[kind].name, name) != 0) {
    kind++;
  }
  return kind;
}

void draw_body(body *b, size_t kind, generator *g) {
  do {
    b->s.count = 0;
    b->proof.count = 0;
    b->solids = 0;
    b->first[0] = 0;
    list[kind].draw(b, g);
    if (one_in(g, 6)) {
      fill_in(&b->s, g);
    }
  } while (b->s.count == 0 || full(&b->s) || full(&b->proof));
  b->solids = list[kind].known ? b->solids : 0;
  shuffle(&b->s, g);
}
