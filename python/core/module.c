/* SPDX-License-Identifier: MIT */
/* module.c - the module sepax._core: failures, versions, and the list of all functions. */
#include "core.h"
#include "reader/libraries.h"
#include "util/threads.h"

enum { TABLES = 8, CODES = 8, FUNCTIONS_MOST = 64 };

/* The exceptions of the package, by the code of the error. */
static PyObject *exceptions[CODES];

PyObject *core_failed_at(const char *before, const sepax_error *error) {
  const size_t code = (size_t)error->code;
  PyObject *kind = code < CODES && exceptions[code] != NULL ? exceptions[code] : PyExc_RuntimeError;
  PyErr_Format(kind, "%s%s", before, error->text);
  return NULL;
}

PyObject *core_failed(const sepax_error *error) { return core_failed_at("", error); }

static PyObject *set_exceptions(PyObject *self, PyObject *arguments) {
  (void)self;
  for (Py_ssize_t n = 0; n < CODES && n < PyTuple_Size(arguments); n++) {
    PyObject *kind = PyTuple_GetItem(arguments, n);
    Py_XINCREF(kind);
    Py_XDECREF(exceptions[n]);
    exceptions[n] = kind;
  }
  Py_RETURN_NONE;
}

static PyObject *about(PyObject *self, PyObject *arguments) {
  (void)self;
  (void)arguments;
  return Py_BuildValue(
      "{s:s,s:s,s:O,s:O,s:n}", "version", sepax_version(), "simd", sepax_simd_name(SEPAX_SIMD_BEST),
      "libxml2", sepax__libxml2_here ? Py_True : Py_False, "libzip",
      sepax__libzip_here ? Py_True : Py_False, "threads", (Py_ssize_t)sepax__threads_here());
}

static PyMethodDef own_methods[] = {
    {"set_exceptions", set_exceptions, METH_VARARGS, "the exception of each code"},
    {"about", about, METH_NOARGS, "version, vector instructions, libraries"},
    {NULL, NULL, 0, NULL}};

static PyMethodDef methods[FUNCTIONS_MOST];

static struct PyModuleDef module = {.m_base = PyModuleDef_HEAD_INIT,
                                    .m_name = "_core",
                                    .m_doc = "The C library, for the package sepax alone.",
                                    .m_size = -1,
                                    .m_methods = methods};

PyMODINIT_FUNC PyInit__core(void) {
  PyMethodDef *const tables[] = {own_methods,        core_body_methods,      core_batch_methods,
                                 core_pair_methods,  core_grid_methods,      core_file_methods,
                                 core_robot_methods, core_mechanism_methods, core_machine_methods};
  size_t count = 0;
  for (size_t t = 0; t < sizeof tables / sizeof tables[0]; t++) {
    for (PyMethodDef *m = tables[t]; m->ml_name != NULL && count + 1 < FUNCTIONS_MOST; m++) {
      methods[count++] = *m;
    }
  }
  return PyModule_Create(&module);
}
