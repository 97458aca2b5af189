/* SPDX-License-Identifier: MIT */
/* stl.c - STL, binary or ASCII. */
#include "mesh.h"

#include "report.h"

#include <ctype.h>
#include <stdint.h>
#include <string.h>
#include <strings.h>

static uint32_t little(const char *bytes) {
  uint32_t value = 0;
  for (int n = 3; n >= 0; n--)
    value = value << 8 | (unsigned char)bytes[n];
  return value;
}

/* Of each record of 50 bytes the normal is not read, and may be NaN. */
static void read_binary(mesh *m, const char *bytes) {
  const uint32_t count = little(bytes + 80);
  for (uint32_t n = 0; n < count; n++) {
    long double v[9];
    for (size_t k = 0; k < 9; k++) {
      const uint32_t bits = little(bytes + 84 + 50 * (size_t)n + 12 + 4 * k);
      float value = 0;
      memcpy(&value, &bits, sizeof value);
      v[k] = value;
    }
    const point corner[3] = {{v[0], v[1], v[2]}, {v[3], v[4], v[5]}, {v[6], v[7], v[8]}};
    mesh_polygon(m, corner, 3);
    m->faces++;
  }
}

typedef struct {
  const mesh *m;
  const char *next;
  const char *word;
  size_t length;
  long line;
} words;

/* false: none is left. */
static bool next_word(words *w) {
  for (; isspace((unsigned char)*w->next); w->next++)
    w->line += *w->next == '\n';
  w->word = w->next;
  while (*w->next != 0 && !isspace((unsigned char)*w->next))
    w->next++;
  w->length = (size_t)(w->next - w->word);
  return w->length > 0;
}

static bool word_is(const words *w, const char *word) {
  return w->length == strlen(word) && strncasecmp(w->word, word, w->length) == 0;
}

static void expect_word(words *w, const char *word) {
  if (!next_word(w) || !word_is(w, word))
    cannot("%s:%ld: %s expected", w->m->file, w->line, word);
}

/* The normal of a facet is not read: it may be NaN. */
static void read_facet(mesh *m, words *w) {
  expect_word(w, "normal");
  for (int n = 0; n < 3; n++)
    next_word(w);
  expect_word(w, "outer");
  expect_word(w, "loop");
  point corner[3];
  for (int n = 0; n < 3; n++) {
    expect_word(w, "vertex");
    corner[n].x = mesh_number(m, &w->next, 0, w->line);
    corner[n].y = mesh_number(m, &w->next, 0, w->line);
    corner[n].z = mesh_number(m, &w->next, 0, w->line);
  }
  expect_word(w, "endloop");
  expect_word(w, "endfacet");
  mesh_polygon(m, corner, 3);
  m->faces++;
}

/* Solids one behind the other, each with its end. */
static void read_ascii(mesh *m, const char *text) {
  words w = {m, text, text, 0, 1};
  bool within = false;
  while (next_word(&w)) {
    if (within && word_is(&w, "facet")) {
      read_facet(m, &w);
    } else if (word_is(&w, within ? "endsolid" : "solid")) {
      within = !within;
      w.next += strcspn(w.next, "\r\n");                    /* its name */
    } else if (within || w.length > 1 || *w.word != 0x1A) { /* the end of a file of DOS */
      cannot("%s:%ld: %s expected", m->file, w.line, within ? "facet" : "solid");
    }
  }
  if (within)
    cannot("%s: ends within a solid", m->file);
}

void mesh_stl(mesh *m, const char *bytes, size_t length) {
  if (length >= 84 && length == 84 + 50 * (size_t)little(bytes + 80)) {
    read_binary(m, bytes);
    return;
  }
  const size_t text = strlen(bytes);
  for (size_t n = text; n < length; n++) {
    if (bytes[n] != 0)
      cannot("%s: a byte 0 in a text, or not as long as a binary STL says", m->file);
  }
  read_ascii(m, bytes);
}
