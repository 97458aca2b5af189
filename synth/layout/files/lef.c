/* SPDX-License-Identifier: MIT */
/* lef.c - see lef.h. */
#include "layout/files/lef.h"
#include "liberty/text.h"
#include "layout/files/words.h"

#include <string.h>
#include <strings.h>

int lef_layer_index(const lef *l, const char *name) {
  for (int k = 0; k < l->layers; k++) {
    if (strcmp(l->layer[k].name, name) == 0) {
      return k;
    }
  }
  return -1;
}

const lef_macro *lef_find(const lef *l, const char *name) {
  for (int k = 0; k < l->macros; k++) {
    if (strcmp(l->macro[k].name, name) == 0) {
      return &l->macro[k];
    }
  }
  return NULL;
}

int lef_pin_index(const lef_macro *macro, const char *name) {
  for (int k = 0; k < macro->pins; k++) {
    if (strcmp(macro->pin[k].name, name) == 0) {
      return k;
    }
  }
  return -1;
}

/* LAYER NAME ; RECT x0 y0 x1 y1 ; ... END, of layers that are routed or cut. */
static void read_shapes(lef *l, words *w, lef_shapes *s, const char *end) {
  int layer = -1;
  while (!word_is(w, end)) {
    if (word_is(w, "LAYER")) {
      layer = lef_layer_index(l, word(w));
      words_skip(w);
    } else if (word_is(w, "RECT")) {
      lef_rect r = {.layer = layer};
      r.x0 = word_length(w), r.y0 = word_length(w);
      r.x1 = word_length(w), r.y1 = word_length(w);
      words_skip(w);
      if (layer >= 0) {
        s->rect = text_more(s->rect, (size_t)s->rects, sizeof *s->rect);
        s->rect[s->rects++] = r;
      }
    } else if (word_is(w, "POLYGON")) {
      words_fail(w, "only rectangles are understood, not a", "POLYGON");
    } else {
      words_skip(w);
    }
  }
}

static void read_table(words *w, lef_layer *layer) {
  while (!word_is(w, "WIDTH")) {
    (void)word(w);
  }
  (void)word_number(w);
  layer->spacing = word_length(w);
  while (!word_is(w, ";")) { /* the next row is of wires that are wider */
    if (word_is(w, "WIDTH") && layer->wide == 0) {
      layer->wide = word_length(w);
    } else {
      (void)word(w);
    }
  }
}

/* OFFSET of both directions, or of x and y: that of the tracks. */
static void read_offset(words *w, lef_layer *layer) {
  int x = word_length(w);
  int y = word_is(w, ";") ? x : word_length(w);
  layer->offset = layer->vertical ? x : y;
}

static void read_layer(lef *l, words *w) {
  lef_layer it = {.name = word(w)};
  double square = 0, edge = 0;
  bool kept = false;
  while (!word_is(w, "END")) {
    if (word_is(w, "TYPE")) {
      const char *type = word(w);
      it.metal = strcmp(type, "ROUTING") == 0;
      kept = it.metal || strcmp(type, "CUT") == 0;
      words_skip(w);
    } else if (word_is(w, "DIRECTION")) {
      it.vertical = strcmp(word(w), "VERTICAL") == 0;
    } else if (word_is(w, "PITCH")) {
      it.pitch = word_length(w);
    } else if (word_is(w, "OFFSET")) {
      read_offset(w, &it);
    } else if (word_is(w, "WIDTH")) {
      it.width = word_length(w);
    } else if (word_is(w, "SPACING")) {
      it.spacing = word_length(w);
    } else if (word_is(w, "SPACINGTABLE")) {
      read_table(w, &it);
    } else if (word_is(w, "RESISTANCE")) {
      if (word_is(w, "RPERSQ")) {
        it.ohm_per_square = word_number(w);
      } else {
        it.ohm_per_cut = word_number(w);
      }
    } else if (word_is(w, "CAPACITANCE")) {
      word_want(w, "CPERSQDIST");
      square = word_number(w) * 1e-12;
    } else if (word_is(w, "EDGECAPACITANCE")) {
      edge = word_number(w) * 1e-12;
    } else {
      (void)word(w);
    }
  }
  word_want(w, it.name);
  it.farad = square * it.width / UNITS + 2 * edge;
  if (kept && lef_layer_index(l, it.name) < 0) {
    l->layer = text_more(l->layer, (size_t)l->layers, sizeof *l->layer);
    l->layer[l->layers++] = it;
  }
}

