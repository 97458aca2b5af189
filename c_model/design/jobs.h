/* jobs.h - what one pose of a scene gives a design to do, and how long that takes (private). */
#ifndef SEPAX_JOBS_H
#define SEPAX_JOBS_H

#include "sepax_design.h"
#include "util/aabb.h"

/* Two quantised bodies, with the AABBs of their triangles. */
typedef struct {
  sepax_tri *tri[2];
  aabb *bounds[2];
  size_t count[2]; /* below 2^32 */
} job_bodies;

/* The job of these bodies. Fails without memory. */
bool job_find(sepax_job *job, const job_bodies *bodies, sepax_error *error);

/* The cycles of a job of count[0] x count[1] triangles, without loading and the core's latency:
 * with lanes as the golden model of the engine says; of a core alone, all pairs and those that take
 * two passes. `steps` has space for job->passes numbers. */
uint64_t job_cycles(const sepax_job *job, const size_t count[2], const sepax_config *config,
                    uint64_t *steps);

/* No job of `passes` passes of candidates takes fewer cycles. */
uint64_t job_least_cycles(uint64_t passes, const size_t count[2], const sepax_config *config);

#endif
