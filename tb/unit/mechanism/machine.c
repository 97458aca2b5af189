/* SPDX-License-Identifier: MIT */
/* machine.c - queries of a whole machine without a travel, against one query for each pair. */
#include "unit/mechanism/rig.h"

CASE(verdicts_of_values) {
  memset(verdicts, 0, sizeof verdicts);
  for (int n = 0; n < FEWER(400); n++) {
    rig r;
    draw_rig(&r);
    for (int step = 0; step < 20; step++) {
      move(&r);
      double clearance = draw_clearance(&r);
      assert_verdict(&r, clearance, 0);
      if (random_below(4) == 0) { /* nothing moved: all is known */
        assert_int_equal(assert_verdict(&r, clearance, 0), r.pairs);
        assert_verdict(&r, draw_clearance(&r), 0);
      }
    }
    free_rig(&r);
  }
  assert_true(verdicts[SEPAX_NEAR] > FEWER(1000) && verdicts[SEPAX_APART] > FEWER(1000));
  assert_int_equal(verdicts[SEPAX_UNDECIDED], 0);
}

/* With a limit of work the verdict is right or not given. */
CASE(limits_of_work) {
  memset(verdicts, 0, sizeof verdicts);
  for (int n = 0; n < FEWER(200); n++) {
    rig r;
    draw_rig(&r);
    for (int step = 0; step < 20; step++) {
      move(&r);
      assert_verdict(&r, draw_clearance(&r), 1 + (uint64_t)random_below(1 << random_below(12)));
    }
    free_rig(&r);
  }
  assert_true(verdicts[SEPAX_NEAR] > FEWER(100) && verdicts[SEPAX_APART] > FEWER(100));
  assert_true(verdicts[SEPAX_UNDECIDED] > FEWER(100));
}

/* -------------------------------------------------------------------- measurement */

static void assert_measured(rig *r, double relative) {
  sepax_machine_answer answer;
  double least = INFINITY;
  const sepax_machine_query query = {
      .size = sizeof query, .measure = true, .relative = relative, .clearance = 0.1};
  assert_works(sepax_watch_ask(r->watch, r->value, &query, &answer, &fault));
  for (size_t n = 0; n < r->pairs; n++) {
    least = fmin(least, distance_of(r, n));
  }
  double ulp = stepped(least, 1) - least;
  assert_true(answer.least <= least + ulp && answer.most >= least - ulp);
  assert_true(answer.most - answer.least <= relative * answer.most + 3 * ulp);
  double nearest = distance_of(r, answer.nearest);
  assert_true(nearest >= least && nearest <= answer.most);
}

CASE(least_clearance) {
  static const double tolerances[] = {0, 1e-12, 1e-6, 0.1};
  for (int n = 0; n < FEWER(200); n++) {
    rig r;
    draw_rig(&r);
    for (int step = 0; step < 10; step++) {
      move(&r);
      assert_measured(&r, tolerances[random_below(4)]);
    }
    free_rig(&r);
  }
}

/* The interval is certain however little work is allowed. */
CASE(least_clearance_with_limits) {
  for (int n = 0; n < FEWER(200); n++) {
    rig r;
    draw_rig(&r);
    for (int step = 0; step < 10; step++) {
      move(&r);
      sepax_machine_answer answer;
      double least = INFINITY;
      const sepax_machine_query query = {.size = sizeof query,
                                         .measure = true,
                                         .work = 1 + (uint64_t)random_below(1 << random_below(12))};
      assert_works(sepax_watch_ask(r.watch, r.value, &query, &answer, &fault));
      for (size_t k = 0; k < r.pairs; k++) {
        least = fmin(least, distance_of(&r, k));
      }
      double ulp = stepped(least, 1) - least;
      assert_true(answer.least <= least + ulp && answer.most >= least - ulp);
    }
    free_rig(&r);
  }
}

/* ------------------------------------------------------------------------- errors */

CASE(refused_parts) {
  rig r = {0};
  sepax_machine *machine;
  draw_mechanism(&r);
  add_body(&r, 0, 3, 1);
  add_body(&r, 0, 3, 1);
  static const size_t pair[3][2] = {{0, 1}, {0, 2}, {0, 0}};
  const sepax_machine_parts right = {sizeof right, &r.m, r.body, 2, pair, 1};
  sepax_machine_parts parts = right;
  parts.pairs = 0;
  assert_fault(sepax_machine_new(&machine, &parts, &fault), "no pairs");
  assert_null(machine);
  parts.pairs = 2;
  assert_fault(sepax_machine_new(&machine, &parts, &fault), "pair 1 names the bodies 0 and 2");
  parts = right;
  parts.pair = &pair[2];
  assert_fault(sepax_machine_new(&machine, &parts, &fault), "two different ones");
  r.body[1].link = r.m.links;
  assert_fault(sepax_machine_new(&machine, &right, &fault), "body 1 is missing or names link");
  r.body[1].link = 0;
  assert_fault(sepax_machine_new(&machine, NULL, &fault), "no mechanism");
  sepax_mechanism unjoined = r.m;
  unjoined.order = NULL;
  parts = right;
  parts.mechanism = &unjoined;
  assert_fault(sepax_machine_new(&machine, &parts, &fault), "after sepax_mechanism_join");
  parts = right;
  parts.size = 0;
  assert_fault(sepax_machine_new(&machine, &parts, &fault), "has no size");
  free_rig(&r);
}

