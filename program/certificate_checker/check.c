/* SPDX-License-Identifier: MIT */
/* check.c - is a certificate right that bodies of a URDF do not touch along a path?
 *   sepax-certificate-check [-p NAME:FOLDER] FILE
 * docs/reference/certificate.md has the format and what is proved. Exit status 0: proved; 1: not;
 * 2: cannot be checked. Shares no code with sepax. */
#include "boxes.h"
#include "inside.h"
#include "motion.h"
#include "report.h"
#include "separation.h"
#include "lines.h"
#include "rules.h"
#include "steps.h"
#include "tools.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

/* How often an interval may be halved here beyond the halving of the certificate. */
enum { DEPTH = 12 };

/* Places in a segment are numbers 0 ... WHOLE. */
static const uint64_t WHOLE = (uint64_t)1 << LEVELS;

typedef struct {
  bool used;
  box_tree tree;
  shell shell;
} prepared;

typedef struct {
  int first, second; /* numbers of links */
  chain chain;
  double clearance;
  bool constant; /* none of the joints between them ever moves */
} pair;

typedef struct {
  robot robot;
  steps steps;
  rules rules;
  prepared *body; /* one for each link */
  pair *pair;
  size_t pairs;
  double clearance;
  long long halved, by_axis;
} proof;

static const char *first_name(const proof *p, const pair *of) {
  return p->robot.link[of->first].name;
}
static const char *second_name(const proof *p, const pair *of) {
  return p->robot.link[of->second].name;
}

static const surface *body_of(const proof *p, int link) { return &p->robot.link[link].body; }

static prepared *prepare(proof *p, int link) {
  prepared *b = &p->body[link];
  if (!b->used) {
    b->tree = boxes_of(body_of(p, link));
    b->shell = shell_of(body_of(p, link));
    b->used = true;
  }
  return b;
}

static motion motion_in(const proof *p, const pair *of, int segment, uint64_t from, uint64_t to) {
  const int next = segment + 1 < p->steps.lines ? segment + 1 : segment;
  const interval i = {
      steps_line(&p->steps, segment),
      steps_line(&p->steps, next),
      (long double)(from + to) / 2 / (long double)WHOLE,
      (long double)(to - from) / 2 / (long double)WHOLE,
      body_of(p, of->first)->radius,
      body_of(p, of->second)->radius,
  };
  return chain_motion(&of->chain, &p->robot, &i);
}

/* How far the bodies must be apart on the linear way to the next line. */
static double need(const proof *p, const pair *of, int segment) {
  return of->clearance + (p->steps.lines > 1 ? p->steps.step[segment + 1].deviation : 0);
}

/* Is there a way from a line to the next? */
static bool goes_on(const proof *p, int line) {
  return line >= 0 && line + 1 < p->steps.lines && !p->steps.step[line + 1].begins;
}

/* Both bodies are there only while their tools are in the spindle. */
static bool exists(const proof *p, const pair *of, int line) {
  const char *tool = p->robot.link[of->first].tool;
  const char *other = p->robot.link[of->second].tool;
  const char *now = p->steps.step[line].tool;
  return (tool == NULL || (now != NULL && strcmp(tool, now) == 0)) &&
         (other == NULL || (now != NULL && strcmp(other, now) == 0));
}

/* Need the pair not be apart in the motion that ends in a line? */
static bool may_meet(const proof *p, const pair *of, int line) {
  return !exists(p, of, line) ||
         rules_may_meet(&p->rules, &p->robot, of->first, of->second, p->steps.step[line].kind);
}

/* Must the pair stay apart from a line to the next? */
static bool must_be_apart(const proof *p, const pair *of, int line) {
  return goes_on(p, line) && !may_meet(p, of, line + 1);
}

