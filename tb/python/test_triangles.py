# SPDX-License-Identifier: MIT
"""Triangles of doubles and of integers, against each other and against fractions."""
import fractions
import itertools
import unittest

import numpy as np
import sepax

from shapes import CORNERS, FACES, ball, cube, poses


def cross(u, v):
    """The cross product."""
    return [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]]


def separated(a, b):
    """Whether an axis of the separating axis theorem separates two triangles; in fractions."""
    a, b = ([[fractions.Fraction(x) for x in v] for v in t] for t in (a, b))
    edges = [[[t[(k + 1) % 3][i] - t[k][i] for i in range(3)] for k in range(3)] for t in (a, b)]
    normals = [cross(e[0], e[1]) for e in edges]
    axes = normals + [cross(e, f) for e in edges[0] for f in edges[1]]
    axes += [cross(n, e) for n, own in zip(normals, edges) for e in own]
    for axis in axes:
        first, second = ([sum(x * y for x, y in zip(axis, v)) for v in t] for t in (a, b))
        if max(first) < min(second) or max(second) < min(first):
            return True
    return False


class Integers(unittest.TestCase):
    """sepax_grid.h."""

    def test_exact(self):
        """All functions agree with fractions on small coordinates, where touching is common."""
        rng = np.random.default_rng(2)
        a, b = rng.integers(-3, 4, (2, 400, 3, 3))
        got = sepax.exact(a, b)
        want = np.array([not separated(p.tolist(), q.tolist()) for p, q in zip(a, b)])
        full = np.array([bool(np.cross(p[1] - p[0], p[2] - p[0]).any()) and
                         bool(np.cross(q[1] - q[0], q[2] - q[0]).any()) for p, q in zip(a, b)])
        np.testing.assert_array_equal(got.collision[full], want[full])
        np.testing.assert_array_equal(sepax.exact_collisions(a, b), got.collision)
        np.testing.assert_array_equal(sepax.triangles_collide(a, b).collision, got.collision)
        np.testing.assert_array_equal(sepax.triangles_collide(a, b).strict, got.strict)
        np.testing.assert_array_equal(sepax.triangles_collide(a, b).coplanar, got.coplanar)
        self.assertTrue(0.1 < got.collision.mean() < 0.9)
        self.assertTrue((got.axis[got.collision] == 0).all())
        length, _ = sepax.triangles_distance(a, b)
        np.testing.assert_array_equal(length == 0, got.collision)

    def test_large(self):
        """Every int32 is legal."""
        top = 2**31 - 1
        a = np.array([[[top, top, top], [-top - 1, top, top], [top, -top - 1, top]]])
        self.assertTrue(sepax.exact(a, a).coplanar[0] and sepax.exact(a, a).collision[0])

    def test_pairs(self):
        """The list of pairs is that of each pair by itself."""
        a, b = np.random.default_rng(5).integers(-9, 9, (2, 30, 3, 3))
        grid = itertools.product(range(30), range(30))
        want = [[i, j] for i, j in grid if sepax.exact(a[i], b[j]).collision[0]]
        self.assertEqual(sepax.exact_pairs(a, b).tolist(), want)
        self.assertEqual(sepax.exact_pairs(a[:0], b).shape, (0, 2))
        self.assertEqual(len(sepax.exact(a[:0], b[:0]).collision), 0)

    def test_grid(self):
        """A mesh on a grid is rounded once."""
        mesh = ball(200)
        grid = sepax.Grid.fit(mesh, cube(3.0), word=12)
        on_grid = grid.quantise(mesh)
        self.assertEqual((grid.word, on_grid.dtype, on_grid.shape), (12, np.int32,
                                                                     (len(mesh[1]), 3, 3)))
        want = (mesh[0][mesh[1]] - np.array(grid.offset)) / grid.resolution
        self.assertLessEqual(np.abs(want - on_grid).max(), 0.5 + 1e-9)
        with self.assertRaisesRegex(sepax.ArgumentError, "does not fit"):
            grid.quantise(cube(30.0))
        self.assertEqual(sepax.Grid.fit((CORNERS, FACES)).word, 18)


class Doubles(unittest.TestCase):
    """Triangles in poses."""

    def test_poses(self):
        """A pose for each pair, or one for all."""
        rng = np.random.default_rng(7)
        a, b = rng.normal(size=(2, 200, 3, 3))
        path = poses(200, 0.5)
        got = sepax.triangles_collide(a, b, path, path[0])
        one = [sepax.triangles_collide(p, q, pose, path[0]).collision[0]
               for p, q, pose in zip(a, b, path)]
        self.assertEqual(list(got.collision), one)
        length, points = sepax.triangles_distance(a, b, path, path[0])
        self.assertTrue(((length == 0) == got.collision).all())
        np.testing.assert_allclose(np.linalg.norm(points[:, 0] - points[:, 1], axis=1), length,
                                   atol=1e-12)


if __name__ == "__main__":
    unittest.main()
