# SPDX-License-Identifier: MIT
"""Files of meshes and poses."""
import os
import tempfile
import unittest

import numpy as np
import sepax

from shapes import ball, cube, poses


class Files(unittest.TestCase):
    """Each test has a folder of its own."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name

    def file(self, name, text):
        """A file with this text."""
        path = os.path.join(self.folder, name)
        with open(path, "w", encoding="utf-8") as out:
            out.write(text)
        return path

    def test_stl(self):
        """What is written is read again; names need not be ASCII."""
        points, faces = ball(100)
        triangles = points[faces]
        for ascii_, kind in ((True, np.float64), (False, np.float32)):
            path = os.path.join(self.folder, "größe.stl")
            sepax.write_stl(path, triangles, ascii=ascii_)
            got, account = sepax.read_mesh(path)
            np.testing.assert_array_equal(got, triangles.astype(kind))
            self.assertEqual((account["format"], account["triangles"]), ("STL", len(faces)))
            body = sepax.Body.load(path)
            self.assertEqual((len(body), body.closed), (len(faces), True))
            self.assertEqual(body.account["faces"], len(faces))

    def test_formats(self):
        """OBJ, and units."""
        path = self.file("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nvt 0 0\nf 1 2 4 3\n")
        triangles, account = sepax.read_mesh(path, unit_mm=1, result_mm=1000)
        self.assertEqual((triangles.shape, account["divided"]), ((2, 3, 3), 1))
        self.assertEqual(triangles.max(), 0.001)
        self.assertTrue(account["others"])

    def test_polygons(self):
        """One that crosses itself is refused, with the cure, or a fan."""
        path = self.file("bow.obj", "v 0 0 0\nv 2 2 0\nv 2 0 0\nv 0 2 0\nf 1 2 3 4\n")
        with self.assertRaisesRegex(sepax.FormatError, "give polygons='fan'"):
            sepax.Body.load(path)
        with self.assertRaisesRegex(sepax.ArgumentError, "give 'refuse' or 'fan'"):
            sepax.read_mesh(path, polygons="ears")
        triangles, account = sepax.read_mesh(path, polygons="fan")
        np.testing.assert_array_equal(triangles[1], [[0, 0, 0], [2, 0, 0], [0, 2, 0]])
        self.assertEqual((account["divided"], account["fans"], account["remarks"]), (1, 1, []))
        self.assertEqual(len(sepax.Body.load(path, polygons="fan")), 2)

    def test_errors(self):
        """The text names the file, the line and the cure."""
        with self.assertRaises(sepax.FileError):
            sepax.Body.load(os.path.join(self.folder, "none.stl"))
        with self.assertRaises(OSError):
            sepax.Body.load(self.folder)
        with self.assertRaisesRegex(sepax.FormatError, "line 2|:2:"):
            sepax.Body.load(self.file("b.obj", "v 0 0 0\nv 1 x 0\n"))
        with self.assertRaises(sepax.LimitError):
            sepax.read_mesh(self.file("c.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 1 2 3\n"),
                            most=1)
        if not sepax.features()["urdf"]:
            with self.assertRaisesRegex(sepax.FormatError, "pip install sepax-io"):
                sepax.Body.load(self.file("d.dae", '<?xml version="1.0"?><COLLADA/>'))

    def test_weld(self):
        """A torn cube is closed."""
        points, faces = cube()
        torn = points[faces] + 1e-9 * np.random.default_rng(1).random((12, 3, 3))
        self.assertFalse(sepax.Body(torn).closed)
        welded, said = sepax.weld(torn, 1e-6)
        self.assertTrue(sepax.Body(welded).closed)
        self.assertLess(said["farthest"], 1e-6)

    def test_poses(self):
        """Lines of 12 numbers."""
        path = poses(5, 3)
        text = "".join(" ".join(repr(float(x)) for x in [*p[:3, :3].ravel(), *p[:3, 3]]) + "\n"
                       for p in path)
        np.testing.assert_array_equal(sepax.read_poses(self.file("p.txt", text)), path)
        with self.assertRaisesRegex(sepax.FormatError, "line 1|:1:"):
            sepax.read_poses(self.file("q.txt", "1 0 0\n"))
        rough = np.round(path, 4)
        with self.assertRaises(sepax.ArgumentError):
            sepax.collide(sepax.Body(*cube()), sepax.Body(*cube()), rough)
        mended = sepax.nearest_poses(rough)
        self.assertLess(np.abs(mended - path).max(), 1e-3)
        sepax.collide(sepax.Body(*cube()), sepax.Body(*cube()), mended)
        self.assertEqual(sepax.nearest_poses(rough[0]).shape, (4, 4))


if __name__ == "__main__":
    unittest.main()
