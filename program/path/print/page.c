/* SPDX-License-Identifier: MIT */
/* page.c - writes an HTML page that shows all bodies and plays the path. page.html is the page
 * itself. The data of the scene and three.js, which draws it, are inserted. */
#include "report/json.h"
#include "path/print/page.h"
#include "util/error.h"
#include "util/hash.h"
#include "util/text.h"
#include "util/write_file.h"

#include <float.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Bytes of data in a page. Browsers do not read longer strings. */
#define PAGE_MOST 400e6

static const char *const programs[PROGRAMS] = {"build/three.min.js",
                                               "examples/js/controls/OrbitControls.js"};

/* -------------------------------------------------------------------------- three.js */

static void free_programs(page *p) {
  for (int i = 0; i < PROGRAMS; i++) {
    free(p->program[i].bytes);
  }
}

/* Read three.js. It is inserted between <script> and </script>. */
static bool read_programs(page *p, sepax_error *error) {
  enum { PATH_MOST = 4096 };
  const char *given = getenv("SEPAX_THREE");
  const char *folder = given != NULL && *given != '\0' ? given : "/usr/share/javascript/three";
  for (int i = 0; i < PROGRAMS; i++) {
    char path[PATH_MOST];
    sepax_error inner = {0};
    text_bytes *text = &p->program[i];
    int length = snprintf(path, sizeof path, "%s/%s", folder, programs[i]);
    if (length < 0 || length >= PATH_MOST ||
        !sepax__text_read(text, path, PATH_PAGE_TEXT, &inner)) {
      return sepax_fail(error, SEPAX_ERROR_ARGUMENT,
                        "page: three.js is not at %.200s; install libjs-three, or set SEPAX_THREE "
                        "to the folder with %s",
                        folder, programs[i]);
    }
    if (strlen(text->bytes) != text->size || strstr(text->bytes, "</script") != NULL ||
        strstr(text->bytes, "<!--") != NULL) {
      return sepax_fail(error, SEPAX_ERROR_ARGUMENT,
                        "page: %.300s: cannot stand in a page; install libjs-three", path);
    }
  }
  return true;
}

bool path_page_possible(const path_scene *scene, sepax_error *error) {
  size_t triangles = 0;
  for (size_t n = 0; n < scene->bodies; n++) {
    triangles += scene->body[n].triangles;
  }
  double bytes = 24 * (double)triangles + 64 * (double)scene->bodies * (double)scene->motion.lines;
  if (bytes > PAGE_MOST) {
    return sepax_fail(error, SEPAX_ERROR_LIMIT,
                      "page: %zu triangles and %zu poses of %zu bodies are more than a page holds; "
                      "give a part of the path",
                      triangles, scene->motion.lines, scene->bodies);
  }
  page p = {.scene = scene};
  bool ok = read_programs(&p, error);
  free_programs(&p);
  return ok;
}

/* ---------------------------------------------------------------------------- base64 */

typedef struct {
  FILE *out;
  uint32_t held;
  int count; /* bytes held so far */
} base64;

