/* SPDX-License-Identifier: MIT */
/* job_list.c - makes, writes and reads lists of jobs with their bodies and poses
 * (docs/reference/tree-engine.md, The list in a file). */
#include "tree_engine/tree.h"
#include "util/error.h"
#include "util/write_file.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum {
  VERSION = 1,
  HEADER = TREE_PAGE,
  ROW = 256, /* bytes of a body in the table */
  ROW_NAME = 16
};
#define BYTES_MOST (UINT64_C(1) << 31)
static const char magic[8] = {'s', 'e', 'p', 'a', 'x', 'S', 'X', 'J'};

/* Places of the numbers in the header, in bytes. */
enum {
  AT_VERSION = 8,
  AT_WORD = 12,
  AT_CLEARANCE = 16,
  AT_WARNING = 20,
  AT_BODIES = 24,
  AT_JOBS = 28,
  AT_POSES = 32,
  AT_TABLE = 40,
  AT_LINES = 48,
  AT_LIST = 56,
  AT_BYTES = 64,
  AT_CRC = 72,
  AT_HEADER_CRC = 76
};

static uint64_t up(uint64_t at, uint64_t unit) { return (at + unit - 1) / unit * unit; }

static const uint8_t *row_of(const sepax_job_list *list, uint32_t body) {
  return list->byte + bytes_get64(list->byte + AT_TABLE) + ROW * (uint64_t)body;
}

void sepax_job_list_free(sepax_job_list *list) {
  free(list->byte);
  *list = (sepax_job_list){.byte = NULL};
}

/* ----------------------------------------------------------------------- making */

/* Places of the parts of a list, and its size, in bytes. */
typedef struct {
  uint64_t table, lines, poses, list, bytes;
} places;

static uint64_t queue_bytes(const sepax_job_scene *s) {
  return SEPAX_TREE_POSE_STRIDE * (uint64_t)s->poses;
}

static places places_of(const sepax_job_scene *s) {
  places at = {.table = HEADER};
  for (size_t n = 0; n < s->bodies; n++) {
    at.table = up(at.table + sepax__tree_file_bytes(s->tree[n]), TREE_PAGE);
  }
  at.lines = at.table + ROW * (uint64_t)s->bodies;
  at.poses = up(at.lines + 4 * (uint64_t)s->poses, SEPAX_TREE_POSE_STRIDE);
  at.list = at.poses + queue_bytes(s) * s->pairs;
  at.bytes = at.list + SEPAX_TREE_JOB_BYTES * (uint64_t)s->pairs;
  return at;
}

/* Write all trees, each with the bytes of its own file, and the table of bodies. */
static bool put_trees(uint8_t *byte, const sepax_job_scene *s, const places *at) {
  uint64_t place = HEADER;
  bool ok = true;
  for (size_t n = 0; n < s->bodies && ok; n++) {
    uint64_t bytes = sepax__tree_file_bytes(s->tree[n]);
    uint8_t *row = byte + at->table + ROW * n;
    FILE *out = fmemopen(byte + place, (size_t)bytes, "wb");
    ok = out != NULL && setvbuf(out, NULL, _IONBF, 0) == 0 &&
         sepax__tree_file_write(out, s->tree[n]);
    ok = out != NULL && fclose(out) == 0 && ok;
    bytes_put64(row, place);
    bytes_put64(row + 8, bytes);
    strncpy((char *)row + ROW_NAME, s->name[n], ROW - ROW_NAME - 1);
    place = up(place + bytes, TREE_PAGE);
  }
  return ok;
}

static void put_jobs(uint8_t *byte, const sepax_job_scene *s, const places *at) {
  for (size_t n = 0; n < s->poses; n++) {
    bytes_put32(byte + at->lines + 4 * n, s->line[n]);
  }
  for (size_t n = 0; n < s->pairs; n++) {
    const sepax_job_pair *pair = &s->pair[n];
    sepax_tree_job job = {
        .poses = at->poses + queue_bytes(s) * n, .count = (uint32_t)s->poses, .modes = s->modes};
    for (int side = 0; side < 2; side++) {
      const uint8_t *row = byte + at->table + ROW * pair->body[side];
      sepax_tree_body(s->tree[pair->body[side]], bytes_get64(row) + HEADER, job.body[side]);
    }
    for (size_t k = 0; k < s->poses; k++) {
      sepax_tree_pose_pack(&pair->pose[k], byte + job.poses + SEPAX_TREE_POSE_STRIDE * k);
    }
    sepax_tree_job_pack(&job, byte + at->list + SEPAX_TREE_JOB_BYTES * n);
  }
}

