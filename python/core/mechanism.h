/* SPDX-License-Identifier: MIT */
/* mechanism.h - handles of mechanisms and robots (private). */
#ifndef SEPAX_PYTHON_MECHANISM_H
#define SEPAX_PYTHON_MECHANISM_H

#include "core.h"
#include "sepax_robot.h"

/* A mechanism that Python described, or the one of a robot's file. */
typedef struct {
  const sepax_mechanism *mechanism;
  sepax_mechanism own;
  sepax_robot robot;
} core_mechanism;

#define CORE_MECHANISM "sepax.mechanism"

core_mechanism *core_mechanism_of(PyObject *handle);

/* A handle that owns all that *from has; on failure it is freed. */
PyObject *core_mechanism_handle(const core_mechanism *from);

#endif
