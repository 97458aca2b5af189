/* SPDX-License-Identifier: MIT */
/* dae_count.c - how many faces a COLLADA document has, by its bytes.
 *
 * It shares nothing with the reader: no libxml2, no tree. It adds the counts of the tags of
 * primitives, with any prefix, outside of comments, CDATA and processing instructions. */
#include "reader/format_table.h"

#include <string.h>

static const char blanks[] = " \t\r\n";

/* The place after the first `end` from here on, or the end of the text. */
static const char *behind(const char *c, const char *end) {
  const char *found = strstr(c, end);
  return found != NULL ? found + strlen(end) : c + strlen(c);
}

static size_t whole(const char *c) {
  size_t number = 0;
  for (c += strspn(c, blanks); *c >= '0' && *c <= '9' && number < SIZE_MAX / 100; c++) {
    number = 10 * number + (size_t)(*c - '0');
  }
  return number;
}

/* The attributes of a tag from here on: what `count` says, added where it matters. Returns where
 * the tag ends. */
static const char *scan_attributes(const char *c, bool matters, size_t *faces) {
  while (*c != '\0' && *c != '>') {
    const char *name = c + strspn(c, blanks);
    const char *name_end = name + strcspn(name, "= \t\r\n>/");
    c = name_end + strspn(name_end, blanks);
    if (*c != '=') {
      c += c == name && *c != '\0' && *c != '>';
      continue;
    }
    c += 1 + strspn(c + 1, blanks);
    char quote[2] = {*c, '\0'};
    if (*c != '"' && *c != '\'') {
      continue;
    }
    if (matters && name_end - name == 5 && memcmp(name, "count", 5) == 0) {
      *faces += whole(c + 1);
    }
    c = behind(c + 1, quote);
  }
  return c;
}

static bool is_primitive(const char *name, size_t length) {
  static const char *const names[] = {"triangles", "polylist", "polygons", "tristrips", "trifans"};
  for (size_t n = 0; n < sizeof names / sizeof names[0]; n++) {
    if (strlen(names[n]) == length && memcmp(names[n], name, length) == 0) {
      return true;
    }
  }
  return false;
}

bool sepax__dae_count(const mesh_builder *b, size_t *faces) {
  *faces = 0;
  for (const char *c = strchr(b->bytes, '<'); c != NULL && *c != '\0'; c = strchr(c, '<')) {
    if (strncmp(c, "<!--", 4) == 0) {
      c = behind(c + 4, "-->");
    } else if (strncmp(c, "<![CDATA[", 9) == 0) {
      c = behind(c, "]]>");
    } else if (c[1] == '?') {
      c = behind(c, "?>");
    } else {
      size_t length = strcspn(c + 1, " \t\r\n/>");
      const char *colon = memchr(c + 1, ':', length);
      const char *name = colon != NULL ? colon + 1 : c + 1;
      bool matters = is_primitive(name, length - (size_t)(name - c - 1));
      c = scan_attributes(c + 1 + length, matters, faces);
    }
  }
  return true;
}
