/* SPDX-License-Identifier: MIT */
/* urdf.c - URDF and SRDF: what they say, and what is refused with its line. */
#include "files.h"

#include <math.h>
#include <stdio.h>
#include <sys/stat.h>

#define HEAD "<robot name='r'>\n"
#define TAIL "</robot>\n"
#define TWO "<link name='a'/>\n<link name='b'/>\n"
#define JOINT(type, rest) \
  "<joint name='j' type='" type "'><parent link='a'/><child link='b'/>" rest "</joint>\n"

static bool read_text(sepax_robot *robot, const char *text) {
  return sepax_robot_read(robot, put_file("r.urdf", text), NULL, &fault);
}

static void refuse_text(const char *text, const char *part) {
  sepax_robot robot;
  assert_fault(read_text(&robot, text), part);
  assert_message("r.urdf");
  assert_null(robot.shape);
  assert_null(robot.mechanism.link);
}

CASE(test_links_and_joints) {
  sepax_robot r;
  put_file("part.obj", "v 0 0 0\n");
  assert_works(read_text(
      &r, "<?xml version='1.0'?>\n<robot name='r' xmlns:xacro='x'>\n"
          "<material name='m'/><transmission><joint name='j'/></transmission>\n"
          "<joint name='j' type='prismatic'><parent link='a'/><child link='b'/>\n"
          "<origin xyz='1 -2.5 3e-1' rpy='0 0 1.5707963267948966'/><axis xyz='0 0 -2'/>\n"
          "<limit lower='-.5' upper='+2' effort='1'/></joint>\n"
          "<joint name='k' type='continuous'><parent link='b'/><child link='c'/>\n"
          "<mimic joint='j' multiplier='3' offset='-1'/></joint>\n"
          "<link name='a'/><link name='b'><visual/><inertial/>\n"
          "<collision><origin xyz='0 0 5'/><geometry><box size='1 2 3'/></geometry></collision>\n"
          "<collision><geometry><cylinder radius='2' length='7'/></geometry></collision>\n"
          "<collision><geometry><sphere radius='4'/></geometry></collision>\n"
          "<collision><geometry><mesh filename='part.obj' scale='.001 .002 -.003'/></geometry>\n"
          "</collision></link><link name='c'/></robot>\n"));
  const sepax_mechanism *m = &r.mechanism;
  assert_int_equal(m->links, 3);
  assert_int_equal(m->joints, 2);
  const sepax_joint *j = &m->joint[0];
  assert_string_equal(j->name, "j");
  assert_int_equal(j->kind, SEPAX_JOINT_PRISMATIC);
  assert_string_equal(m->link[j->parent].name, "a");
  assert_string_equal(m->link[j->child].name, "b");
  assert_true(j->lower == -0.5 && j->upper == 2);
  assert_true(j->axis[0] == 0 && j->axis[1] == 0 && j->axis[2] == -1);
  static const double at[3] = {1, -2.5, 0.3};
  assert_memory_equal(j->origin.translation, at, sizeof at);
  assert_true(fabs(j->origin.rotation[1][0] - 1) < 1e-15);
  assert_int_equal(m->joint[1].mimic, 0);
  assert_true(m->joint[1].factor == 3 && m->joint[1].offset == -1);
  assert_true(isinf(m->joint[1].upper) && m->joint[1].axis[0] == 1);
  assert_int_equal(r.shapes, 4);
  static const sepax_shape_kind kinds[] = {SEPAX_SHAPE_BOX, SEPAX_SHAPE_CYLINDER,
                                           SEPAX_SHAPE_SPHERE, SEPAX_SHAPE_MESH};
  static const double sizes[][3] = {{1, 2, 3}, {2, 7, 0}, {4, 0, 0}, {.001, .002, -.003}};
  for (size_t n = 0; n < 4; n++) {
    assert_int_equal(r.shape[n].kind, kinds[n]);
    assert_int_equal(r.shape[n].link, 1);
    assert_memory_equal(r.shape[n].size, sizes[n], sizeof sizes[n]);
  }
  assert_true(r.shape[0].origin.translation[2] == 5);
  assert_non_null(strstr(r.shape[3].path, "/part.obj"));
  sepax_robot_free(&r);
}

/* rpy against turns about x, then y, then z, by matrices. */
CASE(test_rpy) {
  for (int n = 0; n < 200; n++) {
    char text[600];
    double a[3] = {3 * random_unit(), 3 * random_unit(), 3 * random_unit()};
    snprintf(text, sizeof text, HEAD TWO JOINT("fixed", "<origin rpy='%.17g %.17g %.17g'/>") TAIL,
             a[0], a[1], a[2]);
    sepax_robot r;
    assert_works(read_text(&r, text));
    for (int k = 0; k < 3; k++) {
      double v[3] = {k == 0, k == 1, k == 2};
      for (int axis = 0; axis < 3; axis++) {
        int p = (axis + 1) % 3;
        int q = (axis + 2) % 3;
        double x = cos(a[axis]) * v[p] - sin(a[axis]) * v[q];
        v[q] = sin(a[axis]) * v[p] + cos(a[axis]) * v[q];
        v[p] = x;
      }
      for (int i = 0; i < 3; i++) {
        assert_true(fabs(v[i] - r.mechanism.joint[0].origin.rotation[i][k]) < 1e-14);
      }
    }
    sepax_robot_free(&r);
  }
}

