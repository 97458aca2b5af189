/* SPDX-License-Identifier: MIT */
/* graph.c - nodes and kinds of an expression graph. */
#include "graph.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

const char *graph_vertex_name(int vertex) {
  static const char *const name[] = {"a1", "a2", "a3", "b1", "b2", "b3", "x", "y", "z"};
  return name[vertex];
}

void graph_fault(graph *g, const char *why) { g->fault = g->fault != NULL ? g->fault : why; }

int graph_kind_add(graph *g, const graph_row *row, const char *suffix, int latency,
                   const char *slots) {
  if (g->kinds == GRAPH_KINDS) {
    graph_fault(g, "more kinds than GRAPH_KINDS");
    return 0;
  }
  graph_kind *k = &g->kind[g->kinds];
  *k = (graph_kind){.row = *row, .latency = latency, .slots = slots};
  int length = snprintf(k->symbol, sizeof k->symbol, "%s%s", row->symbol, suffix);
  if (length >= GRAPH_SYMBOL) {
    graph_fault(g, "a symbol that is longer than GRAPH_SYMBOL");
  }
  return g->kinds++;
}

static graph_node *new_node(graph *g, int kind) {
  if (g->nodes == 0) {
    g->nodes = 1;
  }
  if (g->nodes == GRAPH_NODES) {
    graph_fault(g, "more nodes than GRAPH_NODES");
    g->nodes--;
  }
  graph_node *n = &g->node[g->nodes++];
  *n = (graph_node){.kind = kind};
  return n;
}

graph_value graph_coordinate(graph *g, int axis, int vertex) {
  graph_node *n = new_node(g, GRAPH_COORDINATE);
  n->axis = axis;
  n->vertex = vertex;
  return g->nodes - 1;
}

graph_value graph_constant(graph *g, const char *text, const char *width) {
  graph_node *n = new_node(g, GRAPH_CONSTANT);
  n->text = text;
  n->width = width;
  return g->nodes - 1;
}

graph_value graph_add(graph *g, int kind, const int vertex[], const graph_value operand[],
                      graph_value beside) {
  graph_node *n = new_node(g, kind);
  graph_kind *k = &g->kind[kind];
  int number = g->nodes - 1;
  if (k->operations == GRAPH_OPERATIONS) {
    graph_fault(g, "more operations of a kind than GRAPH_OPERATIONS");
    return number;
  }
  k->operation[k->operations++] = number;
  for (int i = 0; vertex[i] >= 0; i++) {
    if (strlen(n->label) + 3 > GRAPH_LABEL) {
      graph_fault(g, "a label that is longer than GRAPH_LABEL");
      return number;
    }
    strcat(n->label, graph_vertex_name(vertex[i]));
  }
  int negative = 0;
  for (int pass = 0; pass < 2; pass++) {
    for (int i = 0; operand[i] != 0; i++) {
      if ((operand[i] < 0) == (pass == 1)) {
        if (n->operands == GRAPH_OPERANDS) {
          graph_fault(g, "more operands than GRAPH_OPERANDS");
          return number;
        }
        n->operand[n->operands++] = abs(operand[i]);
        negative += pass;
      }
    }
  }
  if (negative != k->row.negative) {
    graph_fault(g, "a module that subtracts other operands");
  }
  n->beside = abs(beside);
  return number;
}

const graph_kind *graph_kind_of(const graph *g, graph_value v) {
  return &g->kind[g->node[abs(v)].kind];
}

const char *graph_width(const graph *g, graph_value v) {
  const graph_node *n = &g->node[abs(v)];
  return n->kind == GRAPH_COORDINATE ? "W"
         : n->kind == GRAPH_CONSTANT ? n->width
                                     : g->kind[n->kind].row.width;
}

bool graph_is_signed(const graph *g, graph_value v) {
  const graph_node *n = &g->node[abs(v)];
  return n->kind < 0 || g->kind[n->kind].row.is_signed;
}
