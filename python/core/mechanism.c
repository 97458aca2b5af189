/* SPDX-License-Identifier: MIT */
/* mechanism.c - links and joints: made from Python, described to Python, posed. */
#include "mechanism.h"

#include <stdlib.h>
#include <string.h>

static void release(core_mechanism *m) {
  sepax_mechanism_free(&m->own);
  sepax_robot_free(&m->robot);
}

static void drop(PyObject *handle) {
  core_mechanism *m = PyCapsule_GetPointer(handle, CORE_MECHANISM);
  if (m != NULL) {
    release(m);
    free(m);
  }
}

core_mechanism *core_mechanism_of(PyObject *handle) {
  return PyCapsule_GetPointer(handle, CORE_MECHANISM);
}

PyObject *core_mechanism_handle(const core_mechanism *from) {
  core_mechanism *m = malloc(sizeof *m);
  if (m == NULL) {
    core_mechanism temporary = *from;
    release(&temporary);
    return PyErr_NoMemory();
  }
  *m = *from;
  m->mechanism = from->mechanism == &from->robot.mechanism ? &m->robot.mechanism : &m->own;
  PyObject *handle = PyCapsule_New(m, CORE_MECHANISM, drop);
  if (handle == NULL) {
    release(m);
    free(m);
  }
  return handle;
}

/* ------------------------------------------------------------------- making */

static char *copy_of(const char *name) {
  char *copy = sepax_allocate(strlen(name) + 1);
  return copy != NULL ? strcpy(copy, name) : (char *)PyErr_NoMemory();
}

static bool fill_links(sepax_mechanism *m, PyObject *links) {
  const size_t count = (size_t)PyList_Size(links);
  m->link = sepax_allocate((count > 0 ? count : 1) * sizeof *m->link);
  if (m->link == NULL) {
    PyErr_NoMemory();
    return false;
  }
  for (size_t n = 0; n < count; n++) {
    PyObject *bytes = PyUnicode_AsUTF8String(PyList_GetItem(links, (Py_ssize_t)n));
    char *name = bytes != NULL ? copy_of(PyBytes_AsString(bytes)) : NULL;
    Py_XDECREF(bytes);
    if (name == NULL) {
      return false;
    }
    m->link[m->links++] = (sepax_link){.name = name};
  }
  return true;
}

/* (name, kind, parent, child, 16 numbers of the origin, axis, lower, upper, mimic, factor,
 * offset); mimic is -1 for none. */
static bool fill_joint(sepax_mechanism *m, PyObject *row) {
  const char *name;
  int kind;
  Py_ssize_t parent;
  Py_ssize_t child;
  Py_ssize_t mimic;
  PyObject *origin;
  sepax_joint j = {.name = NULL};
  core_array array;
  sepax_error error = {0};
  const sepax_pose *pose = NULL;
  if (!PyArg_ParseTuple(row, "sinnO(ddd)ddndd", &name, &kind, &parent, &child, &origin, &j.axis[0],
                        &j.axis[1], &j.axis[2], &j.lower, &j.upper, &mimic, &j.factor, &j.offset)) {
    return false;
  }
  bool ok = core_take_rows(&array, origin, "origin", sizeof(double[16]), 1, false);
  const core_poses poses = {.matrix = array.view.buf, .count = 1};
  if (ok && !core_pose(&poses, 0, &j.origin, &pose, &error)) {
    core_failed(&error);
    ok = false;
  }
  core_release(&array, 1);
  if (ok && pose == NULL) {
    PyErr_SetString(PyExc_ValueError, "origin is None");
    ok = false;
  }
  j.kind = (sepax_joint_kind)kind;
  j.parent = (size_t)parent;
  j.child = (size_t)child;
  j.mimic = mimic < 0 ? SEPAX_NO_JOINT : (size_t)mimic;
  j.name = ok ? copy_of(name) : NULL;
  if (j.name != NULL) {
    m->joint[m->joints++] = j;
  }
  return j.name != NULL;
}

static bool fill_joints(sepax_mechanism *m, PyObject *joints) {
  const size_t count = (size_t)PyList_Size(joints);
  m->joint = sepax_allocate((count > 0 ? count : 1) * sizeof *m->joint);
  if (m->joint == NULL) {
    PyErr_NoMemory();
    return false;
  }
  bool ok = true;
  for (size_t n = 0; n < count && ok; n++) {
    ok = fill_joint(m, PyList_GetItem(joints, (Py_ssize_t)n));
  }
  return ok;
}

static PyObject *mechanism_new(PyObject *self, PyObject *arguments) {
  (void)self;
  PyObject *links;
  PyObject *joints;
  if (!PyArg_ParseTuple(arguments, "OO", &links, &joints)) {
    return NULL;
  }
  if (!PyList_Check(links) || !PyList_Check(joints)) {
    PyErr_SetString(PyExc_TypeError, "links and joints are not lists");
    return NULL;
  }
  core_mechanism m = {.mechanism = NULL};
  sepax_error error = {0};
  bool ok = fill_links(&m.own, links) && fill_joints(&m.own, joints);
  if (ok && !sepax_mechanism_join(&m.own, &error)) {
    core_failed(&error);
    ok = false;
  }
  if (!ok) {
    release(&m);
    return NULL;
  }
  m.mechanism = &m.own;
  return core_mechanism_handle(&m);
}

