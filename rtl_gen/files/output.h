/* SPDX-License-Identifier: MIT */
/* output.h - a generated design as a folder of files. */
#ifndef SEPAX_OUTPUT_H
#define SEPAX_OUTPUT_H

#include "emit/emit.h"
#include "files/how.h"
#include "sheet/sheet.h"

/* Write the design's files into a folder: one .v a module, sepax.f (the list of
 * them, top last), and, if the emitter has a design, sepax_params.h, sepax_params.vh and sepax.json
 * (configuration, formats, latency, ports) for test benches, sepax.sdc and for Xilinx sepax.xdc
 * (the clock), sepax.gtkw (ports for GTKWave), of an engine its registers; tb/sepax_tb.v, the test
 * bench (bench/bench.h), and doc/sepax.md and .html, the datasheet (sheet/sheet.h) with `costs`,
 * which are not read without a design; ip/sepax_pkg.vhd, sepax_if.sv, sepax.xml and of an engine
 * sepax.svd (ip/ip.h). All names have the emitter's prefix in place of sepax.
 * sepax_absolute.f has the paths of the modules from the root. files/folder.h says how the folder
 * is written, and which files of a former design go. */
bool gen_write(emitter *e, const char *folder, const sepax_output *how, const sheet_costs *costs,
               sepax_error *error);

#endif
