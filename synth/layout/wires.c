/* SPDX-License-Identifier: MIT */
/* wires.c - see wires.h. */
#include "layout/wires.h"
#include "layout/files/words.h"
#include "liberty/text.h"

#include <err.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

typedef struct {
  int x, y, layer;
  int from;   /* the node before it on the way from the driver, -1: none, -2: not reached */
  double ohm; /* of the way there */
  double farad;
} node;

typedef struct {
  int a, b;
  double ohm, farad;
} edge;

/* The nodes of a net: first its pins. */
typedef struct {
  const design *d;
  const net *n;
  node *node;
  edge *edge;
  int nodes, edges;
  wires_sum *sum;
} graph;

static int add_node(graph *g, int x, int y, int layer) {
  for (int k = g->n->pins; k < g->nodes; k++) {
    if (g->node[k].x == x && g->node[k].y == y && g->node[k].layer == layer) {
      return k;
    }
  }
  g->node = text_more(g->node, (size_t)g->nodes, sizeof *g->node);
  g->node[g->nodes] = (node){.x = x, .y = y, .layer = layer, .from = -2};
  return g->nodes++;
}

static void add_edge(graph *g, int a, int b, double ohm, double farad) {
  g->edge = text_more(g->edge, (size_t)g->edges, sizeof *g->edge);
  g->edge[g->edges++] = (edge){a, b, ohm, farad};
}

static void add_wire(graph *g, int a, int b, const lef_layer *l) {
  double length = (double)abs(g->node[a].x - g->node[b].x) + abs(g->node[a].y - g->node[b].y);
  double um = length / UNITS;
  add_edge(g, a, b, l->ohm_per_square * length / l->width, l->farad * um);
  g->sum->millimetres += um / 1000;
  g->sum->farad += l->farad * um;
}

/* ---------------------------------------------------------------------- not routed */

/* Prim's tree, by the distance along x and y. */
static void span(graph *g, const int like[2]) {
  int pins = g->n->pins;
  int *near = text_alloc((size_t)pins, sizeof *near);
  bool *in = text_alloc((size_t)pins, sizeof *in);
  in[0] = true;
  for (int count = 1; count < pins; count++) {
    int best = -1;
    long least = 0;
    for (int k = 1; k < pins; k++) {
      const node *a = &g->node[k], *b = &g->node[near[k]];
      long far = labs((long)a->x - b->x) + labs((long)a->y - b->y);
      if (!in[k] && (best < 0 || far < least)) {
        best = k, least = far;
      }
    }
    in[best] = true;
    const lef_layer *l = &g->d->lib->layer[like[0]], *m = &g->d->lib->layer[like[1]];
    double um = (double)least / UNITS;
    double farad = (l->farad + m->farad) / 2 * um;
    add_edge(g, near[best], best,
             (l->ohm_per_square / l->width + m->ohm_per_square / m->width) / 2 * (double)least,
             farad);
    g->sum->millimetres += um / 1000;
    g->sum->farad += farad;
    for (int k = 1; k < pins; k++) {
      const node *a = &g->node[k], *b = &g->node[near[k]], *c = &g->node[best];
      if (!in[k] && labs((long)a->x - c->x) + labs((long)a->y - c->y) <
                        labs((long)a->x - b->x) + labs((long)a->y - b->y)) {
        near[k] = best;
      }
    }
  }
  free(near);
  free(in);
}

/* ---------------------------------------------------------------------- routed */

static bool on_segment(const node *p, const segment *s) {
  return p->layer == s->layer && p->x >= (s->x0 < s->x1 ? s->x0 : s->x1) &&
         p->x <= (s->x0 > s->x1 ? s->x0 : s->x1) && p->y >= (s->y0 < s->y1 ? s->y0 : s->y1) &&
         p->y <= (s->y0 > s->y1 ? s->y0 : s->y1);
}

static const node *on_way; /* by qsort */

static int by_way(const void *a, const void *b) {
  const node *p = &on_way[*(const int *)a], *q = &on_way[*(const int *)b];
  return p->x != q->x ? (p->x > q->x) - (p->x < q->x) : (p->y > q->y) - (p->y < q->y);
}

