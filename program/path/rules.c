/* SPDX-License-Identifier: MIT */
/* rules.c - which motions of which pairs are checked: all, unless a rule lets the bodies meet. */
#include "path/parts.h"
#include "util/error.h"

#include <string.h>

static bool is_pair(const path_scene *scene, const path_pair *pair, const format_rule *rule) {
  const char *a = path_body_name(scene, pair->body[0]);
  const char *b = path_body_name(scene, pair->body[1]);
  return (strcmp(a, rule->body[0]) == 0 && strcmp(b, rule->body[1]) == 0) ||
         (strcmp(a, rule->body[1]) == 0 && strcmp(b, rule->body[0]) == 0);
}

static bool apply(path_scene *scene, const char *path, const format_rule *rule,
                  sepax_error *error) {
  for (size_t n = 0; n < scene->pairs; n++) {
    if (is_pair(scene, &scene->pair[n], rule)) {
      scene->pair[n].may_meet |= 1U << rule->kind;
      return true;
    }
  }
  return sepax_fail(error, SEPAX_ERROR_ARGUMENT,
                    "%.240s:%zu: %.60s and %.60s are no pair that is compared; mend the names, or "
                    "leave the rule out",
                    path, rule->line, rule->body[0], rule->body[1]);
}

/* Count the lines and motions of a pair that rules leave out. */
static void count_left_out(const path_scene *scene, path_pair *pair) {
  for (size_t n = 0; n < scene->motion.lines; n++) {
    pair->lines_left_out += !path_line_asked(scene, pair, n);
    pair->motions_left_out +=
        format_motion_goes_on(&scene->motion, n) && !path_motion_asked(scene, pair, n);
  }
}

bool path_rules_apply(path_scene *scene, const char *path, sepax_error *error) {
  format_rules rules;
  if (scene->motion.step == NULL) {
    return sepax_fail(error, SEPAX_ERROR_ARGUMENT,
                      "rules: the path has no column that says what a motion is for; add the "
                      "column kind, or leave --rules out");
  }
  if (!format_rules_read(&rules, path, error)) {
    return false;
  }
  bool ok = true;
  for (size_t n = 0; n < rules.count && ok; n++) {
    ok = apply(scene, path, &rules.rule[n], error);
  }
  for (size_t n = 0; n < scene->pairs && ok; n++) {
    count_left_out(scene, &scene->pair[n]);
  }
  format_rules_free(&rules);
  return ok;
}

static bool may_meet(const path_scene *scene, const path_pair *pair, size_t line) {
  return (pair->may_meet >> scene->motion.step[line].kind & 1U) != 0;
}

bool path_motion_asked(const path_scene *scene, const path_pair *pair, size_t line) {
  return format_motion_goes_on(&scene->motion, line) &&
         (pair->may_meet == 0 || !may_meet(scene, pair, line + 1));
}

bool path_line_asked(const path_scene *scene, const path_pair *pair, size_t line) {
  if (pair->may_meet == 0) {
    return true;
  }
  bool ends = line > 0 && format_motion_goes_on(&scene->motion, line - 1);
  bool begins = format_motion_goes_on(&scene->motion, line);
  return (!ends && !begins) ? !may_meet(scene, pair, line)
                            : (ends && !may_meet(scene, pair, line)) ||
                                  (begins && !may_meet(scene, pair, line + 1));
}