/* --------------------------------------------------------------- describing */

static PyObject *joint_of(const sepax_mechanism *m, const sepax_joint *j) {
  (void)m;
  return Py_BuildValue("(sinn(ddd)ddnddN)", j->name, (int)j->kind, (Py_ssize_t)j->parent,
                       (Py_ssize_t)j->child, j->axis[0], j->axis[1], j->axis[2], j->lower, j->upper,
                       j->mimic == SEPAX_NO_JOINT ? -1 : (Py_ssize_t)j->mimic, j->factor, j->offset,
                       PyBool_FromLong(sepax_joint_driven(j)));
}

/* Appends a new reference, which may be NULL. */
static bool append(PyObject *list, PyObject *item) {
  const bool ok = item != NULL && PyList_Append(list, item) == 0;
  Py_XDECREF(item);
  return ok;
}

static PyObject *mechanism_about(PyObject *self, PyObject *handle) {
  (void)self;
  const core_mechanism *c = core_mechanism_of(handle);
  if (c == NULL) {
    return NULL;
  }
  const sepax_mechanism *m = c->mechanism;
  PyObject *links = PyList_New(0);
  PyObject *joints = PyList_New(0);
  bool ok = links != NULL && joints != NULL;
  for (size_t n = 0; n < m->links && ok; n++) {
    ok = append(links, PyUnicode_DecodeUTF8(m->link[n].name, (Py_ssize_t)strlen(m->link[n].name),
                                            "replace"));
  }
  for (size_t n = 0; n < m->joints && ok; n++) {
    ok = append(joints, joint_of(m, &m->joint[n]));
  }
  if (!ok) {
    Py_XDECREF(links);
    Py_XDECREF(joints);
    return NULL;
  }
  return Py_BuildValue("(NNn)", links, joints, (Py_ssize_t)m->root);
}

/* ------------------------------------------------------------------- posing */

typedef struct {
  const sepax_mechanism *mechanism;
  const double *values;
  double *matrices;
} posing;

static bool pose_rows(const core_batch *batch, size_t first, size_t end, size_t *at,
                      sepax_error *error) {
  const posing *p = batch->context;
  const sepax_mechanism *m = p->mechanism;
  double *value = sepax_allocate((m->joints > 0 ? m->joints : 1) * sizeof *value);
  sepax_pose *pose = sepax_allocate(m->links * sizeof *pose);
  const bool ok = value != NULL && pose != NULL;
  for (size_t n = first; n < end && ok; n++) {
    if (m->joints > 0) {
      memcpy(value, p->values + n * m->joints, m->joints * sizeof *value);
    }
    sepax_mechanism_follow(m, value);
    sepax_mechanism_poses(m, value, pose);
    for (size_t k = 0; k < m->links; k++) {
      double *to = p->matrices + 16 * (n * m->links + k);
      for (size_t i = 0; i < 3; i++) {
        memcpy(to + 4 * i, pose[k].rotation[i], sizeof pose[k].rotation[i]);
        to[4 * i + 3] = pose[k].translation[i];
      }
      memcpy(to + 12, (const double[4]){0, 0, 0, 1}, sizeof(double[4]));
    }
  }
  if (!ok) {
    *at = first;
    *error = (sepax_error){SEPAX_ERROR_MEMORY, "no memory for poses"};
  }
  sepax_release(value);
  sepax_release(pose);
  return ok;
}

static PyObject *mechanism_poses(PyObject *self, PyObject *arguments) {
  (void)self;
  PyObject *handle;
  PyObject *values;
  PyObject *matrices;
  Py_ssize_t count;
  int threads;
  if (!PyArg_ParseTuple(arguments, "OOniO", &handle, &values, &count, &threads, &matrices)) {
    return NULL;
  }
  const core_mechanism *c = core_mechanism_of(handle);
  if (c == NULL) {
    return NULL;
  }
  const size_t rows = count > 0 ? (size_t)count : 0;
  core_array array[2] = {{.held = false}};
  bool ok = core_take_rows(&array[0], values, "values", sizeof(double), rows * c->mechanism->joints,
                           false) &&
            core_take_rows(&array[1], matrices, "matrices", sizeof(double[16]),
                           rows * c->mechanism->links, true);
  if (ok && (!array[0].held || !array[1].held)) {
    PyErr_SetString(PyExc_ValueError, "an array is None");
    ok = false;
  }
  posing p = {c->mechanism, array[0].view.buf, array[1].view.buf};
  const core_batch batch = {.count = rows,
                            .chunk = 256,
                            .threads = threads > 0 ? (size_t)threads : 0,
                            .answer = pose_rows,
                            .context = &p};
  ok = ok && core_run(&batch, "row");
  core_release(array, 2);
  if (!ok) {
    return NULL;
  }
  Py_RETURN_NONE;
}

PyMethodDef core_mechanism_methods[] = {
    {"mechanism_new", mechanism_new, METH_VARARGS, "(links, joints) -> mechanism"},
    {"mechanism_about", mechanism_about, METH_O, "(mechanism) -> links, joints, root"},
    {"mechanism_poses", mechanism_poses, METH_VARARGS,
     "(mechanism, values, rows, threads, matrices)"},
    {NULL, NULL, 0, NULL}};