static void prove(proof *p, const pair *of, int segment, uint64_t from, uint64_t to, int depth) {
  const motion m = motion_in(p, of, segment, from, to);
  if (separated(&p->body[of->first].tree, &p->body[of->second].tree, &m, need(p, of, segment)))
    return;
  if (depth == DEPTH || to - from < 2) {
    reject("%s, %s: segment %d: not proved to be farther from each other than %g m from %.9Lg to "
           "%.9Lg of the way",
           first_name(p, of), second_name(p, of), segment, need(p, of, segment),
           (long double)from / (long double)WHOLE, (long double)to / (long double)WHOLE);
  }
  p->halved++;
  const uint64_t middle = from + (to - from) / 2;
  prove(p, of, segment, from, middle, depth + 1);
  prove(p, of, segment, middle, to, depth + 1);
}

/* Prove that at a line where a way begins the bodies are disjoint and neither is inside the other.
 */
static void prove_start(proof *p, const pair *of, int line, double distance) {
  prepared *a = prepare(p, of->first);
  prepared *b = prepare(p, of->second);
  const motion m = motion_in(p, of, line, 0, 0);
  if (!separated(&a->tree, &b->tree, &m, distance)) {
    reject("%s, %s: segment %d: not proved to be farther from each other than %g m at the first "
           "line",
           first_name(p, of), second_name(p, of), line, distance);
  }
  const pose at = chain_pose(&of->chain, &p->robot, steps_line(&p->steps, line));
  const bool outside = shell_outside(&a->shell, &b->shell, at);
  if (!outside || !shell_outside(&b->shell, &a->shell, pose_inverse(at))) {
    const bool open = (outside ? a : b)->shell.any_open;
    reject("%s, %s: segment %d: one may be inside the other at the first line%s%s%s",
           first_name(p, of), second_name(p, of), line, open ? ": " : "",
           open ? (outside ? first_name : second_name)(p, of) : "", open ? " is open" : "");
  }
}

/* Bodies that never move on their linear ways may still deviate from them. */
static void prove_starts(proof *p, const pair *of) {
  double most = 0;
  for (int line = 0; line < p->steps.lines; line++)
    most = fmax(most, must_be_apart(p, of, line - 1) ? p->steps.step[line].deviation : 0);
  bool proved = false;
  for (int line = 0; line < p->steps.lines && !(proved && of->constant); line++) {
    const bool lone = !goes_on(p, line - 1) && !goes_on(p, line);
    const bool begins = must_be_apart(p, of, line) && !must_be_apart(p, of, line - 1);
    proved = begins || (lone && !may_meet(p, of, line));
    if (proved)
      prove_start(p, of, line, of->clearance + (of->constant ? most : 0));
  }
}

/* What the certificate says of its axis must be right, but for rounding and polyhedra that hold
 * cylinders and spheres; true if it proves the interval, by the bound of motion.h. */
static bool proved_by_axis(const proof *p, const pair *of, const certificate_line *line,
                           const motion *m) {
  const surface *a = body_of(p, of->first);
  const surface *b = body_of(p, of->second);
  const gap g = gap_along(a, b, m, line->axis);
  if (!(g.middle + m->rounding + a->rounded + b->rounded >
        line->bound + need(p, of, line->segment))) {
    reject("%s, %s: segment %d: boxes are %g m from each other along the axis of %s, not more than "
           "%g m",
           first_name(p, of), second_name(p, of), line->segment, g.middle, line->where,
           line->bound + need(p, of, line->segment));
  }
  return g.always > need(p, of, line->segment);
}

/* How far the certificate's lines have come: everything before is covered. */
typedef struct {
  size_t pair;
  int segment;
  uint64_t place;
} progress;

static void must_be_whole(const proof *p, const progress *at) {
  const pair *of = &p->pair[at->pair];
  if (of->constant || at->place == WHOLE || !must_be_apart(p, of, at->segment))
    return;
  reject("%s, %s: segment %d: no interval from %.9Lg of the way", first_name(p, of),
         second_name(p, of), at->segment, (long double)at->place / (long double)WHOLE);
}

