/* SPDX-License-Identifier: MIT */
/* threemf_count.c - how many triangles a 3MF file has, by its bytes.
 *
 * It shares nothing with the reader but libzip: no libxml2, no relationships, no names of parts. A
 * part counts where its first tag is <model>, with any prefix; a triangle is a tag <triangle>, with
 * any prefix, outside of comments, CDATA and processing instructions. */
#include "reader/format_table.h"

#include <string.h>
#include <zip.h>

enum { PIECE = 1 << 16 };
static const size_t bytes_most = (size_t)1 << 30;

typedef enum { IN_TEXT, IN_NAME, IN_TAG, IN_QUOTE, IN_BANG, IN_COMMENT, IN_CDATA, IN_PI } place;

typedef struct {
  place where;
  char name[16]; /* of a tag behind its prefix; the characters behind `<!` */
  size_t length;
  char quote;
  char last[2]; /* the characters before this one */
  bool has_root, is_model;
  size_t triangles;
} scanner;

static bool is_name(const scanner *s, const char *name) {
  return s->length == strlen(name) && memcmp(s->name, name, s->length) == 0;
}

static void end_name(scanner *s) {
  if (s->length > 0 && s->name[0] == '/') {
    return;
  }
  if (!s->has_root) {
    s->has_root = true;
    s->is_model = is_name(s, "model");
  }
  s->triangles += is_name(s, "triangle");
}

static void scan_name(scanner *s, char c) {
  bool ends = c == ' ' || c == '\t' || c == '\r' || c == '\n' || c == '>';
  if (s->length == 0 && (c == '!' || c == '?')) {
    s->where = c == '!' ? IN_BANG : IN_PI;
  } else if (ends || (c == '/' && s->length > 0)) {
    end_name(s);
    s->where = c == '>' ? IN_TEXT : IN_TAG;
  } else if (c == ':') { /* what was read is a prefix */
    s->length = s->length > 0 && s->name[0] == '/' ? 1 : 0;
  } else if (s->length < sizeof s->name) {
    s->name[s->length++] = c;
  }
}

/* Scan "<!--", "<![CDATA[" or a document type. The reader refuses the last. */
static void scan_bang(scanner *s, char c) {
  if (s->length < sizeof s->name) {
    s->name[s->length++] = c;
  }
  if (is_name(s, "--")) {
    s->where = IN_COMMENT;
  } else if (is_name(s, "[CDATA[")) {
    s->where = IN_CDATA;
  } else if (c == '>') {
    s->where = IN_TEXT;
  }
}

static void scan(scanner *s, const char *piece, size_t size) {
  for (size_t n = 0; n < size; n++) {
    char c = piece[n];
    place before = s->where;
    switch (s->where) {
    case IN_TEXT:
      if (c == '<') {
        s->where = IN_NAME;
        s->length = 0;
      }
      break;
    case IN_NAME:
      scan_name(s, c);
      break;
    case IN_TAG:
      s->quote = c;
      s->where = c == '>' ? IN_TEXT : c == '"' || c == '\'' ? IN_QUOTE : IN_TAG;
      break;
    case IN_QUOTE:
      s->where = c == s->quote ? IN_TAG : IN_QUOTE;
      break;
    case IN_BANG:
      scan_bang(s, c);
      break;
    case IN_COMMENT:
    case IN_CDATA: {
      char two = s->where == IN_COMMENT ? '-' : ']';
      s->where = c == '>' && s->last[0] == two && s->last[1] == two ? IN_TEXT : s->where;
      break;
    }
    case IN_PI:
      s->where = c == '>' && s->last[1] == '?' ? IN_TEXT : IN_PI;
      break;
    }
    /* The end of a comment has nothing of its beginning: "<!-->" does not end. */
    bool begins = s->where != before;
    s->last[0] = begins ? '\0' : s->last[1];
    s->last[1] = begins ? '\0' : c;
  }
}

/* XML begins with '<', behind a byte order mark and blanks. */
static bool begins_as_xml(const char *piece, size_t size) {
  size_t n = size >= 3 && memcmp(piece, "\xef\xbb\xbf", 3) == 0 ? 3 : 0;
  while (n < size &&
         (piece[n] == ' ' || piece[n] == '\t' || piece[n] == '\r' || piece[n] == '\n')) {
    n++;
  }
  return n < size && piece[n] == '<';
}

/* Count the triangles of a part; *left is the number of bytes that all parts may still unpack
 * to. */
static bool count_part(zip_file_t *file, char *piece, size_t *left, size_t *triangles) {
  scanner s = {.where = IN_TEXT};
  zip_int64_t got = zip_fread(file, piece, PIECE);
  if (got <= 0 || !begins_as_xml(piece, (size_t)got)) {
    return true;
  }
  while (got > 0 && (size_t)got <= *left && (!s.has_root || s.is_model)) {
    *left -= (size_t)got;
    scan(&s, piece, (size_t)got);
    got = zip_fread(file, piece, PIECE);
  }
  *triangles += s.is_model ? s.triangles : 0;
  return got <= 0 || (s.has_root && !s.is_model);
}

static bool count_parts(zip_t *zip, char *piece, size_t *triangles) {
  size_t left = bytes_most;
  bool ok = true;
  zip_int64_t entries = zip_get_num_entries(zip, 0);
  for (zip_int64_t n = 0; n < entries && ok; n++) {
    zip_file_t *file = zip_fopen_index(zip, (zip_uint64_t)n, 0);
    if (file != NULL) { /* else it is encrypted, or packed as libzip cannot; the reader read none */
      ok = count_part(file, piece, &left, triangles);
      zip_fclose(file);
    }
  }
  return ok;
}

bool sepax__threemf_count(const mesh_builder *b, size_t *faces) {
  zip_error_t error;
  zip_error_init(&error);
  *faces = 0;
  char *piece = sepax_allocate(PIECE);
  if (piece == NULL) {
    return sepax__builder_fail_memory(b);
  }
  zip_source_t *source = zip_source_buffer_create(b->bytes, b->size, 0, &error);
  zip_t *zip = source != NULL ? zip_open_from_source(source, ZIP_RDONLY, &error) : NULL;
  zip_error_fini(&error);
  if (zip == NULL) {
    zip_source_free(source);
    sepax_release(piece);
    return sepax__builder_fail(b, "the archive cannot be opened a second time; pack it again");
  }
  bool ok = count_parts(zip, piece, faces);
  zip_discard(zip);
  sepax_release(piece);
  return ok || sepax__builder_fail(b, "its parts unpack to more than 1 GiB; simplify it");
}
