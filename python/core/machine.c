/* SPDX-License-Identifier: MIT */
/* machine.c - bodies on links: is any pair near, for many rows of joint values? */
#include "mechanism.h"
#include "util/error.h"

#include <stdlib.h>
#include <string.h>

#define CORE_MACHINE "sepax.machine"

/* The verdicts, as in sepax/_verdicts.py. */
enum { FREE = 0, NEAR = 1, A_INSIDE = 2, B_INSIDE = 3, UNDECIDED = 4 };

typedef struct {
  sepax_machine *machine;
  const sepax_mechanism *mechanism;
  size_t pairs;
  size_t (*pair)[2];
  sepax_chain *chain;        /* of each pair */
  const sepax_shell **shell; /* of all solids, body by body; NULL where insides are not asked for */
  size_t *first;             /* solids of body n: first[n] ... first[n + 1] - 1 */
  PyObject *mechanism_handle; /* they keep what the machine needs */
  PyObject *bodies;           /* tuples (link, body, shells of its solids, or None) */
} core_machine;

static void release(core_machine *m) {
  sepax_machine_free(m->machine);
  for (size_t n = 0; n < m->pairs && m->chain != NULL; n++) {
    sepax_chain_free(&m->chain[n]);
  }
  free(m->chain);
  free(m->pair);
  free((void *)m->shell);
  free(m->first);
  Py_XDECREF(m->mechanism_handle);
  Py_XDECREF(m->bodies);
  free(m);
}

static void drop(PyObject *handle) {
  core_machine *m = PyCapsule_GetPointer(handle, CORE_MACHINE);
  if (m != NULL) {
    release(m);
  }
}

/* ------------------------------------------------------------------- making */

/* Append the solids of a body: several shapes of a link, each of which may hold another body. */
static bool solids_from(core_machine *m, size_t n, PyObject *shells) {
  const size_t count = (size_t)PyTuple_Size(shells);
  const size_t from = m->first[n];
  void *grown = realloc((void *)m->shell, (from + count + 1) * sizeof *m->shell);
  if (grown == NULL) {
    PyErr_NoMemory();
    return false;
  }
  m->shell = grown;
  m->first[n + 1] = from + count;
  for (size_t k = 0; k < count; k++) {
    m->shell[from + k] = core_shell_of(PyTuple_GetItem(shells, (Py_ssize_t)k));
    if (m->shell[from + k] == NULL) {
      return false;
    }
  }
  return true;
}

static bool bodies_from(core_machine *m, sepax_machine_body *body, size_t count) {
  bool solids = true;
  for (size_t n = 0; n < count; n++) {
    Py_ssize_t link;
    PyObject *handle;
    PyObject *shells;
    PyObject *row = PyTuple_GetItem(m->bodies, (Py_ssize_t)n);
    if (!PyTuple_Check(row) || !PyArg_ParseTuple(row, "nOO", &link, &handle, &shells)) {
      if (!PyErr_Occurred()) {
        PyErr_SetString(PyExc_TypeError, "a body is no tuple");
      }
      return false;
    }
    body[n] = (sepax_machine_body){.link = (size_t)link, .body = core_body_of(handle)};
    solids = solids && PyTuple_Check(shells);
    if (body[n].body == NULL || (solids && !solids_from(m, n, shells))) {
      return false;
    }
  }
  if (!solids) {
    free((void *)m->shell);
    m->shell = NULL;
  }
  return true;
}

static bool pairs_from(core_machine *m, PyObject *object) {
  core_array array;
  bool ok = core_take(&array, object, "pairs", sizeof *m->pair, false);
  m->pair = ok ? malloc((array.count + 1) * sizeof *m->pair) : NULL;
  m->chain = ok ? calloc(array.count + 1, sizeof *m->chain) : NULL;
  if (ok && (m->pair == NULL || m->chain == NULL)) {
    PyErr_NoMemory();
    ok = false;
  }
  if (ok && array.count > 0) {
    memcpy(m->pair, array.view.buf, array.count * sizeof *m->pair);
    m->pairs = array.count;
  }
  core_release(&array, 1);
  return ok;
}

static bool join(core_machine *m, const sepax_machine_body *body, size_t count,
                 sepax_error *error) {
  const sepax_machine_parts parts = {.size = sizeof parts,
                                     .mechanism = m->mechanism,
                                     .body = body,
                                     .bodies = count,
                                     .pair = (const size_t(*)[2])m->pair,
                                     .pairs = m->pairs};
  bool ok = sepax_machine_new(&m->machine, &parts, error);
  for (size_t n = 0; n < m->pairs && ok && m->shell != NULL; n++) {
    ok = sepax_chain_find(&m->chain[n], m->mechanism, body[m->pair[n][0]].link,
                          body[m->pair[n][1]].link, error);
  }
  return ok;
}

