/* SPDX-License-Identifier: MIT */
/* place.c - see place.h. */
#include "layout/place.h"
#include "layout/route/grid.h"
#include "liberty/text.h"
#include "layout/files/words.h"

#include <err.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { GRAIN = 10 }; /* units in one of the placer's, which counts in whole numbers */

static int rounded_up(double x, int step) { return (int)ceil(x / step - 1e-9) * step; }

/* ---------------------------------------------------------------------- the die */

/* Places along one axis: multiples of a step from an offset, two steps off both ends at least. */
typedef struct {
  int offset, step, first, last;
} tracks;

static tracks tracks_along(int offset, int step, int length) {
  return (tracks){offset, step, (int)round((2.0 * step - offset) / step),
                  (int)round((length - 2.0 * step - offset) / step)};
}

static int nearest(const tracks *t, double at) {
  int n = (int)round((at - t->offset) / t->step);
  return n < t->first ? t->first : n > t->last ? t->last : n;
}

/* Numbers in order become different ones, 0 ... most, in that order, moved as little as need be. */
static bool spread(int *number, int count, int most) {
  for (int k = 1; k < count; k++) {
    number[k] = number[k] > number[k - 1] ? number[k] : number[k - 1] + 1;
  }
  for (int k = count - 1, free = most; k >= 0 && number[k] > free; k--, free--) {
    number[k] = free;
  }
  return count == 0 || number[0] >= 0;
}

/* Along the sides from the lower left corner, up first; on the third and fourth metal, each port on
 * a track of its own. */
static void place_ports(design *d, const grid *g) {
  const int lengths[] = {d->height, d->width, d->height, d->width};
  double step = 2.0 * (d->width + d->height) / d->ports;
  int *number = text_alloc((size_t)d->ports, sizeof *number);
  double start = 0;
  for (int side = 0, k = 0; side < 4; start += lengths[side++]) {
    bool upright = side % 2 == 0, back = side >= 2;
    int layer = 1;
    while (layer < g->layers - 1 && g->layer[layer].vertical == upright) {
      layer++;
    }
    int stride_x = upright ? 1 : g->layer[layer].stride;
    int stride_y = upright ? g->layer[layer].stride : 1;
    tracks x = tracks_along(g->offset_x, g->step_x * stride_x, d->width);
    tracks y = tracks_along(g->offset_y, g->step_y * stride_y, d->height);
    tracks *along = upright ? &y : &x, *across = upright ? &x : &y;
    int most = along->last - along->first, count = 0;
    for (; k + count < d->ports && (side == 3 || (k + count + 0.5) * step < start + lengths[side]);
         count++) {
      double at = (k + count + 0.5) * step - start;
      int n = nearest(along, back ? lengths[side] - at : at);
      number[count] = back ? along->last - n : n - along->first;
    }
    if (!spread(number, count, most)) {
      errx(2, "%d ports do not fit on a side of %d tracks; give less USE", count, most + 1);
    }
    int far = side == 1 || side == 2 ? across->last : across->first;
    int half = d->lib->layer[g->layer[layer].metal].width / 2;
    for (int last = k + count, n = 0; k < last; k++, n++) {
      const int spot[] = {across->offset + far * across->step,
                          along->offset +
                              (back ? along->last - number[n] : along->first + number[n]) *
                                  along->step};
      int cx = spot[!upright], cy = spot[upright];
      d->port[k].shape =
          (lef_rect){g->layer[layer].metal, cx - half, cy - half, cx + half, cy + half};
      d->port[k].placed = true;
    }
  }
  free(number);
}

void place_floor(design *d, double use) {
  const lef *l = d->lib;
  int site = l->site_width, height = l->site_height;
  if (l->site == NULL) {
    errx(2, "the LEF files have no site of a row; give the technology's, too");
  }
  double width = 0;
  for (int k = 0; k < d->cells; k++) {
    if (d->cell[k].macro->height != height || d->cell[k].macro->width % site != 0) {
      errx(2, "%s does not fit into rows of sites", d->cell[k].macro->name);
    }
    width += d->cell[k].macro->width;
  }
  double area = width * height / use;
  int rows = (int)fmax(1, round(sqrt(area) / height));
  int sites = rounded_up(area / (rows * height), site) / site;
  int margin_x = rounded_up(height, 2 * site), margin_y = height;
  d->width = 2 * margin_x + sites * site;
  d->height = 2 * margin_y + rows * height;
  for (int k = 0; k < rows; k++) {
    d->row = text_more(d->row, (size_t)d->rows, sizeof *d->row);
    d->row[d->rows++] = (row){margin_x, margin_y + k * height, sites, k % 2 == 0 ? AS_N : AS_FS};
  }
  grid g = grid_make(d, 6);
  place_ports(d, &g);
}

