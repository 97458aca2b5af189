/* SPDX-License-Identifier: MIT */
/* grid.c - see grid.h. */
#include "layout/route/grid.h"

#include <err.h>
#include <stdlib.h>

void grid_extent(const lef_via *via, int layer, int *x, int *y) {
  *x = *y = 0;
  for (int k = 0; k < via->shape.rects; k++) {
    const lef_rect *r = &via->shape.rect[k];
    if (r->layer == layer) {
      *x = abs(r->x0) > *x ? abs(r->x0) : *x, *x = abs(r->x1) > *x ? abs(r->x1) : *x;
      *y = abs(r->y0) > *y ? abs(r->y0) : *y, *y = abs(r->y1) > *y ? abs(r->y1) : *y;
    }
  }
}

/* Across its track a via should be narrow; then small. */
static long badness(const lef *l, const lef_via *via, int lower, int upper) {
  int x, y, u, v;
  grid_extent(via, lower, &x, &y);
  grid_extent(via, upper, &u, &v);
  if (x == 0 || u == 0) {
    return -1;
  }
  long across = (l->layer[lower].vertical ? x : y) + (l->layer[upper].vertical ? u : v);
  return across * 1000000 + (long)x * y + (long)u * v;
}

static const lef_via *best_via(const lef *l, int lower, int upper) {
  const lef_via *best = NULL;
  long least = 0;
  for (int k = 0; k < l->vias; k++) {
    long bad = badness(l, &l->via[k], lower, upper);
    if (bad >= 0 && (best == NULL || bad < least)) {
      best = &l->via[k], least = bad;
    }
  }
  if (best == NULL) {
    errx(2, "the LEF files have no via from %s to %s", l->layer[lower].name, l->layer[upper].name);
  }
  return best;
}

static int cut_between(const lef *l, int lower) {
  return lower + 1 < l->layers && !l->layer[lower + 1].metal ? lower + 1 : -1;
}

/* Whether two rectangles, given by half their sides, are nearer than `least`, dx and dy away. */
static bool too_near(int x0, int y0, int x1, int y1, int dx, int dy, int least) {
  long gap_x = abs(dx) - x0 - x1, gap_y = abs(dy) - y0 - y1;
  if (gap_x > 0 && gap_y > 0) {
    return gap_x * gap_x + gap_y * gap_y < (long)least * least;
  }
  return gap_x < least && gap_y < least;
}

static void add_ban(bans *b, int i, int j, int kind) {
  if (b->count == GRID_BANS) {
    errx(2, "the LEF files' distances are too long for their pitch");
  }
  b->ban[b->count++] = (ban){i, j, kind};
}

/* Half the width, across its track, of a via's pad on the second metal. */
static int landing(const lef *l, const grid *g, const lef_via *via) {
  int x, y, low_x, low_y;
  grid_extent(via, g->layer[0].metal, &x, &y);
  grid_extent(via, g->first_metal, &low_x, &low_y);
  return low_x == 0 ? 0 : l->layer[g->layer[0].metal].vertical ? x : y;
}

bool grid_lands(const lef *l, const grid *g, const lef_via *via) {
  return landing(l, g, via) > 0 &&
         landing(l, g, via) == landing(l, g, best_via(l, g->first_metal, g->layer[0].metal));
}

/* Half the sides of a kind of shape in a layer; false where there is none. */
static bool shape_of(const design *d, const grid *g, int k, int kind, int *x, int *y) {
  const lef_layer *l = &d->lib->layer[g->layer[k].metal];
  *x = *y = l->width / 2;
  if (kind == WIRE) {
    return true;
  }
  if (kind == PAD_ON_PIN) { /* the largest */
    for (int v = 0, u, w; v < d->lib->vias && k == 0; v++) {
      grid_extent(&d->lib->via[v], g->first_metal, &u, &w);
      if (grid_lands(d->lib, g, &d->lib->via[v])) {
        *x = u > *x ? u : *x, *y = w > *y ? w : *y;
      }
    }
    return k == 0;
  }
  const lef_via *via = kind == PAD_ABOVE ? g->layer[k].via
                       : k > 0           ? g->layer[k - 1].via
                                         : best_via(d->lib, g->first_metal, g->layer[0].metal);
  if (via == NULL) {
    return false;
  }
  grid_extent(via, g->layer[k].metal, x, y);
  return true;
}

