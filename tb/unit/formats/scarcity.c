/* SPDX-License-Identifier: MIT */
/* scarcity.c - readers without memory: each allocation refused in turn. Those of libxml2 are among
 * them, which keeps its last error. */
#include "files.h"
#include "robot/robot.h"
#include "unit/memory/scarce.h"

#include <stdio.h>

#define JOINT(name, type, from, to, more)                                                       \
  "<joint name='" name "' type='" type "'><parent link='" from "'/><child link='" to "'/>" more \
  "</joint>\n"

static bool work_robot(void *context) {
  sepax_robot r;
  static const cli_meshes rules = {.unit = CLI_METRES};
  static const sepax_package package = {"p", "/tmp"};
  static const sepax_robot_reading how = {.size = sizeof how, .package = &package, .packages = 1};
  if (!sepax_robot_read(&r, context, &how, &fault)) {
    return false;
  }
  bool *compared = calloc(r.mechanism.links * r.mechanism.links, sizeof *compared);
  sepax_chain chain;
  sepax_srdf of = {0};
  bool works =
      compared != NULL && sepax_srdf_read(compared, &r.mechanism, &of, in_folder("r.srdf"), &fault);
  if (works && sepax_chain_find(&chain, &r.mechanism, 1, 3, &fault)) {
    assert_int_equal(chain.count, 3);
    sepax_chain_free(&chain);
  } else {
    snprintf(fault.text, sizeof fault.text, "no memory");
    works = false;
  }
  for (size_t n = 0; works && n < r.shapes; n++) {
    sepax_soup mesh = {.facet = NULL, .count = 0};
    report_mesh said;
    works = format_shape_mesh(&mesh, &said, &r.shape[n], &rules, &fault);
    sepax_soup_free(&mesh);
  }
  sepax_srdf_free(&of);
  free(compared);
  sepax_robot_free(&r);
  return works;
}

static bool work_machine(void *context) {
  sepax_robot_machine m;
  if (!sepax_robot_machine_read(&m, context, in_folder("r.srdf"), NULL, &fault)) {
    return false;
  }
  assert_int_equal(m.bodies, 4);
  sepax_robot_machine_free(&m);
  return true;
}

/* ------------------------------------------------------- the library's own allocations */

static long own_left;
static void *own_allocate(void *context, size_t size) {
  (void)context;
  return own_left-- == 0 ? NULL : malloc(size);
}
static void *own_resize(void *context, void *old, size_t size) {
  (void)context;
  return own_left-- == 0 ? NULL : realloc(old, size);
}
static void own_release(void *context, void *old) {
  (void)context;
  free(old);
}

/* Without memory the code is MEMORY, not that of a file which breaks the rules of its format. */
static void assert_codes(char *name) {
  const sepax_allocator own = {own_allocate, own_resize, own_release, NULL};
  long refused = 0;
  sepax_set_allocator(&own);
  for (own_left = -1; own_left < 0; refused++) {
    own_left = refused;
    fault.code = SEPAX_OK;
    bool works = work_machine(name);
    if (!works && fault.code != SEPAX_ERROR_MEMORY) {
      sepax_set_allocator(NULL);
      fail_msg("allocation %ld: code %d: %s", refused, (int)fault.code, fault.text);
    }
  }
  sepax_set_allocator(NULL);
  assert_true(refused > 50);
}

CASE(test_robots) {
  put_file("r.srdf", "<robot name='r'><group/><disable_collisions link1='a' "
                     "link2='b'/></robot>\n");
  char *name = strdup(
      put_file("r.urdf", "<robot name='r'><link name='a'/><link name='b'><collision><geometry>"
                         "<box size='1 2 3'/></geometry></collision></link>\n"
                         "<link name='c'><collision><geometry><sphere radius='1'/></geometry>"
                         "</collision></link><link name='d'><collision><geometry>"
                         "<cylinder radius='1' length='2'/></geometry></collision></link>\n" //
               JOINT("j", "prismatic", "a", "b", "<limit lower='-1' upper='1'/>")            //
               JOINT("k", "continuous", "a", "c", "<mimic joint='j'/>")                      //
               JOINT("l", "fixed", "c", "d", "")                                             //
               "<link name='e'><visual/><collision><geometry><capsule radius='1' length='1'/>"
               "</geometry></collision><collision><geometry><sphere radius='0'/></geometry>"
               "</collision></link>" JOINT("f", "floating", "a", "e", "") "</robot>\n"));
  memory.keeps = true;
  assert_true(assert_scarce(work_robot, name) > 50);
  assert_true(SANITIZED || assert_scarce(work_machine, name) > 50);
  memory.keeps = false;
  assert_codes(name);
  free(name);
}

typedef struct {
  sepax_robot robot;
  const char *path;
} motions;

static bool work_motion(void *context) {
  motions *s = context;
  format_motion motion;
  const format_motion_rules rules = {.hold = true};
  if (!format_motion_read(&motion, &s->robot.mechanism, &rules, s->path, &fault)) {
    return false;
  }
  assert_int_equal(motion.lines, 300);
  assert_true(motion.value[299 * motion.joints] == 0.5);
  format_motion_free(&motion);
  return true;
}

CASE(test_paths) {
  motions s;
  put_file("r.urdf", "<robot name='r'><link name='a'/><link name='b'/><link name='c'/>\n" //
           JOINT("j", "prismatic", "a", "b", "<limit lower='-1' upper='1'/>")             //
           JOINT("k", "continuous", "b", "c", "") "</robot>\n");
  assert_works(sepax_robot_read(&s.robot, in_folder("r.urdf"), NULL, &fault));
  char text[300 * 24 + 16] = "time,j\n";
  for (int n = 0; n < 300; n++) {
    snprintf(text + strlen(text), 24, "%d,0.5\n", n);
  }
  s.path = put_file("p.csv", text);
  assert_true(assert_scarce(work_motion, &s) > 3);
  sepax_robot_free(&s.robot);
}

static bool work_mesh(void *context) {
  sepax_soup mesh;
  sepax_mesh_account account;
  if (!sepax_mesh_read(&mesh, &account, context, NULL, &fault)) {
    return false;
  }
  assert_int_equal(mesh.count, 2);
  sepax__distinct(&mesh);
  sepax_soup_free(&mesh);
  return true;
}

CASE(test_meshes) {
  char *name = strdup(put_file(
      "m.stl", "solid m\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\n"
               "vertex 0 1 0\nendloop\nendfacet\nfacet normal 0 0 1\nouter loop\n"
               "vertex 0 0 1\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\nendsolid m\n"));
  assert_true(assert_scarce(work_mesh, name) > 2);
  free(name);
}
