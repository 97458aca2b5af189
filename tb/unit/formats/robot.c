/* SPDX-License-Identifier: MIT */
/* robot.c - machines from files: pairs of links, bodies of shapes, and what is refused. */
#include "files.h"

#include <math.h>

#define BOX(size, x) \
  "<collision><origin xyz='" x " 0 0'/><geometry><box size='" size "'/></geometry></collision>"
#define JOINT(name, type, from, to, more)                                                       \
  "<joint name='" name "' type='" type "'><parent link='" from "'/><child link='" to "'/>" more \
  "</joint>"
#define SLIDE "<axis xyz='1 0 0'/><limit lower='-9' upper='9'/>"

/* Link a with two boxes, b without any, c and d on slides, e bolted to d, f on a floating joint. */
static const char robot[] = "<robot name='r'><link name='a'>" BOX("1 1 1", "0")
    BOX("1 1 1", "1") "</link>"
                      "<link name='b'/><link name='c'>" BOX(
                          "1 1 1",
                          "0") "</link>"
                               "<link name='d'>" BOX("1 1 1", "0") "</link><link name='e'>" BOX(
                                   "1 1 1",
                                   "0") "</link>"
                                        "<link name='f'>" BOX("1 1 1", "0") "</link>" JOINT(
                                            "x", "prismatic", "a", "b",
                                            SLIDE) JOINT("y", "prismatic", "b", "c", SLIDE)
                                            JOINT("z", "prismatic", "a", "d", SLIDE)
                                                JOINT("k", "fixed", "d", "e", "")
                                                    JOINT("g", "floating", "a", "f", "") "</robot>";

static void assert_pairs(const sepax_robot *r, const char *srdf, const char *expected) {
  sepax_robot_pairs pairs;
  char names[200] = "";
  assert_works(sepax_robot_pairs_choose(&pairs, r, srdf, &fault));
  for (size_t n = 0; n < pairs.count; n++) {
    const sepax_link *link = r->mechanism.link;
    snprintf(names + strlen(names), sizeof names - strlen(names), "%s%s ",
             link[pairs.pair[n][0]].name, link[pairs.pair[n][1]].name);
  }
  assert_string_equal(names, expected);
  assert_int_equal(pairs.count + pairs.joined + pairs.rigid + pairs.disabled, 10);
  sepax_robot_pairs_free(&pairs);
}

CASE(pairs_that_are_compared) {
  sepax_robot r;
  assert_works(sepax_robot_read(&r, put_file("r.urdf", robot), NULL, &fault));
  assert_pairs(&r, NULL, "ac ae af cd ce cf df ef ");
  assert_pairs(&r,
               put_file("r.srdf", "<robot name='r'><disable_collisions link1='f' link2='a'/>"
                                  "<disable_collisions link1='c' link2='d'/></robot>"),
               "ac ad ae ce cf de df ef ");
  sepax_robot_pairs none;
  assert_fault(sepax_robot_pairs_choose(&none, &r, in_folder("none.srdf"), &fault), "none.srdf");
  assert_null(none.pair);
  sepax_robot_free(&r);
}

static double least_at(const sepax_robot_machine *m, sepax_watch *watch, double x, double y,
                       double z, double away) {
  double value[16] = {0};
  sepax_machine_answer answer;
  const sepax_machine_query query = {.size = sizeof query, .measure = true};
  value[sepax_robot_joint(&m->robot, "x")] = x;
  value[sepax_robot_joint(&m->robot, "y")] = y;
  value[sepax_robot_joint(&m->robot, "z")] = z;
  value[sepax_robot_joint(&m->robot, "g/z")] = away;
  assert_works(sepax_watch_ask(watch, value, &query, &answer, &fault));
  assert_true(answer.least <= answer.most && answer.most - answer.least < 1e-12);
  return answer.most;
}

/* The body of link a has both boxes, which share two triangles: it ends at 1.5. */
CASE(machines_of_files) {
  sepax_robot_machine m;
  sepax_robot_machine moved;
  sepax_watch *watch;
  assert_works(sepax_robot_machine_read(&m, put_file("r.urdf", robot), NULL, NULL, &fault));
  moved = m; /* the struct may move */
  memset(&m, 0, sizeof m);
  assert_int_equal(moved.bodies, 5);
  assert_int_equal(sepax_body_triangles(moved.body[0].body), 22);
  assert_int_equal(sepax_robot_joint(&moved.robot, "none"), SEPAX_NO_JOINT);
  assert_works(sepax_watch_new(&watch, moved.machine, &fault));
  assert_true(fabs(least_at(&moved, watch, 3, 1, -4, 50) - 2) < 1e-12);
  assert_true(fabs(least_at(&moved, watch, 2, 1, -4, 50) - 1) < 1e-12);
  assert_true(fabs(least_at(&moved, watch, 8, 9, -4, 2) - 1) < 1e-12);
  assert_true(least_at(&moved, watch, 1, 1, -4, 50) == 0);
  sepax_watch_free(watch);
  sepax_robot_machine_free(&moved);
}

CASE(machines_that_are_refused) {
  sepax_robot_machine m;
  const char *urdf = put_file("r.urdf", "<robot name='r'><link name='a'/></robot>");
  assert_fault(sepax_robot_machine_read(&m, urdf, NULL, NULL, &fault), "no two bodies to compare");
  assert_null(m.machine);
  assert_fault(sepax_robot_machine_read(&m, in_folder("none.urdf"), NULL, NULL, &fault),
               "none.urdf");
  put_file("bad.stl", "solid x\n");
  urdf = put_file(
      "r.urdf",
      "<robot name='r'><link name='a'>" BOX(
          "1 1 1",
          "0") "</link><link name='b'>"
               "<collision><geometry><mesh filename='bad.stl'/></geometry></collision></link>"
               "<link name='c'>" BOX("1 1 1", "0") "</link>" //
      JOINT("x", "prismatic", "a", "b", SLIDE) JOINT("y", "prismatic", "b", "c", SLIDE) "</robot>");
  assert_fault(sepax_robot_machine_read(&m, urdf, NULL, NULL, &fault), "link b: ");
  /* A polygon that crosses itself, unless it may be a fan. */
  put_file("bad.stl", "v 0 0 0\nv 1 1 0\nv 1 0 0\nv 0 1 0\nf 1 2 3 4\n");
  assert_fault(sepax_robot_machine_read(&m, urdf, NULL, NULL, &fault), "crosses itself");
  assert_works(sepax_robot_machine_read(&m, urdf, NULL,
                                        &SEPAX_STRUCT(sepax_robot_reading, .fans = true), &fault));
  sepax_robot_machine_free(&m);
  sepax_shape shape = {.kind = SEPAX_SHAPE_SPHERE, .size = {1}};
  sepax_soup mesh;
  assert_fault(
      sepax_shape_mesh(&mesh, NULL, &shape, &SEPAX_STRUCT(sepax_shape_reading, .unit = -1), &fault),
      "unit of -1");
  shape.kind = 9;
  assert_fault(sepax_shape_mesh(&mesh, NULL, &shape, NULL, &fault), "kind 9");
}
