/* SPDX-License-Identifier: MIT */
/* query.h - a search for one collision that ends after some work or time (private). */
#ifndef SEPAX_QUERY_H
#define SEPAX_QUERY_H

#include "body.h"

/* Units of work of an exact test. */
enum { WORK_EXACT = 50 };

typedef struct {
  uint64_t most;  /* units of work; 0: no limit */
  double seconds; /* 0: no limit */
  uint64_t work;  /* units that were taken */
  bool rough;     /* end at a pair that only exact arithmetic decides, and do not decide it */
  bool in_doubt;  /* such a pair ended the search */
  bool ended;     /* a limit ended the search, or such a pair */
} search_limits;

/* Find a pair of triangles that collide; place[k] receives the place of that of body k. False if
 * there is none, or none was found within the limits. If a pair is in doubt, then place[k] receives
 * the box of its triangle of body k. Both poses are valid. Allocates nothing. */
bool sepax__find_collision(const sepax_body *a, const sepax_pose *pose_a, const sepax_body *b,
                           const sepax_pose *pose_b, sepax_simd simd, search_limits *limits,
                           uint32_t place[2]);

#endif
