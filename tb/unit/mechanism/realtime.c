/* SPDX-License-Identifier: MIT */
/* realtime.c - what the functions for control loops do not do: they take no memory, lock nothing,
 * read no clock, meet no new page, and need the stack that docs/reference/library.md names.
 * SEPAX_COUNT: so many rounds. */
#define _GNU_SOURCE // NOLINT(bugprone-reserved-identifier)

#include "unit/body/draws.h"
#include "unit/mechanism/places.h"

#include <pthread.h>
#include <sched.h>
#include <stdatomic.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <time.h>
#include <unistd.h>

/* As in docs/reference/library.md. */
enum { STACK_NAMED = 256 * 1024 };

enum { JOINTS = 6, BODIES = 7, PAIRS = 15 };

/* ----------------------------------------------------- functions of the C library, counted */

static atomic_long allocations;
static atomic_long clocks;
static atomic_long locks;

/* The allocator behind this one. */
#ifdef __SANITIZE_ADDRESS__
#define BEHIND(name) __asm__("__interceptor_" name)
#else
#define BEHIND(name) __asm__("__libc_" name)
#endif
void *next_malloc(size_t size) BEHIND("malloc");
void *next_calloc(size_t count, size_t size) BEHIND("calloc");
void *next_realloc(void *old, size_t size) BEHIND("realloc");
#define EARLY __attribute__((no_sanitize("address", "undefined")))

#ifndef __clang_analyzer__ /* it would take each result for NULL */
EARLY void *malloc(size_t size) {
  allocations++;
  return next_malloc(size);
}

EARLY void *calloc(size_t count, size_t size) {
  allocations++;
  return next_calloc(count, size);
}

EARLY void *realloc(void *old, size_t size) {
  allocations++;
  return next_realloc(old, size);
}
#endif

int clock_gettime(clockid_t clock, struct timespec *now) {
  clocks++;
  return (int)syscall(SYS_clock_gettime, clock, now);
}

int pthread_mutex_lock(pthread_mutex_t *mutex) {
  locks++;
  while (pthread_mutex_trylock(mutex) != 0) {
    sched_yield();
  }
  return 0;
}

/* ------------------------------------------------------------------------------ a machine */

typedef struct {
  sepax_mechanism m;
  sepax_machine_body body[BODIES];
  size_t pair[PAIRS][2];
  sepax_machine *machine;
  sepax_chain chain;
  sepax_facet facet[BODIES]; /* a triangle of each body */
  sepax_shell shell[BODIES];
} rig;

/* Plates of equal triangles: all of them tie if two plates are parallel. */
static sepax_soup plate(size_t side) {
  sepax_soup mesh = {.facet = calloc(2 * side * side, sizeof(sepax_facet)),
                     .count = 2 * side * side};
  assert_non_null(mesh.facet);
  for (size_t n = 0; n < mesh.count; n++) {
    size_t cell = n / 2;
    size_t row = cell / side;
    double x = (double)(cell % side);
    double y = (double)row;
    double shift[3][2] = {{0, 0}, {1, (double)(n % 2)}, {1 - (double)(n % 2), 1}};
    for (int k = 0; k < 3; k++) {
      mesh.facet[n].v[k][0] = (x + shift[k][0]) / (double)side - 0.5;
      mesh.facet[n].v[k][1] = (y + shift[k][1]) / (double)side - 0.5;
    }
  }
  return mesh;
}

/* Many triangles in one place make a tree as deep as there can be. */
static sepax_soup heap_of_copies(size_t count) {
  sepax_soup mesh = strewn(count, 0.2, 0);
  for (size_t n = 1; n < count; n++) {
    mesh.facet[n] = mesh.facet[0];
    mesh.facet[n].v[0][0] = mesh.facet[0].v[0][0] * (1 + ldexp(1, -(int)(n % 52)));
  }
  return mesh;
}

static sepax_soup mesh_of(size_t body) {
  return body % 3 == 0 ? plate(12) : body % 3 == 1 ? strewn(300, 0.1, 0) : heap_of_copies(300);
}

static void make_rig(rig *r) {
  *r = (rig){.m = row_of(JOINTS)};
  for (size_t n = 0; n < JOINTS; n++) {
    r->m.joint[n].kind = n % 2 == 0 ? SEPAX_JOINT_PRISMATIC : SEPAX_JOINT_REVOLUTE;
  }
  assert_works(sepax_mechanism_join(&r->m, &fault));
  size_t pairs = 0;
  for (size_t n = 0; n < BODIES; n++) {
    sepax_soup mesh = mesh_of(n);
    sepax_body *body;
    assert_works(sepax_body_new(&body, SEPAX_SOUP_MESH(&mesh), NULL, &fault));
    assert_works(sepax_shell_find(&r->shell[n], body, &fault));
    r->facet[n] = mesh.facet[mesh.count / 2];
    free(mesh.facet);
    r->body[n] = (sepax_machine_body){n, body};
    for (size_t k = 0; k < n && pairs < PAIRS; k++, pairs++) {
      r->pair[pairs][0] = k;
      r->pair[pairs][1] = n;
    }
  }
  const sepax_machine_parts parts = {
      sizeof parts, &r->m, r->body, BODIES, (const size_t(*)[2])r->pair, PAIRS};
  assert_works(sepax_machine_new(&r->machine, &parts, &fault));
  assert_works(sepax_chain_find(&r->chain, &r->m, 0, BODIES - 1, &fault));
}

