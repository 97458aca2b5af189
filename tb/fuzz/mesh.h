/* SPDX-License-Identifier: MIT */
/* mesh.h - any bytes as a mesh file. */
#ifndef FUZZ_MESH_H
#define FUZZ_MESH_H

#include "fuzz/fuzz.h"
#include "sepax_io.h"

/* The bytes as a file of this name: what is read is finite, and the account agrees with it. */
void fuzz_mesh(const uint8_t *data, size_t size, const char *name);

#endif
