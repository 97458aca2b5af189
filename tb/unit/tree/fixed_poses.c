/* SPDX-License-Identifier: MIT */
/* fixed_poses.c - poses in fixed point turn vertices to where the doubles put them, rounded; what
 * is refused. */
#include "unit/tree/scenes.h"

static sepax_tree *tree_at(const triangles *t, double resolution, double away) {
  sepax_tree *tree;
  sepax_grid grid = {.resolution = resolution, .word = 18};
  for (int i = 0; i < 3; i++) {
    grid.offset[i] = away * random_unit();
  }
  assert_works(sepax_tree_new(&tree, t->tri, t->count, &grid, &fault));
  return tree;
}

/* pose v. */
static void place(long double to[3], const sepax_pose *pose, const long double v[3]) {
  for (int i = 0; i < 3; i++) {
    to[i] = pose->translation[i];
    for (int k = 0; k < 3; k++) {
      to[i] += (long double)pose->rotation[i][k] * v[k];
    }
  }
}

static void place_back(long double to[3], const sepax_pose *pose, const long double v[3]) {
  for (int k = 0; k < 3; k++) {
    to[k] = 0;
    for (int i = 0; i < 3; i++) {
      to[k] += (long double)pose->rotation[i][k] * (v[i] - pose->translation[i]);
    }
  }
}

/* Vertices are within 1/2 LSB and the rounding of the matrix: for coordinates of 2^17, 3 x 2^-4.
 * The inverse of A's pose is its transpose to 2^-52. */
CASE(vertices_are_where_doubles_put_them) {
  triangles t = drawn(4, 0, 100, 100, 18);
  long double most = 0;
  for (int n = 0; n < 3000; n++) {
    double resolution = n % 2 == 0 ? 1 : 0.002;
    sepax_tree *a = tree_at(&t, resolution, 50 * resolution * (n % 3));
    sepax_tree *b = tree_at(&t, resolution, 5000 * resolution * (n % 3));
    sepax_pose of_a = posed(0, 1e5 * resolution);
    sepax_pose of_b = posed(n % 5, 1e5 * resolution);
    const sepax_pose *pose_a = n % 2 == 0 ? NULL : &of_a;
    sepax_tree_pose pose;
    assert_works(sepax_tree_pose_make(&pose, a, pose_a, b, &of_b, 0, &fault));
    sepax_vec p;
    long double v[3];
    int64_t turned_to[3];
    for (int i = 0; i < 3; i++) {
      *coordinate(&p, i) = random_below(1 << 18) - (1 << 17);
      v[i] = (long double)*coordinate(&p, i) * resolution + sepax_tree_grid(b).offset[i];
    }
    turn_exactly(turned_to, &pose.side[0], &p);
    long double at[3];
    place(at, &of_b, v);
    if (pose_a != NULL) {
      memcpy(v, at, sizeof v);
      place_back(at, pose_a, v);
    }
    for (int i = 0; i < 3; i++) {
      long double steps = (at[i] - sepax_tree_grid(a).offset[i]) / resolution;
      long double error = fabsl(steps - turned_to[i]);
      most = error > most ? error : most;
      assert_true(error <= 0.5L + 0.1875L + 0x1p-17L);
    }
    sepax_tree_free(a);
    sepax_tree_free(b);
  }
  assert_true(most > 0.5L);
  free(t.tri);
}

