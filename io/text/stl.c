/* stl.c - STL, by the reader of libsepax. */
#include "mesh/stl.h"
#include "reader/format_table.h"
#include "util/bytes.h"

#include <string.h>
#include <strings.h>

bool sepax__stl_is(const char *bytes, size_t size) {
  bool binary =
      size >= STL_HEAD_BYTES &&
      size == STL_HEAD_BYTES + STL_FACET_BYTES * (uint64_t)bytes_get32(bytes + STL_TITLE_BYTES);
  return binary || strncasecmp(bytes + strspn(bytes, " \t\r\n"), "solid", 5) == 0;
}

bool sepax__stl_read(mesh_builder *b, size_t *faces) {
  bool ok = sepax__stl_parse(&b->soup, b->bytes, b->size, b->path, b->how.normals, b->error);
  *faces = b->soup.count;
  return ok;
}

bool sepax__stl_count(const mesh_builder *b, size_t *faces) {
  *faces = b->soup.count; /* stub */
  return true;
}
