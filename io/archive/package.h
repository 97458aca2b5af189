/* SPDX-License-Identifier: MIT */
/* package.h - the parts of a package: an archive by libzip, its relationships (private). */
#ifndef SEPAX_PACKAGE_H
#define SEPAX_PACKAGE_H

#include "reader/builder.h"

#include <zip.h>

enum { NO_PART = -1 };

/* An entry of the archive: its name without a '/' before it, and what it unpacks to. */
typedef struct {
  const char *name;
  size_t entry;
  zip_uint64_t size, packed;
  bool encrypted;
  bool is_model, was_read; /* set by the reader */
} package_part;

/* The parts, sorted by name without regard to case, because names of parts have no case. */
typedef struct {
  mesh_builder *b;
  zip_t *zip;
  package_part *part;
  size_t parts;
  zip_uint64_t unpacked; /* bytes of the parts that were unpacked */
} package;

/* Open the archive in the builder's bytes, which must stay. Free it with package_close, also on
 * failure. */
bool sepax__package_open(package *p, mesh_builder *b);
void sepax__package_close(package *p);

/* Find the part of this name, an absolute path of the package. NO_PART if there is none. */
long sepax__package_find(const package *p, const char *path);

/* Takes a piece of a part. If it returns false, then it has set the error. */
typedef bool part_taker(void *context, const char *piece, size_t size);

/* Give all bytes of a part to `take`, piece by piece. Refuses what is encrypted, or unpacks to too
 * much. */
bool sepax__package_stream(package *p, size_t part, part_taker *take, void *context);

/* "PATH, part NAME[:LINE]: ..."; false. */
bool sepax__package_fail(const package *p, size_t part, int line, const char *format, ...)
    __attribute__((format(printf, 4, 5)));

#endif
