/* SPDX-License-Identifier: MIT */
/* lines.c - judges edges on their lines: which are open, which do not run both ways alike, and what
 * the edges that overlap say of their triangles.
 *
 * A surface is a sum of triangles, each with a factor. It is closed iff on each line the factors of
 * the triangles' edges, signed by direction, have the sum 0 at every point but vertices. So at each
 * vertex of a line, what ends there equals what begins there: the sums of edges are a flow along
 * the line. All factors 1: what is open, modulo 2, and what is not consistent.
 *
 * Any factors: if no two edges leave a vertex in the same direction, then the flow is 0 in each
 * edge by itself. (Nothing ends at the first vertex of a line, so nothing flows into the edge that
 * begins there, and so on.) Edges that overlap, but have no vertex in common, do not change this.
 * Only where edges leave a vertex in the same direction, their lines are walked along. */
#include "body/body.h"
#include "body/orient.h"
#include "parts.h"
#include "surface.h"
#include "util/list.h"
#include "util/memory.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* An edge as seen from one of its ends. */
typedef struct {
  uint32_t other; /* the vertex at its other end */
  uint32_t edge;  /* 2 * its first use in the surface's list, + 1 if it is uneven: more triangles
                     run along it in one direction than in the other */
} spoke;

/* A direction from a vertex: to a point, or away from it. */
typedef struct {
  const double *from, *to;
  int axis;  /* the first one along which they differ */
  bool low;  /* `to` is lower there */
  bool back; /* the direction runs to lower coordinates there */
} direction;

/* An edge on a line that is walked along. */
typedef struct {
  double low, high; /* of its ends, along an axis */
  uint32_t edge;    /* its first use, in the list of vertex `from` */
  uint32_t from;
  bool up;      /* `from` is at `low` */
  int32_t flow; /* what flows through it: 0, a number or minus a number that stands for
                   something unknown, or UNKNOWN */
} stretch;

enum { UNKNOWN = INT32_MIN };

typedef struct {
  double at;
  uint32_t stretch;
} line_end;

typedef struct {
  surface *s;
  sepax_shell *shell;
  spoke *spoke;    /* at each vertex, in the order of directions */
  uint32_t *begin; /* as in surface */
  uint32_t *seed;  /* vertices at which two edges leave in one direction */
  size_t seeds, seed_capacity;
  uint32_t *stack; /* vertices of a line */
  size_t depth, stack_capacity;
  uint32_t *seen; /* of each vertex: the number of the last line that was gathered there */
  uint32_t lines;
  stretch *line; /* sorted by `low` */
  size_t stretches, line_capacity;
  line_end *end;        /* their high ends, sorted */
  uint32_t (*alike)[2]; /* of each number of a flow: a triangle + 1 whose factor it is, and one
                           whose factor is minus it; 0: none */
} wheel;

/* -------------------------------------------------------------------- directions */

static direction direction_to(const double from[3], const double to[3]) {
  int axis = 0;
  while (axis < 2 && !(to[axis] < from[axis] || to[axis] > from[axis])) {
    axis++;
  }
  const bool low = to[axis] < from[axis];
  return (direction){from, to, axis, low, low};
}

/* The order of two directions from one vertex; exactly 0 for one direction. */
static int compare(const direction *p, const direction *q) {
  int order = p->back != q->back ? (p->back ? 1 : -1) : p->axis - q->axis;
  const int x = p->axis;
  for (int i = x + 1; i < 3 && order == 0; i++) {
    const double from[2] = {p->from[x], p->from[i]};
    const double to_p[2] = {p->to[x], p->to[i]};
    const double to_q[2] = {q->to[x], q->to[i]};
    order = sepax__orient2d(from, to_p, to_q);
    order = p->low != q->low ? -order : order;
  }
  return order;
}

bool sepax__on_line(const double p[3], const double q[3], const double r[3]) {
  direction to_q = direction_to(p, q);
  direction to_r = direction_to(p, r);
  to_q.back = to_r.back;
  return compare(&to_q, &to_r) == 0;
}

static direction spoke_direction(const wheel *w, uint32_t at, const spoke *p) {
  return direction_to(w->s->vertex[at], w->s->vertex[p->other]);
}

static bool is_uneven(const spoke *p) { return (p->edge & 1) != 0; }

/* A spoke to be sorted, and its direction, rounded. */
typedef struct {
  double way[3];
  spoke own;
} arm;

