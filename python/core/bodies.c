/* SPDX-License-Identifier: MIT */
/* bodies.c - handles of bodies and of their shells. */
#include "core.h"

#include <stdlib.h>

static void drop_body(PyObject *handle) {
  core_body *b = PyCapsule_GetPointer(handle, CORE_BODY);
  if (b != NULL) {
    sepax_body_free(b->body);
    free(b);
  }
}

static void drop_shell(PyObject *handle) {
  core_shell *s = PyCapsule_GetPointer(handle, CORE_SHELL);
  if (s != NULL) {
    sepax_shell_free(&s->shell);
    Py_DECREF(s->body);
    free(s);
  }
}

const sepax_body *core_body_of(PyObject *handle) {
  core_body *b = PyCapsule_GetPointer(handle, CORE_BODY);
  return b != NULL ? b->body : NULL;
}

const sepax_shell *core_shell_of(PyObject *handle) {
  core_shell *s = PyCapsule_GetPointer(handle, CORE_SHELL);
  return s != NULL ? &s->shell : NULL;
}

bool core_maybe_shell(const sepax_shell **shell, PyObject *handle) {
  *shell = handle == Py_None ? NULL : core_shell_of(handle);
  return handle == Py_None || *shell != NULL;
}

static PyObject *body_handle(sepax_body *body) {
  core_body *b = malloc(sizeof *b);
  if (b == NULL) {
    sepax_body_free(body);
    return PyErr_NoMemory();
  }
  b->body = body;
  PyObject *handle = PyCapsule_New(b, CORE_BODY, drop_body);
  if (handle == NULL) {
    sepax_body_free(body);
    free(b);
  }
  return handle;
}

static PyObject *body_new(PyObject *self, PyObject *arguments) {
  (void)self;
  PyObject *vertices;
  PyObject *faces;
  int threads;
  if (!PyArg_ParseTuple(arguments, "OOi", &vertices, &faces, &threads)) {
    return NULL;
  }
  sepax_mesh mesh;
  core_array array[2];
  sepax_body *body = NULL;
  sepax_error error = {0};
  bool ok = false;
  if (core_mesh(&mesh, array, vertices, faces)) {
    Py_BEGIN_ALLOW_THREADS;
    ok = sepax_body_new(&body, &mesh, &SEPAX_STRUCT(sepax_build, .threads = threads), &error);
    Py_END_ALLOW_THREADS;
    if (!ok) {
      core_failed(&error);
    }
  }
  core_release(array, 2);
  return ok ? body_handle(body) : NULL;
}

static PyObject *body_triangles(PyObject *self, PyObject *handle) {
  (void)self;
  const sepax_body *body = core_body_of(handle);
  return body != NULL ? PyLong_FromSize_t(sepax_body_triangles(body)) : NULL;
}

static PyObject *shell_new(PyObject *self, PyObject *handle) {
  (void)self;
  const sepax_body *body = core_body_of(handle);
  if (body == NULL) {
    return NULL;
  }
  core_shell *s = malloc(sizeof *s);
  if (s == NULL) {
    return PyErr_NoMemory();
  }
  sepax_error error = {0};
  bool ok = false;
  Py_BEGIN_ALLOW_THREADS;
  ok = sepax_shell_find(&s->shell, body, &error);
  Py_END_ALLOW_THREADS;
  PyObject *shell = ok ? PyCapsule_New(s, CORE_SHELL, drop_shell) : core_failed(&error);
  if (shell == NULL) {
    if (ok) {
      sepax_shell_free(&s->shell);
    }
    free(s);
    return NULL;
  }
  s->body = handle;
  Py_INCREF(handle);
  return shell;
}

static PyObject *shell_about(PyObject *self, PyObject *handle) {
  (void)self;
  const sepax_shell *s = core_shell_of(handle);
  return s == NULL
             ? NULL
             : Py_BuildValue("(NNn(ddd)(ddd)nn)", PyBool_FromLong(s->closed),
                             PyBool_FromLong(s->consistent), (Py_ssize_t)s->facet, s->edge[0][0],
                             s->edge[0][1], s->edge[0][2], s->edge[1][0], s->edge[1][1],
                             s->edge[1][2], (Py_ssize_t)s->parts, (Py_ssize_t)s->pieces);
}

PyMethodDef core_body_methods[] = {
    {"body_new", body_new, METH_VARARGS, "(vertices, faces, threads) -> body"},
    {"body_triangles", body_triangles, METH_O, "(body) -> number of triangles"},
    {"shell_new", shell_new, METH_O, "(body) -> shell"},
    {"shell_about", shell_about, METH_O,
     "(shell) -> closed, consistent, facet, edge, parts, pieces"},
    {NULL, NULL, 0, NULL}};
