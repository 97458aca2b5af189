/* SPDX-License-Identifier: MIT */
/* dae.c - the reader of COLLADA 1.4 and 1.5: check, geometries, scene. */
#include "xml/dae.h"
#include "reader/format_table.h"
#include "util/text.h"

#include <string.h>

static const char blanks[] = " \t\r\n";

/* ------------------------------------------------------------------ texts and numbers */

bool sepax__dae_fail(const dae *d, const xmlNode *node, const char *format, ...) {
  char detail[240];
  va_list args;
  va_start(args, format);
  vsnprintf(detail, sizeof detail, format, args);
  va_end(args);
  return sepax__xml_fail(&d->file, node, d->b->error, "%s", detail);
}

const char *sepax__dae_attribute(const xmlNode *node, const char *name) {
  for (const xmlAttr *a = node->properties; a != NULL; a = a->next) {
    if (a->ns == NULL && strcmp((const char *)a->name, name) == 0) {
      return a->children != NULL && a->children->content != NULL
                 ? (const char *)a->children->content
                 : "";
    }
  }
  return NULL;
}

const char *sepax__dae_text(const xmlNode *node) {
  const xmlNode *text = node->children;
  return text != NULL && text->type == XML_TEXT_NODE && text->content != NULL
             ? (const char *)text->content
             : "";
}

static bool ends_word(char c) { return c == '\0' || strchr(blanks, c) != NULL; }

int sepax__dae_next_real(const char **text, double *value) {
  const char *word = *text + strspn(*text, blanks);
  *text = word;
  if (*word == '\0') {
    return 0;
  }
  const char *end = sepax__decimal(word, value);
  if (end == NULL || !ends_word(*end)) {
    return -1;
  }
  *text = end;
  return 1;
}

int sepax__dae_next_whole(const char **text, size_t *value) {
  const char *c = *text;
  while (*c == ' ' || *c == '\n' || *c == '\t' || *c == '\r') {
    c++;
  }
  *text = c;
  if (*c == '\0') {
    return 0;
  }
  size_t number = 0;
  for (; *c >= '0' && *c <= '9'; c++) {
    number = 10 * number + (size_t)(*c - '0');
    if (number > UINT32_MAX) {
      return -1;
    }
  }
  if (c == *text || !ends_word(*c)) {
    return -1;
  }
  *text = c;
  *value = number;
  return 1;
}

bool sepax__dae_reals(const dae *d, const xmlNode *node, double *value, size_t count) {
  enum { MATRIX = 16, MATRIX_BYTES = 4096 };
  const char *text = sepax__dae_text(node);
  const char *name = (const char *)node->name;
  /* A transformation is read as often as it is placed. */
  if (count <= MATRIX && strnlen(text, MATRIX_BYTES) == MATRIX_BYTES) {
    return sepax__dae_fail(d, node, "<%s> is longer than %d bytes; export it again", name,
                           (int)MATRIX_BYTES);
  }
  size_t found = 0;
  double beyond = 0;
  int got = 0;
  while ((got = sepax__dae_next_real(&text, found < count ? &value[found] : &beyond)) == 1) {
    found++;
  }
  if (got < 0) {
    size_t length = strcspn(text, blanks);
    return sepax__dae_fail(d, node, "<%s>: number %zu is \"%.*s\"; give a decimal number", name,
                           found, (int)(length < 30 ? length : 30), text);
  }
  return found == count ||
         sepax__dae_fail(d, node, "<%s> has %zu numbers, not %zu; export it again", name, found,
                         count);
}

bool sepax__dae_whole(const dae *d, const xmlNode *node, const char *name, size_t *value) {
  const char *text = sepax__dae_attribute(node, name);
  if (text == NULL) {
    return true;
  }
  const char *end = text;
  bool ok = sepax__dae_next_whole(&end, value) == 1 && end[strspn(end, blanks)] == '\0';
  return ok || sepax__dae_fail(d, node, "%s=\"%.40s\": give a whole number", name, text);
}

/* ----------------------------------------------------------------------------- reader */

/* Behind a byte order mark, blanks, instructions, comments and a document type, which is refused.
 */
