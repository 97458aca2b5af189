/* SPDX-License-Identifier: MIT */
/* kinematics.c - links in their poses against quaternions in long double, within the bound that
 * sepax_mechanism.h gives; chains; what is no mechanism. */
#include "unit/mechanism/places.h"

enum { LINKS_MOST = 300 };

/* Within the bound: every column of the rotation, and the translation. */
static void assert_near(const sepax_pose *pose, const place *exact, double joints, double reach) {
  long double off = 0;
  for (int k = 0; k < 3; k++) {
    long double unit[3] = {k == 0, k == 1, k == 2};
    long double image[3];
    long double square = 0;
    turn(exact->q, unit, image);
    for (int i = 0; i < 3; i++) {
      square += (image[i] - pose->rotation[i][k]) * (image[i] - pose->rotation[i][k]);
    }
    off = fmaxl(off, sqrtl(square));
  }
  assert_true(off <= joints * 0x1p-46L);
  long double square = 0;
  for (int i = 0; i < 3; i++) {
    long double d = exact->t[i] - pose->translation[i];
    square += d * d;
  }
  assert_true(sqrtl(square) <= joints * reach * 0x1p-45L);
}

static double length_of(const double v[3]) { return sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]); }

/* A tree of joints of all kinds; each link's parent is any before it, or the one before it. */
static void check_tree(size_t joints, bool row) {
  sepax_mechanism m = row_of(joints);
  double value[LINKS_MOST];
  place exact[LINKS_MOST] = {{{1, 0, 0, 0}, {0, 0, 0}}};
  double reach[LINKS_MOST] = {0};
  double above[LINKS_MOST] = {0};
  sepax_pose pose[LINKS_MOST];
  for (size_t n = 0; n < joints; n++) {
    draw_joint(&m.joint[n], n + 1);
    m.joint[n].parent = row ? n : m.joint[n].parent;
    value[n] = 7 * random_unit();
    place step = place_of(&m.joint[n], value[n]);
    size_t parent = m.joint[n].parent;
    exact[n + 1] = after(&exact[parent], &step);
    above[n + 1] = above[parent] + 1;
    reach[n + 1] = reach[parent] + length_of(m.joint[n].origin.translation) +
                   (m.joint[n].kind == SEPAX_JOINT_PRISMATIC ? fabs(value[n]) : 0);
  }
  assert_works(sepax_mechanism_join(&m, &fault));
  assert_int_equal(m.root, 0);
  sepax_mechanism_poses(&m, value, pose);
  for (size_t n = 0; n <= joints; n++) {
    assert_works(sepax_pose_valid(&pose[n], &fault));
    assert_near(&pose[n], &exact[n], above[n], reach[n]);
  }
  for (int trial = 0; trial < 20; trial++) {
    size_t a = (size_t)random_below((int)joints + 1);
    size_t b = (size_t)random_below((int)joints + 1);
    sepax_chain chain;
    sepax_pose pair[2];
    assert_works(sepax_chain_find(&chain, &m, a, b, &fault));
    sepax_chain_poses(&chain, &m, value, pair);
    place root = exact[chain.top];
    for (int i = 0; i < 3; i++) { /* back from the top's coordinates: its conjugate */
      root.q[1 + i] = -root.q[1 + i];
    }
    for (int side = 0; side < 2; side++) {
      size_t link = side == 0 ? a : b;
      long double way[3];
      for (int i = 0; i < 3; i++) {
        way[i] = exact[link].t[i] - exact[chain.top].t[i];
      }
      place turned = {{root.q[0], root.q[1], root.q[2], root.q[3]}, {0, 0, 0}};
      place only = {{exact[link].q[0], exact[link].q[1], exact[link].q[2], exact[link].q[3]},
                    {0, 0, 0}};
      place seen = after(&turned, &only);
      turn(root.q, way, seen.t);
      assert_near(&pair[side], &seen, above[link] - above[chain.top] + 0x1p-6,
                  reach[link] - reach[chain.top] + 0x1p-6);
    }
    sepax_chain_free(&chain);
  }
  sepax_mechanism_free(&m);
}

CASE(test_random_trees) {
  for (int n = 0; n < FEWER(300); n++) {
    check_tree(1 + (size_t)random_below(30), n % 2 == 0);
  }
}

CASE(test_deep_chain) { check_tree(LINKS_MOST - 1, true); }

