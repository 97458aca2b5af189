/* SPDX-License-Identifier: MIT */
/* command.c - sepax path: calls the parts that read, search, certify and write. */
#include "command_table.h"
#include "path/stock/cutting.h"
#include "path/jobs/engine.h"
#include "path/nc/program.h"
#include "util/error.h"
#include "util/write_file.h"

/* What --word and --intervals are if they are not given. */
enum { WORD = 18, INTERVALS = 1 << 18 };

enum { OUTPUTS = 8 };

static const char *output_of(const path_question *q, int n) {
  const char *const outputs[OUTPUTS] = {q->csv,  q->picture, q->certificate, q->page,
                                        q->jobs, q->written, q->left,        q->tube};
  return outputs[n];
}

/* Fail before the long search if an output file cannot be written. */
static bool outputs_possible(const path_question *q, sepax_error *error) {
  const char *const inputs[] = {q->urdf,    q->motion,     q->srdf, q->table,
                                q->machine, q->tool_table, q->first};
  const char *outputs[OUTPUTS];
  for (int i = 0; i < OUTPUTS; i++) {
    outputs[i] = output_of(q, i);
  }
  bool ok = cli_outputs_allowed(outputs, OUTPUTS, inputs, 7, error);
  for (int i = 0; i < OUTPUTS && ok; i++) {
    ok = outputs[i] == NULL || sepax__write_file_possible(outputs[i], error);
  }
  return ok;
}

static bool meshes_spared(const path_scene *scene, const path_question *q, sepax_error *error) {
  for (int i = 0; i < OUTPUTS; i++) {
    const char *output = output_of(q, i);
    for (size_t n = 0; n < scene->robot.shapes && output != NULL; n++) {
      const char *mesh = scene->robot.shape[n].path;
      if (mesh != NULL && cli_same_file(output, mesh)) {
        return sepax_fail(error, SEPAX_ERROR_ARGUMENT,
                          "%.300s: is a mesh of the scene; name another file to write", output);
      }
    }
  }
  return true;
}

int cli_path(int argc, char **argv) {
  path_question q;
  path_parse(&q, argc, argv);
  sepax_error error = {0};
  path_scene scene = {.pairs = 0};
  q.certify = q.certify || q.machine != NULL; /* rows of a program are places between its lines */
  q.keep = q.stock != NULL || (q.tools != NULL && q.certificate != NULL) || q.picture != NULL ||
           q.page != NULL || q.jobs != NULL;
  q.word = q.jobs != NULL && q.word == 0 ? WORD : q.word;
  bool ok = path_options_agree(&q, &error) && outputs_possible(&q, &error);
  q.intervals = q.intervals == 0 ? INTERVALS : q.intervals;
  q.no_distance = q.no_distance || (q.output.quiet && q.picture == NULL && q.page == NULL);
  ok = ok && path_scene_load(&scene, &q, &error) && meshes_spared(&scene, &q, &error) &&
       (q.page == NULL || path_page_possible(&scene, &error)) &&
       (q.jobs == NULL || path_write_jobs(&scene, &q, &error)) && path_search(&scene, &q, &error) &&
       (q.written == NULL || path_program_write(&scene, q.written, &error)) &&
       (!q.certify || path_certify(&scene, &q, &error)) &&
       (scene.stock.cell == 0 || path_cutting_run(&scene, &q, &error)) &&
       (q.csv == NULL || path_write_csv(&scene, q.csv, &error)) &&
       (q.picture == NULL || path_write_picture(&scene, q.picture, &error)) &&
       (q.certificate == NULL || path_write_certificate(&scene, &q, &error)) &&
       (q.tube == NULL || path_write_tube(&scene, &q, &error)) &&
       (q.page == NULL || path_write_page(&scene, &q, &error));
  int result = ok ? report_verdict_status[path_worst(&scene)] : cli_fail(argv[0], &error);
  if (ok && !q.output.quiet) {
    (q.output.json ? path_print_json : path_print_text)(&scene, &q);
  }
  path_scene_free(&scene);
  return result;
}
