/* SPDX-License-Identifier: MIT */
/* file.c - stocks in files. docs/reference/stock.md has the format. */
#include "stock/bricks.h"

#include "util/bytes.h"
#include "util/error.h"
#include "util/write_file.h"

#include <errno.h>
#include <math.h>
#include <string.h>

enum { HEAD_BYTES = 72, VERSION = 1, LAYERS_BYTES = 64 };
static const char magic[8] = "sepaxSTK";
static const uint64_t hash_start = 0xcbf29ce484222325U;

/* FNV-1a, 64 bits. */
static uint64_t hash_of(uint64_t hash, const uint8_t *byte, size_t count) {
  for (size_t n = 0; n < count; n++) {
    hash = (hash ^ byte[n]) * 0x100000001b3U;
  }
  return hash;
}

static void put_double(uint8_t *to, double number) {
  uint64_t word;
  memcpy(&word, &number, sizeof word);
  bytes_put64(to, word);
}

static double get_double(const uint8_t *from) {
  uint64_t word = bytes_get64(from);
  double number;
  memcpy(&number, &word, sizeof number);
  return number;
}

/* ----------------------------------------------------------------- writing */

static bool put(FILE *out, uint64_t *hash, const uint8_t *byte, size_t count) {
  *hash = hash_of(*hash, byte, count);
  return fwrite(byte, 1, count, out) == count;
}

static bool put_brick(FILE *out, uint64_t *hash, const sepax__stock *s, size_t brick) {
  uint8_t byte[1 + LAYERS_BYTES];
  uint32_t state = s->brick[brick];
  byte[0] = state == BRICK_EMPTY ? 0 : state == BRICK_FULL ? 1 : 2;
  for (int z = 0; z < BRICK; z++) {
    bytes_put64(byte + 1 + BRICK * z, brick_layer(s, brick, z));
  }
  return put(out, hash, byte, byte[0] == 2 ? sizeof byte : 1);
}

static bool put_stock(FILE *out, const void *context) {
  const sepax__stock *s = context;
  uint64_t hash = hash_start;
  uint8_t head[HEAD_BYTES] = {0};
  memcpy(head, magic, sizeof magic);
  bytes_put32(head + 8, VERSION);
  bytes_put32(head + 12, s->bound == SEPAX__STOCK_OUTER ? 0 : 1);
  put_double(head + 16, s->cell);
  for (int i = 0; i < 3; i++) {
    put_double(head + 24 + 8 * i, s->origin[i]);
    bytes_put64(head + 48 + 8 * i, s->bricks[i]);
  }
  bool ok = put(out, &hash, head, sizeof head);
  size_t bricks = s->bricks[0] * s->bricks[1] * s->bricks[2];
  for (size_t n = 0; ok && n < bricks; n++) {
    ok = put_brick(out, &hash, s, n);
  }
  uint8_t end[8];
  bytes_put64(end, hash);
  return ok && fwrite(end, 1, sizeof end, out) == sizeof end;
}

bool sepax__stock_write(const sepax__stock *stock, const char *path, sepax_error *error) {
  return sepax_write_file(path, put_stock, stock, error);
}

/* ----------------------------------------------------------------- reading */

typedef struct {
  FILE *in;
  const char *path;
  uint64_t hash;
  sepax_error *error;
} reader;

static bool fail_format(const reader *r, const char *what) {
  return sepax_fail(r->error, SEPAX_ERROR_FORMAT, "%.300s: %s; write the stock again", r->path,
                    what);
}

static bool get(reader *r, uint8_t *byte, size_t count) {
  if (fread(byte, 1, count, r->in) != count) {
    return ferror(r->in)
               ? sepax_fail(r->error, SEPAX_ERROR_FILE, "%.300s: %s", r->path, strerror(errno))
               : fail_format(r, "the stock is truncated");
  }
  r->hash = hash_of(r->hash, byte, count);
  return true;
}

/* The bytes of a file, or -1 with errno. */
static long size_of(FILE *in) {
  long at = ftell(in);
  if (at < 0 || fseek(in, 0, SEEK_END) != 0) {
    return -1;
  }
  long size = ftell(in);
  return size >= 0 && fseek(in, at, SEEK_SET) == 0 ? size : -1;
}