/* ---------------------------------------------------------------------- Bookshelf */

static FILE *open_part(const char *dir, const char *end, const char *head) {
  char *path = text_alloc(strlen(dir) + strlen(end) + 16, 1);
  sprintf(path, "%s/design.%s", dir, end);
  FILE *out = fopen(path, "w");
  if (out == NULL) {
    err(2, "%s", path);
  }
  free(path);
  fprintf(out, "%s", head);
  return out;
}

static void close_part(FILE *out) {
  if (fclose(out) != 0) {
    err(2, "the placer's files");
  }
}

static int middle(int a, int b) { return (a + b) / 2; }

static void write_nodes(const design *d, const char *dir) {
  FILE *out = open_part(dir, "nodes", "UCLA nodes 1.0\n");
  fprintf(out, "NumNodes : %d\nNumTerminals : %d\n", d->cells + d->ports, d->ports);
  for (int k = 0; k < d->cells; k++) {
    const lef_macro *m = d->cell[k].macro;
    fprintf(out, "c%d %d %d\n", k, m->width / GRAIN, m->height / GRAIN);
  }
  for (int k = 0; k < d->ports; k++) {
    fprintf(out, "p%d terminal\n", k);
  }
  close_part(out);
  out = open_part(dir, "pl", "UCLA pl 1.0\n");
  for (int k = 0; k < d->cells; k++) {
    const component *c = &d->cell[k];
    fprintf(out, "c%d %d %d : %s\n", k, c->x / GRAIN, c->y / GRAIN, orientation_name[c->orient]);
  }
  for (int k = 0; k < d->ports; k++) {
    const lef_rect *r = &d->port[k].shape;
    fprintf(out, "p%d %d %d : N /FIXED\n", k, middle(r->x0, r->x1) / GRAIN,
            middle(r->y0, r->y1) / GRAIN);
  }
  close_part(out);
}

/* A pin is where the middle of its first shape is, told from the middle of the cell. */
static void write_pin(const design *d, terminal t, FILE *out) {
  if (t.component < 0) {
    fprintf(out, "p%d %c : 0 0\n", t.pin, design_drives(d, t) ? 'O' : 'I');
    return;
  }
  const lef_macro *m = d->cell[t.component].macro;
  const lef_shapes *s = &m->pin[t.pin].shape;
  lef_rect r = s->rects > 0 ? s->rect[0] : (lef_rect){0};
  fprintf(out, "c%d %c : %g %g\n", t.component, design_drives(d, t) ? 'O' : 'I',
          (r.x0 + r.x1 - m->width) / 2.0 / GRAIN, (r.y0 + r.y1 - m->height) / 2.0 / GRAIN);
}

static void write_nets(const design *d, const char *dir) {
  FILE *out = open_part(dir, "nets", "UCLA nets 1.0\n");
  int nets = 0, pins = 0;
  for (int k = 0; k < d->nets; k++) {
    bool counts = d->net[k].pins > 1 && !d->net[k].power;
    nets += counts, pins += counts ? d->net[k].pins : 0;
  }
  fprintf(out, "NumNets : %d\nNumPins : %d\n", nets, pins);
  for (int k = 0; k < d->nets; k++) {
    const net *n = &d->net[k];
    if (n->pins <= 1 || n->power) {
      continue;
    }
    fprintf(out, "NetDegree : %d n%d\n", n->pins, k);
    for (int p = 0; p < n->pins; p++) {
      write_pin(d, n->pin[p], out);
    }
  }
  close_part(out);
}

void place_write(const design *d, const char *dir) {
  write_nodes(d, dir);
  write_nets(d, dir);
  FILE *out = open_part(dir, "scl", "UCLA scl 1.0\n");
  fprintf(out, "NumRows : %d\n", d->rows);
  for (int k = 0; k < d->rows; k++) {
    const row *r = &d->row[k];
    fprintf(out,
            "CoreRow Horizontal\n Coordinate : %d\n Height : %d\n Sitewidth : %d\n"
            " Siteorient : %s\n SubrowOrigin : %d NumSites : %d\nEnd\n",
            r->y / GRAIN, d->lib->site_height / GRAIN, d->lib->site_width / GRAIN,
            orientation_name[r->orient], r->x / GRAIN, r->sites);
  }
  close_part(out);
  close_part(
      open_part(dir, "aux", "RowBasedPlacement : design.nodes design.nets design.pl design.scl\n"));
}

