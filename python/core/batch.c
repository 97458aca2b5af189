/* SPDX-License-Identifier: MIT */
/* batch.c - two bodies in many poses: collisions, nearness, distances, containment. */
#include "core.h"

#include <string.h>

/* The verdicts, as in sepax/_verdicts.py. */
enum { FREE = 0, COLLIDES = 1, A_INSIDE = 2, B_INSIDE = 3, UNDECIDED = 4 };

/* What all questions have, and where their answers go. An output may be NULL. */
typedef struct {
  const sepax_body *body[2];
  const sepax_shell *shell[2]; /* NULL: only surfaces are compared */
  core_poses pose[2];
  double distance, limit, relative, absolute, seconds;
  uint64_t work;
  bool strict;
  unsigned char *verdict;
  double (*interval)[3], (*points)[6], *least; /* interval: least, nearest found, most */
  int64_t (*pair)[2];
} questions;

enum { POSES_A, POSES_B, VERDICT, INTERVAL, POINTS, LEAST, PAIR, ARRAYS };

/* The poses of question n of one chunk. */
typedef struct {
  sepax_pose memory[2];
  const sepax_pose *pose[2];
} places;

static bool places_of(const questions *q, size_t n, places *p, sepax_error *error) {
  return core_pose(&q->pose[0], n, &p->memory[0], &p->pose[0], error) &&
         core_pose(&q->pose[1], n, &p->memory[1], &p->pose[1], error);
}

/* The verdict on bodies whose surfaces are apart. */
static bool inside_of(const questions *q, const places *p, unsigned char *verdict,
                      sepax_error *error) {
  *verdict = FREE;
  if (q->shell[0] == NULL) {
    return true;
  }
  sepax_inside found[2];
  if (!sepax_bodies_within(q->shell[0], p->pose[0], q->shell[1], p->pose[1], found, error)) {
    return false;
  }
  if (found[0] == SEPAX_INSIDE || found[1] == SEPAX_INSIDE) {
    *verdict = found[0] == SEPAX_INSIDE ? A_INSIDE : B_INSIDE;
  } else if (found[0] != SEPAX_OUTSIDE || found[1] != SEPAX_OUTSIDE) {
    *verdict = UNDECIDED;
  }
  return true;
}

static bool collide(const core_batch *batch, size_t first, size_t end, size_t *at,
                    sepax_error *error) {
  const questions *q = batch->context;
  const sepax_query query = {.size = sizeof query, .only_any = true, .strict = q->strict};
  places p;
  for (size_t n = first; n < end; n++) {
    sepax_pairs found;
    *at = n;
    if (!places_of(q, n, &p, error) || !sepax_bodies_collide(q->body[0], p.pose[0], q->body[1],
                                                             p.pose[1], &query, &found, error)) {
      return false;
    }
    q->verdict[n] = COLLIDES;
    if (found.count == 0 && !inside_of(q, &p, &q->verdict[n], error)) {
      return false;
    }
  }
  return true;
}

static bool near(const core_batch *batch, size_t first, size_t end, size_t *at,
                 sepax_error *error) {
  const questions *q = batch->context;
  const sepax_apart_request request = {.size = sizeof request, .work = q->work};
  places p;
  for (size_t n = first; n < end; n++) {
    sepax_apart_result r;
    *at = n;
    if (!places_of(q, n, &p, error) ||
        !sepax_bodies_apart(q->body[0], p.pose[0], q->body[1], p.pose[1], q->distance, &request, &r,
                            error)) {
      return false;
    }
    q->verdict[n] = r.verdict == SEPAX_NEAR ? COLLIDES : UNDECIDED;
    if (r.verdict == SEPAX_APART && !inside_of(q, &p, &q->verdict[n], error)) {
      return false;
    }
    q->least[n] = r.least;
    for (int k = 0; k < 2; k++) {
      q->pair[n][k] = r.verdict == SEPAX_NEAR ? (int64_t)r.pair[k] : -1;
    }
  }
  return true;
}

static void write_distance(const questions *q, size_t n, const sepax_distance_result *r) {
  const bool found = r->min_distance < 1 / 0.0;
  q->interval[n][0] = r->least;
  q->interval[n][1] = r->min_distance;
  q->interval[n][2] = r->most;
  memcpy(q->points[n], r->nearest_points, sizeof q->points[n]);
  for (int k = 0; k < 2; k++) {
    q->pair[n][k] = found ? (int64_t)r->pair[k] : -1;
  }
  q->verdict[n] = r->ended ? UNDECIDED : FREE;
}

