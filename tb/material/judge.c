/* SPDX-License-Identifier: MIT */
#include "judge.h"

#include "checker.h"
#include "touch.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static void need(bool works, const sepax_error *error) {
  if (!works) {
    fprintf(stderr, "material: the library fails: %s\n", error->text);
    exit(2);
  }
}

static void make_body(const placing *where, int which, const triangle *t, size_t count,
                      sepax_body **solid, sepax_shell *shell) {
  static sepax_facet facet[MOST];
  sepax_error error;
  place(where, which, t, count, facet);
  const sepax_soup soup_of = {.facet = facet, .count = count};
  need(sepax_body_new(solid, SEPAX_SOUP_MESH(&soup_of), &SEPAX_STRUCT(sepax_build, .threads = 1),
                      &error),
       &error);
  need(sepax_shell_find(shell, *solid, &error), &error);
}

/* For the checker: where the bodies lie, without the poses, which move both. */
static struct checker_body *make_checked(const placing *where, const triangle *t, size_t count) {
  static sepax_facet facet[MOST];
  static double corner[MOST][3][3];
  const placing still = {.exponent = where->exponent,
                         .offset = where->offset,
                         .from = {{0, 1, 2}, {0, 1, 2}},
                         .way = {{1, 1, 1}, {1, 1, 1}}};
  place(&still, 0, t, count, facet);
  for (size_t n = 0; n < count; n++) {
    memcpy(corner[n], facet[n].v, sizeof corner[n]);
  }
  return checker_open((const double(*)[3][3])corner, count);
}

void open_subject(subject *s, const body *b, const placing *where) {
  s->b = b;
  s->where = *where;
  for (int k = 0; k < 2; k++) { /* the copy's own poses */
    s->where.given[k] = where->given[k] == NULL ? NULL : &s->where.pose[k];
  }
  find_surfaces(&s->found, &b->s);
  find_parts(&s->parts, &b->s);
  make_body(where, 0, b->s.t, b->s.count, &s->solid, &s->shell);
  s->checked = make_checked(where, b->s.t, b->s.count);
}

void close_subject(subject *s) {
  sepax_shell_free(&s->shell);
  sepax_body_free(s->solid);
  checker_close(s->checked);
  free_surfaces(&s->found);
}

static bool has_area_everywhere(const soup *s) {
  for (size_t i = 0; i < s->count; i++) {
    if (is_zero(normal(s->t[i].v))) {
      return false;
    }
  }
  return true;
}

enum { FEW = 48 }; /* triangles, of which each pair is looked at */

judgement judge_shell(const subject *s) {
  if (s->shell.closed != s->found.closed) {
    return (judgement){WRONG,
                       s->shell.closed ? "closed, but an edge is open" : "open, but no edge is"};
  }
  if (s->found.closed && s->shell.consistent != s->found.consistent) {
    return (judgement){WRONG, s->shell.consistent ? "consistent, but a triangle is turned"
                                                  : "not consistent, but no triangle is turned"};
  }
  if (s->shell.parts != s->parts.count) {
    return (judgement){WRONG, "another number of parts"};
  }
  if (s->b->s.count <= FEW && has_area_everywhere(&s->b->s)) {
    size_t piece[MOST];
    if (s->shell.pieces != find_pieces(&s->b->s, &s->parts, piece)) {
      return (judgement){WRONG, "another number of pieces"};
    }
  }
  return (judgement){OUTSIDE, NULL};
}

static void probe_soup(point p, soup *s) {
  point corner[4];
  probe_corners(p, corner);
  s->count = 0;
  add_tetrahedron(s, corner, false);
}

/* What the library says. *other: is the body in the probe? */
static sepax_inside ask(const subject *s, point p, sepax_inside *other) {
  static soup probe;
  sepax_body *solid;
  sepax_shell shell;
  sepax_inside within[2];
  sepax_error error;
  probe_soup(p, &probe);
  make_body(&s->where, 1, probe.t, probe.count, &solid, &shell);
  need(sepax_bodies_within(&shell, s->where.given[1], &s->shell, s->where.given[0], within, &error),
       &error);
  sepax_shell_free(&shell);
  sepax_body_free(solid);
  *other = within[1];
  return within[0];
}

/* What is known of the union of the solids. */
typedef enum { NOT_KNOWN, NO_MATERIAL, MATERIAL } truth;

static truth truth_at(const body *b, point p) {
  truth known = b->solids == 0 ? NOT_KNOWN : NO_MATERIAL;
  for (size_t n = 0; n < b->solids; n++) {
    bool inside = true;
    for (size_t i = b->first[n]; i < b->first[n + 1]; i++) {
      const point *v = b->proof.t[i].v;
      int side = sign(determinant(minus(v[0], p), minus(v[1], p), minus(v[2], p)));
      if (side == 0) {
        return NOT_KNOWN; /* between two solids, perhaps */
      }
      inside = inside && side > 0;
    }
    known = inside ? MATERIAL : known;
  }
  return known;
}

static bool in_box(point p, point low, point high) {
  bool in = true;
  for (int i = 0; i < 3; i++) {
    in = in && low.x[i] < p.x[i] && p.x[i] < high.x[i];
  }
  return in;
}

/* What is known about a point. */
typedef struct {
  bool enclosed;     /* by a closed surface */
  walls by;          /* if it is enclosed */
  sepax_inside rule; /* what rules 2 and 3 say: UNKNOWN, if nothing */
} standing;

/* Rules 2 and 3 for parts. If surfaces of several parts together enclose the point, it is not
 * known which of the rules the library may apply. */
