/* SPDX-License-Identifier: MIT */
/* table.c - see table.h; and interpolates in them. */
#include "table.h"
#include "text.h"

#include <stdlib.h>
#include <string.h>

int table_numbers(const char *text, double *list, int most) {
  int n = 0;
  while (*text != '\0') {
    char *end;
    double x = strtod(text, &end);
    if (end == text) {
      text++;
      continue;
    }
    if (n == most) {
      text_fail("has a table that is too large,", "more than 16 entries");
    }
    list[n++] = x;
    text = end;
  }
  return n;
}

/* An axis of a table, or else of its template; 1 point where neither has it. */
static int read_axis(const node *table, const node *model, const char *name, double *list) {
  const node *n = tree_child(table, name);
  n = n == NULL && model != NULL ? tree_child(model, name) : n;
  int count = n == NULL || n->args == NULL ? 0 : table_numbers(n->args, list, LIB_INDEX);
  return count > 0 ? count : 1;
}

void table_read(lib_table *t, const node *root, const node *n) {
  const node *values = n == NULL ? NULL : tree_child(n, "values");
  if (values == NULL) {
    return;
  }
  const node *model = tree_named(root, "lu_table_template", n->args);
  model = model == NULL ? tree_named(root, "power_lut_template", n->args) : model;
  const char *first = model == NULL ? NULL : tree_value(model, "variable_1");
  bool slope_first = first == NULL || strstr(first, "transition") != NULL;
  double list[LIB_INDEX * LIB_INDEX];
  int rows = read_axis(n, model, "index_1", slope_first ? t->slope : t->load);
  int columns = read_axis(n, model, "index_2", slope_first ? t->load : t->slope);
  if (table_numbers(values->args, list, LIB_INDEX * LIB_INDEX) != rows * columns) {
    text_fail("has a table of wrong size,", n->name);
  }
  t->given = true;
  t->slopes = slope_first ? rows : columns;
  t->loads = slope_first ? columns : rows;
  for (int k = 0; k < rows * columns; k++) {
    int row = k / columns;
    int column = k % columns;
    t->value[slope_first ? row : column][slope_first ? column : row] = list[k];
  }
}

static int place(const double *axis, int n, double x, double *part) {
  int k = 0;
  while (k + 2 < n && x >= axis[k + 1]) {
    k++;
  }
  *part = n < 2 ? 0 : (x - axis[k]) / (axis[k + 1] - axis[k]);
  return k;
}

double lib_look_up(const lib_table *t, double slope, double load) {
  if (!t->given) {
    return 0;
  }
  double ps;
  double pl;
  int s = place(t->slope, t->slopes, slope, &ps);
  int l = place(t->load, t->loads, load, &pl);
  int s2 = s + (t->slopes > 1);
  int l2 = l + (t->loads > 1);
  return (1 - ps) * ((1 - pl) * t->value[s][l] + pl * t->value[s][l2]) +
         ps * ((1 - pl) * t->value[s2][l] + pl * t->value[s2][l2]);
}
