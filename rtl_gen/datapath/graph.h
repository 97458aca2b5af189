/* SPDX-License-Identifier: MIT */
/* graph.h - a datapath as an expression graph. A node is a coordinate, a constant or an operation
 * on other nodes; all that is emitted of it follows from the graph: names, widths, operands,
 * lifetimes, wires. */
#ifndef SEPAX_GRAPH_H
#define SEPAX_GRAPH_H

#include <stdbool.h>

#include "sepax_design.h"

enum {
  GRAPH_NODES = 640,
  GRAPH_KINDS = 64,
  GRAPH_OPERATIONS = 18, /* of one kind */
  GRAPH_UNITS = GRAPH_OPERATIONS,
  GRAPH_OPERANDS = 6,
  GRAPH_LABEL = 16,
  GRAPH_SYMBOL = 16,
  GRAPH_COORDINATE = -1,
  GRAPH_CONSTANT = -2,
  GRAPH_AXIS = 6 /* in labels, behind the vertices 0 ... 5: x, y, z */
};

/* A node by its number, or minus its number: the negated value. 0: no value. */
typedef int graph_value;

/* A kind of operation, one row of a table. A row without module has an expression, or else its
 * result is an optional output of the unit that it is beside. */
typedef struct {
  const char *symbol;                  /* of its values: t, g ... */
  const char *module;                  /* that computes it, or NULL */
  const char *lesser;                  /* the module without optional ports, or NULL */
  const char *operand[GRAPH_OPERANDS]; /* ports. "?name" is optional: left out of a unit where all
                                          optional operands of each operation are one value,
                                          because they cancel */
  int negative;                        /* operands that it subtracts, the last ones */
  const char *output;                  /* port of the result */
  const char *width;                   /* text for declarations */
  bool is_signed;
  const char *expression; /* Verilog, @ stands for the operand */
  const char *about;      /* comment above the units, or NULL */
  bool commutes;          /* operands that it adds are in any order, and those that it subtracts */
} graph_row;

/* The kinds of a graph: a row and what differs between graphs. */
typedef struct {
  graph_row row;
  char symbol[GRAPH_SYMBOL]; /* of the row, and maybe a projection: t_yz */
  int latency;               /* cycles from operands to the result */
  const char *slots;         /* name of the slot register copies that select its operands; NULL: the
                                slot itself does */
  int operations, operation[GRAPH_OPERATIONS]; /* nodes */
  unsigned rotated; /* bit c: cyclic symmetry class c begins with its member 1 */
  /* Binding: */
  int units, count[GRAPH_UNITS];     /* operations of each unit */
  int at[GRAPH_UNITS][SEPAX_II_MAX]; /* the node in each slot of each unit; 0: none */
  /* Schedule: */
  bool started;
  int start[GRAPH_UNITS];    /* cycle of slot 0 */
  int producer[GRAPH_UNITS]; /* of the output */
} graph_kind;

typedef struct {
  int kind;                              /* of an operation, or GRAPH_COORDINATE, GRAPH_CONSTANT */
  char label[GRAPH_LABEL];               /* the vertices: a1b2 */
  int operand[GRAPH_OPERANDS], operands; /* nodes */
  int beside;               /* it takes the slot and the unit's number of this node; 0 */
  int unit, slot;           /* binding */
  int axis, vertex;         /* of a coordinate: 0 x, 1 y, 2 z; 0 ... 5 */
  const char *text, *width; /* of a constant */
} graph_node;

typedef struct {
  const char *fault; /* NULL, or what the graph cannot hold or does not allow: it is none then */
  graph_node node[GRAPH_NODES]; /* node 0 is none */
  int nodes;
  graph_kind kind[GRAPH_KINDS];
  int kinds;
} graph;

/* Keep a fault, unless there is one already. */
void graph_fault(graph *g, const char *why);

/* A new kind; `suffix` ("" or "_yz") joins its symbol. Returns its number. */
int graph_kind_add(graph *g, const graph_row *row, const char *suffix, int latency,
                   const char *slots);

graph_value graph_coordinate(graph *g, int axis, int vertex);
graph_value graph_constant(graph *g, const char *text, const char *width);

/* An operation. `vertex` ends with -1 and makes its label; `operand` ends with 0. Negated operands
 * move behind the others; the row says how many there are. `beside`: a node, or 0. */
graph_value graph_add(graph *g, int kind, const int vertex[], const graph_value operand[],
                      graph_value beside);
#define GRAPH_OF(...) ((const int[]){__VA_ARGS__, -1})
#define GRAPH_IN(...) ((const graph_value[]){__VA_ARGS__, 0})
#define GRAPH_NONE ((const graph_value[]){0})

/* "a1" ... "b3", "x", "y", "z". */
const char *graph_vertex_name(int vertex);

const graph_kind *graph_kind_of(const graph *g, graph_value v);

/* Width and sign of a value's declaration. */
const char *graph_width(const graph *g, graph_value v);
bool graph_is_signed(const graph *g, graph_value v);

#endif