/* Of as many joints as there may be, poses stay valid, and right angles stay exact. */
CASE(test_longest_chain) {
  sepax_mechanism m = row_of(SEPAX_JOINTS_MOST);
  double *value = calloc(m.joints, sizeof *value);
  sepax_pose *pose = calloc(m.links, sizeof *pose);
  assert_non_null(value);
  assert_non_null(pose);
  for (size_t n = 0; n < m.joints; n++) {
    m.joint[n].kind = SEPAX_JOINT_REVOLUTE;
    m.joint[n].axis[n % 2] = 1;
    value[n] = 0.1 + 1e-4 * (double)n;
  }
  assert_works(sepax_mechanism_join(&m, &fault));
  sepax_mechanism_poses(&m, value, pose);
  for (size_t n = 0; n < m.links; n++) {
    assert_works(sepax_pose_valid(&pose[n], &fault));
  }
  free(value);
  free(pose);
  sepax_mechanism_free(&m);
}

/* Along the axes of coordinates whole numbers stay whole. */
CASE(test_prismatic_is_exact) {
  sepax_mechanism m = row_of(3);
  for (int n = 0; n < 3; n++) {
    m.joint[n].kind = SEPAX_JOINT_PRISMATIC;
    m.joint[n].axis[2] = 0;
    m.joint[n].axis[n] = -3;
    m.joint[n].origin.translation[n] = 10;
  }
  assert_works(sepax_mechanism_join(&m, &fault));
  static const double value[3] = {0.5, -7, 3};
  sepax_pose pose[4];
  sepax_mechanism_poses(&m, value, pose);
  static const sepax_pose expected = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {9.5, 17, 7}};
  for (int i = 0; i < 3; i++) {
    assert_true(pose[3].translation[i] == expected.translation[i]);
    for (int k = 0; k < 3; k++) {
      assert_true(pose[3].rotation[i][k] == expected.rotation[i][k]);
    }
  }
  sepax_mechanism_free(&m);
}

/* An origin that is valid, but wrong in the seventh digit: the chain stays valid. */
CASE(test_origins_become_orthonormal) {
  sepax_mechanism m = row_of(200);
  for (size_t n = 0; n < m.joints; n++) {
    for (int i = 0; i < 9; i++) {
      m.joint[n].origin.rotation[i / 3][i % 3] *= 1 + 4e-7;
    }
  }
  assert_works(sepax_mechanism_join(&m, &fault));
  sepax_pose pose[201];
  double value[200] = {0};
  sepax_mechanism_poses(&m, value, pose);
  assert_true(fabs(pose[200].rotation[0][0] - 1) < 1e-13);
  sepax_mechanism_free(&m);
}

CASE(test_mimic) {
  sepax_mechanism m = row_of(3);
  for (int n = 0; n < 3; n++) {
    m.joint[n].kind = SEPAX_JOINT_PRISMATIC;
  }
  m.joint[0].mimic = 2;
  m.joint[0].factor = -2;
  m.joint[0].offset = 0.25;
  assert_works(sepax_mechanism_join(&m, &fault));
  assert_false(sepax_joint_driven(&m.joint[0]));
  assert_true(sepax_joint_driven(&m.joint[1]));
  double value[3] = {99, 5, 3};
  sepax_mechanism_follow(&m, value);
  assert_true(value[0] == -5.75 && value[1] == 5 && value[2] == 3);
  sepax_mechanism_free(&m);
}

/* Each follows the next, or the one before, in any order: afterwards all follow the one that leads,
 * by the product of the factors. */
CASE(test_mimic_chains) {
  enum { LONGEST = 300 };
  static const size_t lengths[] = {2, 3, 17, LONGEST};
  for (size_t trial = 0; trial < 4 * LENGTH(lengths); trial++) {
    size_t joints = lengths[trial / 4];
    sepax_mechanism m = row_of(joints);
    size_t at[LONGEST]; /* joint at[k + 1] follows at[k] */
    double value[LONGEST] = {0};
    double want = 3;
    for (size_t n = 0; n < joints; n++) {
      m.joint[n].kind = SEPAX_JOINT_PRISMATIC;
      at[n] = trial % 4 == 0 ? n : joints - 1 - n;
    }
    for (size_t n = joints; trial % 4 >= 2 && n-- > 1;) {
      size_t other = (size_t)random_below((int)n + 1);
      size_t swapped = at[n];
      at[n] = at[other];
      at[other] = swapped;
    }
    for (size_t n = 1; n < joints; n++) {
      m.joint[at[n]].mimic = at[n - 1];
      m.joint[at[n]].factor = n % 2 == 0 ? 0.5 : -2;
      m.joint[at[n]].offset = (double)(n % 3);
    }
    assert_works(sepax_mechanism_join(&m, &fault));
    value[at[0]] = want;
    sepax_mechanism_follow(&m, value);
    for (size_t n = 1; n < joints; n++) {
      want = (n % 2 == 0 ? 0.5 : -2) * want + (double)(n % 3);
      assert_int_equal(m.joint[at[n]].mimic, at[0]);
      assert_true(value[at[n]] == want);
    }
    sepax_mechanism_free(&m);
  }
}

