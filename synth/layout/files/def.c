/* SPDX-License-Identifier: MIT */
/* def.c - DEF files: written for a router, read from it. */
#include "layout/files/design.h"
#include "liberty/text.h"
#include "layout/files/words.h"

#include <err.h>
#include <search.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* ---------------------------------------------------------------------- written */

static void write_tracks(const design *d, FILE *out) {
  for (int k = 0; k < d->lib->layers; k++) {
    const lef_layer *l = &d->lib->layer[k];
    if (!l->metal || l->pitch == 0) {
      continue;
    }
    int length = l->vertical ? d->width : d->height;
    fprintf(out, "TRACKS %c %d DO %d STEP %d LAYER %s ;\n", l->vertical ? 'X' : 'Y', l->offset,
            (length - l->offset) / l->pitch + 1, l->pitch, l->name);
  }
}

static void write_place(FILE *out, const char *how, int x, int y, const char *orient) {
  fprintf(out, " + %s ( %d %d ) %s", how, x, y, orient);
}

static void write_components(const design *d, FILE *out) {
  fprintf(out, "COMPONENTS %d ;\n", d->cells);
  for (int k = 0; k < d->cells; k++) {
    const component *c = &d->cell[k];
    fprintf(out, "- %s %s", c->name, c->macro->name);
    if (c->placed) {
      write_place(out, "PLACED", c->x, c->y, orientation_name[c->orient]);
    } else {
      fprintf(out, " + UNPLACED");
    }
    fprintf(out, " ;\n");
  }
  fprintf(out, "END COMPONENTS\n");
}

/* A port's shape is told relative to its middle. */
static void write_ports(const design *d, FILE *out) {
  fprintf(out, "PINS %d ;\n", d->ports);
  for (int k = 0; k < d->ports; k++) {
    const port *p = &d->port[k];
    const lef_rect *r = &p->shape;
    fprintf(out, "- %s + NET %s + DIRECTION %s", p->name, d->net[p->net].name,
            p->output ? "OUTPUT" : "INPUT");
    if (p->placed) {
      int x = (r->x0 + r->x1) / 2, y = (r->y0 + r->y1) / 2;
      fprintf(out, " + LAYER %s ( %d %d ) ( %d %d )", d->lib->layer[r->layer].name, r->x0 - x,
              r->y0 - y, r->x1 - x, r->y1 - y);
      write_place(out, "PLACED", x, y, "N");
    }
    fprintf(out, " ;\n");
  }
  fprintf(out, "END PINS\n");
}

static void write_routes(const design *d, const net *n, FILE *out) {
  for (int k = 0; k < n->segments; k++) {
    const segment *s = &n->route[k];
    fprintf(out, "\n  %s %s ( %d %d )", k == 0 ? "+ ROUTED" : "NEW", d->lib->layer[s->layer].name,
            s->x0, s->y0);
    if (s->via != NULL) {
      fprintf(out, " %s", s->via->name);
    } else {
      fprintf(out, " ( %d %d )", s->x1, s->y1);
    }
  }
}

static void write_nets(const design *d, FILE *out) {
  int count = 0;
  for (int k = 0; k < d->nets; k++) {
    count += d->net[k].pins > 0;
  }
  fprintf(out, "NETS %d ;\n", count);
  for (int k = 0; k < d->nets; k++) {
    const net *n = &d->net[k];
    if (n->pins == 0) {
      continue;
    }
    fprintf(out, "- %s", n->name);
    for (int p = 0; p < n->pins; p++) {
      terminal t = n->pin[p];
      fprintf(out, "%s( %s %s )", p % 8 == 0 ? "\n  " : " ",
              t.component < 0 ? "PIN" : d->cell[t.component].name,
              t.component < 0 ? d->port[t.pin].name : d->cell[t.component].macro->pin[t.pin].name);
    }
    if (n->power) {
      fprintf(out, " + USE POWER");
    }
    write_routes(d, n, out);
    fprintf(out, " ;\n");
  }
  fprintf(out, "END NETS\n");
}

void design_write_def(const design *d, FILE *out) {
  fprintf(out,
          "VERSION 5.6 ;\nDIVIDERCHAR \"/\" ;\nBUSBITCHARS \"[]\" ;\nDESIGN %s ;\n"
          "UNITS DISTANCE MICRONS %d ;\nDIEAREA ( 0 0 ) ( %d %d ) ;\n",
          d->name, UNITS, d->width, d->height);
  for (int k = 0; k < d->rows; k++) {
    const row *r = &d->row[k];
    fprintf(out, "ROW row_%d %s %d %d %s DO %d BY 1 STEP %d 0 ;\n", k, d->lib->site, r->x, r->y,
            orientation_name[r->orient], r->sites, d->lib->site_width);
  }
  write_tracks(d, out);
  write_components(d, out);
  write_ports(d, out);
  write_nets(d, out);
  fprintf(out, "END DESIGN\n");
}

