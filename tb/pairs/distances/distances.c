/* SPDX-License-Identifier: MIT */
/* distances - intervals of the distance of two bodies, and what sepax_bodies_apart says, against
 * the oracle in rational numbers.
 *   distances COUNT SEED [FAULT]   COUNT cases: two bodies in poses, with 6 requests of a distance
 *                                  and 6 of a verdict each. A line a kind of bodies: cases,
 * answers, touching cases, answers that a budget ended, wrong answers. Exit status 1: one is wrong
 * FAULT names a fault that is put into each answer before it is checked (see faults[]): a check
 * that works is then red.
 *
 * Bodies of up to 60 triangles are drawn so that many pairs are equally near, or nearly, and every
 * pair is measured without rounding. Of the large bodies (kind "large") the exact mode's pair is
 * measured so. Requests have tolerances, limits about the distance, budgets of work, and results of
 * other poses. A front is kept along small motions, jumps and other bodies. The same request gives
 * the same bytes again. Without vector instructions an answer may be another one, which is checked
 * as well. */
#include "checks.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static const char *const kind_names[KINDS] = {"strewn", "tied",    "touching", "nested",
                                              "copy",   "sliver",  "mixed",    "far",
                                              "alike",  "on_edge", "spheres",  "large"};

static const char *const fault_names[FAULTS] = {"",      "least", "most",  "width", "pair", "ulp",
                                                "bytes", "work",  "limit", "front", "apart"};

fault planted;
tally *counted;
static const char *at_work; /* the kind */
static uint64_t case_number;

void wrong(const char *format, ...) {
  enum { SHOWN = 5 };
  if (counted->wrong++ < SHOWN) {
    va_list list;
    va_start(list, format);
    fprintf(stderr, "%s, case %" PRIu64 ": ", at_work, case_number);
    vfprintf(stderr, format, list);
    fputc('\n', stderr);
    va_end(list);
  }
}

/* --------------------------------------------------------------------------- requests */

static double draw_tolerance(sepax_random *r) {
  static const double tolerances[] = {1e-3, 1e-6, 1e-6, 1e-12, 0x1p-52, 0.5};
  return tolerances[range(r, 0, 5)];
}

uint64_t draw_budget(sepax_random *r) {
  static const uint64_t budgets[] = {1, 2, 10, 50, 100, 1000, 3000, 10000};
  return budgets[range(r, 0, 7)];
}

/* A length about the distance: below, above, or next to it. */
double draw_length(const situation *s, sepax_random *r) {
  double x = s->below;
  switch (range(r, 0, 6)) {
  case 0:
    return x;
  case 1:
    return down(x);
  case 2:
    return up(x);
  case 3:
    return x * (1 - little(r, 0, 52));
  case 4:
    return fmin(x * (1 + little(r, 0, 52)), 0x1p999);
  case 5:
    return fmin(2 * x, 0x1p999);
  default:
    return 0.5 * x;
  }
}

/* A result of another pose, or of this one, which may be a collision, or infinite. */
static sepax_distance_result draw_last(const situation *s, const sepax_distance_result *exact,
                                       sepax_random *r) {
  if (one_in(r, 3)) {
    return *exact;
  }
  situation other = *s;
  double away = one_in(r, 2) ? s->below : 4 * s->below;
  other.pose[1] = any_pose(fmin(fmax(away, 0x1p-900), 0x1p900), r);
  other.given[1] = &other.pose[1];
  double limit = one_in(r, 5) ? s->below : 0;
  return ask(&other, &SEPAX_STRUCT(sepax_distance_request, .relative = 1e-3, .limit = limit));
}

static void draw_request(sepax_distance_request *q, const situation *s, sepax_random *r) {
  *q = SEPAX_STRUCT(sepax_distance_request, .limit = 0);
  if (!one_in(r, 4)) {
    q->relative = draw_tolerance(r);
  }
  if (one_in(r, 4)) {
    q->absolute = one_in(r, 2) ? s->below * draw_tolerance(r) : little(r, 0, 100);
  }
  if (one_in(r, 2)) {
    q->work = draw_budget(r);
  }
  if (one_in(r, 4)) {
    q->limit = draw_length(s, r);
  }
}

/* ------------------------------------------------------------------------------ checks */

/* Both answers, member by member, because the bytes between members may have any value. */
static bool same_bytes(const sepax_distance_result *p, const sepax_distance_result *q) {
  bool same = bits_of(p->min_distance) == bits_of(q->min_distance) &&
              bits_of(p->least) == bits_of(q->least) && bits_of(p->most) == bits_of(q->most);
  for (int k = 0; k < 6; k++) {
    same = same &&
           bits_of(p->nearest_points[k / 3][k % 3]) == bits_of(q->nearest_points[k / 3][k % 3]);
  }
  for (int k = 0; k < 2; k++) {
    same = same && p->pair[k] == q->pair[k] && p->box[k] == q->box[k];
  }
  return same && p->work == q->work && p->ended == q->ended;
}

