/* SPDX-License-Identifier: MIT */
/* memory.c - the allocator: malloc, realloc and free, or what the caller brought. */
#include "sepax.h"

#include <stdlib.h>

static void *of_malloc(void *context, size_t bytes) {
  (void)context;
  return malloc(bytes);
}

static void *of_realloc(void *context, void *memory, size_t bytes) {
  (void)context;
  return realloc(memory, bytes);
}

static void of_free(void *context, void *memory) {
  (void)context;
  free(memory);
}

static const sepax_allocator usual = {of_malloc, of_realloc, of_free, NULL};
static sepax_allocator chosen = {of_malloc, of_realloc, of_free, NULL};

void sepax_set_allocator(const sepax_allocator *allocator) {
  chosen = allocator != NULL ? *allocator : usual;
}

/* An allocation of 0 bytes may return NULL without being a failure, so 1 byte is requested. */
void *sepax_allocate(size_t bytes) {
  return chosen.allocate(chosen.context, bytes > 0 ? bytes : 1);
}

void *sepax_resize(void *memory, size_t bytes) {
  return chosen.resize(chosen.context, memory, bytes > 0 ? bytes : 1);
}

void sepax_release(void *memory) {
  if (memory != NULL) {
    chosen.release(chosen.context, memory);
  }
}
