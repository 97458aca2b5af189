# SPDX-License-Identifier: MIT
"""Two bodies in many poses, against each pair of triangles by itself and against single calls."""
import pickle
import unittest

import numpy as np
import sepax
from sepax import Code, Inside

from shapes import CORNERS, CUBE_FACES, FACES, at, ball, cube, poses

COUNT = 300


def all_pairs(a, b):
    """Every triangle of A beside every one of B, each (n, 3, 3)."""
    first, second = a[0][a[1]], b[0][b[1]]
    return (np.repeat(first, len(second), axis=0), np.tile(second, (len(first), 1, 1)),
            len(second))


class Collisions(unittest.TestCase):
    """Verdicts, distances and pairs."""

    def setUp(self):
        self.mesh = [ball(60, 1.0, 1), cube(1.2)]
        self.a, self.b = (sepax.Body(*mesh) for mesh in self.mesh)
        self.poses = poses(COUNT, 2.5, 3)

    def test_against_each_pair(self):
        """Surfaces collide in a pose if and only if some pair of triangles does."""
        first, second, columns = all_pairs(*self.mesh)
        found = sepax.collide(self.a, self.b, None, self.poses, surfaces=True)
        hits = 0
        for n, pose in enumerate(self.poses[:60]):
            each = sepax.triangles_collide(first, second, None, pose).collision
            want = {(int(k) // columns, int(k) % columns) for k in np.nonzero(each)[0]}
            got = sepax.pairs(self.a, self.b, None, pose)
            self.assertTrue(got.complete)
            self.assertEqual({tuple(map(int, row)) for row in got.triangles}, want)
            self.assertEqual(bool(found.collides[n]), bool(want))
            hits += bool(want)
        self.assertTrue(10 < hits < 50, hits)

    def test_distances_of_each_pair(self):
        """A distance is the least of all pairs of triangles."""
        first, second, _ = all_pairs(*self.mesh)
        all_of = sepax.distance(self.a, self.b, None, self.poses[:30])
        self.assertEqual(len(all_of), 30)
        for n, pose in enumerate(self.poses[:30]):
            each, points = sepax.triangles_distance(first, second, None, pose)
            one = sepax.distance(self.a, self.b, None, pose)
            self.assertEqual(one.value, each.min())
            self.assertEqual(all_of[n].value, each.min())
            self.assertTrue(one.least <= one.value <= one.most and one.decided)
            self.assertAlmostEqual(np.linalg.norm(one.points[0] - one.points[1]), one.value, 12)
            self.assertEqual(float(one), one.value)
            self.assertEqual(points.shape, (len(first), 2, 3))

    def test_many_as_single(self):
        """N poses in one call give what N calls give, for any number of threads."""
        many = sepax.collide(self.a, self.b, self.poses)
        single = [sepax.collide(self.a, self.b, pose).code for pose in self.poses]
        self.assertEqual(list(many.codes), single)
        for threads in (1, 2, 7):
            again = sepax.collide(self.a, self.b, self.poses, threads=threads)
            self.assertTrue((again.codes == many.codes).all())
            apart = sepax.distance(self.a, self.b, self.poses, threads=threads)
            first = sepax.distance(self.a, self.b, self.poses, threads=1)
            for field in ("least", "value", "most", "points", "triangles"):
                np.testing.assert_array_equal(getattr(apart, field), getattr(first, field))
        self.assertEqual([v.code for v in many], single)
        self.assertEqual(len(many), COUNT)

    def test_both_move(self):
        """Poses of both bodies: n and n, n and one, one and n."""
        other = poses(COUNT, 1, 9)
        both = sepax.collide(self.a, self.b, self.poses, other)
        self.assertEqual(list(both.codes), [sepax.collide(self.a, self.b, p, q).code
                                            for p, q in zip(self.poses, other)])
        for one, many in ((self.poses[0], other), (other, self.poses[0])):
            self.assertEqual(len(sepax.collide(self.a, self.b, one, many)), COUNT)

    def test_near(self):
        """Near is a distance of at most so much; `least` is a bound below it."""
        d = sepax.distance(self.a, self.b, self.poses)
        for limit in (0.0, 0.1, 0.7):
            near = sepax.near(self.a, self.b, limit, self.poses, surfaces=True)
            self.assertTrue((near.collides == (d.value <= limit)).all())
            self.assertTrue((near.least <= d.most).all())
            self.assertTrue((near.least[near.free] >= limit).all())
            self.assertTrue((near.triangles[near.free] == -1).all())
            self.assertTrue((near.triangles[near.collides] >= 0).all())
            self.assertEqual(near.basis.distance, limit)
        self.assertEqual(near[0].code, near.codes[0])
        undecided = sepax.near(self.a, self.b, 0.01, self.poses, work=1)
        self.assertFalse(undecided.decided.all())

    def test_inside(self):
        """A body that is wholly inside another one collides, unless surfaces alone are asked."""
        big, small = sepax.Body(*cube(4.0)), sepax.Body(*cube(1.0))
        path = np.array([at(x) for x in (0, 1, 1.5, 2, 2.5, 2.6)])
        got = sepax.collide(small, big, path)
        self.assertEqual(list(got.codes), [Code.A_INSIDE, Code.A_INSIDE, Code.COLLIDES,
                                           Code.COLLIDES, Code.COLLIDES, Code.FREE])
        self.assertEqual(list(sepax.collide(big, small, None, path).codes)[:2], [Code.B_INSIDE] * 2)
        self.assertEqual(list(sepax.collide(small, big, path, surfaces=True).codes)[:2],
                         [Code.FREE] * 2)
        self.assertTrue(got.inside[0] and got[0].inside and got[0].collides)
        self.assertEqual(sepax.distance(small, big).value, 1.5)
        self.assertEqual(sepax.near(small, big, 0.1).code, Code.A_INSIDE)
        within = sepax.within(small, big, path[:2])
        self.assertTrue((within.a_in_b == Inside.INSIDE).all())
        self.assertEqual(sepax.within(small, big), (Inside.INSIDE, Inside.OUTSIDE))

    def test_undecided(self):
        """An open body has no inside; the verdict is then neither yes nor no."""
        points, faces = cube(4.0)
        open_ = sepax.Body(points, faces[1:])
        shell = open_.shell()
        self.assertFalse(shell.closed or open_.closed)
        self.assertEqual(shell.edge.shape, (2, 3))
        v = sepax.collide(sepax.Body(*cube(1.0)), open_)
        self.assertEqual(v.code, Code.UNDECIDED)
        self.assertFalse(v.decided)
        for use in (bool, lambda x: x.collides):
            with self.assertRaisesRegex(sepax.UndecidedError, "close the surface"):
                use(v)
        many = sepax.collide(sepax.Body(*cube(1.0)), open_, np.array([np.eye(4)] * 2))
        self.assertFalse(many.decided.any() or many.collides.any() or many.free.any())
        with self.assertRaises(sepax.UndecidedError):
            many.any()
        with self.assertRaises(TypeError):
            bool(many)

    def test_touching(self):
        """Touching is a collision, and none that passes through."""
        a, b = sepax.Body(*cube()), sepax.Body(*cube(1.0, (1, 0, 0)))
        self.assertTrue(sepax.collide(a, b))
        self.assertFalse(sepax.collide(a, b, strict=True))
        self.assertEqual(sepax.distance(a, b).value, 0)
        self.assertFalse(sepax.collide(a, b, None, at(np.spacing(1.0))))

    def test_limits(self):
        """Limits of pairs and distances."""
        got = sepax.pairs(self.a, self.b, most=3)
        self.assertEqual((got.triangles.shape, got.complete), ((3, 2), False))
        far = sepax.distance(self.a, self.b, at(9), limit=1.0)
        self.assertEqual((far.most, far.value, far.least), (np.inf, np.inf, 1.0))
        self.assertTrue(np.isnan(far.points).all() and (far.triangles == -1).all())
        some = sepax.distance(self.a, self.b, self.poses, relative=0.1)
        exact = sepax.distance(self.a, self.b, self.poses)
        self.assertTrue(((some.least <= exact.most) & (some.most >= exact.least)).all())
        self.assertFalse(sepax.distance(self.a, self.b, at(3, 1, 1), work=1).decided)
        self.assertEqual(len(sepax.pairs(self.a, self.b, at(3), distance=5).triangles),
                         len(self.a) * len(self.b))

    def test_none(self):
        """No poses give no verdicts."""
        none = np.empty((0, 4, 4))
        self.assertEqual(len(sepax.collide(self.a, self.b, none)), 0)
        self.assertFalse(sepax.collide(self.a, self.b, none).any())
        self.assertEqual(len(sepax.distance(self.a, self.b, none)), 0)


class Meshes(unittest.TestCase):
    """Arrays of every kind give the same body."""

    def same(self, body):
        """The body is that of the corners."""
        d = sepax.distance(body, sepax.Body(CORNERS, FACES), at(3))
        self.assertEqual((len(body), d.value), (4, 2.0))

    def test_types(self):
        """Types of faces and vertices, orders, strides, byte orders."""
        for kind in (np.int8, np.uint8, np.int16, np.uint16, np.int32, np.uint32, np.int64,
                     np.uint64):
            self.same(sepax.Body(CORNERS, FACES.astype(kind)))
        for kind in (np.float16, np.float32, np.float64, ">f8", "<f4", ">f4", np.int8, np.int64):
            self.same(sepax.Body(CORNERS.astype(kind), FACES))
        self.same(sepax.Body(CORNERS.tolist(), FACES.tolist()))
        self.same(sepax.Body(np.asfortranarray(CORNERS), np.asfortranarray(FACES)))
        wide = np.full((8, 5), np.nan)
        wide[::2, 1:4] = CORNERS
        self.same(sepax.Body(wide[::2, 1:4], FACES))
        self.same(sepax.Body(CORNERS[::-1].copy()[::-1], FACES))
        self.same(sepax.Body(CORNERS[FACES]))
        self.same(sepax.Body(CORNERS[FACES].reshape(-1, 3)))
        unaligned = np.frombuffer(b"x" + CORNERS.tobytes(), np.uint8)[1:].view(np.float64)
        self.same(sepax.Body(unaligned.reshape(4, 3), FACES))
        frozen = CORNERS.copy()
        frozen.flags.writeable = False
        self.same(sepax.Body(frozen, FACES))

    def test_float32_is_exact(self):
        """Coordinates of float32 are not changed on the way."""
        points, faces = ball(100, 1.0, 5)
        single = points.astype(np.float32)
        a, b = sepax.Body(single, faces), sepax.Body(single.astype(float), faces)
        other = sepax.Body(*cube(0.5))
        path = poses(50, 3)
        np.testing.assert_array_equal(sepax.distance(a, other, path).value,
                                      sepax.distance(b, other, path).value)
        self.assertEqual(a.coordinates, "float32")
        self.assertIn("float32", str(sepax.collide(a, b).basis))

    def test_no_copy(self):
        """Arrays of the right kind reach the library where they are."""
        from sepax import _arrays
        points, index = CORNERS.copy(), FACES.astype(np.uint32)
        self.assertIs(_arrays.vertices_of(points), points)
        self.assertTrue(np.shares_memory(_arrays.faces_of(index, 4), index))
        path = poses(4, 1)
        self.assertIs(_arrays.poses_of(path, "p")[0], path)
        wide = np.zeros((4, 5))
        self.assertTrue(np.shares_memory(_arrays.vertices_of(wide[:, 1:4]), wide))

    def test_body_keeps_its_mesh(self):
        """A body does not change with the array that it was made of."""
        points = CORNERS.copy()
        body = sepax.Body(points, FACES)
        points[:] = np.nan
        self.same(body)

    def test_box_and_words(self):
        """The box is that of the triangles, not of vertices that none uses."""
        points = np.vstack([CORNERS, [[9, 9, 9]]])
        body = sepax.Body(points, FACES)
        np.testing.assert_array_equal(body.box, [[0, 0, 0], [1, 1, 1]])
        self.assertIn("4 triangles", repr(body))
        with self.assertRaisesRegex(TypeError, "pickled"):
            pickle.dumps(body)

    def test_duck(self):
        """An object with vertices and faces is a mesh."""
        class Mesh:  # pylint: disable=too-few-public-methods
            """Like trimesh.Trimesh."""
            vertices, faces = cube()
        self.assertEqual(len(sepax.Body(Mesh())), 12)
        self.assertEqual(len(sepax.Body.from_trimesh(Mesh())), 12)
        self.assertEqual(len(sepax.meshes_pairs(Mesh(), (cube(1.0, (1, 0, 0))[0], CUBE_FACES),
                                                first=True)), 1)

    def test_meshes_pairs(self):
        """The pairs without trees are those of bodies."""
        a, b = ball(200, 1.0, 2), ball(200, 1.0, 3)
        pose = at(0.4, 0.3)
        want = sepax.pairs(sepax.Body(*a), sepax.Body(*b), pose).triangles
        got = sepax.meshes_pairs(a, b, pose)
        self.assertEqual({tuple(p) for p in want.tolist()}, {tuple(p) for p in got.tolist()})
        self.assertGreater(len(got), 10)


if __name__ == "__main__":
    unittest.main()
