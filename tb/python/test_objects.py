# SPDX-License-Identifier: MIT
"""Objects as Python expects them: parts of results, copies, pickles, processes, memory layouts."""
import copy
import multiprocessing
import os
import pickle
import tempfile
import unittest

import numpy as np
import sepax
from sepax import Joint

from shapes import CORNERS, FACES, at, ball, cube, poses

COUNT = 40


def bodies():
    """A ball and a cube."""
    return sepax.Body(*ball(60, 1.0, 1)), sepax.Body(*cube(1.2))


def slide():
    """A cube that slides past another."""
    return sepax.Mechanism(
        ["a", "b"], [Joint("x", "prismatic", "a", "b", axis=(1, 0, 0))], pairs=[("a", "b")],
        bodies={"a": sepax.Body(*cube()), "b": sepax.Body(*cube())})


def results():
    """One of each kind of result for many poses."""
    a, b = bodies()
    path = poses(COUNT, 2.5, 3)
    values = np.linspace(0, 3, COUNT)[:, None]
    return [sepax.collide(a, b, path), sepax.near(a, b, 0.3, path), sepax.distance(a, b, path),
            slide().check(values, measure=True), slide().check(values)]


def fields(result):
    """The arrays of a result."""
    names = {name for kind in type(result).__mro__ for name in getattr(kind, "__slots__", ())}
    return {name: getattr(result, name) for name in sorted(names)
            if isinstance(getattr(result, name), np.ndarray)}


def ask_in_child(connection, a, b, path):
    """What a process that was forked finds."""
    connection.send(sepax.collide(a, b, path, threads=3).codes.tolist())


class Results(unittest.TestCase):
    """Results for many poses are sequences."""

    def test_parts(self):
        """A slice, a mask and a list of numbers give a result of the same kind."""
        for result in results():
            mask = np.arange(COUNT) % 3 == 0
            for part in (slice(2, 9), slice(None, None, -1), mask, [5, 1], np.array([7])):
                some = result[part]
                self.assertIs(type(some), type(result))
                self.assertTrue(fields(some))
                for name, array in fields(some).items():
                    np.testing.assert_array_equal(array, fields(result)[name][part])
                self.assertEqual(some.basis, result.basis)

    def test_items(self):
        """Iteration gives what an index gives."""
        for result in results():
            each = list(result)
            self.assertEqual(len(each), COUNT)
            for n in (0, 7, np.int64(7), -1):
                self.assertIs(type(each[n]), type(result[n]))
                self.assertEqual(repr(each[n]), repr(result[n]))
            for wrong in (COUNT, -COUNT - 1, "a", 1.5):
                with self.assertRaises(IndexError):
                    result[wrong]  # pylint: disable=pointless-statement
        near = results()[1]
        self.assertEqual([x.least for x in near], near.least.tolist())

    def test_one_is_no_list(self):
        """The distance in one pose has no items, and that in many is no number."""
        one = sepax.distance(*bodies())
        for call in (list, len, lambda d: d[0]):
            with self.assertRaisesRegex(TypeError, "one pose; use .value"):
                call(one)
        with self.assertRaisesRegex(TypeError, "40 poses; use .value"):
            float(results()[2])


class Copies(unittest.TestCase):
    """What is copied, pickled, or shared with another process."""

    def test_results(self):
        """Results are copied and pickled."""
        for result in results():
            for other in (copy.copy(result), copy.deepcopy(result),
                          pickle.loads(pickle.dumps(result))):
                self.assertIs(type(other), type(result))
                for name, array in fields(result).items():
                    np.testing.assert_array_equal(fields(other)[name], array)

    def test_bodies(self):
        """Bodies and mechanisms never change, so a copy is the same; a pickle is refused."""
        for thing, cure in ((bodies()[0], "make it anew"), (slide(), "read its URDF")):
            self.assertIs(copy.copy(thing), thing)
            self.assertIs(copy.deepcopy([thing])[0], thing)
            with self.assertRaisesRegex(TypeError, cure):
                pickle.dumps(thing)

    def test_manager(self):
        """To move an object of a copy does not move that of the manager."""
        manager = sepax.CollisionManager()
        a, b = bodies()
        manager.add_object("a", a)
        manager.add_object("b", b, at(9))
        manager.set_pair_ignored("a", "c")
        for other in (copy.copy(manager), copy.deepcopy(manager)):
            other.set_transform("b", np.eye(4))
            other.clear_ignored_pairs()
            other.remove_object("a")
            self.assertEqual(repr(other), "<CollisionManager of 1 objects, 0 pairs ignored>")
        self.assertEqual(repr(manager), "<CollisionManager of 2 objects, 1 pairs ignored>")
        self.assertFalse(manager.in_collision_internal())

    @unittest.skipUnless(hasattr(os, "fork"), "no fork here")
    def test_fork(self):
        """A process that was forked uses the bodies, with threads, after threads of its parent."""
        a, b = bodies()
        path = poses(400, 2.5, 3)
        want = sepax.collide(a, b, path, threads=3).codes.tolist()
        context = multiprocessing.get_context("fork")
        here, there = context.Pipe()
        child = context.Process(target=ask_in_child, args=(there, a, b, path))
        child.start()
        self.assertTrue(here.poll(60))
        self.assertEqual(here.recv(), want)
        child.join()
        self.assertEqual(child.exitcode, 0)