static bool fill(core_machine *m, PyObject *pairs) {
  const size_t count = (size_t)PyTuple_Size(m->bodies);
  sepax_machine_body *body = calloc(count + 1, sizeof *body);
  m->first = calloc(count + 2, sizeof *m->first);
  sepax_error error = {0};
  bool ok = body != NULL && m->first != NULL;
  if (!ok) {
    PyErr_NoMemory();
  }
  ok = ok && bodies_from(m, body, count) && pairs_from(m, pairs);
  if (ok && !join(m, body, count, &error)) {
    core_failed(&error);
    ok = false;
  }
  free(body);
  return ok;
}

static PyObject *machine_new(PyObject *self, PyObject *arguments) {
  (void)self;
  PyObject *handle;
  PyObject *bodies;
  PyObject *pairs;
  if (!PyArg_ParseTuple(arguments, "OOO", &handle, &bodies, &pairs)) {
    return NULL;
  }
  const core_mechanism *c = core_mechanism_of(handle);
  if (c == NULL || !PyTuple_Check(bodies)) {
    return c == NULL ? NULL : PyErr_Format(PyExc_TypeError, "bodies are not a tuple");
  }
  core_machine *m = calloc(1, sizeof *m);
  if (m == NULL) {
    return PyErr_NoMemory();
  }
  m->mechanism = c->mechanism;
  m->mechanism_handle = handle;
  m->bodies = bodies;
  Py_INCREF(handle);
  Py_INCREF(bodies);
  PyObject *made = fill(m, pairs) ? PyCapsule_New(m, CORE_MACHINE, drop) : NULL;
  if (made == NULL) {
    release(m);
  }
  return made;
}

/* ------------------------------------------------------------------- asking */

enum { VALUES, TRAVEL, VERDICT, PAIR, TRIANGLES, INTERVAL, NEAREST, ARRAYS };

typedef struct {
  const core_machine *machine;
  sepax_machine_query query;
  const double *values;
  unsigned char *verdict;
  int64_t *pair, (*triangle)[2], *nearest;
  double (*interval)[2];
} asking;

static int64_t number_of(size_t n) { return n == SEPAX_NO_PAIR ? -1 : (int64_t)n; }

/* Is a solid of one body inside a solid of the other? *found: INSIDE of A in B, of B in A. */
static bool pair_inside(const core_machine *m, size_t k, const sepax_pose pose[2],
                        sepax_inside found[2], sepax_error *error) {
  const size_t a = m->pair[k][0];
  const size_t b = m->pair[k][1];
  found[0] = found[1] = SEPAX_OUTSIDE;
  for (size_t i = m->first[a]; i < m->first[a + 1]; i++) {
    for (size_t j = m->first[b]; j < m->first[b + 1]; j++) {
      sepax_inside within[2];
      if (!sepax_bodies_within(m->shell[i], &pose[0], m->shell[j], &pose[1], within, error)) {
        return false;
      }
      for (int n = 0; n < 2; n++) {
        const bool known = found[n] == SEPAX_INSIDE || within[n] == SEPAX_OUTSIDE;
        found[n] = known ? found[n] : within[n];
      }
    }
  }
  return true;
}

/* Bodies whose surfaces are apart: is one inside the other? Leaves `pair` at the first such pair.
 * Poses are those of sepax_chain_poses, as in sepax_watch_ask. */
static bool look_inside(const asking *a, size_t n, const double *value, sepax_error *error) {
  const core_machine *m = a->machine;
  for (size_t k = 0; k < m->pairs; k++) {
    sepax_pose pose[2];
    sepax_inside found[2];
    sepax_chain_poses(&m->chain[k], m->mechanism, value, pose);
    if (!pair_inside(m, k, pose, found, error)) {
      return false;
    }
    if (found[0] == SEPAX_INSIDE || found[1] == SEPAX_INSIDE) {
      a->verdict[n] = found[0] == SEPAX_INSIDE ? A_INSIDE : B_INSIDE;
      a->pair[n] = (int64_t)k;
      return true;
    }
    const bool open = found[0] != SEPAX_OUTSIDE || found[1] != SEPAX_OUTSIDE;
    if (open && a->verdict[n] == FREE) {
      a->verdict[n] = UNDECIDED;
      a->pair[n] = (int64_t)k;
    }
  }
  return true;
}

