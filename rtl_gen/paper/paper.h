/* SPDX-License-Identifier: MIT */
/* paper.h - architecture paper, and what it has in common with conference. */
#ifndef SEPAX_PAPER_H
#define SEPAX_PAPER_H

#include "emit/emit.h"

/* Emit the modules, leaves first, up to NULL; false with e->error set if one is refused.
 * sepax_norm is left out of designs without block floating point. Their holes: each format's name
 * (bits kept) and NAME_exact (sepax.json lists them), msb, min, max of a coordinate, latency,
 * coplanar_limit and epsilon; conditions plane, printed, block_float; of sepax_psa its name, axes
 * and nine, six or both. */
bool paper_emit(emitter *e, const char *const *module);

/* Emit every module of architecture paper, leaves first, sepax_top last; false with e->error set if
 * one is refused. */
bool gen_paper(emitter *e);

#endif
