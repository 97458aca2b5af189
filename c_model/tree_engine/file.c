/* SPDX-License-Identifier: MIT */
/* file.c - writes and reads files of trees (docs/reference/tree-engine.md, The file). */
#include "tree_engine/tree.h"
#include "util/error.h"
#include "util/write_file.h"

#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { VERSION = 1, HEADER = TREE_PAGE, HEADER_CRC = 68 };
static const char magic[8] = {'s', 'e', 'p', 'a', 'x', 'S', 'X', 'T'};

static void put_double(uint8_t *to, double x) {
  uint64_t bits;
  memcpy(&bits, &x, sizeof bits);
  bytes_put64(to, bits);
}

static double get_double(const uint8_t *from) {
  uint64_t bits = bytes_get64(from);
  double x;
  memcpy(&x, &bits, sizeof x);
  return x;
}

static void pack_table(uint8_t *to, const sepax_tree *tree) {
  for (size_t n = 0; n < tree->triangles; n++) {
    bytes_put32(to + 4 * n, tree->number[n]);
  }
}

static void pack_header(uint8_t *to, const sepax_tree *t, uint32_t crc) {
  memset(to, 0, HEADER);
  memcpy(to, magic, sizeof magic);
  bytes_put32(to + 8, VERSION);
  bytes_put32(to + 12, (uint32_t)t->grid.word);
  put_double(to + 16, t->grid.resolution);
  for (int i = 0; i < 3; i++) {
    put_double(to + 24 + 8 * i, t->grid.offset[i]);
  }
  bytes_put32(to + 48, t->nodes);
  bytes_put32(to + 52, t->triangles);
  bytes_put64(to + 56, t->bytes);
  bytes_put32(to + 64, crc);
  bytes_put32(to + HEADER_CRC, sepax__tree_crc(0, to, HEADER_CRC));
}

uint64_t sepax__tree_file_bytes(const sepax_tree *t) {
  return HEADER + (uint64_t)t->bytes + 4 * (uint64_t)t->triangles;
}

bool sepax__tree_file_write(FILE *out, const sepax_tree *t) {
  size_t table_bytes = 4 * (size_t)t->triangles;
  uint8_t *table = malloc(table_bytes);
  if (table == NULL) {
    return false;
  }
  pack_table(table, t);
  uint8_t header[HEADER];
  pack_header(header, t,
              sepax__tree_crc(sepax__tree_crc(0, t->image, t->bytes), table, table_bytes));
  bool ok = fwrite(header, HEADER, 1, out) == 1 && fwrite(t->image, t->bytes, 1, out) == 1 &&
            fwrite(table, table_bytes, 1, out) == 1;
  free(table);
  return ok;
}

static bool write_tree(FILE *out, const void *context) {
  return sepax__tree_file_write(out, context);
}

bool sepax_tree_write(const sepax_tree *tree, const char *path, sepax_error *error) {
  return sepax_write_file(path, write_tree, tree, error);
}

/* ------------------------------------------------------------------- reading */

static bool unpack_header(sepax_tree *t, const uint8_t *from, uint32_t *crc, sepax_error *error) {
  if (memcmp(from, magic, sizeof magic) != 0) {
    return sepax_fail(error, SEPAX_ERROR_FORMAT, "no tree; make one with 'sepax tree STL -o FILE'");
  }
  if (bytes_get32(from + 8) != VERSION) {
    return sepax_fail(error, SEPAX_ERROR_FORMAT,
                      "version %u of the format, not %d; make it again with 'sepax tree'",
                      bytes_get32(from + 8), VERSION);
  }
  bool zeros = true;
  for (int n = HEADER_CRC + 4; n < HEADER; n++) {
    zeros = zeros && from[n] == 0;
  }
  if (!zeros || bytes_get32(from + HEADER_CRC) != sepax__tree_crc(0, from, HEADER_CRC)) {
    return sepax_fail(error, SEPAX_ERROR_FORMAT,
                      "the header's CRC is wrong; the file is damaged, make it again");
  }
  uint32_t word = bytes_get32(from + 12);
  t->grid.resolution = get_double(from + 16);
  bool ok = word >= SEPAX_WORD_MIN && word <= SEPAX_TREE_WORD_MAX && t->grid.resolution > 0 &&
            isfinite(t->grid.resolution);
  t->grid.word = ok ? (int)word : 0;
  for (int i = 0; i < 3; i++) {
    t->grid.offset[i] = get_double(from + 24 + 8 * i);
    ok = ok && isfinite(t->grid.offset[i]);
  }
  t->nodes = bytes_get32(from + 48);
  t->triangles = bytes_get32(from + 52);
  uint64_t bytes = bytes_get64(from + 56);
  *crc = bytes_get32(from + 64);
  ok = ok && t->nodes > 0 && t->nodes <= TREE_NODES_MAX && t->triangles > 0 &&
       bytes % TREE_BEAT == 0 && bytes >= tree_records_at(t->nodes) &&
       bytes / TREE_BEAT <= UINT32_MAX;
  t->bytes = (size_t)bytes;
  if (!ok) {
    sepax_fail(error, SEPAX_ERROR_FORMAT, "the header is that of no tree; make it again");
  }
  return ok;
}

