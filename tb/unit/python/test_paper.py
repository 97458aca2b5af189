# SPDX-License-Identifier: MIT
"""Tests of scripts/paper: both definitions of throughput, savings, and what is not measured."""
import contextlib
import io
import unittest

from loading import load

paper = load("scripts/paper")


def report():
    """report.json with a row for each column."""
    row = {"ii": 3, "period_ns": 2, "latency": 13, "ge": 1212000.0, "timed": True,
           "energy_pj": {"separated": 600.0, "colliding": 1200.0}}
    return {"library": "nangate45_typ.lib.gz", "nand2_area": 0.798,
            "rows": [{**row, "variables": variables} for _, variables in paper.OURS]}


class Table4(unittest.TestCase):
    """The paper's figures beside ours."""

    def setUp(self):
        self.rows = {row[0]: row[1:] for row in paper.table_4(report())}

    def test_both_throughputs(self):
        self.assertEqual(self.rows["throughput: frequency / latency"][:3],
                         ["20 M", "38.46 M", "38.46 M"])
        self.assertEqual(self.rows["throughput: frequency / II"][:3],
                         ["not stated", "166.7 M", "166.7 M"])

    def test_power_is_energy_over_the_time_of_a_pair(self):
        self.assertEqual(self.rows["power, separated pairs"][2], "100 mW")
        self.assertEqual(self.rows["power, colliding pairs"][2], "200 mW")

    def test_area_is_that_of_the_cells(self):
        self.assertEqual(self.rows["core area"][2], "0.967 mm2")

    def test_a_row_that_is_missing_is_named(self):
        short = report()
        short["rows"].pop()
        with self.assertRaisesRegex(paper.Failed, "no row ARCH=exact II=1; run make report"):
            paper.table_4(short)


    def test_each_row_says_where_it_is_from(self):
        self.assertEqual(len(paper.SOURCES_4), len(paper.table_4(report())))


class MadeNow(unittest.TestCase):
    """Figures that are made now, beside those of table 4."""

    def compare(self, made, key="ge"):
        """Whether a figure agrees, and what is printed."""
        row = paper.OURS[0][1]
        with contextlib.redirect_stdout(io.StringIO()) as out:
            same = paper.compared([paper.Anew("x", "65.8K GE", made, row, key)], report())
        return same, out.getvalue()

    def test_agrees(self):
        self.assertEqual(self.compare(1215000)[0], True)
        self.assertIn("as in table 4", self.compare(1215000)[1])

    def test_differs(self):
        same, said = self.compare(1300000)
        self.assertFalse(same)
        self.assertIn("DIFFERS: 1212000 in table 4; run make report", said)
        self.assertFalse(self.compare(12, "latency")[0])

    def test_another_library_is_not_compared(self):
        same, said = self.compare(1, "")
        self.assertTrue(same)
        self.assertIn("another library", said)


class Table3(unittest.TestCase):
    """Leakage with two thresholds."""

    def test_the_papers_own_savings(self):
        rows = paper.table_3({})
        self.assertEqual(rows[2][3], "47.12 %")
        self.assertEqual(rows[2][5], "18.99 %")

    def test_what_is_not_measured_says_so(self):
        self.assertEqual([row[1] for row in paper.table_3({})[3:]], ["not measured"] * 2)

    def test_ours(self):
        found = {"period_ns": 2, "cells": 1000, "low_leakage_cells": 900,
                 "before": {"cell_leakage_w": 0.004, "total_w": 0.1},
                 "after": {"cell_leakage_w": 0.001, "total_w": 0.1}}
        rows = paper.table_3({"exact": found})
        self.assertEqual(rows[-1][1:4], ["900 of 1,000 low-leakage", "1 mW", "75 %"])


if __name__ == "__main__":
    unittest.main()
