/* SPDX-License-Identifier: MIT */
/* faults.h - what files do to a soup: turned triangles, copies, T-junctions, triangles without
 * area, holes. */
#ifndef MATERIAL_FAULTS_H
#define MATERIAL_FAULTS_H

#include "soup.h"

/* Some triangles are turned: a few, or each with some chance. */
void turn_some(soup *s, generator *g);

/* Some triangles are there twice or three times, in any direction. */
void copy_some(soup *s, generator *g);

/* Some edges are divided on one side only; at most `most`. */
void divide_some(soup *s, int64_t most, generator *g);

/* Triangles without area are added: with equal corners, or with corners on one line. */
void fill_in(soup *s, generator *g);

/* Any of these faults, or none; seldom a hole. */
void spoil(soup *s, generator *g);

#endif
