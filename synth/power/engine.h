/* engine.h - an object engine as gates: what stands around it, for a whole run in 64 lanes.
 */
#ifndef SEPAX_POWER_ENGINE_H
#define SEPAX_POWER_ENGINE_H

#include "gates.h"
#include "sepax_design.h"

/* What of it is counted: from START to the end of the last lane's run; both objects as they come;
 * the cycles after the run, in which nothing comes. */
typedef enum { POWER_RUN, POWER_LOADING, POWER_IDLE } engine_part;

/* Of all lanes; pairs as the engine's registers have them. */
typedef struct {
  uint64_t pairs, collisions, coplanar, out_of_range;
  uint64_t wrong;
} engine_tally;

/* Play the memories (a word is there in the cycle after it was asked for) and the buses of
 * sepax_engine_logic: both objects of the scene are loaded, each lane's from another triangle on,
 * and run once (not for POWER_LOADING), results taken as they come. wrong counts results, in order,
 * ends, answers and counts that are not sepax_engine's. `cycles` are those of POWER_IDLE. Exits
 * with status 2 if the objects do not fit. */
engine_tally engine_run(gates *g, const sepax_design *design, const sepax_scene *scene,
                        engine_part part, int cycles);

#endif
