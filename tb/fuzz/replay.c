/* SPDX-License-Identifier: MIT */
/* replay.c - a fuzz target on given files, without a fuzzer.
 *   replay FILE...
 * Exit status 1: the reader accepted none of them. */
#include "fuzz/fuzz.h"

#include <stdio.h>
#include <string.h>

static void replay(const char *name) {
  enum { MOST = 1 << 20 };
  FILE *in = fopen(name, "rb");
  uint8_t *data = malloc(MOST);
  REQUIRE(in != NULL && data != NULL);
  size_t size = fread(data, 1, MOST, in);
  fclose(in);
  uint8_t *exact = malloc(size > 0 ? size : 1); /* so that a sanitizer sees its end */
  REQUIRE(exact != NULL);
  memcpy(exact, data, size);
  free(data);
  LLVMFuzzerTestOneInput(exact, size);
  free(exact);
}

int main(int count, char **names) {
  for (int n = 1; n < count; n++) {
    replay(names[n]);
  }
  printf("%d inputs, %zu accepted\n", count - 1, fuzz_accepted);
  return fuzz_accepted > 0 ? 0 : 1;
}
