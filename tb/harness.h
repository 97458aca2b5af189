/* SPDX-License-Identifier: MIT */
/* harness.h - what the unit tests share: cases that list themselves, random numbers, designs made
 * from text, a scratch folder, asserts. */
#ifndef HARNESS_H
#define HARNESS_H

#include "sepax_design.h"
#include "sepax_vectors.h"

/* clang-format off */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>
#include <stdio.h>
/* clang-format on */

/* A test case. The program runs its cases in the order of their lines. */
#define CASE(name)                                                             \
  static void name(void **state);                                              \
  __attribute__((constructor(1000 + __LINE__))) static void add_##name(void) { \
    add_case(#name, name);                                                     \
  }                                                                            \
  static void name(__attribute__((unused)) void **state)
void add_case(const char *name, CMUnitTestFunction function);

#define LENGTH(array) (sizeof(array) / sizeof *(array))

/* How many random cases, and the step through a list of cases; fewer where each is slow, as in
 * `make experiment NAME=sanitize`. */
#ifndef FEWER_BY
#define FEWER_BY 1
#endif
#define FEWER(count) ((count) / FEWER_BY)
#define STEP FEWER_BY

#define PI 0x1.921fb54442d18p1

extern sepax_error fault; /* of the call under test */

/* The call under test is right, else its fault is told. */
#define assert_works(call)                   \
  do {                                       \
    if (!(call)) {                           \
      fail_msg("%s: %s", #call, fault.text); \
    }                                        \
  } while (0)

/* The call fails, and its fault is one line that has the part in it. */
#define assert_fault(call, part)                \
  do {                                          \
    fault = (sepax_error){0};                   \
    assert_false(call);                         \
    assert_int_not_equal(fault.code, SEPAX_OK); \
    assert_message(part);                       \
  } while (0)
void assert_message(const char *part);

/* The same numbers in every run: 0 ... count - 1; uniform in -1 ... 1. */
int random_below(int count);
double random_unit(void);

/* The number `ulps` doubles above x, or below it. */
double stepped(double x, int ulps);

/* The design of options like "--word=%d --ii=3"; of the default where none is given. */
sepax_design design_of(const char *options, ...) __attribute__((format(printf, 1, 2)));
/* Options that are no design: the refusal has `why` in it. */
void refuse_design(const char *options, const char *why);

/* A pair of family n modulo the number of families. */
sepax_pair mixed_pair(size_t n, int word, sepax_random *random);

/* ------------------------------------------------------------------------ meshes */

enum { PATH_BYTES = 1024 };

extern char folder[PATH_BYTES / 2]; /* scratch, removed at the end */
extern char path[PATH_BYTES];       /* part.stl in it */

/* The mesh of the file `path`. */
sepax_soup read_mesh(void);

/* The grid that sepax_grid_fit chooses: the meshes fit, and at the next finer
 * resolution they do not. */
sepax_grid assert_fit(const sepax_soup *const meshes[], size_t count, int word);

#endif
