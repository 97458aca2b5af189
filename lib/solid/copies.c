/* SPDX-License-Identifier: MIT */
/* copies.c - finds sheets that are there several times, such as both sides of a face, and what they
 * enclose although a ray meets their triangles an even number of times.
 *
 * Sheets with the same boundary are copies of each other, however each of them is divided. If
 * vertices are in the middle of edges, then sheets may lie on each other without such a
 * boundary. */
#include "body/body.h"
#include "body/orient.h"
#include "parts.h"
#include "sheets.h"
#include "util/memory.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* STACK: 64 levels, up to 7 children waiting on each. STEPS: nodes and planes that are looked at
 * for one triangle, and for each triangle on average. */
enum { STACK = 512, STEPS = 256, MEAN_STEPS = 24 };

typedef struct {
  uint64_t boundary, vertices; /* sums of words */
  uint32_t sheet;
} bounded;

typedef struct {
  sheets all;
  bounded *list; /* sheets that have a boundary, sorted */
  size_t count;
  size_t steps; /* of all searches */
  bool *joint;  /* of a part's first triangle: it has an edge of several sheets, and is not open */
  bool *even;   /* of a part's first triangle: it has an even number of copies of a sheet */
  bool *flat;   /* of each triangle: it has no area */
  uint32_t *begin, *triangle; /* the triangles of sheet n are triangle[begin[n] ... begin[n + 1]] */
  uint8_t *member;            /* of each sheet: it may be a part of a closed surface */
} copies;

static int compare_words(uint64_t a, uint64_t b) { return (a > b) - (a < b); }

static int compare(const void *p, const void *q) {
  const bounded *a = p;
  const bounded *b = q;
  int order = compare_words(a->boundary, b->boundary);
  order = order != 0 ? order : compare_words(a->vertices, b->vertices);
  return order != 0 ? order : compare_words(a->sheet, b->sheet);
}

/* List the triangles of each sheet after each other. False without memory. */
static bool list_triangles(const surface *s, copies *c) {
  c->begin = sepax__zeroed(s->count + 1, sizeof *c->begin);
  c->triangle = sepax_allocate(s->count * sizeof *c->triangle);
  if (c->begin == NULL || c->triangle == NULL) {
    return false;
  }
  for (uint32_t n = 0; n < s->count; n++) {
    c->begin[set_of(c->all.of, n)]++;
  }
  for (size_t n = 0; n < s->count; n++) {
    c->begin[n + 1] += c->begin[n];
  }
  for (uint32_t n = (uint32_t)s->count; n-- > 0;) {
    c->triangle[--c->begin[set_of(c->all.of, n)]] = n;
  }
  return true;
}

/* List the sheets that have a boundary. False without memory. */
static bool list_bounded(const surface *s, copies *c) {
  uint32_t *seen = sepax__zeroed(s->vertices, sizeof *seen);
  if (seen == NULL) {
    return false;
  }
  for (size_t n = 0; n < c->all.borders; n++) {
    const border *b = &c->all.border[n];
    if (n == 0 || b[-1].sheet != b->sheet) {
      c->list[c->count++] = (bounded){0, 0, b->sheet};
    }
    c->list[c->count - 1].boundary += word_of(b->place);
  }
  for (size_t n = 0; n < c->count; n++) {
    uint32_t sheet = c->list[n].sheet;
    for (uint32_t k = 3 * c->begin[sheet]; k < 3 * c->begin[sheet + 1]; k++) {
      uint32_t vertex = s->corner[c->triangle[k / 3]][k % 3];
      c->list[n].vertices += seen[vertex] != sheet + 1 ? word_of(vertex) : 0;
      seen[vertex] = sheet + 1;
    }
  }
  qsort(c->list, c->count, sizeof *c->list, compare);
  sepax_release(seen);
  return true;
}

