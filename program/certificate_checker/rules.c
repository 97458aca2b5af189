/* SPDX-License-Identifier: MIT */
/* rules.c - CSV of two links and a kind of motion. */
#include "rules.h"

#include "report.h"

#include <string.h>

/* The cell at *next without blanks around; *next goes behind its comma, or is NULL at the end. */
static char *cell(char **next) {
  char *text = *next + strspn(*next, " \t");
  char *end = strchr(text, ',');
  *next = end == NULL ? NULL : end + 1;
  if (end == NULL)
    end = text + strlen(text);
  while (end > text && strchr(" \t\r", end[-1]) != NULL)
    end--;
  *end = 0;
  return text;
}

/* Is the link meant by the name? */
static bool is_meant(const robot_link *link, const char *name) {
  return strcmp(link->name, name) == 0 || (link->role != NULL && strcmp(link->role, name) == 0);
}

static bool is_known(const robot *r, const char *name) {
  int n = 0;
  while (n < r->links && !is_meant(&r->link[n], name))
    n++;
  return n < r->links;
}

static rule read_rule(const char *file, char *line, const robot *r, bool header) {
  char *cells[3] = {NULL, NULL, NULL};
  char *next = line;
  for (int n = 0; n < 3; n++) {
    if (next == NULL)
      cannot("%s: a line has less than three cells", file);
    cells[n] = cell(&next);
  }
  if (next != NULL)
    cannot("%s: a line has more than three cells", file);
  rule one = {NULL, NULL, STEP_MOVE};
  if (header) {
    if (strcmp(cells[0], "a") != 0 || strcmp(cells[1], "b") != 0 || strcmp(cells[2], "kind") != 0)
      cannot("%s: the first line is not a,b,kind", file);
    return one;
  }
  one.a = text_copy(cells[0], strlen(cells[0]));
  one.b = text_copy(cells[1], strlen(cells[1]));
  if (!is_known(r, one.a) || !is_known(r, one.b))
    cannot("%s: %s, %s: no such links", file, one.a, one.b);
  if (!step_kind_named(cells[2], &one.kind))
    cannot("%s: no kind %s", file, cells[2]);
  return one;
}

rules rules_read(const char *file, const robot *r, files *f) {
  rules all = {NULL, 0};
  size_t length = 0;
  if (file == NULL)
    return all;
  char *text = files_read(f, file, file, &length);
  if (strlen(text) != length)
    cannot("%s: is no text", file);
  bool header = true;
  for (char *line = text; line != NULL;) {
    char *end = strchr(line, '\n');
    if (end != NULL)
      *end = 0;
    if (line[strspn(line, " \t\r")] != 0) {
      const rule one = read_rule(file, line, r, header);
      if (!header) {
        GROW(all.entry, all.count);
        all.entry[all.count++] = one;
      }
      header = false;
    }
    line = end == NULL ? NULL : end + 1;
  }
  return all;
}

bool rules_may_meet(const rules *all, const robot *r, int a, int b, step_kind kind) {
  const robot_link *p = &r->link[a];
  const robot_link *q = &r->link[b];
  for (int n = 0; n < all->count; n++) {
    const rule *one = &all->entry[n];
    if (one->kind == kind && ((is_meant(p, one->a) && is_meant(q, one->b)) ||
                              (is_meant(p, one->b) && is_meant(q, one->a))))
      return true;
  }
  return false;
}
