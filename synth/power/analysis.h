/* SPDX-License-Identifier: MIT */
/* analysis.h - what the parts of build/power share. */
#ifndef SEPAX_POWER_ANALYSIS_H
#define SEPAX_POWER_ANALYSIS_H

#include "gates.h"
#include "sepax_design.h"

typedef struct {
  const char *liberty, *netlist, *design, *pins, *by_cell;
  const char *mesh[2], *poses;
  double period, global, fault, resolution;
  int cycles;
  bool idle, loading, as_sta;
  double glitches; /* 0: none; share of a delay that a pulse lasts which passes */
} request;

typedef struct {
  const request *want;
  sepax_design design;
  bool exact;
  const struct power_engine *engine;
  library lib;
  gates g;
  double *act, *one;       /* of each net: transitions a cycle, share of ones */
  double *settled;         /* act without glitches */
  double error;            /* of the power, of a pair's energy where pairs come: gates_error */
  double *load;            /* of each net, F */
  int *loads;              /* pins that read it */
  double (*slope)[2];      /* of each net: rising, falling, ns */
  size_t pairs, undecided; /* of all given, those beyond the extents */
  uint64_t poses;          /* of a tree engine */
  gates_count taken_by;    /* pairs of each group */
  uint64_t taken, judged, wrong, collisions, coplanar; /* while it counts, but wrong: always */
} analysis;

typedef struct {
  double leakage, internal, switching;
} watts;

/* The request's meshes, quantised. */
sepax_scene power_meshes(const analysis *m);

/* How the gates of a design with an engine are simulated; main.c has the table. */
typedef struct power_engine {
  /* All that the request asks for; what comes out is compared with the golden model's. NULL: it
   * cannot be simulated. */
  void (*simulate)(analysis *m);
  const char *compared; /* "verdicts" */
  bool loads;           /* objects, which can be measured by itself */
  bool runs;            /* by itself, so that a run has an energy; its memories are not counted */
} power_engine;

/* Simulate the gates with all pairs of the meshes, or with those on standard input; each verdict is
 * compared with the golden model's. */
void power_pairs(analysis *m);

/* An object engine: load the meshes into it and let it run, or what the request asks for of that;
 * its results, ends and counters are compared with the golden model's. Exits if the meshes do not
 * fit. */
void power_object(analysis *m);

/* A tree engine: walk the poses, or be idle after them; all that it sends is compared with the
 * golden model's. Exits if there are no poses. */
void power_tree(analysis *m);

/* Before the simulation: loads and slopes of nets; with glitches, delays of cells. */
void power_prepare(analysis *m);

/* From the simulation's counts, or the request's global activity: transitions. */
void power_count(analysis *m);

/* What a cell draws. */
watts power_of(const analysis *m, const gates_cell *cell);

/* All cells together (W). */
double power_sum(const analysis *m);

/* The files of pins and of cells that the request names, and JSON on standard output. */
void power_report(const analysis *m);

#endif
