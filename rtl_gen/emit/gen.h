/* gen.h - from a checked design to its Verilog modules. */
#ifndef SEPAX_GEN_H
#define SEPAX_GEN_H

#include "emit.h"

/* Emit every module of the design, leaves first, `sepax_top` last. False with
 * e->error set if the emitter refuses one. gen_exact also reports the latency of the
 * schedule it makes. */
bool gen_paper(emitter *e);
bool gen_exact(emitter *e, int *latency);
bool gen_conference(emitter *e);

/* Write the design's files into a folder: one .v a module, sepax.f (the list of
 * them, top last), and, if the emitter has a design, sepax_params.h and sepax.json
 * (configuration, formats, latency, ports) for benches. Each file is written aside and renamed; the
 * folder is made if missing, and removed again if the run fails. */
bool gen_write(const emitter *e, const char *folder, sepax_error *error);

/* Component i (0: the top one) of a bus that packs three of `width` bits, and its
 * sign bit: "bus[3*W-1:2*W]", "bus[3*W-1]". */
typedef struct {
  char text[2 * EMIT_NAME];
} gen_text;
gen_text gen_part(const char *bus, const char *width, int i);
gen_text gen_sign(const char *bus, const char *width, int i);

/* printf into a text by value. */
typedef struct {
  char text[1024];
} gen_line;
gen_line gen_format(const char *format, ...) __attribute__((format(printf, 1, 2)));

/* sepax_bounds: the least and the greatest of three coordinates; once a design. */
void gen_bounds(emitter *e);

/* One function per module of figure 5 and per leaf below it. */
void gen_trunc(emitter *e);
void gen_mul(emitter *e);
void gen_edge(emitter *e);
void gen_dot(emitter *e);
void gen_proj(emitter *e);
void gen_cop(emitter *e);
void gen_norm(emitter *e);
void gen_cross(emitter *e);
void gen_psa(emitter *e);
void gen_cmp(emitter *e);
void gen_nand(emitter *e);
void gen_top(emitter *e);

/* The halves that conference does not share: axes of table 1 across edges, axes of table 2, the
 * inner products of COP. */
void gen_psa_9(emitter *e);
void gen_psa_6(emitter *e);
void gen_cop_proj(emitter *e);

/* Pieces of sepax_top that paper and conference have in common: ports, widths, a word counter
 * and step_4 ... step_last; "a_1TO <= a_1FROM;" and so on; a sepax_proj of a bank. */
void gen_paper_ports(emit_module *m);
void gen_paper_widths(emit_module *m);
void gen_paper_control(emit_module *m, int last);
void gen_paper_input(emit_module *m); /* the clocked block of the banks begins */
void gen_paper_copy(emit_module *m, const char *indent, const char *to, const char *from);
void gen_paper_project(emit_module *m, const char *name, const char *parameters,
                       const char *enables, const char *bank, const char *axis, const char *result);

#endif
