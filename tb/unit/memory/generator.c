/* SPDX-License-Identifier: MIT */
/* generator.c - the generator without memory: of each design one allocation in turn is refused, and
 * each time it fails with an error, leaves no folder and gives back what it took. */
#include "scarce.h"

#include "exact/exact.h"
#include "files/describe.h"
#include "generate.h"

#include <limits.h>
#include <stdio.h>
#include <sys/stat.h>

/* Of some thousand allocations of a design these: all at first, then one of so many. */
enum { FIRST = 40, STRIDE = SANITIZED ? 397 : 41 };

static char whole[PATH_BYTES], scanty[PATH_BYTES]; /* folders: with all memory, and without some */

static bool run_shell(const char *what, const char *in) {
  char command[2 * PATH_BYTES + 32];
  snprintf(command, sizeof command, "%s %s %s", what, in, strcmp(what, "rm -r") == 0 ? "" : whole);
  return system(command) == 0;
}

/* With allocation n refused; false if there were fewer. libc does without some memory that it asks
 * for: then the design is whole. */
static bool try_without(const sepax_design *of, long n) {
  struct stat status;
  sepax_design design = *of;
  fault = (sepax_error){.code = SEPAX_OK};
  memory.taken = 0;
  memory.left = n;
  memory.watched = true;
  bool works = sepax_generate(&design, scanty, &(sepax_output){NULL}, &fault);
  memory.watched = false;
  bool refused = memory.left < 0;
  bool there = stat(scanty, &status) == 0;
  if (works != there || works != (fault.code == SEPAX_OK) || memory.taken != 0 ||
      (!works && !refused) || (works && !run_shell("diff -r", scanty))) {
    fail_msg("allocation %ld: %s, %ld stay, folder %s: %s", n, works ? "works" : "fails",
             memory.taken, there ? "is there" : "is not", fault.text);
  }
  assert_true(!there || run_shell("rm -r", scanty));
  return refused;
}

static void expect_errors(const char *options) {
  sepax_design design = design_of("%s", options);
  long tried = 0;
  snprintf(whole, sizeof whole, "%s/whole", folder);
  snprintf(scanty, sizeof scanty, "%s/scanty", folder);
  assert_works(sepax_generate(&design, whole, &(sepax_output){NULL}, &fault));
  for (long n = 0; try_without(&design, n); n += n < FIRST ? 1 : STRIDE) {
    tried++;
  }
  assert_true(tried > FIRST && run_shell("rm -r", whole));
}

/* A description with allocation n refused, as text; NULL if the description says that it failed. */
typedef void describe(const emitter *e, emit_text *out);
static char *description(describe *of, const emitter *e, long n) {
  emit_text out = {0};
  memory.left = n;
  memory.watched = true;
  of(e, &out);
  memory.watched = false;
  return text_take(&out);
}

/* Every allocation in turn: jansson leaves out what it cannot copy, and a reader of ports that has
 * no memory finds none. */
static void expect_whole_or_none(describe *of, const emitter *e, long least) {
  char *complete = description(of, e, LONG_MAX);
  assert_non_null(complete);
  long n = 0;
  do {
    char *text = description(of, e, n++);
    assert_true(text == NULL || strcmp(text, complete) == 0);
    free(text);
  } while (memory.left < 0);
  assert_true(n > least);
  free(complete);
}

CASE(every_allocation_of_the_descriptions) {
  sepax_design design = design_of("%s", "--word=6 --ii=6 --lanes=2 --clearance=1");
  emitter e;
  emit_init(&e, &design, "sepax gen");
  assert_true(gen_exact(&e));
  expect_whole_or_none(describe_json, &e, 100);
  expect_whole_or_none(describe_constraints, &e, 1);
  expect_whole_or_none(describe_waves, &e, 1);
  emit_free(&e);
}

CASE(exact_design) { expect_errors("--word=6 --ii=3 --clock-gating=on --early-out=boxes"); }
CASE(paper_design) { expect_errors("--arch=paper --word=6"); }
CASE(object_engine) { expect_errors("--word=6 --ii=6 --lanes=4 --clearance=1 --warning=3"); }
CASE(tree_engine) { expect_errors("--word=6 --ii=6 --tree=on --target=ecp5 --clock-ns=10"); }
