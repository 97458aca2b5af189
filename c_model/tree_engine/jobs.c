/* SPDX-License-Identifier: MIT */
/* jobs.c - works through a list of jobs pose by pose (docs/reference/tree-engine.md, Jobs). */
#include "tree_engine/walk.h"

#include <string.h>

#define ADDRESS_MAX ((UINT64_C(1) << 40) - 1)
#define MODES_ALL 127U

enum { POSES = 64, COUNT = 72, MODES = 76, BUDGET = 80, LEAF = 88, CHILD_SHIFT = 23 };

void sepax_tree_job_pack(const sepax_tree_job *job, uint8_t bytes[SEPAX_TREE_JOB_BYTES]) {
  memset(bytes, 0, SEPAX_TREE_JOB_BYTES);
  memcpy(bytes, job->body, sizeof job->body);
  bytes_put64(bytes + POSES, job->poses);
  bytes_put32(bytes + COUNT, job->count);
  bytes_put32(bytes + MODES, job->modes);
  bytes_put32(bytes + BUDGET, job->budget);
  for (int i = 0; i < 2; i++) {
    bytes_put32(bytes + LEAF + 4 * i, job->leaf[i] | (uint32_t)job->child[i] << CHILD_SHIFT);
  }
}

static bool body_in_range(const uint8_t *record, uint32_t triangles_most) {
  uint64_t address = bytes_get64(record);
  uint32_t nodes = bytes_get32(record + 8);
  uint32_t triangles = bytes_get32(record + 12);
  return address % TREE_PAGE == 0 && address <= ADDRESS_MAX && nodes >= 1 &&
         nodes <= TREE_NODES_MAX && triangles >= 1 && triangles <= triangles_most &&
         nodes * (TREE_NODE_BYTES / TREE_BEAT) <= bytes_get32(record + 16);
}

bool sepax_tree_job_unpack(sepax_tree_job *job, const uint8_t bytes[SEPAX_TREE_JOB_BYTES]) {
  *job = (sepax_tree_job){.poses = bytes_get64(bytes + POSES),
                          .count = bytes_get32(bytes + COUNT),
                          .modes = bytes_get32(bytes + MODES),
                          .budget = bytes_get32(bytes + BUDGET)};
  memcpy(job->body, bytes, sizeof job->body);
  for (int i = 0; i < 2; i++) {
    uint32_t row = bytes_get32(bytes + LEAF + 4 * i);
    job->leaf[i] = row & (TREE_NODES_MAX - 1);
    job->child[i] = (int)(row >> CHILD_SHIFT & 15);
  }
  return body_in_range(job->body[0], UINT32_MAX) &&
         body_in_range(job->body[1], UINT32_C(1) << 24) &&
         job->poses % SEPAX_TREE_POSE_STRIDE == 0 && job->poses <= ADDRESS_MAX && job->count >= 1 &&
         job->modes <= MODES_ALL;
}

/* The bytes at an address; NULL if not all of them are in the memory. */
static const uint8_t *read(const sepax_tree_memory *m, uint64_t address, uint64_t bytes) {
  bool there = address >= m->address && address - m->address <= m->size &&
               bytes <= m->size - (address - m->address);
  return there ? m->byte + (address - m->address) : NULL;
}

static bool see(void *context, const sepax_tree_pair *pair) {
  const sepax_tree_batch *b = context;
  if (b->each != NULL &&
      (pair->collision || (b->design->limits > 0 && pair->band == SEPAX_BAND_WARNING))) {
    b->each(b->context, pair);
  }
  return true;
}

/* Read the next job. Returns 0, or SEPAX_TREE_BUS or SEPAX_TREE_REFUSED. */
static unsigned take_job(sepax_tree_batch *b) {
  const uint8_t *bytes =
      read(b->memory, b->list + (uint64_t)SEPAX_TREE_JOB_BYTES * b->job, SEPAX_TREE_JOB_BYTES);
  if (bytes == NULL) {
    return SEPAX_TREE_BUS;
  }
  if (!sepax_tree_job_unpack(&b->current, bytes)) {
    return SEPAX_TREE_REFUSED;
  }
  b->has_row = (b->current.modes & SEPAX_TREE_ROW) != 0;
  b->row = (sepax_tree_pair){.leaf = {b->current.leaf[0], b->current.leaf[1]},
                             .child = {b->current.child[0], b->current.child[1]}};
  return 0;
}

static bool walk_pose(sepax_tree_batch *b, sepax_tree_result *result, sepax_error *error) {
  const sepax_tree_job *job = &b->current;
  const uint8_t *bytes = read(b->memory, job->poses + (uint64_t)SEPAX_TREE_POSE_STRIDE * b->pose,
                              SEPAX_TREE_POSE_BYTES);
  const uint8_t *image[2];
  for (int i = 0; i < 2; i++) {
    image[i] = read(b->memory, bytes_get64(job->body[i]),
                    (uint64_t)TREE_BEAT * bytes_get32(job->body[i] + 16));
  }
  sepax_tree_pose pose;
  sepax_error unread;
  bool refused = bytes != NULL && !sepax_tree_pose_unpack(&pose, bytes, &unread);
  if (refused) {
    result->status = SEPAX_TREE_REFUSED;
  } else if (bytes == NULL || image[0] == NULL || image[1] == NULL) {
    result->status = SEPAX_TREE_BUS;
  }
  if (result->status != 0) {
    return true;
  }
  const sepax_tree_walk_options how = {.design = b->design,
                                       .first = (job->modes & SEPAX_TREE_FIRST) != 0,
                                       .row = b->has_row ? &b->row : NULL,
                                       .each = see,
                                       .context = b};
  if (!sepax_tree_walk_images(image, job->body, &pose, &how, &result->run, error)) {
    return false;
  }
  result->status = result->run.damaged
                       ? SEPAX_TREE_DAMAGED
                       : (result->run.collisions > 0 ? SEPAX_TREE_HIT : 0) |
                             (result->run.out_of_range > 0 ? SEPAX_TREE_OUT_OF_RANGE : 0);
  return true;
}

/* Go on to the next pose or the next job. */
static void go_on(sepax_tree_batch *b, const sepax_tree_result *result) {
  bool hit = (result->status & SEPAX_TREE_HIT) != 0;
  if (hit && (b->current.modes & SEPAX_TREE_AGAIN) != 0) {
    b->has_row = true;
    b->row = result->run.found;
  }
  b->pose++;
  if (b->pose == b->current.count || (hit && (b->current.modes & SEPAX_TREE_LEAVE) != 0)) {
    b->pose = 0;
    b->job++;
  }
}

bool sepax_tree_next(sepax_tree_batch *b, sepax_tree_result *result, bool *more,
                     sepax_error *error) {
  *more = b->job < b->jobs;
  if (!*more) {
    return true;
  }
  *result = (sepax_tree_result){.job = b->job, .pose = b->pose};
  if (b->pose == 0) {
    result->status = take_job(b);
  }
  result->modes = b->current.modes;
  if (result->status == 0 && !walk_pose(b, result, error)) {
    return false;
  }
  if ((result->status & SEPAX_TREE_NO_VERDICT) != 0) {
    b->job = b->jobs;
  } else {
    go_on(b, result);
  }
  return true;
}
