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
      count += *c == 'f' && (isspace((unsigned char)c[length]) || c[length] == '\0');
      state = GOES_ON;
    }
  }
  *faces = count;
  return true;
}

/* The number behind "element NAME" at the beginning of a line of the head; 0 without one. */
static size_t declared(const char *head, const char *end, const char *name) {
  size_t length = strlen(name);
  size_t count = 0;
  for (const char *c = head; c < end; c++) {
    if ((c[-1] == '\n' || c[-1] == '\r') && strncmp(c, "element", 7) == 0) {
      const char *word = c + 7 + strspn(c + 7, " \t");
      if (strncmp(word, name, length) == 0 && (word[length] == ' ' || word[length] == '\t')) {
        for (word += length + strspn(word + length, " \t"); isdigit((unsigned char)*word); word++) {
          count = 10 * count + (size_t)(*word - '0');
        }
      }
    }
  }
  return count;
}

bool sepax__ply_count(const mesh_builder *b, size_t *faces) {
  const char *head = b->bytes + 4;
  const char *end = strstr(head, "end_header");
  end = end != NULL ? end : head;
  *faces = declared(head, end, "face") + declared(head, end, "tristrips");
  return true;
}

/* Is the line of c one that begins with solid or endsolid, behind which there is a name? No line
 * longer than that has one. */
static bool in_name(const char *c, const char *begin) {
  enum { LINE_MOST = 1000 };
  const char *line = c;
  while (line > begin && c - line < LINE_MOST && line[-1] != '\n' && line[-1] != '\r') {
    line--;
  }
  while (line < c && isspace((unsigned char)*line)) {
    line++;
  }
  return line < c && (strncasecmp(line, "solid", 5) == 0 || strncasecmp(line, "endsolid", 8) == 0);
}

/* How often the word endfacet is in a text, not in names, with this letter in its middle: f and F
 * are rare enough that to look for them costs little. */
static size_t count_words(const mesh_builder *b, char letter) {
  enum { BEFORE = 3, LENGTH = sizeof "endfacet" - 1 };
  const char *end = b->bytes + b->size;
  size_t count = 0;
  for (const char *f = b->bytes; (f = memchr(f, letter, (size_t)(end - f))) != NULL; f++) {
    const char *c = f - BEFORE;
    bool found = f - b->bytes >= BEFORE && strncasecmp(c, "endfacet", LENGTH) == 0 &&
                 (c == b->bytes || isspace((unsigned char)c[-1])) &&
                 (c + LENGTH == end || isspace((unsigned char)c[LENGTH]));
    count += found && !in_name(c, b->bytes);
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
