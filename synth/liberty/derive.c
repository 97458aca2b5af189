/* derive.c - see derive.h. */
#include "derive.h"

#include <ctype.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Copies the text, whose statements lie in it in order, but for what it scales. */
typedef struct {
  const char *at;
  ptrdiff_t shift; /* from the text that was read to the one that is copied */
  double delay, leakage;
  const char *suffix;
} copier;

static bool is_one_of(const char *name, const char *const list[], size_t count) {
  for (size_t k = 0; k < count; k++) {
    if (strcmp(name, list[k]) == 0) {
      return true;
    }
  }
  return false;
}

#define IS_ONE_OF(name, list) is_one_of(name, list, sizeof(list) / sizeof *(list))

static void copy_to(copier *c, const char *to) {
  fwrite(c->at, 1, (size_t)(to - c->at), stdout);
  c->at = to;
}

/* All numbers of a value or an argument. */
static void scale(copier *c, const node *n, double by) {
  const char *p = n->from;
  while (p < n->to) {
    if (isspace((unsigned char)*p)) {
      p++;
      continue;
    }
    char *end = NULL;
    double x = strtod(p, &end);
    if (end == NULL || end == p) {
      p++;
      continue;
    }
    copy_to(c, p + c->shift);
    printf("%.8g", x * by);
    p = end;
    c->at = p + c->shift;
  }
}

static void add_suffix(copier *c, const node *n) {
  const char *name = strstr(n->from, n->args);
  copy_to(c, name + strlen(n->args) + c->shift);
  fputs(c->suffix, stdout);
}

static void walk(copier *c, const node *n, const char *parent, bool timed) {
  static const char *const times[] = {"cell_rise",       "cell_fall",       "rise_transition",
                                      "fall_transition", "rise_constraint", "fall_constraint"};
  static const char *const intrinsic[] = {"intrinsic_rise", "intrinsic_fall"};
  for (; n != NULL; n = n->next) {
    if (strcmp(n->name, "library") == 0 || strcmp(n->name, "cell") == 0) {
      add_suffix(c, n);
    } else if (strcmp(n->name, "values") == 0 ? timed : IS_ONE_OF(n->name, intrinsic)) {
      scale(c, n, c->delay);
    } else if (strcmp(n->name, "cell_leakage_power") == 0 ||
               (strcmp(n->name, "value") == 0 && strcmp(parent, "leakage_power") == 0)) {
      scale(c, n, c->leakage);
    }
    walk(c, n->child, n->name, IS_ONE_OF(n->name, times));
  }
}

void derive(const char *text, const char *origin, const node *library, const derivation *how) {
  copier c = {origin, 0, strtod(how->delay, NULL), strtod(how->leakage, NULL), how->suffix};
  c.shift = origin - text;
  printf("/* Derived by liberty from %s: delays, slopes, setup and hold x %s, leakage x %s.\n"
         " * Not a foundry's cells. */\n",
         library->args, how->delay, how->leakage);
  walk(&c, library, "", false);
  fputs(c.at, stdout);
}
