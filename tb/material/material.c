/* SPDX-License-Identifier: MIT */
/* material - what the library says about the inside of random bodies, against linear algebra.
 *   material [--bodies=N] [--seed=S] [--kind=K] [--from=N] [--points=N] [--lost] [--closed]
 *            [--only=TEXT] [--shrink] [--write=PREFIX]
 *
 * Prints a line for each kind of body: bodies, points, and how many points are
 *   outside  OUTSIDE, and no closed surface that the triangles can form encloses them
 *   cavity   OUTSIDE in a cavity
 *   inside   INSIDE
 *   unknown  UNKNOWN where the rule says nothing else
 *   lost     UNKNOWN though the rule, applied to all closed surfaces, tells more
 *   refused  OUTSIDE, but sepax-certificate-check does not prove it
 *   wrong    an answer that is wrong, of the library or of the checker. A wrong field of a shell
 *            counts here, too.
 * Then it prints how often each reason was given. A wrong answer is printed with the options that
 * make its body again; add --bodies=1.
 *
 *   --lost       print lost and refused answers, too
 *   --closed     print only answers about closed bodies
 *   --only=TEXT  print only answers whose reason has the text
 *   --shrink     leave out triangles as long as the answer stays wrong for the same reason, and
 *                print the triangles
 *   --write      write PREFIX-body.stl and PREFIX-probe.stl
 *
 * Exit status 1: an answer is wrong, or of a kind more than 1 % of the answers are lost. */
#include "judge.h"
#include "touch.h"

#include <errno.h>
#include <getopt.h>
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum { SHOWN = 8 }; /* answers of a kind that are printed */

static const char *const outcome_names[OUTCOMES] = {"outside", "cavity",  "inside", "unknown",
                                                    "lost",    "refused", "wrong"};

typedef struct {
  uint64_t bodies, seed, from, points;
  size_t kind; /* or the count of kinds: all */
  bool lost, closed, shrink;
  const char *prefix, *only;
} options;

typedef struct {
  uint64_t bodies, points, of[OUTCOMES], shown;
} tally;

/* How often each reason was given, over all kinds. */
static struct {
  judgement j;
  bool closed;
  uint64_t times;
} reasons[40];
enum { REASONS = sizeof reasons / sizeof *reasons };

/* A point near a triangle, near a corner, or anywhere in and about the box of the body. */
static point draw_point(const soup *s, generator *g) {
  const triangle *t = &s->t[draw(g, 0, (int64_t)s->count - 1)];
  point p;
  int64_t how = draw(g, 0, 3);
  int64_t reach = one_in(g, 2) ? FINE / 4 : 4 * FINE;
  const int64_t part[2] = {draw(g, 0, 16), draw(g, 0, 16)};
  for (int i = 0; i < 3; i++) {
    int64_t low = t->v[0].x[i];
    int64_t high = low;
    for (size_t n = 0; n < 3 * s->count; n++) {
      int64_t x = s->t[n / 3].v[n % 3].x[i];
      low = x < low ? x : low;
      high = x > high ? x : high;
    }
    int64_t along = (16 - part[0]) * t->v[0].x[i] + part[0] * t->v[1].x[i];
    int64_t on = ((16 - part[1]) * along + part[1] * 16 * t->v[2].x[i]) / 256;
    p.x[i] = how < 2    ? draw(g, low - FINE, high + FINE)
             : how == 2 ? on + draw(g, -reach, reach)
                        : t->v[0].x[i] + draw(g, -reach, reach);
  }
  return p;
}

static bool same(judgement j, const char *why) { return j.why != NULL && strcmp(j.why, why) == 0; }

/* Is the answer about a body, closed or open as given, wrong for the same reason? */
static bool is_wrong_so(const body *b, const placing *where, point p, const char *why,
                        bool closed) {
  subject s;
  open_subject(&s, b, where);
  judgement j = judge_shell(&s);
  if (j.is != WRONG) {
    j = judge_point(&s, p);
  }
  bool as_open = s.found.closed == closed;
  close_subject(&s);
  return as_open && same(j, why);
}