static arm arm_of(const wheel *w, uint32_t at, const spoke *p) {
  const double *from = w->s->vertex[at];
  const double *to = w->s->vertex[p->other];
  return (arm){{to[0] - from[0], to[1] - from[1], to[2] - from[2]}, *p};
}

/* The place of an arm's axis in the order of compare: of those that are not `back`, and of those
 * that are. Rounding keeps the signs of differences. */
static int sector_of(const arm *p) {
  int axis = 0;
  while (axis < 2 && !(p->way[axis] < 0 || p->way[axis] > 0)) {
    axis++;
  }
  return p->way[axis] < 0 ? 3 + axis : axis;
}

/* As compare. Each product is wrong by less than 4 u of its size, u = 2^-53, or by what
 * underflows. */
static int compare_arms(const wheel *w, uint32_t at, const arm *p, const arm *q) {
  const int sector = sector_of(p);
  const int other = sector_of(q);
  if (sector != other) {
    return sector - other;
  }
  const int x = sector % 3;
  for (int i = x + 1; i < 3; i++) {
    const double left = p->way[x] * q->way[i];
    const double right = p->way[i] * q->way[x];
    const double limit = 8 * 0x1p-53 * (fabs(left) + fabs(right)) + 0x1p-1000;
    if (fabs(left - right) > limit) {
      return left > right ? 1 : -1;
    }
    if (p->way[i] < 0 || p->way[i] > 0 || q->way[i] < 0 || q->way[i] > 0) {
      const direction to_p = spoke_direction(w, at, &p->own);
      const direction to_q = spoke_direction(w, at, &q->own);
      return compare(&to_p, &to_q);
    }
  }
  return 0;
}

/* Sort arms by merging; `scratch` has space for half of them. Returns whether two have the same
 * direction: in the end they follow each other, so they have been compared. */
static bool sort(const wheel *w, uint32_t at, arm *list, arm *scratch, size_t count) {
  bool equal = false;
  if (count <= 12) {
    for (size_t n = 1; n < count; n++) {
      const arm one = list[n];
      size_t k = n;
      for (; k > 0; k--) {
        const int order = compare_arms(w, at, &list[k - 1], &one);
        equal = equal || order == 0;
        if (order <= 0) {
          break;
        }
        list[k] = list[k - 1];
      }
      list[k] = one;
    }
    return equal;
  }
  const size_t half = count / 2;
  equal = sort(w, at, list, scratch, half);
  equal = sort(w, at, list + half, scratch, count - half) || equal;
  memcpy(scratch, list, half * sizeof *list);
  size_t p = 0;
  size_t q = half;
  for (size_t n = 0; p < half; n++) {
    const int order = q < count ? compare_arms(w, at, &scratch[p], &list[q]) : -1;
    equal = equal || order == 0;
    list[n] = order <= 0 ? scratch[p++] : list[q++];
  }
  return equal;
}

/* The spokes of a vertex in a direction: *count from the one that is returned. */
static const spoke *find_run(const wheel *w, uint32_t at, const direction *to, size_t *count) {
  uint32_t low = w->begin[at];
  uint32_t high = w->begin[at + 1];
  while (low < high) {
    const uint32_t middle = low + (high - low) / 2;
    const direction one = spoke_direction(w, at, &w->spoke[middle]);
    const bool before = compare(&one, to) < 0;
    low = before ? middle + 1 : low;
    high = before ? high : middle;
  }
  *count = 0;
  while (low + *count < w->begin[at + 1]) {
    const direction one = spoke_direction(w, at, &w->spoke[low + *count]);
    if (compare(&one, to) != 0) {
      break;
    }
    ++*count;
  }
  return w->spoke + low;
}

/* ------------------------------------------------------------------ the vertices */

static edge_uses uses_of(const wheel *w, uint32_t at, const spoke *p) {
  const surface *s = w->s;
  return edge_at(s, at < p->other ? at : p->other, s->edge + (p->edge >> 1));
}

