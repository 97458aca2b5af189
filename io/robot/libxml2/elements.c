/* SPDX-License-Identifier: MIT */
/* elements.c - checks elements and attributes against the table of their format, so that nothing in
 * a file is ignored silently. */
#include "robot/libxml2/elements.h"

#include <ctype.h>
#include <string.h>

/* Names of other programs' elements are counted. Files have a few dozen of them. */
enum { OTHERS_MOST = 256 };

typedef struct {
  xml_file *file;
  const element_row *table;
  sepax_robot_others *others;
} checker;

static const char *name_of(const xmlNode *node) { return (const char *)node->name; }

/* ------------------------------------------------------------------------- names */

static bool has_word(const char *list, const char *word) {
  size_t length = strlen(word);
  for (const char *at = list; *at != '\0' && length > 0;) {
    size_t size = strcspn(at, " ");
    if (size == length && strncmp(at, word, length) == 0) {
      return true;
    }
    at += size;
    at += strspn(at, " ");
  }
  return false;
}

static const element_row *row_of(const checker *c, const char *name) {
  const element_row *row = c->table;
  while (row->name != NULL && strcmp(row->name, name) != 0) {
    row++;
  }
  return row->name != NULL ? row : NULL;
}

static size_t least(size_t a, size_t b) { return a < b ? a : b; }

static bool alike(char a, char b) { return tolower((unsigned char)a) == tolower((unsigned char)b); }

/* The number of letters to add, leave out, change or swap. Case does not count. */
static size_t distance_of(const char *a, const char *b) {
  enum { LONGEST = 40 };
  size_t way[LONGEST + 1][LONGEST + 1]; /* from the first i letters to the first j */
  const size_t length[2] = {strlen(a), strlen(b)};
  if (length[0] > LONGEST || length[1] > LONGEST) {
    return LONGEST;
  }
  for (size_t i = 0; i <= length[0]; i++) {
    for (size_t j = 0; j <= length[1]; j++) {
      if (i == 0 || j == 0) {
        way[i][j] = i + j;
        continue;
      }
      way[i][j] = least(way[i - 1][j - 1] + !alike(a[i - 1], b[j - 1]),
                        1 + least(way[i - 1][j], way[i][j - 1]));
      if (i > 1 && j > 1 && alike(a[i - 1], b[j - 2]) && alike(a[i - 2], b[j - 1])) {
        way[i][j] = least(way[i][j], way[i - 2][j - 2] + 1);
      }
    }
  }
  return way[length[0]][length[1]];
}

static bool has_collision(const char *name) {
  static const char word[] = "collision";
  size_t length = strlen(word);
  for (; strlen(name) >= length; name++) {
    size_t n = 0;
    while (n < length && tolower((unsigned char)name[n]) == word[n]) {
      n++;
    }
    if (n == length) {
      return true;
    }
  }
  return false;
}

/* The name of the table that was probably meant, or NULL. Short names have few letters to spare. */
static const char *meant(const checker *c, const char *name) {
  for (const element_row *row = c->table; row->name != NULL; row++) {
    size_t most = strlen(row->name) < 6 ? 1 : 2;
    if (distance_of(name, row->name) <= most) {
      return row->name;
    }
  }
  return has_collision(name) ? "collision" : NULL;
}

/* ------------------------------------------------------------------------ others */

/* False without memory, or if there are more than OTHERS_MOST. */
static bool count_other(sepax_robot_others *others, const char *what, long line) {
  size_t n = 0;
  while (n < others->count && strcmp(others->entry[n].what, what) != 0) {
    n++;
  }
  if (n == others->count) {
    size_t size = strlen(what) + 1;
    sepax_robot_other *grown =
        n < OTHERS_MOST ? sepax_resize(others->entry, (n + 1) * sizeof *grown) : NULL;
    others->entry = grown != NULL ? grown : others->entry;
    char *copy = grown != NULL ? sepax_allocate(size) : NULL;
    if (copy == NULL) {
      return false;
    }
    memcpy(copy, what, size);
    others->entry[others->count++] = (sepax_robot_other){copy, 0, line};
  }
  others->entry[n].count++;
  return true;
}