/* Up to the beginning of a segment of a pair, or the end (pair = pairs, segment = 0). */
static void go_to(const proof *p, progress *at, size_t to_pair, int to_segment) {
  const int segments = p->steps.lines - 1;
  while (at->pair < to_pair || (at->pair == to_pair && at->segment < to_segment)) {
    if (segments > 0)
      must_be_whole(p, at);
    at->place = 0;
    if (++at->segment >= segments) {
      at->segment = 0;
      at->pair++;
    }
  }
}

static void prove_line(proof *p, progress *at, const certificate_line *line) {
  if (line->pair >= p->pairs)
    reject("%s: no pair %zu", line->where, line->pair);
  if (line->segment >= p->steps.lines - 1)
    reject("%s: no segment %d", line->where, line->segment);
  const pair *of = &p->pair[line->pair];
  if (!must_be_apart(p, of, line->segment))
    reject("%s, %s: segment %d: the path breaks there, or the bodies may meet", first_name(p, of),
           second_name(p, of), line->segment);
  go_to(p, at, line->pair, line->segment);
  const uint64_t size = WHOLE >> line->level;
  const uint64_t from = line->index * size;
  if (at->pair != line->pair || at->segment != line->segment || from < at->place) {
    reject("%s, %s: segment %d: %s is out of order", first_name(p, of), second_name(p, of),
           line->segment, line->where);
  }
  if (from > at->place) {
    reject("%s, %s: segment %d: no interval from %.9Lg to %.9Lg of the way", first_name(p, of),
           second_name(p, of), line->segment, (long double)at->place / (long double)WHOLE,
           (long double)from / (long double)WHOLE);
  }
  at->place = from + size;
  if (line->has_axis) {
    const motion m = motion_in(p, of, line->segment, from, at->place);
    if (proved_by_axis(p, of, line, &m)) {
      p->by_axis++;
      return;
    }
  }
  if (!of->constant)
    prove(p, of, line->segment, from, at->place, 0);
}

static bool is_constant(const proof *p, const chain *c) {
  for (int n = 0; n < c->count; n++) {
    const int moved = c->part[n].joint;
    for (int line = 1; moved >= 0 && line < p->steps.lines; line++) {
      if (steps_line(&p->steps, line)[moved] != steps_line(&p->steps, 0)[moved])
        return false;
    }
  }
  return true;
}

/* Does the certificate leave out the clearance of a part of a tool and another link? */
static bool is_bare(const proof *p, const certificate *c, int a, int b) {
  const json_t *list = json_object_get(c->head, "without_clearance");
  const bool of_tool = p->robot.link[a].role != NULL || p->robot.link[b].role != NULL;
  for (size_t n = 0; n < json_array_size(list) && of_tool; n++) {
    const char *first = json_string_value(json_array_get(json_array_get(list, n), 0));
    const char *second = json_string_value(json_array_get(json_array_get(list, n), 1));
    if (first != NULL && second != NULL && robot_link_named(&p->robot, first) == a &&
        robot_link_named(&p->robot, second) == b) {
      if (p->clearance > 0)
        printf("%s and %s: the clearance does not count\n", first, second);
      return true;
    }
  }
  return false;
}

static void add_pair(proof *p, const certificate *c, const char *first, const char *second) {
  const int a = robot_link_named(&p->robot, first);
  const int b = robot_link_named(&p->robot, second);
  if (a < 0 || b < 0)
    reject("%s, %s: no such links", first, second);
  if (a == b)
    reject("%s, %s: one link", first, second);
  if (body_of(p, a)->count == 0 || body_of(p, b)->count == 0) {
    reject("%s, %s: without collision geometry", first, second);
  }
  pair new = {a, b, chain_between(&p->robot, a, b), p->clearance, false};
  if (is_bare(p, c, a, b))
    new.clearance = 0;
  new.constant = is_constant(p, &new.chain);
  GROW(p->pair, p->pairs);
  p->pair[p->pairs++] = new;
}

