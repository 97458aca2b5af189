/* SPDX-License-Identifier: MIT */
/* search.c - the way of one net, pin by pin, on the cheapest nodes (A*); see router.h. */
#include "layout/route/router.h"
#include "liberty/text.h"

#include <stdlib.h>
#include <string.h>

/* In units of words.h: what a via is worth, and one whose pad goes beyond its pin. */
enum { VIA_COST = 500, BEYOND_COST = 1000 };

/* What of a net is there already, from which the search goes on. */
typedef struct {
  uint32_t *node;
  int nodes;
} tree;

/* ---------------------------------------------------------------------- the queue */

static void push(heap *h, uint32_t cost, uint32_t node) {
  h->item = text_more(h->item, h->count, sizeof *h->item);
  uint64_t it = (uint64_t)cost << 32 | node;
  size_t k = h->count++;
  for (; k > 0 && h->item[(k - 1) / 2] > it; k = (k - 1) / 2) {
    h->item[k] = h->item[(k - 1) / 2];
  }
  h->item[k] = it;
}

static uint64_t pop(heap *h) {
  uint64_t least = h->item[0], last = h->item[--h->count];
  size_t k = 0;
  for (size_t child; (child = 2 * k + 1) < h->count; k = child) {
    child += child + 1 < h->count && h->item[child + 1] < h->item[child];
    if (h->item[child] >= last) {
      break;
    }
    h->item[k] = h->item[child];
  }
  h->item[k] = last;
  return least;
}

/* ---------------------------------------------------------------------- search */

static uint32_t ban_cost(const router *r, uint32_t node, int kind) {
  return (uint32_t)(r->claims[kind][node] * r->price);
}

typedef struct {
  router *r;
  int id;
  const access_list *pin; /* sought */
  box window, aim;
  uint32_t best, best_node; /* of the goals so far */
} search;

static uint32_t distance_to(const search *s, place at) {
  int i = at.i < s->aim.i0 ? s->aim.i0 - at.i : at.i > s->aim.i1 ? at.i - s->aim.i1 : 0;
  int j = at.j < s->aim.j0 ? s->aim.j0 - at.j : at.j > s->aim.j1 ? at.j - s->aim.j1 : 0;
  return (uint32_t)(i * s->r->g.step_x + j * s->r->g.step_y);
}

/* Of a via down to the pin. */
static uint32_t landing_cost(const router *r, const access *a) {
  return a->via == NULL ? 0
                        : VIA_COST + ban_cost(r, a->node, PAD_BELOW) +
                              (a->covered ? 0 : BEYOND_COST + ban_cost(r, a->node, PAD_ON_PIN));
}

static const access *access_at(const access_list *pin, uint32_t node) {
  for (int k = 0; k < pin->count; k++) {
    if (pin->at[k].node == node) {
      return &pin->at[k];
    }
  }
  return NULL;
}

static void reach(search *s, uint32_t node, uint32_t cost, int from) {
  router *r = s->r;
  if (r->stamp[node] == r->stamps && r->cost[node] <= cost) {
    return;
  }
  r->stamp[node] = r->stamps;
  r->cost[node] = cost;
  r->from[node] = (uint8_t)from;
  if (r->goal[node] == r->stamps) {
    uint32_t all = cost + landing_cost(r, access_at(s->pin, node));
    if (all < s->best) {
      s->best = all, s->best_node = node;
    }
  }
  push(&r->queue, cost + distance_to(s, grid_place(&r->g, node)), node);
}

static void try_wire(search *s, uint32_t node, place at, int i, int j, int from, uint32_t step) {
  router *r = s->r;
  if (at.i + i < s->window.i0 || at.i + i > s->window.i1 || at.j + j < s->window.j0 ||
      at.j + j > s->window.j1) {
    return;
  }
  uint32_t to = (uint32_t)((int64_t)node + i + (int64_t)j * r->g.columns);
  reach(s, to, r->cost[node] + step + ban_cost(r, to, WIRE) + r->history[to], from);
}

