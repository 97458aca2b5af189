/* SPDX-License-Identifier: MIT */
/* grid.c - answers for sepax check --grid: the judgement of a design on two bodies that are rounded
 * to its grid. */
#include "body/big.h"
#include "check/parts.h"
#include "util/error.h"
#include "util/list.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* ------------------------------------------------------------ lengths in steps */

/* size * 2^two * 5^five */
typedef struct {
  unsigned __int128 size;
  int two, five;
} exact_length;

static exact_length length_of_decimal(const cli_decimal *decimal) {
  exact_length length = {0, 0, 0};
  if (decimal->digits[0] != '\0') {
    length.two = length.five = decimal->power;
  }
  for (const char *c = decimal->digits; *c != '\0'; c++) {
    length.size = 10 * length.size + (unsigned)(*c - '0');
  }
  return length;
}

static exact_length length_of_double(double value) {
  int power = 0;
  double fraction = frexp(value, &power);
  return (exact_length){(unsigned __int128)ldexp(fraction, 53), power - 53, 0};
}

static void set_big(big *r, uint64_t times, const exact_length *p, int two, int five) {
  const big base = {1, 1, {5}};
  big factor = {times != 0, times != 0, {times}};
  big size = {0, 0, {0}};
  big_add_shifted(&size, 1, p->size, p->two - two);
  big_multiply(r, &size, &factor);
  for (int n = p->five; n > five; n--) {
    big_copy(&factor, r);
    factor.sign = r->sign;
    big_multiply(r, &factor, &base);
  }
}

/* Are `steps` steps of the grid at least as long as the length? */
static bool reaches(uint64_t steps, const exact_length *step, const exact_length *length) {
  int two = step->two < length->two ? step->two : length->two;
  int five = step->five < length->five ? step->five : length->five;
  big p;
  big q;
  set_big(&p, steps, step, two, five);
  set_big(&q, 1, length, two, five);
  return big_compare_sizes(&p, &q) >= 0;
}

/* The least number of steps of the grid that is not shorter than the length. It is exact for the
 * decimals as they are written. If the grid was fitted, then it is exact for its resolution as a
 * double. False above 2^31 - 1. */
static bool count_steps(const char *length, const cli_grid *asked, double resolution, int *steps) {
  cli_decimal decimal;
  cli_scan_decimal(length, cli_lengths, CLI_MILLIMETRES, &decimal);
  exact_length whole = length_of_decimal(&decimal);
  exact_length step = length_of_double(resolution);
  if (asked->resolution != NULL) {
    cli_scan_decimal(asked->resolution, cli_lengths, CLI_MILLIMETRES, &decimal);
    step = length_of_decimal(&decimal);
  }
  double value = 0;
  cli_scan_length(length, &value);
  double guess = ceil(value / resolution);
  if (!(guess <= INT32_MAX)) {
    return false;
  }
  uint64_t count = (uint64_t)guess;
  while (count > 0 && reaches(count - 1, &step, &whole)) {
    count--;
  }
  while (!reaches(count, &step, &whole)) {
    count++;
  }
  *steps = count <= INT32_MAX ? (int)count : 0;
  return count <= INT32_MAX;
}

/* Put the clearance and the warning distance into the design, in LSB of the grid. */
static bool set_limits(const check_question *q, check_report *report, sepax_design *design,
                       sepax_error *error) {
  sepax_config config = q->config;
  const report_limit *limits[] = {&q->bands.clearance, &q->bands.warning};
  static const char *const name[] = {"clearance", "warning"};
  int *lsb[] = {&config.clearance, &config.warning};
  for (int i = 0; i < 2; i++) {
    if (limits[i]->text != NULL &&
        !count_steps(limits[i]->text, &q->grid, report->grid.resolution, lsb[i])) {
      return sepax_fail(error, SEPAX_ERROR_ARGUMENT,
                        "%s: %.40s is above 2^31 LSB of %g mm; give a coarser resolution", name[i],
                        limits[i]->text, report->grid.resolution);
    }
  }
  report->steps = (report_steps){config.clearance, config.warning, report->grid.resolution};
  return sepax_design_init(design, &config, error);
}

/* ------------------------------------------------------------------ verdicts */

/* True if the design calls the pair a collision because it could not decide the pair. */
static bool is_undecided(const sepax_design *design, const sepax_judgement *verdict) {
  return verdict->axis == SEPAX_AXIS_EXTENT ||
         (design->config.flag && verdict->coplanar && verdict->collision);
}

static bool judge_all(const check_question *q, const sepax_design *design, const sepax_scene *scene,
                      check_answer *answer, double *seconds, sepax_error *error) {
  cli_progress progress = cli_progress_begin("pairs", (uint64_t)scene->count[0] * scene->count[1]);
  size_t capacity[2] = {0, 0};
  bool ok = true;
  bool done = false;
  for (size_t i = 0; i < scene->count[0] && ok && !done; i++) {
    for (size_t j = 0; j < scene->count[1] && ok && !done; j++) {
      sepax_pair pair = sepax_scene_pair(scene, i, j);
      sepax_judgement verdict = sepax_judge(design, &pair);
      if (verdict.collision) {
        bool open = is_undecided(design, &verdict);
        ok = list_add_pair(open ? &answer->undecided : &answer->colliding, &capacity[open], i, j);
        done = !open && (q->first || check_any_is_enough(q));
      }
    }
    cli_progress_show(&progress, (uint64_t)(i + 1) * scene->count[1]);
  }
  *seconds = cli_progress_end(&progress);
  return ok || sepax_fail(error, SEPAX_ERROR_MEMORY, "no memory for %zu collisions",
                          answer->colliding.count);
}

