/* SPDX-License-Identifier: MIT */
/* sheets.c - makes the net of edges, and takes out the wires that carry nothing. */
#include "sheets.h"

#include "report.h"
#include "sets.h"

#include <stdlib.h>
#include <string.h>

/* An edge, with the triangles that have it as a side and are not flat. */
typedef struct {
  size_t node[2], line[2];
  size_t count;    /* of the triangles */
  long turn;       /* how many more of them run from node[0] to node[1] than back */
  size_t side;     /* the place of one's side */
  size_t opposite; /* the place of a side that runs the other way; NONE */
  bool empty;      /* the wire carries nothing */
} wire;

/* A place is 3 triangle + corner, and the side from there to the triangle's next corner. */
typedef struct {
  const surface *s;
  size_t (*node)[2]; /* of each place: where its side begins, where it ends; NONE: no length */
  size_t (*line)[2]; /* likewise, the line through the vertex; a node may be several lines */
  size_t nodes, lines;
  wire *wire;
  size_t wires;
  size_t *part; /* sets of triangles that have wires in common */
} net;

static int compare_sizes(size_t a, size_t b) { return (a > b) - (a < b); }
static int compare_numbers(double a, double b) { return (a > b) - (a < b); }
static size_t next_corner(size_t place) { return place % 3 == 2 ? place - 2 : place + 1; }
static vec corner_at(const surface *s, size_t place) {
  return s->triangle[place / 3].at[place % 3];
}

/* ------------------------------------------------------------------------ nodes */

typedef struct {
  vec at;
  size_t place;
} corner;

static int compare_corners(const void *x, const void *y) {
  const corner *a = x;
  const corner *b = y;
  int order = compare_numbers(a->at.x, b->at.x);
  if (order == 0)
    order = compare_numbers(a->at.y, b->at.y);
  return order != 0 ? order : compare_numbers(a->at.z, b->at.z);
}

static size_t element_end(const surface *s, size_t element) {
  return element + 1 < s->elements ? s->element[element + 1].first : s->count;
}

/* The vertex of each place: equal corners of an element are one. */
static size_t *find_vertices(const surface *s) {
  corner *all = memory(NULL, 3 * s->count, sizeof *all);
  size_t *vertex = memory(NULL, 3 * s->count, sizeof *vertex);
  size_t vertices = 0;
  for (size_t n = 0; n < 3 * s->count; n++)
    all[n] = (corner){corner_at(s, n), n};
  for (size_t element = 0; element < s->elements; element++) {
    const size_t first = 3 * s->element[element].first;
    const size_t end = 3 * element_end(s, element);
    qsort(all + first, end - first, sizeof *all, compare_corners);
    for (size_t n = first; n < end; n++) {
      vertices += n == first || compare_corners(&all[n - 1], &all[n]) != 0;
      vertex[all[n].place] = vertices - 1;
    }
  }
  free(all);
  return vertex;
}

/* A side at one of its ends. The lines of two sides may be the same if their ranges overlap. */
typedef struct {
  size_t vertex, place_end; /* 2 place + end */
  double from, to;
} spoke;

static int compare_spokes(const void *x, const void *y) {
  const spoke *a = x;
  const spoke *b = y;
  return compare_numbers(a->from, b->from); /* of one vertex */
}

static point side_at(const surface *s, size_t place) {
  return point_minus(point_of(corner_at(s, next_corner(place))), point_of(corner_at(s, place)));
}

static long double most_of(point p) { return fmaxl(fabsl(p.x), fmaxl(fabsl(p.y), fabsl(p.z))); }

