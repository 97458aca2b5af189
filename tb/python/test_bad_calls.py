# SPDX-License-Identifier: MIT
"""More than 200 bad calls: each raises an exception whose text names the cure, and none crashes.

Run with the sanitizers of the compiler, too."""
import os
import tempfile
import unittest

import numpy as np
import sepax
from sepax import Joint
from sepax._library import core

from shapes import CORNERS, FACES, at, cube, poses

NAN, INF = float("nan"), float("inf")
# What is raised: never a crash, and never an error of Python's inside (KeyError, AttributeError).
KINDS = (ValueError, TypeError, OSError, MemoryError, BufferError, IndexError, sepax.SepaxError)


def changed(array, place, value):
    """A copy with another entry."""
    copy = np.array(array, float)
    copy[place] = value
    return copy


def body():
    """A small body."""
    return sepax.Body(CORNERS, FACES)


def bad_meshes():
    """(what is wrong, vertices, faces, a word of the text)."""
    big = np.zeros((4, 3), np.float128) if hasattr(np, "float128") else np.zeros((4, 3), "O")
    masked = np.ma.masked_less(CORNERS, 0.5)
    rows = [
        (CORNERS, None, "multiple|triangles; give faces"), (None, None, "numbers"),
        ("mesh.stl", None, "numbers"), (b"abc", FACES, "numbers"), ({}, FACES, "numbers|shape"),
        (CORNERS, "faces", "whole numbers"), (CORNERS, {}, "whole|shape"), (1.0, FACES, "shape"),
        ([], FACES, "shape"), ([[]], FACES, "shape"), (CORNERS[0], FACES, "shape"),
        (CORNERS[None], FACES, "shape"), (CORNERS[:, :2], FACES, "shape"),
        (np.zeros((4, 4)), FACES, "shape"), (CORNERS.T, FACES, "shape"),
        (CORNERS, FACES[0], "shape"), (CORNERS, FACES[:, :2], "shape"),
        (CORNERS, np.zeros((2, 4), int), "divide"), (CORNERS, FACES[None], "shape"),
        (CORNERS, FACES.astype(float), "whole numbers"), (CORNERS, FACES + 0.5, "whole"),
        (CORNERS, FACES.astype(bool), "whole"), (CORNERS, FACES.astype(complex), "whole"),
        (CORNERS.astype(complex), FACES, "numbers"), (CORNERS.astype("U"), FACES, "numbers"),
        (CORNERS.astype(object), FACES, "numbers"), (big, FACES, "float64|numbers"),
        (np.zeros((4, 3), "M8[s]"), FACES, "numbers"), (masked, FACES, "masked"),
        (CORNERS, FACES + 1, "beyond"), (CORNERS, FACES + 2**31, "beyond"),
        (CORNERS, FACES + 2**32, "indices are"), (CORNERS, FACES.astype(np.uint64) + 2**63,
                                                  "indices are"),
        (CORNERS, FACES - 1, "negative"), (CORNERS, (FACES - 1).astype(np.int8), "negative"),
        (CORNERS, (FACES - 2**31).astype(np.int32), "negative"),
        (CORNERS, FACES[:0], "triangles, not 0"), (CORNERS[:0], FACES, "beyond"),
        (CORNERS[:0], None, "triangles, not 0"), (CORNERS[:0], FACES[:0], "triangles, not 0"),
        (CORNERS[:2], None, "triangles; give faces"), (np.zeros((1, 3, 2)), None, "shape"),
        (np.full((4, 3), 2**60), FACES, "2\\*\\*53"), ([[0, 0, 0], [1, 1]], FACES, "numbers"),
        (CORNERS.tolist() + [["x", 0, 0]], FACES, "numbers"),
        ([[0, 0, None]] * 3, None, "numbers"),
    ]
    for value, word in ((NAN, "NaN|nan"), (INF, "inf"), (-INF, "inf"), (1e305, "2\\^1000")):
        rows += [(changed(CORNERS, (n, k), value), FACES, word)
                 for n, k in ((0, 0), (3, 2))]
    for value in (NAN, INF):
        rows.append((changed(CORNERS, (1, 1), value).astype(np.float32), FACES, "NaN|nan|inf"))
    return rows


