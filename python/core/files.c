/* SPDX-License-Identifier: MIT */
/* files.c - files of meshes and poses, and the mending of meshes. */
#include "core.h"
#include "sepax_io.h"
#include "util/error.h"

#include <stdlib.h>
#include <string.h>

/* ------------------------------------------------------------------- meshes */

static PyObject *others_of(const sepax_mesh_account *a) {
  PyObject *others = PyDict_New();
  for (size_t n = 0; n < a->others && others != NULL; n++) {
    PyObject *count = PyLong_FromSize_t(a->other[n].count);
    if (count == NULL || PyDict_SetItemString(others, a->other[n].what, count) != 0) {
      Py_CLEAR(others);
    }
    Py_XDECREF(count);
  }
  return others;
}

static PyObject *remarks_of(const sepax_mesh_account *a) {
  PyObject *remarks = PyList_New(0);
  for (size_t n = 0; n < a->remarks && remarks != NULL; n++) {
    const sepax_mesh_remark *r = &a->remark[n];
    PyObject *remark = Py_BuildValue("(sns)", r->what, (Py_ssize_t)r->count, r->which);
    if (remark == NULL || PyList_Append(remarks, remark) != 0) {
      Py_CLEAR(remarks);
    }
    Py_XDECREF(remark);
  }
  return remarks;
}

static PyObject *account_of(const sepax_mesh_account *a) {
  PyObject *others = others_of(a);
  PyObject *remarks = remarks_of(a);
  if (others == NULL || remarks == NULL) {
    Py_XDECREF(others);
    Py_XDECREF(remarks);
    return NULL;
  }
  return Py_BuildValue("{s:s,s:s,s:d,s:n,s:n,s:n,s:n,s:n,s:n,s:N,s:N}", "format", a->format, "unit",
                       a->unit, "unit_mm", a->unit_mm, "faces", (Py_ssize_t)a->faces, "triangles",
                       (Py_ssize_t)a->triangles, "divided", (Py_ssize_t)a->divided, "bent",
                       (Py_ssize_t)a->bent, "fans", (Py_ssize_t)a->fans, "unplaced",
                       (Py_ssize_t)a->unplaced, "others", others, "remarks", remarks);
}

static PyObject *mesh_read(PyObject *self, PyObject *arguments) {
  (void)self;
  PyObject *path;
  Py_ssize_t most;
  int fans;
  sepax_mesh_reading how = {.size = sizeof how};
  if (!PyArg_ParseTuple(arguments, "O&nddp", PyUnicode_FSConverter, &path, &most, &how.unit_mm,
                        &how.result_mm, &fans)) {
    return NULL;
  }
  how.fans = fans != 0;
  how.most = most > 0 ? (size_t)most : 0;
  const char *name = PyBytes_AsString(path);
  sepax_soup soup = {0};
  sepax_mesh_account account;
  sepax_error error = {0};
  bool ok;
  Py_BEGIN_ALLOW_THREADS;
  ok = sepax_mesh_read(&soup, &account, name, &how, &error);
  Py_END_ALLOW_THREADS;
  Py_DECREF(path);
  if (!ok) {
    return core_failed(&error);
  }
  PyObject *facets = core_bytes(soup.facet, soup.count, sizeof *soup.facet);
  sepax_soup_free(&soup);
  PyObject *about = facets != NULL ? account_of(&account) : NULL;
  if (about == NULL) {
    Py_XDECREF(facets);
    return NULL;
  }
  return Py_BuildValue("(NN)", facets, about);
}

/* A copy of the triangles of an array, in memory of the library. */
static bool soup_from(sepax_soup *soup, PyObject *object) {
  core_array array;
  *soup = (sepax_soup){0};
  bool ok = core_take(&array, object, "triangles", sizeof(sepax_facet), false);
  if (ok && array.held && array.count > 0) {
    soup->facet = sepax_allocate(array.count * sizeof *soup->facet);
    ok = soup->facet != NULL;
    if (ok) {
      memcpy(soup->facet, array.view.buf, array.count * sizeof *soup->facet);
      soup->count = array.count;
    } else {
      PyErr_NoMemory();
    }
  }
  core_release(&array, 1);
  return ok;
}

static PyObject *stl_write(PyObject *self, PyObject *arguments) {
  (void)self;
  PyObject *path;
  PyObject *triangles;
  int ascii;
  if (!PyArg_ParseTuple(arguments, "OO&p", &triangles, PyUnicode_FSConverter, &path, &ascii)) {
    return NULL;
  }
  sepax_soup soup;
  sepax_error error = {0};
  bool ok = soup_from(&soup, triangles);
  if (ok && !sepax_stl_write(&soup, PyBytes_AsString(path), ascii != 0, &error)) {
    core_failed(&error);
    ok = false;
  }
  sepax_soup_free(&soup);
  Py_DECREF(path);
  if (!ok) {
    return NULL;
  }
  Py_RETURN_NONE;
}

