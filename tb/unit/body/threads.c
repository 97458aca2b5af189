/* SPDX-License-Identifier: MIT */
/* threads.c - threads that share two bodies or a machine find what one thread finds; `make
 * experiment NAME=sanitize` runs this with the thread sanitizer, too. */
#include "harness.h"
#include "sepax_mechanism.h"

#include <math.h>
#include <pthread.h>

enum { THREADS = 4, POSES = 6 };

typedef struct {
  size_t pairs;
  bool any;
  double distance;
} answer;

typedef struct {
  const sepax_body *a, *b;
  sepax_pose pose[POSES];
  answer found[POSES];
  bool failed;
} asker;

static answer ask(const asker *who, const sepax_pose *pose, bool *failed) {
  sepax_error error = {0};
  sepax_pairs all = {0};
  sepax_pairs any = {0};
  sepax_query only_any = {.size = sizeof(sepax_query), .only_any = true};
  sepax_distance_result away;
  *failed = !sepax_bodies_collide(who->a, NULL, who->b, pose, NULL, &all, &error) ||
            !sepax_bodies_collide(who->a, pose, who->b, NULL, &only_any, &any, &error) ||
            !sepax_bodies_distance(who->a, NULL, who->b, pose, NULL, &away, &error) || *failed;
  answer found = {all.count, any.count > 0, *failed ? 0 : away.min_distance};
  sepax_pairs_free(&all);
  sepax_pairs_free(&any);
  return found;
}

static void *run(void *context) {
  asker *who = context;
  for (int n = 0; n < POSES; n++) {
    who->found[n] = ask(who, &who->pose[n], &who->failed);
  }
  return NULL;
}

static sepax_body *sample_body(const char *shape, size_t triangles) {
  static const double at[3] = {0, 0, 0};
  sepax_soup mesh;
  sepax_body *body;
  assert_works(sepax_sample(&mesh, shape, triangles, at, 40, &fault));
  assert_works(sepax_body_new(&body, SEPAX_SOUP_MESH(&mesh), NULL, &fault));
  sepax_soup_free(&mesh);
  return body;
}

CASE(threads_share_bodies) {
  sepax_body *a = sample_body("sphere", 2000);
  sepax_body *b = sample_body("box", 500);
  static asker who[THREADS];
  pthread_t thread[THREADS];
  size_t hits = 0;
  for (int t = 0; t < THREADS; t++) {
    who[t] = (asker){.a = a, .b = b};
    for (int n = 0; n < POSES; n++) {
      double turn = random_unit();
      who[t].pose[n] =
          (sepax_pose){{{cos(turn), -sin(turn), 0}, {sin(turn), cos(turn), 0}, {0, 0, 1}},
                       {30 * random_unit(), 30 * random_unit(), 30 * random_unit()}};
    }
  }
  for (int t = 0; t < THREADS; t++) {
    assert_int_equal(pthread_create(&thread[t], NULL, run, &who[t]), 0);
  }
  for (int t = 0; t < THREADS; t++) {
    assert_int_equal(pthread_join(thread[t], NULL), 0);
    assert_false(who[t].failed);
    for (int n = 0; n < POSES; n++) {
      answer alone = ask(&who[t], &who[t].pose[n], &who[t].failed);
      assert_int_equal(who[t].found[n].pairs, alone.pairs);
      assert_int_equal(who[t].found[n].any, alone.any);
      assert_true(who[t].found[n].distance == alone.distance);
      hits += alone.pairs;
    }
  }
  assert_true(hits > 100);
  sepax_body_free(a);
  sepax_body_free(b);
}

/* ------------------------------------------------------------------------ a machine */

enum { VALUES = 20 };

typedef struct {
  const sepax_machine *machine;
  double value[VALUES];
  sepax_machine_answer found[VALUES];
  bool failed;
} guard;

static void *watch_over(void *context) {
  guard *who = context;
  sepax_error error = {0};
  sepax_watch *watch;
  const sepax_machine_query query = {.size = sizeof query, .clearance = 2, .measure = true};
  who->failed = !sepax_watch_new(&watch, who->machine, &error);
  for (int n = 0; n < VALUES && !who->failed; n++) {
    who->failed = !sepax_watch_ask(watch, &who->value[n], &query, &who->found[n], &error);
  }
  sepax_watch_free(watch);
  return NULL;
}

CASE(threads_share_machines) {
  sepax_link link[2] = {{.joint = 0}};
  sepax_joint joint = {.name = path,
                       .kind = SEPAX_JOINT_PRISMATIC,
                       .child = 1,
                       .origin = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {0, 0, 0}},
                       .axis = {1, 0, 0},
                       .mimic = SEPAX_NO_JOINT};
  sepax_mechanism m = {.link = link, .links = 2, .joint = &joint, .joints = 1};
  assert_works(sepax_mechanism_join(&m, &fault));
  sepax_body *a = sample_body("sphere", 2000);
  sepax_body *b = sample_body("box", 500);
  const sepax_machine_body body[2] = {{0, a}, {1, b}};
  const size_t pair[1][2] = {{0, 1}};
  const sepax_machine_parts parts = {sizeof parts, &m, body, 2, pair, 1};
  sepax_machine *machine;
  assert_works(sepax_machine_new(&machine, &parts, &fault));
  static guard who[THREADS + 1]; /* the last one is this thread */
  pthread_t thread[THREADS];
  for (int t = 0; t <= THREADS; t++) {
    who[t].machine = machine;
    for (int n = 0; n < VALUES; n++) {
      who[t].value[n] = t < THREADS ? 100 * random_unit() : who[n % THREADS].value[n];
    }
  }
  for (int t = 0; t < THREADS; t++) {
    assert_int_equal(pthread_create(&thread[t], NULL, watch_over, &who[t]), 0);
  }
  watch_over(&who[THREADS]);
  size_t near = 0;
  for (int t = 0; t < THREADS; t++) {
    assert_int_equal(pthread_join(thread[t], NULL), 0);
  }
  for (int n = 0; n < VALUES; n++) {
    const sepax_machine_answer *one = &who[THREADS].found[n];
    const sepax_machine_answer *other = &who[n % THREADS].found[n];
    assert_false(who[n % THREADS].failed || who[THREADS].failed);
    assert_int_equal(one->verdict, other->verdict);
    near += one->verdict == SEPAX_NEAR;
    assert_true(one->least <= other->most && other->least <= one->most);
  }
  assert_true(near > 2 && near < VALUES - 2);
  sepax_machine_free(machine);
  sepax_body_free(a);
  sepax_body_free(b);
  sepax_release(m.order);
}