/* Each search of a chunk begins at the triangles that were nearest in the pose before. */
static bool distance(const core_batch *batch, size_t first, size_t end, size_t *at,
                     sepax_error *error) {
  const questions *q = batch->context;
  sepax_distance_request request = {.size = sizeof request,
                                    .limit = q->limit,
                                    .relative = q->relative,
                                    .absolute = q->absolute,
                                    .work = q->work,
                                    .seconds = q->seconds};
  sepax_distance_result r[2];
  places p;
  for (size_t n = first; n < end; n++) {
    sepax_distance_result *now = &r[n % 2];
    *at = n;
    if (!places_of(q, n, &p, error) || !sepax_bodies_distance(q->body[0], p.pose[0], q->body[1],
                                                              p.pose[1], &request, now, error)) {
      return false;
    }
    write_distance(q, n, now);
    request.last = now;
  }
  return true;
}

/* Two verdicts for each question: is a part of A inside B, and of B inside A? */
static bool within(const core_batch *batch, size_t first, size_t end, size_t *at,
                   sepax_error *error) {
  const questions *q = batch->context;
  places p;
  for (size_t n = first; n < end; n++) {
    sepax_inside found[2];
    *at = n;
    if (!places_of(q, n, &p, error) ||
        !sepax_bodies_within(q->shell[0], p.pose[0], q->shell[1], p.pose[1], found, error)) {
      return false;
    }
    for (int k = 0; k < 2; k++) {
      q->verdict[2 * n + (size_t)k] = (unsigned char)found[k];
    }
  }
  return true;
}

/* -------------------------------------------------------------- from Python */

static bool poses_from(core_poses *poses, core_array *array, PyObject *object, size_t count) {
  if (!core_take(array, object, "poses", sizeof(double[16]), false)) {
    return false;
  }
  *poses = (core_poses){.matrix = array->view.buf, .count = array->count};
  if (array->held && array->count != count && array->count != 1) {
    PyErr_Format(PyExc_ValueError, "poses are %zu, not %zu", array->count, count);
    return false;
  }
  return true;
}

static bool write_to(core_array *array, PyObject *object, size_t row, size_t count, void **to) {
  bool ok = core_take_rows(array, object, "an output", row, count, true);
  *to = array->view.buf;
  if (ok && !array->held) {
    PyErr_SetString(PyExc_ValueError, "an output is None");
  }
  return ok && array->held;
}

static bool bodies_from(questions *q, PyObject *const handle[2], PyObject *const shell[2]) {
  bool ok = true;
  for (int k = 0; k < 2 && ok; k++) {
    q->body[k] = core_body_of(handle[k]);
    ok = q->body[k] != NULL && core_maybe_shell(&q->shell[k], shell[k]);
    if (ok && q->shell[k] != NULL && q->shell[k]->body != q->body[k]) {
      PyErr_SetString(PyExc_ValueError, "a shell of another body");
      ok = false;
    }
  }
  if (ok && (q->shell[0] == NULL) != (q->shell[1] == NULL)) {
    PyErr_SetString(PyExc_ValueError, "one body without a shell");
    ok = false;
  }
  return ok;
}

static PyObject *answer(core_batch *batch, bool ok, core_array array[ARRAYS]) {
  ok = ok && core_run(batch, "pose");
  core_release(array, ARRAYS);
  if (!ok) {
    return NULL;
  }
  Py_RETURN_NONE;
}

/* The arguments that all questions begin with: bodies, shells, poses, count, threads. */
typedef struct {
  PyObject *body[2], *shell[2], *pose[2];
  Py_ssize_t count;
  int threads;
} given;

#define GIVEN(g)                                                                        \
  &(g).body[0], &(g).body[1], &(g).shell[0], &(g).shell[1], &(g).pose[0], &(g).pose[1], \
      &(g).count, &(g).threads

static bool begin(core_batch *batch, questions *q, const given *g, core_array array[ARRAYS]) {
  if (g->count < 0 || g->threads < 0) {
    PyErr_SetString(PyExc_ValueError, "a negative number");
    return false;
  }
  batch->count = (size_t)g->count;
  batch->threads = (size_t)g->threads;
  batch->context = q;
  return bodies_from(q, g->body, g->shell) &&
         poses_from(&q->pose[0], &array[POSES_A], g->pose[0], batch->count) &&
         poses_from(&q->pose[1], &array[POSES_B], g->pose[1], batch->count);
}

