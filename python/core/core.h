/* SPDX-License-Identifier: MIT */
/* core.h - sepax._core: what Python cannot say by itself about the C library (private).
 *
 * The functions of the module take what the package's Python code has already brought into form:
 * buffers of one type, whole numbers, handles. They check again what memory safety depends on, that
 * is, handles and the length of each buffer, so that no call of any kind can leave an array.
 *
 * A handle is a capsule. It owns an object of the library, and whatever this object needs to live:
 * a shell keeps its body, a machine its mechanism and bodies. An object is freed when nothing in
 * Python refers to its handle, so a body may be deleted while another object or a running call uses
 * it. Objects never change after they were made, so threads share them. */
#ifndef SEPAX_PYTHON_CORE_H
#define SEPAX_PYTHON_CORE_H

#define PY_SSIZE_T_CLEAN
#include <Python.h>

#include "sepax.h"

/* ------------------------------------------------------------------ failures */

/* Set the exception that belongs to the error, and return NULL. */
PyObject *core_failed(const sepax_error *error);

/* The same, with "BEFORE: " in front of the text. */
PyObject *core_failed_at(const char *before, const sepax_error *error);

/* ------------------------------------------------------------------- buffers */

/* The memory of an array of Python, held until core_release. */
typedef struct {
  Py_buffer view;
  bool held;
  size_t count; /* rows of the size that was asked for */
} core_array;

/* Take a contiguous array whose length is a multiple of `row` bytes. None gives an array of NULL
 * and no rows. On failure a Python exception is set. */
bool core_take(core_array *array, PyObject *object, const char *name, size_t row, bool write);
void core_release(core_array *arrays, size_t count);

/* Like core_take, but the array must have `count` rows (or be None). */
bool core_take_rows(core_array *array, PyObject *object, const char *name, size_t row, size_t count,
                    bool write);

/* A mesh in the memory of Python: vertices (n, 3) of doubles or floats with any distance between
 * rows; faces (m, 3) of uint32_t, or None for vertices that follow each other. array[2] is held. */
bool core_mesh(sepax_mesh *mesh, core_array array[2], PyObject *vertices, PyObject *faces);

/* A new bytearray with a copy of the bytes. */
PyObject *core_bytes(const void *bytes, size_t count, size_t size);

/* ------------------------------------------------------------------- handles */

typedef struct {
  sepax_body *body;
} core_body;

typedef struct {
  sepax_shell shell;
  PyObject *body; /* the handle that keeps the body */
} core_shell;

#define CORE_BODY "sepax.body"
#define CORE_SHELL "sepax.shell"

/* The object of a handle, or NULL with an exception. */
const sepax_body *core_body_of(PyObject *handle);
const sepax_shell *core_shell_of(PyObject *handle);

/* *shell is NULL if the handle is None. */
bool core_maybe_shell(const sepax_shell **shell, PyObject *handle);

/* --------------------------------------------------------------------- poses */

/* Matrices of 4 by 4 doubles, by rows: one for each question, one for all, or none. */
typedef struct {
  const double (*matrix)[16];
  size_t count;
} core_poses;

/* Pose n, in *to; *pose is NULL if the body stays. False with an error if its last row is not 0 0 0
 * 1, or if it is not valid. */
bool core_pose(const core_poses *poses, size_t n, sepax_pose *to, const sepax_pose **pose,
               sepax_error *error);

/* --------------------------------------------------------------- many at once */

/* Questions that threads answer in chunks. Chunks do not depend on the number of threads, so the
 * answers do not, either. */
typedef struct core_batch core_batch;
struct core_batch {
  size_t count, chunk, threads; /* threads 0: one for each processor */
  /* Answer the questions first ... end - 1. On failure *at is the number of the bad one. */
  bool (*answer)(const core_batch *batch, size_t first, size_t end, size_t *at, sepax_error *error);
  void *context;
};

/* Answer all, without the lock of Python. Signals are looked at a few times a second, so Ctrl-C
 * ends a long call. False with an exception; `named` is what a question is called there. */
bool core_run(const core_batch *batch, const char *named);

/* ---------------------------------------------------------- functions by file */

extern PyMethodDef core_body_methods[], core_batch_methods[], core_pair_methods[],
    core_grid_methods[], core_file_methods[], core_mechanism_methods[], core_machine_methods[],
    core_robot_methods[];

#endif
