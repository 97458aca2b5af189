/* SPDX-License-Identifier: MIT */
/* images.c - two images, their body records and a pose that are any bytes: a walk ends. */
#include "fuzz/fuzz.h"
#include "sepax_design.h"
#include "sepax_tree.h"
#include "tree_engine/format.h"

#include <string.h>

/* Children that nodes have in common make a walk long: 2^(2 NODES_MOST). */
enum { HEAD = 2 * SEPAX_TREE_BODY_BYTES + SEPAX_TREE_POSE_BYTES, NODES_MOST = 7 };

static bool few(void *context, const sepax_tree_pair *pair) {
  int *left = context;
  (void)pair;
  return --*left > 0;
}

/* An image has all the bytes that its record tells. */
static bool fits(const uint8_t *record, size_t bytes) {
  return bytes_get32(record + 8) <= NODES_MOST && bytes_get32(record + 16) <= bytes / TREE_BEAT;
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
  static sepax_design design;
  sepax_error error = {0};
  if (design.config.word != 12) {
    sepax_config config = sepax_config_default();
    REQUIRE(sepax_config_set(&config, "word", "12", &error));
    REQUIRE(sepax_config_set(&config, "tree", "on", &error));
    REQUIRE(sepax_design_init(&design, &config, &error));
  }
  if (size < HEAD) {
    return 0;
  }
  uint8_t record[2][SEPAX_TREE_BODY_BYTES];
  sepax_tree_pose pose;
  memcpy(record, data, sizeof record);
  size_t half = (size - HEAD) / 2;
  const uint8_t *const image[2] = {data + HEAD, data + HEAD + half};
  if (!fits(record[0], half) || !fits(record[1], half) ||
      !sepax_tree_pose_unpack(&pose, data + sizeof record, &error)) {
    return 0;
  }
  int left = 1000;
  const sepax_tree_walk_options how = {.design = &design, .each = few, .context = &left};
  sepax_tree_run run;
  error = (sepax_error){0};
  fuzz_answer(sepax_tree_walk_images(image, record, &pose, &how, &run, &error), &error);
  return 0;
}
