/* obj.c - a stub. */
#include "reader/format_table.h"

bool sepax__obj_is(const char *bytes, size_t size) {
  (void)bytes;
  (void)size;
  return false;
}

bool sepax__obj_read(mesh_builder *b, size_t *faces) {
  *faces = 0;
  return sepax__builder_fail(b, "stub");
}

bool sepax__obj_count(const mesh_builder *b, size_t *faces) {
  (void)b;
  *faces = 0;
  return true;
}
