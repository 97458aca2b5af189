/* SPDX-License-Identifier: MIT */
/* machine.c - makes machines: boxes of bodies, tops of pairs, and the links and bodies that are
 * seen from each top. */
#include "mechanism/machine.h"
#include "body/body.h"
#include "util/error.h"
#include "util/list.h"
#include "util/memory.h"
#include "util/options.h"
#include "util/vector.h"

#include <math.h>
#include <string.h>

void sepax_machine_free(sepax_machine *machine) {
  if (machine != NULL) {
    sepax_release(machine->body);
    sepax_release(machine->box);
    sepax_release(machine->node);
    sepax_release(machine->place);
    sepax_release(machine->pair);
    sepax_release(machine);
  }
}

/* -------------------------------------------------------------------------- boxes */

/* The centre and the half sides are rounded: two roundings of numbers that are no greater than the
 * corners. The radius is rounded by less than 2^-49 of the size. Both are covered by the slack of a
 * pair. */
static machine_box box_of(const sepax_body *b) {
  double low[3] = {INFINITY, INFINITY, INFINITY};
  double high[3] = {-INFINITY, -INFINITY, -INFINITY};
  machine_box box;
  for (size_t n = 0; n < 3 * b->count; n++) {
    const double *v = b->triangle[n / 3][n % 3];
    for (int i = 0; i < 3; i++) {
      low[i] = v[i] < low[i] ? v[i] : low[i];
      high[i] = v[i] > high[i] ? v[i] : high[i];
    }
  }
  for (int i = 0; i < 3; i++) {
    box.centre[i] = low[i] / 2 + high[i] / 2;
    box.half[i] = fmax(high[i] - box.centre[i], box.centre[i] - low[i]);
  }
  double square = 0;
  for (size_t n = 0; n < 3 * b->count; n++) {
    const double *v = b->triangle[n / 3][n % 3];
    const double arm[3] = {v[0] - box.centre[0], v[1] - box.centre[1], v[2] - box.centre[2]};
    square = fmax(square, vector_dot(arm, arm));
  }
  /* the square of a very long or short arm is infinite or 0 */
  const double sides = box.half[0] + box.half[1] + box.half[2];
  box.radius = square > 0x1p-900 && square < 0x1p900 ? sqrt(square) : sides;
  box.size = 0;
  for (int i = 0; i < 3; i++) {
    box.size += 2 * (fabs(low[i]) + fabs(high[i]));
  }
  return box;
}

/* --------------------------------------------------------------------------- tops */

/* While the nodes of a top are made: node[link] and place[body] are theirs if they are not below
 * `first_node` and `first_place`. */
typedef struct {
  sepax_machine *machine;
  const size_t (*ends)[2]; /* bodies of each pair */
  size_t *depth;           /* of each link: joints between it and the root */
  size_t *first, *next;    /* pairs of each top, as lists */
  size_t *node, *place;
  size_t *way; /* space for the links of a way */
  size_t first_node, first_place, node_space, place_space;
} builder;

static size_t parent_of(const sepax_mechanism *m, size_t link) {
  return m->joint[m->link[link].joint].parent;
}

static size_t top_of(const builder *b, size_t link, size_t other) {
  const sepax_mechanism *m = b->machine->mechanism;
  while (link != other) {
    if (b->depth[link] >= b->depth[other]) {
      link = parent_of(m, link);
    } else {
      other = parent_of(m, other);
    }
  }
  return link;
}

static bool add_node(builder *b, size_t link, bool top) {
  sepax_machine *machine = b->machine;
  machine_node *grown =
      list_grow(machine->node, &b->node_space, machine->nodes, sizeof *machine->node);
  if (grown == NULL) {
    return false;
  }
  machine->node = grown;
  const sepax_mechanism *m = machine->mechanism;
  machine->node[machine->nodes] =
      top ? (machine_node){SEPAX_NO_JOINT, 0}
          : (machine_node){m->link[link].joint, b->node[parent_of(m, link)]};
  b->node[link] = machine->nodes++;
  return true;
}

/* Make the nodes between the top and a link that are not there yet, from above. */
static bool add_way(builder *b, size_t link) {
  const sepax_mechanism *m = b->machine->mechanism;
  size_t count = 0;
  for (; b->node[link] < b->first_node || b->node[link] == SIZE_MAX; link = parent_of(m, link)) {
    b->way[count++] = link;
  }
  while (count > 0) {
    if (!add_node(b, b->way[--count], false)) {
      return false;
    }
  }
  return true;
}

/* The place of a body as seen from the top. */
static bool find_place(builder *b, size_t body, size_t *place) {
  sepax_machine *machine = b->machine;
  if (b->place[body] >= b->first_place && b->place[body] != SIZE_MAX) {
    *place = b->place[body];
    return true;
  }
  machine_place *grown =
      list_grow(machine->place, &b->place_space, machine->places, sizeof *machine->place);
  if (grown == NULL || !add_way(b, machine->body[body].link)) {
    machine->place = grown != NULL ? grown : machine->place;
    return false;
  }
  machine->place = grown;
  machine_place p = {.body = body,
                     .node = b->node[machine->body[body].link],
                     .first = machine->moves,
                     .scale = machine->box[body].size};
  for (size_t n = p.node; machine->node[n].joint != SEPAX_NO_JOINT; n = machine->node[n].parent) {
    p.scale += vector_length(machine->mechanism->joint[machine->node[n].joint].origin.translation);
    p.depth++;
  }
  machine->moves += p.depth + 1;
  *place = b->place[body] = machine->places;
  machine->place[machine->places++] = p;
  return true;
}