CASE(test_refused) {
  refuse_text("", "mend the XML");
  refuse_text("<robot name='r'>\n<link name='a'>\n", "r.urdf:3: ");
  refuse_text("<sdf/>", "its root is no <robot>");
  refuse_text(HEAD TAIL, "no link");
  refuse_text(HEAD "<link/>\n" TAIL, "r.urdf:2: <link> without name=");
  refuse_text(HEAD "<link name=''/>\n" TAIL, "empty, or not printable");
  refuse_text(HEAD "<link name='a&#10;b'/>\n" TAIL, "not printable");
  refuse_text(HEAD TWO "<link name='a'/>\n" TAIL, "r.urdf:4: two links of one name");
  refuse_text(HEAD TWO TAIL, "links a and b: two roots");
  refuse_text(HEAD TWO JOINT("ball", "") TAIL, "r.urdf:4: joint j: type 'ball' is none of");
  refuse_text(HEAD TWO JOINT("planar", "") TAIL, "r.urdf:4: joint j: planar, and its axis is not");
  refuse_text(HEAD TWO JOINT("planar", "<axis xyz='0 0 -1'/>") TAIL, "its axis is not 0 0 1");
  refuse_text(HEAD TWO JOINT("floating", "<mimic joint='j'/>") TAIL,
              "joint j: <mimic> of a joint with several values");
  refuse_text(HEAD TWO JOINT("revolute", "") TAIL, "joint j: revolute without <limit");
  refuse_text(HEAD TWO JOINT("prismatic", "<limit lower='1' upper='0'/>") TAIL,
              "r.urdf:4: joint j: the lower limit, 1, is above the upper, 0");
  refuse_text(HEAD TWO JOINT("prismatic", "<limit lower='nan' upper='0'/>") TAIL,
              "lower=\"nan\": give 1 finite number");
  refuse_text(HEAD TWO JOINT("fixed", "<origin xyz='0 0 1e308'/>") TAIL, "a number beyond 1e+12");
  refuse_text(HEAD TWO JOINT("fixed", "<origin rpy='0 0 -2e12'/>") TAIL, "r.urdf:4: <origin>: a");
  refuse_text(HEAD TWO JOINT("fixed", "<origin xyz='1 2'/>") TAIL, "xyz=\"1 2\": give 3 finite");
  refuse_text(HEAD TWO JOINT("fixed", "<origin xyz='1 2 3 4'/>") TAIL, "give 3 finite numbers");
  refuse_text(HEAD TWO JOINT("fixed", "<origin rpy='0x1 0 0'/>") TAIL, "give 3 finite numbers");
  refuse_text(HEAD TWO JOINT("continuous", "<axis xyz='0 0 0'/>") TAIL, "no direction");
  refuse_text(HEAD TWO JOINT("continuous", "<mimic joint='j'/>") TAIL, "it follows itself");
  refuse_text(HEAD TWO JOINT("continuous", "<mimic joint='k'/>") TAIL, "there is no joint 'k'");
  refuse_text(HEAD TWO "<joint name='j' type='fixed'><parent link='a'/></joint>" TAIL,
              "without <child link");
  refuse_text(HEAD TWO
              "<joint name='j' type='fixed'><parent link='a'/><child link='c'/></joint>" TAIL,
              "<child>: there is no link 'c'");
  refuse_text(HEAD TWO JOINT("fixed", "") JOINT("fixed", "") TAIL, "two joints 'j'");
  refuse_text(
      HEAD TWO JOINT(
          "fixed",
          "") "<joint name='k' type='fixed'><parent link='b'/><child link='a'/></joint>" TAIL,
      "r.urdf:5: links b and a are on a cycle; leave joint k out");
  refuse_text("<robot name='r' xmlns:xacro='x'>\n<xacro:macro/>\n</robot>", "run xacro");
}

/* Of elements that may stand once, a second is not what one sees in the file. */
CASE(test_second_elements) {
  static const char *const joints[][2] = {
      {"<origin/>\n<origin xyz='9 0 0'/>", "origin"},
      {"<axis xyz='1 0 0'/>\n<axis xyz='0 1 0'/>", "axis"},
      {"<limit/>\n<limit upper='1'/>", "limit"},
      {"<mimic joint='k'/>\n<mimic joint='k' offset='1'/>", "mimic"},
      {"\n<parent link='b'/>", "parent"},
      {"\n<child link='a'/>", "child"},
  };
  for (size_t n = 0; n < sizeof joints / sizeof joints[0]; n++) {
    char text[600];
    char part[100];
    snprintf(text, sizeof text,
             HEAD TWO JOINT("prismatic", "%s%s") "<joint name='k' type='continuous'>"
                                                 "<parent link='b'/><child link='c'/></joint>"
                                                 "<link name='c'/>" TAIL,
             joints[n][0], strstr(joints[n][0], "limit") != NULL ? "" : "<limit upper='9'/>");
    snprintf(part, sizeof part, "r.urdf:5: a second <%s> in one <joint>", joints[n][1]);
    refuse_text(text, part);
  }
}