/* All sides on a line have the same number, but for rounding; others may have it, too. */
static spoke spoke_of(const surface *s, size_t place) {
  const point d = side_at(s, place);
  const long double most = most_of(d);
  const point by = {1, 0.6180339887498949L, 0.3247179572447461L};
  const long double number = fabsl(point_dot(d, by)) / most;
  /* Coordinates are wrong by 8 roundings of the radius at most, 2^-50 of it, so d by 2^-49. The
   * factors' sum is below 2, and so is the number, which is wrong by less than 2^-46 / most. */
  const long double wrong = 0x1p-46L * (long double)s->radius / most;
  return (spoke){.from = (double)(number - wrong), .to = (double)(number + wrong)};
}

/* Sorted; first by counting, because an algorithm of n log n takes longer for all than for each. */
static spoke *by_vertex(spoke *all, size_t count, size_t vertices) {
  spoke *sorted = memory(NULL, count, sizeof *sorted);
  size_t *end = memory(NULL, vertices + 1, sizeof *end);
  memset(end, 0, (vertices + 1) * sizeof *end);
  for (size_t n = 0; n < count; n++)
    end[all[n].vertex]++;
  for (size_t n = 1; n <= vertices; n++)
    end[n] += end[n - 1];
  for (size_t n = count; n-- > 0;)
    sorted[--end[all[n].vertex]] = all[n];
  for (size_t n = 0; n < vertices; n++) {
    if (end[n + 1] > end[n])
      qsort(&sorted[end[n]], end[n + 1] - end[n], sizeof *sorted, compare_spokes);
  }
  free(end);
  free(all);
  return sorted;
}

/* Are two sides with a common end on one line, but for rounding? */
static bool one_line(const surface *s, size_t p, size_t q) {
  const point a = side_at(s, p);
  const point b = side_at(s, q);
  const long double wrong = 0x1p-46L * (long double)s->radius; /* of a and of b, and more */
  return most_of(point_cross(a, b)) <= wrong * (most_of(a) + most_of(b));
}

/* Number the lines of a node. If they are many, then some get several numbers: what is closed by
 * numbers is closed by lines. */
static void find_lines(net *g, const spoke *of, size_t count) {
  enum { MANY = 16 };
  size_t first[MANY];
  size_t known = 0;
  size_t more = 0;
  for (size_t n = 0; n < count; n++) {
    const size_t place = of[n].place_end / 2;
    size_t k = 0;
    while (k < known && !one_line(g->s, first[k], place))
      k++;
    if (k == known && known < MANY)
      first[known++] = place;
    g->line[place][of[n].place_end % 2] = g->lines + (k < MANY ? k : MANY + more++);
  }
  g->lines += known + more;
}

static void find_nodes(net *g) {
  const size_t places = 3 * g->s->count;
  size_t *vertex = find_vertices(g->s);
  spoke *all = memory(NULL, 2 * places, sizeof *all);
  size_t spokes = 0;
  g->node = memory(NULL, places, sizeof *g->node);
  g->line = memory(NULL, places, sizeof *g->line);
  for (size_t n = 0; n < places; n++) {
    const size_t at[2] = {vertex[n], vertex[next_corner(n)]};
    g->node[n][0] = g->node[n][1] = NONE;
    if (at[0] == at[1])
      continue;
    const spoke one = spoke_of(g->s, n);
    for (size_t end = 0; end < 2; end++)
      all[spokes++] = (spoke){at[end], 2 * n + end, one.from, one.to};
  }
  all = by_vertex(all, spokes, places);
  size_t next;
  for (size_t first = 0; first < spokes; first = next) {
    double reached = all[first].to;
    for (next = first;
         next < spokes && all[next].vertex == all[first].vertex && all[next].from <= reached;
         next++) {
      reached = fmax(reached, all[next].to);
      g->node[all[next].place_end / 2][all[next].place_end % 2] = g->nodes;
    }
    find_lines(g, &all[first], next - first);
    g->nodes++;
  }
  free(all);
  free(vertex);
}

/* ------------------------------------------------------------------------ wires */

/* Two of its corners are equal. */
static bool is_line(const net *g, size_t n) {
  return g->node[3 * n][0] == NONE || g->node[3 * n + 1][0] == NONE ||
         g->node[3 * n + 2][0] == NONE;
}

