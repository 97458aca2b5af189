/* SPDX-License-Identifier: MIT */
/* reads.c - which blocks of its memory a batch of the tree engine has read, and how often. */
#include "bench.h"
#include "tree_engine/format.h"

#include <string.h>

/* So many are never given up: a set of its own for each node; each record in another way, for they
 * are taken by turns. */
enum { NODES_KEPT = 16, RECORDS_KEPT = 4 };

/* What is read of one job's bodies and poses. */
typedef struct {
  const bench_reads *of;
  uint64_t colds;
  uint64_t seen; /* bursts at places that were looked at */
} sum;

static uint32_t at(const sum *s, uint64_t address) {
  return s->of->bursts[(address - bench_base) / MEMORY_BEAT];
}

static void no_more(sum *s, const char *what, uint64_t address, uint64_t most) {
  uint32_t reads = at(s, address);
  s->seen += reads;
  if (reads > most) {
    expect(what, reads, most);
  }
}

/* Each node and each record once after each cold start, where there are that few. */
static void of_body(sum *s, const uint8_t record[SEPAX_TREE_BODY_BYTES]) {
  uint64_t base = bytes_get64(record);
  uint32_t nodes = bytes_get32(record + 8);
  uint32_t leaves = 0;
  const uint8_t *image = bench_at((size_t)(base - bench_base));
  for (uint32_t n = 0; n < nodes; n++) {
    tree_node node = sepax__tree_unpack(image + (size_t)TREE_NODE_BYTES * n, SEPAX_WORD);
    leaves += node.level == 0;
    no_more(s, "reads of a node", base + (uint64_t)TREE_NODE_BYTES * n,
            nodes <= NODES_KEPT ? s->colds : UINT64_MAX);
  }
  if (s->of->whole) {
    expect("a root is read after each cold start", at(s, base) >= s->colds, 1);
  }
  for (uint32_t n = 0; n < nodes; n++) {
    tree_node node = sepax__tree_unpack(image + (size_t)TREE_NODE_BYTES * n, SEPAX_WORD);
    if (node.level == 0) {
      no_more(s, "reads of a record", base + (uint64_t)TREE_BEAT * node.record,
              leaves <= RECORDS_KEPT ? s->colds : UINT64_MAX);
    }
  }
}

void reads_check(const bench_reads *of, uint64_t list, uint32_t jobs, uint64_t bursts) {
  sum s = {of, of->colds, 0};
  const uint8_t *bytes = bench_at((size_t)(list - bench_base));
  for (uint32_t n = 0; n < jobs; n++) {
    const uint8_t *job = bytes + (size_t)SEPAX_TREE_JOB_BYTES * n;
    if (memcmp(job, bytes, 2 * SEPAX_TREE_BODY_BYTES) != 0) {
      return; /* cold starts of other bodies */
    }
  }
  of_body(&s, bytes);
  of_body(&s, bytes + SEPAX_TREE_BODY_BYTES);
  for (uint32_t n = 0; n < jobs; n++) {
    sepax_tree_job job;
    stop_on(!sepax_tree_job_unpack(&job, bytes + (size_t)SEPAX_TREE_JOB_BYTES * n), "a bad job");
    no_more(&s, "reads of a job", list + (uint64_t)SEPAX_TREE_JOB_BYTES * n, 1);
    for (uint32_t k = 0; k < job.count; k++) {
      no_more(&s, "reads of a pose", job.poses + (uint64_t)SEPAX_TREE_POSE_STRIDE * k, 1);
    }
  }
  expect("bursts, of which there are none elsewhere", bursts, s.seen);
}