static void refuse_geometry(const char *geometry, const char *part) {
  char text[600];
  snprintf(text, sizeof text, HEAD "<link name='a'><collision>\n%s</collision></link>" TAIL,
           geometry);
  refuse_text(text, part);
  assert_message("r.urdf:");
}

CASE(test_geometry_refused) {
  refuse_geometry("", "<collision> without geometry");
  refuse_geometry("<geometry/>", "<collision> without geometry");
  refuse_geometry("<geometry><cone radius='1'/></geometry>", "<cone> in <geometry> is not known");
  refuse_geometry("<geometry><capsule radius='1'/></geometry>", "<capsule> without length=");
  refuse_geometry("<geometry><box size='1 2'/></geometry>", "give 3 finite numbers");
  refuse_geometry("<geometry><box/></geometry>", "<box> without size=");
  refuse_geometry("<geometry><sphere radius='-1'/></geometry>", "a length of -1 m");
  refuse_geometry("<geometry><cylinder radius='1'/></geometry>", "<cylinder> without length=");
  refuse_geometry("<geometry><cylinder radius='1' length='0'/></geometry>", "makes it flat");
  refuse_geometry("<geometry><box size='1 0 1'/></geometry>", "r.urdf:3: <box>: a length of 0 m");
  refuse_geometry("<geometry><capsule radius='0' length='1'/></geometry>", "makes it flat");
  refuse_geometry("<geometry><mesh/></geometry>", "<mesh> without filename");
  refuse_geometry("<geometry><mesh filename='none.stl'/></geometry>", "none.stl: no such file");
  refuse_geometry("<geometry><mesh filename='http://x/y.stl'/></geometry>", "is not fetched");
  refuse_geometry("<geometry><mesh filename='package://p/y.stl'/></geometry>",
                  "give --package=p:FOLDER");
  refuse_geometry("<geometry><box size='1 1 1'/>\n<sphere radius='9'/></geometry>",
                  "r.urdf:4: <sphere> beside <box> in one <geometry>");
  refuse_geometry("<geometry><box size='1 1 1'/></geometry>\n<geometry><sphere radius='9'/>"
                  "</geometry>",
                  "r.urdf:4: a second <geometry> in one <collision>");
  refuse_geometry("<origin/>\n<origin xyz='9 0 0'/><geometry><box size='1 1 1'/></geometry>",
                  "r.urdf:4: a second <origin> in one <collision>");
  put_file("part.obj", "v 0 0 0\n");
  refuse_geometry("<geometry><mesh filename='part.obj' scale='1 0 1'/></geometry>", "scale of 0");
}

/* Of version 1.1 in a file of any version; a length of 0 is allowed. */
CASE(test_capsules) {
  sepax_robot r;
  assert_works(read_text(
      &r, HEAD "<link name='a'><collision><geometry><capsule radius='2' length='7'/></geometry>"
               "</collision><collision><geometry><capsule radius='2' length='0'/></geometry>"
               "</collision></link>" TAIL));
  assert_int_equal(r.shapes, 2);
  assert_int_equal(r.shape[0].kind, SEPAX_SHAPE_CAPSULE);
  assert_true(r.shape[0].size[0] == 2 && r.shape[0].size[1] == 7 && r.shape[1].size[1] == 0);
  sepax_robot_free(&r);
}

/* Lengths that are all 0: no surface, and told. */
CASE(test_nothing) {
  sepax_robot r;
  assert_works(read_text(
      &r, HEAD "<link name='a'/>\n<link name='b'>\n<collision><geometry><box size='0 0 0'/>"
               "</geometry></collision>\n"
               "<collision><geometry><sphere radius='0'/></geometry></collision>\n"
               "<collision><geometry><capsule radius='0' length='0'/></geometry></collision>"
               "</link>" JOINT("fixed", "") TAIL));
  assert_int_equal(r.shapes, 0);
  assert_int_equal(r.nothings, 3);
  static const sepax_shape_kind kinds[] = {SEPAX_SHAPE_BOX, SEPAX_SHAPE_SPHERE,
                                           SEPAX_SHAPE_CAPSULE};
  for (size_t n = 0; n < 3; n++) {
    assert_int_equal(r.nothing[n].link, 1);
    assert_int_equal(r.nothing[n].kind, kinds[n]);
    assert_int_equal(r.nothing[n].line, 4 + n);
  }
  sepax_robot_free(&r);
}