/* Leave out a few triangles, or of a closed body a closed surface, so that it stays closed. */
static void leave_out(soup *s, bool closed, generator *g) {
  static bool in[MOST];
  surfaces f;
  if (!closed || one_in(g, 8)) {
    for (int64_t n = draw(g, 1, 4); n > 0 && s->count > 0; n--) {
      remove_triangle(s, (size_t)draw(g, 0, (int64_t)s->count - 1));
    }
    return;
  }
  find_surfaces(&f, s);
  if (draw_surface(&f, in, g)) {
    for (size_t i = s->count; i-- > 0;) {
      if (in[i]) {
        remove_triangle(s, i);
      }
    }
  }
  free_surfaces(&f);
}

/* Fewer triangles, and no pose if it does not matter. */
static void shrink(body *b, placing *where, point p, const char *why, bool closed) {
  generator g = {1};
  placing plain;
  draw_place(&plain, true, &g);
  b->solids = 0;
  if (is_wrong_so(b, &plain, p, why, closed)) {
    *where = plain;
  }
  for (int vain = 0; vain < 6000; vain++) {
    static body fewer;
    fewer = *b;
    leave_out(&fewer.s, closed, &g);
    if (fewer.s.count > 0 && fewer.s.count < b->s.count && probe_is_free(&fewer.s, p) &&
        is_wrong_so(&fewer, where, p, why, closed)) {
      *b = fewer;
      vain = 0;
    }
  }
}

static void print_body(const soup *s, point p) {
  printf("  lattice of 1/%d; probe %" PRId64 " %" PRId64 " %" PRId64 "\n", FINE, p.x[0], p.x[1],
         p.x[2]);
  for (size_t i = 0; i < s->count; i++) {
    printf("   ");
    for (int k = 0; k < 9; k++) {
      printf("%s%" PRId64, k % 3 == 0 ? "  " : " ", s->t[i].v[k / 3].x[k % 3] / FINE);
    }
    printf("\n");
  }
}

static void show(const options *o, const body *b, const placing *where, point p, judgement j,
                 bool closed, size_t kind, uint64_t number) {
  static body small;
  placing place_of = *where;
  small = *b;
  printf("%s --kind=%s --seed=%" PRIu64 " --from=%" PRIu64 ": %s\n", outcome_names[j.is],
         kind_name(kind), o->seed, number, j.why);
  if (o->shrink) {
    for (int k = 0; k < 2; k++) {
      place_of.given[k] = where->given[k] == NULL ? NULL : &place_of.pose[k];
    }
    shrink(&small, &place_of, p, j.why, closed);
    print_body(&small.s, p);
  }
  if (o->prefix != NULL) {
    subject s;
    open_subject(&s, &small, &place_of);
    write_subject(&s, p, o->prefix);
    close_subject(&s);
  }
}

static void count_in(const options *o, tally *t, const subject *s, point p, judgement j,
                     size_t kind, uint64_t number) {
  t->of[j.is]++;
  bool closed = s->found.closed;
  for (size_t n = 0; n < REASONS && j.why != NULL; n++) {
    bool known = reasons[n].j.is == j.is && reasons[n].closed == closed;
    if (reasons[n].times == 0 || (known && same(j, reasons[n].j.why))) {
      reasons[n].j = j;
      reasons[n].closed = closed;
      reasons[n].times++;
      break;
    }
  }
  bool shown = j.is == WRONG || (o->lost && (j.is == LOST || j.is == REFUSED));
  shown = shown && (!o->closed || closed);
  if (shown && j.why != NULL && strstr(j.why, o->only) != NULL && t->shown++ < SHOWN) {
    show(o, s->b, &s->where, p, j, closed, kind, number);
  }
}

/* Judge body `number` of a kind. */
static void judge_body(const options *o, tally *t, size_t kind, uint64_t number) {
  static body b;
  generator g = {o->seed * 1000003 + kind};
  g.state = draw_bits(&g) + number;
  g.state = draw_bits(&g);
  bool plainly = one_in(&g, 2);
  do {
    draw_body(&b, kind, &g);
  } while (!map_body(&b, plainly, &g));
  placing where;
  draw_place(&where, plainly, &g);
  subject s;
  open_subject(&s, &b, &where);
  t->bodies++;
  judgement j = judge_shell(&s);
  if (j.is == WRONG) {
    count_in(o, t, &s, draw_point(&b.s, &g), j, kind, number);
  }
  uint64_t points = 0;
  for (uint64_t tries = 0; points < o->points && tries < 6 * o->points; tries++) {
    point p = draw_point(&b.s, &g);
    if (probe_is_free(&b.s, p)) {
      count_in(o, t, &s, p, judge_point(&s, p), kind, number);
      points++;
    }
  }
  t->points += points;
  close_subject(&s);
}

