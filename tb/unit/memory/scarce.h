/* SPDX-License-Identifier: MIT */
/* scarce.h - a memory that refuses: an operation is done again and again, each time with another of
 * its allocations refused, the first, the second, until none is. Each time it ends with a fault in
 * one line, or does without and ends as it should; and all that it took it has given back. */
#ifndef SCARCE_H
#define SCARCE_H

#include "harness.h"

#include <stdatomic.h>
#include <stdlib.h>
#include <string.h>

static struct {
  bool watched;
  bool keeps;        /* after a refusal, some of what was taken */
  atomic_long left;  /* allocations until one is refused */
  atomic_long taken; /* less what was given back */
} memory;

/* The allocator behind this one, which the address sanitizer calls while it begins. */
#ifdef __SANITIZE_ADDRESS__
#define BEHIND(name) __asm__("__interceptor_" name)
#define COUNTED(change)                                                         \
  ((void)(change))      /* it takes by itself what strdup gives; it counts, too \
                         */
enum { SANITIZED = 1 }; /* its threads do not begin without memory */
#else
#define BEHIND(name) __asm__("__libc_" name)
#define COUNTED(change) (memory.taken += memory.watched ? (change) : 0)
enum { SANITIZED = 0 };
#endif
void *next_malloc(size_t size) BEHIND("malloc");
void *next_calloc(size_t count, size_t size) BEHIND("calloc");
void *next_realloc(void *old, size_t size) BEHIND("realloc");
void *next_memalign(size_t alignment, size_t size) BEHIND("memalign");
void next_free(void *old) BEHIND("free");
#define EARLY __attribute__((no_sanitize("address", "undefined")))

EARLY static inline bool is_refused(void) {
  return memory.watched && atomic_fetch_sub(&memory.left, 1) == 0;
}

EARLY static inline void *taken(void *made) {
  COUNTED(made != NULL);
  return made;
}

EARLY void *malloc(size_t size) { return is_refused() ? NULL : taken(next_malloc(size)); }

EARLY void *calloc(size_t count, size_t size) {
  return is_refused() ? NULL : taken(next_calloc(count, size));
}

EARLY void *realloc(void *old, size_t size) {
  if (is_refused()) {
    return NULL;
  }
  void *made = next_realloc(old, size);
  return old == NULL ? taken(made) : made;
}

EARLY void *aligned_alloc(size_t alignment, size_t size) {
  return is_refused() ? NULL : taken(next_memalign(alignment, size));
}

EARLY void free(void *old) {
  COUNTED(-(old != NULL));
  next_free(old);
}

/* `work` is true if it is done as it should be, and false if it ended with a fault; it gives back
 * what it took either way. How many allocations were refused, one at a time. */
static inline long assert_scarce(bool (*work)(void *), void *context) {
  assert_works(work(context)); /* what stays for ever is there from now on */
  for (long n = 0;; n++) {
    fault.text[0] = '\0';
    memory.taken = 0;
    memory.left = n;
    memory.watched = true;
    bool works = work(context);
    memory.watched = false;
    bool refused = memory.left < 0;
    bool kept = memory.taken != 0 && !(refused && memory.keeps);
    if (kept || (!works && (!refused || fault.text[0] == '\0'))) {
      fail_msg("allocation %ld: %s, %ld stay: %s", n, works ? "works" : "fails", memory.taken,
               fault.text);
    }
    if (!refused) {
      return n;
    }
  }
}

#endif