/* ------------------------------------------------------------------------- versions */

#define VERSION(text) "<robot name='r' version='" text "'>\n" TWO

CASE(test_versions) {
  sepax_robot r;
  static const char *const known[] = {VERSION("1.0"), VERSION("1.1"), VERSION("1.2")};
  for (size_t n = 0; n < LENGTH(known); n++) {
    char text[400];
    snprintf(text, sizeof text, "%s%s", known[n], JOINT("fixed", "") TAIL);
    assert_works(read_text(&r, text));
    sepax_robot_free(&r);
  }
  refuse_text(VERSION("9.0") TAIL, "r.urdf:1: version=\"9.0\" is not known; give the file as URDF");
  refuse_text(VERSION("1") TAIL, "version=\"1\" is not known");
  refuse_text(VERSION("1.0.0") TAIL, "version=\"1.0.0\" is not known");
  refuse_text(VERSION("") TAIL, "version=\"...\" is empty");
  /* without limits a joint of 1.0 stands still; 1.2 says nothing of the sort */
  assert_works(read_text(&r, VERSION("1.0") JOINT("revolute", "<limit upper='1'/>") TAIL));
  assert_true(r.mechanism.joint[0].lower == 0 && r.mechanism.joint[0].upper == 1);
  sepax_robot_free(&r);
  refuse_text(VERSION("1.2") JOINT("revolute", "<limit upper='1'/>") TAIL,
              "r.urdf:4: joint j: URDF 1.2 has no limit of 0 by default; give lower and upper");
  assert_works(read_text(&r, VERSION("1.2")
                                 JOINT("revolute", "<limit lower='0' upper='1' jerk='3'/>") TAIL));
  sepax_robot_free(&r);
}

/* A quaternion against turns by rpy that are the same. */
CASE(test_quaternions) {
  for (int n = 0; n < 200; n++) {
    double a[3] = {3 * random_unit(), 1.5 * random_unit(), 3 * random_unit()};
    double c[3];
    double s[3];
    char text[2][600];
    for (int i = 0; i < 3; i++) {
      c[i] = cos(a[i] / 2);
      s[i] = sin(a[i] / 2);
    }
    double scale = 1 + 9e-4 * random_unit();
    snprintf(text[0], sizeof text[0],
             VERSION("1.1") JOINT("fixed", "<origin xyz='1 2 3' "
                                           "quat_xyzw='%.17g %.17g %.17g %.17g'/>") TAIL,
             scale * (s[0] * c[1] * c[2] - c[0] * s[1] * s[2]),
             scale * (c[0] * s[1] * c[2] + s[0] * c[1] * s[2]),
             scale * (c[0] * c[1] * s[2] - s[0] * s[1] * c[2]),
             scale * (c[0] * c[1] * c[2] + s[0] * s[1] * s[2]));
    snprintf(text[1], sizeof text[1],
             VERSION("1.1") JOINT("fixed", "<origin xyz='1 2 3' rpy='%.17g %.17g %.17g'/>") TAIL,
             a[0], a[1], a[2]);
    sepax_robot r[2];
    assert_works(read_text(&r[0], text[0]));
    assert_works(read_text(&r[1], text[1]));
    for (int i = 0; i < 9; i++) {
      assert_true(fabs(r[0].mechanism.joint[0].origin.rotation[i / 3][i % 3] -
                       r[1].mechanism.joint[0].origin.rotation[i / 3][i % 3]) < 1e-14);
    }
    assert_true(r[0].mechanism.joint[0].origin.translation[1] == 2);
    sepax_robot_free(&r[0]);
    sepax_robot_free(&r[1]);
  }
  refuse_text(HEAD TWO JOINT("fixed", "<origin quat_xyzw='0 0 0 1'/>") TAIL,
              "r.urdf:4: quat_xyzw is of URDF 1.1; give <robot version=\"1.1\">, or rpy");
  refuse_text(VERSION("1.1") JOINT("fixed", "<origin rpy='0 0 0' quat_xyzw='0 0 0 1'/>") TAIL,
              "<origin> has rpy and quat_xyzw; leave one of them out");
  refuse_text(VERSION("1.1") JOINT("fixed", "<origin quat_xyzw='0 0 0 1.0011'/>") TAIL,
              "quat_xyzw: its length is 1.0011; give one of length 1, within 0.001");
  refuse_text(VERSION("1.1") JOINT("fixed", "<origin quat_xyzw='0 0 1'/>") TAIL, "give 4 finite");
}

/* ------------------------------------------------------------------------- elements */

static void expect_others(const sepax_robot_others *others, const char *const *what,
                          const size_t *count, size_t kinds) {
  assert_int_equal(others->count, kinds);
  for (size_t n = 0; n < kinds; n++) {
    assert_string_equal(others->entry[n].what, what[n]);
    assert_int_equal(others->entry[n].count, count[n]);
  }
}

