/* SPDX-License-Identifier: MIT */
/* list_files.c - lists of jobs in files: what was put in is what the golden model answers from the
 * file's bytes, and files that are damaged or are no list are refused. */
#include "unit/tree/scenes.h"

#include <stdio.h>
#include <string.h>

enum { BODIES = 3, PAIRS = 2, POSES = 6, WORD = 12 };

typedef struct {
  triangles t[BODIES];
  sepax_tree *tree[BODIES];
  sepax_tree_pose pose[PAIRS][POSES];
  sepax_design design;
  sepax_job_list list;
} scene;

static const uint32_t lines[POSES] = {2, 3, 5, 6, 7, 100000};
static const size_t pairs[PAIRS][2] = {{2, 0}, {1, 2}};

static sepax_job_scene described(scene *s, sepax_job_pair pair[PAIRS]) {
  static const char *const names[BODIES] = {"a table", "b", "the third"};
  for (int n = 0; n < PAIRS; n++) {
    pair[n] = (sepax_job_pair){{pairs[n][0], pairs[n][1]}, s->pose[n]};
  }
  return (sepax_job_scene){.tree = (const sepax_tree *const *)s->tree,
                           .name = names,
                           .bodies = BODIES,
                           .pair = pair,
                           .pairs = PAIRS,
                           .line = lines,
                           .poses = POSES,
                           .modes = SEPAX_TREE_FIRST,
                           .word = WORD,
                           .clearance = 1,
                           .warning = 4};
}

static scene *new_scene(void) {
  scene *s = calloc(1, sizeof *s);
  assert_non_null(s);
  s->design = design_of("--word=12 --tree=on --clearance=1 --warning=4");
  for (int i = 0; i < BODIES; i++) {
    s->t[i] = drawn(150 + 100 * (size_t)i, 4, 300, 0, WORD);
    s->tree[i] = tree_of(&s->t[i], WORD);
  }
  for (int n = 0; n < PAIRS; n++) {
    for (int k = 0; k < POSES; k++) {
      sepax_pose p = posed(0, 0);
      p.translation[1] = 450 + 40 * k;
      assert_works(sepax_tree_pose_make(&s->pose[n][k], s->tree[pairs[n][0]], NULL,
                                        s->tree[pairs[n][1]], &p, s->design.margin[1], &fault));
    }
  }
  sepax_job_pair pair[PAIRS];
  const sepax_job_scene of = described(s, pair);
  assert_works(sepax_job_list_make(&s->list, &of, &fault));
  snprintf(path, sizeof path, "%s/path.sxj", folder);
  return s;
}

static void free_scene(scene *s) {
  for (int i = 0; i < BODIES; i++) {
    sepax_tree_free(s->tree[i]);
    free(s->t[i].tri);
  }
  sepax_job_list_free(&s->list);
  free(s);
}

CASE(a_file_has_what_was_put_in) {
  scene *s = new_scene();
  sepax_job_list list;
  assert_works(sepax_job_list_write(&s->list, path, &fault));
  assert_true(sepax_job_list_is(path));
  assert_works(sepax_job_list_read(&list, path, &fault));
  assert_int_equal(list.bytes, s->list.bytes);
  assert_memory_equal(list.byte, s->list.byte, list.bytes);
  assert_int_equal(list.jobs, PAIRS);
  assert_int_equal(list.poses, POSES);
  assert_int_equal(list.bodies, BODIES);
  assert_string_equal(sepax_job_list_name(&list, 2), "the third");
  assert_int_equal(sepax_job_list_triangles(&list, 1), 250);
  assert_true(sepax_job_list_resolution(&list) == 1);
  for (uint32_t n = 0; n < PAIRS; n++) {
    assert_int_equal(sepax_job_list_body(&list, n, 0), pairs[n][0]);
    assert_int_equal(sepax_job_list_body(&list, n, 1), pairs[n][1]);
  }
  for (uint32_t n = 0; n < POSES; n++) {
    assert_int_equal(sepax_job_list_line(&list, n), lines[n]);
  }
  sepax_config config = sepax_config_default();
  sepax_job_list_config(&list, &config);
  assert_true(config.tree && config.word == WORD && config.clearance == 1 && config.warning == 4);
  sepax_job_list_free(&list);
  free_scene(s);
}

/* The bytes, wherever they begin, are the engine's memory. */
CASE(the_golden_model_answers_from_its_bytes) {
  scene *s = new_scene();
  const sepax_tree_memory memory = {s->list.byte, 0, s->list.bytes};
  sepax_tree_batch b = {
      .design = &s->design, .memory = &memory, .list = s->list.list, .jobs = s->list.jobs};
  int hits = 0;
  for (uint32_t n = 0; n < PAIRS * POSES; n++) {
    const size_t *of = pairs[n / POSES];
    const sepax_tree_walk_options how = {.design = &s->design, .first = true};
    sepax_tree_run run;
    sepax_tree_result r;
    bool more = false;
    assert_works(sepax_tree_walk(s->tree[of[0]], s->tree[of[1]], &s->pose[n / POSES][n % POSES],
                                 &how, &run, &fault));
    assert_works(sepax_tree_next(&b, &r, &more, &fault));
    assert_true(more);
    assert_int_equal(r.job, n / POSES);
    assert_int_equal(r.pose, n % POSES);
    assert_int_equal(r.run.steps, run.steps);
    assert_int_equal(r.run.near, run.near);
    assert_int_equal(r.run.collisions, run.collisions);
    assert_int_equal(r.status, run.collisions > 0 ? SEPAX_TREE_HIT : 0);
    hits += run.collisions > 0;
  }
  assert_true(hits > 0 && hits < PAIRS * POSES);
  free_scene(s);
}