/* The box of the bricks gives back their number: sepax__stock_new counts bricks up to 2^-23. */
static bool make_stock(reader *r, const uint8_t head[HEAD_BYTES], sepax__stock **stock) {
  double cell = get_double(head + 16);
  double box[2][3];
  uint64_t bricks[3];
  uint32_t bound = bytes_get32(head + 12);
  bool ok = isfinite(cell) && cell > 0 && bound <= 1;
  double all = 1;
  for (int i = 0; i < 3; i++) {
    bricks[i] = bytes_get64(head + 48 + 8 * i);
    box[0][i] = get_double(head + 24 + 8 * i);
    box[1][i] = box[0][i] + (double)bricks[i] * BRICK * cell;
    all *= (double)bricks[i];
    ok = ok && isfinite(box[0][i]) && isfinite(box[1][i]) && bricks[i] > 0 && all <= 1 << 28;
  }
  if (!ok) {
    return fail_format(r, "the head of the stock has an impossible size");
  }
  long size = size_of(r->in);
  if (size < 0) {
    return sepax_fail(r->error, SEPAX_ERROR_FILE, "%.300s: %s", r->path, strerror(errno));
  }
  if (all > (double)size) { /* a brick has a byte; no memory is taken for what is not there */
    return fail_format(r, "the stock is truncated");
  }
  if (!sepax__stock_new(stock, bound == 0 ? SEPAX__STOCK_OUTER : SEPAX__STOCK_INNER, box, cell,
                        r->error)) {
    return false;
  }
  for (int i = 0; i < 3; i++) {
    ok = ok && *stock != NULL && (*stock)->bricks[i] == bricks[i];
  }
  return ok || fail_format(r, "the head of the stock has an impossible size");
}

static bool get_brick(reader *r, sepax__stock *s, const size_t at[3]) {
  uint8_t state = 0;
  uint8_t byte[LAYERS_BYTES] = {0};
  uint64_t layer[BRICK];
  if (!get(r, &state, 1) || (state == 2 && !get(r, byte, sizeof byte))) {
    return false;
  }
  bool mixed = false;
  for (int z = 0; z < BRICK; z++) {
    layer[z] = state == 0 ? 0 : state == 1 ? UINT64_MAX : bytes_get64(byte + BRICK * z);
    mixed = mixed || layer[z] != layer[0] || (layer[z] != 0 && layer[z] != UINT64_MAX);
  }
  if (state > 2 || mixed != (state == 2)) {
    return fail_format(r, "a brick of the stock is in no state that is known");
  }
  return state == 0 || sepax__brick_put(s, at, layer) || sepax__stock_no_memory(r->error);
}

static bool get_bricks(reader *r, sepax__stock *s) {
  size_t at[3];
  for (at[2] = 0; at[2] < s->bricks[2]; at[2]++) {
    for (at[1] = 0; at[1] < s->bricks[1]; at[1]++) {
      for (at[0] = 0; at[0] < s->bricks[0]; at[0]++) {
        if (!get_brick(r, s, at)) {
          return false;
        }
      }
    }
  }
  return true;
}

/* The hash after the bricks, and nothing after it. */
static bool get_end(reader *r) {
  uint64_t hash = r->hash;
  uint8_t end[8];
  if (!get(r, end, sizeof end)) {
    return false;
  }
  if (bytes_get64(end) != hash) {
    return fail_format(r, "the stock is damaged: its checksum is another one");
  }
  return fgetc(r->in) == EOF || fail_format(r, "the stock has bytes after its end");
}

static bool read_stock(reader *r, sepax__stock **stock) {
  uint8_t head[HEAD_BYTES] = {0};
  if (!get(r, head, sizeof head)) {
    return false;
  }
  if (memcmp(head, magic, sizeof magic) != 0) {
    return sepax_fail(r->error, SEPAX_ERROR_FORMAT,
                      "%.300s: no stock of sepax; give a file of --left without the ending .obj",
                      r->path);
  }
  if (bytes_get32(head + 8) != VERSION) {
    return sepax_fail(r->error, SEPAX_ERROR_FORMAT,
                      "%.300s: a stock of version %u, and this sepax reads version %d", r->path,
                      bytes_get32(head + 8), VERSION);
  }
  return make_stock(r, head, stock) && *stock != NULL && get_bricks(r, *stock) && get_end(r);
}

bool sepax__stock_read(sepax__stock **stock, const char *path, sepax_error *error) {
  *stock = NULL;
  reader r = {.in = fopen(path, "rb"), .path = path, .hash = hash_start, .error = error};
  if (r.in == NULL) {
    return sepax_fail(error, SEPAX_ERROR_FILE, "%.300s: %s", path, strerror(errno));
  }
  bool ok = read_stock(&r, stock);
  fclose(r.in);
  if (!ok) {
    sepax__stock_free(*stock);
    *stock = NULL;
  }
  return ok;
}
