/* SPDX-License-Identifier: MIT */
/* steps.c - CSV of joint values. */
#include "steps.h"

#include "report.h"

#include <limits.h>
#include <stdlib.h>
#include <string.h>

/* Columns that are no joints. Where a joint has such a name, the column is that of the joint. */
enum { TIME = -1, BREAK = -2, DEVIATION = -3, KIND = -4, TOOL = -5, WORDS = -6 };

typedef struct {
  int joint; /* or one of the above; WORDS and below: of no use for a proof */
  long double unit;
} column;

static const struct {
  const char *name;
  joint_kind kind;
  long double size;
} UNIT[] = {
    {"m", JOINT_PRISMATIC, 1},
    {"cm", JOINT_PRISMATIC, 1e-2L},
    {"mm", JOINT_PRISMATIC, 1e-3L},
    {"um", JOINT_PRISMATIC, 1e-6L},
    {"nm", JOINT_PRISMATIC, 1e-9L},
    {"in", JOINT_PRISMATIC, .0254L},
    {"rad", JOINT_REVOLUTE, 1},
    {"deg", JOINT_REVOLUTE, 3.14159265358979323846264338327950288L / 180},
};

/* The text between blanks, in its place. */
static char *trimmed(char *text) {
  static const char BLANK[] = " \t\r";
  text += strspn(text, BLANK);
  size_t length = strlen(text);
  while (length > 0 && strchr(BLANK, text[length - 1]) != NULL)
    text[--length] = 0;
  return text;
}

const char *const step_kind_names[STEP_DWELL + 1] = {"move", "rapid", "feed", "probe", "dwell"};

bool step_kind_named(const char *name, step_kind *kind) {
  int n = 0;
  while (n <= STEP_DWELL && strcmp(step_kind_names[n], name) != 0)
    n++;
  *kind = (step_kind)n;
  return n <= STEP_DWELL;
}

/* What a column is that is no joint. */
static int meaning(const char *file, const char *name) {
  static const char *const NAMES[] = {"time", "break", "deviation", "kind", "tool", "file", "line"};
  for (int n = 0; n < (int)(sizeof NAMES / sizeof *NAMES); n++) {
    if (strcmp(NAMES[n], name) == 0)
      return TIME - n;
  }
  cannot("%s: no joint %s", file, name);
}

static column heading(const char *file, char *text, const robot *r) {
  char *unit = NULL;
  char *bracket = strchr(text, '[');
  if (bracket != NULL) {
    char *end = bracket + strcspn(bracket, "]");
    if (*end == 0 || *trimmed(end + 1) != 0)
      cannot("%s: column %s", file, text);
    *bracket = *end = 0;
    unit = trimmed(bracket + 1);
  }
  const char *name = trimmed(text);
  column c = {robot_joint_named(r, name), 1};
  if (c.joint < 0)
    c.joint = meaning(file, name);
  if (c.joint < 0 && c.joint != DEVIATION) {
    if (unit != NULL && c.joint != TIME)
      cannot("%s: column %s has no unit", file, name);
    return c;
  }
  const joint_kind kind = c.joint == DEVIATION ? JOINT_PRISMATIC : r->joint[c.joint].kind;
  if (c.joint >= 0 && (kind == JOINT_FIXED || r->joint[c.joint].mimic >= 0))
    cannot("%s: joint %s cannot be moved", file, name);
  if (unit == NULL)
    return c;
  for (size_t n = 0; n < sizeof UNIT / sizeof *UNIT; n++) {
    if (strcmp(UNIT[n].name, unit) == 0 && UNIT[n].kind == kind) {
      c.unit = UNIT[n].size;
      return c;
    }
  }
  cannot("%s: column %s in %s", file, name, unit);
}

/* The text up to the next separator, which becomes a 0; *next is NULL behind the last. */
static char *part(char **next, char separator) {
  char *text = *next;
  char *end = strchr(text, separator);
  *next = end == NULL ? NULL : end + 1;
  if (end != NULL)
    *end = 0;
  return text;
}

