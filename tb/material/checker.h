/* SPDX-License-Identifier: MIT */
/* checker.h - what sepax-certificate-check proves of a body and a probe. Its source is linked, but
 * its types have the names of ours, so it is called through doubles. */
#ifndef MATERIAL_CHECKER_H
#define MATERIAL_CHECKER_H

#include <stdbool.h>
#include <stddef.h>

typedef struct checker_body checker_body;

/* A body of triangles in the coordinates of its link. Ends the program without memory. */
checker_body *checker_open(const double (*corner)[3][3], size_t count);
void checker_close(checker_body *c);

/* Is no part of either body inside the other? They touch nowhere. */
bool checker_proves_outside(checker_body *body, checker_body *probe);

#endif