static void put_header(uint8_t *byte, const sepax_job_scene *s, const places *at) {
  memcpy(byte, magic, sizeof magic);
  bytes_put32(byte + AT_VERSION, VERSION);
  bytes_put32(byte + AT_WORD, (uint32_t)s->word);
  bytes_put32(byte + AT_CLEARANCE, (uint32_t)s->clearance);
  bytes_put32(byte + AT_WARNING, (uint32_t)s->warning);
  bytes_put32(byte + AT_BODIES, (uint32_t)s->bodies);
  bytes_put32(byte + AT_JOBS, (uint32_t)s->pairs);
  bytes_put32(byte + AT_POSES, (uint32_t)s->poses);
  bytes_put64(byte + AT_TABLE, at->table);
  bytes_put64(byte + AT_LINES, at->lines);
  bytes_put64(byte + AT_LIST, at->list);
  bytes_put64(byte + AT_BYTES, at->bytes);
  bytes_put32(byte + AT_CRC, sepax__tree_crc(0, byte + HEADER, (size_t)(at->bytes - HEADER)));
  bytes_put32(byte + AT_HEADER_CRC, sepax__tree_crc(0, byte, AT_HEADER_CRC));
}

bool sepax_job_list_make(sepax_job_list *list, const sepax_job_scene *s, sepax_error *error) {
  *list = (sepax_job_list){.byte = NULL};
  if (s->bodies == 0 || s->pairs == 0 || s->poses == 0) {
    return sepax_fail(error, SEPAX_ERROR_FORMAT,
                      "a list of jobs has bodies, pairs and poses; here are %zu, %zu, %zu",
                      s->bodies, s->pairs, s->poses);
  }
  const places at = places_of(s);
  if (s->poses > BYTES_MOST / SEPAX_TREE_POSE_STRIDE ||
      s->pairs > BYTES_MOST / SEPAX_TREE_POSE_STRIDE || at.bytes > BYTES_MOST) {
    return sepax_fail(error, SEPAX_ERROR_LIMIT,
                      "%zu poses of %zu pairs are more than a list of 2 GiB; divide the path",
                      s->poses, s->pairs);
  }
  uint8_t *byte = calloc((size_t)at.bytes, 1);
  if (byte == NULL || !put_trees(byte, s, &at)) {
    free(byte);
    return sepax_fail(error, SEPAX_ERROR_MEMORY, "no memory for a list of %llu bytes",
                      (unsigned long long)at.bytes);
  }
  put_jobs(byte, s, &at);
  put_header(byte, s, &at);
  *list = (sepax_job_list){.byte = byte,
                           .bytes = (size_t)at.bytes,
                           .list = at.list,
                           .jobs = (uint32_t)s->pairs,
                           .poses = (uint32_t)s->poses,
                           .bodies = (uint32_t)s->bodies,
                           .word = s->word,
                           .clearance = s->clearance,
                           .warning = s->warning};
  return true;
}

static bool write_list(FILE *out, const void *context) {
  const sepax_job_list *list = context;
  return fwrite(list->byte, list->bytes, 1, out) == 1;
}

bool sepax_job_list_write(const sepax_job_list *list, const char *path, sepax_error *error) {
  return sepax_write_file(path, write_list, list, error);
}

/* ---------------------------------------------------------------------- reading */

bool sepax_job_list_is(const char *path) {
  char head[sizeof magic];
  FILE *in = fopen(path, "rb");
  bool is =
      in != NULL && fread(head, sizeof head, 1, in) == 1 && memcmp(head, magic, sizeof magic) == 0;
  if (in != NULL) {
    fclose(in);
  }
  return is;
}

/* Read the whole file. Memory is allocated only for bytes that the file really has, so a damaged
 * header cannot ask for too much. */
