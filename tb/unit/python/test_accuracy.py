# SPDX-License-Identifier: MIT
"""Tests of scripts/pictures/accuracy: intervals, what is drawn for nothing found, and names."""
import unittest

from loading import load

pictures = load("scripts/pictures/accuracy")


def row(**changes):
    """A row of accuracy.csv."""
    return {"study": "main", "design": "--arch=float64 --word=18", "family": "all",
            "triangles": "proper", "pairs": "1000", "collisions": "400", "missed": "4",
            "false_alarms": "0", **changes}


class Intervals(unittest.TestCase):
    """Wilson's interval, and 3 / N."""

    def test_known_values(self):
        share = pictures.wilson(10, 100)
        self.assertAlmostEqual(share.low, 0.05523, 5)
        self.assertAlmostEqual(share.high, 0.17437, 5)

    def test_ends(self):
        self.assertEqual(pictures.wilson(0, 50).low, 0)
        self.assertAlmostEqual(pictures.wilson(50, 50).high, 1)

    def test_nothing_found_is_drawn_at_three_over_n(self):
        self.assertEqual(pictures.wilson(0, 300).drawn, 0.01)
        self.assertEqual(pictures.wilson(0, 3000000).drawn, 1e-6)
        self.assertEqual(pictures.wilson(3, 300).drawn, 0.01)


class Rows(unittest.TestCase):
    """Shares of rows, names, positions."""

    def test_what_a_share_is_of(self):
        self.assertEqual(pictures.missed(row())[:2], (4, 400))
        self.assertEqual(pictures.false_alarms(row())[:2], (0, 600))
        self.assertEqual(pictures.wrong(row(false_alarms="6"))[:2], (10, 1000))
        self.assertIsNone(pictures.missed(row(collisions="0")))

    def test_names(self):
        design = "--arch=paper --word=18 --precision={} --block-float=on"
        self.assertEqual(pictures.series_name(row(design=design.format("word"))),
                         "paper, word + block float")
        guard = row(study="guard", design=design.format("guard=4"))
        self.assertEqual(pictures.series_name(guard), "paper, guard bits + block float")
        self.assertEqual(pictures.x_of(guard, "guard"), 4)
        self.assertEqual(pictures.x_of(guard, "word"), 18)

    def test_hardware_and_software(self):
        rows = [row(design="--arch=exact --word=18", missed="0"), row()]
        points = pictures.speed_points(rows, {"exact": 1e7, "avx2": 1e8, "float64": 2e7})
        self.assertEqual([(p.name, p.hardware) for p in points],
                         [("exact, II = 1", True), ("exact, II = 3", True), ("exact, C", False),
                          ("exact, avx2", False), ("float64", False)])


class Labels(unittest.TestCase):
    """Names beside points."""

    def test_none_over_another(self):
        share = pictures.wilson(0, 1000)
        points = [pictures.Point(1e8 * (1 + 0.01 * n), share, f"name {n}") for n in range(4)]
        lines = pictures.labels(points, (1e6, 1e10))
        places = [line.split(" at ")[1] for line in lines if line.startswith("set label")]
        self.assertEqual(len(set(places)), 4)


if __name__ == "__main__":
    unittest.main()
