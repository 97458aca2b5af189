/* SPDX-License-Identifier: MIT */
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
  double delay, leakage;
  const char *suffix;
} copier;

/* What is scaled: statements of this name in one of that name. */
static const struct {
  const char *name, *parent;
  bool leaks;
} scaled[] = {
    {"values", "cell_rise", false},       {"values", "cell_fall", false},
    {"values", "rise_transition", false}, {"values", "fall_transition", false},
    {"values", "rise_constraint", false}, {"values", "fall_constraint", false},
    {"intrinsic_rise", "timing", false},  {"intrinsic_fall", "timing", false},
    {"cell_leakage_power", "cell", true}, {"value", "leakage_power", true},
};

static void copy_to(copier *c, const char *to) {
  fwrite(c->at, 1, (size_t)(to - c->at), stdout);
  c->at = to;
}

/* All numbers of a value or an argument. */
static void scale(copier *c, const node *n, double by) {
  for (const char *p = n->from; p < n->to;) {
    char *end = NULL;
    double x = strtod(p, &end);
    if (end == p || isspace((unsigned char)*p)) {
      p++;
      continue;
    }
    copy_to(c, p);
    printf("%.8g", x * by);
    c->at = p = end;
  }
}

static void walk(copier *c, const node *parent) {
  for (const node *n = parent->child; n != NULL; n = n->next) {
    if (strcmp(n->name, "cell") == 0) {
      copy_to(c, strstr(n->from, n->args) + strlen(n->args));
      fputs(c->suffix, stdout);
    }
    for (size_t k = 0; k < sizeof scaled / sizeof scaled[0]; k++) {
      if (strcmp(n->name, scaled[k].name) == 0 && strcmp(parent->name, scaled[k].parent) == 0) {
        scale(c, n, scaled[k].leaks ? c->leakage : c->delay);
      }
    }
    walk(c, n);
  }
}

void derive(const node *library, const char *delay, const char *leakage, const char *suffix) {
  printf("/* Derived by liberty from %s: delays, slopes, setup and hold x %s, leakage x %s.\n"
         " * Not a foundry's cells. */\nlibrary (",
         library->args, delay, leakage);
  copier c = {library->from, strtod(delay, NULL), strtod(leakage, NULL), suffix};
  copy_to(&c, strstr(library->from, library->args) + strlen(library->args));
  fputs(suffix, stdout);
  walk(&c, library);
  fputs(c.at, stdout);
}