static bool add_top(builder *b, size_t top) {
  sepax_machine *machine = b->machine;
  b->first_node = machine->nodes;
  b->first_place = machine->places;
  if (!add_node(b, top, true)) {
    return false;
  }
  for (size_t n = b->first[top]; n != SIZE_MAX; n = b->next[n]) {
    for (int side = 0; side < 2; side++) {
      if (!find_place(b, b->ends[n][side], &machine->pair[n].place[side])) {
        return false;
      }
    }
  }
  return true;
}

static bool add_tops(builder *b) {
  sepax_machine *machine = b->machine;
  const sepax_mechanism *m = machine->mechanism;
  for (size_t n = 0; n < m->joints; n++) {
    const sepax_joint *joint = &m->joint[m->order[n]];
    b->depth[joint->child] = b->depth[joint->parent] + 1;
  }
  memset(b->first, 0xff, m->links * sizeof *b->first);
  memset(b->node, 0xff, m->links * sizeof *b->node);
  memset(b->place, 0xff, machine->bodies * sizeof *b->place);
  for (size_t n = machine->pairs; n-- > 0;) {
    size_t top = top_of(b, machine->body[b->ends[n][0]].link, machine->body[b->ends[n][1]].link);
    b->next[n] = b->first[top];
    b->first[top] = n;
  }
  for (size_t link = 0; link < m->links; link++) {
    if (b->first[link] != SIZE_MAX && !add_top(b, link)) {
      return false;
    }
  }
  return true;
}

static bool find_tops(sepax_machine *machine, const size_t (*ends)[2]) {
  size_t links = machine->mechanism->links;
  builder b = {.machine = machine,
               .ends = ends,
               .depth = sepax__zeroed(links, sizeof *b.depth),
               .first = sepax__zeroed(links, sizeof *b.first),
               .next = sepax__zeroed(machine->pairs, sizeof *b.next),
               .node = sepax__zeroed(links, sizeof *b.node),
               .place = sepax__zeroed(machine->bodies, sizeof *b.place),
               .way = sepax__zeroed(links, sizeof *b.way)};
  bool ok = b.depth != NULL && b.first != NULL && b.next != NULL && b.node != NULL &&
            b.place != NULL && b.way != NULL && add_tops(&b);
  sepax_release(b.depth);
  sepax_release(b.first);
  sepax_release(b.next);
  sepax_release(b.node);
  sepax_release(b.place);
  sepax_release(b.way);
  return ok;
}

/* -------------------------------------------------------------------- the machine */

static bool check(const sepax_machine_parts *p, sepax_error *error) {
  const sepax_mechanism *m = p->mechanism;
  if (m == NULL || m->links == 0 || m->order == NULL) {
    return sepax_fail(error, SEPAX_ERROR_ARGUMENT,
                      "the machine has no mechanism; give one after sepax_mechanism_join");
  }
  for (size_t n = 0; n < p->bodies; n++) {
    if (p->body[n].link >= m->links || p->body[n].body == NULL) {
      return sepax_fail(error, SEPAX_ERROR_ARGUMENT,
                        "body %zu is missing or names link %zu of %zu; name a link of the "
                        "mechanism",
                        n, p->body[n].link, m->links);
    }
  }
  for (size_t n = 0; n < p->pairs; n++) {
    if (p->pair[n][0] >= p->bodies || p->pair[n][1] >= p->bodies ||
        p->pair[n][0] == p->pair[n][1]) {
      return sepax_fail(error, SEPAX_ERROR_ARGUMENT,
                        "pair %zu names the bodies %zu and %zu of %zu; name two different ones", n,
                        p->pair[n][0], p->pair[n][1], p->bodies);
    }
  }
  return p->pairs > 0 || sepax_fail(error, SEPAX_ERROR_ARGUMENT,
                                    "the machine has no pairs of bodies, so it would always be "
                                    "free; name the pairs that are compared");
}

static bool make(sepax_machine *machine, const sepax_machine_parts *p) {
  machine->parts = *p->mechanism;
  machine->mechanism = &machine->parts;
  machine->bodies = p->bodies;
  machine->pairs = p->pairs;
  machine->body = sepax__zeroed(p->bodies, sizeof *machine->body);
  machine->box = sepax__zeroed(p->bodies, sizeof *machine->box);
  machine->pair = sepax__zeroed(p->pairs, sizeof *machine->pair);
  if (machine->body == NULL || machine->box == NULL || machine->pair == NULL) {
    return false;
  }
  for (size_t n = 0; n < p->bodies; n++) {
    machine->body[n] = p->body[n];
    machine->box[n] = box_of(p->body[n].body);
  }
  return find_tops(machine, p->pair);
}

bool sepax_machine_new(sepax_machine **machine, const sepax_machine_parts *parts,
                       sepax_error *error) {
  sepax_machine_parts p;
  *machine = NULL;
  if (!sepax__options(&p, sizeof p, parts, "sepax_machine_parts", error) || !check(&p, error)) {
    return false;
  }
  sepax_machine *made = sepax__zeroed(1, sizeof *made);
  if (made == NULL || !make(made, &p)) {
    sepax_machine_free(made);
    return sepax_fail(error, SEPAX_ERROR_MEMORY, "no memory for a machine of %zu pairs", p.pairs);
  }
  *machine = made;
  return true;
}