static bool show(void *context, uint64_t done, uint64_t total) {
  cli_progress *progress = context;
  progress->total = total;
  cli_progress_show(progress, done);
  return true;
}

/* Split the pairs that are not free: colliding pairs stay, pairs in band WARNING move to the other
 * list. */
static bool divide_bands(const sepax_design *design, const sepax_scene *scene,
                         check_answer *answer) {
  sepax_pairs *all = &answer->colliding;
  size_t colliding = 0;
  answer->warned.pair = malloc((all->count + 1) * sizeof *all->pair);
  if (answer->warned.pair == NULL) {
    return false;
  }
  for (size_t k = 0; k < all->count; k++) {
    sepax_pair pair = sepax_scene_pair(scene, all->pair[k][0], all->pair[k][1]);
    bool collides = sepax_clearance(design, &pair.a, &pair.b).collision;
    size_t *to = collides ? all->pair[colliding++] : answer->warned.pair[answer->warned.count++];
    memmove(to, all->pair[k], sizeof *all->pair);
  }
  all->count = colliding;
  return true;
}

static bool search(const check_question *q, const sepax_design *design, const sepax_scene *scene,
                   check_answer *answer, double *seconds, sepax_error *error) {
  cli_progress progress = cli_progress_begin("leaves", 1);
  bool bands = design->limits > 0;
  sepax_search how = {.size = sizeof(sepax_search),
                      .threads = q->threads,
                      .first = !bands && (q->first || check_any_is_enough(q)),
                      .progress = show,
                      .context = &progress};
  bool ok = bands ? sepax_near_pairs(design, false, scene->tri[0], scene->count[0], scene->tri[1],
                                     scene->count[1], &how, &answer->colliding, error)
                  : sepax_colliding_pairs(scene->tri[0], scene->count[0], scene->tri[1],
                                          scene->count[1], &how, &answer->colliding, error);
  *seconds = cli_progress_end(&progress);
  return ok && (!bands || divide_bands(design, scene, answer) ||
                sepax_fail(error, SEPAX_ERROR_MEMORY, "no memory for the pairs found"));
}

/* Architecture exact without --coplanar=flag and extents searches by halving lists of AABBs. All
 * other designs judge every pair, one after the other. */
static bool find(const check_question *q, const sepax_design *design, const sepax_scene *scene,
                 check_report *report, sepax_error *error) {
  const sepax_config *config = &q->config;
  check_answer *answer = report->answer;
  bool exact = config->arch == SEPAX_ARCH_EXACT && !config->flag && config->extent_a == 0;
  bool ok = (exact ? search : judge_all)(q, design, scene, answer, &report->seconds, error);
  answer->verdict = answer->colliding.count > 0   ? VERDICT_COLLISION
                    : answer->undecided.count > 0 ? VERDICT_UNDECIDED
                    : answer->warned.count > 0    ? VERDICT_WARNING
                                                  : VERDICT_FREE;
  return ok;
}

/* The rounded triangles, in mm, for --ply. */
static bool fill_mesh(const sepax_scene *scene, int i, sepax_soup *mesh) {
  mesh->facet = sepax_allocate((scene->count[i] + 1) * sizeof *mesh->facet);
  if (mesh->facet == NULL) {
    return false;
  }
  mesh->count = scene->count[i];
  for (size_t n = 0; n < 3 * mesh->count; n++) {
    const sepax_vec *v = &scene->tri[i][n / 3].v[n % 3];
    const int32_t at[3] = {v->x, v->y, v->z};
    for (int axis = 0; axis < 3; axis++) {
      mesh->facet[n / 3].v[n % 3][axis] =
          scene->grid.offset[axis] + scene->grid.resolution * at[axis];
    }
  }
  return true;
}

bool check_on_grid(const check_question *q, check_report *report, sepax_error *error) {
  sepax_scene scene;
  sepax_design design = {0};
  if (!cli_scene_load(&scene, report->file, q->path, &q->meshes, &q->grid, error)) {
    return false;
  }
  report->grid = scene.grid;
  report->answer = calloc(1, sizeof *report->answer);
  if (report->answer == NULL) {
    sepax_scene_free(&scene);
    return sepax_fail(error, SEPAX_ERROR_MEMORY, "no memory for the verdict");
  }
  report->answers = 1;
  bool ok = set_limits(q, report, &design, error) && find(q, &design, &scene, report, error);
  for (int i = 0; i < 2; i++) {
    report->triangles[i] = scene.count[i];
    if (ok && q->ply_path != NULL && !fill_mesh(&scene, i, &report->mesh[i])) {
      ok = sepax_fail(error, SEPAX_ERROR_MEMORY, "no memory for the picture of %zu triangles",
                      scene.count[i]);
    }
  }
  sepax_scene_free(&scene);
  return ok;
}
