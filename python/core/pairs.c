/* SPDX-License-Identifier: MIT */
/* pairs.c - which triangles: of two bodies, of two meshes, and of single triangles of doubles. */
#include "core.h"

#include <string.h>

/* One pose for one question; `error` becomes an exception. */
static bool pose_from(PyObject *object, sepax_pose *memory, const sepax_pose **pose) {
  core_array array;
  sepax_error error = {0};
  bool ok = core_take(&array, object, "a pose", sizeof(double[16]), false);
  if (ok && array.held && array.count != 1) {
    PyErr_Format(PyExc_ValueError, "%zu poses in place of one", array.count);
    ok = false;
  }
  const core_poses poses = {.matrix = array.view.buf, .count = 1};
  if (ok && !core_pose(&poses, 0, memory, pose, &error)) {
    core_failed(&error);
    ok = false;
  }
  core_release(&array, 1);
  return ok;
}

/* (bytearray of pairs of size_t, whether a limit ended the search) */
static PyObject *pairs_found(sepax_pairs *found) {
  PyObject *bytes = core_bytes(found->pair, found->count, sizeof *found->pair);
  const bool ended = found->ended;
  sepax_pairs_free(found);
  return bytes != NULL ? Py_BuildValue("(NN)", bytes, PyBool_FromLong(ended)) : NULL;
}

static PyObject *bodies_pairs(PyObject *self, PyObject *arguments) {
  (void)self;
  PyObject *body[2];
  PyObject *at[2];
  double distance;
  Py_ssize_t most;
  int strict;
  sepax_query query = {.size = sizeof query};
  if (!PyArg_ParseTuple(arguments, "OOOOdnpd", &body[0], &body[1], &at[0], &at[1], &distance, &most,
                        &strict, &query.seconds)) {
    return NULL;
  }
  const sepax_body *a = core_body_of(body[0]);
  const sepax_body *b = a != NULL ? core_body_of(body[1]) : NULL;
  sepax_pose memory[2];
  const sepax_pose *pose[2];
  if (b == NULL || !pose_from(at[0], &memory[0], &pose[0]) ||
      !pose_from(at[1], &memory[1], &pose[1])) {
    return NULL;
  }
  query.most = most > 0 ? (size_t)most : 0;
  query.strict = strict != 0;
  sepax_pairs found;
  sepax_error error = {0};
  bool ok;
  Py_BEGIN_ALLOW_THREADS;
  ok = sepax_bodies_near(a, pose[0], b, pose[1], distance, &query, &found, &error);
  Py_END_ALLOW_THREADS;
  return ok ? pairs_found(&found) : core_failed(&error);
}

static PyObject *meshes_pairs(PyObject *self, PyObject *arguments) {
  (void)self;
  PyObject *part[6];
  int first;
  sepax_search how = {.size = sizeof how};
  if (!PyArg_ParseTuple(arguments, "OOOOOOpi", &part[0], &part[1], &part[2], &part[3], &part[4],
                        &part[5], &first, &how.threads)) {
    return NULL;
  }
  how.first = first != 0;
  core_array array[4] = {{.held = false}};
  sepax_mesh mesh[2];
  sepax_pose memory[2];
  const sepax_pose *pose[2];
  sepax_pairs found;
  sepax_error error = {0};
  bool ok = true;
  for (int k = 0; k < 2 && ok; k++) {
    ok = core_mesh(&mesh[k], &array[2 * k], part[3 * k], part[3 * k + 1]) &&
         pose_from(part[3 * k + 2], &memory[k], &pose[k]);
  }
  if (ok) {
    Py_BEGIN_ALLOW_THREADS;
    ok = sepax_meshes_collide(&mesh[0], pose[0], &mesh[1], pose[1], &how, &found, &error);
    Py_END_ALLOW_THREADS;
    if (!ok) {
      core_failed(&error);
    }
  }
  core_release(array, 4);
  return ok ? pairs_found(&found) : NULL;
}

