/* SPDX-License-Identifier: MIT */
/* robot.c - robots from files of URDF and SRDF. */
#include "mechanism.h"
#include "robot/robot.h"
#include "util/error.h"

#include <stdlib.h>
#include <string.h>

static bool append(PyObject *list, PyObject *item) {
  const bool ok = item != NULL && PyList_Append(list, item) == 0;
  Py_XDECREF(item);
  return ok;
}

static PyObject *others_of(const sepax_robot_others *others) {
  PyObject *all = PyDict_New();
  for (size_t n = 0; n < others->count && all != NULL; n++) {
    PyObject *count = PyLong_FromSize_t(others->entry[n].count);
    if (count == NULL || PyDict_SetItemString(all, others->entry[n].what, count) != 0) {
      Py_CLEAR(all);
    }
    Py_XDECREF(count);
  }
  return all;
}

/* [(name, folder)] of Python; the strings live as long as the list. */
static bool packages_from(sepax_robot_reading *how, sepax_package *package, PyObject *list) {
  for (Py_ssize_t n = 0; n < PyList_Size(list); n++) {
    if (!PyArg_ParseTuple(PyList_GetItem(list, n), "ss", &package[n].name, &package[n].folder)) {
      return false;
    }
  }
  how->package = package;
  how->packages = (size_t)PyList_Size(list);
  return true;
}

static PyObject *robot_read(PyObject *self, PyObject *arguments) {
  (void)self;
  PyObject *path = NULL;
  PyObject *list;
  if (!PyArg_ParseTuple(arguments, "OO&", &list, PyUnicode_FSConverter, &path)) {
    return NULL;
  }
  sepax_package *package =
      PyList_Check(list) ? calloc((size_t)PyList_Size(list) + 1, sizeof *package) : NULL;
  sepax_robot_reading how = {.size = sizeof how};
  core_mechanism m = {.mechanism = NULL};
  sepax_error error = {0};
  bool ok = package != NULL;
  if (!ok) {
    PyErr_SetString(PyExc_TypeError, "packages are not a list");
  }
  ok = ok && packages_from(&how, package, list);
  if (ok && !sepax_robot_read(&m.robot, PyBytes_AsString(path), &how, &error)) {
    core_failed(&error);
    ok = false;
  }
  free(package);
  Py_DECREF(path);
  m.mechanism = &m.robot.mechanism;
  return ok ? core_mechanism_handle(&m) : NULL;
}

static PyObject *shape_of(const sepax_shape *s) {
  return Py_BuildValue("(nszz(ddd)l)", (Py_ssize_t)s->link, sepax_shape_kind_name(s->kind), s->path,
                       s->name, s->size[0], s->size[1], s->size[2], s->line);
}

static PyObject *robot_about(PyObject *self, PyObject *handle) {
  (void)self;
  const core_mechanism *m = core_mechanism_of(handle);
  if (m == NULL) {
    return NULL;
  }
  const sepax_robot *r = &m->robot;
  PyObject *shapes = PyList_New(0);
  PyObject *bare = PyList_New(0);
  PyObject *others = others_of(&r->others);
  bool ok = shapes != NULL && bare != NULL && others != NULL;
  for (size_t n = 0; n < r->shapes && ok; n++) {
    ok = append(shapes, shape_of(&r->shape[n]));
  }
  for (size_t n = 0; n < r->nothings && ok; n++) {
    ok = append(bare, Py_BuildValue("(nl)", (Py_ssize_t)r->nothing[n].link, r->nothing[n].line));
  }
  if (!ok) {
    Py_XDECREF(shapes);
    Py_XDECREF(bare);
    Py_XDECREF(others);
    return NULL;
  }
  return Py_BuildValue("(znNNN)", r->name, (Py_ssize_t)r->links, shapes, bare, others);
}

