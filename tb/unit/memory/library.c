/* SPDX-License-Identifier: MIT */
/* library.c - the library without memory: each allocation refused in turn. */
#include "scarce.h"
#include "sepax_mechanism.h"
#include "unit/tree/scenes.h"

#include <math.h>
#include <stdio.h>

enum { WORD = 12, MANY = 400 };

static bool same_pairs(const sepax_pairs *found, size_t count, uint64_t sum) {
  uint64_t s = 0;
  for (size_t n = 0; n < found->count; n++) {
    s += found->pair[n][0] * 1000003 + found->pair[n][1];
  }
  return found->count == count && s == sum;
}

/* ------------------------------------------------------------------- pairs */

typedef struct {
  triangles t[2];
  sepax_design design;
  sepax_search how;
  bool near;
  size_t count;
  uint64_t sum;
  int runs;
} search;

static bool work_search(void *context) {
  search *s = context;
  sepax_pairs found;
  const triangles *t = s->t;
  if (!(s->near ? sepax_near_pairs(&s->design, false, t[0].tri, t[0].count, t[1].tri, t[1].count,
                                   &s->how, &found, &fault)
                : sepax_colliding_pairs(t[0].tri, t[0].count, t[1].tri, t[1].count, &s->how, &found,
                                        &fault))) {
    return false;
  }
  if (s->runs++ == 0) {
    s->count = found.count;
    for (size_t n = 0; n < found.count; n++) {
      s->sum += found.pair[n][0] * 1000003 + found.pair[n][1];
    }
  }
  bool same = same_pairs(&found, s->count, s->sum);
  sepax_pairs_free(&found);
  assert_true(same);
  return true;
}

CASE(pairs_of_triangles) {
  for (int way = 0; way < 6; way++) {
    search s = {.design = design_of("--word=12 --clearance=4 --warning=8"),
                .how = {.size = sizeof(sepax_search),
                        .threads = way < 3 || SANITIZED ? 1 : 3,
                        .brute_force = way % 3 == 1},
                .near = way % 3 == 2};
    for (int k = 0; k < 2; k++) {
      s.t[k] = drawn(MANY, 0, 300, 60, WORD);
    }
    assert_true(assert_scarce(work_search, &s) > 2 && s.count > 20);
    for (int k = 0; k < 2; k++) {
      free(s.t[k].tri);
    }
  }
}

/* ------------------------------------------------------------------ bodies */

typedef struct {
  sepax_soup mesh[2];
  sepax_pose pose;
  size_t count;
  double distance;
} solids;

/* A surface of a ball. */
static sepax_soup mesh_of(size_t count, double reach) {
  triangles t = drawn(count, 4, reach, 0, WORD);
  sepax_soup mesh = {.facet = calloc(count, sizeof *mesh.facet), .count = count};
  for (size_t n = 0; mesh.facet != NULL && n < count; n++) {
    for (int k = 0; k < 3; k++) {
      for (int axis = 0; axis < 3; axis++) {
        mesh.facet[n].v[k][axis] = *coordinate(&t.tri[n].v[k], axis);
      }
    }
  }
  assert_non_null(mesh.facet);
  free(t.tri);
  return mesh;
}

static bool ask(solids *s, sepax_body *const body[2], sepax_shell shell[2]) {
  sepax_pairs found;
  if (!sepax_bodies_collide(body[0], NULL, body[1], &s->pose, NULL, &found, &fault)) {
    return false;
  }
  size_t count = found.count;
  sepax_pairs_free(&found);
  if (!sepax_bodies_near(body[0], NULL, body[1], &s->pose, 1, NULL, &found, &fault)) {
    return false;
  }
  assert_true(found.count >= count);
  sepax_pairs_free(&found);
  sepax_distance_result far;
  sepax_inside within[2];
  if (!sepax_bodies_distance(body[0], NULL, body[1], NULL, NULL, &far, &fault) ||
      !sepax_shell_find(&shell[0], body[0], &fault) ||
      !sepax_shell_find(&shell[1], body[1], &fault) ||
      !sepax_bodies_within(&shell[0], NULL, &shell[1], NULL, within, &fault)) {
    return false;
  }
  s->count = s->count == 0 ? count : s->count;
  s->distance = s->distance == 0 ? far.min_distance : s->distance;
  assert_true(s->count == count && s->distance == far.min_distance);
  assert_int_equal(within[1], SEPAX_INSIDE);
  return true;
}

static bool work_bodies(void *context) {
  solids *s = context;
  sepax_body *body[2] = {NULL, NULL};
  sepax_shell shell[2] = {{.own = NULL}, {.own = NULL}};
  bool works = sepax_body_new(&body[0], SEPAX_SOUP_MESH(&s->mesh[0]), NULL, &fault) &&
               sepax_body_new(&body[1], SEPAX_SOUP_MESH(&s->mesh[1]), NULL, &fault) &&
               ask(s, body, shell);
  for (int k = 0; k < 2; k++) {
    sepax_shell_free(&shell[k]);
    sepax_body_free(body[k]);
  }
  return works;
}