static void try_via(search *s, uint32_t node, place at, int up) {
  router *r = s->r;
  const grid *g = &r->g;
  int lower = up > 0 ? at.layer : at.layer - 1;
  if (lower < 0 || lower + 1 >= g->layers || !grid_crosses(g, lower, at)) {
    return;
  }
  uint32_t to = (uint32_t)((int64_t)node + up * (int64_t)g->columns * g->rows);
  uint32_t low = up > 0 ? node : to, high = up > 0 ? to : node;
  if (r->cuts[low] == (uint32_t)s->id + 1) {
    return;
  }
  uint32_t cost = r->cost[node] + VIA_COST + ban_cost(r, low, PAD_ABOVE) +
                  ban_cost(r, high, PAD_BELOW) + ban_cost(r, to, WIRE) + r->history[to];
  reach(s, to, cost, up > 0 ? FROM_BELOW : FROM_ABOVE);
}

/* From the nodes in the queue to the nearest goal; false if there is no way. */
static bool find(search *s) {
  router *r = s->r;
  while (r->queue.count > 0) {
    uint64_t top = pop(&r->queue);
    uint32_t node = (uint32_t)top, estimate = (uint32_t)(top >> 32);
    if (estimate >= s->best) {
      break;
    }
    place at = grid_place(&r->g, node);
    if (estimate > r->cost[node] + distance_to(s, at)) {
      continue;
    }
    if (r->g.layer[at.layer].vertical) {
      try_wire(s, node, at, 0, 1, FROM_LESS, (uint32_t)r->g.step_y);
      try_wire(s, node, at, 0, -1, FROM_MORE, (uint32_t)r->g.step_y);
    } else {
      try_wire(s, node, at, 1, 0, FROM_LESS, (uint32_t)r->g.step_x);
      try_wire(s, node, at, -1, 0, FROM_MORE, (uint32_t)r->g.step_x);
    }
    try_via(s, node, at, 1);
    try_via(s, node, at, -1);
  }
  r->queue.count = 0;
  return s->best != UINT32_MAX;
}

/* ---------------------------------------------------------------------- one net */

static void add_use(path *p, uint32_t node, int kind) {
  p->use = text_more(p->use, (size_t)p->uses, sizeof *p->use);
  p->use[p->uses++] = (use){node, (uint8_t)kind};
}

static void add_node(tree *t, uint32_t node) {
  t->node = text_more(t->node, (size_t)t->nodes, sizeof *t->node);
  t->node[t->nodes++] = node;
}

/* No via of this net so near to another of its own that their cuts are too near. */
static void mark_cuts(router *r, int id, uint32_t low) {
  const grid *g = &r->g;
  place at = grid_place(g, low);
  const bans *b = &g->cuts[at.layer];
  for (int k = 0; k < b->count; k++) {
    int i = at.i + b->ban[k].i, j = at.j + b->ban[k].j;
    if (i >= 0 && j >= 0 && i < g->columns && j < g->rows) {
      r->cuts[grid_node(g, at.layer, i, j)] = (uint32_t)id + 1;
    }
  }
}

/* The node from which the search came to one. */
static uint32_t before(const router *r, uint32_t node) {
  int64_t along = r->g.layer[grid_place(&r->g, node).layer].vertical ? r->g.columns : 1;
  int64_t slab = (int64_t)r->g.columns * r->g.rows;
  int from = r->from[node];
  return (uint32_t)(node + (from == FROM_LESS    ? -along
                            : from == FROM_MORE  ? along
                            : from == FROM_BELOW ? -slab
                                                 : slab));
}

/* The way back from a goal to what was there before, which is returned. */
static uint32_t keep_way(router *r, int id, path *p, uint32_t node, tree *t) {
  while (r->from[node] != FROM_NONE) {
    uint32_t to = before(r, node);
    add_use(p, node, WIRE);
    add_node(t, node);
    if (r->from[node] == FROM_BELOW || r->from[node] == FROM_ABOVE) {
      uint32_t low = node < to ? node : to;
      add_use(p, low, PAD_ABOVE);
      add_use(p, node < to ? to : node, PAD_BELOW);
      mark_cuts(r, id, low);
    } else {
      path_wire(p, to, node);
    }
    node = to;
  }
  return node;
}