static bool read_bytes(sepax_job_list *list, FILE *in, sepax_error *error) {
  uint8_t head[HEADER];
  if (fread(head, HEADER, 1, in) != 1 || memcmp(head, magic, sizeof magic) != 0) {
    return sepax_fail(error, SEPAX_ERROR_FORMAT,
                      "no list of jobs; make one with 'sepax path --jobs=FILE'");
  }
  if (bytes_get32(head + AT_VERSION) != VERSION) {
    return sepax_fail(error, SEPAX_ERROR_FORMAT, "version %u of the format, not %d; make it again",
                      bytes_get32(head + AT_VERSION), VERSION);
  }
  bool zeros = true;
  for (int n = AT_HEADER_CRC + 4; n < HEADER; n++) {
    zeros = zeros && head[n] == 0;
  }
  if (!zeros || bytes_get32(head + AT_HEADER_CRC) != sepax__tree_crc(0, head, AT_HEADER_CRC)) {
    return sepax_fail(error, SEPAX_ERROR_FORMAT,
                      "the header's CRC is wrong; the file is damaged, make it again");
  }
  uint64_t bytes = bytes_get64(head + AT_BYTES);
  long end = fseek(in, 0, SEEK_END) == 0 ? ftell(in) : -1;
  if (end < HEADER || (uint64_t)end != bytes || bytes > BYTES_MOST || fseek(in, 0, SEEK_SET) != 0) {
    return sepax_fail(error, SEPAX_ERROR_FORMAT,
                      "%ld bytes, not %llu; the file is cut or has more, make it again", end,
                      (unsigned long long)bytes);
  }
  list->byte = malloc((size_t)bytes);
  list->bytes = (size_t)bytes;
  if (list->byte == NULL) {
    return sepax_fail(error, SEPAX_ERROR_MEMORY, "no memory for a list of %ld bytes", end);
  }
  if (fread(list->byte, list->bytes, 1, in) != 1) {
    return sepax_fail(error, SEPAX_ERROR_FILE, "not read: %s", strerror(errno));
  }
  return bytes_get32(head + AT_CRC) ==
             sepax__tree_crc(0, list->byte + HEADER, list->bytes - HEADER) ||
         sepax_fail(error, SEPAX_ERROR_FORMAT,
                    "the CRC is wrong; the file is damaged, make it again");
}

/* True if `count` elements of `size` bytes from `at` on are inside the file and after the header,
 * and `at` is a multiple of `unit`. */
static bool within(const sepax_job_list *list, uint64_t at, uint64_t count, uint64_t size,
                   uint64_t unit) {
  return at >= HEADER && at % unit == 0 && at <= list->bytes && count * size <= list->bytes - at;
}

static bool take_header(sepax_job_list *list, sepax_error *error) {
  const uint8_t *head = list->byte;
  list->bodies = bytes_get32(head + AT_BODIES);
  list->jobs = bytes_get32(head + AT_JOBS);
  list->poses = bytes_get32(head + AT_POSES);
  list->list = bytes_get64(head + AT_LIST);
  uint32_t word = bytes_get32(head + AT_WORD);
  uint32_t clearance = bytes_get32(head + AT_CLEARANCE);
  uint32_t warning = bytes_get32(head + AT_WARNING);
  bool ok = list->bodies > 0 && list->jobs > 0 && list->poses > 0 &&
            within(list, bytes_get64(head + AT_TABLE), list->bodies, ROW, ROW) &&
            within(list, bytes_get64(head + AT_LINES), list->poses, 4, 4) &&
            within(list, list->list, list->jobs, SEPAX_TREE_JOB_BYTES, SEPAX_TREE_JOB_BYTES) &&
            word >= SEPAX_WORD_MIN && word <= SEPAX_TREE_WORD_MAX && clearance <= INT16_MAX &&
            warning <= INT16_MAX;
  list->word = (int)word;
  list->clearance = (int)clearance;
  list->warning = (int)warning;
  return ok ||
         sepax_fail(error, SEPAX_ERROR_FORMAT, "the header is that of no list; make it again");
}

/* Check the tree of a body, and write its body record. */
static bool check_tree(const sepax_job_list *list, uint32_t body,
                       uint8_t record[SEPAX_TREE_BODY_BYTES], sepax_error *error) {
  const uint8_t *row = row_of(list, body);
  uint64_t place = bytes_get64(row);
  uint64_t bytes = bytes_get64(row + 8);
  if (!within(list, place, 1, bytes > 0 ? bytes : list->bytes + 1, TREE_PAGE) ||
      row[ROW - 1] != '\0') {
    return sepax_fail(error, SEPAX_ERROR_FORMAT, "body %u is beyond the file; make it again", body);
  }
  sepax_error inner = {0};
  sepax_tree *tree = NULL;
  FILE *in = fmemopen(list->byte + place, (size_t)bytes, "rb");
  bool ok = in != NULL && sepax__tree_file_read(&tree, in, &inner);
  if (in != NULL) {
    fclose(in);
  }
  if (!ok) {
    return sepax_fail(error, inner.code, "body %.60s: %.300s", (const char *)row + ROW_NAME,
                      inner.text);
  }
  sepax_grid grid = sepax_tree_grid(tree);
  ok = (grid.word <= list->word && grid.resolution == sepax_job_list_resolution(list)) ||
       sepax_fail(error, SEPAX_ERROR_FORMAT,
                  "body %.60s: its word or resolution is not that of the list",
                  (const char *)row + ROW_NAME);
  sepax_tree_body(tree, place + HEADER, record);
  sepax_tree_free(tree);
  return ok;
}

