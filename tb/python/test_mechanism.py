# SPDX-License-Identifier: MIT
"""Mechanisms from Python and from a URDF; proofs and pages by the program."""
import os
import shutil
import tempfile
import unittest

import numpy as np
import sepax
from sepax import Code, Joint

from shapes import at, cube, poses

URDF = """<robot name='arm'>
<link name='base'><collision><geometry><box size='1 1 1'/></geometry></collision></link>
<link name='arm'/>
<link name='hand'><collision><origin xyz='3 0 0'/><geometry><box size='1 1 1'/></geometry>
</collision></link>
<joint name='turn' type='revolute'><parent link='base'/><child link='arm'/><axis xyz='0 0 1'/>
<limit lower='-3' upper='3' effort='1' velocity='1'/></joint>
<joint name='slide' type='prismatic'><parent link='arm'/><child link='hand'/><axis xyz='1 0 0'/>
<limit lower='-2.5' upper='2' effort='1' velocity='1'/></joint></robot>
"""


def arm(**more):
    """The same mechanism from Python."""
    return sepax.Mechanism(
        ["base", "arm", "hand"],
        [Joint("turn", "revolute", "base", "arm", axis=(0, 0, 1), lower=-3, upper=3),
         Joint("slide", "prismatic", "arm", "hand", axis=(1, 0, 0))],
        bodies={"base": sepax.Body(*cube()), "hand": sepax.Body(*cube(1, (3, 0, 0)))}, **more)


class FromPython(unittest.TestCase):
    """Links and joints as Python names them."""

    def test_about(self):
        """What the mechanism says of itself."""
        m = arm()
        self.assertEqual((m.links, m.root, m.driven), (["base", "arm", "hand"], "base",
                                                       ["turn", "slide"]))
        self.assertEqual((m.pairs, m.joints[0].upper, m.joints[1].kind), ([("base", "hand")], 3,
                                                                         "prismatic"))
        self.assertIn("1 pairs", repr(m))

    def test_poses(self):
        """Poses of links."""
        got = arm().poses([[np.pi / 2, 1.0], [0, 0]])
        np.testing.assert_allclose(got["hand"][0], [[0, -1, 0, 0], [1, 0, 0, 1], [0, 0, 1, 0],
                                                    [0, 0, 0, 1]], atol=1e-15)
        np.testing.assert_array_equal(got["base"], [np.eye(4)] * 2)
        self.assertEqual(arm().poses({"turn": 0.0, "slide": 2.0})["hand"].shape, (4, 4))

    def test_check(self):
        """Verdicts and least clearances, beside bodies in the poses of the links."""
        m = arm()
        rng = np.random.default_rng(3)
        rows = rng.uniform((-3, -3.5), (3, 1), (2000, 2))
        got = m.check(rows, measure=True)
        where = m.poses(rows)
        want = sepax.collide(m.bodies["base"], m.bodies["hand"], where["base"], where["hand"])
        near = sepax.distance(m.bodies["base"], m.bodies["hand"], where["base"], where["hand"])
        np.testing.assert_array_equal(got.collides, want.collides)
        self.assertTrue(((got.least <= near.most) & (near.least <= got.most)).all())
        self.assertTrue(0.1 < got.collides.mean() < 0.9)
        self.assertEqual(got.names(int(np.argmax(got.collides))), ("base", "hand"))
        self.assertIsNone(got.names(int(np.argmin(got.collides))))
        self.assertEqual(got.basis.poses, "rounded")
        by_name = m.check({"slide": rows[:, 1], "turn": rows[:, 0]}, threads=2)
        np.testing.assert_array_equal(by_name.codes, got.codes)
        self.assertIsNone(by_name.least)
        self.assertTrue(m.check([0, -1.9], clearance=0.2).collides[0])
        self.assertFalse(m.check([0, -1.75], clearance=0.2).collides[0])
        self.assertFalse(m.check(rows[:5], travel=[3.0, 3.0]).free.any())
        self.assertEqual(len(m.check(np.empty((0, 2)))), 0)
        self.assertEqual(list(m.outside_limits([[4, 0], [0, 0]])), [True, False])

    def test_inside(self):
        """A hand that is wholly inside the base."""
        small = {"base": sepax.Body(*cube(3)), "hand": sepax.Body(*cube(0.5))}
        parts = (["base", "hand"], [Joint("x", "prismatic", "base", "hand", axis=(1, 0, 0))])
        m = sepax.Mechanism(*parts, bodies=small, pairs=[("base", "hand")])
        got = m.check([[0.0], [1.5], [9.0]], measure=True)
        self.assertEqual(list(got.codes), [Code.B_INSIDE, Code.COLLIDES, Code.FREE])
        self.assertEqual((got.most[0], got.most[1], got.nearest[0]), (0, 0, 0))
        m = sepax.Mechanism(*parts, bodies=small, pairs=[("base", "hand")], surfaces=True)
        self.assertEqual(m.check([0.0]).codes[0], Code.FREE)
        points, faces = cube(3)
        small["base"] = sepax.Body(points, faces[1:])
        m = sepax.Mechanism(*parts, bodies=small, pairs=[("base", "hand")])
        got = m.check([[0.0], [9.0]])
        self.assertEqual(list(got.codes), [Code.UNDECIDED, Code.FREE])
        self.assertEqual(got.names(0), ("base", "hand"))

    def test_mimic(self):
        """A joint that follows another one has no column."""
        m = sepax.Mechanism(["a", "b", "c"], [
            Joint("x", "prismatic", "a", "b", axis=(2, 0, 0)),
            Joint("y", "prismatic", "b", "c", axis=(0, 1, 0), mimic="x", factor=-2, offset=1),
            ], bodies={"a": sepax.Body(*cube()), "c": sepax.Body(*cube())})
        self.assertEqual(m.driven, ["x"])
        np.testing.assert_array_equal(m.poses([3.0])["c"], at(3, -5))
        origin = poses(1, 2)[0]
        m = sepax.Mechanism(["a", "b"], [Joint("f", "fixed", "a", "b", origin)])
        np.testing.assert_allclose(m.poses({})["b"], origin, atol=1e-12)
        with self.assertRaisesRegex(sepax.ArgumentError, "no pairs"):
            m.check({})


