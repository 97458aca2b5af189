/* SPDX-License-Identifier: MIT */
/* claims.c - bans of what is near a route; see router.h. */
#include "layout/route/router.h"
#include "liberty/text.h"

enum { DEARER = 1000, HIGHEST = 60000 };

static void claim(router *r, const use *u, int by) {
  const grid *g = &r->g;
  place at = grid_place(g, u->node);
  const bans *b = &g->bans[at.layer][u->kind];
  for (int k = 0; k < b->count; k++) {
    int i = at.i + b->ban[k].i, j = at.j + b->ban[k].j;
    if (i >= 0 && j >= 0 && i < g->columns && j < g->rows) {
      uint16_t *it = &r->claims[b->ban[k].kind][grid_node(g, at.layer, i, j)];
      *it = (uint16_t)(*it + by);
    }
  }
}

void claim_path(router *r, const path *p, int by) {
  for (int k = 0; k < p->uses; k++) {
    claim(r, &p->use[k], by);
  }
}

static void make_dearer(router *r, uint32_t node) {
  uint16_t *h = &r->history[node];
  *h = (uint16_t)(*h < HIGHEST ? *h + DEARER : *h);
}

bool claim_clash(router *r, const path *p) {
  bool clash = false;
  for (int k = 0; k < p->uses; k++) {
    if (r->claims[p->use[k].kind][p->use[k].node] > 0) {
      make_dearer(r, p->use[k].node);
      clash = true;
    }
  }
  return clash;
}

bool claim_own_clash(router *r, const path *p) {
  const grid *g = &r->g;
  bool clash = false;
  for (int a = 0; a < p->uses; a++) {
    place at = grid_place(g, p->use[a].node);
    const bans *b = &g->cuts[at.layer];
    for (int c = 0; c < p->uses && p->use[a].kind == PAD_ABOVE; c++) {
      place to = grid_place(g, p->use[c].node);
      for (int k = 0; k < b->count && p->use[c].kind == PAD_ABOVE && to.layer == at.layer; k++) {
        if (b->ban[k].i == to.i - at.i && b->ban[k].j == to.j - at.j) {
          make_dearer(r, p->use[c].node);
          clash = true;
        }
      }
    }
  }
  return clash;
}

void path_wire(path *p, uint32_t a, uint32_t b) {
  p->wire = text_more(p->wire, (size_t)p->wires, sizeof *p->wire);
  p->wire[p->wires++] = a;
  p->wire = text_more(p->wire, (size_t)p->wires, sizeof *p->wire);
  p->wire[p->wires++] = b;
}
