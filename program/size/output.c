/* SPDX-License-Identifier: MIT */
/* output.c - prints the answer of sepax size as text and as JSON. */
#include "report/json.h"
#include "design/engine_table.h"
#include "report/text.h"
#include "size/parts.h"

#include <stdio.h>

enum { WIDTH = SIZE_WIDTH };

static uint64_t pairs_of(const sepax_size *s) { return (uint64_t)s->count[0] * s->count[1]; }

static const char *pairs_told(const size_options *o) { return o->request.first ? "first" : "all"; }

/* --------------------------------------------------------------------------- text */

static void print_candidates(const size_options *o, const sepax_size *s) {
  double pairs = (double)pairs_of(s);
  printf("%-*s%llu of %.0f pairs have overlapping AABBs in the %s: %.3g %%\n", WIDTH, "AABBs",
         (unsigned long long)s->given, pairs,
         s->path > 0 ? "first pose of the path" : "pose of the files",
         100 * (double)s->given / pairs);
  if (s->poses > 0) {
    printf("%-*smost in this pose and %d sampled poses (seed %llu): %llu, %.3g %%\n", WIDTH, "",
           s->poses, (unsigned long long)o->space.seed, (unsigned long long)s->worst,
           100 * (double)s->worst / pairs);
  } else if (s->path > 1) {
    printf("%-*smost in any of the %zu poses: %llu, %.3g %%\n", WIDTH, "", s->path,
           (unsigned long long)s->worst, 100 * (double)s->worst / pairs);
  }
}

/* The number of the slowest pose: in a file of poses counted from 0, for a machine the line of the
 * CSV. */
static size_t worst_of(const size_answer *answer, size_t pose) {
  return answer->each != NULL ? answer->scene.motion.line[pose] : pose;
}

/* Print the best design of each engine, if several engines were considered. */
static void print_engines(const size_answer *answer) {
  printf("%-*s%-16s%9s %9s %11s %11s %6s\n", WIDTH, "engines", "", "GE", "kbit", "worst, ms",
         "mean, ms", answer->each != NULL ? "line" : "pose");
  for (int n = 0; n < SEPAX_ENGINE_COUNT; n++) {
    const size_engine *engine = &size_engines[n];
    const size_best *k = &answer->with[n];
    const sepax_sized_design *m = &k->best;
    double period = m->config.clock_ps * 1e-12;
    if (k->in_time) {
      printf("%-*s%-16s%8.1fK %9.0f %11.4g %11.4g %6zu\n", WIDTH, "", engine->name, m->gates / 1000,
             (double)sepax_memory_bits(&m->config) / 1000, 1e3 * m->seconds, 1e3 * period * m->mean,
             worst_of(answer, m->worst));
    } else if (k->refused) {
      printf("%-*s%-16snone: the clock is too short\n", WIDTH, "", engine->name);
    } else if (k->asked) {
      printf("%-*s%-16snone in time: %.4g ms or more\n", WIDTH, "", engine->name, 1e3 * m->seconds);
    } else if (engine->walks_trees && answer->size->trees == NULL) {
      printf("%-*s%-16snone: W is above %d\n", WIDTH, "", engine->name, SEPAX_TREE_WORD_MAX);
    }
  }
}

static void print_design(const size_answer *answer) {
  const sepax_sized_design *m = answer->best;
  const sepax_config *c = &m->config;
  double kbit = (double)sepax_memory_bits(c) / 1000;
  printf("design     exact, II = %d, ", c->ii);
  size_engine_of(m)->print(c, kbit);
  printf("gates      %.1fK +- %.1fK GE (formula for Nangate45, typical)\n", m->gates / 1000,
         m->gates_error / 1000);
}

static void print_basis(const size_options *o, const sepax_sized_design *m) {
  if (size_engine_of(m)->print_basis != NULL) {
    size_engine_of(m)->print_basis(o);
  }
}

static void print_time(const size_options *o, const size_answer *answer) {
  const sepax_sized_design *m = answer->best;
  double period = m->config.clock_ps / 1000.0;
  printf("time       %.4g ms for %s (%llu cycles of %g ns)", 1e3 * m->seconds,
         size_engine_of(m)->walks_trees && o->request.first ? "the first collision" : "all pairs",
         (unsigned long long)m->cycles, period);
  if (answer->size->path > 0) {
    printf(" in the worst of %zu poses, number %zu; mean %.4g ms (%.0f cycles)\n",
           answer->size->path, m->worst, 1e-6 * period * m->mean, m->mean);
    print_basis(o, m);
    return;
  }
  if (answer->size->poses > 0) {
    printf(", the worst of the file's pose and %d sampled poses; other poses may take longer",
           answer->size->poses);
  }
  putchar('\n');
}

