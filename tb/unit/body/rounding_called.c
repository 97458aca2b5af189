/* SPDX-License-Identifier: MIT */
/* rounding_called.c - rounding.c with -O3, but functions that are called. */
#ifndef __clang__
#pragma GCC optimize("O3", "no-inline")
#endif
#define OTHER_OPTIONS
#include "rounding.c" /* NOLINT(bugprone-suspicious-include): compiled once more */
