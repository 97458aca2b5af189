/* SPDX-License-Identifier: MIT */
/* stl.c - STL, by the reader of libsepax. */
#include "mesh/stl.h"
#include "reader/format_table.h"
#include "util/bytes.h"

#include <string.h>
#include <strings.h>

static bool is_binary(const char *bytes, size_t size) {
  return size >= STL_HEAD_BYTES &&
         size == STL_HEAD_BYTES + STL_FACET_BYTES * (uint64_t)bytes_get32(bytes + STL_TITLE_BYTES);
}

bool sepax__stl_is(const char *bytes, size_t size) {
  const char *word = bytes + (size >= 3 && memcmp(bytes, "\xef\xbb\xbf", 3) == 0 ? 3 : 0);
  word += strspn(word, " \t\r\n");
  return is_binary(bytes, size) ||
         (strncasecmp(word, "solid", 5) == 0 && strchr(" \t\r\n", word[5]) != NULL);
}

/* Two bytes of each facet that are free for anything; some writers have colours in them. */
static bool name_attributes(mesh_builder *b) {
  size_t count = 0;
  for (size_t n = 0; n < b->soup.count; n++) {
    const char *bytes = b->bytes + STL_HEAD_BYTES + STL_FACET_BYTES * (n + 1) - 2;
    count += bytes[0] != 0 || bytes[1] != 0;
  }
  return sepax__builder_other(b, "facet attributes", count);
}

bool sepax__stl_read(mesh_builder *b, size_t *faces) {
  if (!sepax__stl_parse(&b->soup, b->bytes, b->size, b->path, b->how.normals, b->how.most,
                        b->error)) {
    return false;
  }
  *faces = b->soup.count;
  return sepax__builder_within(b) && (!is_binary(b->bytes, b->size) || name_attributes(b));
}
