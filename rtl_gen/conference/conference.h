/* SPDX-License-Identifier: MIT */
/* conference.h - architecture conference: what the paper improves on
 * (docs/reference/conference.md). */
#ifndef SEPAX_CONFERENCE_H
#define SEPAX_CONFERENCE_H

#include "emit/emit.h"

/* Emit every module, leaves first, sepax_top last; false with e->error set if one is refused. */
bool gen_conference(emitter *e);

#endif