static void put_letters(const base64 *b, int count) {
  static const char letters[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  for (int i = 0; i < 4; i++) {
    putc(i < count ? letters[b->held >> (18 - 6 * i) & 63] : '=', b->out);
  }
}

/* Write a word in little-endian bytes. */
static void put_word(base64 *b, uint64_t word, int bytes) {
  for (int i = 0; i < bytes; i++) {
    b->held = b->held << 8 | (uint32_t)(word >> (8 * i) & 0xff);
    if (++b->count == 3) {
      put_letters(b, 4);
      *b = (base64){b->out, 0, 0};
    }
  }
}

static void put_float(base64 *b, double x) {
  float f = (float)fmin(fmax(x, -FLT_MAX), FLT_MAX);
  uint32_t word;
  memcpy(&word, &f, sizeof word);
  put_word(b, word, sizeof word);
}

static base64 begin_base64(FILE *out) {
  putc('"', out);
  return (base64){out, 0, 0};
}

static void end_base64(base64 *b) {
  if (b->count > 0) {
    b->held <<= 8 * (3 - b->count);
    put_letters(b, b->count + 1);
  }
  putc('"', b->out);
}

/* ---------------------------------------------------------------------------- meshes */

/* The corners of a mesh as binary32, with equal corners merged. */
typedef struct {
  uint32_t (*vertex)[3]; /* bits of the floats */
  uint32_t *index;       /* vertex of each corner */
  uint32_t *place;       /* hash table of vertices, numbered from 1; 0 is a free entry */
  size_t vertices, mask;
} corners;

static void find_vertex(corners *c, size_t corner, const double v[3]) {
  uint32_t key[3];
  uint64_t hash = 0;
  for (int i = 0; i < 3; i++) {
    float f = (float)fmin(fmax(v[i], -FLT_MAX), FLT_MAX) + 0.0F; /* -0 is 0 */
    memcpy(&key[i], &f, sizeof key[i]);
    hash = hash_add(hash, key[i]);
  }
  size_t at = (size_t)hash & c->mask;
  while (c->place[at] != 0 && memcmp(c->vertex[c->place[at] - 1], key, sizeof key) != 0) {
    at = (at + 1) & c->mask;
  }
  if (c->place[at] == 0) {
    memcpy(c->vertex[c->vertices], key, sizeof key);
    c->place[at] = (uint32_t)++c->vertices;
  }
  c->index[corner] = c->place[at] - 1;
}

static bool write_mesh(FILE *out, const sepax_soup *mesh) {
  size_t count = 3 * mesh->count;
  corners c = {.mask = 1};
  while (c.mask < 2 * count) {
    c.mask = 2 * c.mask + 1;
  }
  c.vertex = calloc(count, sizeof *c.vertex);
  c.index = calloc(count, sizeof *c.index);
  c.place = calloc(c.mask + 1, sizeof *c.place);
  bool ok = c.vertex != NULL && c.index != NULL && c.place != NULL;
  if (ok) {
    for (size_t n = 0; n < count; n++) {
      find_vertex(&c, n, mesh->facet[n / 3].v[n % 3]);
    }
    int bytes = c.vertices <= 0x10000 ? 2 : 4;
    fputs("\"vertex\": ", out);
    base64 b = begin_base64(out);
    for (size_t n = 0; n < 3 * c.vertices; n++) {
      put_word(&b, c.vertex[n / 3][n % 3], 4);
    }
    end_base64(&b);
    fprintf(out, ", \"index_bytes\": %d, \"index\": ", bytes);
    b = begin_base64(out);
    for (size_t n = 0; n < count; n++) {
      put_word(&b, c.index[n], bytes);
    }
    end_base64(&b);
  }
  free(c.vertex);
  free(c.index);
  free(c.place);
  return ok;
}

/* ----------------------------------------------------------------------------- poses */

static bool moves(const path_scene *scene, const sepax_chain *chain) {
  const format_motion *motion = &scene->motion;
  for (size_t line = 1; line < motion->lines; line++) {
    for (size_t n = 0; n < chain->count; n++) {
      size_t joint = chain->joint[n];
      if (motion->value[line * motion->joints + joint] != motion->value[joint]) {
        return true;
      }
    }
  }
  return false;
}

/* Write rotation and translation of a body in each step, in the root's coordinates. If no line
 * moves the body, then only those of the first step are written. */
static bool write_poses(FILE *out, const page *p, size_t link) {
  const path_scene *scene = p->scene;
  const sepax_mechanism *m = &scene->robot.mechanism;
  double *value = malloc((m->joints + 1) * sizeof *value);
  sepax_chain chain;
  sepax_error error = {0};
  if (value == NULL || !sepax_chain_find(&chain, m, m->root, link, &error)) {
    free(value);
    return false;
  }
  size_t steps = moves(scene, &chain) ? p->steps : 1;
  fputs(", \"pose\": ", out);
  base64 b = begin_base64(out);
  for (size_t n = 0; n < steps; n++) {
    sepax_pose pose[2];
    path_values(&scene->motion, p->step[n], value);
    sepax_chain_poses(&chain, m, value, pose);
    for (int i = 0; i < 12; i++) {
      put_float(&b, i % 4 < 3 ? pose[1].rotation[i / 4][i % 4] : pose[1].translation[i / 4]);
    }
  }
  end_base64(&b);
  sepax_chain_free(&chain);
  free(value);
  return true;
}

/* ---------------------------------------------------------------------------- steps */

static int by_time(const void *a, const void *b) {
  const path_moment *p = a;
  const path_moment *q = b;
  return p->line != q->line ? (p->line > q->line) - (p->line < q->line)
                            : (p->part > q->part) - (p->part < q->part);
}

static bool find_steps(page *p, sepax_error *error) {
  const path_scene *scene = p->scene;
  size_t most = scene->motion.lines + scene->pairs;
  p->step = malloc(most * sizeof *p->step);
  if (p->step == NULL) {
    return sepax_fail(error, SEPAX_ERROR_MEMORY, "no memory for %zu poses", most);
  }
  for (size_t n = 0; n < scene->motion.lines; n++) {
    p->step[p->steps++] = (path_moment){n, 0};
  }
  for (size_t n = 0; n < scene->pairs; n++) {
    if (path_between_lines(&scene->pair[n]) != VERDICT_FREE) {
      p->step[p->steps++] = path_between_moment(&scene->pair[n]);
    }
  }
  qsort(p->step, p->steps, sizeof *p->step, by_time);
  size_t kept = 1;
  for (size_t n = 1; n < p->steps; n++) {
    if (by_time(&p->step[n], &p->step[kept - 1]) != 0) {
      p->step[kept++] = p->step[n];
    }
  }
  p->steps = kept;
  return true;
}

/* The verdict of a pair at a moment. Between lines only pairs with a result there have one. */
static int verdict_at(const path_pair *pair, path_moment at) {
  path_moment between = path_between_moment(pair);
  return at.part == 0                  ? pair->verdict[at.line]
         : by_time(&at, &between) == 0 ? (int)path_between_lines(pair)
                                       : VERDICT_FREE;
}

/* ------------------------------------------------------------------------------ data */

static bool write_report(FILE *out, const page *p) {
  json_t *report = path_report(p->scene, p->q);
  bool ok = json_dump_callback(report, path_page_put, out, JSON_ENSURE_ASCII) == 0;
  json_decref(report);
  return ok;
}

/* Write the lines as [first line, number of lines in a row, ...]. */
static void write_lines(FILE *out, const page *p) {
  const size_t *line = p->scene->motion.line;
  fprintf(out, ",\n\"line\": [%zu", line[0]);
  size_t first = 0;
  for (size_t n = 1; n < p->steps; n++) {
    if (line[p->step[n].line] != line[p->step[n - 1].line] + 1) {
      fprintf(out, ", %zu, %zu", n - first, line[p->step[n].line]);
      first = n;
    }
  }
  fprintf(out, ", %zu]", p->steps - first);
}

/* Write the steps between lines as [step, part of the way after its line, ...], and the worst
 * step. */
static void write_parts(FILE *out, const page *p) {
  const path_pair *pair = NULL;
  path_moment worst = path_worst_moment(p->scene, &pair);
  size_t at = 0;
  const char *before = "";
  fputs(",\n\"part\": [", out);
  for (size_t n = 0; n < p->steps; n++) {
    if (p->step[n].part > 0) {
      fprintf(out, "%s%zu, %.17g", before, n, p->step[n].part);
      before = ", ";
    }
    at = by_time(&p->step[n], &worst) == 0 ? n : at;
  }
  fprintf(out, "],\n\"worst\": %zu", at);
}

/* Write the verdicts of a pair as [verdict, number of steps in a row, ...]. */
static void write_verdicts(FILE *out, const page *p, const path_pair *pair) {
  int last = verdict_at(pair, p->step[0]);
  size_t first = 0;
  fprintf(out, "[%d", last);
  for (size_t n = 1; n < p->steps; n++) {
    int verdict = verdict_at(pair, p->step[n]);
    if (verdict != last) {
      fprintf(out, ", %zu, %d", n - first, verdict);
      first = n;
      last = verdict;
    }
  }
  fprintf(out, ", %zu]", p->steps - first);
}

static void write_times(FILE *out, const page *p) {
  const format_motion *motion = &p->scene->motion;
  base64 b = begin_base64(out);
  for (size_t n = 0; n < p->steps && motion->time != NULL; n++) {
    double time = path_time(motion, p->step[n]);
    uint64_t word;
    memcpy(&word, &time, sizeof word);
    put_word(&b, word, sizeof word);
  }
  end_base64(&b);
}

/* The step of the page that is a line. */
static size_t step_of(const page *p, size_t line) {
  size_t n = line;
  while (n + 1 < p->steps && p->step[n].line < line) {
    n++;
  }
  return n;
}

/* Cores are within flutes, and the finished part is within the stock as it is cut. */
static bool is_shown(const page *p, size_t body) {
  const char *role = p->scene->body[body].role;
  bool is_part = role == NULL && p->q->part != NULL && p->scene->stock.snapshots > 0 &&
                 strcmp(path_body_name(p->scene, body), p->q->part) == 0;
  return !is_part && (role == NULL || strcmp(role, "core") != 0);
}

static bool write_data(FILE *out, const page *p) {
  const path_scene *scene = p->scene;
  fputs("{\"report\": ", out);
  bool ok = write_report(out, p);
  write_parts(out, p);
  write_lines(out, p);
  path_page_program(out, p);
  fputs(",\n\"time\": ", out);
  write_times(out, p);
  fputs(",\n\"verdict\": [", out);
  for (size_t n = 0; n < scene->pairs; n++) {
    fputs(n == 0 ? "\n" : ",\n", out);
    write_verdicts(out, p, &scene->pair[n]);
  }
  fputs("],\n\"body\": [", out);
  for (size_t n = 0; n < scene->bodies && ok; n++) {
    size_t tool = scene->body[n].tool;
    fprintf(out, "%s{\"tool\": %ld, \"shown\": %s, ", n == 0 ? "\n" : ",\n",
            tool == FORMAT_NO_NAME ? -1L : (long)tool, is_shown(p, n) ? "true" : "false");
    ok = write_mesh(out, &scene->body[n].mesh) && write_poses(out, p, scene->body[n].link);
    putc('}', out);
  }
  fputs("],\n\"stock\": [", out);
  for (size_t n = 0; n < scene->stock.snapshots && ok; n++) {
    fprintf(out, "%s{\"body\": %zu, \"at\": %zu, ", n > 0 ? ",\n" : "\n", scene->stock.body,
            step_of(p, scene->stock.snapshot[n].line));
    ok = write_mesh(out, &scene->stock.snapshot[n].mesh);
    putc('}', out);
  }
  fputs("]}", out);
  return ok;
}

static bool write_program(FILE *out, const text_bytes *text) {
  return fwrite(text->bytes, 1, text->size, out) == text->size;
}

/* Write page.html and fill in each hole. */
static bool write_all(FILE *out, const void *context) {
  static const char *const holes[] = {"@three@", "@controls@", "@data@"};
  const page *p = context;
  const char *at = path_page_html;
  bool ok = true;
  for (int i = 0; i <= PROGRAMS && ok; i++) {
    const char *hole = strstr(at, holes[i]);
    if (hole == NULL) {
      return false;
    }
    ok = fwrite(at, 1, (size_t)(hole - at), out) == (size_t)(hole - at) &&
         (i < PROGRAMS ? write_program(out, &p->program[i]) : write_data(out, p));
    at = hole + strlen(holes[i]);
  }
  return ok && fputs(at, out) != EOF && ferror(out) == 0;
}

bool path_write_page(const path_scene *scene, const path_question *q, sepax_error *error) {
  page p = {.scene = scene, .q = q};
  bool ok = read_programs(&p, error) && find_steps(&p, error) &&
            sepax_write_file(q->page, write_all, &p, error);
  free_programs(&p);
  free(p.step);
  return ok;
}