/* What is passed over is counted, and is no part of the robot, whatever it has in it. */
CASE(test_passed_over) {
  sepax_robot r;
  assert_works(read_text(
      &r, "<robot name='r' xmlns:x='y' x:a='1'><gazebo reference='a'><link name='z'/></gazebo>"
          "<plugin_of_mine><collision/></plugin_of_mine>"
          "<link name='a' type='t'><visual><RPY/></visual><visual/><inertial>text</inertial>"
          "<collision name='c'><geometry><box size='1 1 1'/></geometry><verbose value='1'/>"
          "<x:collision/></collision>"
          "<x:collision><geometry><sphere radius='1'/></geometry></x:collision>"
          "<y:collision/></link><visual/></robot>"));
  static const char *const what[] = {"x:a=",     "gazebo",  "plugin_of_mine", "visual",
                                     "inertial", "verbose", "x:collision",    "y:collision"};
  static const size_t count[] = {1, 1, 1, 3, 1, 1, 2, 1};
  expect_others(&r.others, what, count, LENGTH(what));
  assert_int_equal(r.shapes, 1);
  assert_int_equal(r.links, 1);
  sepax_robot_free(&r);
}

/* Text between elements, and attributes that mean nothing where they stand, with their lines. */
CASE(test_strays) {
  sepax_robot r;
  assert_works(read_text(
      &r, "<robot name='r'>\n\n  -\n<link name='a'/>\n<link name='b'><collision> ;\n"
          "<geometry><box\n size='1 1 1' name='n'/></geometry></collision>\n\n"
          "<!-- comment -->\n -\n</link>\n"
          "<joint name='j' type='continuous'><parent link='a'/><child link='b'/>\n"
          "<axis rpy='0 0 1' xyz='0 1 0'/></joint>\n<![CDATA[\n\xe2\x80\x94\n]]></robot>"));
  static const char *const what[] = {"text '-'", "text ';'",
                                     "box name=", "axis rpy=", "text '\xe2\x80\x94'"};
  static const size_t count[] = {2, 1, 1, 1, 1};
  static const long line[] = {3, 5, 6, 13, 15};
  expect_others(&r.others, what, count, LENGTH(what));
  for (size_t n = 0; n < LENGTH(what); n++) {
    assert_int_equal(r.others.entry[n].line, line[n]);
  }
  assert_true(r.mechanism.joint[0].axis[1] == 1);
  assert_int_equal(r.shapes, 1);
  sepax_robot_free(&r);
}

/* What may be meant as something that is read stays an error, in the line where it stands. */
CASE(test_strays_refused) {
  static const char *const rows[][2] = {
      {"<link\n\n name='a'\n foo='1'/>", "r.urdf:2: <link foo=\"...\">"},
      {"<link name='a'/>\n\n 1 2\n", "r.urdf:4: <robot>: it contains the text '1', which"},
      {"<link name='a'/>\norigin xyz=''/>", "r.urdf:3: <robot>: it contains the text 'origin'"},
      {"<link name='a'/>\n- Collison -", "the text '-'"},
      {"<link name='a'/>\nlink", "the text 'link'"},
      {"<link name='a'/>\nsiz", "the text 'siz'"},
      {"<link name='a'/>\n${x}", "the text '${x}'"},
      {"<link name='a'><collision><origin>\n-</origin></collision></link>",
       "r.urdf:3: <origin>: it contains the text '-'"},
  };
  for (size_t n = 0; n < LENGTH(rows); n++) {
    char text[300];
    snprintf(text, sizeof text, HEAD "%s" TAIL, rows[n][0]);
    refuse_text(text, rows[n][1]);
  }
  /* It may be the xyz that is not there. */
  refuse_text(HEAD TWO JOINT("continuous", "<axis rpy='0 0 1'/>") TAIL,
              "r.urdf:4: <axis rpy=\"...\">: <axis> has the attributes xyz");
  refuse_text(HEAD TWO JOINT("continuous", "<axis xyz='0 0 1' rpy2='0'/>") TAIL, "<axis rpy2=");
  refuse_text(HEAD TWO
              "<joint name='j' type='fixed'><parent name='a'/><child link='b'/></joint>" TAIL,
              "<parent name=\"...\">: <parent> has the attributes link");
}

