/* certificate.c - what was certified, for programs that check it: docs/certificate.md. */
#include "path/parts.h"
#include "util/write_file.h"

#include <jansson.h>

typedef struct {
  const path_scene *scene;
  const path_question *q;
} certificate;

/* A value on a line of its own. */
static bool write_line(FILE *out, json_t *json) {
  bool ok = json != NULL && json_dumpf(json, out, JSON_COMPACT) == 0 && putc('\n', out) != EOF;
  json_decref(json);
  return ok;
}

static json_t *head_of(const certificate *c) {
  const path_question *q = c->q;
  json_t *packages = json_object();
  json_t *pairs = json_array();
  for (size_t n = 0; n < q->packages; n++) {
    json_object_set_new(packages, q->package[n].name, json_string(q->package[n].folder));
  }
  for (size_t n = 0; n < c->scene->pairs; n++) {
    const path_pair *pair = &c->scene->pair[n];
    json_array_append_new(pairs, json_pack("[s, s]", path_body_name(c->scene, pair->body[0]),
                                           path_body_name(c->scene, pair->body[1])));
  }
  return json_pack("{s:s, s:i, s:s, s:s?, s:s, s:o, s:f, s:o}", "certificate", "sepax", "version",
                   1, "urdf", q->urdf, "srdf", q->srdf, "path", q->motion, "packages", packages,
                   "clearance", q->clearance.length, "pairs", pairs);
}

static json_t *interval_of(size_t pair, const path_interval *at) {
  json_t *json = json_pack("[I, I, I, I, f]", (json_int_t)pair, (json_int_t)at->segment,
                           (json_int_t)at->level, (json_int_t)at->index, at->bound);
  for (int i = 0; i < 3 && at->by_axis; i++) {
    json_array_append_new(json, json_real(at->axis[i]));
  }
  return json;
}

static bool write_all(FILE *out, const void *context) {
  const certificate *c = context;
  size_t count = 0;
  bool ok = write_line(out, head_of(c));
  for (size_t n = 0; n < c->scene->pairs; n++) {
    const path_proof *proof = &c->scene->pair[n].proof;
    for (size_t k = 0; k < proof->count && ok; k++, count++) {
      ok = write_line(out, interval_of(n, &proof->interval[k]));
    }
  }
  return ok && write_line(out, json_pack("{s:I}", "intervals", (json_int_t)count));
}

bool path_write_certificate(const path_scene *scene, const path_question *q, sepax_error *error) {
  const certificate c = {scene, q};
  return sepax_write_file(q->certificate, write_all, &c, error);
}