/* List each edge that bounds something at both of its vertices. False without memory. */
static bool list_spokes(wheel *w) {
  const surface *s = w->s;
  w->begin = sepax__zeroed(s->vertices + 1, sizeof *w->begin);
  w->spoke = sepax_allocate(2 * (size_t)s->begin[s->vertices] * sizeof *w->spoke + 1);
  if (w->begin == NULL || w->spoke == NULL) {
    return false;
  }
  for (edge_uses at = {0, s->edge, 0}; next_edge(s, &at);) {
    if (sum_edge(&at).triangles > 0) {
      w->begin[at.from]++;
      w->begin[other_vertex(at.edge)]++;
    }
  }
  uint32_t sum = 0;
  for (size_t n = 0; n <= s->vertices; n++) { /* the ends of the lists, which then fill downwards */
    sum += w->begin[n];
    w->begin[n] = sum;
  }
  for (edge_uses at = {0, s->edge, 0}; next_edge(s, &at);) {
    const edge_sum own = sum_edge(&at);
    if (own.triangles > 0) {
      const uint32_t to = other_vertex(at.edge);
      const uint32_t edge = 2 * (uint32_t)(at.edge - s->edge) + (own.turn != 0);
      w->spoke[--w->begin[at.from]] = (spoke){to, edge};
      w->spoke[--w->begin[to]] = (spoke){at.from, edge};
    }
  }
  return true;
}

/* An open edge is named rather than a turned one. */
static void mark(wheel *w, const edge_uses *at, uint32_t triangle, bool odd, bool uneven) {
  sepax_shell *shell = w->shell;
  const surface *s = w->s;
  if ((odd && shell->closed) || (uneven && shell->closed && shell->consistent)) {
    memcpy(shell->edge[0], s->vertex[at->from], sizeof *s->vertex);
    memcpy(shell->edge[1], s->vertex[other_vertex(at->edge)], sizeof *s->vertex);
    shell->facet = shell->body->number[triangle];
  }
  s->turned[triangle] = s->turned[triangle] || uneven;
  s->open[triangle] = s->open[triangle] || odd;
  shell->closed = shell->closed && !odd;
  shell->consistent = shell->consistent && !uneven;
}

/* Judge the uneven edges of a vertex that are on one line, `ahead` in a direction and `behind` in
 * the opposite one. Their triangles are one part. If edges of an odd number of triangles end here
 * an odd number of times, then one of them is open. */
static void judge_ends(wheel *w, uint32_t at, const spoke *const run[2], const size_t count[2]) {
  int64_t away = 0;
  bool odd = false;
  bool found = false;
  edge_uses named = {0};
  uint32_t first = 0;
  for (int way = 0; way < 2; way++) {
    for (size_t n = 0; n < count[way]; n++) {
      const spoke *p = &run[way][n];
      if (!is_uneven(p)) {
        continue;
      }
      const edge_uses uses = uses_of(w, at, p);
      const edge_sum sum = sum_edge(&uses);
      const bool own = sum.triangles % 2 != 0;
      join(w->s->parent, found ? first : sum.two[0], sum.two[0]);
      if (!found || (own && !odd)) {
        named = uses;
        first = sum.two[0];
      }
      found = true;
      away += at == uses.from ? sum.turn : -sum.turn;
      odd ^= own;
    }
  }
  if (odd || away != 0) {
    mark(w, &named, first, odd, away > 1 || away < -1);
  }
}

/* The spokes of a vertex on the line of one of them: *count[0] in its direction, then those in the
 * opposite one. */
static void find_line(const wheel *w, uint32_t at, const spoke *p, const spoke *run[2],
                      size_t count[2]) {
  direction to = spoke_direction(w, at, p);
  run[0] = find_run(w, at, &to, &count[0]);
  to.back = !to.back;
  run[1] = find_run(w, at, &to, &count[1]);
}

static bool any_uneven(const spoke *run, size_t count) {
  for (size_t n = 0; n < count; n++) {
    if (is_uneven(&run[n])) {
      return true;
    }
  }
  return false;
}

static bool push(uint32_t **list, size_t *count, size_t *capacity, uint32_t vertex) {
  uint32_t *grown = list_grow(*list, capacity, *count, sizeof *grown);
  if (grown == NULL) {
    return false;
  }
  *list = grown;
  grown[(*count)++] = vertex;
  return true;
}

/* Judge the lines of a vertex on which there are uneven edges. */
static void judge_vertex(wheel *w, uint32_t at) {
  const uint32_t end = w->begin[at + 1];
  uint32_t next;
  for (uint32_t n = w->begin[at]; n < end; n = next) {
    next = n + 1;
    if (is_uneven(&w->spoke[n])) {
      const spoke *run[2];
      size_t count[2];
      find_line(w, at, &w->spoke[n], run, count);
      next = (uint32_t)((size_t)(run[0] - w->spoke) + count[0]);
      const direction to = spoke_direction(w, at, &w->spoke[n]);
      if (!to.back || !any_uneven(run[1], count[1])) { /* else the opposite direction does it */
        judge_ends(w, at, run, count);
      }
    }
  }
}