static void free_rig(rig *r) {
  for (size_t n = 0; n < BODIES; n++) {
    sepax_shell_free(&r->shell[n]);
    sepax_body_free((sepax_body *)r->body[n].body);
  }
  sepax_chain_free(&r->chain);
  sepax_machine_free(r->machine);
  sepax_mechanism_free(&r->m);
}

/* --------------------------------------------------------- the functions for control loops */

static bool count_pair(void *context, size_t a, size_t b) {
  (void)a;
  (void)b;
  return ++*(size_t *)context < 100;
}

typedef struct {
  const rig *r;
  sepax_watch *watch;
  unsigned seed;
  int rounds;
  bool ok;
  size_t deepest; /* bytes of stack */
  long faults;
} task;

static double drawn_unit(unsigned *state) {
  *state = *state * 1664525U + 1013904223U;
  return (double)(*state >> 8) * 0x1p-23 - 1;
}

/* Round numbers put plates into parallel planes, at exactly the clearance. */
static void draw_values(unsigned *state, double *value, double *travel) {
  bool whole = drawn_unit(state) > 0;
  for (size_t n = 0; n < JOINTS; n++) {
    value[n] = whole ? (n % 2 == 0 ? round(4 * drawn_unit(state)) / 4 : 0) : drawn_unit(state);
    travel[n] = 0.01 * fabs(drawn_unit(state));
  }
}

static bool ask_bodies(const rig *r, const size_t pair[2], const double *value, uint64_t work) {
  sepax_pose pose[BODIES];
  sepax_pose of_chain[2];
  sepax_apart_result apart;
  sepax_distance_result last;
  sepax_pairs pairs;
  size_t seen = 0;
  double followed[JOINTS];
  memcpy(followed, value, sizeof followed);
  sepax_mechanism_follow(&r->m, followed);
  sepax_mechanism_poses(&r->m, followed, pose);
  sepax_chain_poses(&r->chain, &r->m, followed, of_chain);
  const double box[2][3] = {{-1, -1, -1}, {1, 1, 1}};
  double travel = sepax_chain_travel(&r->chain, &r->m, value, value, followed, box);
  const sepax_body *a = r->body[pair[0]].body;
  const sepax_body *b = r->body[pair[1]].body;
  const sepax_pose *p = &pose[pair[0]];
  const sepax_pose *q = &pose[pair[1]];
  sepax_front *front;
  char memory[4096];
  const bool begun = sepax_front_begin(&front, memory, sizeof memory, &fault);
  const sepax_apart_request request = {.size = sizeof request, .work = work};
  const sepax_apart_request kept = {.size = sizeof kept, .work = work, .front = front};
  sepax_distance_request measure = {.size = sizeof measure, .relative = 1e-6, .work = work};
  const sepax_query any = {.size = sizeof any, .only_any = true};
  sepax_inside within[2];
  double nearest[2][3];
  const sepax_facet *const facet[2] = {&r->facet[pair[0]], &r->facet[pair[1]]};
  sepax_exact_posed(facet[0]->v, p, facet[1]->v, q);
  sepax_distance_posed(facet[0]->v, p, facet[1]->v, q, nearest);
  const sepax_query each = {.size = sizeof each, .each = count_pair, .context = &seen};
  return travel >= 0 && begun && sepax_bodies_apart(a, p, b, q, 0.25, &request, &apart, &fault) &&
         sepax_bodies_apart(a, p, b, q, 0, &request, &apart, &fault) &&
         sepax_bodies_apart(a, p, b, q, 0.25, &kept, &apart, &fault) &&
         sepax_bodies_apart(a, p, b, q, 0, &kept, &apart, &fault) &&
         sepax_bodies_distance(a, p, b, q, &measure, &last, &fault) &&
         sepax_bodies_distance(a, p, b, q, (measure.last = &last, &measure), &last, &fault) &&
         sepax_bodies_collide(a, p, b, q, &any, &pairs, &fault) &&
         sepax_bodies_collide(a, p, b, q, &each, &pairs, &fault) &&
         sepax_bodies_near(a, p, b, q, 0.25, &any, &pairs, &fault) &&
         sepax_bodies_near(a, p, b, q, 0.25, &each, &pairs, &fault) &&
         sepax_bodies_within(&r->shell[pair[0]], p, &r->shell[pair[1]], q, within, &fault);
}

static bool ask_machine(const task *t, const double *value, const double *travel, uint64_t work) {
  sepax_machine_answer answer;
  for (int kind = 0; kind < 8; kind++) {
    const sepax_machine_query query = {.size = sizeof query,
                                       .clearance = (kind & 1) != 0 ? 0.25 : 0,
                                       .travel = (kind & 2) != 0 ? travel : NULL,
                                       .measure = (kind & 4) != 0,
                                       .relative = 1e-6,
                                       .work = work};
    if (!sepax_watch_ask(t->watch, value, &query, &answer, &fault)) {
      return false;
    }
  }
  return true;
}

