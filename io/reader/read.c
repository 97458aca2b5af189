/* SPDX-License-Identifier: MIT */
/* read.c - reads the mesh of a file: finds the format, calls its reader and checks the result. */
#include "reader/read.h"
#include "reader/format_table.h"
#include "util/options.h"
#include "util/plain_numbers.h"
#include "util/text.h"

#include <math.h>
#include <string.h>
#include <strings.h>

enum { TRIANGLES_MOST = 20000000 };

static const size_t bytes_most = (size_t)1 << 30;
static const double coordinate_most = 0x1p1000;

typedef struct {
  const char *name, *ending;
  bool (*is)(const char *bytes, size_t size);
  bool (*read)(mesh_builder *b, size_t *faces);
  bool (*count)(const mesh_builder *b, size_t *faces);
  int libraries;
} mesh_format;

#define MESH_FORMAT_ROW(name, ending, x, libraries) \
  {name, ending, sepax__##x##_is, sepax__##x##_read, sepax__##x##_count, libraries},
static const mesh_format formats[] = {MESH_FORMATS(MESH_FORMAT_ROW)};
enum { FORMATS = sizeof formats / sizeof formats[0] };

static const mesh_format *by_ending(const char *path) {
  size_t length = strlen(path);
  for (int n = 0; n < FORMATS; n++) {
    size_t size = strlen(formats[n].ending);
    if (length > size && strcasecmp(path + length - size, formats[n].ending) == 0) {
      return &formats[n];
    }
  }
  return NULL;
}

/* "STL, OBJ or PLY": the names of those that this build reads. */
static void list_formats(char list[80]) {
  const char *names[FORMATS] = {NULL};
  int count = 0;
  for (int n = 0; n < FORMATS; n++) {
    if (sepax__libraries_here(formats[n].libraries, "", "", NULL)) {
      names[count++] = formats[n].name;
    }
  }
  size_t used = 0;
  for (int n = 0; n < count && used < 80; n++) {
    const char *between = n == 0 ? "" : n + 1 < count ? ", " : " or ";
    used += (size_t)snprintf(list + used, 80 - used, "%s%s", between, names[n]);
  }
}

static const mesh_format *format_of(const mesh_builder *b) {
  if (b->size > 2 && memcmp(b->bytes, "\x1f\x8b", 2) == 0) {
    sepax__builder_fail(b, "compressed by gzip; unpack it with gunzip");
    return NULL;
  }
  for (int n = 0; n < FORMATS; n++) {
    if (formats[n].is(b->bytes, b->size)) {
      return &formats[n];
    }
  }
  const mesh_format *format = by_ending(b->path);
  if (format == NULL) {
    char list[80] = "";
    list_formats(list);
    if (b->size > 8 && memcmp(b->bytes, "sepaxSXT", 8) == 0) {
      sepax__builder_fail(
          b, "it is a tree of 'sepax tree', not a mesh; give the mesh that the tree was made from");
    } else {
      sepax__builder_fail(b, "not a mesh that can be read; give %s", list);
    }
  }
  return format;
}

/* Scale the coordinates to the unit of the result. */
static bool scale(mesh_builder *b) {
  double own = b->how.unit_mm > 0 ? b->how.unit_mm : b->account.unit_mm;
  double factor = own > 0 && b->how.result_mm > 0 ? own / b->how.result_mm : 1;
  if (factor == 1) {
    return true;
  }
  for (size_t n = 0; n < b->soup.count; n++) {
    for (int i = 0; i < 9; i++) {
      double *x = &b->soup.facet[n].v[i / 3][i % 3];
      *x *= factor;
      if (!(fabs(*x) <= coordinate_most)) {
        return sepax__builder_fail(b,
                                   "triangle %zu: a coordinate is beyond 2^1000 in the unit of "
                                   "the result; mend it, or give another unit",
                                   n);
      }
    }
  }
  return true;
}

static bool lengths_right(const mesh_builder *b) {
  const sepax_mesh_reading *how = &b->how;
  return (how->unit_mm >= 0 && how->unit_mm <= 1e12 && how->result_mm >= 0 &&
          how->result_mm <= 1e12) ||
         sepax_fail(b->error, SEPAX_ERROR_ARGUMENT,
                    "sepax_mesh_reading: a unit of %g mm, of %g mm for the result: give lengths of "
                    "0 ... 1e12 mm",
                    how->unit_mm, how->result_mm);
}

static bool read_mesh(mesh_builder *b, const mesh_format *format) {
  size_t read = 0;
  size_t counted = 0;
  sepax_mesh_account *account = &b->account;
  if (!format->read(b, &read) || !format->count(b, &counted)) {
    return false;
  }
  if (read != counted) {
    return sepax__builder_fail(b,
                               "%zu faces were read, but a second count finds %zu; export the mesh "
                               "again, and report this as an error of sepax",
                               read, counted);
  }
  account->faces = read;
  account->triangles = b->soup.count;
  if (b->soup.count == 0) {
    return sepax__builder_fail(b, "it has no triangles%s; give a mesh with a surface",
                               account->unplaced > 0 ? " that it places" : "");
  }
  if (b->how.normals && b->soup.normal == NULL) {
    return sepax__builder_fail(b, "normals of facets are read from STL alone; give an STL file, or "
                                  "have them computed");
  }
  return scale(b);
}

/* Put the options into b->how. False if they are wrong. */
static bool options_right(mesh_builder *b, const sepax_mesh_reading *how) {
  if (!sepax__options(&b->how, sizeof b->how, how, "sepax_mesh_reading", b->error) ||
      !lengths_right(b)) {
    return false;
  }
  b->how.most = b->how.most == 0 ? TRIANGLES_MOST : b->how.most;
  return true;
}

static bool parse(mesh_builder *b, sepax_soup *soup, sepax_mesh_account *account) {
  plain_numbers plain = plain_numbers_begin();
  const mesh_format *format = format_of(b);
  bool ok = format != NULL &&
            sepax__libraries_here(format->libraries, b->path, format->name, b->error) &&
            read_mesh(b, format);
  plain_numbers_end(plain);
  sepax_release(b->corner);
  sepax_release(b->triangle);
  sepax_release(b->sides.slot);
  if (!ok) {
    sepax_soup_free(&b->soup);
    return false;
  }
  b->account.format = format->name;
  *soup = b->soup;
  if (account != NULL) {
    *account = b->account;
  }
  return true;
}

static void begin(sepax_soup *soup, sepax_mesh_account *account) {
  *soup = (sepax_soup){0};
  if (account != NULL) {
    *account = (sepax_mesh_account){0};
  }
}

bool sepax__mesh_parse(sepax_soup *soup, sepax_mesh_account *account, const char *bytes,
                       size_t size, const char *name, const sepax_mesh_reading *how,
                       sepax_error *error) {
  mesh_builder b = {.path = name, .bytes = bytes, .size = size, .error = error};
  begin(soup, account);
  return options_right(&b, how) && parse(&b, soup, account);
}

bool sepax_mesh_read(sepax_soup *soup, sepax_mesh_account *account, const char *path,
                     const sepax_mesh_reading *how, sepax_error *error) {
  if (soup == NULL || path == NULL) {
    return sepax_fail(error, SEPAX_ERROR_ARGUMENT, "sepax_mesh_read: give a soup and a path");
  }
  mesh_builder b = {.path = path, .error = error};
  text_bytes file;
  begin(soup, account);
  if (!options_right(&b, how) || !sepax__text_read(&file, path, bytes_most, error)) {
    return false;
  }
  b.bytes = file.bytes;
  b.size = file.size;
  bool ok = parse(&b, soup, account);
  sepax_release(file.bytes);
  return ok;
}
