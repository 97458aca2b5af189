/* SPDX-License-Identifier: MIT */
// traits.h - what a design does, from its macros: its last axis, the time between its pairs, and
// how long it may rest or wait.
#ifndef SEPAX_TRAITS_H
#define SEPAX_TRAITS_H

#include "ports.h"
#include "sepax_design.h"
#include "sepax_params.h"

#ifdef SEPAX_CONFERENCE
constexpr double PAPER_PS = 2500; // 400 MHz, table 4
#else
constexpr double PAPER_PS = 2000;
#endif
#if !SEPAX_EXACT
constexpr int LAST_AXIS = 0; // none is told
#elif defined SEPAX_EXTENT_A
constexpr int LAST_AXIS = SEPAX_AXIS_EXTENT;
#elif defined SEPAX_BOXES || defined SEPAX_BANDS
constexpr int LAST_AXIS = SEPAX_AXIS_AABB;
#else
constexpr int LAST_AXIS = SEPAX_AXIS_PLANE;
#endif
// Cycles between pairs of a full stream.
constexpr uint64_t PACE = SEPAX_II > INPUT_WORDS ? SEPAX_II : INPUT_WORDS;
// Without stress the first pairs go alone, until so many latencies were seen.
constexpr uint64_t ALONE_LATENCIES = 3, ALONE_PAIRS = 32;
// A pair is alone after so many idle cycles. Behind an AABB test or a skid buffer a pair may be
// taken before the II window of the core, empty by then, ends.
#if defined SEPAX_BOXES || defined SEPAX_STREAM || defined SEPAX_SKID
constexpr uint64_t SETTLE = 1 + 2 * SEPAX_II;
#else
constexpr uint64_t SETTLE = 1;
#endif
// Empty for more cycles, a design takes a pair at once.
constexpr uint64_t RESTED = 1 + 2 * SEPAX_II;
#if defined SEPAX_EXTENT_A
constexpr uint64_t BOXES = 2;
#elif defined SEPAX_BOXES
constexpr uint64_t BOXES = 1;
#else
constexpr uint64_t BOXES = 0;
#endif
#if defined SEPAX_SKID || defined SEPAX_STREAM
constexpr uint64_t SKID = 1;
#else
constexpr uint64_t SKID = 0;
#endif
constexpr int LEAVES = 1 + (int)SKID; // cycles from a verdict that leaves to a pair
// A pair that is taken enters the core at once: every pair has the same latency. Else the cycles
// for which it may wait before the core while no verdict is blocked.
constexpr bool CONSTANT = BOXES + SKID == 0;
constexpr uint64_t WAIT = (SEPAX_II - 1) * (BOXES + SKID);
// Cycles of waiting, out_ready high, with no transfer on either side.
constexpr uint64_t PATIENCE = 2000 + 64 * (SEPAX_LATENCY + SEPAX_II);

#endif
