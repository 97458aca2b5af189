/* SPDX-License-Identifier: MIT */
/* corpus - is what the library says of points inside real meshes true? Each answer is compared with
 * the winding number of the mesh, which is computed from solid angles.
 *   solid-corpus [-q FILE] [-n COUNT] [-s SEED] [-t TIMES]   reads names of mesh files from the
 *                                                            standard input, one a line
 *   -q FILE    also write a line for each query, so that two builds of the library can be compared:
 *              file, number, kind, x, y, z, answer, winding number, its distance from an integer,
 *              reason of the answer
 *   -n COUNT   queries of a file (48); fewer if the file has more than WORK / COUNT triangles
 *   -s SEED    of the points (1)
 *   -t TIMES   no queries: find each shell so often and print the least time
 *
 * The points of a file depend only on SEED, COUNT and the mesh. A third of them is drawn in the
 * box of the mesh, a third near the middle of a facet on either side, a third halfway between the
 * middles of two facets. The library is asked about a small tetrahedron round the point. If the
 * tetrahedron touches the mesh, then the point is left out.
 *
 * A line for each file has the columns of `titles`, divided by tabs. In a closed and consistent
 * mesh the winding number is an integer. There `wrong` counts points that the library calls outside
 * though their winding number is not 0, and points that it calls inside though it is 0. `far` is
 * the largest distance of a winding number from an integer. Exit status 1: an answer is wrong. */
#include "sepax.h"
#include "sepax_io.h"
#include "sepax_vectors.h"

#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

/* Triangles times queries of a file, at most. */
enum { WORK = 40000000, FEWEST = 6, TRIANGLES_MOST = 4000000 };

static const char titles[] =
    "file\ttriangles\tclosed\tconsistent\tparts\tpieces\tqueries\toutside\t"
    "inside\tunknown\ttouching\twrong_outside\twrong_inside\tfar";

typedef enum { BOX, NEAR, BETWEEN, KINDS } kind;
static const char *const kind_names[KINDS] = {"box", "near", "between"};
static const char *const answer_names[3] = {"UNKNOWN", "OUTSIDE", "INSIDE"};
static const char *const reason_names[] = {
    [SEPAX_WITHIN_PLAIN] = "-",         [SEPAX_WITHIN_NESTED] = "nested",
    [SEPAX_WITHIN_OPEN] = "open",       [SEPAX_WITHIN_INCONSISTENT] = "inconsistent",
    [SEPAX_WITHIN_DOUBLED] = "doubled", [SEPAX_WITHIN_OPPOSED] = "opposed",
    [SEPAX_WITHIN_SHEETS] = "sheets",
};

typedef struct {
  FILE *queries;
  size_t count;
  uint64_t seed;
  size_t times;
} request;

typedef struct {
  sepax_soup mesh;
  sepax_body *body;
  sepax_shell shell;
  double low[3], high[3], diagonal;
} solid;

typedef struct {
  size_t answers[3], touching, wrong[3];
  long double far; /* distance from the nearest integer */
} tally;

