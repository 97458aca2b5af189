/* SPDX-License-Identifier: MIT */
/* stock.c - stocks in files, whose hash is made right first; what is read can be written and read
 * again. */
#include "fuzz/fuzz.h"
#include "stock/stock.h"
#include "util/bytes.h"

#include <string.h>

enum { HEAD = 72, HASH = 8 };

/* The file, with its hash over all that comes before. */
static uint8_t *mend(const uint8_t *data, size_t size) {
  uint8_t *file = malloc(size + 1);
  REQUIRE(file != NULL);
  memcpy(file, data, size);
  uint64_t hash = 0xcbf29ce484222325U;
  for (size_t n = 0; n + HASH < size; n++) {
    hash = (hash ^ file[n]) * 0x100000001b3U;
  }
  if (size >= HEAD + HASH) {
    bytes_put64(file + size - HASH, hash);
  }
  return file;
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
  sepax__stock *stock;
  sepax_error error = {0};
  uint8_t *file = mend(data, size);
  fuzz_file("input.stock", file, size);
  free(file);
  bool ok = fuzz_answer(sepax__stock_read(&stock, "input.stock", &error), &error);
  REQUIRE(ok == (stock != NULL));
  if (ok) {
    sepax__stock *again;
    sepax__stock_facts facts = sepax__stock_look(stock);
    REQUIRE(sepax__stock_write(stock, "again.stock", &error));
    REQUIRE(sepax__stock_read(&again, "again.stock", &error));
    REQUIRE(sepax__stock_look(again).cells == facts.cells);
    REQUIRE(facts.cell > 0 && facts.box[0][0] < facts.box[1][0]);
    sepax__stock_free(again);
    sepax__stock_free(stock);
  }
  return 0;
}