const char *said(sepax_simd second) {
  return second == SEPAX_SIMD_PORTABLE ? ", then without vector instructions," : "";
}

static void plant(sepax_distance_result *a, const sepax_distance_request *q, const situation *s) {
  bool exact = q->relative == 0 && q->absolute == 0;
  switch (planted) {
  case LEAST_ABOVE:
    a->least = up(s->below);
    break;
  case MOST_BELOW:
    a->most = s->is_double ? down(s->below) : s->below;
    break;
  case TOO_WIDE:
    if (isfinite(a->most) && !a->ended && q->absolute < a->most) {
      a->least = 0;
      a->most *= 2;
    }
    break;
  case OTHER_PAIR:
    a->pair[0] = (a->pair[0] + 1) % s->count[0];
    break;
  case ONE_ULP:
    a->min_distance = exact ? up(up(a->min_distance)) : a->min_distance;
    break;
  case TOO_MUCH:
    a->work = q->work + OVERSHOOT + 1;
    break;
  case LOST:
    if (q->limit > 0) {
      *a = (sepax_distance_result){.min_distance = INFINITY, .least = a->least, .most = INFINITY};
    }
    break;
  default:
    break;
  }
}

/* The distance between the answer's points is that of the pair, but for rounding. */
static bool points_fit(const situation *s, const sepax_distance_result *a) {
  long double square = 0;
  double size = 0;
  for (int i = 0; i < 3; i++) {
    long double way = (long double)a->nearest_points[1][i] - (long double)a->nearest_points[0][i];
    square += way * way;
  }
  for (int k = 0; k < 2; k++) {
    for (int n = 0; n < 9; n++) {
      size = fmax(size, fabs(s->facet[k][a->pair[k]].v[n / 3][n % 3]));
      size = fmax(size, s->given[k] != NULL ? fabs(s->given[k]->translation[n % 3]) : 0);
    }
  }
  return fabsl(sqrtl(square) - (long double)a->min_distance) <=
         0x1p-48L * (long double)size + 0x1p-1070L;
}

static void check_pair(const situation *s, const sepax_distance_result *a) {
  double m = a->min_distance;
  if (a->pair[0] >= s->count[0] || a->pair[1] >= s->count[1]) {
    wrong("there is no pair %zu, %zu", a->pair[0], a->pair[1]);
    return;
  }
  double posed = sepax_distance_posed(s->facet[0][a->pair[0]].v, s->given[0],
                                      s->facet[1][a->pair[1]].v, s->given[1], NULL);
  if (posed != m) {
    wrong("min_distance is %a, but that of its pair is %a", m, posed);
  }
  exact_square square;
  exact_square_init(&square);
  find_pair_square(s, a->pair, &square);
  bool right = m == 0 ? exact_square_compare_length(&square, 0) == 0
                      : exact_square_compare_length(&square, down(m)) > 0 &&
                            exact_square_compare_length(&square, up(m)) < 0;
  exact_square_clear(&square);
  if (!right) {
    wrong("min_distance %a is not right to one unit in the last place for its pair", m);
  }
  if (!points_fit(s, a)) {
    wrong("the nearest points are not min_distance %a apart", m);
  }
}

static void check_interval(const situation *s, const sepax_distance_request *q,
                           const sepax_distance_result *a) {
  double most = s->slack_ulps > 0 ? up(a->most) : a->most;
  if (!(a->least >= 0 && a->least <= a->most)) {
    wrong("the interval is %a ... %a", a->least, a->most);
  } else if (order(s, a->least) < 0) {
    wrong(
        "least is %a, above the distance: %a is below it (tolerance %g, %g, limit %a, work %" PRIu64
        "%s)",
        a->least, s->below, q->relative, q->absolute, q->limit, q->work,
        q->last != NULL ? ", last" : "");
  } else if (order(s, most) > 0) {
    wrong("most is %a, below the distance of at least %a", a->most, s->below);
  }
}

static void check_width(const situation *s, const sepax_distance_request *q,
                        const sepax_distance_result *a) {
  double m = a->min_distance;
  long double width = (long double)a->most - (long double)a->least;
  bool neighbours = a->least >= down(m) && a->most <= up(m);
  bool within =
      width <= (long double)q->relative * (long double)a->most || width <= (long double)q->absolute;
  if (!within && !neighbours) {
    wrong("the interval %a ... %a is wider than its tolerance: %g, %g", a->least, a->most,
          q->relative, q->absolute);
  }
  bool exact = q->relative == 0 && q->absolute == 0;
  double slack = s->slack_ulps > 0 ? up(m) : m;
  if (exact && !(m == 0 ? order(s, 0) == 0 : order(s, down(m)) > 0 && order(s, up(slack)) < 0)) {
    wrong("the exact distance is not %a but near %a", m, s->below);
  }
}