static double seconds(void) {
  struct timespec now;
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

/* In lo ... hi. */
static double uniform(sepax_random *random, double lo, double hi) {
  return lo + (hi - lo) * ((double)(sepax_random_next(random) >> 11) * 0x1p-53);
}

static const sepax_facet *any_facet(const sepax_soup *mesh, sepax_random *random) {
  return &mesh->facet[sepax_random_range(random, 0, (int64_t)mesh->count - 1)];
}

static long double length(const long double v[3]) {
  return sqrtl(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
}

static long double dot(const long double a[3], const long double b[3]) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static void cross(long double c[3], const long double a[3], const long double b[3]) {
  for (int i = 0; i < 3; i++) {
    int j = (i + 1) % 3;
    int k = (i + 2) % 3;
    c[i] = a[j] * b[k] - a[k] * b[j];
  }
}

/* Half of the solid angle of a facet as seen from a point (van Oosterom and Strackee, The Solid
 * Angle of a Plane Triangle, 1983). */
static long double half_angle(const sepax_facet *facet, const double at[3]) {
  long double v[3][3];
  long double size[3];
  for (int k = 0; k < 3; k++) {
    for (int i = 0; i < 3; i++) {
      v[k][i] = (long double)facet->v[k][i] - (long double)at[i];
    }
    size[k] = length(v[k]);
  }
  long double normal[3];
  cross(normal, v[1], v[2]);
  return atan2l(dot(v[0], normal), size[0] * size[1] * size[2] + dot(v[0], v[1]) * size[2] +
                                       dot(v[0], v[2]) * size[1] + dot(v[1], v[2]) * size[0]);
}

static long double winding_number(const sepax_soup *mesh, const double at[3]) {
  long double sum = 0;
  for (size_t n = 0; n < mesh->count; n++) {
    sum += half_angle(&mesh->facet[n], at);
  }
  return sum / (2 * acosl(-1));
}

static void middle(double m[3], const sepax_facet *facet) {
  for (int i = 0; i < 3; i++) {
    m[i] = facet->v[0][i] / 3 + facet->v[1][i] / 3 + facet->v[2][i] / 3;
  }
}

/* A unit normal; 0 if the facet has no area. */
static void normal_of(double n[3], const sepax_facet *facet) {
  long double edge[2][3];
  for (int i = 0; i < 3; i++) {
    edge[0][i] = (long double)facet->v[1][i] - (long double)facet->v[0][i];
    edge[1][i] = (long double)facet->v[2][i] - (long double)facet->v[0][i];
  }
  long double normal[3];
  cross(normal, edge[0], edge[1]);
  long double size = length(normal);
  for (int i = 0; i < 3; i++) {
    n[i] = size > 0 ? (double)(normal[i] / size) : 0;
  }
}

/* Draw a point, and the size of the tetrahedron round it. */
static double draw(double at[3], kind what, const solid *s, sepax_random *random) {
  double away = s->diagonal * pow(10, uniform(random, -5, -1.5));
  double sign = uniform(random, -1, 1) < 0 ? -1 : 1;
  double m[2][3];
  double normal[3];
  const sepax_facet *facet = any_facet(&s->mesh, random);
  middle(m[0], facet);
  normal_of(normal, facet);
  middle(m[1], any_facet(&s->mesh, random));
  for (int i = 0; i < 3; i++) {
    double margin = 0.03 * (s->high[i] - s->low[i]);
    double in_box = uniform(random, s->low[i] - margin, s->high[i] + margin);
    at[i] = what == BOX    ? in_box
            : what == NEAR ? m[0][i] + sign * away * normal[i]
                           : m[0][i] / 2 + m[1][i] / 2;
  }
  return what == NEAR ? away / 8 : s->diagonal * 1e-6;
}

static void fail(const char *file, const char *text) {
  fprintf(stderr, "solid-corpus: %s: %s\n", file, text);
}

/* The tetrahedron round a point. */
static void make_probe(sepax_facet probe[4], const double at[3], double size) {
  static const double corner[4][3] = {{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}};
  static const int side[4][3] = {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}};
  for (int n = 0; n < 4; n++) {
    for (int k = 0; k < 3; k++) {
      for (int i = 0; i < 3; i++) {
        probe[n].v[k][i] = at[i] + size * corner[side[n][k]][i];
      }
    }
  }
}

/* What the library says of a point, and why. */
static bool ask(sepax_inside *answer, sepax_within_reason *reason, bool *touches, const solid *s,
                const double at[3], double size, sepax_error *error) {
  sepax_facet facet[4];
  make_probe(facet, at, size);
  sepax_soup soup = {.facet = facet, .count = 4};
  sepax_body *probe = NULL;
  sepax_shell shell = {0};
  sepax_pairs pairs = {0};
  sepax_inside within[2] = {SEPAX_INSIDE_UNKNOWN, SEPAX_INSIDE_UNKNOWN};
  sepax_within_reason why[2] = {SEPAX_WITHIN_PLAIN, SEPAX_WITHIN_PLAIN};
  bool done = sepax_body_new(&probe, SEPAX_SOUP_MESH(&soup), NULL, error) &&
              sepax_bodies_collide(probe, NULL, s->body, NULL,
                                   &SEPAX_STRUCT(sepax_query, .only_any = true), &pairs, error);
  *touches = done && pairs.count > 0;
  if (done && !*touches) {
    done = sepax_shell_find(&shell, probe, error) &&
           sepax_bodies_within_why(&shell, NULL, &s->shell, NULL, within, why, error);
  }
  *answer = within[0];
  *reason = why[0];
  sepax_pairs_free(&pairs);
  sepax_shell_free(&shell);
  sepax_body_free(probe);
  return done;
}

static bool query(tally *t, const solid *s, const char *file, size_t number, sepax_random *random,
                  const request *how, sepax_error *error) {
  kind what = (kind)(number % KINDS);
  double at[3];
  double size = draw(at, what, s, random);
  sepax_inside answer;
  sepax_within_reason reason;
  bool touches;
  if (!ask(&answer, &reason, &touches, s, at, size, error)) {
    return false;
  }
  if (touches) {
    t->touching++;
    return true;
  }
  long double winding = winding_number(&s->mesh, at);
  long double far = fabsl(winding - roundl(winding));
  t->answers[answer]++;
  t->far = fmaxl(t->far, far);
  if (s->shell.closed && s->shell.consistent && answer != SEPAX_INSIDE_UNKNOWN) {
    t->wrong[answer] += (answer == SEPAX_OUTSIDE) != (lroundl(winding) == 0);
  }
  if (how->queries != NULL) {
    fprintf(how->queries, "%s\t%zu\t%s\t%.17g\t%.17g\t%.17g\t%s\t%.6Lf\t%.1Le\t%s\n", file, number,
            kind_names[what], at[0], at[1], at[2], answer_names[answer], winding, far,
            reason_names[reason]);
  }
  return true;
}

static void measure_box(solid *s) {
  double square = 0;
  for (int i = 0; i < 3; i++) {
    s->low[i] = INFINITY;
    s->high[i] = -INFINITY;
    for (size_t n = 0; n < s->mesh.count; n++) {
      for (int k = 0; k < 3; k++) {
        s->low[i] = fmin(s->low[i], s->mesh.facet[n].v[k][i]);
        s->high[i] = fmax(s->high[i], s->mesh.facet[n].v[k][i]);
      }
    }
    square += (s->high[i] - s->low[i]) * (s->high[i] - s->low[i]);
  }
  s->diagonal = sqrt(square);
}

static bool run_queries(tally *t, const solid *s, const char *file, const request *how,
                        sepax_error *error) {
  size_t most = (size_t)WORK / s->mesh.count;
  size_t count = how->count < most ? how->count : most < FEWEST ? (size_t)FEWEST : most;
  sepax_random random = {how->seed};
  for (size_t n = 0; n < count; n++) {
    if (!query(t, s, file, n, &random, how, error)) {
      return false;
    }
  }
  return true;
}

static void print_tally(const char *file, const solid *s, const tally *t) {
  const size_t *answers = t->answers;
  printf("%s\t%zu\t%d\t%d\t%zu\t%zu\t%zu\t%zu\t%zu\t%zu\t%zu\t%zu\t%zu\t%.1Le\n", file,
         s->mesh.count, s->shell.closed, s->shell.consistent, s->shell.parts, s->shell.pieces,
         answers[SEPAX_OUTSIDE] + answers[SEPAX_INSIDE] + answers[SEPAX_INSIDE_UNKNOWN],
         answers[SEPAX_OUTSIDE], answers[SEPAX_INSIDE], answers[SEPAX_INSIDE_UNKNOWN], t->touching,
         t->wrong[SEPAX_OUTSIDE], t->wrong[SEPAX_INSIDE], t->far);
  fflush(stdout);
}

/* Find the shell again and print the least time. */
static bool time_shell(const solid *s, const char *file, size_t times, sepax_error *error) {
  double least = INFINITY;
  for (size_t n = 0; n < times; n++) {
    sepax_shell shell;
    double start = seconds();
    if (!sepax_shell_find(&shell, s->body, error)) {
      return false;
    }
    least = fmin(least, seconds() - start);
    sepax_shell_free(&shell);
  }
  printf("%s\t%zu\t%.9f\n", file, s->mesh.count, least);
  fflush(stdout);
  return true;
}

static bool judge(bool *wrong, const char *file, const request *how, sepax_error *error) {
  solid s = {0};
  tally t = {0};
  bool done = sepax_mesh_read(&s.mesh, NULL, file,
                              &SEPAX_STRUCT(sepax_mesh_reading, .most = TRIANGLES_MOST), error) &&
              sepax_body_new(&s.body, SEPAX_SOUP_MESH(&s.mesh), NULL, error) &&
              sepax_shell_find(&s.shell, s.body, error);
  if (done && how->times > 0) {
    done = time_shell(&s, file, how->times, error);
  } else if (done) {
    measure_box(&s);
    done = run_queries(&t, &s, file, how, error);
    if (done) {
      print_tally(file, &s, &t);
    }
  }
  *wrong = *wrong || t.wrong[SEPAX_OUTSIDE] + t.wrong[SEPAX_INSIDE] > 0;
  sepax_shell_free(&s.shell);
  sepax_body_free(s.body);
  sepax_soup_free(&s.mesh);
  return done;
}

static bool read_request(request *how, int count, char **words) {
  *how = (request){.count = 48, .seed = 1};
  for (int option; (option = getopt(count, words, "q:n:s:t:")) != -1;) {
    switch (option) {
    case 'q':
      how->queries = fopen(optarg, "w");
      if (how->queries == NULL) {
        fail(optarg, strerror(errno));
        return false;
      }
      break;
    case 'n':
      how->count = strtoul(optarg, NULL, 10);
      break;
    case 's':
      how->seed = strtoul(optarg, NULL, 10);
      break;
    case 't':
      how->times = strtoul(optarg, NULL, 10);
      break;
    default:
      return false;
    }
  }
  return true;
}

int main(int count, char **words) {
  request how;
  if (!read_request(&how, count, words)) {
    fputs("usage: solid-corpus [-q FILE] [-n COUNT] [-s SEED] [-t TIMES]\n", stderr);
    return 2;
  }
  if (how.times == 0) {
    puts(titles);
  }
  bool wrong = false;
  char *file = NULL;
  size_t space = 0;
  while (getline(&file, &space, stdin) > 0) {
    file[strcspn(file, "\n")] = '\0';
    sepax_error error = {0};
    if (!judge(&wrong, file, &how, &error)) {
      fail(file, error.text); /* a file that cannot be read is no wrong answer */
    }
  }
  free(file);
  if (how.queries != NULL && fclose(how.queries) != 0) {
    fail("the file of queries", strerror(errno));
    return 2;
  }
  return wrong ? 1 : 0;
}