static void read_via(lef *l, words *w) {
  lef_via it = {.name = word(w)};
  (void)word_is(w, "DEFAULT");
  (void)word_is(w, "TOPOFSTACKONLY");
  read_shapes(l, w, &it.shape, "END");
  word_want(w, it.name);
  l->via = text_more(l->via, (size_t)l->vias, sizeof *l->via);
  l->via[l->vias++] = it;
}

static void read_pin(lef *l, words *w, lef_macro *macro) {
  lef_pin it = {.name = word(w)};
  while (!word_is(w, "END")) {
    if (word_is(w, "DIRECTION")) {
      it.output = strcmp(word(w), "OUTPUT") == 0;
      words_skip(w);
    } else if (word_is(w, "USE")) {
      const char *use = word(w);
      it.use = strcasecmp(use, "POWER") == 0    ? LEF_POWER
               : strcasecmp(use, "GROUND") == 0 ? LEF_GROUND
               : strcasecmp(use, "CLOCK") == 0  ? LEF_CLOCK
                                                : LEF_SIGNAL;
      words_skip(w);
    } else if (word_is(w, "PORT")) {
      read_shapes(l, w, &it.shape, "END");
    } else {
      words_skip(w);
    }
  }
  word_want(w, it.name);
  if (macro->pins == LEF_PINS) {
    words_fail(w, "too many pins of", macro->name);
  }
  macro->pin = text_more(macro->pin, (size_t)macro->pins, sizeof *macro->pin);
  macro->pin[macro->pins++] = it;
}

/* SIZE width BY height */
static void read_size(words *w, int *width, int *height) {
  *width = word_length(w);
  word_want(w, "BY");
  *height = word_length(w);
  words_skip(w);
}

static void read_macro(lef *l, words *w) {
  lef_macro it = {.name = word(w)};
  while (!word_is(w, "END")) {
    if (word_is(w, "CLASS")) {
      it.core = strcasecmp(word(w), "CORE") == 0;
      words_skip(w);
    } else if (word_is(w, "SIZE")) {
      read_size(w, &it.width, &it.height);
    } else if (word_is(w, "PIN")) {
      read_pin(l, w, &it);
    } else if (word_is(w, "OBS")) {
      read_shapes(l, w, &it.obstruction, "END");
    } else {
      words_skip(w);
    }
  }
  word_want(w, it.name);
  if (lef_find(l, it.name) == NULL) {
    l->macro = text_more(l->macro, (size_t)l->macros, sizeof *l->macro);
    l->macro[l->macros++] = it;
  }
}

/* The first site of cells in rows. */
static void read_site(lef *l, words *w) {
  const char *name = word(w);
  int width = 0, height = 0;
  bool core = false;
  while (!word_is(w, "END")) {
    if (word_is(w, "CLASS")) {
      core = strcasecmp(word(w), "CORE") == 0;
      words_skip(w);
    } else if (word_is(w, "SIZE")) {
      read_size(w, &width, &height);
    } else {
      words_skip(w);
    }
  }
  word_want(w, name);
  if (core && l->site == NULL) {
    l->site = name, l->site_width = width, l->site_height = height;
  }
}

/* All up to END and the name. */
static void skip_block(words *w, const char *name) {
  for (;;) {
    if (strcmp(word(w), "END") == 0 && word_is(w, name)) {
      return;
    }
  }
}

void lef_read(lef *l, const char *path) {
  words file = words_open(path), *w = &file;
  while (words_left(w)) {
    const char *what = word(w);
    if (strcmp(what, "LAYER") == 0) {
      read_layer(l, w);
    } else if (strcmp(what, "VIA") == 0) {
      read_via(l, w);
    } else if (strcmp(what, "MACRO") == 0) {
      read_macro(l, w);
    } else if (strcmp(what, "SITE") == 0) {
      read_site(l, w);
    } else if (strcmp(what, "VIARULE") == 0 || strcmp(what, "NONDEFAULTRULE") == 0) {
      skip_block(w, word(w));
    } else if (strcmp(what, "UNITS") == 0 || strcmp(what, "PROPERTYDEFINITIONS") == 0 ||
               strcmp(what, "SPACING") == 0) {
      skip_block(w, what);
    } else if (strcmp(what, "END") == 0) {
      return;
    } else {
      words_skip(w);
    }
  }
}