/* A number as text. That of a deviation is rounded up. */
static void read_value(const char *file, const char *text, const column *c, steps *s) {
  char *end = NULL;
  const long double number = strtold(text, &end);
  if (end == text || *end != 0 || !isfinite(number))
    cannot("%s: data line %d: '%s' is no number", file, s->lines, text);
  if (c->joint >= 0)
    s->value[(size_t)s->lines * (size_t)s->joints + (size_t)c->joint] = number * c->unit;
  if (c->joint == DEVIATION)
    s->step[s->lines].deviation = nextafter((double)(number * c->unit), INFINITY);
  if (c->joint == DEVIATION && !(number >= 0 && isfinite(s->step[s->lines].deviation)))
    cannot("%s: data line %d: a deviation of '%s'", file, s->lines, text);
}

static void read_cell(const char *file, const char *text, const column *c, steps *s) {
  step *to = &s->step[s->lines];
  if (c->joint == BREAK) {
    to->begins = to->begins || strcmp(text, "1") == 0;
    if (*text != 0 && strcmp(text, "0") != 0 && strcmp(text, "1") != 0)
      cannot("%s: data line %d: a break of '%s'", file, s->lines, text);
  } else if (c->joint == KIND) {
    if (*text != 0 && !step_kind_named(text, &to->kind))
      cannot("%s: data line %d: no kind %s", file, s->lines, text);
  } else if (c->joint == TOOL) {
    const char *before = s->lines > 0 ? to[-1].tool : NULL;
    const bool same = before != NULL && strcmp(before, text) == 0;
    to->tool = *text == 0 ? NULL : same ? before : text_copy(text, strlen(text));
  } else if (c->joint > WORDS && !(c->joint == DEVIATION && *text == 0)) {
    read_value(file, text, c, s);
  }
}

static void read_line(const char *file, char *line, const column *columns, int count, steps *s) {
  char *next = line;
  for (int n = 0; n < count; n++) {
    if (next == NULL)
      cannot("%s: data line %d: too few values", file, s->lines);
    read_cell(file, trimmed(part(&next, ',')), &columns[n], s);
  }
  if (next != NULL)
    cannot("%s: data line %d: too many values", file, s->lines);
}

static void follow(const robot *r, long double *value) {
  for (int n = 0; n < r->joints; n++) {
    /* q = factor (factor' q' + offset') + offset ... down to a joint that moves by itself */
    long double factor = 1;
    long double offset = 0;
    int at = n;
    for (; r->joint[at].mimic >= 0; at = r->joint[at].mimic) {
      offset += factor * r->joint[at].offset;
      factor *= r->joint[at].factor;
    }
    if (at != n)
      value[n] = factor * value[at] + offset;
  }
}

steps steps_read(const char *file, const robot *r, files *f) {
  size_t length = 0;
  char *text = files_read(f, file, file, &length);
  if (strlen(text) != length)
    cannot("%s: is no text", file);
  char *next = strncmp(text, "\xEF\xBB\xBF", 3) == 0 ? text + 3 : text; /* a mark of UTF-8 */
  next += strspn(next, " \t\r\n");
  column *columns = NULL;
  int count = 0;
  for (char *header = part(&next, '\n'); header != NULL; count++) {
    GROW(columns, count);
    columns[count] = heading(file, trimmed(part(&header, ',')), r);
    for (int n = 0; n < count; n++) {
      if (columns[n].joint == columns[count].joint)
        cannot("%s: two columns of one name", file);
    }
  }
  steps s = {0, r->joints, NULL, NULL};
  size_t size = 0;
  while (next != NULL) {
    char *line = part(&next, '\n');
    if (*trimmed(line) == 0)
      continue;
    if (s.lines == INT_MAX)
      cannot("%s: too long", file);
    if ((size_t)s.lines == size) {
      size = size == 0 ? 1024 : 2 * size;
      s.value = memory(s.value, size * (size_t)(r->joints + 1), sizeof *s.value);
      s.step = memory(s.step, size, sizeof *s.step);
    }
    long double *value = s.value + (size_t)s.lines * (size_t)s.joints;
    for (int n = 0; n < r->joints; n++)
      value[n] = 0;
    s.step[s.lines] = (step){STEP_MOVE, NULL, s.lines == 0, 0};
    read_line(file, line, columns, count, &s);
    follow(r, value);
    s.lines++;
  }
  if (s.lines == 0)
    cannot("%s: no line of values", file);
  files_count(f, file, "lines", s.lines);
  files_count(f, file, "columns", count);
  free(columns);
  free(text);
  return s;
}
