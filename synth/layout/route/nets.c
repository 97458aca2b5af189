/* SPDX-License-Identifier: MIT */
/* nets.c - see nets.h. */
#include "layout/route/nets.h"
#include "layout/route/router.h"
#include "liberty/text.h"

#include <err.h>
#include <stdio.h>
#include <stdlib.h>

/* Tracks beyond a net's pins where it is sought, more in each round; the price of a ban. */
enum { MARGIN = 12, FIRST_PRICE = 200, LAST_PRICE = 3000 };

static bool is_routed(const net *n) { return n->pins > 1; }

static bool is_whole(const router *r, int id) {
  for (int p = 0; p < r->d->net[id].pins; p++) {
    if (!r->path[id].reached[p]) {
      return false;
    }
  }
  return true;
}

static box net_box(const router *r, int id) {
  return router_box(r, &r->access[r->first[id]], r->d->net[id].pins, 0);
}

static const router *ordered; /* by qsort */

static int by_size(const void *a, const void *b) {
  box p = net_box(ordered, *(const int *)a), q = net_box(ordered, *(const int *)b);
  int c = p.i1 - p.i0 + p.j1 - p.j0, e = q.i1 - q.i0 + q.j1 - q.j0;
  return c != e ? (c > e) - (c < e) : *(const int *)a - *(const int *)b;
}

/* Seek again what is not whole or too near to others; how many nets that was. */
static int one_round(router *r, const int *order, int nets, int round) {
  int sought = 0;
  for (int k = 0; k < nets; k++) {
    int id = order[k];
    path *p = &r->path[id];
    claim_path(r, p, -1);
    bool near = claim_clash(r, p), own = claim_own_clash(r, p);
    if (round == 0 || near || own || !is_whole(r, id)) {
      search_net(r, id, MARGIN * (round + 1));
      sought++;
    }
    claim_path(r, p, 1);
  }
  return sought;
}

static void add_segment(net *n, segment s) {
  n->route = text_more(n->route, (size_t)n->segments, sizeof *n->route);
  n->route[n->segments++] = s;
}

static bool has_wire(const path *p, uint32_t a, uint32_t b) {
  for (int w = 0; w < p->wires; w += 2) {
    if ((p->wire[w] == a && p->wire[w + 1] == b) || (p->wire[w] == b && p->wire[w + 1] == a)) {
      return true;
    }
  }
  return false;
}

/* Wires of the same net that are too near and not joined are joined along their track. */
static void join_near(const router *r, path *p) {
  const grid *g = &r->g;
  int uses = p->uses;
  for (int a = 0; a < uses; a++) {
    place at = grid_place(g, p->use[a].node);
    const bans *b = &g->bans[at.layer][p->use[a].kind];
    for (int c = 0; c < uses; c++) {
      place to = grid_place(g, p->use[c].node);
      bool vertical = g->layer[at.layer].vertical;
      int far = vertical ? to.j - at.j : to.i - at.i;
      if (to.layer != at.layer || far <= 0 || (vertical ? to.i != at.i : to.j != at.j)) {
        continue;
      }
      for (int k = 0; k < b->count; k++) {
        if (b->ban[k].i == to.i - at.i && b->ban[k].j == to.j - at.j &&
            b->ban[k].kind == p->use[c].kind) {
          uint32_t step = vertical ? (uint32_t)g->columns : 1, node = p->use[a].node;
          for (; node != p->use[c].node; node += step) {
            if (!has_wire(p, node, node + step)) {
              path_wire(p, node, node + step);
            }
          }
          break;
        }
      }
    }
  }
}

/* Pieces of wire in the order of layers, tracks and places on them. */
static int by_track(const void *a, const void *b) {
  place p = grid_place(&ordered->g, *(const uint32_t *)a);
  place q = grid_place(&ordered->g, *(const uint32_t *)b);
  bool vertical = ordered->g.layer[p.layer].vertical;
  int track = vertical ? p.i - q.i : p.j - q.j, along = vertical ? p.j - q.j : p.i - q.i;
  return p.layer != q.layer ? p.layer - q.layer : track != 0 ? track : along;
}

