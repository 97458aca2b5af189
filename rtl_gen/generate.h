/* SPDX-License-Identifier: MIT */
/* generate.h - the door of rtl_gen: from a checked design to a folder of Verilog.
 *
 * Behind it: an architecture (exact, paper, conference) emits its modules, leaves first; the
 * emitter (emit/) checks each of them; an engine (engine/, object_engine/, tree_engine/, stream/)
 * adds what stands around the core; files/ writes the folder. */
#ifndef SEPAX_GENERATE_H
#define SEPAX_GENERATE_H

#include "files/how.h"
#include "sepax_design.h"

/* Write the Verilog of the design into the folder, which is made if it is missing, and the files
 * that tell about the design (files/output.h lists them). Sets design->latency, in cycles, where
 * the schedule that is made here fixes it. Fails if the architecture has no hardware, if the prefix
 * does not fit (emit/prefix.h), if the clock period is too short for a stage, if the emitter
 * refuses a module, without memory, and if a file cannot be written; then the folder is as it was.
 */
bool sepax_generate(sepax_design *design, const char *folder, const sepax_output *how,
                    sepax_error *error);

/* Fails if the architecture of the configuration has no hardware. */
bool generate_check(const sepax_config *config, sepax_error *error);

#endif
