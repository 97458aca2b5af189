/* float.c - the software baselines: SAT in IEEE single and double precision. */
#include "sepax.h"

#define REAL float
#define NAME(name) name##_32
#include "float_sat.h"
#undef REAL
#undef NAME

#define REAL double
#define NAME(name) name##_64
#include "float_sat.h"
#undef REAL
#undef NAME

bool sepax_float32(const sepax_tri *a, const sepax_tri *b) { return collide_32(a, b); }

bool sepax_float64(const sepax_tri *a, const sepax_tri *b) { return collide_64(a, b); }