def bad_poses():
    """(pose, a word of the text)."""
    eye = np.eye(4)
    rows = [(changed(eye, place, value), "") for place in ((0, 0), (1, 2), (0, 3), (3, 0), (3, 3))
            for value in (NAN, INF, -INF, 7.0, 1e308) if (place, value) != ((0, 3), 7.0) and
            (place, value) != ((0, 3), 1e308)]
    rows += [(m, "") for m in (
        np.zeros((4, 4)), 2 * eye, -eye, np.diag([1, 1, -1, 1.0]), np.diag([1, 1, 1, 0.0]),
        changed(eye, (0, 1), 1e-5), changed(eye, (2, 2), 1 + 1e-5), np.ones((4, 4)),
        at(1, 2, 3).T, np.full((4, 4), NAN), np.full((4, 4), 1e-320))]
    rows += [(m, "shape|numbers") for m in (
        np.eye(3), np.zeros(4), np.zeros(16), np.zeros((3, 4)), np.zeros((4, 3)), 1.0, "pose", {},
        [], [[]], np.zeros((2, 3, 4)), np.zeros((1, 1, 4, 4)), np.zeros((4, 4, 4, 4)),
        np.zeros((0, 4)), [eye, np.eye(3)], eye.astype(complex), eye.astype("U"),
        eye.astype(object))]
    return rows


