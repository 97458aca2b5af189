/* SPDX-License-Identifier: MIT */
/* simd.h - the contract of headers that are included once for each set of vector instructions
 * (private): batch/lanes.h, body/filter.h, body/boxes.h, distance/reach.h, and for each width of
 * integers verdict/exact_sums.h.
 *
 * The including file defines these macros before each inclusion, and the header undefines them at
 * its end:
 *
 * SIMD_NAME(x)     x with a suffix of the instruction set, so that each inclusion has own names
 * SIMD_TARGET      the attribute of functions for that set, or nothing
 * SIMD_LANES       how many 64-bit numbers (doubles, whole numbers) a vector has
 * SIMD_FLOATS      how many 32-bit numbers a vector has, where the header uses such
 * SIMD_BITS(v)     the sign bits of a vector as a number: bit n is that of lane n
 *
 * What only one header needs beyond these stands at its beginning. SIMD_UNROLL is the including
 * file's pragma that keeps short loops in registers. Vectors are the extension of GCC and Clang. */
#ifndef SEPAX_UTIL_SIMD_H
#define SEPAX_UTIL_SIMD_H

/* Functions, and the vectors: doubles, 64-bit whole numbers, int32_t, floats, and int32_t that are
 * the results of comparisons. The header declares the types that it uses. */
#define SIMD_INLINE SIMD_TARGET static inline __attribute__((always_inline))
#define SIMD_REAL SIMD_NAME(reals)
#define SIMD_WHOLE SIMD_NAME(lanes)
#define SIMD_SHORT SIMD_NAME(shorts)
#define SIMD_FLOAT SIMD_NAME(floats)
#define SIMD_MASK SIMD_NAME(masks)

#endif