static void check_pairs(const proof *p) {
  const int links = p->robot.links;
  bool *there = memory(NULL, (size_t)links * (size_t)links, sizeof *there);
  memset(there, 0, (size_t)links * (size_t)links * sizeof *there);
  for (size_t n = 0; n < p->pairs; n++) {
    const pair *of = &p->pair[n];
    bool *one = &there[of->first * links + of->second];
    if (*one)
      reject("%s, %s: twice among the pairs", first_name(p, of), second_name(p, of));
    *one = there[of->second * links + of->first] = true;
  }
  for (int a = 0; a < links; a++) {
    for (int b = a + 1; b < links; b++) {
      if (body_of(p, a)->count == 0 || body_of(p, b)->count == 0)
        continue;
      if (p->robot.excluded[a * links + b] || there[a * links + b])
        continue;
      reject("%s, %s: not among the pairs", p->robot.link[a].name, p->robot.link[b].name);
    }
  }
  free(there);
}

static const char usage[] = "usage: sepax-certificate-check [-p NAME:FOLDER] FILE";
static const char version[] = "0.2.0"; /* that of sepax; tb/system/install compares them */

static void print_help(void) {
  printf("%s\n\n"
         "Does FILE, a certificate that sepax path --certify --certificate=FILE wrote, prove that\n"
         "the bodies of its URDF do not collide on its path? Shares no code with sepax.\n\n"
         "  -p NAME:FOLDER   where package://NAME/ is; may be given again\n"
         "  --version        the version of sepax to which the program belongs\n\n"
         "Exit status: 0 accepted, 1 rejected, 2 error.\n",
         usage);
}

int main(int count, char **words) {
  atexit(report_at_exit);
  if (count == 2 && strcmp(words[1], "--help") == 0) {
    print_help();
    return 0;
  }
  if (count == 2 && strcmp(words[1], "--version") == 0) {
    printf("sepax-certificate-check %s\n", version);
    return 0;
  }
  packages folders = {NULL, 0};
  int option = 0;
  while ((option = getopt(count, words, "p:")) != -1) {
    const char *colon = option == 'p' ? strchr(optarg, ':') : NULL;
    if (colon == NULL)
      cannot("%s", usage);
    GROW(folders.entry, folders.count);
    folders.entry[folders.count++] = (package){text_copy(optarg, (size_t)(colon - optarg)),
                                               text_copy(colon + 1, strlen(colon + 1))};
  }
  if (optind + 1 != count)
    cannot("%s", usage);
  if (words[optind][0] == 0)
    cannot("the name is empty; name a certificate");
  certificate c = certificate_open(words[optind], &folders);
  proof p = {.robot = robot_read(c.urdf, c.srdf, &folders, &c.files), .clearance = c.clearance};
  tools_add(&p.robot, &c);
  p.steps = steps_read(c.path, &p.robot, &c.files);
  p.rules = rules_read(c.rules, &p.robot, &c.files);
  files_finish(&c.files);
  const size_t links = (size_t)p.robot.links;
  p.body = memory(NULL, links, sizeof *p.body);
  memset(p.body, 0, links * sizeof *p.body);
  for (size_t n = 0; n < c.pairs; n++)
    add_pair(&p, &c, c.pair[n][0], c.pair[n][1]);
  check_pairs(&p);
  for (size_t n = 0; n < p.pairs; n++)
    prove_starts(&p, &p.pair[n]);
  progress at = {0, 0, 0};
  certificate_line line;
  while (certificate_next(&c, &line))
    prove_line(&p, &at, &line);
  go_to(&p, &at, p.pairs, 0);
  int segments = 0;
  for (int n = 0; n < p.steps.lines; n++)
    segments += goes_on(&p, n);
  for (int n = 0; n < p.rules.count; n++)
    printf("%s and %s may meet in motions of kind %s of %s\n", p.rules.entry[n].a,
           p.rules.entry[n].b, step_kind_names[p.rules.entry[n].kind], c.path);
  printf("%zu pairs, %d segments, %lld intervals: accepted (%lld by their axis; %lld halved)\n",
         p.pairs, segments, c.intervals, p.by_axis, p.halved);
  return 0;
}