/* Wires as long as they are straight. */
static void write_wires(const grid *g, path *p, net *n) {
  for (int w = 0; w < p->wires; w += 2) {
    if (p->wire[w] > p->wire[w + 1]) {
      uint32_t less = p->wire[w + 1];
      p->wire[w + 1] = p->wire[w], p->wire[w] = less;
    }
  }
  qsort(p->wire, (size_t)p->wires / 2, 2 * sizeof *p->wire, by_track);
  for (int w = 0; w < p->wires;) {
    uint32_t from = p->wire[w], to = p->wire[w + 1];
    bool vertical = g->layer[grid_place(g, from).layer].vertical;
    uint32_t step = vertical ? (uint32_t)g->columns : 1;
    for (w += 2; w < p->wires && p->wire[w] == to && p->wire[w + 1] == to + step; w += 2) {
      to = p->wire[w + 1];
    }
    place a = grid_place(g, from), b = grid_place(g, to);
    add_segment(n, (segment){g->layer[a.layer].metal, grid_x(g, a.i), grid_y(g, a.j),
                             grid_x(g, b.i), grid_y(g, b.j), NULL});
  }
}

static void write_route(router *r, int k) {
  const grid *g = &r->g;
  path *p = &r->path[k];
  net *n = &r->d->net[k];
  join_near(r, p);
  write_wires(g, p, n);
  for (int u = 0; u < p->uses; u++) {
    place at = grid_place(g, p->use[u].node);
    if (p->use[u].kind == PAD_ABOVE) {
      add_segment(n, (segment){g->layer[at.layer].metal, grid_x(g, at.i), grid_y(g, at.j),
                               grid_x(g, at.i), grid_y(g, at.j), g->layer[at.layer].via});
    }
  }
  for (int pin = 0; pin < n->pins; pin++) {
    if (p->reached[pin] && p->landing[pin].via != NULL) {
      place at = grid_place(g, p->landing[pin].node);
      add_segment(n, (segment){g->first_metal, grid_x(g, at.i), grid_y(g, at.j), grid_x(g, at.i),
                               grid_y(g, at.j), p->landing[pin].via});
    }
  }
}

static void prepare(router *r, design *d, int top) {
  r->d = d;
  r->g = grid_make(d, top);
  size_t nodes = (size_t)r->g.layers * (size_t)r->g.columns * (size_t)r->g.rows;
  for (int k = 0; k < KINDS; k++) {
    r->claims[k] = text_alloc(nodes, sizeof *r->claims[k]);
  }
  r->history = text_alloc(nodes, sizeof *r->history);
  r->cost = text_alloc(nodes, sizeof *r->cost);
  r->stamp = text_alloc(nodes, sizeof *r->stamp);
  r->goal = text_alloc(nodes, sizeof *r->goal);
  r->cuts = text_alloc(nodes, sizeof *r->cuts);
  r->from = text_alloc(nodes, 1);
  r->path = text_alloc((size_t)d->nets, sizeof *r->path);
  r->first = text_alloc((size_t)d->nets, sizeof *r->first);
  r->access = access_find(d, &r->g, r->first);
  for (int k = 0; k < d->nets; k++) {
    r->path[k].landing = text_alloc((size_t)d->net[k].pins, sizeof *r->path[k].landing);
    r->path[k].reached = text_alloc((size_t)d->net[k].pins, sizeof *r->path[k].reached);
  }
}

int route_nets(design *d, int top, int rounds) {
  router r = {0};
  prepare(&r, d, top);
  int *order = text_alloc((size_t)d->nets, sizeof *order), nets = 0, failed = 0;
  for (int k = 0; k < d->nets; k++) {
    if (is_routed(&d->net[k])) {
      order[nets++] = k;
    }
  }
  ordered = &r;
  qsort(order, (size_t)nets, sizeof *order, by_size);
  r.price = FIRST_PRICE;
  for (int round = 0, sought = 1; round < rounds && sought > 0; round++) {
    sought = one_round(&r, order, nets, round);
    fprintf(stderr, "round %d: %d of %d nets sought\n", round, sought, nets);
    r.price = r.price < LAST_PRICE ? r.price + r.price / 4 : r.price;
  }
  for (int k = 0; k < nets; k++) {
    path *p = &r.path[order[k]];
    claim_path(&r, p, -1);
    bool near = claim_clash(&r, p) || claim_own_clash(&r, p), open = !is_whole(&r, order[k]);
    claim_path(&r, p, 1);
    if (near || open) {
      failed++;
      warnx("%s: %s", d->net[order[k]].name,
            open ? "a pin without a wire" : "too near to another net");
    }
  }
  for (int k = 0; k < nets; k++) {
    write_route(&r, order[k]);
  }
  ordered = NULL;
  return failed;
}