/* After an error the watch is as good as new. */
CASE(refused_queries) {
  for (int n = 0; n < FEWER(100); n++) {
    rig r;
    draw_rig(&r);
    sepax_machine_answer answer;
    size_t driven = SIZE_MAX;
    for (size_t k = 0; k < r.m.joints; k++) {
      driven = sepax_joint_driven(&r.m.joint[k]) ? k : driven;
    }
    move(&r);
    assert_verdict(&r, 0.1, 0);
    sepax_machine_query query = {.size = sizeof query, .clearance = -1};
    assert_fault(sepax_watch_ask(r.watch, r.value, &query, &answer, &fault), "clearance");
    query.clearance = NAN;
    assert_fault(sepax_watch_ask(r.watch, r.value, &query, &answer, &fault), "clearance");
    query = (sepax_machine_query){.size = sizeof query, .relative = -1};
    assert_fault(sepax_watch_ask(r.watch, r.value, &query, &answer, &fault), "tolerance");
    query.relative = 1; /* also if nothing is measured */
    assert_fault(sepax_watch_ask(r.watch, r.value, &query, &answer, &fault), "tolerance of 1");
    query.relative = 0;
    query.absolute = INFINITY;
    assert_fault(sepax_watch_ask(r.watch, r.value, &query, &answer, &fault), "tolerance of 0");
    query.absolute = 0;
    if (driven != SIZE_MAX) {
      static const double bad[] = {NAN, INFINITY, -INFINITY};
      double kept = r.value[driven];
      query = (sepax_machine_query){.size = sizeof query};
      r.value[driven] = bad[random_below(3)];
      assert_fault(sepax_watch_ask(r.watch, r.value, &query, &answer, &fault), "finite");
      assert_int_equal(answer.verdict, SEPAX_UNDECIDED);
      r.value[driven] = kept;
      query.travel = r.travel;
      r.travel[driven] = random_below(2) == 0 ? -1 : NAN;
      assert_fault(sepax_watch_ask(r.watch, r.value, &query, &answer, &fault), "travel");
      r.travel[driven] = 0;
    }
    assert_verdict(&r, 0.1, 0);
    free_rig(&r);
  }
}

CASE(links_beyond_limits) {
  rig r = {.m = row_of(1), .pair = {{0, 1}}, .pairs = 1};
  sepax_machine_answer answer;
  r.m.joint[0].kind = SEPAX_JOINT_PRISMATIC;
  assert_works(sepax_mechanism_join(&r.m, &fault));
  add_body(&r, 0, 3, 1);
  add_body(&r, 1, 3, 1);
  make_machine(&r);
  r.value[0] = 0x1p1001;
  assert_fault(sepax_watch_ask(r.watch, r.value, NULL, &answer, &fault), "beyond 2^1000");
  r.value[0] = 0x1p999;
  assert_works(sepax_watch_ask(r.watch, r.value, NULL, &answer, &fault));
  assert_int_equal(answer.verdict, SEPAX_APART);
  free_rig(&r);
}

/* A query that fails halfway leaves no pose behind: links on two slides, of which the first fails.
 */
CASE(error_halfway) {
  rig r = {.m = row_of(2), .pair = {{0, 1}}, .pairs = 1};
  sepax_machine_answer answer;
  for (size_t n = 0; n < 2; n++) {
    r.m.joint[n].kind = SEPAX_JOINT_PRISMATIC;
    r.m.joint[n].parent = 0;
  }
  assert_works(sepax_mechanism_join(&r.m, &fault));
  add_body(&r, 1, 3, 1);
  add_body(&r, 2, 3, 1);
  make_machine(&r);
  assert_works(sepax_watch_ask(r.watch, r.value, NULL, &answer, &fault));
  r.value[0] = 0x1p1001;
  r.value[1] = 100;
  assert_fault(sepax_watch_ask(r.watch, r.value, NULL, &answer, &fault), "beyond 2^1000");
  r.value[0] = 100;
  assert_verdict(&r, stepped(distance_of(&r, 0), 1), 0);
  assert_verdict(&r, stepped(distance_of(&r, 0), -1), 0);
  free_rig(&r);
}