static sepax_inside rule_of(const walls *w) {
  if (!w->alone) {
    return SEPAX_INSIDE_UNKNOWN;
  }
  if (w->consistent ? w->sum > 0 || w->below == w->count : w->sum % 2 != 0) {
    return SEPAX_INSIDE;
  }
  return w->in_turn ? SEPAX_OUTSIDE : SEPAX_INSIDE_UNKNOWN;
}

static standing stand(const subject *s, const int8_t *crossing) {
  standing at = {.enclosed = is_enclosed(&s->found, crossing), .rule = SEPAX_OUTSIDE};
  if (at.enclosed) {
    find_walls(&at.by, &s->found, &s->parts, crossing);
    at.rule = rule_of(&at.by);
  }
  return at;
}

static int sum_of(const int8_t *crossing, size_t count) {
  int sum = 0;
  for (size_t i = 0; i < count; i++) {
    sum += crossing[i];
  }
  return sum;
}

static judgement judge_outside(const subject *s, const standing *at, point p) {
  if (at->enclosed) {
    return at->rule == SEPAX_OUTSIDE ? (judgement){CAVITY, NULL}
                                     : (judgement){WRONG, "OUTSIDE, but a surface encloses it"};
  }
  return !s->found.closed && in_box(p, s->found.low, s->found.high)
             ? (judgement){WRONG, "OUTSIDE in the box of open parts"}
             : (judgement){OUTSIDE, NULL};
}

/* An odd number of crossings is INSIDE if a part is not consistent, and this part need not enclose
 * the point. */
static judgement judge_inside(const subject *s, const standing *at, const int8_t *crossing) {
  int all = sum_of(crossing, s->b->s.count);
  if (!at->enclosed) {
    return (judgement){WRONG, "INSIDE, but no surface encloses it"};
  }
  bool may = at->rule == SEPAX_INSIDE || !at->by.alone || all % 2 != 0 || !s->found.closed;
  return may ? (judgement){INSIDE, NULL} : (judgement){WRONG, "INSIDE by no rule"};
}

static judgement judge_unknown(const subject *s, const standing *at, point p) {
  if (in_box(p, s->parts.low, s->parts.high) || at->rule == SEPAX_INSIDE_UNKNOWN) {
    return (judgement){UNKNOWN, NULL};
  }
  const char *why = !at->enclosed               ? "UNKNOWN, but no surface encloses it"
                    : at->rule == SEPAX_OUTSIDE ? "UNKNOWN, but it is a cavity"
                    : !at->by.consistent        ? "UNKNOWN, but the crossings are odd"
                    : at->by.sum > 0            ? "UNKNOWN, but the winding number is above 0"
                                                : "UNKNOWN, but all is inside out";
  return (judgement){LOST, why};
}

/* The checker proves less than the library finds, and nothing that is wrong. */
static judgement judge_checker(const subject *s, const standing *at, point p, sepax_inside said,
                               bool outside) {
  static soup probe;
  probe_soup(p, &probe);
  struct checker_body *own = make_checked(&s->where, probe.t, probe.count);
  const bool proved = checker_proves_outside(s->checked, own);
  checker_close(own);
  if (proved && at->enclosed && at->rule != SEPAX_OUTSIDE) {
    return (judgement){WRONG, "the checker proves OUTSIDE, but a surface encloses it"};
  }
  if (proved && said == SEPAX_INSIDE) {
    return (judgement){WRONG, "INSIDE, but the checker proves OUTSIDE"};
  }
  return !proved && outside
             ? (judgement){REFUSED, at->enclosed ? "a cavity" : "no surface encloses it"}
             : (judgement){OUTSIDE, NULL};
}

judgement judge_point(const subject *s, point p) {
  /* Rays of its own: the points that are drawn do not depend on answers. */
  generator own = {(uint64_t)(p.x[0] ^ p.x[1] << 20 ^ p.x[2] << 40)};
  int8_t crossing[MOST];
  sepax_inside other;
  find_crossings(crossing, &s->b->s, p, &own);
  standing at = stand(s, crossing);
  truth known = truth_at(s->b, p);
  if (known != NOT_KNOWN && (known == MATERIAL) != (sum_of(crossing, s->b->s.count) > 0)) {
    fprintf(stderr, "material: the generator and the winding number differ\n");
    exit(2);
  }
  sepax_inside said = ask(s, p, &other);
  judgement j = said == SEPAX_OUTSIDE  ? judge_outside(s, &at, p)
                : said == SEPAX_INSIDE ? judge_inside(s, &at, crossing)
                                       : judge_unknown(s, &at, p);
  if (other != SEPAX_OUTSIDE && s->found.closed) {
    j = (judgement){WRONG, "the body is not outside of the probe"};
  }
  if (j.is == WRONG) {
    return j;
  }
  const bool outside = said == SEPAX_OUTSIDE && other == SEPAX_OUTSIDE;
  const judgement proof = judge_checker(s, &at, p, said, outside);
  return proof.is == OUTSIDE ? j : proof;
}

void write_subject(const subject *s, point p, const char *prefix) {
  static sepax_facet facet[MOST];
  static soup probe;
  probe_soup(p, &probe);
  for (int which = 0; which < 2; which++) {
    char path[1000];
    sepax_error error;
    const soup *of = which == 0 ? &s->b->s : &probe;
    place(&s->where, which, of->t, of->count, facet);
    snprintf(path, sizeof path, "%s-%s.stl", prefix, which == 0 ? "body" : "probe");
    const sepax_soup soup_of = {.facet = facet, .count = of->count};
    need(sepax_stl_write(&soup_of, path, true, &error), &error);
  }
}