class BadCalls(unittest.TestCase):
    """Each call is refused."""

    calls = 0

    def refuse(self, text, call, *arguments, **options):
        """The call raises one of KINDS, in one line that is not empty and has the text."""
        BadCalls.calls += 1
        about = f"{call} {arguments} {options}"
        try:
            result = call(*arguments, **options)
        except KINDS as error:
            said = str(error)
            self.assertTrue(said and "\n" not in said, about + repr(said))
            if text:
                self.assertRegex(said, text, about)
            return
        self.fail(f"{about} gave {result!r}")

    def test_meshes(self):
        """Bodies, meshes without trees, grids."""
        for vertices, faces, word in bad_meshes():
            self.refuse(word, sepax.Body, vertices, faces)
            if faces is not None and np.size(faces) > 0:
                self.refuse("", sepax.meshes_pairs, (vertices, faces), (CORNERS, FACES))
        for threads in (0, -1, 1.5, "2", True, 10**9):
            self.refuse("threads", sepax.Body, CORNERS, FACES, threads=threads)
        for mesh in (None, 3, "x", (CORNERS,), [CORNERS, FACES]):
            self.refuse("vertices|numbers", sepax.meshes_pairs, mesh, (CORNERS, FACES))
            self.refuse("", sepax.Body.from_trimesh, mesh)

    def test_poses(self):
        """Poses of all questions."""
        a, b = body(), body()
        for pose, word in bad_poses():
            self.refuse(word, sepax.collide, a, b, pose)
            self.refuse(word, sepax.distance, a, b, None, pose)
            self.refuse(word, sepax.near, a, b, 1.0, pose)
            if isinstance(pose, np.ndarray) and pose.shape == (4, 4) and pose.dtype == float:
                many = poses(100, 1)
                many[57] = np.asarray(pose, float)
                self.refuse("pose 57", sepax.collide, a, b, many)
                self.refuse("pose 57", sepax.within, a, b, None, many)
        self.refuse("3 poses and pose_b has 2", sepax.collide, a, b, poses(3, 1), poses(2, 1))
        self.refuse("one pose", sepax.pairs, a, b, poses(3, 1))
        self.refuse("0.01", sepax.nearest_poses, 2 * np.eye(4))
        self.refuse("None", sepax.nearest_poses, None)

    def test_first_bad_pose(self):
        """Of many bad poses the first is named, whatever threads do."""
        many = poses(5000, 1)
        many[[777, 1234, 4000], 0, 0] = 9
        for threads in (1, 2, 8):
            self.refuse("pose 777", sepax.collide, body(), body(), many, threads=threads)

    def test_arguments(self):
        """Numbers out of range, and things that are no bodies."""
        a = body()
        for other in (None, 3, "b", CORNERS, (CORNERS, FACES), a._handle, object()):
            for call in (sepax.collide, sepax.distance, sepax.within, sepax.pairs):
                self.refuse("Body", call, a, other)
                self.refuse("Body", call, other, a)
        for value in (NAN, -1, INF, "x", None, 1e305, [1, 2], 1j):
            self.refuse("distance", sepax.near, a, a, value)
            self.refuse("", sepax.pairs, a, a, distance=value)
        for name in ("relative", "absolute", "limit", "seconds"):
            for value in (NAN, -1, INF, "x"):
                self.refuse(name, sepax.distance, a, a, **{name: value})
        for value in (0, -1, 2.5, "3", True, 2**70):
            self.refuse("most", sepax.pairs, a, a, most=value)
            self.refuse("work", sepax.near, a, a, 1.0, work=value)
            self.refuse("threads", sepax.collide, a, a, threads=value)
        self.refuse("relative", sepax.distance, a, a, relative=1)

    def test_triangles(self):
        """Single triangles and grids."""
        one = CORNERS[FACES]
        for value in (None, 1, "x", one[0, 0], one[..., :2], one[None], one.astype(complex),
                      changed(one, (0, 0, 0), NAN), changed(one, (0, 0, 0), INF)):
            self.refuse("", sepax.triangles_collide, value, one)
            self.refuse("", sepax.triangles_distance, one, value)
            self.refuse("", sepax.exact, value, one.astype(int))
        self.refuse("as many", sepax.triangles_collide, one, one[:2])
        self.refuse("2\\*\\*1000", sepax.triangles_distance, one * 1e305, one)
        self.refuse("as many", sepax.triangles_collide, one, one, poses(3, 1))
        self.refuse("32 bits", sepax.exact, np.full((1, 3, 3), 2**31), np.zeros((1, 3, 3), int))
        self.refuse("as many", sepax.exact_collisions, np.zeros((2, 3, 3), int),
                    np.zeros((1, 3, 3), int))
        for word in (0, 3, 33, -1, 1.5, "18", 2**40):
            self.refuse("", sepax.Grid.fit, (CORNERS, FACES), word=word)
        self.refuse("", sepax.Grid(NAN, (0, 0, 0), 18).quantise, (CORNERS, FACES))
        self.refuse("", sepax.Grid(-1.0, (0, 0, 0), 18).quantise, (CORNERS, FACES))
        self.refuse("", sepax.Grid(1e-9, (0, 0, 0), 18).quantise, (CORNERS, FACES))
        self.refuse("", sepax.Grid.fit, (np.zeros((3, 3)), [[0, 1, 2]]))

    def test_files(self):
        """Files that are not there or damaged."""
        with tempfile.TemporaryDirectory() as folder:
            for name in ("", "none.stl", ".", "\0", 3.5, None, b"\0"):
                path = os.path.join(folder, name) if isinstance(name, str) else name
                self.refuse("", sepax.Body.load, path)
                self.refuse("", sepax.read_poses, path)
            texts = (b"", b"x", b"solid\n", b"\0" * 90, b"ply\n", b"v 1\n", b"PK")
            for n, text in enumerate(texts):
                path = os.path.join(folder, f"{n}.bin")
                with open(path, "wb") as file:
                    file.write(text)
                self.refuse("bin", sepax.Body.load, path)
            for value in (NAN, -1, 0, "x", 1e13):
                self.refuse("unit_mm", sepax.Body.load, path, unit_mm=value)
            self.refuse("", sepax.write_stl, os.path.join(folder, "no", "x.stl"), CORNERS[FACES])
            self.refuse("", sepax.write_stl, os.path.join(folder, "x.stl"), CORNERS[FACES][:0])
            self.refuse("", sepax.write_stl, os.path.join(folder, "x.stl"), 1e300 * CORNERS[FACES])
            self.assertEqual([f for f in os.listdir(folder) if f.endswith("stl")], [])
        for length in (NAN, -1, INF, "x", 9.0):
            self.refuse("", sepax.weld, CORNERS[FACES], length)

    def test_mechanisms(self):
        """Links, joints and rows of values."""
        joint = Joint("j", "revolute", "a", "b")
        m = sepax.Mechanism(["a", "b"], [joint], bodies={"a": body(), "b": body()},
                            pairs=[("a", "b")])
        for change in ({"kind": "ball"}, {"kind": 3}, {"parent": "x"}, {"child": "a"},
                       {"axis": (0, 0, 0)}, {"axis": (1, 0)}, {"axis": (NAN, 0, 0)},
                       {"axis": "z"}, {"lower": 2, "upper": 1}, {"lower": NAN}, {"mimic": "j"},
                       {"mimic": "k"}, {"factor": NAN}, {"origin": np.eye(3)}, {"name": 3},
                       {"origin": 2 * np.eye(4)}, {"name": ""}, {"name": "a\0b"},
                       {"origin": poses(2, 1)}):
            self.refuse("", sepax.Mechanism, ["a", "b"], [joint._replace(**change)])
        for links, joints in (([], []), (["a", "b"], []), (["a"], [joint]), (["a", "a"], [joint]),
                              (["a", "b"], [joint, joint]), ([3], []), (["a", "b"], ["j"]),
                              (["a", "b"], [None]), ("ab", 3), (["a", "b", "c"], [
                                  joint, joint._replace(name="k", parent="b", child="a")])):
            self.refuse("", sepax.Mechanism, links, joints)
        for more in ({"bodies": {"x": body()}}, {"bodies": {"a": CORNERS}}, {"pairs": [("a", "b")]},
                     {"bodies": {"a": body()}, "pairs": [("a", "a")]},
                     {"bodies": {"a": body()}, "pairs": [("a", "b")]}):
            self.refuse("", sepax.Mechanism, ["a", "b"], [joint], **more)
        for values in (None, "x", 1.0, [[1, 2]], [[]], [[NAN]], [[INF]], [[1e13]], [[[1]]], [[1j]],
                       {"x": 1}, {}, {"j": 1, "k": 2}, {"j": [[1.0]]}, {"j": "x"}, [[True], ["x"]]):
            self.refuse("", m.check, values)
            self.refuse("", m.poses, values)
        for name, values in (("clearance", (NAN, -1, "x", 1e305)), ("work", (0, 1.5)),
                             ("threads", (0, "1")), ("relative", (1, -1, NAN)),
                             ("travel", ([-1], [NAN], [1, 2], "x", [[1], [2]]))):
            for value in values:
                self.refuse("", m.check, [[0.0]], **{name: value})
        for name in ("none.urdf", 3, None, "\0"):
            self.refuse("", sepax.Mechanism.from_urdf, name)
        self.refuse("dict", sepax.Mechanism.from_urdf, "none.urdf", packages=[1])

    def test_manager(self):
        """Managers."""
        m = sepax.CollisionManager()
        for mesh in (None, 3, CORNERS, "x", object()):
            self.refuse("", m.add_object, "a", mesh)
            self.refuse("", m.in_collision_single, mesh)
        m.add_object("a", body())
        for pose, _ in bad_poses():
            self.refuse("", m.set_transform, "a", pose)
            self.refuse("", m.add_object, "b", body(), pose)
        self.refuse("not in", m.remove_object, "b")
        self.assertFalse(m.in_collision_internal())
        self.assertEqual(m.min_distance_single(body(), at(3)), 2.0)

    def test_core(self):
        """The compiled functions, called past the Python code, leave no array."""
        a = body()._handle
        eye = np.eye(4)
        codes = np.zeros(4, np.uint8)
        for arguments in (
                (), (1,), (a, a), (a, a, None, None, eye, eye, -1, 1, codes, False),
                (a, a, None, None, eye, eye, 5, 1, codes, False),
                (a, a, None, None, eye[:3], None, 1, 1, codes[:1], False),
                (a, a, None, None, np.zeros((3, 4, 4)), None, 4, 1, codes, False),
                (a, a, None, None, eye.T[::2], None, 1, 1, codes[:1], False),
                (a, a, None, None, None, None, 4, -1, codes, False),
                (a, a, None, None, None, None, 4, 1, None, False),
                (a, a, None, None, None, None, 4, 1, bytes(4), False),
                (a, a, a, None, None, None, 4, 1, codes, False),
                (a, a, core.shell_new(a), None, None, None, 4, 1, codes, False),
                (a, None, None, None, None, None, 4, 1, codes, False),
                (object(), a, None, None, None, None, 4, 1, codes, False),
                (a, a, None, None, None, None, 2**62, 1, codes, False)):
            self.refuse("", core.collide, *arguments)
        for call in (core.body_new, core.near, core.distance, core.within, core.bodies_pairs,
                     core.meshes_pairs, core.triangle_pairs, core.grid_fit, core.grid_quantise,
                     core.grid_exact, core.grid_exact_bits, core.grid_colliding, core.mesh_read,
                     core.stl_write, core.weld, core.poses_read, core.mechanism_new,
                     core.mechanism_poses, core.machine_new, core.machine_ask, core.robot_read,
                     core.robot_shape, core.robot_pairs):
            for arguments in ((), (None,), (a, a, a), (None,) * 9, (1,) * 10):
                self.refuse("", call, *arguments)
        for call in (core.body_triangles, core.shell_new, core.shell_about, core.mechanism_about,
                     core.robot_about, core.poses_check, core.poses_nearest, core.distinct):
            for argument in (3, "x", object(), eye[:, ::2]):
                self.refuse("", call, argument)
        self.refuse("", core.body_new, CORNERS, FACES.astype(np.uint32).ravel()[:4], 0)
        self.refuse("", core.triangle_pairs, np.zeros((2, 3, 3)), np.zeros((1, 3, 3)), None, None,
                    1, np.zeros((2, 4), np.uint8), None, None)
        self.refuse("", core.triangle_pairs, np.zeros((2, 3, 3)), np.zeros((2, 3, 3)), None, None,
                    1, None, np.zeros(2), None)

    @classmethod
    def tearDownClass(cls):
        print(f"{cls.calls} bad calls")
        assert cls.calls > 200, cls.calls


if __name__ == "__main__":
    unittest.main()