static const char *prefix_of(const xmlNs *ns) {
  return ns != NULL && ns->prefix != NULL ? (const char *)ns->prefix : NULL;
}

/* A prefix that the file does not declare stays a part of the name. */
static bool has_prefix(const xmlNode *node) {
  return prefix_of(node->ns) != NULL || strchr(name_of(node), ':') != NULL;
}

static bool is_xacro(const xmlNode *node) {
  const char *prefix = prefix_of(node->ns);
  return (prefix != NULL && strcmp(prefix, "xacro") == 0) ||
         strncmp(name_of(node), "xacro:", strlen("xacro:")) == 0;
}

/* Count what begins in the line of `at`: its name is `before`, `between` and `after` in one. */
static bool add(const checker *c, const xmlNode *at, const char *before, const char *between,
                const char *after, const char *end, sepax_error *error) {
  char what[200];
  snprintf(what, sizeof what, "%.60s%s%.100s%s", before, between, after, end);
  if (count_other(c->others, what, sepax__xml_line(at))) {
    return true;
  }
  return c->others->count < OTHERS_MOST
             ? sepax__xml_no_memory(c->file, at, error)
             : sepax__xml_fail(c->file, at, error,
                               "<%.40s>: more than %d kinds of unknown elements; leave some out",
                               name_of(at), OTHERS_MOST);
}

static bool add_named(const checker *c, const xmlNode *at, const char *prefix, const char *name,
                      const char *end, sepax_error *error) {
  return add(c, at, prefix != NULL ? prefix : "", prefix != NULL ? ":" : "", name, end, error);
}

static bool pass_over(const checker *c, xmlNode *node, sepax_error *error) {
  bool ok = add_named(c, node, prefix_of(node->ns), name_of(node), "", error);
  xmlUnlinkNode(node);
  xmlFreeNode(node);
  return ok;
}

/* ---------------------------------------------------------------------- elements */

static bool fail_attribute(const checker *c, const xmlNode *node, const char *name,
                           const element_row *row, sepax_error *error) {
  return row->attributes[0] == '\0'
             ? sepax__xml_fail(c->file, node, error,
                               "<%.40s %.40s=\"...\">: <%.40s> has no attribute; leave it out",
                               row->name, name, row->name)
             : sepax__xml_fail(c->file, node, error,
                               "<%.40s %.40s=\"...\">: <%.40s> has the attributes %.60s; mend its "
                               "name, or leave it out",
                               row->name, name, row->name, row->attributes);
}

/* Has the element one of the attributes that are read? */
static bool has_own(const xmlNode *node, const element_row *row) {
  bool has = false;
  for (const xmlAttr *a = node->properties; a != NULL; a = a->next) {
    has = has || (a->ns == NULL && has_word(row->attributes, (const char *)a->name));
  }
  return has;
}

static bool check_attributes(const checker *c, xmlNode *node, const element_row *row,
                             sepax_error *error) {
  for (const xmlAttr *a = node->properties; a != NULL; a = a->next) {
    const char *name = (const char *)a->name;
    const char *prefix = prefix_of(a->ns);
    if (prefix != NULL || strchr(name, ':') != NULL) {
      if (!add_named(c, node, prefix, name, "=", error)) {
        return false;
      }
    } else if (has_word(row->stray, name) && has_own(node, row)) {
      if (!add(c, node, row->name, " ", name, "=", error)) {
        return false;
      }
    } else if (!has_word(row->attributes, name) && !has_word(row->idle, name)) {
      return fail_attribute(c, node, name, row, error);
    }
  }
  return true;
}

