/* SPDX-License-Identifier: MIT */
/* describe.h - the files that tell benches and scripts about a design. */
#ifndef SEPAX_EMIT_DESCRIBE_H
#define SEPAX_EMIT_DESCRIBE_H

#include "emit/emit.h"

void describe_json(const emitter *e, emit_text *out);        /* sepax.json */
void describe_c(const sepax_design *design, emit_text *out); /* sepax_params.h */
void describe_verilog(const emitter *e, emit_text *out);     /* sepax_params.vh */
void describe_constraints(const emitter *e, emit_text *out); /* sepax.sdc, sepax.xdc: the clock */
void describe_waves(const emitter *e, emit_text *out);       /* sepax.gtkw: ports, by groups */

#endif