/* The triangles of a shape, in metres, in the link's coordinates. */
static PyObject *robot_shape(PyObject *self, PyObject *arguments) {
  (void)self;
  PyObject *handle;
  Py_ssize_t n;
  int fans;
  sepax_shape_reading how = {.size = sizeof how};
  if (!PyArg_ParseTuple(arguments, "Ondp", &handle, &n, &how.unit, &fans)) {
    return NULL;
  }
  how.fans = fans != 0;
  const core_mechanism *m = core_mechanism_of(handle);
  if (m == NULL || n < 0 || (size_t)n >= m->robot.shapes) {
    return m == NULL ? NULL : PyErr_Format(PyExc_IndexError, "shape %zd", n);
  }
  sepax_soup soup = {0};
  sepax_error error = {0};
  bool ok;
  Py_BEGIN_ALLOW_THREADS;
  ok = sepax_shape_mesh(&soup, NULL, &m->robot.shape[n], &how, &error);
  Py_END_ALLOW_THREADS;
  if (!ok) {
    return core_failed(&error);
  }
  PyObject *facets = core_bytes(soup.facet, soup.count, sizeof *soup.facet);
  sepax_soup_free(&soup);
  return facets;
}

/* Of triangles with the same corners one stays, as in sepax_robot_machine_read. */
static PyObject *distinct(PyObject *self, PyObject *triangles) {
  (void)self;
  core_array array;
  if (!core_take(&array, triangles, "triangles", sizeof(sepax_facet), false)) {
    core_release(&array, 1);
    return NULL;
  }
  sepax_soup soup = {.facet = sepax_allocate((array.count + 1) * sizeof *soup.facet),
                     .count = array.count};
  bool ok = soup.facet != NULL;
  if (ok && array.count > 0) {
    memcpy(soup.facet, array.view.buf, array.count * sizeof *soup.facet);
  }
  core_release(&array, 1);
  ok = ok && sepax__distinct(&soup);
  PyObject *facets = ok ? core_bytes(soup.facet, soup.count, sizeof *soup.facet) : PyErr_NoMemory();
  sepax_soup_free(&soup);
  return facets;
}

static PyObject *robot_pairs(PyObject *self, PyObject *arguments) {
  (void)self;
  PyObject *handle;
  PyObject *file;
  if (!PyArg_ParseTuple(arguments, "OO", &handle, &file)) {
    return NULL;
  }
  const core_mechanism *m = core_mechanism_of(handle);
  PyObject *path = NULL;
  if (m == NULL || (file != Py_None && PyUnicode_FSConverter(file, &path) == 0)) {
    return NULL;
  }
  sepax_robot_pairs pairs;
  sepax_error error = {0};
  const bool ok = sepax_robot_pairs_choose(&pairs, &m->robot,
                                           path != NULL ? PyBytes_AsString(path) : NULL, &error);
  Py_XDECREF(path);
  if (!ok) {
    return core_failed(&error);
  }
  PyObject *bytes = core_bytes(pairs.pair, pairs.count, sizeof *pairs.pair);
  PyObject *others = others_of(&pairs.srdf.others);
  PyObject *result =
      bytes != NULL && others != NULL
          ? Py_BuildValue("(OnnnOz)", bytes, (Py_ssize_t)pairs.joined, (Py_ssize_t)pairs.rigid,
                          (Py_ssize_t)pairs.disabled, others, pairs.srdf.robot)
          : NULL;
  Py_XDECREF(bytes);
  Py_XDECREF(others);
  sepax_robot_pairs_free(&pairs);
  return result;
}

PyMethodDef core_robot_methods[] = {
    {"robot_read", robot_read, METH_VARARGS, "(packages, path) -> mechanism"},
    {"robot_about", robot_about, METH_O, "(mechanism) -> name, links, shapes, bare, others"},
    {"robot_shape", robot_shape, METH_VARARGS, "(mechanism, shape, unit, fans) -> facets"},
    {"robot_pairs", robot_pairs, METH_VARARGS,
     "(mechanism, srdf) -> pairs, joined, rigid, disabled, others, name in the SRDF"},
    {"distinct", distinct, METH_O, "(facets) -> facets"},
    {NULL, NULL, 0, NULL}};
