/* SPDX-License-Identifier: MIT */
/* words.h - what a datasheet says about a design in sentences. */
#ifndef SEPAX_SHEET_WORDS_H
#define SEPAX_SHEET_WORDS_H

#include "sepax_design.h"
#include "sheet/page.h"

/* The name of the block: "exact collision test of two triangles". */
const char *words_title(const sepax_design *d);

/* Pairs a second, of `through_core` that the cores take: a stream may bring them more slowly. */
double words_pairs(const sepax_design *d, double through_core);

/* Paragraphs: what the block does; what its verdict is worth; what the numbers of a verdict mean;
 * the rules of its handshake. */
void words_purpose(const sepax_design *d, page *p);
void words_exactness(const sepax_design *d, page *p);
void words_verdict(const sepax_design *d, page *p);
void words_handshake(const sepax_design *d, page *p);

/* Is there an engine with registers? */
bool words_has_engine(const sepax_design *d);

/* The clock period for which the design is made, in ns. */
double words_clock(const sepax_design *d);

#endif