static PyObject *py_collide(PyObject *self, PyObject *arguments) {
  (void)self;
  given g;
  PyObject *verdict;
  int strict;
  if (!PyArg_ParseTuple(arguments, "OOOOOOniOp", GIVEN(g), &verdict, &strict)) {
    return NULL;
  }
  questions q = {.strict = strict != 0};
  core_array array[ARRAYS] = {{.held = false}};
  core_batch batch = {.chunk = 64, .answer = collide};
  bool ok = begin(&batch, &q, &g, array) &&
            write_to(&array[VERDICT], verdict, 1, batch.count, (void **)&q.verdict);
  return answer(&batch, ok, array);
}

static PyObject *py_near(PyObject *self, PyObject *arguments) {
  (void)self;
  given g;
  PyObject *out[3];
  questions q = {.strict = false};
  unsigned long long work;
  if (!PyArg_ParseTuple(arguments, "OOOOOOniOOOdK", GIVEN(g), &out[0], &out[1], &out[2],
                        &q.distance, &work)) {
    return NULL;
  }
  q.work = work;
  core_array array[ARRAYS] = {{.held = false}};
  core_batch batch = {.chunk = 64, .answer = near};
  bool ok = begin(&batch, &q, &g, array) &&
            write_to(&array[VERDICT], out[0], 1, batch.count, (void **)&q.verdict) &&
            write_to(&array[LEAST], out[1], sizeof(double), batch.count, (void **)&q.least) &&
            write_to(&array[PAIR], out[2], sizeof *q.pair, batch.count, (void **)&q.pair);
  return answer(&batch, ok, array);
}

static PyObject *py_distance(PyObject *self, PyObject *arguments) {
  (void)self;
  given g;
  PyObject *out[4];
  questions q = {.strict = false};
  unsigned long long work;
  if (!PyArg_ParseTuple(arguments, "OOOOOOniOOOOdddKd", GIVEN(g), &out[0], &out[1], &out[2],
                        &out[3], &q.limit, &q.relative, &q.absolute, &work, &q.seconds)) {
    return NULL;
  }
  q.work = work;
  core_array array[ARRAYS] = {{.held = false}};
  core_batch batch = {.chunk = 16, .answer = distance};
  bool ok =
      begin(&batch, &q, &g, array) &&
      write_to(&array[VERDICT], out[0], 1, batch.count, (void **)&q.verdict) &&
      write_to(&array[INTERVAL], out[1], sizeof *q.interval, batch.count, (void **)&q.interval) &&
      write_to(&array[POINTS], out[2], sizeof *q.points, batch.count, (void **)&q.points) &&
      write_to(&array[PAIR], out[3], sizeof *q.pair, batch.count, (void **)&q.pair);
  return answer(&batch, ok, array);
}

static PyObject *py_within(PyObject *self, PyObject *arguments) {
  (void)self;
  given g;
  PyObject *verdict;
  if (!PyArg_ParseTuple(arguments, "OOOOOOniO", GIVEN(g), &verdict)) {
    return NULL;
  }
  questions q = {.strict = false};
  core_array array[ARRAYS] = {{.held = false}};
  core_batch batch = {.chunk = 64, .answer = within};
  bool ok = begin(&batch, &q, &g, array) &&
            write_to(&array[VERDICT], verdict, 2, batch.count, (void **)&q.verdict);
  if (ok && q.shell[0] == NULL) {
    PyErr_SetString(PyExc_ValueError, "no shells");
    ok = false;
  }
  return answer(&batch, ok, array);
}

PyMethodDef core_batch_methods[] = {
    {"collide", py_collide, METH_VARARGS,
     "(body, body, shell, shell, poses, poses, count, threads, verdicts, strict)"},
    {"near", py_near, METH_VARARGS, "(... threads, verdicts, least, pairs, distance, work)"},
    {"distance", py_distance, METH_VARARGS,
     "(... threads, verdicts, intervals, points, pairs, limit, relative, absolute, work, "
     "seconds)"},
    {"within", py_within, METH_VARARGS, "(... threads, verdicts of two)"},
    {NULL, NULL, 0, NULL}};
