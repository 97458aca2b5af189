/* SPDX-License-Identifier: MIT */
/* exact.h - architecture exact: its expression graph (docs/reference/exact.md), the registers
 * inside its units, its cycles, its modules. */
#ifndef SEPAX_EXACT_H
#define SEPAX_EXACT_H

#include "arith/arith.h"
#include "datapath/times.h"
#include "emit/template.h"
#include "sepax_design.h"

/* Kinds of units that may have no register behind them: chained to the units that read them. Each
 * is a bit of a set. */
enum {
  EXACT_CHAIN_T = 1, /* trapezoids */
  EXACT_CHAIN_G = 2, /* orient2d and z sums */
  EXACT_CHAIN_H = 4, /* prisms */
  EXACT_CHAIN_D = 8, /* orient3d */
  EXACT_CHAIN_ALL = 15
};
static inline bool exact_is_chained(unsigned chained, unsigned kinds) {
  return (chained & kinds) == kinds;
}

/* What sepax_axis does one after the other before its products; a register may stand behind each.
 */
enum { AXIS_COMPARED, AXIS_PICKED, AXIS_DIFFERENCES, AXIS_CHOSEN, AXIS_CUTS };

/* Registers of sepax_axis, besides those of the pair: axis.c. */
typedef struct {
  bool cut[AXIS_CUTS];
  arith_plan product; /* gates: both products and what is left of their sum; FPGA: one of them */
  bool in_turn;       /* gates: they take turns, in the cycle of this product and the next */
  bool late;          /* behind that test */
} exact_axis;

/* Registers inside the units, and the longest stage that is left: stages.c. */
typedef struct {
  exact_axis axis;
  arith_plan trapezoid, prism, own_prism;
  arith_plan prism_of_two; /* where the z sum is a sum of two differences */
  bool trapezoid_sums;     /* between a trapezoid's sums and its product */
  int orient3d;            /* behind its sum; 2: behind its rows, too */
  int orient3d_latency;
  bool fetch_2d, fetch_3d; /* in front of an orient2d, an orient3d, whose operands are selected */
  bool slot_copies;        /* of what selects operands of orient2d and of z sums */
  bool own_zsum;           /* inside B's z sum */
  bool zdiff_shared; /* z sums are sums of z differences, which settle in the same cycle (II = 1) */
  unsigned chained;  /* kinds without a register behind them: a set of EXACT_CHAIN_ */
  bool most, total;  /* inside a limit: behind its first maximum, its products */
  double shortest;   /* the period in ns that the longest stage needs */
} exact_stages;

enum { EXACT_BUSES = 10, EXACT_BUS = 20 };

/* Values that are read together, by the name of a port; they end with 0, buses with port NULL. */
typedef struct {
  const char *port;
  graph_value value[EXACT_BUS];
} exact_bus;

/* Kinds that start in a cycle of their own; others start as soon as they can. */
typedef struct {
  int trapezoid[3], orient2d[3], own_orient2d[3];
  int zdiff, zsum, own_zdiff, own_zsum, prism, running_sum;
} exact_kinds;

/* Values by vertices: 0 ... 2 are A's, 3 ... 5 B's; by projection: on xy, yz, zx. Projections 1 and
 * 2 are there with a clearance. */
typedef struct {
  graph *graph;
  exact_kinds kind;
  graph_value coordinate[3][6];    /* x, y, z */
  graph_value t[3][6][6];          /* trapezoid terms; t_ji = -t_ij */
  graph_value g[3][6][6][6];       /* orient2d; the sign is that of the permutation */
  graph_value zdiff[3][6];         /* z of B's vertex less that of A's, where they are shared */
  graph_value h[6][6][6];          /* signed prism volumes, signs as g */
  graph_value s[3], w[3], d[3][3]; /* orient3d: B_k and A's plane, A_i and B's, edges i and j */
  exact_bus verdict[EXACT_BUSES], projection[EXACT_BUSES]; /* that the last modules read */
} exact_graph;

typedef struct {
  const sepax_design *design;
  const delay_model *delay;
  int limits;       /* of a clearance, 0 ... 2; with it orient3d comes whole, not as a sign */
  bool single;      /* coplanar pairs are not decided in their plane, and any projection does */
  bool running;     /* orient3d of A's plane and B's z sum are summed term by term (II = 3) */
  bool own_running; /* orient2d of A and of B, too; B's z sum of differences behind a register */
  exact_stages stages;
  exact_graph graph;
  datapath datapath;
  int plane_cycle;   /* it is known whether the pair is separated if it is coplanar */
  bool ripple;       /* there is time for adders that are chains of full adders */
  int verdict_cycle; /* the pair is judged; counted from the core's first registers, as all cycles
                      */
} exact_plan;

/* Schedule the design. Fails if the clock is too fast for a stage that has no place for
 * a register. */
bool exact_plan_make(exact_plan *p, const sepax_design *design, sepax_error *error);

