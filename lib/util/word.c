/* SPDX-License-Identifier: MIT */
/* word.c - the range of a coordinate of W bits. */
#include "sepax_grid.h"

int32_t sepax_word_min(int word) { return (int32_t)(-(INT64_C(1) << (word - 1))); }

int32_t sepax_word_max(int word) { return (int32_t)((INT64_C(1) << (word - 1)) - 1); }