static void cut_wire(graph *g, const segment *s) {
  int *on = text_alloc((size_t)g->nodes, sizeof *on), count = 0;
  for (int k = g->n->pins; k < g->nodes; k++) {
    if (on_segment(&g->node[k], s)) {
      on[count++] = k;
    }
  }
  on_way = g->node;
  qsort(on, (size_t)count, sizeof *on, by_way);
  for (int k = 1; k < count; k++) {
    add_wire(g, on[k - 1], on[k], &g->d->lib->layer[s->layer]);
  }
  free(on);
}

static int next_metal(const lef *l, int layer) {
  for (int k = layer + 1; k < l->layers; k++) {
    if (l->layer[k].metal) {
      return k;
    }
  }
  return layer;
}

static bool touches(const lef_rect *r, const node *p, int half) {
  return r->layer == p->layer && p->x + half > r->x0 && p->x - half < r->x1 &&
         p->y + half > r->y0 && p->y - half < r->y1;
}

/* A pin is joined to the nodes whose wires touch it. */
static void join_pin(graph *g, int k) {
  terminal t = g->n->pin[k];
  const lef_macro *m = t.component < 0 ? NULL : g->d->cell[t.component].macro;
  int rects = m == NULL ? 1 : m->pin[t.pin].shape.rects;
  for (int j = 0; j < rects; j++) {
    lef_rect r = m == NULL ? g->d->port[t.pin].shape
                           : design_rect(&g->d->cell[t.component], &m->pin[t.pin].shape.rect[j]);
    for (int i = g->n->pins; i < g->nodes; i++) {
      if (touches(&r, &g->node[i], g->d->lib->layer[r.layer].width / 2)) {
        add_edge(g, k, i, 0.01, 0);
      }
    }
  }
}

static void follow(graph *g) {
  for (int k = 0; k < g->n->segments; k++) {
    const segment *s = &g->n->route[k];
    int a = add_node(g, s->x0, s->y0, s->layer);
    if (s->via == NULL) {
      (void)add_node(g, s->x1, s->y1, s->layer);
      continue;
    }
    int upper = next_metal(g->d->lib, s->layer);
    add_edge(g, a, add_node(g, s->x0, s->y0, upper), g->d->lib->layer[s->layer + 1].ohm_per_cut, 0);
    g->sum->vias++;
  }
  for (int k = 0; k < g->n->segments; k++) {
    if (g->n->route[k].via == NULL) {
      cut_wire(g, &g->n->route[k]);
    }
  }
  for (int k = 0; k < g->n->pins; k++) {
    join_pin(g, k);
  }
}

/* ---------------------------------------------------------------------- SPEF */

/* The way to each node from the driver; nodes in the order that they are found. */
static int walk(graph *g, int *order) {
  int found = 0;
  g->node[0].from = -1;
  order[found++] = 0;
  for (int k = 0; k < found; k++) {
    for (int e = 0; e < g->edges; e++) {
      int here = order[k];
      const edge *it = &g->edge[e];
      int to = it->a == here ? it->b : it->b == here ? it->a : -1;
      if (to >= 0 && g->node[to].from == -2) {
        g->node[to].from = here;
        g->node[to].ohm = it->ohm;
        order[found++] = to;
      }
    }
  }
  for (int e = 0; e < g->edges; e++) {
    g->node[g->edge[e].a].farad += g->edge[e].farad / 2;
    g->node[g->edge[e].b].farad += g->edge[e].farad / 2;
  }
  return found;
}

static void write_name(const graph *g, int k, FILE *out) {
  if (k >= g->n->pins) {
    fprintf(out, "%s:%d", g->n->name, k);
    return;
  }
  terminal t = g->n->pin[k];
  if (t.component < 0) {
    fprintf(out, "%s", g->d->port[t.pin].name);
  } else {
    const component *c = &g->d->cell[t.component];
    fprintf(out, "%s:%s", c->name, c->macro->pin[t.pin].name);
  }
}