CASE(quarter_turns_are_exact) {
  triangles t = drawn(4, 0, 100, 100, 18);
  sepax_tree *tree = tree_of(&t, 18);
  for (int n = 0; n < 100; n++) {
    sepax_pose of_b = posed(1, 1000);
    sepax_tree_pose pose;
    assert_works(sepax_tree_pose_make(&pose, tree, NULL, tree, &of_b, 7, &fault));
    sepax_vec p = {random_below(1000), random_below(1000), random_below(1000)};
    int64_t v[3];
    turn_exactly(v, &pose.side[0], &p);
    for (int i = 0; i < 3; i++) {
      double exact = of_b.translation[i];
      for (int k = 0; k < 3; k++) {
        exact += of_b.rotation[i][k] * *coordinate(&p, k);
      }
      assert_true((double)v[i] == exact);
      assert_int_equal(pose.side[0].sigma[i], 7 << 10);
      assert_int_equal(pose.side[1].sigma[i], (7 << 10) + 512); /* the margin, and 1/2 */
    }
  }
  sepax_tree_free(tree);
  free(t.tri);
}

CASE(what_is_refused) {
  triangles t = drawn(4, 0, 100, 100, 18);
  sepax_tree *tree = tree_of(&t, 18);
  sepax_tree *other = tree_at(&t, 0.5, 0);
  sepax_tree_pose pose;
  sepax_pose far = posed(3, 0);
  far.translation[1] = 1e7;
  assert_fault(sepax_tree_pose_make(&pose, tree, NULL, other, NULL, 0, &fault), "make them alike");
  assert_fault(sepax_tree_pose_make(&pose, tree, NULL, tree, NULL, 8192, &fault), "0 ... 8191");
  assert_fault(sepax_tree_pose_make(&pose, tree, NULL, tree, NULL, -1, &fault), "0 ... 8191");
  assert_fault(sepax_tree_pose_make(&pose, tree, NULL, tree, &far, 0, &fault), "8388607");
  far.translation[1] = 1e9;
  assert_fault(sepax_tree_pose_make(&pose, tree, NULL, tree, &far, 0, &fault), "2^28 LSB");
  far.translation[1] = NAN;
  assert_fault(sepax_tree_pose_make(&pose, tree, NULL, tree, &far, 0, &fault), "finite");
  far = posed(3, 0);
  far.rotation[0][0] = 1.0000004;
  far.rotation[1][1] = 1 - 2e-7;
  assert_works(sepax_tree_pose_make(&pose, tree, NULL, tree, &far, 0, &fault));
  far.rotation[0][0] = 1 + 4.9e-7;
  assert_fault(sepax_tree_pose_make(&pose, tree, NULL, tree, &far, 0, &fault), "-1 ... 1");
  far.rotation[0][0] = 2;
  assert_fault(sepax_tree_pose_make(&pose, tree, NULL, tree, &far, 0, &fault), "no rotation");
  sepax_tree_free(tree);
  sepax_tree_free(other);
  free(t.tri);
}

CASE(bytes) {
  triangles t = drawn(4, 0, 100, 100, 18);
  sepax_tree *tree = tree_of(&t, 18);
  for (int n = 0; n < 100; n++) {
    sepax_pose of_b = posed(n % 5, 1000);
    sepax_tree_pose pose;
    sepax_tree_pose back;
    uint8_t packed[SEPAX_TREE_POSE_BYTES];
    uint8_t again[SEPAX_TREE_POSE_BYTES];
    assert_works(sepax_tree_pose_make(&pose, tree, NULL, tree, &of_b, n, &fault));
    sepax_tree_pose_pack(&pose, packed);
    assert_works(sepax_tree_pose_unpack(&back, packed, &fault));
    sepax_tree_pose_pack(&back, again);
    assert_memory_equal(packed, again, sizeof packed);
    assert_memory_equal(pose.side[1].shift, back.side[1].shift, sizeof pose.side[1].shift);
    static const struct {
      int at;
      uint8_t byte;
    } wrong[] = {{5, 8}, {29, 0xf7}, {48 + 34, 0x20}, {84 + 3, 1}, {123, 1}, {143, 255}};
    int k = random_below(LENGTH(wrong));
    packed[wrong[k].at] = wrong[k].byte;
    assert_false(sepax_tree_pose_unpack(&back, packed, &fault));
  }
  sepax_tree_free(tree);
  free(t.tri);
}
