/* SPDX-License-Identifier: MIT */
/* buffers.c - arrays of Python, used where they are. */
#include "core.h"

#include <string.h>

void core_release(core_array *arrays, size_t count) {
  for (size_t n = 0; n < count; n++) {
    if (arrays[n].held) {
      PyBuffer_Release(&arrays[n].view);
    }
    arrays[n] = (core_array){.held = false};
  }
}

bool core_take(core_array *array, PyObject *object, const char *name, size_t row, bool write) {
  *array = (core_array){.held = false};
  if (object == Py_None) {
    return true;
  }
  if (PyObject_GetBuffer(object, &array->view, write ? PyBUF_WRITABLE : PyBUF_SIMPLE) != 0) {
    return false;
  }
  array->held = true;
  array->count = (size_t)array->view.len / row;
  if (array->count * row != (size_t)array->view.len) {
    PyErr_Format(PyExc_ValueError, "%s has %zd bytes, no multiple of %zu", name, array->view.len,
                 row);
    return false;
  }
  return true;
}

bool core_take_rows(core_array *array, PyObject *object, const char *name, size_t row, size_t count,
                    bool write) {
  if (!core_take(array, object, name, row, write)) {
    return false;
  }
  if (array->held && array->count != count) {
    PyErr_Format(PyExc_ValueError, "%s has %zu rows, not %zu", name, array->count, count);
    return false;
  }
  return true;
}

/* The type of the vertices by the letter of Python's module struct. */
static bool real_of(sepax_mesh *mesh, const Py_buffer *view) {
  const char *format = view->format != NULL ? view->format : "B";
  if (strcmp(format, "d") == 0 && view->itemsize == sizeof(double)) {
    mesh->real = SEPAX_DOUBLE;
    return true;
  }
  mesh->real = SEPAX_FLOAT;
  return strcmp(format, "f") == 0 && view->itemsize == sizeof(float);
}

static bool vertices_of(sepax_mesh *mesh, core_array *array, PyObject *object) {
  if (PyObject_GetBuffer(object, &array->view, PyBUF_STRIDES | PyBUF_FORMAT) != 0) {
    return false;
  }
  array->held = true;
  const Py_buffer *view = &array->view;
  if (view->ndim != 2 || view->shape[1] != 3 || !real_of(mesh, view) ||
      view->strides[1] != view->itemsize || view->strides[0] < 3 * view->itemsize) {
    PyErr_SetString(PyExc_ValueError, "vertices are not (n, 3) floats in rows");
    return false;
  }
  mesh->vertex = view->buf;
  mesh->vertex_stride = (size_t)view->strides[0];
  mesh->vertices = (size_t)view->shape[0];
  return true;
}

bool core_mesh(sepax_mesh *mesh, core_array array[2], PyObject *vertices, PyObject *faces) {
  array[0] = array[1] = (core_array){.held = false};
  *mesh = (sepax_mesh){.size = sizeof *mesh};
  if (!vertices_of(mesh, &array[0], vertices) ||
      !core_take(&array[1], faces, "faces", sizeof(uint32_t[3]), false)) {
    return false;
  }
  mesh->index = array[1].view.buf;
  mesh->triangles = array[1].held ? array[1].count : mesh->vertices / 3;
  if (!array[1].held && mesh->vertices % 3 != 0) {
    PyErr_SetString(PyExc_ValueError, "without faces, the number of vertices is a multiple of 3");
    return false;
  }
  return true;
}

PyObject *core_bytes(const void *bytes, size_t count, size_t size) {
  if (count > (size_t)PY_SSIZE_T_MAX / size) {
    return PyErr_NoMemory();
  }
  return PyByteArray_FromStringAndSize(count > 0 ? bytes : NULL, (Py_ssize_t)(count * size));
}
