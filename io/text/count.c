/* SPDX-License-Identifier: MIT */
/* count.c - how many faces a text has, by its bytes alone; shares nothing with the readers. */
#include "reader/format_table.h"

#include <ctype.h>
#include <string.h>
#include <strings.h>

/* Lines that begin with f or fo. A line goes on where a backslash is its last character. */
bool sepax__obj_count(const mesh_builder *b, size_t *faces) {
  enum { BEGINS, GOES_ON } state = BEGINS;
  const char *end = b->bytes + b->size;
  size_t count = 0;
  char before = '\0';
  for (const char *c = b->bytes; c < end; before = *c++) {
    if (*c == '\n' || *c == '\r') {
      bool joined =
          before == '\\' || (*c == '\n' && before == '\r' && c - b->bytes >= 2 && c[-2] == '\\');
      state = joined ? state : BEGINS;
    } else if (state == BEGINS && (isspace((unsigned char)*c) || *c == '\\')) {
      continue;
    } else if (state == BEGINS) {
      if (c == b->bytes && b->size >= 3 && memcmp(c, "\xef\xbb\xbf", 3) == 0) {
        c += 2;
        continue;
      }
      size_t length = *c == 'f' && c[1] == 'o' ? 2 : 1;
      char next = c[length] == '\\' ? c[length + 1] : c[length]; /* as a line's end joins */
      count += *c == 'f' && (isspace((unsigned char)next) || next == '\0');
      state = GOES_ON;
    }
  }
  *faces = count;
  return true;
}

/* How many the line from c declares, where it begins with "element NAME"; else 0. */
static size_t declared(const char *c, const char *name) {
  static const char blanks[] = " \t\v\f";
  size_t length = strlen(name);
  size_t count = 0;
  const char *word = c + 7;
  if (strncmp(c, "element", 7) != 0) {
    return 0;
  }
  word += strspn(word, blanks);
  if (strncmp(word, name, length) == 0 && isspace((unsigned char)word[length])) {
    for (word += length + strspn(word + length, blanks); isdigit((unsigned char)*word); word++) {
      count = 10 * count + (size_t)(*word - '0');
    }
  }
  return count;
}

/* The faces and strips that the head declares. */
bool sepax__ply_count(const mesh_builder *b, size_t *faces) {
  const char *end = b->bytes + b->size;
  bool begins = true; /* c is before the first word of its line */
  size_t count = 0;
  for (const char *c = b->bytes; c < end; c++) {
    bool blank = isspace((unsigned char)*c);
    if (begins && strncmp(c, "end_header", 10) == 0) {
      break;
    }
    count += begins && !blank ? declared(c, "face") + declared(c, "tristrips") : 0;
    begins = *c == '\n' || *c == '\r' || (begins && blank);
  }
  *faces = count;
  return true;
}

/* How often the word endfacet is in a text, with this letter in its middle: f and F are rare enough
 * that to look for them costs little. */
static size_t count_words(const mesh_builder *b, char letter) {
  enum { BEFORE = 3, LENGTH = sizeof "endfacet" - 1 };
  const char *end = b->bytes + b->size;
  size_t count = 0;
  for (const char *f = b->bytes; (f = memchr(f, letter, (size_t)(end - f))) != NULL; f++) {
    const char *c = f - BEFORE;
    count += f - b->bytes >= BEFORE && strncasecmp(c, "endfacet", LENGTH) == 0 &&
             (c == b->bytes || isspace((unsigned char)c[-1])) &&
             (c + LENGTH == end || isspace((unsigned char)c[LENGTH]));
  }
  return count;
}

/* A binary file is as long as its head says. */
bool sepax__stl_count(const mesh_builder *b, size_t *faces) {
  if (b->size > 84 && (b->size - 84) % 50 == 0) {
    const unsigned char *head = (const unsigned char *)b->bytes + 80;
    uint64_t said = head[0] + 256ULL * (head[1] + 256ULL * (head[2] + 256ULL * head[3]));
    if (said == (b->size - 84) / 50) {
      *faces = (size_t)said;
      return true;
    }
  }
  *faces = count_words(b, 'f') + count_words(b, 'F');
  return true;
}
