/* SPDX-License-Identifier: MIT */
/* rules.c - which motions of which pairs are checked: those with the tool of the pair, except those
 * in which rules let its bodies meet. */
#include "path/common/parts.h"
#include "util/error.h"

#include <string.h>

/* Does the rule mean this body by `name`? */
static bool is_named(const path_scene *scene, size_t body, const char *name) {
  const char *role = scene->body[body].role;
  return strcmp(path_body_name(scene, body), name) == 0 ||
         (role != NULL && strcmp(role, name) == 0);
}

static bool is_pair(const path_scene *scene, const path_pair *pair, const format_rule *rule) {
  return (is_named(scene, pair->body[0], rule->body[0]) &&
          is_named(scene, pair->body[1], rule->body[1])) ||
         (is_named(scene, pair->body[0], rule->body[1]) &&
          is_named(scene, pair->body[1], rule->body[0]));
}

static bool apply(path_scene *scene, const char *path, const format_rule *rule,
                  sepax_error *error) {
  bool any = false;
  for (size_t n = 0; n < scene->pairs; n++) {
    if (is_pair(scene, &scene->pair[n], rule)) {
      scene->pair[n].may_meet |= 1U << rule->kind;
      any = true;
    }
  }
  return any || sepax_fail(error, SEPAX_ERROR_ARGUMENT,
                           "%.240s:%zu: %.60s and %.60s are no pair that is compared; mend the "
                           "names, or leave the rule out",
                           path, rule->line, rule->body[0], rule->body[1]);
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
  format_rules_free(&rules);
  return ok;
}

report_bands path_bands(const path_question *q, const path_pair *pair) {
  const report_bands none = {.unit = q->bands.unit};
  return pair->bare ? none : q->bands;
}

/* ----------------------------------------------------------------------- motions */

static bool always_asked(const path_pair *pair) {
  return pair->may_meet == 0 && !pair->by_cells && pair->tool == FORMAT_NO_NAME;
}

/* Is the pair there in the motion that ends in a line? Only with its tool. Pairs that the stock as
 * it is cut decides are not asked here. */
static bool exists(const path_scene *scene, const path_pair *pair, size_t line) {
  return !pair->by_cells &&
         (pair->tool == FORMAT_NO_NAME || pair->tool == scene->motion.step[line].tool);
}

static bool may_meet(const path_scene *scene, const path_pair *pair, size_t line) {
  return pair->may_meet != 0 && (pair->may_meet >> scene->motion.step[line].kind & 1U) != 0;
}

bool path_motion_asked(const path_scene *scene, const path_pair *pair, size_t line) {
  return format_motion_goes_on(&scene->motion, line) &&
         (always_asked(pair) ||
          (exists(scene, pair, line + 1) && !may_meet(scene, pair, line + 1)));
}

/* The lines whose motions a line belongs to: itself if a motion ends there, the next if one begins
 * there. A line between breaks belongs to itself. */
static size_t motions_of(const path_scene *scene, size_t line, size_t end[2]) {
  size_t count = 0;
  if (line > 0 && format_motion_goes_on(&scene->motion, line - 1)) {
    end[count++] = line;
  }
  if (format_motion_goes_on(&scene->motion, line)) {
    end[count++] = line + 1;
  }
  if (count == 0) {
    end[count++] = line;
  }
  return count;
}

bool path_line_asked(const path_scene *scene, const path_pair *pair, size_t line) {
  size_t end[2];
  bool asked = always_asked(pair);
  for (size_t n = asked ? 0 : motions_of(scene, line, end); n > 0 && !asked; n--) {
    asked = exists(scene, pair, end[n - 1]) && !may_meet(scene, pair, end[n - 1]);
  }
  return asked;
}

/* Is a line left out only because the bodies may meet? */
static bool left_out(const path_scene *scene, const path_pair *pair, size_t line) {
  size_t end[2];
  bool there = false;
  for (size_t n = motions_of(scene, line, end); n > 0; n--) {
    there = there || exists(scene, pair, end[n - 1]);
  }
  return there && !path_line_asked(scene, pair, line);
}

void path_rules_count(path_scene *scene) {
  for (size_t k = 0; k < scene->pairs; k++) {
    path_pair *pair = &scene->pair[k];
    if (pair->by_cells) {
      continue;
    }
    pair->lines_asked = always_asked(pair) ? scene->motion.lines : 0;
    for (size_t n = 0; n < scene->motion.lines && !always_asked(pair); n++) {
      pair->lines_asked += path_line_asked(scene, pair, n);
      pair->lines_left_out += left_out(scene, pair, n);
      pair->motions_left_out += format_motion_goes_on(&scene->motion, n) &&
                                exists(scene, pair, n + 1) && may_meet(scene, pair, n + 1);
    }
  }
}
