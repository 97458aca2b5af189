/* SPDX-License-Identifier: MIT */
/* threemf.c - 3MF files: the model as text, from which the archive is made, so that the fuzzer has
 * the XML to itself; text behind a byte of zero is a second model, whose part the first may name.
 * What begins with "PK" is an archive. */
#include "fuzz/mesh.h"

#include <string.h>

typedef struct {
  const char *name;
  const uint8_t *data;
  size_t size, offset;
  uint32_t crc;
} part;

enum { PARTS_MOST = 5, BESIDE = 4096 };

static const char types[] =
    "<Types xmlns='http://schemas.openxmlformats.org/package/2006/content-types'>"
    "<Default Extension='rels' "
    "ContentType='application/vnd.openxmlformats-package.relationships+xml'/>"
    "<Default Extension='model' "
    "ContentType='application/vnd.ms-package.3dmanufacturing-3dmodel+xml'/></Types>";
static const char root[] =
    "<Relationships xmlns='http://schemas.openxmlformats.org/package/2006/relationships'>"
    "<Relationship Target='/3D/3dmodel.model' Id='r' "
    "Type='http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel'/></Relationships>";
static const char beside[] =
    "<Relationships xmlns='http://schemas.openxmlformats.org/package/2006/relationships'>"
    "<Relationship Target='/3D/2.model' Id='r' "
    "Type='http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel'/></Relationships>";

static uint32_t crc(const uint8_t *data, size_t size) {
  static uint32_t table[256];
  if (table[1] == 0) {
    for (uint32_t n = 0; n < 256; n++) {
      table[n] = n;
      for (int bit = 0; bit < 8; bit++) {
        table[n] = table[n] >> 1 ^ ((table[n] & 1) * 0xedb88320U);
      }
    }
  }
  uint32_t sum = ~0U;
  for (size_t n = 0; n < size; n++) {
    sum = sum >> 8 ^ table[(sum ^ data[n]) & 255];
  }
  return ~sum;
}

static uint8_t *put(uint8_t *at, uint32_t value, int bytes) {
  for (int n = 0; n < bytes; n++) {
    *at++ = (uint8_t)(n < 4 ? value >> 8 * n & 255 : 0);
  }
  return at;
}

/* Version, flags, method (stored), time, date, CRC, sizes, lengths: the same in both heads. */
static uint8_t *put_head(uint8_t *at, const part *p) {
  at = put(at, 20, 2);
  at = put(at, 0, 8);
  at = put(at, p->crc, 4);
  at = put(at, (uint32_t)p->size, 4);
  at = put(at, (uint32_t)p->size, 4);
  at = put(at, (uint32_t)strlen(p->name), 2);
  return put(at, 0, 2);
}

static uint8_t *put_bytes(uint8_t *at, const void *bytes, size_t size) {
  memcpy(at, bytes, size);
  return at + size;
}

/* A zip archive of stored parts. Returns its size. */
static size_t archive(uint8_t *zip, part *of, int parts) {
  uint8_t *at = zip;
  for (int n = 0; n < parts; n++) {
    of[n].crc = crc(of[n].data, of[n].size);
    of[n].offset = (size_t)(at - zip);
    at = put(at, 0x04034b50, 4);
    at = put_head(at, &of[n]);
    at = put_bytes(at, of[n].name, strlen(of[n].name));
    at = put_bytes(at, of[n].data, of[n].size);
  }
  uint32_t directory = (uint32_t)(at - zip);
  for (int n = 0; n < parts; n++) {
    at = put(at, 0x02014b50, 4);
    at = put(at, 20, 2);
    at = put_head(at, &of[n]);
    at = put(at, 0, 10); /* comment, disk, attributes */
    at = put(at, (uint32_t)of[n].offset, 4);
    at = put_bytes(at, of[n].name, strlen(of[n].name));
  }
  uint32_t size = (uint32_t)(at - zip) - directory;
  at = put(at, 0x06054b50, 4);
  at = put(at, 0, 4);
  at = put(at, (uint32_t)parts, 2);
  at = put(at, (uint32_t)parts, 2);
  at = put(at, size, 4);
  at = put(at, directory, 4);
  at = put(at, 0, 2);
  return (size_t)(at - zip);
}

static const uint8_t *text(const char *words) { return (const uint8_t *)words; }

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
  if (size >= 2 && memcmp(data, "PK", 2) == 0) {
    fuzz_mesh(data, size, "input.3mf");
    return 0;
  }
  const uint8_t *end = size == 0 ? NULL : memchr(data, '\0', size);
  size_t first = end == NULL ? size : (size_t)(end - data);
  part of[PARTS_MOST] = {
      {.name = "[Content_Types].xml", .data = text(types), .size = sizeof types - 1},
      {.name = "_rels/.rels", .data = text(root), .size = sizeof root - 1},
      {.name = "3D/3dmodel.model", .data = data, .size = first},
      {.name = "3D/_rels/3dmodel.model.rels", .data = text(beside), .size = sizeof beside - 1},
      {.name = "3D/2.model", .data = data + first + 1},
  };
  if (end != NULL) {
    of[4].size = size - first - 1;
  }
  uint8_t *zip = malloc(size + BESIDE);
  REQUIRE(zip != NULL);
  size_t length = archive(zip, of, end == NULL ? 3 : PARTS_MOST);
  fuzz_mesh(zip, length, "input.3mf");
  free(zip);
  return 0;
}
