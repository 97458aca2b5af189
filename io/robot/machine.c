/* SPDX-License-Identifier: MIT */
/* machine.c - makes a machine from the files of a robot. */
#include "robot/robot.h"
#include "util/error.h"
#include "util/memory.h"
#include "util/options.h"

#include <string.h>

size_t sepax_robot_joint(const sepax_robot *robot, const char *name) {
  for (size_t n = 0; n < robot->mechanism.joints; n++) {
    if (strcmp(robot->mechanism.joint[n].name, name) == 0) {
      return n;
    }
  }
  return SEPAX_NO_JOINT;
}

void sepax_robot_machine_free(sepax_robot_machine *machine) {
  sepax_machine_free(machine->machine);
  for (size_t n = 0; n < machine->bodies; n++) {
    sepax_body_free((sepax_body *)machine->body[n].body);
  }
  sepax_release(machine->body);
  sepax_release(machine->pair);
  sepax_robot_pairs_free(&machine->pairs);
  sepax_robot_free(&machine->robot);
  *machine = (sepax_robot_machine){0};
}

/* Append the mesh of a shape. */
static bool append(sepax_soup *to, const sepax_shape *shape, const sepax_shape_reading *how,
                   sepax_error *error) {
  sepax_soup mesh;
  if (!sepax_shape_mesh(&mesh, NULL, shape, how, error)) {
    return false;
  }
  sepax_facet *grown = sepax_resize(to->facet, (to->count + mesh.count) * sizeof *grown);
  if (grown != NULL) {
    to->facet = grown;
    memcpy(to->facet + to->count, mesh.facet, mesh.count * sizeof *grown);
    to->count += mesh.count;
  }
  sepax_soup_free(&mesh);
  return grown != NULL || sepax_fail(error, SEPAX_ERROR_MEMORY, "no memory for its triangles");
}

/* One body of `count` shapes from `first` on, which are all of one link. */
static bool add_body(sepax_robot_machine *machine, size_t first, size_t count,
                     const sepax_shape_reading *how, sepax_error *error) {
  const sepax_shape *shape = &machine->robot.shape[first];
  sepax_soup mesh = {0};
  sepax_body *body = NULL;
  sepax_error inner = {0};
  bool ok = true;
  for (size_t n = 0; n < count && ok; n++) {
    ok = append(&mesh, &shape[n], how, &inner);
  }
  ok = ok &&
       (sepax__distinct(&mesh) ||
        sepax_fail(&inner, SEPAX_ERROR_MEMORY, "no memory for its triangles")) &&
       sepax_body_new(&body, SEPAX_SOUP_MESH(&mesh), NULL, &inner);
  sepax_soup_free(&mesh);
  if (!ok) {
    return sepax_fail(error, inner.code, "link %.60s: %.400s",
                      machine->robot.mechanism.link[shape->link].name, inner.text);
  }
  machine->body[machine->bodies++] = (sepax_machine_body){shape->link, body};
  return true;
}

/* The body of a link; bodies stand in the order of their links. */
static size_t body_of(const sepax_robot_machine *machine, size_t link) {
  size_t low = 0;
  size_t high = machine->bodies;
  while (high - low > 1) {
    size_t middle = low + (high - low) / 2;
    *(machine->body[middle].link <= link ? &low : &high) = middle;
  }
  return low;
}

static bool make(sepax_robot_machine *machine, const char *urdf, const sepax_shape_reading *how,
                 sepax_error *error) {
  const sepax_robot *robot = &machine->robot;
  size_t count = 0;
  machine->body = sepax__zeroed(robot->shapes, sizeof *machine->body);
  machine->pair = sepax__zeroed(machine->pairs.count, sizeof *machine->pair);
  if (machine->body == NULL || machine->pair == NULL) {
    return sepax_fail(error, SEPAX_ERROR_MEMORY, "no memory for %zu bodies", robot->shapes);
  }
  if (machine->pairs.count == 0) {
    return sepax_fail(error, SEPAX_ERROR_ARGUMENT,
                      "%.240s: no two bodies to compare; give two links collision geometry, or "
                      "enable a pair",
                      urdf);
  }
  for (size_t first = 0; first < robot->shapes; first += count) {
    count = 1;
    while (first + count < robot->shapes &&
           robot->shape[first + count].link == robot->shape[first].link) {
      count++;
    }
    if (!add_body(machine, first, count, how, error)) {
      return false;
    }
  }
  for (size_t n = 0; n < machine->pairs.count; n++) {
    for (int side = 0; side < 2; side++) {
      machine->pair[n][side] = body_of(machine, machine->pairs.pair[n][side]);
    }
  }
  const sepax_machine_parts parts = {.size = sizeof parts,
                                     .mechanism = &robot->mechanism,
                                     .body = machine->body,
                                     .bodies = machine->bodies,
                                     .pair = (const size_t(*)[2])machine->pair,
                                     .pairs = machine->pairs.count};
  return sepax_machine_new(&machine->machine, &parts, error);
}

bool sepax_robot_machine_read(sepax_robot_machine *machine, const char *urdf, const char *srdf,
                              const sepax_robot_reading *how, sepax_error *error) {
  sepax_robot_reading h;
  *machine = (sepax_robot_machine){0};
  if (!sepax__options(&h, sizeof h, how, "sepax_robot_reading", error)) {
    return false;
  }
  const sepax_shape_reading shapes = {.size = sizeof shapes, .fans = h.fans};
  if (!sepax_robot_read(&machine->robot, urdf, how, error)) {
    return false;
  }
  if (!sepax_robot_pairs_choose(&machine->pairs, &machine->robot, srdf, error) ||
      !make(machine, urdf, &shapes, error)) {
    sepax_robot_machine_free(machine);
    return false;
  }
  return true;
}
