/* mesh_formats.c - which reader of mesh_format_table.h reads a file, and the text that lists them.
 */
#include "formats/mesh_format_table.h"
#include "formats/confined.h"
#include "formats/formats.h"
#include "util/error.h"

#include <stdio.h>
#include <string.h>
#include <strings.h>

typedef struct {
  const char *name, *endings;
  mesh_reader *read;
  int libraries;
} mesh_format;

#define MESH_FORMAT_ROW(name, endings, reader, libraries) {name, endings, reader, libraries},
static const mesh_format formats[] = {MESH_FORMATS(MESH_FORMAT_ROW)};
enum { FORMATS = sizeof formats / sizeof formats[0] };

/* `endings` has one of `path`, in capitals or not, behind at least one other character. */
static bool ends_in(const char *path, const char *endings) {
  size_t length = strlen(path);
  for (const char *e = endings; *e != '\0'; e += strspn(e, " ")) {
    size_t size = strcspn(e, " ");
    if (length > size && strncasecmp(path + length - size, e, size) == 0) {
      return true;
    }
    e += size;
  }
  return false;
}

static const mesh_format *format_of(const char *path) {
  for (int n = 0; n < FORMATS; n++) {
    if (ends_in(path, formats[n].endings)) {
      return &formats[n];
    }
  }
  return NULL;
}

/* "STL, OBJ or PLY": the names of those that this build reads. */
static void list_formats(char list[80]) {
  const char *names[FORMATS] = {NULL};
  int count = 0;
  sepax_error unused;
  for (int n = 0; n < FORMATS; n++) {
    if (format_has(formats[n].libraries, "", formats[n].name, &unused)) {
      names[count++] = formats[n].name;
    }
  }
  size_t used = 0;
  for (int n = 0; n < count && used < 80; n++) {
    const char *between = n == 0 ? "" : n + 1 < count ? ", " : " or ";
    used += (size_t)snprintf(list + used, 80 - used, "%s%s", between, names[n]);
  }
}

bool format_mesh_is_stl(const char *path) {
  const mesh_format *format = format_of(path);
  return format != NULL && format->read == mesh_read_stl;
}

bool format_mesh_read(sepax_soup *mesh, const char *path, sepax_error *error) {
  const mesh_format *format = format_of(path);
  *mesh = (sepax_soup){0};
  if (format == NULL) {
    char list[80] = "";
    list_formats(list);
    return sepax_fail(error, SEPAX_ERROR_FORMAT, "%.300s: no mesh that is read; give %s", path,
                      list);
  }
  if (!format_has(format->libraries, path, format->name, error)) {
    return false;
  }
  return format->libraries != 0 ? confined_read(mesh, path, format->read, error)
                                : format->read(mesh, path, error);
}
