/* SPDX-License-Identifier: MIT */
/* main.c - the steps of a layout between the netlist and the tools that place and route it.
 *
 *   layout COMMAND -l LEF [-l LEF ...] [OPTIONS] FILE
 *
 * plan -u USE NETLIST       a die of which the cells take the share USE; its ports
 * tree -c CLOCK -b BUFFER   a tree of buffers for the clock, in a DEF whose cells are placed
 * place -s SOLUTION         the cells of a DEF as a placer found them; -r: on sites, checked, with
 *                           fillers
 * check                     faults of the rows of a DEF
 * bookshelf -d DIR          a DEF's cells and nets for the placer
 * verilog                   the netlist of a DEF
 * route -t TOP -n ROUNDS    wires on the second to the TOPth metal (6), in at most so many rounds
 * wires -j SUMS             its wires as SPEF; sums in JSON
 * rules                     of each layer that is routed or cut: name, number in GDS, metal or cut,
 *                           width, distance, how far metal goes beyond a cut, from which width on
 *                           distances are longer; in micrometres
 * pins                      of each pin its net, layer, and a point in it
 *
 * A DEF goes to standard output. Exit status 1: a placement that is not legal, nets that
 * are not routed; 2: it could not be done. */
#include "layout/files/words.h"
#include "layout/place.h"
#include "layout/route/grid.h"
#include "layout/route/nets.h"
#include "layout/wires.h"
#include "liberty/text.h"

#include <err.h>
#include <getopt.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

typedef struct {
  const char *given[128];
  const char *file;
  lef lib;
} request;

static double number(const request *r, char option, double other) {
  const char *text = r->given[(unsigned char)option];
  if (text == NULL) {
    return other;
  }
  char *end;
  double x = strtod(text, &end);
  if (end == text || *end != '\0' || !(x > 0 && x < 1e6)) {
    errx(2, "-%c %s: give a number", option, text);
  }
  return x;
}

static const char *wanted(const request *r, char option) {
  const char *text = r->given[(unsigned char)option];
  if (text == NULL) {
    errx(2, "-%c is missing; see the head of synth/layout/main.c", option);
  }
  return text;
}

/* LAYER OHM FARAD: of a micrometre of wire, where the LEF's own are not wanted. */
static void read_wires(lef *l, const char *path) {
  words w = words_open(path);
  while (words_left(&w)) {
    int k = lef_layer_index(l, word(&w));
    double ohm = word_number(&w), farad = word_number(&w);
    if (k >= 0 && k < l->layers) {
      l->layer[k].ohm_per_square = ohm * l->layer[k].width / UNITS;
      l->layer[k].farad = farad;
    }
  }
}

static void plan(request *r, design *d) {
  design_read_netlist(d, &r->lib, r->file);
  place_floor(d, number(r, 'u', 0.6));
  design_write_def(d, stdout);
}

static void tree(request *r, design *d) {
  const lef_macro *buffer = lef_find(&r->lib, wanted(r, 'b'));
  if (buffer == NULL) {
    errx(2, "the LEF files have no cell %s", wanted(r, 'b'));
  }
  place_tree(d, wanted(r, 'c'), buffer, (int)number(r, 'm', 16));
  design_write_def(d, stdout);
}

static void settle(request *r, design *d) {
  place_read(d, wanted(r, 's'));
  if (r->given['r'] != NULL) {
    place_snap(d);
    place_fill(d);
    if (place_check(d) > 0) {
      exit(1);
    }
  }
  design_write_def(d, stdout);
}

static void wires(request *r, design *d) {
  if (r->given['w'] != NULL) {
    read_wires(&r->lib, r->given['w']);
  }
  int metal[3] = {0}, metals = 0;
  for (int k = 0; k < r->lib.layers && metals < 3; k++) {
    if (r->lib.layer[k].metal) {
      metal[metals++] = k;
    }
  }
  wires_sum sum = wires_write(d, metal + 1, stdout);
  FILE *out = fopen(wanted(r, 'j'), "w");
  if (out == NULL) {
    err(2, "%s", wanted(r, 'j'));
  }
  double cells = 0;
  int count = 0;
  for (int k = 0; k < d->cells; k++) {
    const lef_macro *m = d->cell[k].macro;
    bool fills = strncmp(m->name, "FILL", 4) == 0;
    cells += fills ? 0 : (double)m->width / UNITS * m->height / UNITS;
    count += !fills;
  }
  fprintf(out,
          "{\"cells\": %d, \"die_um2\": %.3f, \"width_um\": %.3f, \"height_um\": %.3f,\n"
          " \"cell_um2\": %.3f, \"half_girth_mm\": %.4f, \"wire_mm\": %.4f, \"vias\": %ld,\n"
          " \"wire_pf\": %.4f, \"open_pins\": %d}\n",
          count, (double)d->width / UNITS * d->height / UNITS, (double)d->width / UNITS,
          (double)d->height / UNITS, cells, wires_half_girth(d), sum.millimetres, sum.vias,
          sum.farad * 1e12, sum.open);
  if (fclose(out) != 0) {
    err(2, "%s", wanted(r, 'j'));
  }
}