/* Read the image and the table. Memory is allocated only for bytes that the file really has, so a
 * damaged header cannot ask for too much. */
static bool read_behind(sepax_tree *t, FILE *in, uint32_t crc, sepax_error *error) {
  size_t table_bytes = 4 * (size_t)t->triangles;
  uint64_t all_bytes = sepax__tree_file_bytes(t);
  long end = fseek(in, 0, SEEK_END) == 0 ? ftell(in) : -1;
  if (t->triangles == 0 || end < 0 || (uint64_t)end != all_bytes ||
      fseek(in, HEADER, SEEK_SET) != 0) {
    return sepax_fail(error, SEPAX_ERROR_FORMAT,
                      "%ld bytes, not %llu; the file is cut or has more, make it again", end,
                      (unsigned long long)all_bytes);
  }
  uint8_t *table = calloc(t->triangles, 4);
  t->image = malloc(t->bytes);
  t->number = malloc(t->triangles * sizeof *t->number);
  bool ok = table != NULL && t->image != NULL && t->number != NULL;
  if (!ok) {
    sepax_fail(error, SEPAX_ERROR_MEMORY, "no memory for a tree of %u triangles", t->triangles);
  } else if (fread(t->image, t->bytes, 1, in) != 1 || fread(table, table_bytes, 1, in) != 1) {
    ok = sepax_fail(error, SEPAX_ERROR_FILE, "not read: %s", strerror(errno));
  } else if (sepax__tree_crc(sepax__tree_crc(0, t->image, t->bytes), table, table_bytes) != crc) {
    ok = sepax_fail(error, SEPAX_ERROR_FORMAT,
                    "the CRC is wrong; the file is damaged, make it again");
  }
  for (size_t n = 0; ok && n < t->triangles; n++) {
    t->number[n] = bytes_get32(table + 4 * n);
  }
  free(table);
  return ok;
}

static bool read_tree(sepax_tree *t, FILE *in, sepax_error *error) {
  uint8_t header[HEADER] = {0};
  uint32_t crc = 0;
  if (fread(header, HEADER, 1, in) != 1) {
    return sepax_fail(error, SEPAX_ERROR_FORMAT,
                      "too short for a tree; make one with 'sepax tree STL -o FILE'");
  }
  return unpack_header(t, header, &crc, error) && read_behind(t, in, crc, error) &&
         sepax__tree_check(t, error);
}

bool sepax__tree_file_read(sepax_tree **tree, FILE *in, sepax_error *error) {
  sepax_tree *made = calloc(1, sizeof *made);
  bool ok = made != NULL ? read_tree(made, in, error)
                         : sepax_fail(error, SEPAX_ERROR_MEMORY, "no memory");
  if (!ok) {
    sepax_tree_free(made);
  }
  *tree = ok ? made : NULL;
  return ok;
}

bool sepax_tree_read(sepax_tree **tree, const char *path, sepax_error *error) {
  *tree = NULL;
  FILE *in = fopen(path, "rb");
  if (in == NULL) {
    return sepax_fail(error, SEPAX_ERROR_FILE, "%.300s: not read: %s", path, strerror(errno));
  }
  sepax_error inner = {0};
  bool ok = sepax__tree_file_read(tree, in, &inner);
  fclose(in);
  return ok || sepax_fail(error, inner.code, "%.200s: %.300s", path, inner.text);
}
