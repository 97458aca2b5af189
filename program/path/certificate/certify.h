/* SPDX-License-Identifier: MIT */
/* certify.h - one motion between two lines. */
#ifndef SEPAX_PATH_CERTIFY_H
#define SEPAX_PATH_CERTIFY_H

#include "path/common/parts.h"

/* Are the surfaces of a pair proved to stay farther apart than the clearance from a line to the
 * next? The pair's own proof does not change. */
bool path_certify_segment(path_scene *scene, const path_question *q, const path_pair *pair,
                          size_t segment, bool *certified, sepax_error *error);

#endif
