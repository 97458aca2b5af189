/* SPDX-License-Identifier: MIT */
/* registers.h - the register map of the tree engine. */
#ifndef SEPAX_TREE_REGISTERS_H
#define SEPAX_TREE_REGISTERS_H

#include "engine/registers.h"

extern const engine_registers tree_engine_registers;

#endif