void place_read(design *d, const char *path) {
  words w = words_open(path);
  while (words_left(&w)) {
    const char *name = word(&w);
    char *end;
    long k = strtol(name + 1, &end, 10);
    if (name[0] != 'c' || *end != '\0' || end == name + 1 || k < 0 || k >= d->cells) {
      w.next += strcspn(w.next, "\n"); /* a port, or what the file is */
      continue;
    }
    component *c = &d->cell[k];
    c->x = (int)word_number(&w) * GRAIN;
    c->y = (int)word_number(&w) * GRAIN;
    word_want(&w, ":");
    const char *as = word(&w);
    c->placed = true;
    for (int o = 0; o < 4; o++) {
      if (strcmp(orientation_name[o], as) == 0) {
        c->orient = (orientation)o;
      }
    }
  }
  for (int k = 0; k < d->cells; k++) {
    if (!d->cell[k].placed) {
      errx(2, "%s: does not place %s", path, d->cell[k].name);
    }
  }
}

/* ---------------------------------------------------------------------- rows */

void place_snap(design *d) {
  for (int k = 0; k < d->cells; k++) {
    component *c = &d->cell[k];
    c->x -= (c->x - d->row[0].x) % d->lib->site_width;
  }
}

static const design *sorted; /* by qsort */

static int by_place(const void *a, const void *b) {
  const component *c = &sorted->cell[*(const int *)a], *e = &sorted->cell[*(const int *)b];
  return c->y != e->y ? (c->y > e->y) - (c->y < e->y) : (c->x > e->x) - (c->x < e->x);
}

/* The cells, row by row, from the left. */
static int *in_rows(const design *d) {
  int *order = text_alloc((size_t)d->cells, sizeof *order);
  for (int k = 0; k < d->cells; k++) {
    order[k] = k;
  }
  sorted = d;
  qsort(order, (size_t)d->cells, sizeof *order, by_place);
  return order;
}

/* From the widest cell that fits to the narrowest. */
static void fill_gap(design *d, const row *r, int from, int to) {
  while (from < to) {
    const lef_macro *widest = NULL;
    for (int k = 0; k < d->lib->macros; k++) {
      const lef_macro *m = &d->lib->macro[k];
      if (strncmp(m->name, "FILL", 4) == 0 && m->width <= to - from &&
          (widest == NULL || m->width > widest->width)) {
        widest = m;
      }
    }
    if (widest == NULL) {
      return;
    }
    char *name = text_alloc(24, 1);
    sprintf(name, "fill_%d", d->cells);
    int k = design_add_cell(d, name, widest);
    component *c = &d->cell[k];
    c->x = from, c->y = r->y, c->orient = r->orient, c->placed = true;
    from += widest->width;
  }
}

void place_fill(design *d) {
  int *order = in_rows(d), cells = d->cells;
  for (int k = 0, next = 0; k < d->rows; k++) {
    const row *r = &d->row[k];
    int x = r->x;
    for (; next < cells && d->cell[order[next]].y == r->y; next++) {
      const component *c = &d->cell[order[next]];
      int at = c->x, width = c->macro->width;
      fill_gap(d, r, x, at);
      x = at + width;
    }
    fill_gap(d, r, x, r->x + r->sites * d->lib->site_width);
  }
  free(order);
}

static const row *row_at(const design *d, int y) {
  for (int k = 0; k < d->rows; k++) {
    if (d->row[k].y == y) {
      return &d->row[k];
    }
  }
  return NULL;
}

static const char *fault_of(const design *d, const component *c) {
  const row *r = row_at(d, c->y);
  if (!c->placed || r == NULL) {
    return "is in no row";
  }
  if (c->x < r->x || c->x + c->macro->width > r->x + r->sites * d->lib->site_width) {
    return "is beyond its row";
  }
  if ((c->x - r->x) % d->lib->site_width != 0) {
    return "is on no site";
  }
  bool down = c->orient == AS_S || c->orient == AS_FS;
  return down == (r->orient == AS_FS) ? NULL : "stands on its head";
}

int place_check(const design *d) {
  int faults = 0, *order = in_rows(d);
  for (int k = 0; k < d->cells; k++) {
    const component *c = &d->cell[order[k]];
    const char *fault = fault_of(d, c);
    const component *before = k > 0 ? &d->cell[order[k - 1]] : NULL;
    if (fault == NULL && before != NULL && before->y == c->y &&
        before->x + before->macro->width > c->x) {
      fault = "overlaps the cell to its left";
    }
    if (fault != NULL) {
      faults++;
      warnx("%s %s", c->name, fault);
    }
  }
  free(order);
  return faults;
}