CASE(what_makes_no_list) {
  scene *s = new_scene();
  sepax_job_pair pair[PAIRS];
  sepax_job_list list;
  sepax_job_scene of = described(s, pair);
  of.pairs = 0;
  assert_fault(sepax_job_list_make(&list, &of, &fault), "here are 3, 0, 6");
  of = described(s, pair);
  of.poses = 0;
  assert_fault(sepax_job_list_make(&list, &of, &fault), "here are 3, 2, 0");
  of.poses = 5000000;
  assert_fault(sepax_job_list_make(&list, &of, &fault), "more than a list of 2 GiB");
  of.poses = (size_t)1 << 62;
  assert_fault(sepax_job_list_make(&list, &of, &fault), "more than a list of 2 GiB");
  of = described(s, pair);
  of.pairs = (size_t)1 << 57;
  assert_fault(sepax_job_list_make(&list, &of, &fault), "more than a list of 2 GiB");
  free_scene(s);
}

/* ------------------------------------------------------------------- damage */

static void write_bytes(const sepax_job_list *list, size_t count) {
  FILE *out = fopen(path, "wb");
  assert_non_null(out);
  assert_int_equal(fwrite(list->byte, 1, count, out), count);
  assert_int_equal(fclose(out), 0);
}

static void refused(const sepax_job_list *list, const char *words) {
  sepax_job_list read;
  write_bytes(list, list->bytes);
  assert_fault(sepax_job_list_read(&read, path, &fault), words);
  assert_null(read.byte);
}

/* With CRCs that are right. */
static void refused_whole(sepax_job_list *list, const char *words) {
  bytes_put32(list->byte + 72, sepax__tree_crc(0, list->byte + 4096, list->bytes - 4096));
  bytes_put32(list->byte + 76, sepax__tree_crc(0, list->byte, 76));
  refused(list, words);
}

CASE(files_that_are_damaged) {
  scene *s = new_scene();
  sepax_job_list read;
  assert_fault(sepax_job_list_read(&read, "no/such.sxj", &fault), "no/such.sxj: not read");
  for (size_t count = 0; count < s->list.bytes; count += 1 + count / 3) {
    write_bytes(&s->list, count);
    assert_fault(sepax_job_list_read(&read, path, &fault), "path.sxj: ");
  }
  for (size_t at = 0; at < s->list.bytes; at += at < 200 ? 1 : 997) {
    s->list.byte[at] ^= 0x10;
    refused(&s->list, at < 8 ? "no list of jobs" : at < 12 ? "version" : "CRC is wrong");
    s->list.byte[at] ^= 0x10;
  }
  write_bytes(&s->list, s->list.bytes);
  assert_true(sepax_job_list_is(path));
  s->list.byte[7] ^= 1;
  write_bytes(&s->list, s->list.bytes);
  assert_false(sepax_job_list_is(path));
  assert_false(sepax_job_list_is("no/such.sxj"));
  free_scene(s);
}

/* Numbers that are wrong though the CRCs are right: one at a time. */
CASE(files_that_are_no_list) {
  static const struct {
    uint64_t at; /* from the header, from the first job: 1 << 20, pose: 1 << 21, body: 1 << 22 */
    uint8_t bits;
    const char *words;
  } wrong[] = {{12, 32, "that of no list"},
               {15, 1, "that of no list"},
               {19, 1, "that of no list"},
               {23, 1, "that of no list"},
               {31, 1, "that of no list"},
               {35, 1, "that of no list"},
               {42, 1, "that of no list"},
               {50, 1, "that of no list"},
               {58, 1, "that of no list"},
               {56, 64, "that of no list"},
               {66, 1, "bytes, not"},
               {(1 << 20) + 1, 16, "job 0 is none"},
               {(1 << 20) + 9, 1, "job 0 is none"},
               {(1 << 20) + 8, 1, "job 0 is none"},
               {(1 << 20) + 33, 16, "job 0 is none"},
               {(1 << 20) + 66, 255, "job 0 is none"},
               {(1 << 20) + 72, 1, "job 0 is none"},
               {(1 << 20) + 77, 1, "job 0 is none"},
               {(1 << 21) + 7, 64, "a pose has the shift"},
               {(1 << 21) + 51, 64, "a matrix has the entry"},
               {(1 << 22) + 1, 32, "body a table: "},
               {(1 << 22) + 8, 16, "body a table: "},
               {(1 << 22) + 12, 1, "body 0 is beyond"},
               {(1 << 22) + 4, 1, "body 0 is beyond"},
               {(1 << 22) + 255, 1, "body 0 is beyond"}};
  scene *s = new_scene();
  uint8_t *byte = s->list.byte;
  const uint64_t part[] = {0, s->list.list, bytes_get64(byte + s->list.list + 64),
                           bytes_get64(byte + 40)};
  for (size_t n = 0; n < LENGTH(wrong); n++) {
    uint64_t kind = wrong[n].at >> 20;
    uint64_t at = part[kind == 4 ? 3 : kind] + (wrong[n].at & 0xfffff);
    byte[at] ^= wrong[n].bits;
    refused_whole(&s->list, wrong[n].words);
    byte[at] ^= wrong[n].bits;
  }
  bytes_put32(byte + 12, WORD - 1); /* bodies have more bits */
  refused_whole(&s->list, "its word or resolution");
  bytes_put32(byte + 12, WORD);
  byte[4096 + 16 + 6] ^= 16; /* the first tree's resolution */
  bytes_put32(byte + 4096 + 68, sepax__tree_crc(0, byte + 4096, 68));
  refused_whole(&s->list, "its word or resolution");
  free_scene(s);
}
