# SPDX-License-Identifier: MIT
"""Designs as objects."""
import os
import tempfile
import unittest

import sepax


class Designs(unittest.TestCase):
    """What sepax gen writes."""

    def setUp(self):
        if not os.environ.get("SEPAX_PROGRAM"):
            self.skipTest("no program")
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = os.path.join(folder.name, "core")

    def test_generate(self):
        """Files, ports, latency."""
        design = sepax.generate(self.folder, word=12, ii=3)
        self.assertEqual((design.word, design.ii, design.latency), (12, 3, 12))
        self.assertEqual(design.top, "sepax_top")
        self.assertEqual(design.port("in_a1_x")[1:4], ("input", 12, True))
        self.assertTrue(all(f.exists() for f in design.files) and len(design.files) > 10)
        with self.assertRaisesRegex(sepax.ArgumentError, "there is no port"):
            design.port("x")
        engine = sepax.generate(self.folder + "2", prefix="mine", word=8, ii=6, tree=True)
        self.assertTrue(engine.top.startswith("mine_"))
        self.assertTrue(engine.registers)
        self.assertIn("<Design", repr(engine))
        stream = sepax.generate(self.folder + "3", word=8, stream="pair", tag=4)
        self.assertTrue(any(p.name.endswith("tvalid") for p in stream.ports))

    def test_estimate(self):
        """More pairs a second take more gates."""
        fast, slow = sepax.estimate(word=12, ii=1), sepax.estimate(word=12, ii=9)
        self.assertGreater(fast.gates, slow.gates)
        self.assertGreater(fast.pairs_per_second, slow.pairs_per_second)
        self.assertTrue(0 < fast.gates_error < fast.gates)
        self.assertEqual(set(fast.energy), {"separated", "colliding", "coplanar"})

    def test_accuracy(self):
        """Rounding to fewer bits misses more collisions; the arithmetic of exact misses none."""
        coarse, fine = (sepax.accuracy(word=word, pairs=5000) for word in (8, 14))
        self.assertGreater(coarse.missed, 10 * max(fine.missed, 1))
        low, high = coarse.missed_share
        self.assertTrue(low < coarse.missed / coarse.collisions < high)
        self.assertEqual((coarse.pairs, coarse.design.split()[1]), (5000, "--word=8"))
        exact = sepax.accuracy(word=8, pairs=5000, truth="quantised")
        self.assertEqual((exact.missed, exact.false_alarms), (0, 0))
        paper = sepax.accuracy(word=18, arch="paper", precision="word", truth="quantised",
                               family="touch-face", pairs=5000)
        self.assertGreater(paper.missed + paper.false_alarms, 0)
        with self.assertRaisesRegex(sepax.ArgumentError, "nearby"):
            sepax.accuracy(family="nearby")

    def test_refused(self):
        """The option and its range are named; nothing is written."""
        for options, text in (({"word": 99}, "word"), ({"ii": 0}, "ii"), ({"wrd": 12}, "wrd"),
                              ({"arch": "best"}, "arch"), ({"prefix": "a-b"}, "prefix"),
                              ({"target": "moon"}, "target|moon"), ({"lanes": "many"}, "lanes")):
            with self.assertRaisesRegex(sepax.ArgumentError, text):
                sepax.generate(self.folder, **options)
        with self.assertRaises(TypeError):
            sepax.generate(self.folder, word=[12])
        self.assertFalse(os.path.exists(self.folder))


if __name__ == "__main__":
    unittest.main()
