/* SPDX-License-Identifier: MIT */
/* weld_copies.c - leaves out triangles of a welded mesh that are copies, or edges or vertices of
 * others.
 *
 * Copies have the same three vertices. If their number is odd, then one of them has the same edges,
 * modulo two, as all of them. If it is even, then keeping one opens edges or closes them: two
 * sheets that lie on each other are closed with two, but a triangle of a shell that occurs twice is
 * closed with one. All copies that share edges are decided together. */
#include "mesh/weld.h"
#include "util/hash.h"
#include "util/memory.h"

#include <string.h>

enum { NONE = UINT32_MAX };

typedef struct {
  uint32_t first;   /* the first of the triangles */
  uint32_t ways[2]; /* number of copies that run from the least vertex to the next one; number of
                       copies that run back */
  uint32_t keep[2]; /* number of them to keep */
  uint32_t parent;
  size_t open[2]; /* open edges if all copies are kept; if one is kept */
} copies;

typedef struct {
  uint32_t *of;  /* the group of copies of each triangle */
  copies *group; /* sorted by their first triangles */
  uint32_t groups;
} sorted;

/* Sort the vertices of a triangle by their coordinates. Returns true if that turns the triangle
 * round. */
static bool put_in_order(const welding *w, const uint32_t c[3], uint32_t key[3]) {
  bool back = false;
  memcpy(key, c, 3 * sizeof *key);
  for (int k = 0; k < 3; k++) {
    int i = k == 1; /* 0 and 1, 1 and 2, 0 and 1 */
    if (weld_below(w->vertex[key[i + 1]], w->vertex[key[i]])) {
      uint32_t one = key[i];
      key[i] = key[i + 1];
      key[i + 1] = one;
      back = !back;
    }
  }
  return back;
}

static bool find_copies(const welding *w, sorted *s) {
  size_t slots = 16;
  while (slots < 2 * w->count) {
    slots *= 2;
  }
  uint32_t *slot = sepax__zeroed(slots, sizeof *slot);
  s->of = sepax_allocate(w->count * sizeof *s->of);
  s->group = sepax_allocate(w->count * sizeof *s->group);
  bool ok = slot != NULL && s->of != NULL && s->group != NULL;
  for (uint32_t n = 0; n < w->count && ok; n++) {
    uint32_t key[3];
    uint32_t other[3];
    bool back = put_in_order(w, w->corner[n], key);
    uint64_t hash = 0;
    for (int k = 0; k < 3; k++) {
      hash = hash_add(hash, key[k]);
    }
    size_t at = (size_t)hash & (slots - 1);
    for (; slot[at] != 0; at = (at + 1) & (slots - 1)) {
      put_in_order(w, w->corner[s->group[slot[at] - 1].first], other);
      if (memcmp(key, other, sizeof key) == 0) {
        break;
      }
    }
    if (slot[at] == 0) {
      s->group[s->groups] = (copies){.first = n, .parent = s->groups};
      slot[at] = ++s->groups;
    }
    s->of[n] = slot[at] - 1;
    s->group[s->of[n]].ways[back]++;
  }
  sepax_release(slot);
  return ok;
}

static uint32_t root_of(copies *group, uint32_t n) {
  while (group[n].parent != n) {
    n = group[n].parent = group[group[n].parent].parent;
  }
  return n;
}

static bool is_even(const copies *c) { return (c->ways[0] + c->ways[1]) % 2 == 0; }

/* Count what is open at one edge by both choices. */
static void judge_edge(sorted *s, const weld_edge *e, size_t count) {
  size_t one = 0;
  uint32_t root = NONE;
  for (size_t n = 0; n < count; n++) {
    uint32_t of = s->of[e[n].triangle];
    if (!is_even(&s->group[of])) {
      one++;
      continue;
    }
    one += s->group[of].first == e[n].triangle;
    uint32_t other = root_of(s->group, of);
    root = root == NONE ? other : root;
    if (other != root) {
      s->group[other].parent = root;
      s->group[root].open[0] += s->group[other].open[0];
      s->group[root].open[1] += s->group[other].open[1];
    }
  }
  if (root != NONE) {
    s->group[root].open[0] += count % 2;
    s->group[root].open[1] += one % 2;
  }
}

static bool same_edge(const weld_edge *p, const weld_edge *q) {
  return p->low == q->low && p->high == q->high;
}