static void print_row(const char *name, const tally *t) {
  printf("%-10s %8" PRIu64 " %9" PRIu64, name, t->bodies, t->points);
  for (int k = 0; k < OUTCOMES; k++) {
    printf(" %9" PRIu64, t->of[k]);
  }
  printf("\n");
}

static bool print_table(const tally *of) {
  tally all = {0};
  printf("%-10s %8s %9s", "kind", "bodies", "points");
  for (int k = 0; k < OUTCOMES; k++) {
    printf(" %9s", outcome_names[k]);
  }
  printf("\n");
  bool few_lost = true;
  for (size_t kind = 0; kind < kinds(); kind++) {
    few_lost = few_lost && of[kind].of[LOST] * 100 <= of[kind].points;
    if (of[kind].bodies > 0) {
      print_row(kind_name(kind), &of[kind]);
    }
    all.bodies += of[kind].bodies;
    all.points += of[kind].points;
    for (int k = 0; k < OUTCOMES; k++) {
      all.of[k] += of[kind].of[k];
    }
  }
  print_row("all", &all);
  for (size_t n = 0; n < REASONS && reasons[n].times > 0; n++) {
    printf("%-7s %9" PRIu64 "  %s: %s\n", outcome_names[reasons[n].j.is], reasons[n].times,
           reasons[n].closed ? "closed" : "open", reasons[n].j.why);
  }
  return all.of[WRONG] == 0 && few_lost && all.points > 0;
}

static uint64_t number_of(const char *text) {
  char *end;
  errno = 0;
  uint64_t n = strtoull(text, &end, 10);
  if (*text < '0' || *text > '9' || *end != '\0' || errno != 0) {
    fprintf(stderr, "material: '%s' is not a number\n", text);
    exit(2);
  }
  return n;
}

static options read_options(int argc, char **argv) {
  static const struct option names[] = {
      {"bodies", 1, NULL, 'b'}, {"seed", 1, NULL, 's'},   {"kind", 1, NULL, 'k'},
      {"from", 1, NULL, 'f'},   {"points", 1, NULL, 'p'}, {"write", 1, NULL, 'w'},
      {"lost", 0, NULL, 'l'},   {"closed", 0, NULL, 'c'}, {"only", 1, NULL, 'o'},
      {"shrink", 0, NULL, 'm'}, {NULL, 0, NULL, 0}};
  options o = {.bodies = 3000, .seed = 1, .points = 8, .kind = kinds(), .only = ""};
  for (int c; (c = getopt_long(argc, argv, "", names, NULL)) != -1;) {
    switch (c) {
    case 'b':
      o.bodies = number_of(optarg);
      break;
    case 's':
      o.seed = number_of(optarg);
      break;
    case 'f':
      o.from = number_of(optarg);
      break;
    case 'p':
      o.points = number_of(optarg);
      break;
    case 'c':
      o.closed = true;
      break;
    case 'o':
      o.only = optarg;
      break;
    case 'w':
      o.prefix = optarg;
      break;
    case 'l':
      o.lost = true;
      break;
    case 'm':
      o.shrink = true;
      break;
    case 'k':
      o.kind = kind_of(optarg);
      if (o.kind < kinds()) {
        break;
      }
      fprintf(stderr, "material: no kind '%s'\n", optarg);
      exit(2);
    default:
      exit(2);
    }
  }
  return o;
}

int main(int argc, char **argv) {
  options o = read_options(argc, argv);
  size_t all = kinds();
  tally *of = calloc(all, sizeof *of);
  if (of == NULL) {
    return 2;
  }
  for (uint64_t n = 0; n < o.bodies; n++) {
    bool one = o.kind < all;
    judge_body(&o, &of[one ? o.kind : n % all], one ? o.kind : n % all,
               o.from + (one ? n : n / all));
    if (n % 1000 == 0 && isatty(2)) {
      fprintf(stderr, "  %" PRIu64 " of %" PRIu64 "\r", n, o.bodies);
    }
  }
  bool right = print_table(of);
  free(of);
  return right ? 0 : 1;
}