/* ------------------------------------------------------------------ no mechanisms */

/* The root is any link, the last, too. */
CASE(test_root_is_last) {
  sepax_mechanism m = row_of(3);
  for (size_t n = 0; n < 3; n++) {
    m.joint[n].parent = n + 1;
    m.joint[n].child = n;
  }
  assert_works(sepax_mechanism_join(&m, &fault));
  assert_int_equal(m.root, 3);
  assert_int_equal(m.link[3].joint, SEPAX_NO_JOINT);
  for (size_t n = 0; n < 3; n++) {
    assert_int_equal(m.link[n].joint, n);
    assert_int_equal(m.order[n], 2 - n);
  }
  sepax_chain chain;
  assert_works(sepax_chain_find(&chain, &m, 0, 3, &fault));
  assert_true(chain.count == 3 && chain.up == 3 && chain.top == 3);
  sepax_chain_free(&chain);
  sepax_mechanism_free(&m);
}

static void refuse(sepax_mechanism *m, const char *part) {
  assert_fault(sepax_mechanism_join(m, &fault), part);
  sepax_mechanism_free(m);
}

CASE(test_no_mechanism) {
  sepax_mechanism m = {0};
  assert_fault(sepax_mechanism_join(&m, &fault), "no link");
  m = row_of(3);
  m.joint[1].child = 1;
  refuse(&m, "link l1 is its own parent");
  m = row_of(3);
  m.joint[1].child = 3;
  refuse(&m, "link l3: two joints move it, j1 and j2");
  m = row_of(3);
  free(m.joint[--m.joints].name);
  refuse(&m, "links l0 and l3: two roots");
  m = row_of(3);
  m.joint[2].child = 0;
  m.joint[1].kind = SEPAX_JOINT_REVOLUTE;
  free(m.link[--m.links].name);
  refuse(&m, "are on a cycle");
  m = row_of(4); /* beside the tree: l2, l3, l4 in a ring, l1 a root that moves nothing else */
  m.joint[1].parent = 4;
  refuse(&m, "are on a cycle; leave joint j");
  m = row_of(1);
  m.joint[0].kind = SEPAX_JOINT_REVOLUTE;
  m.joint[0].axis[2] = 0;
  refuse(&m, "joint j0: the axis has no direction");
  m = row_of(1);
  m.joint[0].kind = SEPAX_JOINT_PRISMATIC;
  m.joint[0].axis[1] = NAN;
  refuse(&m, "joint j0: the axis has no direction");
  m = row_of(1);
  m.joint[0].lower = 1;
  m.joint[0].upper = -1;
  refuse(&m, "joint j0: the lower limit, 1, is above the upper, -1");
  m = row_of(1);
  m.joint[0].lower = 1; /* held in place, which is no fault */
  m.joint[0].upper = 1;
  assert_works(sepax_mechanism_join(&m, &fault));
  sepax_mechanism_free(&m);
  m = row_of(1);
  m.joint[0].origin.rotation[0][0] = 2;
  refuse(&m, "joint j0: origin: the matrix is no rotation");
  m = row_of(2);
  m.joint[0].mimic = 0;
  refuse(&m, "joint j0: it follows itself");
  m = row_of(2);
  m.joint[0].mimic = 1;
  refuse(&m, "joint j0: it follows j1, which is fixed");
  for (size_t joints = 2; joints < 40; joints++) { /* a cycle, and one that follows it */
    m = row_of(joints);
    for (size_t n = 0; n < joints; n++) {
      m.joint[n].kind = SEPAX_JOINT_PRISMATIC;
      m.joint[n].mimic = n + 2 < joints ? n + 1 : 0;
    }
    refuse(&m, joints > 2 ? "lead to a cycle; name a joint that follows no other"
                          : "joint j0: it follows itself");
  }
  m = row_of(3);
  for (size_t n = 0; n < 3; n++) {
    m.joint[n].kind = SEPAX_JOINT_PRISMATIC;
    m.joint[n].factor = 1e200;
    m.joint[n].mimic = n < 2 ? n + 1 : SEPAX_NO_JOINT;
  }
  refuse(&m, "joint j0: the factor or the offset by which it follows is not finite");
}