/* Choose how many copies of each direction to keep. */
static void choose(sorted *s, uint32_t n) {
  copies *c = &s->group[n];
  const copies *root = &s->group[root_of(s->group, n)];
  bool two = is_even(c) && root->open[0] < root->open[1];
  bool back = c->ways[1] > c->ways[0];
  c->keep[back] = 1;
  c->keep[!back] = two && c->ways[!back] > 0;
  c->keep[back] += two && c->ways[!back] == 0;
}

/* True if the triangle is an edge or a vertex of a triangle with an area. */
static bool is_held(const uint32_t c[3], const weld_edge *edge, size_t edges, const uint8_t *held) {
  uint32_t p = c[0];
  uint32_t q = c[0] != c[1] ? c[1] : c[2];
  if (p == q) {
    return held[p] != 0;
  }
  weld_edge key = {p < q ? p : q, p < q ? q : p, 0};
  size_t low = 0;
  size_t high = edges;
  while (low < high) {
    size_t middle = low + (high - low) / 2;
    const weld_edge *e = &edge[middle];
    bool before = e->low < key.low || (e->low == key.low && e->high < key.high);
    low = before ? middle + 1 : low;
    high = before ? high : middle;
  }
  return low < edges && same_edge(&edge[low], &key);
}

/* Leave out triangles with two equal vertices if others have the same edge or vertex. */
static weld_result leave_out_segments(welding *w) {
  welding whole = *w;
  size_t edges = 0;
  size_t lost = 0;
  for (size_t n = 0; n < w->count; n++) {
    lost += weld_no_area(w->corner[n]);
  }
  if (lost == 0) {
    return WELD_DONE;
  }
  whole.count -= lost;
  whole.corner = sepax_allocate((whole.count + 1) * sizeof *whole.corner);
  uint8_t *held = sepax__zeroed(w->vertices, 1);
  weld_edge *edge = NULL;
  if (whole.corner != NULL && held != NULL) {
    size_t to = 0;
    for (size_t n = 0; n < w->count; n++) {
      if (!weld_no_area(w->corner[n])) {
        memcpy(whole.corner[to++], w->corner[n], sizeof *w->corner);
        held[w->corner[n][0]] = held[w->corner[n][1]] = held[w->corner[n][2]] = 1;
      }
    }
    edge = sepax__weld_edges(&whole, &edges);
  }
  size_t kept = 0;
  for (size_t n = 0; n < w->count && edge != NULL; n++) {
    if (weld_no_area(w->corner[n]) && is_held(w->corner[n], edge, edges, held)) {
      w->said.degenerate++;
    } else {
      memmove(w->corner[kept++], w->corner[n], sizeof *w->corner);
    }
  }
  w->count = edge != NULL ? kept : w->count;
  sepax_release(whole.corner);
  sepax_release(held);
  sepax_release(edge);
  return edge != NULL ? WELD_DONE : WELD_MEMORY;
}

static weld_result leave_out_copies(welding *w) {
  sorted s = {0};
  size_t edges = 0;
  weld_edge *edge = NULL;
  bool ok = find_copies(w, &s);
  if (ok && s.groups < w->count) {
    edge = sepax__weld_edges(w, &edges);
    ok = edge != NULL;
    for (size_t first = 0; first < edges && ok;) {
      size_t end = first;
      while (end < edges && same_edge(&edge[first], &edge[end])) {
        end++;
      }
      judge_edge(&s, &edge[first], end - first);
      first = end;
    }
    for (uint32_t n = 0; n < s.groups && ok; n++) {
      choose(&s, n);
    }
    size_t kept = 0;
    for (size_t n = 0; n < w->count && ok; n++) {
      uint32_t key[3];
      uint32_t *keep = &s.group[s.of[n]].keep[put_in_order(w, w->corner[n], key)];
      if (*keep > 0) {
        --*keep;
        memmove(w->corner[kept++], w->corner[n], sizeof *w->corner);
      } else {
        w->said.duplicates++;
      }
    }
    w->count = ok ? kept : w->count;
  }
  sepax_release(s.of);
  sepax_release(s.group);
  sepax_release(edge);
  return ok ? WELD_DONE : WELD_MEMORY;
}

weld_result sepax__weld_leave_out(welding *w) {
  weld_result result = leave_out_segments(w);
  return result == WELD_DONE ? leave_out_copies(w) : result;
}