/* Sort the spokes of a vertex, and judge its lines. arms: space for 1.5 times as many. False
 * without memory. */
static bool visit_vertex(wheel *w, uint32_t at, arm *arms) {
  spoke *list = w->spoke + w->begin[at];
  const size_t count = w->begin[at + 1] - w->begin[at];
  for (size_t n = 0; n < count; n++) {
    arms[n] = arm_of(w, at, &list[n]);
  }
  const bool equal = sort(w, at, arms, arms + count, count);
  for (size_t n = 0; n < count; n++) {
    list[n] = arms[n].own;
  }
  if (any_uneven(list, count)) {
    judge_vertex(w, at);
  }
  return !equal || push(&w->seed, &w->seeds, &w->seed_capacity, at);
}

/* --------------------------------------------------- the lines of edges that overlap */

/* Add the edges at a vertex that are on a line, and their other ends to the stack. */
static bool add_run(wheel *w, const direction *along, uint32_t at, const spoke *run, size_t count) {
  for (size_t n = 0; n < count; n++) {
    const uint32_t edge = run[n].edge >> 1;
    if (w->s->walked[edge] != 0) {
      continue;
    }
    stretch *grown = list_grow(w->line, &w->line_capacity, w->stretches, sizeof *grown);
    if (grown == NULL) {
      return false;
    }
    const uint32_t lower = at < run[n].other ? at : run[n].other;
    const uint32_t higher = at < run[n].other ? run[n].other : at;
    const double p = w->s->vertex[lower][along->axis];
    const double q = w->s->vertex[higher][along->axis];
    w->line = grown;
    w->line[w->stretches++] = (stretch){p < q ? p : q, p < q ? q : p, edge, lower, p < q, 0};
    w->s->walked[edge] = EDGE_WALKED;
    if (!push(&w->stack, &w->depth, &w->stack_capacity, run[n].other)) {
      return false;
    }
  }
  return true;
}

/* List the edges on the line of a spoke that hang together by vertices. */
static bool gather_line(wheel *w, uint32_t at, const spoke *first) {
  const uint32_t other = first->other;
  const direction along = spoke_direction(w, at, first);
  w->lines++;
  w->stretches = 0;
  bool ok = push(&w->stack, &w->depth, &w->stack_capacity, at);
  while (ok && w->depth > 0) {
    const uint32_t vertex = w->stack[--w->depth];
    if (w->seen[vertex] == w->lines) {
      continue;
    }
    w->seen[vertex] = w->lines;
    const spoke toward = {vertex == at ? other : at, 0};
    const spoke *run[2];
    size_t count[2];
    find_line(w, vertex, &toward, run, count);
    ok = add_run(w, &along, vertex, run[0], count[0]) &&
         add_run(w, &along, vertex, run[1], count[1]);
  }
  return ok;
}

static int compare_doubles(double a, double b) { return (a > b) - (a < b); }

static int compare_low(const void *p, const void *q) {
  return compare_doubles(((const stretch *)p)->low, ((const stretch *)q)->low);
}

static int compare_ends(const void *p, const void *q) {
  return compare_doubles(((const line_end *)p)->at, ((const line_end *)q)->at);
}

/* What flows to a vertex in `count` edges, of which `end` lists the ends. */
static int32_t flow_to(const wheel *w, const line_end *end, size_t count) {
  int32_t flow[2] = {0};
  size_t flows = 0;
  for (size_t n = 0; n < count; n++) {
    const int32_t own = w->line[end[n].stretch].flow;
    if (own == UNKNOWN || (own != 0 && flows == 2)) {
      return UNKNOWN;
    }
    if (own != 0) {
      flow[flows++] = own;
    }
  }
  return flows < 2 ? flow[0] : flow[0] == -flow[1] ? 0 : UNKNOWN;
}

/* Find what flows through the edges of a line. Where two edges leave a vertex to which nothing
 * flows, one has minus the flow of the other. */
static void find_flows(wheel *w) {
  int32_t number = 0;
  size_t end = 0;
  size_t next;
  for (size_t n = 0; n < w->stretches; n = next) {
    const double at = w->line[n].low;
    for (next = n + 1; next < w->stretches && !(w->line[next].low > at);) {
      next++;
    }
    while (end < w->stretches && w->end[end].at < at) {
      end++;
    }
    size_t ending = 0;
    while (end + ending < w->stretches && !(w->end[end + ending].at > at)) {
      ending++;
    }
    const int32_t to = flow_to(w, w->end + end, ending);
    const bool split = to == 0 && next - n == 2;
    number += split;
    for (size_t k = n; k < next; k++) {
      w->line[k].flow = next - n == 1 ? to : !split ? UNKNOWN : k == n ? number : -number;
    }
  }
}