static void check_limits(const situation *s, const sepax_distance_request *q,
                         const sepax_distance_result *a) {
  if (q->work == 0 && a->ended) {
    wrong("a search without a budget ended");
  }
  if (q->work > 0 && a->work > q->work + OVERSHOOT) {
    wrong("%" PRIu64 " units of work within a budget of %" PRIu64, a->work, q->work);
  }
  if (q->work > 0 && a->ended && a->work < q->work) {
    wrong("ended after %" PRIu64 " units of a budget of %" PRIu64, a->work, q->work);
  }
  if (a->min_distance == INFINITY) {
    if (!a->ended && !(q->limit > 0 && a->least >= q->limit && order(s, q->limit) >= 0)) {
      wrong("infinite, with least %a, at a limit of %a and a distance near %a", a->least, q->limit,
            s->below);
    }
    if (a->most != INFINITY) {
      wrong("most is %a where min_distance is infinite", a->most);
    }
  } else if (q->limit > 0 && a->min_distance > q->limit) {
    wrong("%a is above the limit of %a and is not infinite", a->min_distance, q->limit);
  }
}

static void check_answer(const situation *s, const sepax_distance_request *q,
                         sepax_distance_result *a) {
  plant(a, q, s);
  counted->ended += a->ended;
  check_interval(s, q, a);
  check_limits(s, q, a);
  if (a->min_distance != INFINITY) {
    check_pair(s, a);
    if (!a->ended) {
      check_width(s, q, a);
    }
  }
}

static void check_distances(const situation *s, sepax_random *r) {
  const sepax_distance_request plain = SEPAX_STRUCT(sepax_distance_request, .limit = 0);
  sepax_distance_result exact = ask(s, &plain);
  sepax_distance_result last;
  check_answer(s, &plain, &exact);
  exact = ask(s, &plain);
  for (int n = 0; n < REQUESTS; n++) {
    sepax_distance_request q;
    draw_request(&q, s, r);
    if (one_in(r, 2)) {
      last = draw_last(s, &exact, r);
      q.last = &last;
    }
    sepax_distance_result answer = ask(s, &q);
    q.simd = one_in(r, 2) ? SEPAX_SIMD_BEST : SEPAX_SIMD_PORTABLE;
    sepax_distance_result again = ask(s, &q);
    again.box[0] ^= planted == OTHER_BYTES;
    if (q.simd == SEPAX_SIMD_BEST && !same_bytes(&answer, &again)) {
      wrong("the same arguments%s gave %a ... %a (%" PRIu64 " units) and %a ... %a (%" PRIu64
            " units)",
            said(q.simd), answer.least, answer.most, answer.work, again.least, again.most,
            again.work);
    }
    check_answer(s, &q, q.simd == SEPAX_SIMD_BEST ? &answer : &again);
  }
  if (one_in(r, 16)) {
    sepax_distance_request q = SEPAX_STRUCT(sepax_distance_request, .seconds = 1e-7);
    sepax_distance_result hurried = ask(s, &q);
    check_interval(s, &q, &hurried);
  }
}

/* --------------------------------------------------------------------------- campaign */

/* One case in so many is of large bodies, which take longer. */
enum { LARGE_EVERY = 24 };

static fault fault_of(const char *name) {
  int n = 1;
  while (n < FAULTS && strcmp(fault_names[n], name) != 0) {
    n++;
  }
  return (fault)n;
}

int main(int argc, char **argv) {
  char *end[2] = {NULL, NULL};
  bool ok = argc == 3 || argc == 4;
  uint64_t count = ok ? strtoull(argv[1], &end[0], 10) : 0;
  sepax_random random = {ok ? strtoull(argv[2], &end[1], 10) : 0};
  planted = argc == 4 ? fault_of(argv[3]) : NO_FAULT;
  if (count == 0 || *end[0] != '\0' || *end[1] != '\0' || planted == FAULTS) {
    fputs("usage: distances COUNT SEED [least|most|width|pair|ulp|bytes|work|limit|front|apart]\n",
          stderr);
    return 2;
  }
  tally of[KINDS] = {{0}};
  uint64_t all_wrong = 0;
  make_pool();
  for (uint64_t n = 0; n < count; n++) {
    kind what = n % LARGE_EVERY == LARGE_EVERY - 1 ? LARGE : (kind)(n % LARGE);
    situation s = {.count = {0, 0}};
    counted = &of[what];
    at_work = kind_names[what];
    case_number = n;
    draw_situation(&s, what, &random);
    find_truth(&s, what);
    counted->cases++;
    counted->touching += order(&s, 0) == 0;
    check_distances(&s, &random);
    check_all_apart(&s, &random);
    if (one_in(&random, 3)) {
      check_walk(&s, what, &random);
    }
    free_situation(&s, what);
    if (n % 1000 == 0 && isatty(2)) {
      fprintf(stderr, "  %" PRIu64 " of %" PRIu64 "\r", n, count);
    }
  }
  free_pool();
  for (int k = 0; k < KINDS; k++) {
    printf("%s %" PRIu64 " %" PRIu64 " %" PRIu64 " %" PRIu64 " %" PRIu64 "\n", kind_names[k],
           of[k].cases, of[k].answers, of[k].touching, of[k].ended, of[k].wrong);
    all_wrong += of[k].wrong;
  }
  return all_wrong > 0;
}