/* Nothing of what may be meant as geometry, or as its place, is passed over. */
CASE(test_elements_refused) {
  static const char *const link[][2] = {
      {"<Collision/>", "r.urdf:2: <Collision> in <link> is not known; write <collision>, or leave"},
      {"<collison/>", "write <collision>"},
      {"<colision/>", "write <collision>"},
      {"<collisions/>", "write <collision>"},
      {"<my_collision_2/>", "write <collision>"},
      {"<collision><Geometry/></collision>", "write <geometry>"},
      {"<collision><shape/></collision>", "<shape> in <collision> is not known; mend its name"},
      {"<collision><box size='1 1 1'/></collision>", "<box> in <collision>: it belongs else"},
      {"<geometry/>", "<geometry> in <link>: it belongs elsewhere"},
      {"<link name='c'/>", "<link> in <link>: it belongs elsewhere"},
      {"<collision><geometry><bOx/></geometry></collision>", "write <box>"},
      {"<collision><geometry><cube/></geometry></collision>",
       "<cube> in <geometry> is not known; mend its name, or leave it out (known: mesh box "},
      {"<collision><orgin/></collision>", "write <origin>"},
      {"<collision><origin RPY='0 0 1'/></collision>",
       "r.urdf:2: <origin RPY=\"...\">: <origin> has the attributes xyz rpy quat_xyzw; mend"},
      {"<collision><origin rot='0 0 1'/></collision>", "<origin rot=\"...\">"},
      {"<collision><origin quat='0 0 0 1'/></collision>", "<origin quat=\"...\">"},
      {"<collision><geometry><mesh Scale='1 1 1'/></geometry></collision>", "<mesh Scale="},
      {"<collision><geometry><box Size='1 1 1'/></geometry></collision>", "<box Size="},
      {"<collision><geometry r='1'/></collision>", "<geometry> has no attribute; leave it out"},
      {"<collision>1 0 0<geometry/></collision>",
       "r.urdf:2: <collision>: it contains the text '1', which has no meaning there; leave it out"},
      {"<![CDATA[<collision/>]]>", "<link>: it contains the text '<collision/>'"},
      {"<xacro:block/>", "<xacro:block> is of xacro; run xacro"},
  };
  static const char *const joint[][2] = {
      {"<axis XYZ='0 0 1'/>", "r.urdf:4: <axis XYZ="},
      {"<axes xyz='0 0 1'/>", "write <axis>"},
      {"<limit lower='-1' Upper='1'/>", "<limit Upper="},
      {"<limits lower='-1' upper='1'/>", "write <limit>"},
      {"<mimic joint='k' multiplyer='2'/>", "<mimic multiplyer="},
      {"<Mimic joint='k'/>", "write <mimic>"},
      {"<collision/>", "<collision> in <joint>: it belongs elsewhere"},
  };
  char text[600];
  for (size_t n = 0; n < LENGTH(link); n++) {
    snprintf(text, sizeof text, HEAD "<link name='a'>%s</link>" TAIL, link[n][0]);
    refuse_text(text, link[n][1]);
  }
  for (size_t n = 0; n < LENGTH(joint); n++) {
    snprintf(text, sizeof text, HEAD TWO JOINT("continuous", "%s") TAIL, joint[n][0]);
    refuse_text(text, joint[n][1]);
  }
  refuse_text(HEAD "<Link name='a'/>" TAIL, "<Link> in <robot> is not known; write <link>");
  refuse_text(HEAD "<jiont name='a'/>" TAIL, "write <joint>");
  refuse_text(HEAD "<collision/>" TAIL, "<collision> in <robot>: it belongs elsewhere");
  refuse_text("<robot Name='r'/>", "<robot Name=");
}

/* As many names as nobody has. */
CASE(test_many_others) {
  static char text[300 * 24 + 100] = HEAD "<link name='a'/>";
  for (int n = 0; n < 300; n++) {
    snprintf(text + strlen(text), 24, "<thing%d/>", n);
  }
  strcat(text, TAIL);
  refuse_text(text, "<thing256>: more than 256 kinds of unknown elements");
}

/* ------------------------------------------------------------------- several values */

/* A body in space is where rpy and xyz put it: six joints with links between them. */
CASE(test_floating) {
  sepax_robot r;
  assert_works(read_text(&r, HEAD TWO "<link name='c'/>" JOINT(
                                 "floating", "<origin xyz='1 2 3' rpy='.1 .2 .3'/><limit lower='1' "
                                             "upper='0'/>") "<joint name='k' type='fixed'>"
                                                            "<parent link='b'/><child link='c'/>"
                                                            "</joint>" TAIL));
  const sepax_mechanism *m = &r.mechanism;
  static const char *const names[] = {"j/x", "k", "j/y", "j/z", "j/yaw", "j/pitch", "j/roll"};
  static const size_t order[] = {0, 6, 1, 2, 3, 4, 5};
  assert_int_equal(m->joints, 7);
  assert_int_equal(m->links, 8);
  assert_int_equal(r.links, 3);
  for (size_t n = 0; n < 7; n++) {
    assert_string_equal(m->joint[order[n]].name, names[n]);
    assert_true(n == 1 || (sepax_joint_driven(&m->joint[order[n]]) &&
                           isinf(m->joint[order[n]].lower) && isinf(m->joint[order[n]].upper)));
  }
  for (int n = 0; n < 50; n++) {
    double value[7] = {0};
    sepax_pose pose[8];
    char text[600];
    sepax_robot fixed;
    for (int k = 0; k < 6; k++) {
      value[k] = 3 * random_unit();
    }
    snprintf(text, sizeof text,
             HEAD TWO "<link name='o'/><joint name='o' type='fixed'><parent link='a'/>"
                      "<child link='o'/><origin xyz='1 2 3' rpy='.1 .2 .3'/></joint>"
                      "<joint name='j' type='fixed'><parent link='o'/><child link='b'/>"
                      "<origin xyz='%.17g %.17g %.17g' rpy='%.17g %.17g %.17g'/></joint>" TAIL,
             value[0], value[1], value[2], value[5], value[4], value[3]);
    assert_works(read_text(&fixed, text));
    sepax_pose want[3];
    sepax_mechanism_poses(m, value, pose);
    sepax_mechanism_poses(&fixed.mechanism, value, want);
    for (int i = 0; i < 3; i++) {
      assert_true(fabs(pose[1].translation[i] - want[1].translation[i]) < 1e-14);
      for (int k = 0; k < 3; k++) {
        assert_true(fabs(pose[1].rotation[i][k] - want[1].rotation[i][k]) < 1e-14);
      }
    }
    sepax_robot_free(&fixed);
  }
  sepax_robot_free(&r);
  assert_works(read_text(&r, HEAD TWO JOINT("planar", "<axis xyz='0 0 2'/>") TAIL));
  assert_int_equal(r.mechanism.joints, 3);
  assert_int_equal(r.mechanism.links, 4);
  assert_string_equal(r.mechanism.joint[2].name, "j/yaw");
  assert_int_equal(r.mechanism.joint[2].child, 1);
  sepax_robot_free(&r);
}

