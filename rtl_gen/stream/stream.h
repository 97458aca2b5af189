/* stream.h - the core on AXI4-Stream (docs/exact.md). */
#ifndef SEPAX_STREAM_H
#define SEPAX_STREAM_H

#include "emit/template.h"

/* sepax_stream around sepax_top, of which `pairs` may be in flight; `h` has the holes of sepax_top.
 */
void gen_stream(emitter *e, emit_holes *h, int pairs);

#endif
