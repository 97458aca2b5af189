/* SPDX-License-Identifier: MIT */
/* bounds_compiled.h - distance/bounds.c compiled once more, under names of the test, because its
 * functions are static. */
#define sepax__search_begin search_begin_of_test
#define sepax__set_way set_way_of_test
#define sepax__find_most find_most_of_test
#define sepax__bound_children bound_children_of_test
#define sepax__exact_bound exact_bound_of_test
#define sepax__enclose_waiting enclose_waiting_of_test
#define sepax__place_at place_at_of_test
#include "distance/bounds.c" /* NOLINT(bugprone-suspicious-include): compiled once more */