static void work_on(task *t) {
  unsigned state = t->seed;
  t->ok = true;
  for (int n = 0; n < t->rounds && t->ok; n++) {
    double value[JOINTS];
    double travel[JOINTS];
    uint64_t work = n % 3 == 0 ? 0 : n % 3 == 1 ? 300 : 5000;
    draw_values(&state, value, travel);
    t->ok =
        ask_machine(t, value, travel, work) && ask_bodies(t->r, t->r->pair[n % PAIRS], value, work);
  }
}

static int rounds(void) {
  const char *count = getenv("SEPAX_COUNT");
  return count != NULL ? atoi(count) : FEWER(300);
}

/* No allocation, not even behind the library's own allocator; no lock, no clock. */
CASE(no_memory_lock_or_clock) {
  rig r;
  make_rig(&r);
  task t = {.r = &r, .seed = 1, .rounds = rounds()};
  assert_works(sepax_watch_new(&t.watch, r.machine, &fault));
  allocations = clocks = locks = 0;
  work_on(&t);
  long taken = allocations;
  long read = clocks;
  long locked = locks;
  assert_works(t.ok);
  assert_int_equal(taken, 0);
  assert_int_equal(read, 0);
  assert_int_equal(locked, 0);
  sepax_watch_free(t.watch);
  free_rig(&r);
}

/* --------------------------------------------------------------------------------- stack */

enum { STACK = 1 << 20, PAINT = 0xA5 };

static void *measured_thread(void *context) {
  task *t = context;
  struct rusage first;
  struct rusage last;
  getrusage(RUSAGE_THREAD, &first);
  work_on(t);
  getrusage(RUSAGE_THREAD, &last);
  t->faults = last.ru_minflt - first.ru_minflt + last.ru_majflt - first.ru_majflt;
  t->deepest = (size_t)(uintptr_t)&last; /* where the work began */
  return NULL;
}

/* Run a task on a painted stack. */
static void run_on_stack(task *t) {
  unsigned char *stack =
      mmap(NULL, STACK, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  pthread_attr_t attributes;
  pthread_t thread;
  assert_true(stack != MAP_FAILED);
  memset(stack, PAINT, STACK); /* brings the pages in, too */
  assert_int_equal(pthread_attr_init(&attributes), 0);
  assert_int_equal(pthread_attr_setstack(&attributes, stack, STACK), 0);
  assert_int_equal(pthread_create(&thread, &attributes, measured_thread, t), 0);
  pthread_join(thread, NULL);
  pthread_attr_destroy(&attributes);
  size_t untouched = 0;
  while (untouched < STACK && stack[untouched] == PAINT) {
    untouched++;
  }
  t->deepest = t->deepest - ((size_t)(uintptr_t)stack + untouched);
  munmap(stack, STACK);
}

/* An allocator whose memory is always of new pages. */
enum { PAGE = 4096 };

static void *new_pages(void *context, size_t bytes) {
  size_t whole = (bytes + 2 * PAGE - 1) / PAGE * PAGE;
  char *pages = mmap(NULL, whole, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  (void)context;
  if (pages == MAP_FAILED) {
    return NULL;
  }
  memcpy(pages, &whole, sizeof whole);
  return pages + PAGE;
}

static void release_pages(void *context, void *old) {
  char *pages = (char *)old - PAGE;
  size_t whole = 0;
  (void)context;
  memcpy(&whole, pages, sizeof whole);
  munmap(pages, whole);
}

static void *resize_pages(void *context, void *old, size_t bytes) {
  void *grown = new_pages(context, bytes);
  if (old != NULL && grown != NULL) {
    size_t whole = 0;
    memcpy(&whole, (char *)old - PAGE, sizeof whole);
    memcpy(grown, old, bytes < whole - PAGE ? bytes : whole - PAGE);
    release_pages(context, old);
  }
  return grown;
}

CASE(stack_and_pages) {
  static const sepax_allocator pages = {new_pages, resize_pages, release_pages, NULL};
  rig r;
  make_rig(&r);
  task t = {.r = &r, .seed = 2, .rounds = rounds()};
  assert_works(sepax_watch_new(&t.watch, r.machine, &fault));
  run_on_stack(&t); /* the program's own pages are in from now on */
  assert_works(t.ok);
  sepax_watch_free(t.watch);
  sepax_set_allocator(&pages); /* for the watch alone */
  assert_works(sepax_watch_new(&t.watch, r.machine, &fault));
  run_on_stack(&t);
  assert_works(t.ok);
  sepax_watch_free(t.watch);
  sepax_set_allocator(NULL);
  free_rig(&r);
  printf("%zu bytes of stack, %ld page faults\n", t.deepest, t.faults);
#ifndef __SANITIZE_ADDRESS__ /* which enlarges frames */
  assert_true(t.deepest > 1000 && t.deepest <= STACK_NAMED);
  assert_int_equal(t.faults, 0);
#endif
}