box router_box(const router *r, const access_list *pin, int pins, int margin) {
  box b = {r->g.columns, r->g.rows, 0, 0};
  for (int p = 0; p < pins; p++) {
    for (int k = 0; k < pin[p].count; k++) {
      place at = grid_place(&r->g, pin[p].at[k].node);
      b.i0 = at.i < b.i0 ? at.i : b.i0, b.i1 = at.i > b.i1 ? at.i : b.i1;
      b.j0 = at.j < b.j0 ? at.j : b.j0, b.j1 = at.j > b.j1 ? at.j : b.j1;
    }
  }
  b.i0 = b.i0 > margin ? b.i0 - margin : 0, b.j0 = b.j0 > margin ? b.j0 - margin : 0;
  b.i1 = b.i1 + margin < r->g.columns ? b.i1 + margin : r->g.columns - 1;
  b.j1 = b.j1 + margin < r->g.rows ? b.j1 + margin : r->g.rows - 1;
  return b;
}

/* The pin that is reached at a node. */
static void land(router *r, path *p, int id, int pin, uint32_t node) {
  const access *a = access_at(&r->access[r->first[id] + pin], node);
  if (a == NULL) {
    return;
  }
  p->landing[pin] = *a;
  p->reached[pin] = true;
  if (a->via != NULL) {
    add_use(p, node, PAD_BELOW);
  }
  if (!a->covered) {
    add_use(p, node, PAD_ON_PIN);
  }
}

static int gap(int a0, int a1, int b0, int b1) { return a1 < b0 ? b0 - a1 : b1 < a0 ? a0 - b1 : 0; }

/* The pin not reached yet that is nearest to one that is. */
static int next_pin(const router *r, const path *p, int id, const box *of) {
  int best = -1;
  long least = 0;
  int pins = r->d->net[id].pins;
  for (int a = 0; a < pins; a++) {
    for (int b = 0; b < pins && !p->reached[a]; b++) {
      if (!p->reached[b] && !(b == 0)) {
        continue;
      }
      long far = (long)gap(of[a].i0, of[a].i1, of[b].i0, of[b].i1) * r->g.step_x +
                 (long)gap(of[a].j0, of[a].j1, of[b].j0, of[b].j1) * r->g.step_y;
      if (a != 0 && (best < 0 || far < least)) {
        best = a, least = far;
      }
    }
  }
  return best;
}

/* Lead the tree to a pin; false if there is no way. At first it is the driver. */
static bool lead(search *s, path *p, tree *t, int pin, const box *aim) {
  router *r = s->r;
  const access_list *of = &r->access[r->first[s->id]];
  r->stamps++;
  s->best = UINT32_MAX;
  s->pin = &of[pin];
  s->aim = *aim;
  for (int k = 0; k < of[pin].count; k++) {
    r->goal[of[pin].at[k].node] = r->stamps;
  }
  for (int k = 0; k < of[0].count && t->nodes == 0; k++) {
    const access *a = &of[0].at[k];
    reach(s, a->node, landing_cost(r, a) + ban_cost(r, a->node, WIRE), FROM_NONE);
  }
  for (int k = 0; k < t->nodes; k++) {
    reach(s, t->node[k], 0, FROM_NONE);
  }
  if (!find(s)) {
    return false;
  }
  bool first = t->nodes == 0;
  uint32_t root = keep_way(r, s->id, p, s->best_node, t);
  if (first) {
    add_use(p, root, WIRE);
    add_node(t, root);
    land(r, p, s->id, 0, root);
  }
  land(r, p, s->id, pin, s->best_node);
  return true;
}

void search_net(router *r, int id, int margin) {
  path *p = &r->path[id];
  int pins = r->d->net[id].pins;
  const access_list *pin = &r->access[r->first[id]];
  box *boxes = text_alloc((size_t)pins, sizeof *boxes);
  for (int k = 0; k < pins; k++) {
    boxes[k] = router_box(r, &pin[k], 1, 0);
  }
  p->uses = 0, p->wires = 0;
  memset(p->reached, 0, (size_t)pins * sizeof *p->reached);
  tree t = {0};
  search s = {.r = r, .id = id, .window = router_box(r, pin, pins, margin)};
  for (int next; (next = next_pin(r, p, id, boxes)) >= 0 && lead(&s, p, &t, next, &boxes[next]);) {}
  for (int k = 0; k < p->uses; k++) { /* no marks are left for the next time */
    if (p->use[k].kind == PAD_ABOVE) {
      mark_cuts(r, -1, p->use[k].node);
    }
  }
  free(t.node);
  free(boxes);
}