/* ---------------------------------------------------------------------- clock tree */

typedef struct {
  design *d;
  const lef_macro *buffer;
  int in, out; /* its pins */
  const char *clock;
} forest;

static const design *compared;
static bool along_x;

static int by_side(const void *a, const void *b) {
  lef_rect p = design_terminal(compared, *(const terminal *)a);
  lef_rect q = design_terminal(compared, *(const terminal *)b);
  return along_x ? (p.x0 > q.x0) - (p.x0 < q.x0) : (p.y0 > q.y0) - (p.y0 < q.y0);
}

/* Order the pins along the longer side of the box around them. */
static void order_pins(const design *d, terminal *pin, int pins) {
  int x0 = 1 << 30, y0 = 1 << 30, x1 = -x0, y1 = -y0;
  for (int k = 0; k < pins; k++) {
    lef_rect r = design_terminal(d, pin[k]);
    x0 = r.x0 < x0 ? r.x0 : x0, x1 = r.x0 > x1 ? r.x0 : x1;
    y0 = r.y0 < y0 ? r.y0 : y0, y1 = r.y0 > y1 ? r.y0 : y1;
  }
  compared = d;
  along_x = x1 - x0 > y1 - y0;
  qsort(pin, (size_t)pins, sizeof *pin, by_side);
}

/* A buffer amid pins, on a net of theirs; its input. */
static terminal add_buffer(forest *f, const terminal *pin, int pins) {
  design *d = f->d;
  size_t length = strlen(f->clock) + 32;
  char *name = text_alloc(length, 1), *of_net = text_alloc(length, 1);
  sprintf(name, "%s_tree_%d", f->clock, d->cells);
  sprintf(of_net, "%s_tree_%d_net", f->clock, d->cells);
  int c = design_add_cell(d, name, f->buffer), n = design_add_net(d, of_net);
  design_add_pin(&d->net[n], c, f->out);
  double x = 0, y = 0;
  for (int k = 0; k < pins; k++) {
    lef_rect r = design_terminal(d, pin[k]);
    x += r.x0, y += r.y0;
    design_add_pin(&d->net[n], pin[k].component, pin[k].pin);
  }
  d->cell[c].x = (int)(x / pins), d->cell[c].y = (int)(y / pins);
  d->cell[c].placed = true;
  return (terminal){c, f->in};
}

/* A tree of so many halvings over pins; its input. */
static terminal grow(forest *f, terminal *pin, int pins, int halvings) {
  if (halvings <= 0) {
    return add_buffer(f, pin, pins);
  }
  terminal child[4];
  int parts = halvings % 2 == 0 ? 4 : 2, children = 0;
  order_pins(f->d, pin, pins);
  for (int half = 0; half < 2; half++) {
    terminal *at = half == 0 ? pin : pin + pins / 2;
    int count = half == 0 ? pins / 2 : pins - pins / 2;
    if (parts == 2) {
      child[children++] = grow(f, at, count, halvings - 1);
      continue;
    }
    order_pins(f->d, at, count);
    child[children++] = grow(f, at, count / 2, halvings - 2);
    child[children++] = grow(f, at + count / 2, count - count / 2, halvings - 2);
  }
  return add_buffer(f, child, children);
}

void place_tree(design *d, const char *clock, const lef_macro *buffer, int most) {
  int n = 0;
  while (n < d->nets && strcmp(d->net[n].name, clock) != 0) {
    n++;
  }
  if (n == d->nets) {
    errx(2, "there is no net %s; give the clock's name", clock);
  }
  forest f = {.d = d, .buffer = buffer, .in = -1, .out = -1, .clock = clock};
  for (int p = 0; p < buffer->pins; p++) {
    if (buffer->pin[p].use == LEF_SIGNAL || buffer->pin[p].use == LEF_CLOCK) {
      *(buffer->pin[p].output ? &f.out : &f.in) = p;
    }
  }
  if (f.in < 0 || f.out < 0) {
    errx(2, "%s is no buffer", buffer->name);
  }
  int pins = d->net[n].pins - 1, halvings = 0;
  while (pins > most << halvings) {
    halvings++;
  }
  terminal root = grow(&f, d->net[n].pin + 1, pins, halvings);
  net *it = &d->net[n];
  it->pins = 1;
  design_add_pin(it, root.component, root.pin);
}