/* Join a triangle, which is alone at its edge, to others that have the same factor. */
static void join_alike(wheel *w, const stretch *e, const edge_sum *sum) {
  const bool minus = (sum->turn > 0) == e->up ? e->flow < 0 : e->flow > 0;
  uint32_t *alike = &w->alike[abs(e->flow) - 1][minus];
  if (*alike > 0) {
    join(w->s->sheet, *alike - 1, sum->two[0]);
  }
  *alike = sum->two[0] + 1;
}

/* Join what the flows say of a line's triangles: which are alike, and which may form a surface
 * together. */
static void join_line(wheel *w) {
  surface *s = w->s;
  const stretch *last = NULL;
  for (size_t n = 0; n < w->stretches; n++) {
    const stretch *e = &w->line[n];
    if (e->flow == 0) {
      continue;
    }
    const edge_uses at = edge_at(s, e->from, s->edge + e->edge);
    const edge_sum sum = sum_edge(&at);
    s->walked[e->edge] = EDGE_FLOWS;
    if (e->flow != UNKNOWN && sum.triangles == 1) {
      join_alike(w, e, &sum);
    }
    if (last != NULL) {
      join(s->entangled, triangle_at(s->edge + last->edge), sum.two[0]);
    }
    last = e;
  }
}

/* Walk along the line that is gathered. */
static bool walk_line(wheel *w) {
  w->end = sepax_allocate(w->stretches * sizeof *w->end);
  w->alike = sepax__zeroed(w->stretches, sizeof *w->alike);
  const bool ok = w->end != NULL && w->alike != NULL;
  if (ok) {
    qsort(w->line, w->stretches, sizeof *w->line, compare_low);
    for (size_t n = 0; n < w->stretches; n++) {
      w->end[n] = (line_end){w->line[n].high, (uint32_t)n};
    }
    qsort(w->end, w->stretches, sizeof *w->end, compare_ends);
    find_flows(w);
    join_line(w);
  }
  sepax_release(w->end);
  sepax_release(w->alike);
  return ok;
}

/* Walk along the lines on which two edges leave a vertex in one direction. */
static bool walk_lines(wheel *w) {
  surface *s = w->s;
  s->walked = sepax__zeroed(s->begin[s->vertices], sizeof *s->walked);
  s->entangled = sepax_allocate(s->count * sizeof *s->entangled);
  w->seen = sepax__zeroed(s->vertices, sizeof *w->seen);
  bool ok = s->walked != NULL && s->entangled != NULL && w->seen != NULL;
  for (uint32_t n = 0; n < s->count && ok; n++) {
    s->entangled[n] = n;
  }
  for (size_t k = 0; k < w->seeds && ok; k++) {
    const uint32_t at = w->seed[k];
    for (uint32_t n = w->begin[at]; n + 1 < w->begin[at + 1] && ok; n++) {
      const direction p = spoke_direction(w, at, &w->spoke[n]);
      const direction q = spoke_direction(w, at, &w->spoke[n + 1]);
      if (s->walked[w->spoke[n].edge >> 1] == 0 && compare(&p, &q) == 0) {
        ok = gather_line(w, at, &w->spoke[n]) && walk_line(w);
      }
    }
  }
  return ok;
}

bool sepax__judge_lines(surface *s, sepax_shell *shell) {
  wheel w = {.s = s, .shell = shell};
  bool ok = list_spokes(&w);
  size_t most = 0;
  for (uint32_t n = 0; n < s->vertices && ok; n++) {
    const size_t count = w.begin[n + 1] - w.begin[n];
    most = count > most ? count : most;
  }
  arm *arms = sepax_allocate((most + most / 2 + 1) * sizeof *arms);
  ok = ok && arms != NULL;
  for (uint32_t n = 0; n < s->vertices && ok; n++) {
    ok = visit_vertex(&w, n, arms);
  }
  ok = ok && (w.seeds == 0 || walk_lines(&w));
  sepax_release(arms);
  sepax_release(w.begin);
  sepax_release(w.spoke);
  sepax_release(w.seed);
  sepax_release(w.stack);
  sepax_release(w.seen);
  sepax_release(w.line);
  return ok;
}