/* A line; or at each corner both sides are at one node: then the triangle brings to each node what
 * it takes away, so the laws hold without it. */
static bool is_flat(const net *g, size_t n) {
  bool flat = true;
  for (size_t k = 3 * n; k < 3 * n + 3; k++)
    flat = flat && g->node[k][1] == g->node[next_corner(k)][0];
  return flat || is_line(g, n);
}

typedef struct {
  size_t low, high; /* nodes */
  size_t place;
} side;

static int compare_sides(const void *x, const void *y) {
  const side *a = x;
  const side *b = y;
  const int order = compare_sizes(a->low, b->low);
  return order != 0 ? order : compare_sizes(a->high, b->high);
}

static wire wire_of(const net *g, size_t place) {
  const size_t *node = g->node[place];
  const size_t *line = g->line[place];
  const bool back = node[0] > node[1];
  return (wire){.node = {node[back], node[!back]},
                .line = {line[back], line[!back]},
                .side = place,
                .opposite = NONE};
}

static void find_wires(net *g) {
  side *all = memory(NULL, 3 * g->s->count, sizeof *all);
  size_t sides = 0;
  for (size_t n = 0; n < 3 * g->s->count; n++) {
    const size_t *of = g->node[n];
    const bool forward = of[0] < of[1];
    if (!is_flat(g, n / 3))
      all[sides++] = (side){of[!forward], of[forward], n};
  }
  qsort(all, sides, sizeof *all, compare_sides);
  g->wire = memory(NULL, sides, sizeof *g->wire);
  g->part = memory(NULL, g->s->count, sizeof *g->part);
  for (size_t n = 0; n < g->s->count; n++)
    g->part[n] = n;
  for (size_t n = 0; n < sides; n++) {
    if (n == 0 || compare_sides(&all[n - 1], &all[n]) != 0)
      g->wire[g->wires++] = wire_of(g, all[n].place);
    wire *w = &g->wire[g->wires - 1];
    w->count++;
    w->turn += g->node[all[n].place][0] == w->node[0] ? 1 : -1;
    unite(g->part, w->side / 3, all[n].place / 3);
    if (g->node[all[n].place][0] != g->node[w->side][0])
      w->opposite = all[n].place;
  }
  free(all);
}

/* The wires at a node: how many, and their numbers combined by exclusive or. */
typedef struct {
  size_t count, wires;
} joint;

static void change(joint *at, const wire *w, size_t number, int by) {
  for (int end = 0; end < 2; end++) {
    at[w->node[end]].count += (size_t)by;
    at[w->node[end]].wires ^= number;
  }
}

/* Law 1, until no wire is alone at a node. Returns what is left at the nodes. */
static joint *empty_wires(net *g) {
  joint *at = memory(NULL, g->nodes, sizeof *at);
  memset(at, 0, g->nodes * sizeof *at);
  for (size_t n = 0; n < g->wires; n++)
    change(at, &g->wire[n], n, 1);
  for (size_t n = 0; n < g->nodes; n++) {
    for (size_t node = n; at[node].count == 1;) {
      wire *w = &g->wire[at[node].wires];
      w->empty = true;
      change(at, w, at[node].wires, -1);
      node = w->node[w->node[0] == node];
    }
  }
  return at;
}

/* ------------------------------------------------------------------------ sheets */

/* The current of a wire is the factor of its only triangle. Of two wires at the node, does one
 * bring it and the other one take it away? */
static bool goes_on(const net *g, const wire *a, const wire *b, size_t node) {
  return (g->node[a->side][1] == node) != (g->node[b->side][1] == node);
}