static void write_net(graph *g, FILE *out) {
  int *order = text_alloc((size_t)g->nodes, sizeof *order);
  int found = walk(g, order);
  double farad = 0;
  for (int k = 0; k < found; k++) {
    farad += g->node[order[k]].farad;
  }
  fprintf(out, "\n*D_NET %s %.6g\n*CONN\n", g->n->name, farad * 1e12);
  for (int k = 0; k < g->n->pins; k++) {
    terminal t = g->n->pin[k];
    fprintf(out, t.component < 0 ? "*P " : "*I ");
    write_name(g, k, out);
    fprintf(out, " %s\n",
            t.component < 0 ? (g->d->port[t.pin].output ? "O" : "I")
            : k == 0        ? "O"
                            : "I");
    if (g->node[k].from == -2) {
      g->sum->open++;
      warnx("%s: no wire leads to pin %d of %s", g->n->name, k,
            t.component < 0 ? g->d->port[t.pin].name : g->d->cell[t.component].name);
    }
  }
  fprintf(out, "*CAP\n");
  for (int k = 0; k < found; k++) {
    fprintf(out, "%d ", k + 1);
    write_name(g, order[k], out);
    fprintf(out, " %.6g\n", g->node[order[k]].farad * 1e12);
  }
  fprintf(out, "*RES\n");
  for (int k = 1; k < found; k++) {
    fprintf(out, "%d ", k);
    write_name(g, g->node[order[k]].from, out);
    fputc(' ', out);
    write_name(g, order[k], out);
    fprintf(out, " %.6g\n", g->node[order[k]].ohm / 1000);
  }
  fprintf(out, "*END\n");
  free(order);
}

static void start(graph *g) {
  for (int k = 0; k < g->n->pins; k++) {
    lef_rect r = design_terminal(g->d, g->n->pin[k]);
    g->node = text_more(g->node, (size_t)g->nodes, sizeof *g->node);
    g->node[g->nodes++] = (node){(r.x0 + r.x1) / 2, (r.y0 + r.y1) / 2, r.layer, -2, 0, 0};
  }
}

wires_sum wires_write(const design *d, const int like[2], FILE *out) {
  wires_sum sum = {0};
  fprintf(out,
          "*SPEF \"IEEE 1481-1998\"\n*DESIGN \"%s\"\n*DATE \"\"\n*VENDOR \"sepax\"\n"
          "*PROGRAM \"layout\"\n*VERSION \"1\"\n*DESIGN_FLOW \"\"\n*DIVIDER /\n*DELIMITER :\n"
          "*BUS_DELIMITER []\n*T_UNIT 1 NS\n*C_UNIT 1 PF\n*R_UNIT 1 KOHM\n*L_UNIT 1 HENRY\n",
          d->name);
  for (int k = 0; k < d->nets; k++) {
    graph g = {.d = d, .n = &d->net[k], .sum = &sum};
    if (g.n->pins < 2 || g.n->power) {
      continue;
    }
    start(&g);
    if (g.n->segments > 0) {
      follow(&g);
    } else {
      span(&g, like);
    }
    write_net(&g, out);
    free(g.node);
    free(g.edge);
  }
  return sum;
}

double wires_half_girth(const design *d) {
  double sum = 0;
  for (int k = 0; k < d->nets; k++) {
    const net *n = &d->net[k];
    int x0 = 1 << 30, y0 = 1 << 30, x1 = -x0, y1 = -y0;
    for (int p = 0; p < n->pins && !n->power; p++) {
      lef_rect r = design_terminal(d, n->pin[p]);
      int x = (r.x0 + r.x1) / 2, y = (r.y0 + r.y1) / 2;
      x0 = x < x0 ? x : x0, x1 = x > x1 ? x : x1, y0 = y < y0 ? y : y0, y1 = y > y1 ? y : y1;
    }
    sum += n->pins > 1 && !n->power ? (double)(x1 - x0) + (y1 - y0) : 0;
  }
  return sum / UNITS / 1000;
}
