/* gen.h - from a checked design to its Verilog modules. */
#ifndef SEPAX_GEN_H
#define SEPAX_GEN_H

#include "emit/emit.h"

/* Emit every module of the design, leaves first, its top last (`sepax_top`; of an engine
 * `sepax_engine`). False with e->error set if the emitter refuses one. gen_exact also reports the
 * latency of the schedule it makes. */
bool gen_paper(emitter *e);
bool gen_exact(emitter *e, int *latency);
bool gen_conference(emitter *e);

/* Write the design's files into a folder: one .v a module, sepax.f (the list of
 * them, top last), and, if the emitter has a design, sepax_params.h, sepax_params.vh and sepax.json
 * (configuration, formats, latency, ports) for test benches, sepax.sdc and for Xilinx sepax.xdc
 * (the clock), sepax.gtkw (ports for GTKWave), of an engine its registers. Each file is written
 * aside and renamed; the folder is made if missing, and removed again if the run fails. Files of a
 * design that was there before go: those named sepax_... or sepax. ... that begin with a generated
 * file's banner. */
bool gen_write(const emitter *e, const char *folder, sepax_error *error);

#endif