/* Print the bodies of a machine. */
static void print_bodies(const size_options *o, const size_answer *answer) {
  const path_scene *scene = &answer->scene;
  const path_engine *e = &answer->engine;
  for (size_t n = 0; n < scene->bodies; n++) {
    printf("%-*s%s, %zu triangles\n", WIDTH, "body", path_body_name(scene, n),
           scene->body[n].triangles);
  }
  printf("%-*s%zu of %zu are compared\n", WIDTH, "pairs", e->pairs,
         scene->pairs + scene->joined + scene->rigid + scene->disabled);
  printf("%-*s%s, %zu poses, in lines %zu ... %zu\n", WIDTH, "path", o->path[1],
         scene->motion.lines, scene->motion.line[0], scene->motion.line[scene->motion.lines - 1]);
  const report_steps steps = {e->clearance, e->warning, report_mm(e->resolution, CLI_METRES)};
  printf("%-*sW = %d, 1 LSB = %.9g mm; about the middles of the bodies this holds all near pairs\n",
         WIDTH, "grid", e->word, steps.lsb_mm);
  report_print_bands(WIDTH, &o->scene.bands, &steps, NULL);
  puts(", of the bodies as they are in the files: nothing is missed");
}

static void print_lines(const size_options *o, const size_answer *answer) {
  const path_scene *scene = &answer->scene;
  const sepax_sized_design *m = answer->best;
  double period = m->config.clock_ps / 1000.0;
  printf("%-*s%-42s %11s %11s %7s\n", WIDTH, "cycles", "", "worst", "mean", "line");
  for (size_t n = 0; n < answer->pairs; n++) {
    const size_pair *p = &answer->each[n];
    char name[96];
    snprintf(name, sizeof name, "%.40s, %.40s",
             path_body_name(scene, size_pair_of(answer, n)->body[0]),
             path_body_name(scene, size_pair_of(answer, n)->body[1]));
    printf("%-*s%-42s %11llu %11.0f %7zu\n", WIDTH, "", name, (unsigned long long)p->worst, p->mean,
           worst_of(answer, p->line));
  }
  printf("time       %.4g ms for %s of all %zu pairs (%llu cycles of %g ns) in the worst of %zu "
         "lines,\n%-*sline %zu; mean %.4g ms (%.0f cycles); each line is in %.4g ms\n",
         1e3 * m->seconds, size_engine_of(m)->walks_trees ? "the first collision" : "all triangles",
         answer->pairs, (unsigned long long)m->cycles, period, scene->motion.lines, WIDTH, "",
         worst_of(answer, m->worst), 1e-6 * period * m->mean, m->mean, 1e3 * o->request.seconds);
  print_basis(o, m);
}

static void print_scene(const size_options *o, const size_answer *answer) {
  char text[SEPAX_CONFIG_TEXT];
  print_bodies(o, answer);
  print_engines(answer);
  print_design(answer);
  print_lines(o, answer);
  printf("sepax gen %s -o %s\n", sepax_config_text(&answer->best->config, text, sizeof text),
         o->generate ? o->folder : "DIR");
}

void size_print_text(const size_options *o, const size_answer *answer) {
  if (o->is_scene) {
    print_scene(o, answer);
    return;
  }
  const sepax_size *s = answer->size;
  char text[SEPAX_CONFIG_TEXT];
  report_print_mesh("A", WIDTH, o->path[0], &answer->file[0]);
  report_print_mesh("B", WIDTH, o->path[1], &answer->file[1]);
  if (o->path_file != NULL) {
    printf("path       %s, %zu poses of B\n", o->path_file, s->path);
  }
  printf("poses      x %.9g ... %.9g mm, y %.9g ... %.9g mm, z %.9g ... %.9g mm\n", s->low[0],
         s->high[0], s->low[1], s->high[1], s->low[2], s->high[2]);
  report_print_grid(WIDTH, &s->grid);
  printf("extents    L_A = %lld, L_B = %lld LSB: %d bits behind the AABB test\n",
         (long long)s->extent[0], (long long)s->extent[1], s->core_word);
  if (s->workloads > 0) {
    print_candidates(o, s);
  }
  if (s->path > 0) {
    print_engines(answer);
  }
  print_design(answer);
  print_time(o, answer);
  printf("sepax gen %s -o %s\n", sepax_config_text(&answer->best->config, text, sizeof text),
         o->generate ? o->folder : "DIR");
}

/* --------------------------------------------------------------------------- JSON */

static json_t *design_json(const size_answer *answer, const sepax_sized_design *m) {
  char text[SEPAX_CONFIG_TEXT];
  char command[SEPAX_CONFIG_TEXT + 16];
  const sepax_config *c = &m->config;
  snprintf(command, sizeof command, "sepax gen %s", sepax_config_text(c, text, sizeof text));
  json_t *design = json_pack(
      "{s:s, s:i, s:b, s:i, s:b, s:i, s:I, s:f, s:f, s:I, s:f, s:b, s:s}", "arch",
      sepax_arch_name(c->arch), "ii", c->ii, "extents", c->extent_a > 0, "lanes", c->lanes, "tree",
      c->tree, "cores", c->cores, "memory_bits", (json_int_t)sepax_memory_bits(c), "ge", m->gates,
      "ge_error", m->gates_error, "cycles", (json_int_t)m->cycles, "seconds", m->seconds,
      "is_bound", answer->size->poses == 0 && !size_engine_of(m)->walks_trees, "command", command);
  if (answer->size->path > 0) {
    json_object_set_new(design, "mean_cycles", json_real(m->mean));
    json_object_set_new(design, answer->each != NULL ? "worst_line" : "worst_pose",
                        json_integer((json_int_t)worst_of(answer, m->worst)));
  }
  return design;
}

