/* SPDX-License-Identifier: MIT */
/* slicer.c - what slicers say of the volumes of a 3MF that are no material.
 *
 * PrusaSlicer divides the triangles of an object into volumes, in Metadata/Slic3r_PE_model.config:
 *   <object id="1"><volume firstid="0" lastid="11"><metadata key="volume_type" value="ModelPart"/>
 * Bambu Studio and OrcaSlicer list the components of an object in Metadata/model_settings.config:
 *   <object id="3"><part id="1" subtype="normal_part">
 * The meshes stand in the model like any others, so they are read as material. The account names
 * those that are something else. */
#include "archive/core.h"
#include "archive/model.h"

#include <string.h>

typedef enum { MATERIAL, MODIFIER, NEGATIVE, BLOCKER, ENFORCER, KINDS } volume_kind;

/* The kinds in the words of each program, and in the account. */
static const struct {
  const char *prusa, *bambu, *told;
} kinds[KINDS] = {
    [MATERIAL] = {"ModelPart", "normal_part", NULL},
    [MODIFIER] = {"ParameterModifier", "modifier_part", "modifiers, which count as material"},
    [NEGATIVE] = {"NegativeVolume", "negative_part", "negative volumes, which count as material"},
    [BLOCKER] = {"SupportBlocker", "support_blocker", "support blockers, which count as material"},
    [ENFORCER] = {"SupportEnforcer", "support_enforcer",
                  "support enforcers, which count as material"},
};

typedef struct {
  char object[24];  /* the number of the object that is open */
  char volume[100]; /* what the account calls the volume that is open; "" if none is */
  size_t depth;     /* of its element */
  volume_kind kind;
} volumes;

/* An attribute as text, cut at the end of the space. */
static bool find(const part_element *e, const char *name, char *text, size_t size) {
  part_attribute a;
  text[0] = '\0';
  if (!sepax__core_attribute(e, name, &a)) {
    return false;
  }
  snprintf(text, size, "%.*s", (int)(a.length < size ? a.length : size - 1), a.value);
  return true;
}

static volume_kind kind_of(const char *text) {
  volume_kind kind = MATERIAL;
  for (int n = 0; n < KINDS; n++) {
    if (strcmp(text, kinds[n].prusa) == 0 || strcmp(text, kinds[n].bambu) == 0) {
      kind = (volume_kind)n;
    }
  }
  return kind;
}

static void start_volume(part_xml *x, volumes *v, const part_element *e) {
  char first[24];
  char last[24];
  char text[40];
  v->depth = x->depth;
  find(e, "subtype", text, sizeof text);
  v->kind = kind_of(text);
  if (find(e, "firstid", first, sizeof first) && find(e, "lastid", last, sizeof last)) {
    snprintf(v->volume, sizeof v->volume, "triangles %s ... %s of object %s", first, last,
             v->object);
  } else {
    find(e, "id", first, sizeof first);
    snprintf(v->volume, sizeof v->volume, "part %s of object %s", first, v->object);
  }
}

static void read_metadata(volumes *v, const part_element *e) {
  char key[40];
  char value[40];
  find(e, "key", key, sizeof key);
  find(e, "value", value, sizeof value);
  if (strcmp(key, "volume_type") == 0) {
    v->kind = kind_of(value);
  } else if (strcmp(key, "modifier") == 0 && strcmp(value, "1") == 0 && v->kind == MATERIAL) {
    v->kind = MODIFIER; /* all that programs before volume_type had */
  }
}

static bool start(part_xml *x, const part_element *e) {
  volumes *v = x->context;
  if (strcmp(e->name, "object") == 0) {
    find(e, "id", v->object, sizeof v->object);
  } else if (strcmp(e->name, "volume") == 0 || strcmp(e->name, "part") == 0) {
    start_volume(x, v, e);
  } else if (strcmp(e->name, "metadata") == 0 && v->volume[0] != '\0') {
    read_metadata(v, e);
  }
  return true;
}

static void end(part_xml *x) {
  volumes *v = x->context;
  if (v->volume[0] != '\0' && x->depth < v->depth) {
    if (v->kind != MATERIAL) {
      sepax__builder_remark(x->p->b, kinds[v->kind].told, "%s", v->volume);
    }
    v->volume[0] = '\0';
  }
}

bool sepax__slicer_volumes(package *p) {
  static const char *const names[] = {"/Metadata/Slic3r_PE_model.config",
                                      "/Metadata/model_settings.config"};
  bool ok = true;
  for (int n = 0; n < 2 && ok; n++) {
    long part = sepax__package_find(p, names[n]);
    volumes v = {.kind = MATERIAL};
    part_xml x = {.p = p, .part = (size_t)part, .start = start, .end = end, .context = &v};
    ok = part == NO_PART || sepax__part_xml_read(&x);
  }
  return ok;
}