/* Of vias one above the other the cuts count, too: those below, or those above, a layer. */
static bool cuts_near(const design *d, const grid *g, int k, int kind, int dx, int dy) {
  int below =
      kind == PAD_BELOW ? (k > 0 ? g->layer[k - 1].metal : g->first_metal) : g->layer[k].metal;
  const lef_via *via = kind == PAD_ABOVE ? g->layer[k].via
                       : k > 0           ? g->layer[k - 1].via
                                         : best_via(d->lib, g->first_metal, g->layer[0].metal);
  int cut = cut_between(d->lib, below), x, y;
  if (cut < 0 || via == NULL) {
    return false;
  }
  grid_extent(via, cut, &x, &y);
  return too_near(x, y, x, y, dx, dy, d->lib->layer[cut].spacing);
}

static void find_bans(const design *d, grid *g, int k) {
  for (int a = 0; a < KINDS; a++) {
    for (int b = 0; b < KINDS; b++) {
      int ax, ay, bx, by;
      int least = d->lib->layer[a == PAD_ON_PIN ? g->first_metal : g->layer[k].metal].spacing;
      if ((a == PAD_ON_PIN) != (b == PAD_ON_PIN) || !shape_of(d, g, k, a, &ax, &ay) ||
          !shape_of(d, g, k, b, &bx, &by)) {
        continue;
      }
      for (int i = -4; i <= 4; i++) {
        for (int j = -4; j <= 4; j++) {
          int dx = i * g->step_x, dy = j * g->step_y;
          if (too_near(ax, ay, bx, by, dx, dy, least) ||
              (a == b && (a == PAD_ABOVE || a == PAD_BELOW) && cuts_near(d, g, k, a, dx, dy))) {
            add_ban(&g->bans[k][a], i, j, b);
          }
          if (a == PAD_ABOVE && b == a && (i != 0 || j != 0) && cuts_near(d, g, k, a, dx, dy)) {
            add_ban(&g->cuts[k], i, j, b);
          }
        }
      }
    }
  }
}

grid grid_make(const design *d, int top) {
  const lef *l = d->lib;
  grid g = {.first_metal = -1};
  for (int k = 0, metals = 0; k < l->layers && metals < top; k++) {
    if (!l->layer[k].metal) {
      continue;
    }
    if (metals++ == 0) {
      g.first_metal = k;
    } else if (g.layers < GRID_LAYERS) {
      g.layer[g.layers++] = (grid_layer){.metal = k, .vertical = l->layer[k].vertical};
    }
  }
  if (g.layers < 2 || g.layer[0].vertical == g.layer[1].vertical) {
    errx(2, "the LEF files have no two layers of wires, one across the other");
  }
  const lef_layer *v = &l->layer[g.layer[g.layer[0].vertical ? 0 : 1].metal];
  const lef_layer *h = &l->layer[g.layer[g.layer[0].vertical ? 1 : 0].metal];
  g.step_x = v->pitch, g.offset_x = v->offset;
  g.step_y = h->pitch, g.offset_y = h->offset;
  g.columns = (d->width - g.offset_x) / g.step_x;
  g.rows = (d->height - g.offset_y) / g.step_y;
  if ((double)g.columns * g.rows * g.layers > 4e9) {
    errx(2, "the die is too large");
  }
  for (int k = 0; k < g.layers; k++) {
    const lef_layer *m = &l->layer[g.layer[k].metal];
    int step = g.layer[k].vertical ? g.step_x : g.step_y;
    g.layer[k].stride = (m->width + m->spacing + step - 1) / step;
    g.layer[k].via = k + 1 < g.layers ? best_via(l, g.layer[k].metal, g.layer[k + 1].metal) : NULL;
  }
  for (int k = 0; k < g.layers; k++) {
    find_bans(d, &g, k);
  }
  return g;
}