class Layouts(unittest.TestCase):
    """Arrays of all layouts in memory give the same verdicts."""

    def test_meshes(self):
        """Byte orders, steps, unaligned and read-only memory."""
        wide = np.zeros((4, 6))
        wide[:, ::2] = CORNERS
        unaligned = np.frombuffer(b"\0" + np.array(CORNERS, float).tobytes(),
                                  np.uint8)[1:].view(float).reshape(4, 3)
        self.assertFalse(unaligned.flags.aligned)
        frozen = np.array(CORNERS, float)
        frozen.setflags(write=False)
        other = sepax.Body(CORNERS, FACES)
        for vertices in (np.array(CORNERS, ">f8"), np.array(CORNERS, ">f4"), wide[:, ::2],
                         wide[::-1][::-1][:, ::2], np.asfortranarray(CORNERS), unaligned, frozen):
            kind = "float32" if vertices.dtype.itemsize == 4 else "float64"
            for faces in (FACES, np.array(FACES, ">u4"), np.array(FACES, np.int8),
                          np.asfortranarray(FACES)):
                body = sepax.Body(vertices, faces)
                self.assertEqual(body.coordinates, kind)
                self.assertEqual(sepax.distance(body, other, at(3)).value, 2.0)

    def test_poses(self):
        """Poses likewise, also one that is broadcast."""
        a, b = bodies()
        path = np.round(poses(COUNT, 2.5, 3), 12)
        path[:, :3, :3] = np.eye(3)
        path[:, :3, 3] = path[:, :3, 3].astype(np.float32)
        want = sepax.collide(a, b, path).codes.tolist()
        frozen = path.copy()
        frozen.setflags(write=False)
        for some in (path.astype(">f8"), path.astype(np.float32), np.asfortranarray(path),
                     np.repeat(path, 2, axis=0)[::2], path.tolist(), frozen):
            self.assertEqual(sepax.collide(a, b, some).codes.tolist(), want)
        same = sepax.collide(a, b, np.broadcast_to(path[0], (7, 4, 4)))
        self.assertEqual(same.codes.tolist(), want[:1] * 7)

    def test_too_many(self):
        """More poses than memory holds are a MemoryError or ValueError before any work."""
        a, b = bodies()
        for count in (10**12, 2**58):
            with self.assertRaises((MemoryError, ValueError)):
                sepax.collide(a, b, np.broadcast_to(np.eye(4), (count, 4, 4)))


class Words(unittest.TestCase):
    """Errors of the program, in the words of Python."""

    def test_package(self):
        """A mesh of an unknown package is an error that names the argument."""
        if not sepax.features()["urdf"]:
            self.skipTest("no sepax-io")
        with tempfile.TemporaryDirectory() as folder:
            file = os.path.join(folder, "a.urdf")
            with open(file, "w", encoding="utf-8") as out:
                out.write("<robot name='a'><link name='l'><collision><geometry><mesh filename="
                          "'package://parts/x.stl'/></geometry></collision></link></robot>")
            with self.assertRaisesRegex(sepax.FormatError, "packages={'parts': FOLDER}"):
                sepax.Mechanism.from_urdf(file)
            with self.assertRaisesRegex(sepax.FormatError, "packages={name: folder}$"):
                os.mkdir(os.path.join(folder, "parts"))
                os.rename(file, os.path.join(folder, "parts", "a.urdf"))
                sepax.Mechanism.from_urdf(os.path.join(folder, "parts", "a.urdf"))

    def test_urdf(self):
        """The text of a robot in place of a file, and a robot without collision geometry."""
        text = "<robot name='a'><link name='l'/></robot>"
        with self.assertRaisesRegex(sepax.ArgumentError, "write it into a file"):
            sepax.Mechanism.from_urdf(" " + text)
        if not sepax.features()["urdf"]:
            self.skipTest("no sepax-io")
        with tempfile.TemporaryDirectory() as folder:
            file = os.path.join(folder, "a.urdf")
            with open(file, "w", encoding="utf-8") as out:
                out.write(text)
            with self.assertRaisesRegex(sepax.ArgumentError, "0 links have <collision>"):
                sepax.Mechanism.from_urdf(file).check(np.zeros((1, 0)))

    def test_limit(self):
        """A row beyond a limit is named by its number, with the argument that allows it."""
        if not sepax.features()["urdf"]:
            self.skipTest("no sepax-io")
        with tempfile.TemporaryDirectory() as folder:
            file = os.path.join(folder, "a.urdf")
            box = "<collision><geometry><box size='1 1 1'/></geometry></collision>"
            with open(file, "w", encoding="utf-8") as out:
                out.write(f"<robot name='a'><link name='l'>{box}</link><link name='m'/>"
                          f"<link name='n'>{box}</link><joint name='k' type='fixed'>"
                          "<parent link='l'/><child link='m'/></joint><joint name='j' "
                          "type='prismatic'><parent link='m'/><child link='n'/><limit lower='-5' "
                          "upper='5' effort='1' velocity='1'/></joint></robot>")
            robot = sepax.Mechanism.from_urdf(file)
            with self.assertRaisesRegex(sepax.ArgumentError,
                                        "^row 1: .* joint j: .*ignore_limits=True"):
                robot.certify([[4.0], [6.0]])


if __name__ == "__main__":
    unittest.main()