/* How many sheets from `first` on have the same boundary, and perhaps the same vertices. */
static size_t equal_sheets(const copies *c, size_t first, bool vertices) {
  size_t count = 1;
  while (first + count < c->count && c->list[first + count].boundary == c->list[first].boundary &&
         (!vertices || c->list[first + count].vertices == c->list[first].vertices)) {
    count++;
  }
  return count;
}

/* Edges that lie on each other belong to one part. */
static bool join_torn(const surface *s, const copies *c) {
  uint32_t *first = sepax_allocate(c->all.places * sizeof *first + 1);
  if (first == NULL) {
    return false;
  }
  memset(first, 255, c->all.places * sizeof *first);
  for (size_t n = 0; n < c->all.borders; n++) {
    const border *b = &c->all.border[n];
    first[b->place] = first[b->place] == UINT32_MAX ? b->sheet : first[b->place];
    join(s->parent, first[b->place], b->sheet);
  }
  sepax_release(first);
  return true;
}

/* Has the triangle no area? */
static bool is_flat(const double t[3][3]) {
  for (int i = 0; i < 3; i++) {
    const double p[3][2] = {
        {t[0][i], t[0][(i + 1) % 3]}, {t[1][i], t[1][(i + 1) % 3]}, {t[2][i], t[2][(i + 1) % 3]}};
    if (sepax__orient2d(p[0], p[1], p[2]) != 0) {
      return false;
    }
  }
  return true;
}

/* Does the triangle t of t's plane have the point p of this plane? Roughly so. */
static bool has_point(const double t[3][3], const double p[3]) {
  double normal[3];
  double way[3];
  for (int i = 0; i < 3; i++) {
    int x = (i + 1) % 3;
    int y = (i + 2) % 3;
    normal[i] =
        (t[1][x] - t[0][x]) * (t[2][y] - t[0][y]) - (t[1][y] - t[0][y]) * (t[2][x] - t[0][x]);
  }
  int axis = 0;
  for (int i = 1; i < 3; i++) {
    axis = fabs(normal[i]) > fabs(normal[axis]) ? i : axis;
  }
  int x = (axis + 1) % 3;
  int y = (axis + 2) % 3;
  for (int k = 0; k < 3; k++) {
    const double *a = t[k];
    const double *b = t[(k + 1) % 3];
    way[k] = ((b[x] - a[x]) * (p[y] - a[y]) - (b[y] - a[y]) * (p[x] - a[x])) * normal[axis];
  }
  return way[0] >= 0 && way[1] >= 0 && way[2] >= 0;
}

static bool in_one_plane(const double p[3][3], const double q[3][3]) {
  return sepax__orient3d(p[0], p[1], p[2], q[0]) == 0 &&
         sepax__orient3d(p[0], p[1], p[2], q[1]) == 0 &&
         sepax__orient3d(p[0], p[1], p[2], q[2]) == 0;
}

static uint32_t children_at(const body_node *node, const double at[3]) {
  uint32_t bits = 0;
  for (uint32_t n = 0; n < node->children; n++) {
    bool near = true;
    for (int i = 0; i < 3; i++) {
      near = near && fabs(node->centre[i][n] - at[i]) <= node->half[i][n] + 0x1p-20;
    }
    bits |= (uint32_t)near << n;
  }
  return bits;
}

/* Does another triangle lie on the middle of this one? True if that would take long to find. */
static bool is_covered(copies *c, const sepax_body *body, uint32_t number) {
  const double(*own)[3] = body->triangle[number];
  uint32_t stack[STACK] = {0};
  int depth = 1;
  size_t steps = 0;
  double middle[3];
  double at[3];
  for (int i = 0; i < 3; i++) {
    middle[i] = own[0][i] / 3 + own[1][i] / 3 + own[2][i] / 3;
    at[i] = (middle[i] - body->centre[i]) / body->scale;
  }
  while (depth > 0) {
    const body_node *node = &body->node[stack[--depth]];
    steps++;
    if (steps > STEPS || c->steps + steps > MEAN_STEPS * body->count) {
      return true;
    }
    for (uint32_t mask = children_at(node, at); mask != 0; mask &= mask - 1) {
      uint32_t child = node->child[__builtin_ctz(mask)];
      if ((child & BODY_TRIANGLE) == 0) {
        stack[depth++] = child;
        continue;
      }
      const double(*t)[3] = body->triangle[child - BODY_TRIANGLE];
      if (child - BODY_TRIANGLE == number || !has_point(t, middle)) {
        continue;
      }
      steps++;
      if (in_one_plane(own, t)) {
        c->steps += steps;
        return true;
      }
    }
  }
  c->steps += steps;
  return false;
}