static bool check_job(const sepax_job_list *list, const uint8_t *records, uint32_t n,
                      sepax_error *error) {
  sepax_tree_job job;
  bool ok = sepax_tree_job_unpack(&job, list->byte + list->list + SEPAX_TREE_JOB_BYTES * n) &&
            job.count == list->poses &&
            within(list, job.poses, job.count, SEPAX_TREE_POSE_STRIDE, SEPAX_TREE_POSE_STRIDE);
  for (int side = 0; side < 2 && ok; side++) {
    uint32_t body = sepax_job_list_body(list, n, side);
    ok = body < list->bodies &&
         memcmp(job.body[side], records + SEPAX_TREE_BODY_BYTES * body, SEPAX_TREE_BODY_BYTES) == 0;
  }
  for (uint32_t k = 0; k < job.count && ok; k++) {
    sepax_tree_pose pose;
    const uint8_t *bytes = list->byte + job.poses + SEPAX_TREE_POSE_STRIDE * (uint64_t)k;
    if (!sepax_tree_pose_unpack(&pose, bytes, error)) {
      return false;
    }
  }
  return ok || sepax_fail(error, SEPAX_ERROR_FORMAT,
                          "job %u is none of these bodies and poses; make it again", n);
}

static bool read_list(sepax_job_list *list, FILE *in, sepax_error *error) {
  if (!read_bytes(list, in, error) || !take_header(list, error)) {
    return false;
  }
  uint8_t *records = calloc(list->bodies, SEPAX_TREE_BODY_BYTES);
  bool ok = records != NULL ||
            sepax_fail(error, SEPAX_ERROR_MEMORY, "no memory for %u bodies", list->bodies);
  for (uint32_t n = 0; n < list->bodies && ok; n++) {
    ok = check_tree(list, n, records + SEPAX_TREE_BODY_BYTES * (size_t)n, error);
  }
  for (uint32_t n = 0; n < list->jobs && ok; n++) {
    ok = check_job(list, records, n, error);
  }
  free(records);
  return ok;
}

bool sepax_job_list_read(sepax_job_list *list, const char *path, sepax_error *error) {
  *list = (sepax_job_list){.byte = NULL};
  FILE *in = fopen(path, "rb");
  if (in == NULL) {
    return sepax_fail(error, SEPAX_ERROR_FILE, "%.300s: not read: %s", path, strerror(errno));
  }
  sepax_error inner = {0};
  bool ok = read_list(list, in, &inner);
  fclose(in);
  if (!ok) {
    sepax_job_list_free(list);
    return sepax_fail(error, inner.code, "%.200s: %.300s", path, inner.text);
  }
  return true;
}

/* -------------------------------------------------------------------- questions */

const char *sepax_job_list_name(const sepax_job_list *list, uint32_t body) {
  return (const char *)row_of(list, body) + ROW_NAME;
}

/* The header of a body's tree. */
static const uint8_t *tree_of(const sepax_job_list *list, uint32_t body) {
  return list->byte + bytes_get64(row_of(list, body));
}

uint32_t sepax_job_list_triangles(const sepax_job_list *list, uint32_t body) {
  return bytes_get32(tree_of(list, body) + 52);
}

double sepax_job_list_resolution(const sepax_job_list *list) {
  uint64_t bits = bytes_get64(tree_of(list, 0) + 16);
  double x;
  memcpy(&x, &bits, sizeof x);
  return x;
}

uint32_t sepax_job_list_body(const sepax_job_list *list, uint32_t job, int side) {
  uint64_t address = bytes_get64(list->byte + list->list + SEPAX_TREE_JOB_BYTES * (uint64_t)job +
                                 (uint64_t)(SEPAX_TREE_BODY_BYTES * side));
  uint32_t body = 0;
  while (body < list->bodies && bytes_get64(row_of(list, body)) + HEADER != address) {
    body++;
  }
  return body;
}

uint32_t sepax_job_list_line(const sepax_job_list *list, uint32_t pose) {
  return bytes_get32(list->byte + bytes_get64(list->byte + AT_LINES) + 4 * (uint64_t)pose);
}

void sepax_job_list_config(const sepax_job_list *list, sepax_config *config) {
  config->tree = true;
  config->word = list->word;
  config->clearance = list->clearance;
  config->warning = list->warning;
}
