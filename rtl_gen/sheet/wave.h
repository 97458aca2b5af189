/* SPDX-License-Identifier: MIT */
/* wave.h - waveforms: a picture, and the same as WaveDrom's JSON.
 *
 * A lane is a string with a character a cycle, as WaveDrom has it: p a clock, 0 and 1 a level, = a
 * value (the next label), x anything, . the same as before, | the same behind a gap of time. */
#ifndef SEPAX_SHEET_WAVE_H
#define SEPAX_SHEET_WAVE_H

#include "emit/text.h"

enum { WAVE_LANES = 12, WAVE_CYCLES = 32, WAVE_LABELS = 8 };

typedef struct {
  const char *name; /* "": a space between lanes */
  char wave[WAVE_CYCLES + 1];
  const char *label[WAVE_LABELS];
  int labels;
} wave_lane;

typedef struct {
  const char *title;
  wave_lane lane[WAVE_LANES];
  int lanes;
  char text[16]; /* of a label that is made for this wave */
} wave;

/* A further lane, at first without cycles. At most WAVE_LANES. */
wave_lane *wave_add(wave *w, const char *name);

/* Append cycles to a lane, and a label for the next =, which lives as long as the wave. What does
 * not fit is left out. */
void wave_put(wave_lane *lane, const char *cycles);
void wave_label(wave_lane *lane, const char *label);

/* WaveDrom's JSON, with a line that names the generator. */
void wave_json(const wave *w, emit_text *out);

/* An SVG picture: a white ground, black lines; its comment names the generator. */
void wave_svg(const wave *w, emit_text *out);

#endif