static bool work_meshes(void *context) {
  solids *s = context;
  sepax_pairs found;
  const sepax_search how = {.size = sizeof(sepax_search), .threads = 1};
  if (!sepax_meshes_collide(SEPAX_SOUP_MESH(&s->mesh[0]), NULL, SEPAX_SOUP_MESH(&s->mesh[1]),
                            &s->pose, &how, &found, &fault)) {
    return false;
  }
  size_t count = found.count;
  sepax_pairs_free(&found);
  assert_int_equal(count, s->count);
  return true;
}

CASE(bodies) {
  solids s = {.mesh = {mesh_of(288, 400), mesh_of(200, 100)}, .pose = posed(3, 0)};
  s.pose.translation[0] = 350;
  assert_true(assert_scarce(work_bodies, &s) > 20 && s.count > 0);
  assert_true(assert_scarce(work_meshes, &s) > 3);
  free(s.mesh[0].facet);
  free(s.mesh[1].facet);
}

/* ---------------------------------------------------------------- machines */

typedef struct {
  sepax_mechanism mechanism;
  sepax_body *body[2];
} rig;

static bool work_machine(void *context) {
  rig *r = context;
  const sepax_machine_body body[2] = {{0, r->body[0]}, {1, r->body[1]}};
  const size_t pair[1][2] = {{0, 1}};
  const sepax_machine_parts parts = {.size = sizeof parts,
                                     .mechanism = &r->mechanism,
                                     .body = body,
                                     .bodies = 2,
                                     .pair = pair,
                                     .pairs = 1};
  sepax_machine *machine = NULL;
  sepax_watch *watch = NULL;
  sepax_machine_answer answer;
  const double value[1] = {0.5};
  bool works = sepax_machine_new(&machine, &parts, &fault) &&
               sepax_watch_new(&watch, machine, &fault) &&
               sepax_watch_ask(watch, value, NULL, &answer, &fault);
  assert_true(!works || answer.verdict != SEPAX_UNDECIDED);
  sepax_watch_free(watch);
  sepax_machine_free(machine);
  return works;
}

CASE(machines) {
  sepax_link link[2] = {{.joint = 0}};
  sepax_joint joint = {.name = path,
                       .kind = SEPAX_JOINT_PRISMATIC,
                       .child = 1,
                       .origin = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {0, 0, 0}},
                       .axis = {1, 0, 0},
                       .mimic = SEPAX_NO_JOINT};
  rig r = {.mechanism = {.link = link, .links = 2, .joint = &joint, .joints = 1}};
  assert_works(sepax_mechanism_join(&r.mechanism, &fault));
  for (int k = 0; k < 2; k++) {
    sepax_soup mesh = mesh_of(60, 100);
    assert_works(sepax_body_new(&r.body[k], SEPAX_SOUP_MESH(&mesh), NULL, &fault));
    free(mesh.facet);
  }
  assert_true(assert_scarce(work_machine, &r) > 20);
  sepax_body_free(r.body[0]);
  sepax_body_free(r.body[1]);
  sepax_release(r.mechanism.order);
}

/* ------------------------------------------------------------------- files */

static bool work_files(void *context) {
  const sepax_soup *mesh = context;
  static char place[2][PATH_BYTES];
  snprintf(place[0], sizeof place[0], "%s/a.stl", folder);
  snprintf(place[1], sizeof place[1], "%s/b.stl", folder);
  sepax_scene scene = {.count = {0, 0}};
  sepax_soup read = {.facet = NULL, .count = 0};
  const sepax_grid grid = {.word = WORD};
  const char *const names[2] = {place[0], place[1]};
  bool works = sepax_stl_write(&mesh[0], place[0], false, &fault) &&
               sepax_stl_write(&mesh[1], place[1], true, &fault) &&
               sepax_stl_read(&read, place[1], false, &fault) &&
               sepax_scene_load(&scene, names, &grid, true, &fault);
  if (works) {
    assert_true(read.count == mesh[1].count && scene.count[0] == mesh[0].count);
    sepax_scene_free(&scene);
  }
  if (read.facet != NULL) {
    sepax_soup_free(&read);
  }
  return works;
}

static bool work_poses(void *context) {
  sepax_poses poses;
  (void)context;
  if (!sepax_poses_read(&poses, path, &fault)) {
    return false;
  }
  assert_int_equal(poses.count, 300);
  sepax_poses_free(&poses);
  return true;
}

CASE(files) {
  sepax_soup mesh[2] = {mesh_of(100, 300), mesh_of(80, 200)};
  assert_true(assert_scarce(work_files, mesh) > 10);
  free(mesh[0].facet);
  free(mesh[1].facet);
  FILE *out = fopen(path, "w");
  assert_non_null(out);
  for (int n = 0; n < 300; n++) {
    fprintf(out, "1 0 0 0 1 0 0 0 1 %d 0 0\n", n);
  }
  assert_int_equal(fclose(out), 0);
  assert_true(assert_scarce(work_poses, NULL) > 3);
}

