# SPDX-License-Identifier: MIT
"""Tests of scripts/pictures/accuracy: intervals, what is drawn for nothing found, and names."""
import unittest

from loading import load

pictures = load("scripts/pictures/accuracy")
import accuracy_counts as counts  # noqa: E402  pylint: disable=wrong-import-position
import accuracy_page  # noqa: E402  pylint: disable=wrong-import-position


def row(**changes):
    """A row of accuracy.csv."""
    return {"study": "main", "design": "--arch=float64 --word=18", "family": "all",
            "triangles": "proper", "pairs": "1000", "collisions": "400", "missed": "4",
            "false_alarms": "0", **changes}


class Intervals(unittest.TestCase):
    """Wilson's interval, and 3 / N."""

    def test_known_values(self):
        share = counts.wilson(10, 100)
        self.assertAlmostEqual(share.low, 0.05523, 5)
        self.assertAlmostEqual(share.high, 0.17437, 5)

    def test_ends(self):
        self.assertEqual(counts.wilson(0, 50).low, 0)
        self.assertAlmostEqual(counts.wilson(50, 50).high, 1)

    def test_nothing_found_is_drawn_at_three_over_n(self):
        self.assertEqual(counts.wilson(0, 300).drawn, 0.01)
        self.assertEqual(counts.wilson(0, 3000000).drawn, 1e-6)
        self.assertEqual(counts.wilson(3, 300).drawn, 0.01)


class Rows(unittest.TestCase):
    """Shares of rows, names, positions."""

    def test_what_a_share_is_of(self):
        self.assertEqual(counts.missed(row())[:2], (4, 400))
        self.assertEqual(counts.false_alarms(row())[:2], (0, 600))
        self.assertEqual(counts.wrong(row(false_alarms="6"))[:2], (10, 1000))
        self.assertIsNone(counts.missed(row(collisions="0")))

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


class Text(unittest.TestCase):
    """Shares, depths and gaps in tables."""

    def text(self, found, of):
        """A share in a table."""
        return counts.share_text(counts.wilson(found, of))

    def test_digits_tell_the_ends_of_the_interval_apart(self):
        self.assertEqual(self.text(4728000, 7767058), "60.87 % (60.84 ... 60.91)")
        self.assertEqual(self.text(200, 1000), "20 % (18 ... 23)")

    def test_few_are_counted(self):
        self.assertEqual(self.text(26, 7970201), "26, 0.00033 % (0.00022 ... 0.00048)")
        self.assertEqual(self.text(1, 10), "1, 10 % (2 ... 40)")

    def test_none_and_nothing_to_find(self):
        self.assertEqual(self.text(0, 300), "none (< 1 %)")
        self.assertEqual(self.text(0, 15_000_000), "none (< 0.00002 %)")
        self.assertEqual(counts.share_text(None), "-")

    def test_all_found(self):
        self.assertEqual(self.text(1000, 1000), "100.0 % (99.6 ... 100.0)")

    def test_lengths(self):
        some, none = counts.wilson(1, 10), counts.wilson(0, 10)
        self.assertEqual(counts.length("97012.4", some), "97,000")
        self.assertEqual(counts.length("5.39461e-06", some), "0.00000539")
        self.assertEqual(counts.length("0", some), "contact")
        self.assertEqual(counts.length("0", none), "-")

    def test_designs_without_what_is_usual(self):
        self.assertEqual(accuracy_page.short(
            "--arch=paper --word=18 --ii=3 --precision=word --block-float=off "
            "--coplanarity=plane --inequality=correct --epsilon=1"), "paper word=18 precision=word")
        self.assertIn("epsilon=16", accuracy_page.short("--arch=paper --epsilon=16"))

    def test_a_cell_is_text(self):
        self.assertIn("<td>none (&lt; 1 %)</td>", accuracy_page.table(["a"], [["none (< 1 %)"]]))


class Labels(unittest.TestCase):
    """Names beside points."""

    def test_none_over_another(self):
        share = counts.wilson(0, 1000)
        points = [pictures.Point(1e8 * (1 + 0.01 * n), share, f"name {n}") for n in range(4)]
        lines = pictures.labels(points, (1e6, 1e10))
        places = [line.split(" at ")[1] for line in lines if line.startswith("set label")]
        self.assertEqual(len(set(places)), 4)

    def test_a_line_passes_no_name(self):
        share = counts.wilson(0, 1000)
        points = [pictures.Point(1e8 * (1 + 0.02 * n), share, f"a longer name {n}")
                  for n in range(5)]
        lines = pictures.labels(points, (1e6, 1e10))
        self.assertEqual(sum(line.startswith("set label") for line in lines), 5)


if __name__ == "__main__":
    unittest.main()
