/* SPDX-License-Identifier: MIT */
/* grid.c - triangles of integers, as the hardware has them (sepax_grid.h). */
#include "core.h"
#include "sepax_grid.h"

#include <stdlib.h>
#include <string.h>

static PyObject *fit(PyObject *self, PyObject *arguments) {
  (void)self;
  PyObject *part[2][2] = {{NULL, NULL}, {NULL, NULL}};
  int word;
  if (!PyArg_ParseTuple(arguments, "iOO|OO", &word, &part[0][0], &part[0][1], &part[1][0],
                        &part[1][1])) {
    return NULL;
  }
  const size_t count = part[1][0] != NULL && part[1][1] != NULL ? 2 : 1;
  core_array array[4] = {{.held = false}};
  sepax_mesh mesh[2];
  const sepax_mesh *meshes[2] = {&mesh[0], &mesh[1]};
  sepax_grid g;
  sepax_error error = {0};
  bool ok = true;
  for (size_t k = 0; k < count && ok; k++) {
    ok = core_mesh(&mesh[k], &array[2 * k], part[k][0], part[k][1]);
  }
  if (ok && !sepax_grid_fit(&g, meshes, count, word, &error)) {
    core_failed(&error);
    ok = false;
  }
  core_release(array, 4);
  return ok ? Py_BuildValue("(d(ddd)i)", g.resolution, g.offset[0], g.offset[1], g.offset[2],
                            g.word)
            : NULL;
}

static PyObject *quantise(PyObject *self, PyObject *arguments) {
  (void)self;
  PyObject *vertices;
  PyObject *faces;
  PyObject *out;
  sepax_grid g;
  if (!PyArg_ParseTuple(arguments, "OOd(ddd)iO", &vertices, &faces, &g.resolution, &g.offset[0],
                        &g.offset[1], &g.offset[2], &g.word, &out)) {
    return NULL;
  }
  core_array array[3] = {{.held = false}};
  sepax_mesh mesh;
  sepax_error error = {0};
  bool ok = core_mesh(&mesh, array, vertices, faces) &&
            core_take_rows(&array[2], out, "the output", sizeof(sepax_tri), mesh.triangles, true);
  if (ok && array[2].held) {
    Py_BEGIN_ALLOW_THREADS;
    ok = sepax_quantise(&mesh, &g, array[2].view.buf, &error);
    Py_END_ALLOW_THREADS;
    if (!ok) {
      core_failed(&error);
    }
  }
  core_release(array, 3);
  if (!ok) {
    return NULL;
  }
  Py_RETURN_NONE;
}

typedef struct {
  const sepax_tri *a, *b;
  unsigned char (*verdict)[4];
} integers;

static bool judge(const core_batch *batch, size_t first, size_t end, size_t *at,
                  sepax_error *error) {
  const integers *i = batch->context;
  (void)error;
  for (size_t n = first; n < end; n++) {
    *at = n;
    const sepax_verdict v = sepax_exact(&i->a[n], &i->b[n]);
    const unsigned char all[4] = {v.collision, v.strict, v.coplanar, (unsigned char)v.axis};
    memcpy(i->verdict[n], all, sizeof all);
  }
  return true;
}

static PyObject *exact(PyObject *self, PyObject *arguments) {
  (void)self;
  PyObject *part[3];
  int threads;
  if (!PyArg_ParseTuple(arguments, "OOiO", &part[0], &part[1], &threads, &part[2])) {
    return NULL;
  }
  core_array array[3] = {{.held = false}};
  bool ok = core_take(&array[0], part[0], "a", sizeof(sepax_tri), false) &&
            core_take_rows(&array[1], part[1], "b", sizeof(sepax_tri), array[0].count, false) &&
            core_take_rows(&array[2], part[2], "verdicts", 4, array[0].count, true);
  if (ok && (!array[0].held || !array[1].held || !array[2].held)) {
    PyErr_SetString(PyExc_ValueError, "an array is None");
    ok = false;
  }
  integers i = {array[0].view.buf, array[1].view.buf, array[2].view.buf};
  const core_batch batch = {.count = array[0].count,
                            .chunk = 4096,
                            .threads = threads > 0 ? (size_t)threads : 0,
                            .answer = judge,
                            .context = &i};
  ok = ok && core_run(&batch, "pair");
  core_release(array, 3);
  if (!ok) {
    return NULL;
  }
  Py_RETURN_NONE;
}

