/* SPDX-License-Identifier: MIT */
/* reading.h - what the tests of the mesh readers share: a file as it was read, and allocations that
 * are refused. */
#ifndef READING_H
#define READING_H

#include "sepax_io.h"
#include "unit/formats/files.h"

static sepax_soup soup;
static sepax_mesh_account account;

static inline void assert_triangle(size_t n, const double v[9]) {
  assert_true(n < soup.count);
  for (int i = 0; i < 9; i++) {
    assert_true(soup.facet[n].v[i / 3][i % 3] == v[i]);
  }
}
#define TRIANGLE(n, ...) assert_triangle(n, (const double[9]){__VA_ARGS__})

/* How many elements of this kind have no surface. */
static inline size_t others(const char *what) {
  for (size_t n = 0; n < account.others; n++) {
    if (strcmp(account.other[n].what, what) == 0) {
      return account.other[n].count;
    }
  }
  return 0;
}

/* Of the allocations that are this library's, each is refused in turn. */
static long left_to_refuse;
static long taken;

static inline bool is_refused(void) { return left_to_refuse-- == 0; }

static inline void *scarce_allocate(void *context, size_t size) {
  (void)context;
  void *memory = is_refused() ? NULL : malloc(size);
  taken += memory != NULL;
  return memory;
}

static inline void *scarce_resize(void *context, void *old, size_t size) {
  (void)context;
  void *memory = is_refused() ? NULL : realloc(old, size);
  taken += old == NULL && memory != NULL;
  return memory;
}

static inline void scarce_release(void *context, void *old) {
  (void)context;
  taken -= old != NULL;
  free(old);
}

static inline void refuse_each_allocation(const char *at) {
  const sepax_allocator scarce = {scarce_allocate, scarce_resize, scarce_release, NULL};
  long n = 0;
  bool ok = false;
  sepax_set_allocator(&scarce);
  for (; !ok && n < 1000; n++) {
    left_to_refuse = n;
    taken = 0;
    ok = sepax_mesh_read(&soup, &account, at, NULL, &fault);
    if (ok) {
      sepax_soup_free(&soup);
    }
    if (taken != 0 || (!ok && fault.code != SEPAX_ERROR_MEMORY)) {
      sepax_set_allocator(NULL);
      fail_msg("allocation %ld: %ld stay, code %d: %s", n, taken, (int)fault.code, fault.text);
    }
  }
  sepax_set_allocator(NULL);
  assert_true(ok && n > 5);
}

#endif
