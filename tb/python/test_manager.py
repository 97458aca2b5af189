# SPDX-License-Identifier: MIT
"""CollisionManager: trimesh's interface; pairs left out; containment."""
import unittest
import warnings

import numpy as np
import sepax

from shapes import at, ball, cube, poses


class Mesh:
    """Like trimesh.Trimesh."""

    def __init__(self, vertices, faces):
        self.vertices, self.faces = np.asarray(vertices, float), np.asarray(faces)

    def __hash__(self):
        return hash((self.vertices.tobytes(), self.faces.tobytes()))

    def __eq__(self, other):
        return self is other


class Manager(unittest.TestCase):
    """Each method, beside questions about two bodies."""

    def setUp(self):
        self.cube = Mesh(*cube())
        self.manager = sepax.CollisionManager()
        self.manager.add_object("a", self.cube)
        self.manager.add_object("b", self.cube, at(5))

    def test_objects(self):
        """Objects are added, replaced, moved and removed."""
        m = self.manager
        self.assertIs(m.in_collision_internal(), False)
        m.add_object("c", self.cube, at(5.5))
        self.assertEqual(m.in_collision_internal(return_names=True), (True, {("b", "c")}))
        m.set_transform("c", at(0.5))
        self.assertEqual(m.in_collision_internal(return_names=True), (True, {("a", "c")}))
        m.add_object("c", Mesh(*cube(0.1)), at(50))
        self.assertFalse(m.in_collision_internal())
        m.remove_object("c")
        for call in (lambda: m.remove_object("c"), lambda: m.set_transform("c", np.eye(4)),
                     lambda: m.min_distance_internal("c")):
            with self.assertRaisesRegex(ValueError, "c not in collision manager"):
                call()

    def test_single(self):
        """One mesh beside those of the manager."""
        hit, names, contacts = self.manager.in_collision_single(
            self.cube, at(5.25, 0.25), return_names=True, return_data=True)
        self.assertEqual((hit, names), (True, {"b"}))
        self.assertGreater(len(contacts), 3)
        for contact in contacts:
            self.assertEqual(contact.names, {"b", "__external"})
            self.assertTrue(0 <= contact.index("b") < 12 and 0 <= contact.index("__external") < 12)
            self.assertLessEqual(abs(contact.point - [5, 0, 0]).max(), 0.5 + 1e-12)
            self.assertLessEqual(abs(contact.point - [5.25, 0.25, 0]).max(), 0.5 + 1e-12)
            self.assertAlmostEqual(np.linalg.norm(contact.normal), 1)
            with self.assertRaisesRegex(NotImplementedError, "FCL"):
                contact.depth  # pylint: disable=pointless-statement
        self.assertEqual(self.manager.in_collision_single(self.cube, at(2), True, True),
                         (False, set(), []))

    def test_other(self):
        """Two managers."""
        other = sepax.CollisionManager()
        self.assertFalse(self.manager.in_collision_other(other))
        self.assertEqual(self.manager.min_distance_other(other), np.inf)
        other.add_object("x", self.cube, at(0, 0, 0.75))
        self.assertEqual(self.manager.in_collision_other(other, True), (True, {("a", "x")}))
        self.assertEqual(other.in_collision_other(self.manager, True), (True, {("x", "a")}))
        self.assertEqual(self.manager.min_distance_other(other, True), (0.0, ("a", "x")))
        with self.assertRaises(TypeError):
            self.manager.in_collision_other(3)

    def test_distances(self):
        """The least of all distances, with names and points."""
        m = self.manager
        self.assertEqual(m.min_distance_internal(return_names=True), (4.0, ("a", "b")))
        m.add_object("c", self.cube, at(2))
        d, names, data = m.min_distance_internal(return_names=True, return_data=True)
        self.assertEqual((d, names, data.distance), (1.0, ("a", "c"), 1.0))
        self.assertAlmostEqual(np.linalg.norm(data.point("a") - data.point("c")), 1)
        self.assertTrue(data.least <= 1 <= data.most and 0 <= data.index("c") < 12)
        self.assertEqual(m.min_distance_internal("b", return_names=True), (2.0, ("b", "c")))
        self.assertEqual(m.min_distance_single(self.cube, at(8), True), (2.0, "b"))
        self.assertEqual(sepax.CollisionManager().min_distance_single(self.cube, None, True, True),
                         (np.inf, None, None))

    def test_ignored(self):
        """Pairs that are left out."""
        m = self.manager
        m.add_object("c", self.cube, at(0.5))
        m.set_pair_ignored("c", "a")
        self.assertEqual(m.ignored_pairs, {("a", "c")})
        self.assertTrue(m.is_pair_ignored("a", "c"))
        self.assertEqual(m.in_collision_internal(True, True), (False, set(), []))
        self.assertEqual(m.min_distance_internal(return_names=True), (3.5, ("b", "c")))
        self.assertEqual(m.min_distance_internal("a"), 4.0)
        m.set_pair_ignored("a", "c", ignored=False)
        self.assertTrue(m.in_collision_internal())
        m.set_pair_ignored("a", "c")
        m.clear_ignored_pairs()
        self.assertTrue(m.in_collision_internal())
        with self.assertRaises(ValueError):
            m.set_pair_ignored("a", "a")

    def test_contained(self):
        """An object that is wholly inside another one, and one that may be."""
        for surfaces in (False, True):
            m = sepax.CollisionManager(surfaces=surfaces)
            m.add_object("big", Mesh(*cube(4)))
            m.add_object("small", self.cube)
            want = (True, {("big", "small")}, []) if not surfaces else (False, set(), [])
            self.assertEqual(m.in_collision_internal(True, True), want)
            self.assertEqual(m.min_distance_internal(), 0.0 if not surfaces else 1.5)
            self.assertEqual(m.in_collision_single(Mesh(*cube(9)), at(0.1), True),
                             (not surfaces, set() if surfaces else {"big", "small"}))
        points, faces = cube(4)
        m = sepax.CollisionManager()
        m.add_object("open", Mesh(points, faces[1:]))
        m.add_object("small", self.cube)
        with self.assertWarnsRegex(sepax.UndecidedWarning, "weld"):
            self.assertFalse(m.in_collision_internal())
        self.assertEqual(m.undecided, [("open", "small")])
        m.set_transform("small", at(9))
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            self.assertFalse(m.in_collision_internal())
        self.assertEqual(m.undecided, [])

    def test_many(self):
        """The boxes leave no pair out: 150 objects beside all pairs."""
        meshes = [Mesh(*ball(60, 0.3, n)) for n in range(5)]
        places = poses(150, 2.0, 8)
        m = sepax.CollisionManager()
        bodies = []
        for n, place in enumerate(places):
            bodies.append(m.add_object(n, meshes[n % 5], place))
        self.assertEqual(len({id(b) for b in bodies}), 5)
        want = {(i, j) for i in range(150) for j in range(i + 1, 150)
                if sepax.collide(bodies[i], bodies[j], places[i], places[j])}
        self.assertEqual(m.in_collision_internal(return_names=True)[1], want)
        self.assertGreater(len(want), 20)
        hit, names = m.in_collision_single(meshes[0], at(0.2), return_names=True)
        self.assertEqual(names, {i for i in range(150)
                                 if sepax.collide(bodies[i], bodies[0], places[i], at(0.2))})
        self.assertTrue(hit)
        d, name = m.min_distance_single(meshes[1], at(2.6, 2.6, 2.6), return_name=True)
        each = [sepax.distance(b, bodies[1], p, at(2.6, 2.6, 2.6)).value
                for b, p in zip(bodies, places)]
        self.assertEqual((d, name), (min(each), int(np.argmin(each))))

    def test_changed_mesh(self):
        """A mesh that changed is not taken for what it was."""
        mesh = Mesh(*cube())
        m = sepax.CollisionManager()
        m.add_object("a", mesh)
        mesh.vertices = mesh.vertices * 8
        m.add_object("b", mesh, at(4.6))
        self.assertFalse(m.in_collision_internal())
        self.assertEqual(round(m.min_distance_internal(), 9), 0.1)

    def test_bodies(self):
        """Bodies that were made before are taken as they are."""
        body = sepax.Body(*cube())
        m = sepax.CollisionManager()
        self.assertIs(m.add_object("a", body), body)
        m.add_object("b", body, at(0.5))
        hit, contacts = m.in_collision_internal(return_data=True)
        self.assertTrue(hit and contacts[0].index("a") >= 0)
        with self.assertRaisesRegex(ValueError, "add the mesh"):
            contacts[0].point  # pylint: disable=pointless-statement


if __name__ == "__main__":
    unittest.main()
