/* SPDX-License-Identifier: MIT */
/* output.h - a generated design as a folder of files. */
#ifndef SEPAX_OUTPUT_H
#define SEPAX_OUTPUT_H

#include "emit/emit.h"

/* Write the design's files into a folder: one .v a module, sepax.f (the list of
 * them, top last), and, if the emitter has a design, sepax_params.h, sepax_params.vh and sepax.json
 * (configuration, formats, latency, ports) for test benches, sepax.sdc and for Xilinx sepax.xdc
 * (the clock), sepax.gtkw (ports for GTKWave), of an engine its registers. Each file is written
 * aside and renamed; the folder is made if missing, with those
 * that it is in, and removed again if the run fails. Files of a
 * design that was there before go: those named sepax_... or sepax. ... that begin with a generated
 * file's banner. All names have the emitter's prefix in place of sepax. `absolute` adds
 * sepax_absolute.f, with the paths of the modules from the root. */
bool gen_write(const emitter *e, const char *folder, bool absolute, sepax_error *error);

#endif