/* Sheets of one boundary are copies if they have the same vertices, or if other triangles lie on
 * them. The others may be the walls of a room. Copies come first in the list then. */
static size_t take_copies(copies *c, size_t first, size_t count, const sepax_body *body) {
  size_t copied = 0;
  for (size_t n = first; n < first + count;) {
    size_t equal = equal_sheets(c, n, true);
    for (size_t end = n + equal; n < end; n++) {
      bounded own = c->list[n];
      bool copy = equal > 1;
      for (uint32_t k = c->begin[own.sheet]; k < c->begin[own.sheet + 1] && !copy; k++) {
        copy = !c->flat[c->triangle[k]] && is_covered(c, body, c->triangle[k]);
      }
      if (copy) {
        c->list[n] = c->list[first + copied];
        c->list[first + copied++] = own;
      }
    }
  }
  return copied;
}

/* Set s->times of each sheet, and find the parts that need closed surfaces. Each sheet of c->list
 * that is no copy gets a boundary of its own. */
static void count_copies(surface *s, copies *c, const sepax_body *body) {
  for (uint32_t n = 0; n < s->count; n++) {
    s->times[n] = 1;
    c->joint[set_of(s->parent, n)] |= c->all.joint[n];
  }
  for (uint32_t n = 0; n < s->count; n++) {
    uint32_t part = set_of(s->parent, n);
    c->joint[part] = c->joint[part] && !s->open[n];
  }
  for (size_t first = 0; first < c->count;) {
    size_t count = equal_sheets(c, first, false);
    size_t copied = count > 1 ? take_copies(c, first, count, body) : 0;
    for (size_t n = 0; n < copied; n++) {
      s->times[c->list[first + n].sheet] = (uint32_t)copied;
    }
    c->even[set_of(s->parent, c->list[first].sheet)] |= copied > 0 && copied % 2 == 0;
    first += count;
  }
  size_t kept = 0;
  for (size_t n = 0; n < c->count; n++) {
    if (s->times[c->list[n].sheet] > 1) {
      c->list[kept++] = c->list[n];
    }
  }
  c->count = kept;
}

/* Mark sheets that are there several times; of copies the first one. */
static void find_members(surface *s, copies *c, const sepax_body *body) {
  for (uint32_t n = 0; n < s->count; n++) {
    uint32_t part = set_of(s->parent, n);
    uint32_t sheet = set_of(c->all.of, n);
    if (c->joint[part] && s->times[sheet] == 1 && !c->flat[n] && is_covered(c, body, n)) {
      c->member[sheet] = 1;
      c->even[part] = true;
      s->times[sheet] = 0;
    }
  }
  for (size_t first = 0; first < c->count; first += equal_sheets(c, first, false)) {
    uint32_t sheet = c->list[first].sheet;
    c->member[sheet] = c->even[set_of(s->parent, sheet)];
  }
}

/* If a part has several closed surfaces, then it is not known how often each is there: one may fill
 * another, or stand in it. False without memory. */