/* ------------------------------------------------------------------- trees */

enum { POSES = 3 };

typedef struct {
  triangles t[2];
  sepax_tree *tree[2];
  sepax_tree_pose pose[POSES];
  sepax_design design;
  uint64_t near;
} engine;

static bool work_tree(void *context) {
  engine *s = context;
  const sepax_grid grid = {.resolution = 1, .word = WORD};
  sepax_tree *made = NULL;
  sepax_tree *read = NULL;
  sepax_tree_run run;
  const sepax_tree_walk_options how = {.design = &s->design};
  snprintf(path, sizeof path, "%s/t.sxt", folder);
  bool works = sepax_tree_new(&made, s->t[0].tri, s->t[0].count, &grid, &fault) &&
               sepax_tree_write(made, path, &fault) && sepax_tree_read(&read, path, &fault) &&
               sepax_tree_walk(read, s->tree[1], &s->pose[0], &how, &run, &fault);
  sepax_tree_free(made);
  sepax_tree_free(read);
  if (works) {
    s->near = s->near == 0 ? run.near : s->near;
    assert_true(run.near == s->near && !run.damaged);
  }
  return works;
}

static bool work_list(void *context) {
  engine *s = context;
  static const uint32_t lines[POSES] = {2, 3, 5};
  static const char *const names[2] = {"a", "b"};
  const sepax_job_pair pair = {{0, 1}, s->pose};
  const sepax_job_scene scene = {.tree = (const sepax_tree *const *)s->tree,
                                 .name = names,
                                 .bodies = 2,
                                 .pair = &pair,
                                 .pairs = 1,
                                 .line = lines,
                                 .poses = POSES,
                                 .word = WORD,
                                 .clearance = 1,
                                 .warning = 4};
  sepax_job_list made = {.byte = NULL};
  sepax_job_list read = {.byte = NULL};
  snprintf(path, sizeof path, "%s/l.sxj", folder);
  bool works = sepax_job_list_make(&made, &scene, &fault) &&
               sepax_job_list_write(&made, path, &fault) &&
               sepax_job_list_read(&read, path, &fault);
  if (works) {
    assert_int_equal(read.jobs, 1);
    const sepax_tree_memory memory_of = {read.byte, 0, read.bytes};
    sepax_tree_batch batch = {
        .design = &s->design, .memory = &memory_of, .list = read.list, .jobs = 1};
    sepax_tree_result result;
    bool more;
    works = sepax_tree_next(&batch, &result, &more, &fault);
  }
  sepax_job_list_free(&made);
  sepax_job_list_free(&read);
  return works;
}

CASE(trees_and_lists_of_jobs) {
  engine s = {.design = design_of("--word=12")};
  for (int i = 0; i < 2; i++) {
    s.t[i] = drawn(200, 4, 300, 0, WORD);
    s.tree[i] = tree_of(&s.t[i], WORD);
  }
  for (int n = 0; n < POSES; n++) {
    sepax_pose p = posed(4, 0);
    p.translation[0] = 400 + n;
    assert_works(sepax_tree_pose_make(&s.pose[n], s.tree[0], NULL, s.tree[1], &p, 0, &fault));
  }
  assert_true(assert_scarce(work_tree, &s) > 5 && s.near > 0);
  assert_true(assert_scarce(work_list, &s) > 5);
  for (int i = 0; i < 2; i++) {
    sepax_tree_free(s.tree[i]);
    free(s.t[i].tri);
  }
}

/* ------------------------------------------------------------------- sizes */

typedef struct {
  sepax_soup mesh[2];
  sepax_space space;
  double gates;
} sizes;

static bool work_size(void *context) {
  sizes *s = context;
  sepax_size size;
  if (!sepax_size_scene(&size, &s->mesh[0], &s->mesh[1], &s->space, &fault)) {
    return false;
  }
  sepax_sized_design sized;
  const sepax_size_request request = {
      .seconds = 1e-5, .clock_ps = 2000, .lanes_most = 2, .tree = true, .latency = 0};
  bool works = sepax_size_design(&sized, &size, &request, &fault);
  sepax_size_free(&size);
  if (works) {
    s->gates = s->gates == 0 ? sized.gates : s->gates;
    assert_true(s->gates == sized.gates);
  }
  return works;
}

CASE(what_a_scene_needs) {
  sepax_pose path_of[3] = {posed(3, 0), posed(3, 0), posed(3, 0)};
  const sepax_poses poses = {path_of, 3};
  for (int way = 0; way < 2; way++) {
    sizes s = {.mesh = {mesh_of(60, 30), mesh_of(40, 20)},
               .space = {.resolution = 0.5,
                         .poses = 4,
                         .seed = 1,
                         .motion = {{.low = {-5, -5, -5}, .high = {5, 5, 5}}},
                         .path = way == 1 ? &poses : NULL}};
    assert_true(assert_scarce(work_size, &s) > 5);
    free(s.mesh[0].facet);
    free(s.mesh[1].facet);
  }
}