bool sepax__dae_is(const char *bytes, size_t size) {
  const char *c = bytes;
  c += size >= 3 && memcmp(c, "\xef\xbb\xbf", 3) == 0 ? 3 : 0;
  while (true) {
    c += strspn(c, blanks);
    const char *end = strncmp(c, "<!--", 4) == 0        ? "-->"
                      : strncmp(c, "<?", 2) == 0        ? "?>"
                      : strncmp(c, "<!DOCTYPE", 9) == 0 ? ">"
                                                        : NULL;
    if (end == NULL) {
      break;
    }
    c = strstr(c, end);
    if (c == NULL) {
      return false;
    }
    c += strlen(end);
  }
  if (*c != '<') {
    return false;
  }
  size_t length = strcspn(c, "> \t\r\n/");
  const char *colon = memchr(c, ':', length);
  const char *name = colon != NULL ? colon + 1 : c + 1;
  return length - (size_t)(name - c) == strlen("COLLADA") && strncmp(name, "COLLADA", 7) == 0;
}

static bool check_version(const dae *d) {
  static const char *const known[][2] = {
      {"1.4.0", "http://www.collada.org/2005/11/COLLADASchema"},
      {"1.4.1", "http://www.collada.org/2005/11/COLLADASchema"},
      {"1.5.0", "http://www.collada.org/2008/03/COLLADASchema"},
      {"1.5.1", "http://www.collada.org/2008/03/COLLADASchema"},
  };
  const xmlNode *root = d->file.root;
  const char *version = sepax__dae_attribute(root, "version");
  const char *space = root->ns != NULL ? (const char *)root->ns->href : "";
  for (size_t n = 0; n < sizeof known / sizeof known[0] && version != NULL; n++) {
    if (strcmp(version, known[n][0]) == 0 && strcmp(space, known[n][1]) == 0) {
      return true;
    }
  }
  return sepax__dae_fail(d, root,
                         "COLLADA version \"%.20s\" of namespace \"%.80s\" is not read; export it "
                         "as 1.4.1 or 1.5.0",
                         version != NULL ? version : "", space);
}

/* True if an element contains only elements. A source of an effect contains a name. */
static bool is_container(const xmlNode *node) {
  static const char *const names[] = {"mesh",  "triangles",    "polylist", "polygons", "node",
                                      "scene", "visual_scene", "geometry", "COLLADA"};
  bool is = strncmp((const char *)node->name, "library_", 8) == 0;
  for (const xmlNode *n = node->children; n != NULL && !is; n = n->next) {
    is = n->type == XML_ELEMENT_NODE && !sepax__xml_is(node, "source");
  }
  for (size_t n = 0; n < sizeof names / sizeof names[0] && !is; n++) {
    is = sepax__xml_is(node, names[n]);
  }
  return is;
}

/* Text between elements may be an element that is damaged. What is in <extra> is of other programs.
 */
static bool check_texts(const dae *d) {
  for (xmlNode *n = d->file.root; n != NULL;) {
    bool is_text = n->type == XML_TEXT_NODE || n->type == XML_CDATA_SECTION_NODE;
    if (is_text && n->content != NULL &&
        n->content[strspn((const char *)n->content, blanks)] != 0 && is_container(n->parent)) {
      return sepax__dae_fail(d, n, "<%.40s> has text between its elements; export it again",
                             (const char *)n->parent->name);
    }
    bool enters = n->type == XML_ELEMENT_NODE && n->children != NULL && !sepax__xml_is(n, "extra");
    if (enters) {
      n = n->children;
      continue;
    }
    while (n != d->file.root && n->next == NULL) {
      n = n->parent;
    }
    n = n != d->file.root ? n->next : NULL;
  }
  return true;
}

static bool read_document(dae *d, size_t *faces) {
  if (!check_version(d) || !check_texts(d) || !sepax__dae_check(d)) {
    return false;
  }
  for (size_t n = 0; n < d->geometries; n++) {
    if (!sepax__dae_mesh(d, &d->geometry[n])) {
      return false;
    }
    *faces += d->geometry[n].faces;
  }
  if (!sepax__dae_place(d)) {
    return false;
  }
  for (size_t n = 0; n < d->geometries; n++) {
    d->b->account.unplaced += d->geometry[n].placed ? 0 : d->geometry[n].faces;
  }
  return true;
}

bool sepax__dae_read(mesh_builder *b, size_t *faces) {
  dae d = {.b = b};
  *faces = 0;
  if (b->size >= 4 && memchr(b->bytes, '\0', 4) != NULL) {
    return sepax__builder_fail(b, "it is XML in UTF-16 or UTF-32; save it in UTF-8");
  }
  bool ok = sepax__xml_parse(&d.file, b->path, b->bytes, b->size, "COLLADA", b->error) &&
            read_document(&d, faces);
  for (size_t n = 0; n < d.geometries; n++) {
    sepax_release(d.geometry[n].facet);
  }
  sepax_release(d.geometry);
  sepax_release(d.id);
  sepax_release(d.node);
  sepax__xml_close(&d.file);
  return ok;
}
