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

enum { WORD_LENGTH = sizeof "endfacet" - 1 };

/* How often the word endfacet is between two places, by skips of up to its length. */
static size_t count_words(const char *from, const char *to, const unsigned char skip[256]) {
  size_t count = 0;
  for (const char *c = from; to - c >= WORD_LENGTH;) {
    count += (*c == 'e' || *c == 'E') && strncasecmp(c, "endfacet", WORD_LENGTH) == 0 &&
             (c == from || isspace((unsigned char)c[-1])) &&
             (c + WORD_LENGTH == to || isspace((unsigned char)c[WORD_LENGTH]));
    c += skip[(unsigned char)c[WORD_LENGTH - 1]];
  }
  return count;
}

static bool begins_name(const char *c) {
  return (*c == 's' || *c == 'S' || *c == 'e' || *c == 'E') &&
         (strncasecmp(c, "solid", 5) == 0 || strncasecmp(c, "endsolid", 8) == 0);
}

/* A binary file is as long as its head says; of a text, words in lines that have no name. */
bool sepax__stl_count(const mesh_builder *b, size_t *faces) {
  unsigned char skip[256];
  const char *end = b->bytes + b->size;
  char ends_line = memchr(b->bytes, '\n', b->size) != NULL ? '\n' : '\r';
  if (b->size > 84 && (b->size - 84) % 50 == 0) {
    const unsigned char *head = (const unsigned char *)b->bytes + 80;
    uint64_t said = head[0] + 256ULL * (head[1] + 256ULL * (head[2] + 256ULL * head[3]));
    if (said == (b->size - 84) / 50) {
      *faces = (size_t)said;
      return true;
    }
  }
  memset(skip, WORD_LENGTH, sizeof skip);
  for (size_t n = 0; n + 1 < WORD_LENGTH; n++) {
    skip[(unsigned char)"endfacet"[n]] = (unsigned char)(WORD_LENGTH - 1 - n);
    skip[(unsigned char)"ENDFACET"[n]] = (unsigned char)(WORD_LENGTH - 1 - n);
  }
  *faces = 0;
  for (const char *line = b->bytes; line < end;) {
    while (line < end && isspace((unsigned char)*line)) {
      line++;
    }
    line += *line == '\xef' ? 3 : 0;
    const char *next = memchr(line, ends_line, (size_t)(end - line));
    next = next != NULL ? next : end;
    if (begins_name(line)) {
      next = line + strcspn(line, "\r\n");
    } else {
      *faces += count_words(line, next, skip);
    }
    line = next + 1;
  }
  return true;
}