static bool fail_child(const checker *c, const xmlNode *node, const element_row *row,
                       sepax_error *error) {
  const char *name = name_of(node);
  const char *near = meant(c, name);
  if (near != NULL && strcmp(near, name) == 0) {
    return sepax__xml_fail(c->file, node, error,
                           "<%.40s> in <%.40s>: it belongs elsewhere; move it, or leave it out",
                           name, row->name);
  }
  if (near != NULL) {
    return sepax__xml_fail(c->file, node, error,
                           "<%.40s> in <%.40s> is not known; write <%.40s>, or leave it out", name,
                           row->name, near);
  }
  return sepax__xml_fail(c->file, node, error,
                         "<%.40s> in <%.40s> is not known; mend its name, or leave it out%s%.60s%s",
                         name, row->name, row->children[0] != '\0' ? " (known: " : "",
                         row->children, row->children[0] != '\0' ? ")" : "");
}

/* Is a word nearly the name of an element that is read, or of one of its attributes? */
static bool is_nearly_known(const checker *c, const char *word) {
  bool near = meant(c, word) != NULL;
  for (const element_row *row = c->table; row->name != NULL; row++) {
    for (const char *at = row->attributes; *at != '\0' && !near;) {
      char name[40];
      size_t size = strcspn(at, " ");
      snprintf(name, sizeof name, "%.*s", (int)size, at);
      near = distance_of(word, name) <= 1;
      at += size;
      at += strspn(at, " ");
    }
  }
  return near;
}

/* May the text be meant as an element, an attribute or a value? */
static bool may_be_meant(const checker *c, const char *text, const element_row *in) {
  bool may = in->children[0] == '\0' || strpbrk(text, "0123456789$") != NULL;
  while (*text != '\0' && !may) {
    char word[48];
    size_t size = 0;
    while (text[size] == '_' || isalpha((unsigned char)text[size])) {
      size++;
    }
    snprintf(word, sizeof word, "%.*s", (int)least(size, sizeof word - 1), text);
    may = size > 0 && is_nearly_known(c, word);
    text += size > 0 ? size : 1;
  }
  return may;
}

static bool check_text(const checker *c, const xmlNode *text, const element_row *in,
                       sepax_error *error) {
  static const char blanks[] = " \t\r\n";
  const char *all = text->content != NULL ? (const char *)text->content : "";
  const char *word = all + strspn(all, blanks);
  char shown[44];
  snprintf(shown, sizeof shown, "%.*s", (int)least(strcspn(word, blanks), 40), word);
  return may_be_meant(c, all, in)
             ? sepax__xml_fail(c->file, text, error,
                               "<%.40s>: it contains the text '%s', which has no meaning there; "
                               "leave it out",
                               in->name, shown)
             : add(c, text, "text", " '", shown, "'", error);
}

static bool check_element(const checker *c, xmlNode *node, const element_row *row,
                          sepax_error *error);

static bool check_child(const checker *c, xmlNode *node, const element_row *row,
                        sepax_error *error) {
  const char *name = name_of(node);
  if (is_xacro(node)) {
    const char *colon = strchr(name, ':');
    return sepax__xml_fail(c->file, node, error,
                           "<xacro:%.40s> is of xacro; run xacro on the file first",
                           colon != NULL ? colon + 1 : name);
  }
  if (has_prefix(node)) {
    return pass_over(c, node, error);
  }
  if (has_word(row->children, name)) {
    return check_element(c, node, row_of(c, name), error);
  }
  if (has_word(row->passed, name) || (row->open && meant(c, name) == NULL)) {
    return pass_over(c, node, error);
  }
  return fail_child(c, node, row, error);
}

static bool check_element(const checker *c, xmlNode *node, const element_row *row,
                          sepax_error *error) {
  if (!check_attributes(c, node, row, error)) {
    return false;
  }
  for (xmlNode *child = node->children; child != NULL;) {
    xmlNode *next = child->next; /* the child may be freed */
    if (child->type == XML_TEXT_NODE && !xmlIsBlankNode(child)) {
      if (!check_text(c, child, row, error)) {
        return false;
      }
    } else if (child->type == XML_ELEMENT_NODE && !check_child(c, child, row, error)) {
      return false;
    }
    child = next;
  }
  return true;
}

bool sepax__elements_check(xml_file *file, const element_row *table, sepax_robot_others *others,
                           sepax_error *error) {
  const checker c = {file, table, others};
  return check_element(&c, file->root, &table[0], error);
}