#define THREE TWO "<link name='c'/>"
#define SECOND(name, type) \
  "<joint name='" name "' type='" type "'><parent link='b'/><child link='c'/></joint>\n"

CASE(test_names_of_parts) {
  refuse_text(HEAD THREE JOINT("floating", "") SECOND("j", "fixed") TAIL,
              "r.urdf:5: two joints 'j'");
  refuse_text(HEAD THREE JOINT("floating", "") SECOND("j", "floating") TAIL, "two joints 'j'");
  refuse_text(HEAD THREE JOINT("floating", "") SECOND("j/z", "fixed") TAIL, "two joints 'j/z'");
  refuse_text(HEAD THREE SECOND("j/x", "fixed") JOINT("floating", "") TAIL, "two joints 'j/x'");
  refuse_text(HEAD THREE SECOND("j/z", "fixed") JOINT("floating", "") TAIL, "two joints 'j/z'");
  refuse_text(HEAD THREE "<link name='j/z'/>" JOINT("floating", "") TAIL, "two links of one name");
}

/* Neither entities nor a document type: nothing is expanded, nothing is read. */
CASE(test_document_types) {
  static const char part[] = "it has a document type (<!DOCTYPE>); take it out";
  refuse_text("<!DOCTYPE robot [<!ENTITY a 'aaaaaaaaaa'><!ENTITY b '&a;&a;&a;&a;&a;&a;&a;&a;'>\n"
              "<!ENTITY c '&b;&b;&b;&b;&b;&b;&b;&b;'><!ENTITY d '&c;&c;&c;&c;&c;&c;&c;&c;'>]>\n"
              "<robot name='&d;'><link name='&d;'/></robot>",
              part);
  refuse_text("<!DOCTYPE robot SYSTEM 'http://localhost/none.dtd'>\n<robot name='r'/>", part);
  refuse_text("<!DOCTYPE robot>\n<robot name='r'><link name='a'/></robot>", part);
  refuse_text("<robot name='&lol;'><link name='a'/></robot>", "mend the XML");
  static char deep[3 * 300 + 20] = "<robot>";
  for (int n = 0; n < 300; n++) {
    strcat(deep, "<a>");
  }
  refuse_text(deep, "r.urdf:1: deeper than 256 elements");
}

CASE(test_packages) {
  sepax_robot r;
  char own[600]; /* the scratch folder is the package */
  static const char text[] = HEAD "<link name='a'><collision><geometry>"
                                  "<mesh filename='package://p/part.obj'/></geometry></collision>"
                                  "</link>" TAIL;
  put_file("part.obj", "v 0 0 0\n");
  const sepax_package package[] = {{"other", "/"}, {"p", folder}};
  const char *urdf = put_file("r.urdf", text);
  assert_works(sepax_robot_read(&r, urdf, &SEPAX_STRUCT(sepax_robot_reading, package, 2), &fault));
  assert_string_equal(r.shape[0].path, in_folder("part.obj"));
  sepax_robot_free(&r);
  const sepax_package elsewhere[] = {{"p", "/nowhere"}};
  assert_fault(sepax_robot_read(&r, urdf, &SEPAX_STRUCT(sepax_robot_reading, elsewhere, 1), &fault),
               "in package folder /nowhere");
  snprintf(own, sizeof own,
           HEAD "<link name='a'><collision><geometry><mesh filename='package://%s/part.obj'/>"
                "</geometry></collision></link>" TAIL,
           strrchr(folder, '/') + 1);
  assert_works(read_text(&r, own));
  sepax_robot_free(&r);
  snprintf(own, sizeof own, "%s/pp", folder);
  assert_int_equal(mkdir(own, 0700), 0);
  snprintf(own, sizeof own,
           HEAD "<link name='a'><collision><geometry>"
                "<mesh filename='package://pp/typo.obj'/></geometry></collision>"
                "</link>" TAIL);
  assert_fault(read_text(&r, own), "no file pp/typo.obj in package folder ");
  assert_message("/pp; mend the name");
}