/* How far every via's metal goes beyond its cut on two opposite sides, at least. */
static int enclosure(const lef *l, int cut) {
  int least = -1;
  for (int k = 0; k < l->vias; k++) {
    int x, y;
    grid_extent(&l->via[k], cut, &x, &y);
    for (int metal = cut - 1; metal <= cut + 1 && x > 0; metal += 2) {
      int u, v;
      grid_extent(&l->via[k], metal, &u, &v);
      int beyond = u - x > v - y ? u - x : v - y;
      least = least < 0 || beyond < least ? beyond : least;
    }
  }
  return least < 0 ? 0 : least;
}

/* Half of the side of a cut, of any via. */
static int cut_width(const lef *l, int cut) {
  for (int k = 0; k < l->vias; k++) {
    int x, y;
    grid_extent(&l->via[k], cut, &x, &y);
    if (x > 0) {
      return 2 * x;
    }
  }
  return 0;
}

static void rules(const lef *l) {
  int first = 0;
  while (first < l->layers && !l->layer[first].metal) {
    first++;
  }
  for (int k = first; k < l->layers; k++) {
    const lef_layer *it = &l->layer[k];
    printf("%s %d %s %g %g %g %g\n", it->name, 11 + k - first, it->metal ? "metal" : "cut",
           (double)(it->metal ? it->width : cut_width(l, k)) / UNITS, (double)it->spacing / UNITS,
           it->metal ? 0 : (double)enclosure(l, k) / UNITS, (double)it->wide / UNITS);
  }
}

static void pins(const design *d) {
  for (int k = 0; k < d->nets; k++) {
    const net *n = &d->net[k];
    for (int p = 0; p < n->pins && !n->power; p++) {
      lef_rect r = design_terminal(d, n->pin[p]);
      printf("%s %s %g %g\n", n->name, d->lib->layer[r.layer].name, (r.x0 + r.x1) / 2.0 / UNITS,
             (r.y0 + r.y1) / 2.0 / UNITS);
    }
  }
}

int main(int argc, char **argv) {
  request r = {0};
  const char *command = argc > 1 ? argv[1] : "";
  for (int letter; optind = optind < 2 ? 2 : optind,
                   (letter = getopt(argc, argv, "b:c:d:j:l:m:n:rs:t:u:w:")) != -1;) {
    if (letter == '?') {
      return 2;
    }
    if (letter == 'l') {
      lef_read(&r.lib, optarg);
    }
    r.given[letter] = letter == 'r' ? "" : optarg;
  }
  if (argc != optind + 1) {
    errx(2, "usage: layout COMMAND -l LEF ... FILE");
  }
  r.file = argv[optind];
  design d;
  if (strcmp(command, "plan") == 0) {
    plan(&r, &d);
    return fflush(stdout) == 0 ? 0 : 2;
  }
  design_read_def(&d, &r.lib, r.file);
  if (strcmp(command, "tree") == 0) {
    tree(&r, &d);
  } else if (strcmp(command, "place") == 0) {
    settle(&r, &d);
  } else if (strcmp(command, "check") == 0) {
    return place_check(&d) > 0;
  } else if (strcmp(command, "bookshelf") == 0) {
    place_write(&d, wanted(&r, 'd'));
  } else if (strcmp(command, "route") == 0) {
    int failed = route_nets(&d, (int)number(&r, 't', 6), (int)number(&r, 'n', 200));
    design_write_def(&d, stdout);
    return failed > 0;
  } else if (strcmp(command, "rules") == 0) {
    rules(&r.lib);
  } else if (strcmp(command, "pins") == 0) {
    pins(&d);
  } else if (strcmp(command, "verilog") == 0) {
    design_write_verilog(&d, stdout);
  } else if (strcmp(command, "wires") == 0) {
    wires(&r, &d);
  } else {
    errx(2, "%s: no such command; plan, tree, place, check, bookshelf, verilog or wires", command);
  }
  return fflush(stdout) == 0 ? 0 : 2;
}
