/* table.c - see table.h. */
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

static const node *find_template(const node *root, const char *name) {
  for (const node *n = root->child; n != NULL; n = n->next) {
    if ((strcmp(n->name, "lu_table_template") == 0 || strcmp(n->name, "power_lut_template") == 0) &&
        strcmp(n->args, name) == 0) {
      return n;
    }
  }
  return NULL;
}

static int index_of(const node *table, const node *model, const char *name, double *list) {
  const node *n = tree_child(table, name);
  if (n == NULL && model != NULL) {
    n = tree_child(model, name);
  }
  return n == NULL || n->args == NULL ? 0 : table_numbers(n->args, list, LIB_INDEX);
}

void table_read(lib_table *t, const node *root, const node *n) {
  if (n == NULL) {
    return;
  }
  const node *model = find_template(root, n->args);
  const char *first = model == NULL ? NULL : tree_value(model, "variable_1");
  double axis[2][LIB_INDEX];
  int count[2] = {index_of(n, model, "index_1", axis[0]), index_of(n, model, "index_2", axis[1])};
  const node *values = tree_child(n, "values");
  if (values == NULL) {
    return;
  }
  static double list[LIB_INDEX * LIB_INDEX];
  int rows = count[0] > 0 ? count[0] : 1;
  int columns = count[1] > 0 ? count[1] : 1;
  if (table_numbers(values->args, list, LIB_INDEX * LIB_INDEX) != rows * columns) {
    text_fail("has a table of wrong size,", n->name);
  }
  bool slope_first = first == NULL || strstr(first, "transition") != NULL;
  t->given = true;
  t->slopes = slope_first ? rows : columns;
  t->loads = slope_first ? columns : rows;
  memcpy(t->slope, axis[slope_first ? 0 : 1], sizeof t->slope);
  memcpy(t->load, axis[slope_first ? 1 : 0], sizeof t->load);
  for (int r = 0; r < rows; r++) {
    for (int c = 0; c < columns; c++) {
      t->value[slope_first ? r : c][slope_first ? c : r] = list[r * columns + c];
    }
  }
}

static int place(const double *axis, int n, double x, double *part) {
  if (n < 2) {
    *part = 0;
    return 0;
  }
  int k = 0;
  while (k + 2 < n && x >= axis[k + 1]) {
    k++;
  }
  *part = (x - axis[k]) / (axis[k + 1] - axis[k]);
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