static bool ask_row(const asking *a, sepax_watch *watch, size_t n, double *value,
                    sepax_error *error) {
  const sepax_mechanism *m = a->machine->mechanism;
  sepax_machine_answer r;
  if (m->joints > 0) {
    memcpy(value, a->values + n * m->joints, m->joints * sizeof *value);
  }
  if (!sepax_watch_ask(watch, value, &a->query, &r, error)) {
    return false;
  }
  a->verdict[n] = r.verdict == SEPAX_APART ? FREE : r.verdict == SEPAX_NEAR ? NEAR : UNDECIDED;
  a->pair[n] = number_of(r.pair);
  a->nearest[n] = number_of(r.nearest);
  a->interval[n][0] = r.least;
  a->interval[n][1] = r.most;
  for (int k = 0; k < 2; k++) {
    a->triangle[n][k] = r.verdict == SEPAX_NEAR ? (int64_t)r.triangle[k] : -1;
  }
  if (r.verdict != SEPAX_APART || a->machine->shell == NULL) {
    return true;
  }
  sepax_mechanism_follow(m, value);
  return look_inside(a, n, value, error);
}

static bool ask_rows(const core_batch *batch, size_t first, size_t end, size_t *at,
                     sepax_error *error) {
  const asking *a = batch->context;
  const size_t joints = a->machine->mechanism->joints;
  double *value = malloc((joints + 1) * sizeof *value);
  sepax_watch *watch = NULL;
  *at = first;
  if (value == NULL) {
    return sepax_fail(error, SEPAX_ERROR_MEMORY, "no memory for a row");
  }
  bool ok = sepax_watch_new(&watch, a->machine->machine, error);
  for (size_t n = first; n < end && ok; n++) {
    *at = n;
    ok = ask_row(a, watch, n, value, error);
  }
  sepax_watch_free(watch);
  free(value);
  return ok;
}

/* Rows of each chunk share a watch, which each of them makes faster for the next. */
static bool run(asking *a, size_t rows, int threads) {
  const core_batch batch = {.count = rows,
                            .chunk = 512,
                            .threads = threads > 0 ? (size_t)threads : 0,
                            .answer = ask_rows,
                            .context = a};
  return core_run(&batch, "row");
}

static PyObject *machine_ask(PyObject *self, PyObject *arguments) {
  (void)self;
  PyObject *handle;
  PyObject *part[ARRAYS];
  Py_ssize_t count;
  int threads;
  int measure;
  unsigned long long work;
  asking a = {.query = {.size = sizeof a.query}};
  if (!PyArg_ParseTuple(arguments, "OOniOdKpddOOOOO", &handle, &part[VALUES], &count, &threads,
                        &part[TRAVEL], &a.query.clearance, &work, &measure, &a.query.relative,
                        &a.query.absolute, &part[VERDICT], &part[PAIR], &part[TRIANGLES],
                        &part[INTERVAL], &part[NEAREST])) {
    return NULL;
  }
  a.machine = PyCapsule_GetPointer(handle, CORE_MACHINE);
  if (a.machine == NULL) {
    return NULL;
  }
  a.query.work = work;
  a.query.measure = measure != 0;
  const size_t rows = count > 0 ? (size_t)count : 0;
  const size_t joints = a.machine->mechanism->joints;
  const size_t row[ARRAYS] = {sizeof(double),  sizeof(double),     1,
                              sizeof(int64_t), sizeof(int64_t[2]), sizeof(double[2]),
                              sizeof(int64_t)};
  core_array array[ARRAYS] = {{.held = false}};
  bool ok = true;
  for (int k = 0; k < ARRAYS && ok; k++) {
    const size_t length = k == VALUES ? rows * joints : k == TRAVEL ? joints : rows;
    ok = core_take_rows(&array[k], part[k], "an array", row[k], length, k >= VERDICT);
    if (ok && !array[k].held && k != TRAVEL) {
      PyErr_SetString(PyExc_ValueError, "an array is None");
      ok = false;
    }
  }
  a.values = array[VALUES].view.buf;
  a.query.travel = array[TRAVEL].view.buf;
  a.verdict = array[VERDICT].view.buf;
  a.pair = array[PAIR].view.buf;
  a.triangle = array[TRIANGLES].view.buf;
  a.interval = array[INTERVAL].view.buf;
  a.nearest = array[NEAREST].view.buf;
  ok = ok && run(&a, rows, threads);
  core_release(array, ARRAYS);
  if (!ok) {
    return NULL;
  }
  Py_RETURN_NONE;
}

PyMethodDef core_machine_methods[] = {
    {"machine_new", machine_new, METH_VARARGS, "(mechanism, bodies, pairs) -> machine"},
    {"machine_ask", machine_ask, METH_VARARGS,
     "(machine, values, rows, threads, travel, clearance, work, measure, relative, absolute, "
     "verdicts, pairs, triangles, intervals, nearest)"},
    {NULL, NULL, 0, NULL}};