static bool find_several(surface *s) {
  uint64_t *first = sepax__zeroed(s->count, sizeof *first);
  if (first == NULL) {
    return false;
  }
  for (uint32_t n = 0; n < s->count; n++) {
    uint64_t *word = &first[set_of(s->parent, n)];
    if (s->word[n] != 0) {
      s->times[n] = *word != 0 && *word != s->word[n] ? 0 : s->times[n];
      *word = *word != 0 ? *word : s->word[n];
    }
  }
  sepax_release(first);
  return true;
}

/* Find the words. Sheets that are there several times, but in no closed surface, do not count. */
static bool find_words(surface *s, copies *c) {
  size_t kept = 0;
  for (size_t n = 0; n < c->all.borders; n++) {
    if (c->member[c->all.border[n].sheet]) {
      c->all.border[kept++] = c->all.border[n];
    }
  }
  for (uint32_t n = 0; n < s->count; n++) {
    s->times[n] |= c->member[n] ? SOLID_MEMBER : 0;
  }
  if (!sepax__find_cycles(s, c->all.border, kept, c->all.places, c->member, s->word, s->tangled)) {
    return false;
  }
  for (uint32_t n = 0; n < s->count; n++) {
    bool lost = (s->times[n] & SOLID_MEMBER) != 0 && !c->member[n];
    s->times[n] = lost ? SOLID_MEMBER : s->times[n] & ~SOLID_MEMBER;
  }
  if (!find_several(s)) {
    return false;
  }
  uint64_t pairs = 0;
  for (size_t first = 0; first < c->count;) {
    size_t count = equal_sheets(c, first, false);
    uint32_t sheet = c->list[first].sheet;
    uint32_t part = set_of(s->parent, sheet);
    for (size_t n = 1; n < count; n++) {
      uint64_t word = c->even[part] ? word_of(2 * pairs++ + 1) : 0;
      s->word[sheet] ^= word;
      s->word[c->list[first + n].sheet] ^= word;
      s->times[c->list[first + n].sheet] = s->times[sheet];
    }
    first += count;
  }
  return true;
}

static bool find(surface *s, const sepax_body *body, copies *c) {
  if (!sepax__find_sheets(s, &c->all)) {
    return false;
  }
  c->list = sepax_allocate(s->count * sizeof *c->list);
  c->joint = sepax__zeroed(s->count, sizeof *c->joint);
  c->even = sepax__zeroed(s->count, sizeof *c->even);
  c->flat = sepax_allocate(s->count * sizeof *c->flat);
  c->member = sepax__zeroed(s->count, sizeof *c->member);
  s->times = sepax_allocate(s->count * sizeof *s->times);
  s->word = sepax__zeroed(s->count, sizeof *s->word);
  s->tangled = sepax__zeroed(s->count, sizeof *s->tangled);
  if (c->list == NULL || c->joint == NULL || c->even == NULL || c->flat == NULL ||
      c->member == NULL || s->times == NULL || s->word == NULL || s->tangled == NULL) {
    return false;
  }
  for (size_t n = 0; n < s->count; n++) {
    c->flat[n] = is_flat(body->triangle[n]);
  }
  if (!list_triangles(s, c) || !list_bounded(s, c) || !join_torn(s, c)) {
    return false;
  }
  count_copies(s, c, body);
  find_members(s, c, body);
  if (!find_words(s, c)) {
    return false;
  }
  for (uint32_t n = 0; n < s->count; n++) {
    uint32_t sheet = set_of(c->all.of, n);
    s->times[n] = c->flat[n] ? SOLID_MEMBER : s->times[sheet];
    s->word[n] = s->word[sheet];
    s->tangled[n] = s->tangled[sheet];
  }
  return true;
}

bool sepax__find_copies(surface *s, const sepax_body *body) {
  copies c = {0};
  bool ok = !s->crowded || find(s, body, &c);
  sepax__free_sheets(&c.all);
  sepax_release(c.list);
  sepax_release(c.joint);
  sepax_release(c.even);
  sepax_release(c.flat);
  sepax_release(c.begin);
  sepax_release(c.triangle);
  sepax_release(c.member);
  return ok;
}