static json_t *engines_json(const size_answer *answer) {
  json_t *list = json_array();
  for (int n = 0; n < SEPAX_ENGINE_COUNT; n++) {
    const size_best *k = &answer->with[n];
    if (k->asked) {
      json_t *of = json_pack("{s:s, s:b}", "kind", size_engines[n].name, "in_time", k->in_time);
      if (k->in_time) {
        json_object_set_new(of, "design", design_json(answer, &k->best));
      } else if (!k->refused) {
        json_object_set_new(of, "seconds_at_least", json_real(k->best.seconds));
      }
      json_array_append_new(list, of);
    }
  }
  return list;
}

static json_t *body_json(const path_scene *scene, size_t n) {
  return json_pack("{s:s, s:I}", "link", path_body_name(scene, n), "triangles",
                   (json_int_t)scene->body[n].triangles);
}

static json_t *pair_json(const size_answer *answer, size_t n) {
  const path_scene *scene = &answer->scene;
  const size_pair *p = &answer->each[n];
  return json_pack(
      "{s:s, s:s, s:I, s:I, s:f}", "a", path_body_name(scene, size_pair_of(answer, n)->body[0]),
      "b", path_body_name(scene, size_pair_of(answer, n)->body[1]), "cycles", (json_int_t)p->worst,
      "worst_line", (json_int_t)worst_of(answer, p->line), "mean_cycles", p->mean);
}

static void print_scene_json(const size_options *o, const size_answer *answer) {
  const path_scene *scene = &answer->scene;
  const path_engine *e = &answer->engine;
  json_t *bodies = json_array();
  json_t *pairs = json_array();
  for (size_t n = 0; n < scene->bodies; n++) {
    json_array_append_new(bodies, body_json(scene, n));
  }
  for (size_t n = 0; n < answer->pairs; n++) {
    json_array_append_new(pairs, pair_json(answer, n));
  }
  json_t *report = json_pack(
      "{s:s, s:s?, s:s, s:I, s:i, s:f, s:i, s:i, s:i, s:f, s:o, s:o, s:o, s:o}", "urdf", o->path[0],
      "srdf", o->scene.srdf, "path", o->path[1], "lines", (json_int_t)scene->motion.lines, "word",
      e->word, "lsb_mm", report_mm(e->resolution, CLI_METRES), "clearance_lsb", e->clearance,
      "warning_lsb", e->warning, "latency_cycles", o->request.latency, "time_s", o->request.seconds,
      "bodies", bodies, "pairs", pairs, "engines", engines_json(answer), "design",
      design_json(answer, answer->best));
  report_set_bands(report, &o->scene.bands, NULL);
  report_print_json(report);
}

void size_print_json(const size_options *o, const size_answer *answer) {
  if (o->is_scene) {
    print_scene_json(o, answer);
    return;
  }
  const sepax_size *s = answer->size;
  json_t *report = report_scene(o->path, s->count, &s->grid);
  report_set_mesh(json_object_get(report, "a"), &answer->file[0]);
  report_set_mesh(json_object_get(report, "b"), &answer->file[1]);
  json_t *needs =
      json_pack("{s:[[f, f], [f, f], [f, f]], s:[I, I], s:i}", "poses_mm", s->low[0], s->high[0],
                s->low[1], s->high[1], s->low[2], s->high[2], "extents_lsb",
                (json_int_t)s->extent[0], (json_int_t)s->extent[1], "core_word", s->core_word);
  json_object_update(report, needs);
  json_decref(needs);
  if (s->workloads > 0) {
    json_t *candidates = json_pack("{s:I, s:I, s:I, s:i, s:I}", "pairs", (json_int_t)pairs_of(s),
                                   "as_given", (json_int_t)s->given, "worst", (json_int_t)s->worst,
                                   "sampled_poses", s->poses, "seed", (json_int_t)o->space.seed);
    json_object_set_new(report, "candidates", candidates);
  }
  if (s->path > 0) {
    json_object_set_new(report, "path",
                        json_pack("{s:s, s:I, s:i, s:s, s:s}", "file", o->path_file, "poses",
                                  (json_int_t)s->path, "latency_cycles", o->request.latency,
                                  "tree_pairs", pairs_told(o), "caches", "cold"));
    json_object_set_new(report, "engines", engines_json(answer));
  }
  json_object_set_new(report, "design", design_json(answer, answer->best));
  report_print_json(report);
}

bool size_names_printable(const size_options *o, sepax_error *error) {
  const char *other = o->is_scene ? o->scene.srdf : o->path_file;
  const char *const poses[2] = {other, other};
  return report_names_printable(o->path, error) &&
         (other == NULL || report_names_printable(poses, error));
}
