/* SPDX-License-Identifier: MIT */
/* swept.h - whether two bodies are apart while one of them moves (private). */
#ifndef SEPAX_DISTANCE_SWEPT_H
#define SEPAX_DISTANCE_SWEPT_H

#include "body/body.h"

/* Are two bodies farther apart than `distance` while A moves? Each point of A goes straight from
 * its place in the pose `from` to its place in the pose `to`, and all points have done the same
 * part of their ways at the same time. Both poses are of A in B's coordinates. True is proved for
 * the doubles given, all rounding included. False proves nothing: the bodies come nearer, or `work`
 * comparisons of parts were not enough. Cost: about 0.2 microseconds for each comparison. The call
 * allocates nothing. */
bool sepax__swept_apart(const sepax_body *a, const sepax_pose *from, const sepax_pose *to,
                        const sepax_body *b, double distance, size_t work);

#endif