static void find_sheets(net *g, size_t *sheet) {
  joint *at = empty_wires(g);
  for (size_t n = 0; n < g->s->count; n++)
    sheet[n] = n;
  for (size_t n = 0; n < g->wires; n++) {
    const wire *w = &g->wire[n];
    if (w->empty && w->count == 2 && w->opposite != NONE)
      unite(sheet, w->side / 3, w->opposite / 3);
    for (int end = 0; end < 2 && !w->empty && w->count == 1; end++) {
      const size_t node = w->node[end];
      const wire *other = at[node].count == 2 ? &g->wire[at[node].wires ^ n] : w;
      if (other->count == 1 && goes_on(g, w, other, node))
        unite(sheet, w->side / 3, other->side / 3);
    }
  }
  for (size_t n = 0; n < g->s->count; n++)
    sheet[n] = is_line(g, n) ? NONE : is_flat(g, n) ? FLAT : root_of(sheet, n);
  free(at);
}

/* ------------------------------------------------------------------------ parts */

static double coordinate(vec p, int axis) { return axis == 0 ? p.x : axis == 1 ? p.y : p.z; }

static void part_add(part *to, vec p) {
  for (int n = 0; n < 6; n++) {
    const double by = coordinate(p, n / 2) - coordinate(to->at[n + 1], n / 2);
    if (n % 2 == 0 ? by < 0 : by > 0)
      to->at[n + 1] = p;
  }
}

/* The parts of the triangles, whose sets are in `up`. */
static void add_parts(sheets *made, const surface *s, size_t *up) {
  size_t element = 0;
  for (size_t n = 0; n < s->count; n++) {
    while (n >= element_end(s, element))
      element++;
    if (root_of(up, n) != n)
      continue;
    GROW(made->part, made->parts);
    part *new = &made->part[made->parts];
    *new = (part){.element = element};
    for (int k = 0; k < 7; k++)
      new->at[k] = corner_at(s, 3 * n);
    made->part_of[n] = made->parts++;
  }
  for (size_t n = 0; n < 3 * s->count; n++) {
    made->part_of[n / 3] = made->part_of[root_of(up, n / 3)];
    part_add(&made->part[made->part_of[n / 3]], corner_at(s, n));
  }
}

/* Wires that carry something at one node are of one part. A part is closed if along each line it
 * brings as much to each vertex as it takes away; so does a wire that carries nothing, by itself.
 */
static void find_parts(net *g, sheets *made) {
  size_t *first = memory(NULL, g->nodes, sizeof *first); /* a triangle at each node */
  long *sum = memory(NULL, g->lines, sizeof *sum);
  for (size_t n = 0; n < g->nodes; n++)
    first[n] = NONE;
  memset(sum, 0, g->lines * sizeof *sum);
  for (size_t n = 0; n < g->wires; n++) {
    const wire *w = &g->wire[n];
    for (int end = 0; end < 2 && !w->empty; end++) {
      const size_t node = w->node[end];
      first[node] = first[node] == NONE ? w->side / 3 : first[node];
      unite(g->part, w->side / 3, first[node]);
      sum[w->line[end]] += end == 0 ? -w->turn : w->turn;
    }
  }
  add_parts(made, g->s, g->part);
  for (size_t n = 0; n < g->wires; n++) {
    const wire *w = &g->wire[n];
    part *of = &made->part[made->part_of[w->side / 3]];
    for (int end = 0; end < 2; end++) {
      const long left = w->empty ? w->turn : sum[w->line[end]];
      of->open = of->open || left % 2 != 0;
      of->twisted = of->twisted || left != 0;
    }
  }
  free(sum);
  free(first);
}

sheets sheets_of(const surface *s) {
  net g = {.s = s};
  sheets made = {.sheet_of = memory(NULL, s->count, sizeof *made.sheet_of),
                 .part_of = memory(NULL, s->count, sizeof *made.part_of)};
  find_nodes(&g);
  find_wires(&g);
  find_sheets(&g, made.sheet_of);
  find_parts(&g, &made);
  free(g.part);
  free(g.wire);
  free(g.node);
  free(g.line);
  return made;
}