/* ---------------------------------------------------------------------- read */

typedef struct {
  const char *name;
  int number;
} entry;

static int by_name(const void *a, const void *b) {
  return strcmp(((const entry *)a)->name, ((const entry *)b)->name);
}

static void remember(void **tree, const words *w, const char *name, int number) {
  entry *it = text_alloc(1, sizeof *it);
  *it = (entry){name, number};
  entry **found = tsearch(it, tree, by_name);
  if (found == NULL || *found != it) {
    words_fail(w, "is there twice:", name);
  }
}

static int recall(void *const *tree, const words *w, const char *name) {
  entry want = {name, 0};
  entry *const *found = tfind(&want, tree, by_name);
  if (found == NULL) {
    words_fail(w, "unknown:", name);
  }
  return (*found)->number;
}

typedef struct {
  words w;
  design *d;
  double scale; /* units of the file to ours */
  void *cells, *ports, *nets;
} reader;

static int read_units(reader *r) {
  double value = word_number(&r->w) * r->scale;
  return (int)(value < 0 ? value - 0.5 : value + 0.5);
}

/* ( x y ), of which "*" is the one before. */
static void read_point(reader *r, int *x, int *y) {
  word_want(&r->w, "(");
  if (!word_is(&r->w, "*")) {
    *x = read_units(r);
  }
  if (!word_is(&r->w, "*")) {
    *y = read_units(r);
  }
  while (!word_is(&r->w, ")")) {
    (void)word(&r->w);
  }
}

static orientation read_orientation(reader *r) {
  const char *name = word(&r->w);
  for (int k = 0; k < 4; k++) {
    if (strcmp(orientation_name[k], name) == 0) {
      return (orientation)k;
    }
  }
  words_fail(&r->w, "no orientation in a row:", name);
}

static void read_row(reader *r) {
  design *d = r->d;
  (void)word(&r->w);
  (void)word(&r->w);
  row it = {.x = read_units(r)};
  it.y = read_units(r);
  it.orient = read_orientation(r);
  word_want(&r->w, "DO");
  it.sites = (int)word_number(&r->w);
  words_skip(&r->w);
  d->row = text_more(d->row, (size_t)d->rows, sizeof *d->row);
  d->row[d->rows++] = it;
}

static bool section_ends(reader *r, const char *name) {
  if (word_is(&r->w, "END")) {
    word_want(&r->w, name);
    return true;
  }
  word_want(&r->w, "-");
  return false;
}

static void read_components(reader *r) {
  design *d = r->d;
  while (!section_ends(r, "COMPONENTS")) {
    const char *name = word(&r->w), *type = word(&r->w);
    const lef_macro *macro = lef_find(d->lib, type);
    if (macro == NULL) {
      words_fail(&r->w, "the LEF files have no cell", type);
    }
    int c = design_add_cell(d, name, macro);
    remember(&r->cells, &r->w, name, c);
    while (!word_is(&r->w, ";")) {
      if (word_is(&r->w, "PLACED") || word_is(&r->w, "FIXED")) {
        d->cell[c].placed = true;
        read_point(r, &d->cell[c].x, &d->cell[c].y);
        d->cell[c].orient = read_orientation(r);
      } else {
        (void)word(&r->w);
      }
    }
  }
}

static void read_pins(reader *r) {
  design *d = r->d;
  while (!section_ends(r, "PINS")) {
    port it = {.name = word(&r->w), .net = -1};
    int x = 0, y = 0;
    while (!word_is(&r->w, ";")) {
      if (word_is(&r->w, "DIRECTION")) {
        it.output = strcmp(word(&r->w), "OUTPUT") == 0;
      } else if (word_is(&r->w, "LAYER")) {
        it.shape.layer = lef_layer_index(d->lib, word(&r->w));
        read_point(r, &it.shape.x0, &it.shape.y0);
        read_point(r, &it.shape.x1, &it.shape.y1);
      } else if (word_is(&r->w, "PLACED") || word_is(&r->w, "FIXED")) {
        read_point(r, &x, &y);
        it.placed = true;
      } else {
        (void)word(&r->w);
      }
    }
    it.shape.x0 += x, it.shape.x1 += x, it.shape.y0 += y, it.shape.y1 += y;
    remember(&r->ports, &r->w, it.name, d->ports);
    d->port = text_more(d->port, (size_t)d->ports, sizeof *d->port);
    d->port[d->ports++] = it;
  }
}

