/* SPDX-License-Identifier: MIT */
/* float.c - the software baselines in IEEE single and double precision: SAT, the interval test, and
 * the test of Guigue and Devillers. */
#include "models/guigue.h"
#include "sepax_models.h"

#define REAL float
#define NAME(name) name##_32
#include "float_sat.h"
#include "float_interval.h"
#include "float_guigue.h"
#undef REAL
#undef NAME

#define REAL double
#define NAME(name) name##_64
#include "float_sat.h"
#include "float_interval.h"
#include "float_guigue.h"
#undef REAL
#undef NAME

bool sepax_float32(const sepax_tri *a, const sepax_tri *b) { return collide_32(a, b); }

bool sepax_float64(const sepax_tri *a, const sepax_tri *b) { return collide_64(a, b); }

bool sepax_interval32(const sepax_tri *a, const sepax_tri *b) { return intervals_overlap_32(a, b); }

bool sepax_interval64(const sepax_tri *a, const sepax_tri *b) { return intervals_overlap_64(a, b); }

bool sepax_guigue32(const sepax_tri *a, const sepax_tri *b) { return guigue_32(a, b); }

bool sepax_guigue64(const sepax_tri *a, const sepax_tri *b) { return guigue_64(a, b); }
