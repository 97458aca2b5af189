# SPDX-License-Identifier: MIT
"""Tests of scripts/results: rows of tables, and pages that have a table by its name."""
import tempfile
import unittest
from pathlib import Path

from loading import load

results = load("scripts/results")


def row(**changes):
    """A row of report.json."""
    return {"variables": "ARCH=exact II=3", "arch": "exact", "ii": 3, "latency": 12,
            "period_ns": 2, "timed": True, "met": True, "ge": 65848.669, "lanes": None,
            "pairs_per_s": 166666666.67, "energy_pj": {"separated": 296.14},
            "errors": {"pairs": 1000, "collisions": 400, "missed": 0, "false_alarms": 3},
            **changes}


class Rows(unittest.TestCase):
    """A row as the tables show it."""

    def test_numbers(self):
        shown = results.entry(row())
        self.assertEqual([shown[key] for key in ("clock", "ge", "cost", "speed", "missed",
                                                 "alarms")],
                         ["2 ns", "65.8K", "197.5K", "167 M", "none", "0.5 %"])

    def test_clocks(self):
        self.assertEqual(results.entry(row(timed=False, met=None, period_ns=2.5))["clock"],
                         "2.5 ns, not timed")
        self.assertEqual(results.entry(row(met=False))["clock"], "2 ns, missed")

    def test_an_engine_has_no_latency(self):
        shown = results.entry(row(lanes=16, pairs_per_s=7984031936))
        self.assertEqual((shown["latency"], shown["cost"], shown["speed"]), ("-", "-", "7.98 G"))
        self.assertEqual(shown["name"], "engine, 16 lanes, II = 3")

    def test_small_shares_have_more_digits(self):
        self.assertEqual(results.share(1, 3000), "0.0333 %")

    def test_energy_beside_paper(self):
        paper = row(arch="paper", variables="ARCH=paper PRECISION=full",
                    energy_pj={"separated": 1776.84})
        lines = results.energy({"library": "x.lib.gz", "rows": [paper, row()]})
        self.assertIn("| **exact**, II = 3 | 65.8K | 0.296 (6) | - | - |", lines)


class Pages(unittest.TestCase):
    """Tables in pages."""

    def filled(self, text):
        """A page with a table that says its name."""
        with tempfile.TemporaryDirectory() as folder:
            (Path(folder) / "page.md").write_text(text)
            root, results.ROOT = results.ROOT, Path(folder)
            try:
                return results.filled("page.md", lambda name: [f"table {name}"])
            finally:
                results.ROOT = root

    def test_each_table_by_its_name(self):
        text = ("a\n<!-- results: one -->\nold\n<!-- end of results -->\nb\n"
                "<!-- results -->\n<!-- end of results -->\n")
        self.assertEqual(self.filled(text), (
            "a\n<!-- results: one -->\ntable one\n<!-- end of results -->\nb\n"
            "<!-- results -->\ntable \n<!-- end of results -->\n"))

    def test_a_page_without_a_place(self):
        for text in ("a\n", "<!-- results -->\na\n",
                     "<!-- results -->\n<!-- results -->\n<!-- end of results -->\n"):
            with self.assertRaises(results.Failed):
                self.filled(text)


class Counts(unittest.TestCase):
    """The rows of accuracy.csv that are kept."""

    def test_kept(self):
        design = "--arch=paper --word=18 --precision=full --block-float=off --epsilon="
        base = {"study": "word", "family": "local", "triangles": "proper", "design": design + "1"}
        self.assertFalse(results.is_shown(base))
        self.assertTrue(results.is_shown({**base, "family": "all"}))
        self.assertTrue(results.is_shown({**base, "study": "main"}))
        self.assertTrue(results.is_shown({**base, "study": "epsilon"}))
        self.assertFalse(results.is_shown({**base, "study": "epsilon", "design": design + "16"}))


if __name__ == "__main__":
    unittest.main()
