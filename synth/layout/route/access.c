/* SPDX-License-Identifier: MIT */
/* access.c - see access.h. */
#include "layout/route/access.h"
#include "liberty/text.h"

#include <err.h>
#include <stdlib.h>

/* A shape of the first metal, and whose it is. */
typedef struct {
  lef_rect rect;
  terminal of; /* pin -1: an obstruction */
} shape;

/* All shapes, by squares of the die that they touch. */
typedef struct {
  int side, columns, rows;
  shape **bin;
  int *count;
} floor_plan;

static void put(floor_plan *f, shape s) {
  for (int i = s.rect.x0 / f->side; i <= s.rect.x1 / f->side; i++) {
    for (int j = s.rect.y0 / f->side; j <= s.rect.y1 / f->side; j++) {
      if (i >= 0 && j >= 0 && i < f->columns && j < f->rows) {
        int b = j * f->columns + i;
        f->bin[b] = text_more(f->bin[b], (size_t)f->count[b], sizeof *f->bin[b]);
        f->bin[b][f->count[b]++] = s;
      }
    }
  }
}

static void put_all(floor_plan *f, const component *c, const lef_shapes *s, terminal of,
                    int metal) {
  for (int k = 0; k < s->rects; k++) {
    if (s->rect[k].layer == metal) {
      put(f, (shape){design_rect(c, &s->rect[k]), of});
    }
  }
}

static floor_plan lay_out(const design *d, int metal) {
  floor_plan f = {.side = d->lib->site_height};
  f.columns = d->width / f.side + 1, f.rows = d->height / f.side + 1;
  f.bin = text_alloc((size_t)f.columns * (size_t)f.rows, sizeof *f.bin);
  f.count = text_alloc((size_t)f.columns * (size_t)f.rows, sizeof *f.count);
  for (int c = 0; c < d->cells; c++) {
    const lef_macro *m = d->cell[c].macro;
    for (int p = 0; p < m->pins; p++) {
      put_all(&f, &d->cell[c], &m->pin[p].shape, (terminal){c, p}, metal);
    }
    put_all(&f, &d->cell[c], &m->obstruction, (terminal){c, -1}, metal);
  }
  return f;
}

static int between(int a0, int a1, int b0, int b1) {
  return a1 < b0 ? b0 - a1 : b1 < a0 ? a0 - b1 : 0;
}

static bool nearer_than(const lef_rect *a, const lef_rect *b, int least) {
  long x = between(a->x0, a->x1, b->x0, b->x1), y = between(a->y0, a->y1, b->y0, b->y1);
  return x * x + y * y < (long)least * least;
}

static bool meets(const lef_rect *a, const lef_rect *b) {
  return a->x0 <= b->x1 && b->x0 <= a->x1 && a->y0 <= b->y1 && b->y0 <= a->y1;
}

/* Whether all of a pad lies within the pin's shapes. */
static bool is_covered(lef_rect pad, const lef_rect *rect, int rects) {
  if (pad.x0 >= pad.x1 || pad.y0 >= pad.y1) {
    return true;
  }
  for (int k = 0; k < rects; k++) {
    const lef_rect *r = &rect[k];
    if (r->x0 >= pad.x1 || r->x1 <= pad.x0 || r->y0 >= pad.y1 || r->y1 <= pad.y0) {
      continue;
    }
    int x0 = r->x0 > pad.x0 ? r->x0 : pad.x0, x1 = r->x1 < pad.x1 ? r->x1 : pad.x1;
    int y0 = r->y0 > pad.y0 ? r->y0 : pad.y0, y1 = r->y1 < pad.y1 ? r->y1 : pad.y1;
    return is_covered((lef_rect){0, pad.x0, pad.y0, x0, pad.y1}, rect, rects) &&
           is_covered((lef_rect){0, x1, pad.y0, pad.x1, pad.y1}, rect, rects) &&
           is_covered((lef_rect){0, x0, pad.y0, x1, y0}, rect, rects) &&
           is_covered((lef_rect){0, x0, y1, x1, pad.y1}, rect, rects);
  }
  return false;
}

typedef struct {
  const design *d;
  const grid *g;
  floor_plan floor;
} finder;

/* Whether two terminals are one, or rails of the same kind, which rows of cells join. */
static bool is_same(const design *d, terminal a, terminal b) {
  if (a.pin < 0 || b.pin < 0) {
    return false;
  }
  return (a.component == b.component && a.pin == b.pin) ||
         (design_is_rail(d, a) && design_is_rail(d, b) &&
          d->cell[a.component].macro->pin[a.pin].use == d->cell[b.component].macro->pin[b.pin].use);
}

