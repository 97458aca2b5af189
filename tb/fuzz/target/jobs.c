/* SPDX-License-Identifier: MIT */
/* jobs.c - lists of jobs, .sxj files: one that is made here, with bytes that the input changes, and
 * with CRCs made right so that the checks behind them are reached; what is read can be answered. */
#include "fuzz/fuzz.h"
#include "sepax_tree.h"
#include "tree_engine/format.h"

#include <string.h>

enum { POSES = 3, CHANGE = 4, CRC = 72, HEADER_CRC = 76 };

static sepax_tree *new_tree(int size) {
  const sepax_grid grid = {.resolution = 1, .word = 8};
  const sepax_tri tri[2] = {{{{0, 0, 0}, {size, 0, 0}, {0, size, 1}}},
                            {{{size, size, 0}, {size, 0, 0}, {0, size, 1}}}};
  sepax_tree *tree = NULL;
  sepax_error error = {0};
  REQUIRE(sepax_tree_new(&tree, tri, 2, &grid, &error));
  return tree;
}

/* Two bodies, a pair, some poses in which they meet and some in which they do not. */
static void make_list(sepax_job_list *list) {
  static const char *const name[2] = {"a", "b"};
  static const uint32_t line[POSES] = {2, 3, 4};
  sepax_tree *tree[2] = {new_tree(20), new_tree(30)};
  sepax_tree_pose pose[POSES];
  sepax_error error = {0};
  for (int n = 0; n < POSES; n++) {
    const sepax_pose p = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {20 * n, 0, 0}};
    REQUIRE(sepax_tree_pose_make(&pose[n], tree[0], NULL, tree[1], &p, 3, &error));
  }
  const sepax_job_pair pair = {{0, 1}, pose};
  const sepax_job_scene scene = {.tree = (const sepax_tree *const *)tree,
                                 .name = name,
                                 .bodies = 2,
                                 .pair = &pair,
                                 .pairs = 1,
                                 .line = line,
                                 .poses = POSES,
                                 .modes = SEPAX_TREE_FIRST,
                                 .word = 8};
  REQUIRE(sepax_job_list_make(list, &scene, &error));
  sepax_tree_free(tree[0]);
  sepax_tree_free(tree[1]);
}

/* Each pose has an answer; a batch ends early only behind one without a verdict. */
static void require_answers(const sepax_job_list *list) {
  sepax_config config = sepax_config_default();
  sepax_design design;
  sepax_error error = {0};
  sepax_job_list_config(list, &config);
  if (!sepax_design_init(&design, &config, &error)) {
    return;
  }
  const sepax_tree_memory memory = {list->byte, 0, list->bytes};
  sepax_tree_batch batch = {
      .design = &design, .memory = &memory, .list = list->list, .jobs = list->jobs};
  sepax_tree_result r = {.status = 0};
  bool more = true;
  while (more) {
    REQUIRE(sepax_tree_next(&batch, &r, &more, &error));
    REQUIRE(!more || (r.status & SEPAX_TREE_NO_VERDICT) == 0);
    REQUIRE(!more || (r.job < list->jobs && r.pose < list->poses));
  }
  for (uint32_t n = 0; n < list->bodies; n++) {
    REQUIRE(strlen(sepax_job_list_name(list, n)) < 256);
    REQUIRE(sepax_job_list_triangles(list, n) > 0);
  }
}

/* The first byte says which CRCs stay as they are, and whether the file is cut; then come changes:
 * three bytes where, one what is added. */
int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
  if (size == 0) {
    return 0;
  }
  sepax_job_list list;
  make_list(&list);
  for (size_t n = 1; n + CHANGE <= size; n += CHANGE) {
    size_t at = (size_t)(bytes_get32(data + n) & 0xffffff) % list.bytes;
    list.byte[at] = (uint8_t)(list.byte[at] + data[n + 3]);
  }
  size_t bytes = (data[0] & 4) != 0 ? list.bytes * data[0] / 256 : list.bytes;
  if ((data[0] & 1) == 0 && bytes > TREE_PAGE) {
    bytes_put32(list.byte + CRC, sepax__tree_crc(0, list.byte + TREE_PAGE, bytes - TREE_PAGE));
  }
  if ((data[0] & 2) == 0) {
    bytes_put32(list.byte + HEADER_CRC, sepax__tree_crc(0, list.byte, HEADER_CRC));
  }
  fuzz_file("input.sxj", list.byte, bytes);
  sepax_job_list_free(&list);
  sepax_error error = {0};
  if (fuzz_answer(sepax_job_list_read(&list, "input.sxj", &error), &error)) {
    require_answers(&list);
    sepax_job_list_free(&list);
  }
  return 0;
}
