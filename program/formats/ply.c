/* ply.c - PLY by assimp, which does not notice a file that is cut off. */
#include "formats/mesh_format_table.h"
#include "util/error.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

typedef struct {
  bool text, faces;
  uint64_t lines;          /* of all elements */
  uint64_t bytes;          /* of all elements before the one at hand */
  uint64_t count, element; /* of this one: how many, the bytes of each */
} head;

static uint64_t bytes_of(const char *type) {
  static const struct {
    const char *name;
    uint64_t bytes;
  } types[] = {{"char", 1},  {"uchar", 1},   {"int8", 1},   {"uint8", 1},
               {"short", 2}, {"ushort", 2},  {"int16", 2},  {"uint16", 2},
               {"int", 4},   {"uint", 4},    {"int32", 4},  {"uint32", 4},
               {"float", 4}, {"float32", 4}, {"double", 8}, {"float64", 8}};
  for (size_t n = 0; n < sizeof types / sizeof types[0]; n++) {
    if (strcmp(type, types[n].name) == 0) {
      return types[n].bytes;
    }
  }
  return 0;
}

/* A list is counted as one of a triangle. */
static bool read_property(head *h, const char *rest) {
  char type[3][16] = {"", "", ""};
  int words = sscanf(rest, "%15s %15s %15s", type[0], type[1], type[2]);
  bool list = words == 3 && strcmp(type[0], "list") == 0;
  uint64_t bytes = list ? bytes_of(type[1]) : bytes_of(type[0]);
  h->element += bytes + (list ? 3 * bytes_of(type[2]) : 0);
  return bytes > 0 && (!list || bytes_of(type[2]) > 0);
}

static bool read_element(head *h, const char *rest) {
  static const uint64_t most = (uint64_t)1 << 31;
  char name[32] = "";
  char digits[16] = "";
  if (sscanf(rest, "%31s %15[0-9]", name, digits) != 2) {
    return false;
  }
  h->bytes += h->count * h->element;
  h->count = strtoull(digits, NULL, 10);
  h->element = 0;
  h->lines += h->count;
  h->faces = h->faces || strcmp(name, "face") == 0;
  return h->count <= most;
}

/* The first 256 lines up to end_header. */
static bool read_head(head *h, FILE *in) {
  enum { LINES_MOST = 256 };
  char line[512];
  *h = (head){.text = false};
  for (int n = 0; n < LINES_MOST && fgets(line, sizeof line, in) != NULL; n++) {
    line[strcspn(line, "\r\n")] = '\0';
    if (strcmp(line, "end_header") == 0) {
      h->bytes += h->count * h->element;
      return h->faces;
    }
    h->text = h->text || strncmp(line, "format ascii", 12) == 0;
    bool right = n == 0                               ? strcmp(line, "ply") == 0
                 : strncmp(line, "element ", 8) == 0  ? read_element(h, line + 8)
                 : strncmp(line, "property ", 9) == 0 ? read_property(h, line + 9)
                                                      : true;
    if (!right) {
      return false;
    }
  }
  return false;
}

/* Lines with something on them, or bytes. */
static uint64_t count_behind(FILE *in, bool lines) {
  static const size_t block = 1 << 16;
  uint64_t count = 0;
  bool empty = true;
  char *bytes = sepax_allocate(block);
  size_t size = 0;
  while (bytes != NULL && (size = fread(bytes, 1, block, in)) > 0) {
    count += lines ? 0 : size;
    for (size_t n = 0; lines && n < size; n++) {
      bool blank = bytes[n] == ' ' || bytes[n] == '\t' || bytes[n] == '\r' || bytes[n] == '\n';
      count += empty && !blank;
      empty = bytes[n] == '\n' || (empty && blank);
    }
  }
  sepax_release(bytes);
  return count;
}

/* The file has a head, and behind it as many lines (of text) or bytes at least as its elements,
 * lists being those of triangles, take. */
static bool is_whole(const char *path, sepax_error *error) {
  FILE *in = fopen(path, "rb");
  if (in == NULL) {
    return sepax_fail(error, SEPAX_ERROR_FILE, "%.300s: %s; give a readable file", path,
                      strerror(errno));
  }
  head h;
  bool ok = read_head(&h, in) ||
            sepax_fail(error, SEPAX_ERROR_FORMAT,
                       "%.300s: no head of a PLY file with faces; export it again", path);
  if (ok) {
    uint64_t wanted = h.text ? h.lines : h.bytes;
    uint64_t found = count_behind(in, h.text);
    ok = found >= wanted || sepax_fail(error, SEPAX_ERROR_FORMAT,
                                       "%.240s: truncated: %llu %s behind the head, not %llu; "
                                       "export it again",
                                       path, (unsigned long long)found, h.text ? "lines" : "bytes",
                                       (unsigned long long)wanted);
  }
  fclose(in);
  return ok;
}

bool mesh_read_ply(sepax_soup *mesh, const char *path, sepax_error *error) {
  *mesh = (sepax_soup){0};
  return is_whole(path, error) && mesh_read_assimp(mesh, path, error);
}
