/* harness.h - what every unit test includes: cmocka with the headers that it wants before it. */
#ifndef HARNESS_H
#define HARNESS_H

/* clang-format off */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>
/* clang-format on */

/* A test case, for cmocka_unit_test. */
#define CASE(name) static void name(__attribute__((unused)) void **state)

#endif