static const lef_via *find_via(const lef *l, const char *name) {
  for (int k = 0; k < l->vias; k++) {
    if (strcmp(l->via[k].name, name) == 0) {
      return &l->via[k];
    }
  }
  return NULL;
}

static void add_segment(net *n, segment s) {
  n->route = text_more(n->route, (size_t)n->segments, sizeof *n->route);
  n->route[n->segments++] = s;
}

/* The metal above or below one, by way of a via. */
static int other_metal(const reader *r, const lef_via *via, int layer) {
  for (int k = 0; k < via->shape.rects; k++) {
    int of = via->shape.rect[k].layer;
    if (r->d->lib->layer[of].metal && of != layer) {
      return of;
    }
  }
  words_fail(&r->w, "joins no two metals:", via->name);
}

/* LAYER ( x y ) ( x y ) ... VIA ..., up to NEW, "+" or ";". */
static void read_route(reader *r, net *n) {
  design *d = r->d;
  do {
    const char *name = word(&r->w);
    int layer = lef_layer_index(d->lib, name);
    if (layer < 0) {
      words_fail(&r->w, "no layer that is routed:", name);
    }
    int x = 0, y = 0;
    read_point(r, &x, &y);
    while (words_left(&r->w) && strchr(";+N", *r->w.next) == NULL) {
      if (*r->w.next == '(') {
        segment s = {.layer = layer, .x0 = x, .y0 = y};
        read_point(r, &x, &y);
        s.x1 = x, s.y1 = y;
        add_segment(n, s);
        continue;
      }
      const char *via_name = word(&r->w);
      const lef_via *via = find_via(d->lib, via_name);
      if (via == NULL) {
        words_fail(&r->w, "no via of the LEF files:", via_name);
      }
      int other = other_metal(r, via, layer);
      add_segment(n, (segment){layer < other ? layer : other, x, y, x, y, via});
      layer = other;
    }
  } while (word_is(&r->w, "NEW"));
}

static void read_net_pin(reader *r, int n) {
  design *d = r->d;
  const char *of = word(&r->w), *pin = word(&r->w);
  word_want(&r->w, ")");
  if (strcmp(of, "PIN") == 0) {
    int p = recall(&r->ports, &r->w, pin);
    d->port[p].net = n;
    design_add_pin(&d->net[n], -1, p);
    return;
  }
  int c = recall(&r->cells, &r->w, of);
  int p = lef_pin_index(d->cell[c].macro, pin);
  if (p < 0) {
    words_fail(&r->w, "the LEF files have no pin", pin);
  }
  design_add_pin(&d->net[n], c, p);
}

static void read_nets(reader *r) {
  design *d = r->d;
  while (!section_ends(r, "NETS")) {
    const char *name = word(&r->w);
    int n = design_add_net(d, name);
    remember(&r->nets, &r->w, name, n);
    while (!word_is(&r->w, ";")) {
      if (word_is(&r->w, "(")) {
        read_net_pin(r, n);
      } else if (word_is(&r->w, "ROUTED")) {
        read_route(r, &d->net[n]);
      } else if (word_is(&r->w, "POWER")) {
        d->net[n].power = true;
      } else {
        (void)word(&r->w);
      }
    }
  }
}

void design_read_def(design *d, const lef *lib, const char *path) {
  *d = (design){.lib = lib};
  reader r = {.w = words_open(path), .d = d, .scale = 1};
  while (words_left(&r.w)) {
    const char *what = word(&r.w);
    if (strcmp(what, "DESIGN") == 0) {
      d->name = word(&r.w);
      words_skip(&r.w);
    } else if (strcmp(what, "UNITS") == 0) {
      word_want(&r.w, "DISTANCE");
      word_want(&r.w, "MICRONS");
      r.scale = UNITS / word_number(&r.w);
      words_skip(&r.w);
    } else if (strcmp(what, "DIEAREA") == 0) {
      int x = 0, y = 0;
      read_point(&r, &x, &y);
      read_point(&r, &d->width, &d->height);
      words_skip(&r.w);
    } else if (strcmp(what, "ROW") == 0) {
      read_row(&r);
    } else if (strcmp(what, "COMPONENTS") == 0) {
      words_skip(&r.w);
      read_components(&r);
    } else if (strcmp(what, "PINS") == 0) {
      words_skip(&r.w);
      read_pins(&r);
    } else if (strcmp(what, "NETS") == 0) {
      words_skip(&r.w);
      read_nets(&r);
    } else if (strcmp(what, "END") == 0) {
      if (strcmp(word(&r.w), "DESIGN") == 0) {
        break;
      }
    } else {
      words_skip(&r.w);
    }
  }
  if (d->name == NULL || d->width <= 0 || d->height <= 0) {
    errx(2, "%s: is no DEF file with a die", path);
  }
  text_file = path;
  design_order(d);
}
