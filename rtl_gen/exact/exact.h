/* exact.h - architecture exact: the datapath of docs/exact.md as operations, and the
 * cycles and units they get. */
#ifndef SEPAX_EXACT_H
#define SEPAX_EXACT_H

#include "arith/arith.h"
#include "datapath/schedule.h"
#include "sepax_design.h"

/* Operations, by what they make of the two triangles; vertices and edges cyclic, edge i
 * from vertex i to i + 1. Operations that a turn of both triangles takes into each other
 * are an orbit and follow in threes, so that they meet in one unit when 3 divides II. */
typedef enum {
  EXACT_STRIP,   /* t: edges of A, of B (3 + 3), A_c B_{c+r} at 6 + 3r + c */
  EXACT_ORDER_X, /* signs of x_B - x_A, numbered as the strips */
  EXACT_AREA,    /* g: edge c of A with B_{c+r} at 3r + c, A_c with edge c + r of B at 9 + 3r + c */
  EXACT_AREA_SIGN, /* their signs */
  EXACT_WEIGHT,    /* sums of z for the areas' prisms */
  EXACT_ORDER_Z,   /* signs of z_B - z_A, numbered as the first nine areas */
  EXACT_OWN,       /* g of B itself, and of A itself */
  EXACT_OWN_SIGN,
  EXACT_OWN_WEIGHT, /* for B */
  EXACT_PRISM,      /* h, numbered as the areas */
  EXACT_OWN_PRISM,  /* h of B */
  EXACT_ABOVE_A,    /* signs of the volumes over A of B_k */
  EXACT_ABOVE_B,    /* signs of the volumes over B of A_i */
  EXACT_BETWEEN,    /* signs of the volumes of edge c of A and edge c + r of B, at 3r + c */
  /* With a clearance the volumes come whole, and there is more. The same in y and z, z and x: */
  EXACT_STRIP_YZ,
  EXACT_STRIP_ZX,
  EXACT_AREA_YZ,
  EXACT_AREA_ZX,
  EXACT_OWN_YZ,
  EXACT_OWN_ZX,
  EXACT_CROSS_XY, /* components of e x f, numbered as EXACT_BETWEEN */
  EXACT_CROSS_YZ,
  EXACT_CROSS_ZX,
  EXACT_LIMIT,      /* what twice a gap must exceed on e x f; */
  EXACT_OWN_LIMIT,  /* on N_B, N_A; */
  EXACT_EDGE_LIMIT, /* on what is normal to an edge of A, of B and z, x, y */
  EXACT_BEYOND_XY,  /* areas of both triangles against it, numbered as they; */
  EXACT_BEYOND_YZ,
  EXACT_BEYOND_ZX,
  EXACT_EDGE_XY, /* does it exceed it on what is normal to an edge of A, of B, and z; */
  EXACT_EDGE_YZ, /* x; */
  EXACT_EDGE_ZX, /* y */
  EXACT_BOX,     /* x, y, z: the gap of the boxes */
  EXACT_FAR_A,   /* does the volume over A of B_k exceed it; */
  EXACT_FAR_B,
  EXACT_FAR_BETWEEN,
  EXACT_SLOPE_A, /* how N_A goes along an edge of B */
  EXACT_SLOPE_B,
  EXACT_CLASSES
} exact_class_id;

enum { EXACT_UNITS = 18, EXACT_TERMS = 4 };

typedef struct {
  int operations;
  int start[EXACT_UNITS]; /* of each unit: cycle of slot 0 */
  int latency;            /* to the output register */
  int stream;             /* of unit 0 */
} exact_class;

enum { EXACT_BANKS = 40 };

typedef struct {
  const sepax_design *design;
  schedule schedule;
  exact_class class[EXACT_CLASSES];
  arith_plan strip_mul, prism_mul, own_mul;
  arith_plan low_prism_mul;   /* where the weight is a sum of two rises */
  bool strip_rank;            /* registers between the strip's sums and its product */
  int volume_ranks;           /* registers inside a volume: behind its sum, behind its rows, too */
  bool own_weight_rank;       /* registers inside B's weight */
  bool shared_rises;          /* weights are sums of rises, which are there at once (II = 1) */
  bool sign_rank;             /* an area's sign is registered behind the area */
  bool turns;                 /* the vertices go round: 3 divides II */
  int limits;                 /* of a clearance, 0 ... 2; with it volumes come whole */
  bool single;                /* no pair takes a second pass: the plane is not judged */
  bool most_rank, total_rank; /* registers inside a limit: behind its first maximum, its products */
  bool running;               /* volumes over A and B's weight are summed term by term (II = 3) */
  int u_bank[EXACT_BANKS], z_bank[EXACT_BANKS]; /* first cycle of each */
  int u_banks, z_banks; /* u: x, or y where all x are equal; bank 0 is x and y */
  int plane_cycle;      /* areas' signs are judged; last cycle of a frame */
  int verdict_cycle;
  int latency;     /* cycles from a pair taken to its verdict, both counted */
  double shortest; /* period in ns that the longest stage needs */
} exact_plan;

/* Schedule the design. Fails if the clock is too fast for a stage that has no place for
 * a register. */
bool exact_plan_make(exact_plan *p, const sepax_design *design, sepax_error *error);

/* Units of a class; the operation in a slot of a unit; where its value is; the slot it is
 * in; the z bank that covers a cycle. */
int exact_units(const exact_plan *p, exact_class_id id);
int exact_slots(const exact_plan *p, exact_class_id id, int unit);
int exact_operation(const exact_plan *p, exact_class_id id, int unit, int slot);
schedule_value exact_value(const exact_plan *p, exact_class_id id, int operation);
int exact_z_bank(const exact_plan *p, int cycle);

/* Operation numbers from vertices and edges, indices modulo 3. */
int exact_cross_strip(int a, int b); /* EXACT_STRIP, EXACT_ORDER_X */
int exact_edge_area(int i, int b);   /* edge i of A with B_b */
int exact_vertex_area(int a, int j); /* A_a with edge j of B */
int exact_between(int i, int j);

/* Operands of an operation as values: up to EXACT_TERMS; returns how many. */
int exact_operands(const exact_plan *p, exact_class_id id, int operation,
                   schedule_value operand[EXACT_TERMS]);

/* Projection 0, 1, 2 (x and y, y and z, z and x) of the classes that are there for each. */
exact_class_id exact_projected(exact_class_id of_xy, int projection);

/* Rows that a number is made of when it is multiplied by a factor: signed digits that are not 0. */
int exact_digits(int64_t factor);

/* The projection in words: "xy", "yz", "zx". */
const char *exact_projection_name(int projection);

/* Modules. */
void gen_exact_units(emitter *e, const exact_plan *p);
void gen_exact_core(emitter *e, const exact_plan *p);
/* With a clearance: modules of its own. */
void gen_exact_clear_units(emitter *e, const exact_plan *p);
/* "cycle", "3 cycles": a pair comes every ... */
void gen_exact_every(const exact_plan *p, char text[24]);
/* sepax_top, or sepax_near behind a box test; with extents gen_exact_near, else gen_exact_boxes
 * puts that test and sepax_top before it. */
void gen_exact_top(emitter *e, const exact_plan *p);
int gen_exact_near(emitter *e, const exact_plan *p); /* the cycles that it adds */
int gen_exact_boxes(emitter *e, const exact_plan *p);
/* The ports of sepax_top but for what extents and a clearance add. */
void gen_exact_ports(emit_module *m, int word);

#endif