/* ---------------------------------------------------------------------------- SRDF */

static sepax_robot three_links(void) {
  sepax_robot r;
  assert_works(read_text(&r, HEAD TWO "<link name='c'/>" JOINT(
                                 "continuous", "") "<joint name='k' type='fixed'><parent link='b'/>"
                                                   "<child link='c'/></joint>" TAIL));
  return r;
}

static void expect_pairs(const sepax_robot *r, const char *text, const char *bits) {
  bool compared[9];
  memset(compared, true, sizeof compared);
  assert_works(sepax_srdf_read(compared, &r->mechanism, NULL, put_file("r.srdf", text), &fault));
  static const int pair[3][2] = {{0, 1}, {0, 2}, {1, 2}};
  for (int n = 0; n < 3; n++) {
    assert_int_equal(compared[3 * pair[n][0] + pair[n][1]], bits[n] == '1');
    assert_int_equal(compared[3 * pair[n][1] + pair[n][0]], bits[n] == '1');
  }
}

CASE(test_srdf) {
  sepax_robot r = three_links();
  expect_pairs(&r, HEAD TAIL, "111");
  expect_pairs(&r, HEAD "<disable_collisions link1='b' link2='a' reason='Adjacent'/>" TAIL, "011");
  expect_pairs(&r,
               HEAD "<disable_default_collisions link='a'/>"
                    "<enable_collisions link1='a' link2='c'/>" TAIL,
               "011");
  expect_pairs(&r,
               HEAD "<group name='g'/><link_sphere_approximation link='a'/><group_tcps/>"
                    "<virtual_joint name='v' child_link='a'/>" TAIL,
               "111");
  static const char *const wrong[][2] = {
      {"\n<disable_collision link1='a' link2='b'/>", "r.srdf:3: <disable_collision> is no element"},
      {"\n<disable_default_collision link='a'/>", "r.srdf:3: <disable_default_collision> is no"},
      {"\n<link name='a'/>", "r.srdf:3: <link> is of a URDF; give an SRDF"},
      {"\n<joint name='a'/>", "r.srdf:3: <joint> is of a URDF"},
      {"\n<Disable_collisions/>", "r.srdf:3: <Disable_collisions> in <robot> is not known; write"},
      {"\n<disable_collisions link1='a' link2='b' Reason='x'/>", "<disable_collisions Reason="},
      {"\n<disable_collisions link1='a' link2='b'><link/></disable_collisions>", "<link> in <dis"},
      {"\n<disable_collisions link1='a' link2='b'>c</disable_collisions>", "contains the text 'c'"},
  };
  bool compared[9];
  sepax_srdf of = {0};
  for (size_t n = 0; n < sizeof wrong / sizeof wrong[0]; n++) {
    char srdf[200];
    snprintf(srdf, sizeof srdf, HEAD "%s" TAIL, wrong[n][0]);
    assert_fault(sepax_srdf_read(compared, &r.mechanism, &of, put_file("r.srdf", srdf), &fault),
                 wrong[n][1]);
    assert_null(of.robot);
  }
  assert_works(sepax_srdf_read(compared, &r.mechanism, &of,
                               put_file("r.srdf", "<robot name='other'/>"), &fault));
  assert_string_equal(of.robot, "other");
  assert_string_equal(r.name, "r");
  sepax_srdf_free(&of);
  assert_works(sepax_srdf_read(compared, &r.mechanism, &of,
                               put_file("r.srdf", HEAD
                                        "<group name='g'><link name='a'/></group><group name='h'/>"
                                        "<notes/><x:y/>" TAIL),
                               &fault));
  static const char *const what[] = {"group", "notes", "x:y"};
  static const size_t count[] = {2, 1, 1};
  expect_others(&of.others, what, count, 3);
  sepax_srdf_free(&of);
  assert_fault(
      sepax_srdf_read(compared, &r.mechanism, NULL,
                      put_file("r.srdf", HEAD "\n<disable_collisions link1='a' link2='x'/>" TAIL),
                      &fault),
      "r.srdf:3: there is no link 'x'");
  assert_fault(sepax_srdf_read(compared, &r.mechanism, NULL,
                               put_file("r.srdf", "<!DOCTYPE robot><robot/>"), &fault),
               "document type");
  assert_fault(sepax_srdf_read(compared, &r.mechanism, NULL, in_folder("none.srdf"), &fault),
               "No such file");
  sepax_robot_free(&r);
}