/* A pad that goes beyond its pin keeps the distance from all but what it touches of the pin. */
static bool keeps_distance(const finder *f, const lef_rect *pad, terminal of, int least) {
  const floor_plan *p = &f->floor;
  int i1 = (pad->x1 + least) / p->side, j1 = (pad->y1 + least) / p->side;
  for (int i = (pad->x0 - least) / p->side; i <= i1 && i < p->columns; i++) {
    for (int j = (pad->y0 - least) / p->side; j <= j1 && j < p->rows; j++) {
      for (int b = j * p->columns + i, k = 0; i >= 0 && j >= 0 && k < p->count[b]; k++) {
        const shape *s = &p->bin[b][k];
        if (nearer_than(pad, &s->rect, least) &&
            !(is_same(f->d, s->of, of) && meets(pad, &s->rect))) {
          return false;
        }
      }
    }
  }
  return true;
}

static int first_track(int from, int offset, int step) {
  int k = (from - offset + step - 1) / step;
  return k < 0 ? 0 : k;
}

static void add(access_list *list, uint32_t node, const lef_via *via, bool covered) {
  for (int k = 0; k < list->count; k++) {
    if (list->at[k].node == node) {
      return;
    }
  }
  list->at = text_more(list->at, (size_t)list->count, sizeof *list->at);
  list->at[list->count++] = (access){node, via, covered};
}

/* The nodes at which a via of the library has its cut within a rectangle of a pin; covered: and
 * its pad within the pin. */
static void look(const finder *f, terminal t, const lef_rect *all, int rects, bool covered,
                 access_list *list) {
  const grid *g = f->g;
  int least = f->d->lib->layer[g->first_metal].spacing;
  for (int k = 0; k < f->d->lib->vias; k++) {
    const lef_via *via = &f->d->lib->via[k];
    int cut_x, cut_y, pad_x, pad_y;
    if (!grid_lands(f->d->lib, g, via)) {
      continue;
    }
    grid_extent(via, g->first_metal + 1, &cut_x, &cut_y);
    grid_extent(via, g->first_metal, &pad_x, &pad_y);
    for (int r = 0; r < rects; r++) {
      for (int i = first_track(all[r].x0 + cut_x, g->offset_x, g->step_x);
           i < g->columns && grid_x(g, i) <= all[r].x1 - cut_x; i++) {
        for (int j = first_track(all[r].y0 + cut_y, g->offset_y, g->step_y);
             j < g->rows && grid_y(g, j) <= all[r].y1 - cut_y; j++) {
          lef_rect pad = {g->first_metal, grid_x(g, i) - pad_x, grid_y(g, j) - pad_y,
                          grid_x(g, i) + pad_x, grid_y(g, j) + pad_y};
          if (covered ? is_covered(pad, all, rects) : keeps_distance(f, &pad, t, least)) {
            add(list, grid_node(g, 0, i, j), via, covered);
          }
        }
      }
    }
  }
}

static void find_port(const finder *f, const port *p, access_list *list) {
  const grid *g = f->g;
  int x = (p->shape.x0 + p->shape.x1) / 2, y = (p->shape.y0 + p->shape.y1) / 2;
  for (int k = 0; k < g->layers; k++) {
    if (g->layer[k].metal == p->shape.layer) {
      add(list, grid_node(g, k, (x - g->offset_x) / g->step_x, (y - g->offset_y) / g->step_y), NULL,
          true);
    }
  }
}

static void find_pin(const finder *f, terminal t, access_list *list) {
  if (t.component < 0) {
    find_port(f, &f->d->port[t.pin], list);
    return;
  }
  const component *c = &f->d->cell[t.component];
  const lef_shapes *s = &c->macro->pin[t.pin].shape;
  lef_rect *all = text_alloc((size_t)s->rects, sizeof *all);
  int rects = 0;
  for (int k = 0; k < s->rects; k++) {
    if (s->rect[k].layer == f->g->first_metal) {
      all[rects++] = design_rect(c, &s->rect[k]);
    }
  }
  look(f, t, all, rects, true, list);
  look(f, t, all, rects, false, list);
  free(all);
  if (list->count == 0) {
    errx(2, "no via of the LEF files fits onto pin %s of %s", c->macro->pin[t.pin].name,
         c->macro->name);
  }
}

access_list *access_find(const design *d, const grid *g, int first[]) {
  finder f = {.d = d, .g = g, .floor = lay_out(d, g->first_metal)};
  int pins = 0;
  for (int k = 0; k < d->nets; k++) {
    first[k] = pins;
    pins += d->net[k].pins;
  }
  access_list *list = text_alloc((size_t)pins, sizeof *list);
  for (int k = 0; k < d->nets; k++) {
    for (int p = 0; p < d->net[k].pins && d->net[k].pins > 1; p++) {
      find_pin(&f, d->net[k].pin[p], &list[first[k] + p]);
    }
  }
  return list;
}