static PyObject *weld(PyObject *self, PyObject *arguments) {
  (void)self;
  PyObject *triangles;
  double length;
  if (!PyArg_ParseTuple(arguments, "Od", &triangles, &length)) {
    return NULL;
  }
  sepax_soup soup;
  sepax_weld said;
  sepax_error error = {0};
  bool ok = soup_from(&soup, triangles);
  if (ok) {
    Py_BEGIN_ALLOW_THREADS;
    ok = sepax_soup_weld(&soup, length, &said, &error);
    Py_END_ALLOW_THREADS;
    if (!ok) {
      core_failed(&error);
    }
  }
  PyObject *facets = ok ? core_bytes(soup.facet, soup.count, sizeof *soup.facet) : NULL;
  sepax_soup_free(&soup);
  return facets != NULL
             ? Py_BuildValue("(N{s:n,s:d,s:n,s:n,s:n})", facets, "moved", (Py_ssize_t)said.moved,
                             "farthest", said.farthest, "degenerate", (Py_ssize_t)said.degenerate,
                             "duplicates", (Py_ssize_t)said.duplicates, "divided",
                             (Py_ssize_t)said.divided)
             : NULL;
}

/* -------------------------------------------------------------------- poses */

/* The 12 numbers of each pose: the rotation by rows, then the translation. */
static PyObject *poses_read(PyObject *self, PyObject *arguments) {
  (void)self;
  PyObject *path;
  int nearest;
  if (!PyArg_ParseTuple(arguments, "O&p", PyUnicode_FSConverter, &path, &nearest)) {
    return NULL;
  }
  sepax_poses poses;
  sepax_error error = {0};
  double moved = 0;
  const char *name = PyBytes_AsString(path);
  const bool ok = nearest ? sepax_poses_read_nearest(&poses, &moved, name, &error)
                          : sepax_poses_read(&poses, name, &error);
  Py_DECREF(path);
  if (!ok) {
    return core_failed(&error);
  }
  PyObject *bytes = core_bytes(poses.pose, poses.count, sizeof *poses.pose);
  sepax_poses_free(&poses);
  return bytes != NULL ? Py_BuildValue("(Nd)", bytes, moved) : NULL;
}

/* Raises what a question would raise about the bad pose. */
static PyObject *poses_check(PyObject *self, PyObject *matrices) {
  (void)self;
  core_array array;
  sepax_pose memory;
  const sepax_pose *pose;
  sepax_error error = {0};
  bool ok = core_take(&array, matrices, "poses", sizeof(double[16]), false);
  const core_poses poses = {.matrix = array.view.buf, .count = array.count};
  for (size_t n = 0; n < array.count && ok; n++) {
    if (!core_pose(&poses, n, &memory, &pose, &error)) {
      core_failed(&error);
      ok = false;
    }
  }
  core_release(&array, 1);
  if (!ok) {
    return NULL;
  }
  Py_RETURN_NONE;
}

/* In place: each matrix of 4 by 4 becomes the nearest rotation, and its last row stays. */
static PyObject *poses_nearest(PyObject *self, PyObject *matrices) {
  (void)self;
  core_array array;
  sepax_error error = {0};
  double farthest = 0;
  bool ok = core_take(&array, matrices, "poses", sizeof(double[16]), true);
  for (size_t n = 0; n < array.count && ok; n++) {
    double *m = (double *)array.view.buf + 16 * n;
    sepax_pose pose = {0};
    double moved;
    for (size_t i = 0; i < 3; i++) {
      memcpy(pose.rotation[i], m + 4 * i, sizeof pose.rotation[i]);
      pose.translation[i] = m[4 * i + 3];
    }
    ok = sepax_pose_nearest(&pose, &moved, &error);
    if (ok) {
      for (size_t i = 0; i < 3; i++) {
        memcpy(m + 4 * i, pose.rotation[i], sizeof pose.rotation[i]);
      }
      farthest = moved > farthest ? moved : farthest;
    } else {
      char before[64];
      snprintf(before, sizeof before, "pose %zu: ", n);
      core_failed_at(before, &error);
    }
  }
  core_release(&array, 1);
  return ok ? PyFloat_FromDouble(farthest) : NULL;
}

PyMethodDef core_file_methods[] = {
    {"mesh_read", mesh_read, METH_VARARGS,
     "(path, most, unit_mm, result_mm, fans) -> facets, account"},
    {"stl_write", stl_write, METH_VARARGS, "(facets, path, ascii)"},
    {"weld", weld, METH_VARARGS, "(facets, length) -> facets, account"},
    {"poses_read", poses_read, METH_VARARGS, "(path, nearest) -> numbers, moved"},
    {"poses_check", poses_check, METH_O, "(matrices)"},
    {"poses_nearest", poses_nearest, METH_O, "(matrices) -> largest change"},
    {NULL, NULL, 0, NULL}};