class FromFile(unittest.TestCase):
    """URDF, and what the program does."""

    def setUp(self):
        if not sepax.features()["urdf"]:
            self.skipTest("no sepax-io here")
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name
        self.urdf = os.path.join(self.folder, "arm.urdf")
        with open(self.urdf, "w", encoding="utf-8") as file:
            file.write(URDF)
        self.robot = sepax.Mechanism.from_urdf(self.urdf)

    def test_same(self):
        """The file says what Python said."""
        rows = np.random.default_rng(3).uniform((-3, -3.5), (3, 1), (500, 2))
        np.testing.assert_array_equal(self.robot.check(rows).codes, arm().check(rows).codes)
        self.assertEqual((self.robot.name, self.robot.driven, self.robot.pairs),
                         ("arm", ["turn", "slide"], [("base", "hand")]))
        self.assertEqual(self.robot.account["shapes"], 2)

    def test_meshes(self):
        """Meshes, packages, SRDF and their errors."""
        sepax.write_stl(os.path.join(self.folder, "hand.stl"), cube(1)[0][cube(1)[1]])
        path = os.path.join(self.folder, "mesh.urdf")
        shape = "<mesh filename='package://parts/hand.stl' scale='2 2 2'/>"
        with open(path, "w", encoding="utf-8") as file:
            file.write(URDF.replace("<box size='1 1 1'/>", shape, 1))
        robot = sepax.Mechanism.from_urdf(path, packages={"parts": self.folder})
        np.testing.assert_array_equal(robot.bodies["base"].box, [[-1] * 3, [1] * 3])
        robot = sepax.Mechanism.from_urdf(path, packages={"parts": self.folder}, unit=0.1)
        self.assertAlmostEqual(robot.bodies["base"].box[1, 0], 0.1)
        with self.assertRaisesRegex(sepax.SepaxError, "parts"):
            sepax.Mechanism.from_urdf(path)
        srdf = os.path.join(self.folder, "arm.srdf")
        with open(srdf, "w", encoding="utf-8") as file:
            file.write("<robot name='arm'><disable_collisions link1='base' link2='hand'/></robot>")
        robot = sepax.Mechanism.from_urdf(self.urdf, srdf)
        self.assertEqual((robot.pairs, robot.account["pairs_disabled"]), ([], 1))
        with open(srdf, "w", encoding="utf-8") as file:
            file.write("<robot name='leg'/>")
        with self.assertWarnsRegex(UserWarning, "'leg'.*'arm'"):
            self.assertEqual(len(sepax.Mechanism.from_urdf(self.urdf, srdf).pairs), 1)
        with self.assertRaises(sepax.FileError):
            sepax.Mechanism.from_urdf(os.path.join(self.folder, "none.urdf"))
        with self.assertRaisesRegex(sepax.FormatError, "line|:[0-9]+:"):
            sepax.Mechanism.from_urdf(srdf)

    def test_two_solids(self):
        """A shape within another shape of its link is no cavity."""
        path = os.path.join(self.folder, "two.urdf")
        two = "<collision><geometry><box size='{0} {0} {0}'/></geometry></collision>"
        with open(path, "w", encoding="utf-8") as file:
            file.write("<robot name='r'><link name='a'>" + two.format(9) + two.format(5) +
                       "</link><link name='b'>" + two.format(1) + "</link><joint name='j' "
                       "type='prismatic'><parent link='a'/><child link='b'/><axis xyz='1 0 0'/>"
                       "<limit lower='-9' upper='9' effort='1' velocity='1'/></joint></robot>")
        srdf = os.path.join(self.folder, "two.srdf")
        with open(srdf, "w", encoding="utf-8") as file:
            file.write("<robot name='r'/>")
        robot = sepax.Mechanism.from_urdf(path, srdf)
        self.assertEqual(list(robot.check([[0.0], [9.0]]).codes), [Code.B_INSIDE, Code.FREE])

    def test_polygons(self):
        """Of mesh files, in Python and in the program."""
        with open(os.path.join(self.folder, "bow.obj"), "w", encoding="utf-8") as file:
            file.write("v 0 0 0\nv 1 1 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3 4\nf 1 5 2\n"
                       "f 2 5 3\nf 3 5 4\nf 4 5 1\n")
        path = os.path.join(self.folder, "bow.urdf")
        with open(path, "w", encoding="utf-8") as file:
            file.write(URDF.replace("<box size='1 1 1'/>", "<mesh filename='bow.obj'/>", 1))
        with self.assertRaisesRegex(sepax.FormatError, "give polygons='fan'"):
            sepax.Mechanism.from_urdf(path)
        robot = sepax.Mechanism.from_urdf(path, polygons="fan")
        self.assertEqual(len(robot.bodies["base"]), 6)
        self.assertTrue(robot.certify([[0, 0], [0.1, 0]]).pairs)

    def test_certify(self):
        """The motion between rows."""
        path = [[-1, 0], [1, 0], [1, 1.5]]
        got = self.robot.certify(path, proof=os.path.join(self.folder, "proof"))
        self.assertTrue(got.free and got.certified)
        self.assertEqual(got.pairs[0].links, ("base", "hand"))
        self.assertTrue(os.path.getsize(got.proof) > 100)
        measured = self.robot.check(path, measure=True)
        self.assertAlmostEqual(got.least().least[0], measured.least.min(), 9)
        self.assertEqual(got.least().row, int(measured.least.argmin()))
        through = self.robot.certify([[0, 1], [0, -2]], times=[0, 1])
        self.assertEqual((through.verdict, through.certified), ("collision", False))
        self.assertIsNone(got.first)
        self.assertEqual((through.first.row, through.first.part), (1, 0.0))
        self.assertEqual(through.first.links, ("base", "hand"))
        self.assertIn("collision of base and hand in row 1", repr(through))
        with self.assertRaisesRegex(TypeError, "free"):
            bool(got)
        bad = self.robot.certify([[0, 1], [0, -2]], proof=os.path.join(self.folder, "none"))
        self.assertIsNone(bad.proof)
        # Turned through a body between two rows that are free.
        tunnel = self.robot.certify([[0, 0], [0, 0]], clearance=1.9)
        self.assertTrue(tunnel.free)
        between = self.robot.certify({"turn": [0.0, 0.0], "slide": [0.0, 0.5]}, clearance=2.1)
        self.assertEqual(between.verdict, "collision")
        self.assertIn("certified", repr(got))
        with self.assertRaisesRegex(sepax.ArgumentError, "^row 1: .*limit.*ignore_limits=True"):
            self.robot.certify([[0, 0], [0, 99]])
        with self.assertRaisesRegex(sepax.FileError, "give a place"):
            self.robot.certify(path, proof="/proc/none")
        with self.assertRaisesRegex(sepax.ArgumentError, "text of a robot"):
            sepax.Mechanism.from_urdf("<robot name='r'/>")
        here = os.getcwd()
        os.chdir("/")
        try:
            self.assertTrue(self.robot.certify(path).free)
        finally:
            os.chdir(here)

    def test_between_rows(self):
        """Bodies that meet between two free rows: the place is told, by rows."""
        file = os.path.join(self.folder, "post.urdf")
        box = ("<link name='{}'><collision><origin xyz='2 0 0'/><geometry><box size='{} {} 1'/>"
               "</geometry></collision></link>")
        joint = ("<joint name='{}' type='revolute'><parent link='{}'/><child link='{}'/>"
                 "<axis xyz='0 0 1'/><limit lower='-3' upper='3' effort='1' velocity='1'/></joint>")
        with open(file, "w", encoding="utf-8") as out:
            out.write("<robot name='r'>" + box.format("post", .01, .01) +
                      box.format("arm", .1, .1) +
                      "<link name='m'/>" + joint.format("i", "post", "m") +
                      joint.format("j", "m", "arm") + "</robot>")
        robot = sepax.Mechanism.from_urdf(file)
        path = [[0, -1.5], [0, -1], [0, 1], [0, 1.2]]
        self.assertFalse(robot.check(path).collides.any())
        got = robot.certify(path)
        self.assertEqual((got.verdict, got.first.row, got.first.links),
                         ("collision", 1, ("post", "arm")))
        self.assertAlmostEqual(got.first.part, 0.4862, 3)
        self.assertEqual(set(got.first.values), {"i", "j"})
        self.assertIn("of post and arm between rows 1 and 2", repr(got))
        place = got.pairs[0].between.collision
        self.assertEqual((place["row"], place["part"]), (1, got.first.part))
        self.assertTrue(robot.check([list(got.first.values.values())]).collides[0])
        only_visual = os.path.join(self.folder, "visual.urdf")
        with open(only_visual, "w", encoding="utf-8") as out:
            out.write("<robot name='r'><link name='a'><visual><geometry><box size='1 1 1'/>"
                      "</geometry></visual></link></robot>")
        with self.assertRaisesRegex(sepax.ArgumentError, "<collision>"):
            sepax.Mechanism.from_urdf(only_visual).check(np.zeros((1, 0)))

    def test_certify_refused(self):
        """What cannot be certified is told."""
        path = [[-1, 0], [1, 0], [1, 1.5]]
        self.assertTrue(self.robot.certify([[0, 99]], ignore_limits=True).free)
        with self.assertRaisesRegex(sepax.ArgumentError, "from_urdf"):
            arm().certify(path)

    def test_no_program(self):
        """Without the program the text says how to get it."""
        before = os.environ.pop("SEPAX_PROGRAM", None)
        try:
            os.environ["SEPAX_PROGRAM"] = "/nowhere/sepax"
            with self.assertRaisesRegex(sepax.MissingError, "pip install sepax-io"):
                self.robot.certify([[0, 0]])
        finally:
            if before is not None:
                os.environ["SEPAX_PROGRAM"] = before
            else:
                del os.environ["SEPAX_PROGRAM"]

    def test_page(self):
        """A page for a notebook."""
        three = os.environ.get("SEPAX_THREE", "/usr/share/javascript/three")
        if not os.path.exists(os.path.join(three, "build/three.min.js")) and not shutil.which("x"):
            self.skipTest("no three.js here")
        file = os.path.join(self.folder, "p.html")
        page = self.robot.page([[0, 0], [1, 0]], file)
        self.assertTrue(page._repr_html_().startswith("<iframe srcdoc="))
        self.assertEqual(os.path.getsize(file), len(page.html.encode()))


if __name__ == "__main__":
    unittest.main()