/* ---------------------------------------------------------- single triangles */

typedef const double (*triangle)[3];

typedef struct {
  const double (*a)[3][3], (*b)[3][3];
  core_poses pose[2];
  unsigned char (*verdict)[4]; /* collision, strict, coplanar, axis; or NULL: distances */
  double *distance, (*nearest)[2][3];
} triangles;

static bool judge(const core_batch *batch, size_t first, size_t end, size_t *at,
                  sepax_error *error) {
  const triangles *t = batch->context;
  sepax_pose memory[2];
  const sepax_pose *pose[2];
  for (size_t n = first; n < end; n++) {
    *at = n;
    if (!core_pose(&t->pose[0], n, &memory[0], &pose[0], error) ||
        !core_pose(&t->pose[1], n, &memory[1], &pose[1], error)) {
      return false;
    }
    if (t->verdict != NULL) {
      const sepax_verdict v = sepax_exact_posed(t->a[n], pose[0], t->b[n], pose[1]);
      const unsigned char all[4] = {v.collision, v.strict, v.coplanar, (unsigned char)v.axis};
      memcpy(t->verdict[n], all, sizeof all);
    } else {
      t->distance[n] = sepax_distance_posed(t->a[n], pose[0], t->b[n], pose[1], t->nearest[n]);
    }
  }
  return true;
}

static PyObject *triangle_pairs(PyObject *self, PyObject *arguments) {
  (void)self;
  PyObject *part[7];
  int threads;
  if (!PyArg_ParseTuple(arguments, "OOOOiOOO", &part[0], &part[1], &part[2], &part[3], &threads,
                        &part[4], &part[5], &part[6])) {
    return NULL;
  }
  const size_t row = sizeof(double[3][3]);
  const size_t size[7] = {
      row, row, sizeof(double[16]), sizeof(double[16]), 4, sizeof(double), sizeof(double[2][3])};
  core_array array[7] = {{.held = false}};
  bool ok = core_take(&array[0], part[0], "triangles", size[0], false);
  const size_t count = array[0].count;
  for (int k = 1; k < 7 && ok; k++) {
    ok = core_take(&array[k], part[k], "an array", size[k], k >= 4);
    const bool poses = k == 2 || k == 3;
    if (ok && array[k].held && array[k].count != count && !(poses && array[k].count == 1)) {
      PyErr_SetString(PyExc_ValueError, "arrays of different lengths");
      ok = false;
    }
  }
  if (ok &&
      (!array[0].held || !array[1].held || (!array[4].held && !(array[5].held && array[6].held)))) {
    PyErr_SetString(PyExc_ValueError, "an array is None");
    ok = false;
  }
  triangles t = {.a = array[0].view.buf, .b = array[1].view.buf};
  t.pose[0] = (core_poses){.matrix = array[2].view.buf, .count = array[2].count};
  t.pose[1] = (core_poses){.matrix = array[3].view.buf, .count = array[3].count};
  t.verdict = array[4].view.buf;
  t.distance = array[5].view.buf;
  t.nearest = array[6].view.buf;
  const core_batch batch = {.count = count,
                            .chunk = 256,
                            .threads = threads > 0 ? (size_t)threads : 0,
                            .answer = judge,
                            .context = &t};
  ok = ok && core_run(&batch, "pair");
  core_release(array, 7);
  if (!ok) {
    return NULL;
  }
  Py_RETURN_NONE;
}

PyMethodDef core_pair_methods[] = {
    {"bodies_pairs", bodies_pairs, METH_VARARGS,
     "(body, body, pose, pose, distance, most, strict, seconds) -> pairs, ended"},
    {"meshes_pairs", meshes_pairs, METH_VARARGS,
     "(vertices, faces, pose, vertices, faces, pose, first, threads) -> pairs, ended"},
    {"triangle_pairs", triangle_pairs, METH_VARARGS,
     "(a, b, poses, poses, threads, verdicts | None, distances | None, points | None)"},
    {NULL, NULL, 0, NULL}};
