/* SPDX-License-Identifier: MIT */
/* package.c - the parts of a package: an archive by libzip. */
#include "archive/package.h"

#include <stdarg.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

/* A part may unpack to 64 MiB or to a hundred times its packed length, and all parts together to 1
 * GiB. */
static const zip_uint64_t part_bytes_free = (zip_uint64_t)64 << 20;
static const zip_uint64_t all_bytes_most = (zip_uint64_t)1 << 30;
enum { PACKED_MOST = 100, PARTS_MOST = 100000 };

bool sepax__package_fail(const package *p, size_t part, int line, const char *format, ...) {
  char detail[240];
  char number[16] = "";
  va_list args;
  va_start(args, format);
  vsnprintf(detail, sizeof detail, format, args);
  va_end(args);
  if (line > 0) {
    snprintf(number, sizeof number, ":%d", line);
  }
  return sepax_fail(p->b->error, SEPAX_ERROR_FORMAT, "%.240s, part %.80s%s: %s", p->b->path,
                    p->part[part].name, number, detail);
}

static int compare_parts(const void *left, const void *right) {
  return strcasecmp(((const package_part *)left)->name, ((const package_part *)right)->name);
}

static bool list_part(package *p, size_t entry) {
  zip_stat_t stat;
  zip_stat_init(&stat);
  if (zip_stat_index(p->zip, entry, 0, &stat) != 0 || (stat.valid & ZIP_STAT_NAME) == 0 ||
      (stat.valid & ZIP_STAT_SIZE) == 0 || (stat.valid & ZIP_STAT_COMP_SIZE) == 0) {
    return sepax__builder_fail(p->b, "entry %zu of the archive is damaged; pack it again", entry);
  }
  size_t length = strlen(stat.name);
  if (length > 0 && stat.name[length - 1] != '/') { /* a name with '/' at its end is a folder */
    p->part[p->parts++] = (package_part){
        .name = stat.name[0] == '/' ? stat.name + 1 : stat.name,
        .entry = entry,
        .size = stat.size,
        .packed = stat.comp_size,
        .encrypted =
            (stat.valid & ZIP_STAT_ENCRYPTION_METHOD) != 0 && stat.encryption_method != ZIP_EM_NONE,
    };
  }
  return true;
}

static bool list_parts(package *p) {
  zip_int64_t entries = zip_get_num_entries(p->zip, 0);
  if (entries > PARTS_MOST) {
    return sepax_fail(p->b->error, SEPAX_ERROR_LIMIT,
                      "%.240s: more than %d entries in the archive; leave out what is no mesh",
                      p->b->path, (int)PARTS_MOST);
  }
  p->part = sepax_allocate((size_t)(entries + 1) * sizeof *p->part);
  if (p->part == NULL) {
    return sepax__builder_fail_memory(p->b);
  }
  for (size_t n = 0; n < (size_t)entries; n++) {
    if (!list_part(p, n)) {
      return false;
    }
  }
  qsort(p->part, p->parts, sizeof *p->part, compare_parts);
  for (size_t n = 1; n < p->parts; n++) {
    if (compare_parts(&p->part[n - 1], &p->part[n]) == 0) {
      return sepax__builder_fail(p->b, "two parts have the name %.80s; leave one of them out",
                                 p->part[n].name);
    }
  }
  return true;
}

bool sepax__package_open(package *p, mesh_builder *b) {
  *p = (package){.b = b};
  zip_error_t error;
  zip_error_init(&error);
  zip_source_t *source = zip_source_buffer_create(b->bytes, b->size, 0, &error);
  p->zip = source != NULL ? zip_open_from_source(source, ZIP_RDONLY, &error) : NULL;
  if (p->zip == NULL) {
    zip_source_free(source);
    sepax__builder_fail(b, "the archive cannot be opened (%.80s); pack it again",
                        zip_error_strerror(&error));
  }
  zip_error_fini(&error);
  return p->zip != NULL && list_parts(p);
}

void sepax__package_close(package *p) {
  if (p->zip != NULL) {
    zip_discard(p->zip);
  }
  sepax_release(p->part);
  *p = (package){.b = p->b};
}

static int hexadecimal(char c) {
  const char *digits = "0123456789abcdef";
  const char *at = c != '\0' ? strchr(digits, c | ('a' ^ 'A')) : NULL;
  return at != NULL ? (int)(at - digits) : -1;
}

/* Decode references, which write some characters of a name as %20. */
static void decode(char *text) {
  char *to = text;
  for (const char *from = text; *from != '\0'; from++) {
    int high = from[0] == '%' ? hexadecimal(from[1]) : -1;
    int low = high >= 0 ? hexadecimal(from[2]) : -1;
    *to++ = low >= 0 && 16 * high + low != 0 ? (char)(16 * high + low) : *from;
    from += low >= 0 ? 2 : 0;
  }
  *to = '\0';
}

static long find_name(const package *p, const char *name) {
  package_part key = {.name = name};
  const package_part *found = bsearch(&key, p->part, p->parts, sizeof key, compare_parts);
  return found != NULL ? found - p->part : NO_PART;
}

long sepax__package_find(const package *p, const char *path) {
  char name[1024];
  path += path[0] == '/';
  long found = find_name(p, path);
  if (found == NO_PART && strlen(path) < sizeof name) {
    strcpy(name, path);
    decode(name);
    found = find_name(p, name);
  }
  return found;
}

static bool size_right(package *p, size_t part) {
  const package_part *it = &p->part[part];
  if (it->encrypted) {
    return sepax__package_fail(p, part, 0, "it is encrypted; save the file without a password");
  }
  if (it->size > part_bytes_free && it->size / PACKED_MOST > it->packed) {
    return sepax__package_fail(p, part, 0,
                               "it would unpack to more than %d times its length; pack it again",
                               (int)PACKED_MOST);
  }
  p->unpacked += it->size < all_bytes_most ? it->size : all_bytes_most + 1;
  return p->unpacked <= all_bytes_most ||
         sepax__package_fail(p, part, 0, "the parts would unpack to more than 1 GiB; simplify it");
}

/* Unpack a part piece by piece. False also if `take` refuses a piece; then *refused is true. */
static bool stream_file(package *p, size_t part, zip_file_t *file, part_taker *take, void *context,
                        bool *refused) {
  enum { PIECE = 1 << 16 };
  char *piece = sepax_allocate(PIECE);
  if (piece == NULL) {
    *refused = true;
    return sepax__builder_fail_memory(p->b);
  }
  /* the length in the header was checked, so no more bytes may come */
  zip_uint64_t left = p->part[part].size;
  zip_int64_t got = 0;
  while (!*refused && (got = zip_fread(file, piece, PIECE)) > 0 && (zip_uint64_t)got <= left) {
    left -= (zip_uint64_t)got;
    *refused = !take(context, piece, (size_t)got);
  }
  sepax_release(piece);
  return !*refused && got == 0 && left == 0;
}

bool sepax__package_stream(package *p, size_t part, part_taker *take, void *context) {
  if (!size_right(p, part)) {
    return false;
  }
  zip_file_t *file = zip_fopen_index(p->zip, p->part[part].entry, 0);
  if (file == NULL) {
    return sepax__package_fail(p, part, 0, "it cannot be unpacked (%.80s); pack it again",
                               zip_strerror(p->zip));
  }
  bool refused = false;
  bool ok = stream_file(p, part, file, take, context, &refused);
  zip_fclose(file);
  return ok ||
         (!refused && sepax__package_fail(p, part, 0, "it is damaged or cut off; pack it again"));
}