/* Place registers inside the units for this period in ns at the typical corner. */
void exact_stages_make(exact_plan *p, double period);

/* axis.c: place the registers of sepax_axis for stages of so many ns; returns the longest stage
 * that has no place for a register. Then its latency, 0 if the design has none. */
double exact_axis_place(exact_plan *p, double available);
int exact_axis_latency(const exact_plan *p);

/* Its longest stage in ns, an upper estimate, if each adder is a chain of full adders. */
double exact_axis_ripple_time(const exact_plan *p);

/* Cycles from the operands to the result. */
int exact_trapezoid_latency(const exact_plan *p);
int exact_order_latency(const exact_plan *p); /* of the order beside a trapezoid */
int exact_orient2d_latency(const exact_plan *p);
int exact_zsum_latency(const exact_plan *p);
int exact_own_zsum_latency(const exact_plan *p);
int exact_prism_latency(const exact_plan *p, const arith_plan *multiplier);
int exact_orient3d_latency(const exact_plan *p);

/* The longest chain, in ns, registers included, if these kinds of units have no register behind
 * them: a set of EXACT_CHAIN_. It is an upper estimate. */
double exact_chain_time(const exact_plan *p, unsigned chained);

/* The same if all kinds are chained and each adder is a chain of full adders. Infinite for an
 * engine and for a design with a clearance, whose other adders are not known here. */
double exact_ripple_time(const exact_plan *p);

/* May these kinds be chained in this period in ns? Units with registers inside may not. */
bool exact_may_chain(const exact_plan *p, unsigned chained, double period);

/* What a plan costs, to compare it with others of its configuration: cycles, bits, thirds of a gate
 * equivalent. What all of them have in common is left out. */
typedef struct {
  int latency, flip_flops, gates;
} exact_counts;
exact_counts exact_count(const exact_plan *p);

/* What a plan consists of, in bits: full adders inside the units; their additions; inputs of
 * multiplexers beyond the first; rows of partial products; flip-flops that load in each cycle, of
 * units, delay lines and control; flip-flops with an enable, of holding registers and of
 * coordinates. */
typedef struct {
  int full_adders, additions, multiplexers, rows;
  int registers, control, holding, coordinates;
} exact_parts;
exact_parts exact_parts_of(const exact_plan *p);

/* axis.c: add those of sepax_axis. */
void exact_axis_count(const exact_plan *p, exact_parts *parts);

/* Flip-flops of sepax_narrow and its queue. */
int exact_control_count(const exact_plan *p);

/* Schedule the stages of the plan. */
void exact_schedule(exact_plan *p);

/* latency.c: the cycles of both judges, and the latency that follows: from a pair taken to its
 * verdict, both counted; of sepax_narrow, and of sepax_top. It is that of every pair. */
void exact_place_judges(exact_plan *p);
int exact_narrow_latency(const exact_plan *p);
int exact_latency(const exact_plan *p);

/* Registers in which it waits until the verdict whether the pair is separated in its plane. */
int exact_waits(const exact_plan *p);

/* The cycle in which signs are taken for the plane: on an FPGA two before it is judged. */
int exact_projection_cycle(const exact_plan *p);

/* The vertices A_i and B_j, indices modulo 3; the vertex that follows v in its triangle. */
int exact_a(int i);
int exact_b(int j);
int exact_next(int v);

/* Triangles of both: 0 ... 8 an edge of A with a vertex of B, 9 ... 17 an edge of B with a vertex
 * of A; edges ij of A and kl of B, 0 ... 8. By cyclic symmetry classes. */
typedef struct {
  int i, j, k;
} exact_triangle;
exact_triangle exact_triangle_of(int n);
typedef struct {
  int i, j, k, l;
} exact_edges;
exact_edges exact_edges_of(int n);

/* Projections on xy, yz, zx: what names end with, slot copies of trapezoid terms and orient2d. */
typedef struct {
  const char *suffix, *slots_t, *slots_g;
} exact_projection;
extern const exact_projection exact_projections[];

/* Build the graph: values, kinds, buses. */
void exact_graph_make(exact_plan *p);

/* Its trapezoid terms and orient2d in a projection. */
void exact_graph_projection(exact_plan *p, int projection);

/* An operation on a triangle; its label begins with A's vertices. */
graph_value exact_add(exact_graph *e, int kind, exact_triangle v, const graph_value operand[],
                      graph_value beside);

/* Emit every module of architecture exact, leaves first, and of the engine around it, its top last
 * (`sepax_top`, `sepax_stream`, `sepax_engine`). Sets the latency of the emitter's design. False
 * with e->error set if the clock is too fast or the emitter refuses a module. */
bool gen_exact(emitter *e);

/* Modules; what one of them sets in the list of holes, the next finds there or sets anew. */
void gen_exact_units(emitter *e, const exact_plan *p, emit_holes *h);
void gen_exact_core(emitter *e, exact_plan *p, emit_holes *h);
void gen_axis(emitter *e, const exact_plan *p, emit_holes *h);

#endif
