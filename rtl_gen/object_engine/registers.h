/* SPDX-License-Identifier: MIT */
/* registers.h - the register map of the object engine. */
#ifndef SEPAX_OBJECT_REGISTERS_H
#define SEPAX_OBJECT_REGISTERS_H

#include "engine/registers.h"

extern const engine_registers object_engine_registers;

#endif
