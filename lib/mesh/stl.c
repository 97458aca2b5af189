/* SPDX-License-Identifier: MIT */
/* stl.c - STL files, text and binary, read and written whole. */
#include "mesh/stl.h"
#include "util/bytes.h"
#include "util/error.h"
#include "util/plain_numbers.h"
#include "util/text.h"
#include "util/write_file.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* The least number that rounds to infinity in binary32. */
static const double binary32_end = 0x1.ffffffp127;

static const size_t bytes_most = SIZE_MAX / 4;

void sepax_soup_free(sepax_soup *soup) {
  sepax_release(soup->facet);
  sepax_release(soup->normal);
  *soup = (sepax_soup){0};
}

bool sepax_stl_read(sepax_soup *soup, const char *path, bool normals, sepax_error *error) {
  text_bytes file;
  *soup = (sepax_soup){0};
  if (!sepax__text_read(&file, path, bytes_most, error)) {
    return false;
  }
  plain_numbers plain = plain_numbers_begin();
  bool ok = sepax__stl_parse(soup, file.bytes, file.size, path, normals, SIZE_MAX, error);
  plain_numbers_end(plain);
  sepax_release(file.bytes);
  return ok;
}

/* ----------------------------------------------------------------- writing */

static stl_numbers numbers_of(const sepax_soup *soup, size_t k) {
  stl_numbers n = {{0}};
  if (soup->normal != NULL) {
    memcpy(n.of, soup->normal[k], sizeof soup->normal[k]);
  }
  memcpy(n.of + 3, soup->facet[k].v, sizeof soup->facet[k].v);
  return n;
}

static const char *number_name(int i) { return i < 3 ? "normal" : "coordinate"; }

static bool has_area(const double v[3][3]) {
  double e[3];
  double f[3];
  for (int i = 0; i < 3; i++) {
    e[i] = v[1][i] - v[0][i];
    f[i] = v[2][i] - v[0][i];
  }
  return e[1] * f[2] != e[2] * f[1] || e[2] * f[0] != e[0] * f[2] || e[0] * f[1] != e[1] * f[0];
}

/* True if a facet with an area has none after rounding to binary32. */
static bool flattened(const sepax_facet *facet) {
  double rounded[3][3];
  for (int k = 0; k < 3; k++) {
    for (int i = 0; i < 3; i++) {
      rounded[k][i] = (double)(float)facet->v[k][i];
    }
  }
  return has_area(facet->v) && !has_area((const double(*)[3])rounded);
}

static bool fits_file(const sepax_soup *soup, const char *path, bool ascii, sepax_error *error) {
  if (soup->count == 0) {
    return sepax__stl_fail(error, SEPAX_ERROR_ARGUMENT, path,
                           "not written: the mesh has no facets");
  }
  if (!ascii && soup->count > UINT32_MAX) {
    return sepax__stl_fail(error, SEPAX_ERROR_ARGUMENT, path,
                           "not written: too many facets for binary; write text");
  }
  for (size_t k = 0; k < soup->count; k++) {
    const stl_numbers all = numbers_of(soup, k);
    for (int i = 0; i < STL_FACET_NUMBERS; i++) {
      double number = all.of[i];
      if (!isfinite(number)) {
        return sepax__stl_fail(error, SEPAX_ERROR_ARGUMENT, path,
                               "not written: facet %zu: %s is %s; mend the mesh", k, number_name(i),
                               sepax__stl_flaw(number));
      }
      if (!ascii && fabs(number) >= binary32_end) {
        return sepax__stl_fail(error, SEPAX_ERROR_ARGUMENT, path,
                               "not written: facet %zu: %s %g does not fit binary32; write text", k,
                               number_name(i), number);
      }
    }
    if (!ascii && flattened(&soup->facet[k])) {
      return sepax__stl_fail(error, SEPAX_ERROR_ARGUMENT, path,
                             "not written: facet %zu has no area in binary32; write text or move "
                             "nearer to the origin",
                             k);
    }
  }
  return true;
}

static bool write_text(FILE *out, const void *context) {
  const sepax_soup *soup = context;
  bool ok = fputs("solid sepax\n", out) != EOF;
  for (size_t k = 0; ok && k < soup->count; k++) {
    const stl_numbers all = numbers_of(soup, k);
    const double *n = all.of;
    ok = fprintf(out, "  facet normal %.17g %.17g %.17g\n    outer loop\n", n[0], n[1], n[2]) > 0;
    for (int i = 0; ok && i < 3; i++) {
      const double *v = n + 3 + 3 * i;
      ok = fprintf(out, "      vertex %.17g %.17g %.17g\n", v[0], v[1], v[2]) > 0;
    }
    ok = ok && fputs("    endloop\n  endfacet\n", out) != EOF;
  }
  return ok && fputs("endsolid sepax\n", out) != EOF;
}

static bool write_binary(FILE *out, const void *context) {
  const sepax_soup *soup = context;
  char head[STL_HEAD_BYTES] = "sepax, binary STL";
  bytes_put32(head + STL_TITLE_BYTES, (uint32_t)soup->count);
  bool ok = fwrite(head, sizeof head, 1, out) == 1;
  for (size_t k = 0; ok && k < soup->count; k++) {
    char record[STL_FACET_BYTES] = {0};
    const stl_numbers all = numbers_of(soup, k);
    for (int i = 0; i < STL_FACET_NUMBERS; i++) {
      bytes_put_float(record + 4 * i, (float)all.of[i]);
    }
    ok = fwrite(record, sizeof record, 1, out) == 1;
  }
  return ok;
}

bool sepax_stl_write(const sepax_soup *soup, const char *path, bool ascii, sepax_error *error) {
  plain_numbers plain = plain_numbers_begin();
  bool ok = fits_file(soup, path, ascii, error) &&
            sepax_write_file(path, ascii ? write_text : write_binary, soup, error);
  plain_numbers_end(plain);
  return ok;
}
