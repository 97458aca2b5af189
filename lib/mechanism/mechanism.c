/* SPDX-License-Identifier: MIT */
/* mechanism.c - completes and frees mechanisms. */
#include "mechanism/steps.h"

void sepax_mechanism_free(sepax_mechanism *m) {
  for (size_t n = 0; n < m->links && m->link != NULL; n++) {
    sepax_release(m->link[n].name);
  }
  for (size_t n = 0; n < m->joints && m->joint != NULL; n++) {
    sepax_release(m->joint[n].name);
  }
  sepax_release(m->link);
  sepax_release(m->joint);
  sepax_release(m->order);
  *m = (sepax_mechanism){0};
}

bool sepax_mechanism_join(sepax_mechanism *m, sepax_error *error) {
  size_t wrong;
  return sepax__mechanism_join(m, &wrong, error);
}