/* A structure of arrays: 9 rows of `count` numbers, vertex by vertex. */
static void columns_of(sepax_columns *c, const int32_t *first, size_t count) {
  for (size_t k = 0; k < 9; k++) {
    c->c[k / 3][k % 3] = first + k * count;
  }
}

static PyObject *exact_bits(PyObject *self, PyObject *arguments) {
  (void)self;
  PyObject *part[3];
  Py_ssize_t count;
  if (!PyArg_ParseTuple(arguments, "OOnO", &part[0], &part[1], &count, &part[2])) {
    return NULL;
  }
  core_array array[3] = {{.held = false}};
  const size_t n = count > 0 ? (size_t)count : 0;
  const size_t row = sizeof(int32_t[9]);
  bool ok = core_take_rows(&array[0], part[0], "a", row, n, false) &&
            core_take_rows(&array[1], part[1], "b", row, n, false) &&
            core_take_rows(&array[2], part[2], "bits", sizeof(uint64_t), (n + 63) / 64, true);
  if (ok && n > 0 && array[0].held && array[1].held && array[2].held) {
    sepax_columns a;
    sepax_columns b;
    columns_of(&a, array[0].view.buf, n);
    columns_of(&b, array[1].view.buf, n);
    Py_BEGIN_ALLOW_THREADS;
    sepax_exact_pairs(SEPAX_SIMD_BEST, &a, &b, n, array[2].view.buf);
    Py_END_ALLOW_THREADS;
  }
  core_release(array, 3);
  if (!ok) {
    return NULL;
  }
  Py_RETURN_NONE;
}

static PyObject *colliding(PyObject *self, PyObject *arguments) {
  (void)self;
  PyObject *part[2];
  sepax_search how = {.size = sizeof how};
  if (!PyArg_ParseTuple(arguments, "OOi", &part[0], &part[1], &how.threads)) {
    return NULL;
  }
  core_array array[2] = {{.held = false}};
  sepax_pairs found = {0};
  sepax_error error = {0};
  bool ok = core_take(&array[0], part[0], "a", sizeof(sepax_tri), false) &&
            core_take(&array[1], part[1], "b", sizeof(sepax_tri), false);
  if (ok) {
    Py_BEGIN_ALLOW_THREADS;
    ok = sepax_colliding_pairs(array[0].view.buf, array[0].count, array[1].view.buf, array[1].count,
                               &how, &found, &error);
    Py_END_ALLOW_THREADS;
    if (!ok) {
      core_failed(&error);
    }
  }
  core_release(array, 2);
  PyObject *bytes = ok ? core_bytes(found.pair, found.count, sizeof *found.pair) : NULL;
  sepax_pairs_free(&found);
  return bytes;
}

PyMethodDef core_grid_methods[] = {
    {"grid_fit", fit, METH_VARARGS, "(word, vertices, faces[, vertices, faces]) -> grid"},
    {"grid_quantise", quantise, METH_VARARGS, "(vertices, faces, resolution, offset, word, out)"},
    {"grid_exact", exact, METH_VARARGS, "(a, b, threads, verdicts)"},
    {"grid_exact_bits", exact_bits, METH_VARARGS, "(columns of a, of b, count, bits)"},
    {"grid_colliding", colliding, METH_VARARGS, "(a, b, threads) -> pairs"},
    {NULL, NULL, 0, NULL}};
