# SPDX-License-Identifier: MIT
"""Tests of synth/report/tables: numbers as people read them, and what stands beside the paper."""
import io
import json
import tempfile
import unittest
from contextlib import redirect_stderr, redirect_stdout
from pathlib import Path
from unittest import mock

from loading import load

tables = load("synth/report/tables")

DESIGN = {"arch": "exact", "word": 18, "ii": 3, "precision": "exact", "options": "--arch=exact",
          "latency": 12, "timing": None, "multipliers": "generated", "area": 1.0, "ge": 60600.0,
          "ff": 9, "memory_bits": None,
          "modules": [{"name": "sepax_top", "instances": 1, "ge": 2.5, "ge_total": 60600.0,
                       "ff": 9, "clock_gates": 0}]}


def result(library="a.lib", **changes):
    """AREA.json of one design."""
    return {"library": library, "nand2": "N", "nand2_area": 24,
            "tools": {"yosys": "Yosys 0.23 (git)", "sta": ""}, "design": {**DESIGN, **changes}}


class Numbers(unittest.TestCase):
    """Rounding and printing."""

    def test_halves_go_away_from_zero(self):
        self.assertEqual([tables.rounded(v, 1) for v in (0.5, 1.5, 2.5, -2.5)], [1, 2, 3, -3])

    def test_numbers_are_short(self):
        self.assertEqual([tables.shown(v) for v in (2.0, 0.1, None, 1955, "x")],
                         ["2", "0.1", "-", "1955", "x"])

    def test_thousands_have_one_decimal(self):
        self.assertEqual([tables.thousands(v) for v in (60600.0, 999, 12)],
                         ["60.6K", "1.0K", "0.0K"])

    def test_columns_are_as_wide_as_they_must_be(self):
        self.assertEqual(tables.table([["a", "bcd"], ["efgh", 1]]), "a     bcd\nefgh    1")


class Gates(unittest.TestCase):
    """The table beside the paper's."""

    def text(self, *results):
        return "\n".join(tables.gates(tables.join("gates", list(results))))

    def test_ratio_to_the_paper(self):
        self.assertRegex(self.text(result()), r"(?m)^exact .* 181\.8K +20 +-$")

    def test_another_word_is_marked(self):
        text = self.text(result(word=12))
        self.assertRegex(text, r"(?m)^exact .* 20 \(W = 12\) +-$")
        self.assertIn("not one of equal work", text)
        self.assertNotIn("(W = 18)", self.text(result()))

    def test_a_missed_clock_is_told(self):
        timing = {"period_ns": 2, "slack_ns": -0.25, "met": False}
        self.assertIn("2 ns missed by 0.25", self.text(result(timing=timing)))

    def test_cells_of_no_process_are_told(self):
        self.assertIn("of no process", self.text(result("generic.lib")))
        self.assertNotIn("of no process", self.text(result()))

    def test_two_libraries_are_refused(self):
        with self.assertRaises(tables.Failed):
            self.text(result(), result("b.lib"))


class Power(unittest.TestCase):
    """A figure of 0 is a figure."""

    def test_no_error_and_an_error_of_nothing(self):
        load_of = {"workload": "idle", "period_ns": 2, "leakage_w": 0, "internal_w": 0,
                   "switching_w": 0, "total_w": 0, "registers": {"total_w": 0}, "modules": []}
        design = {"library": "a.lib", "design": DESIGN, "workloads": [{**load_of, "error": 0},
                                                                      load_of]}
        lines = tables.power(tables.join("power", [design]))[1].split("\n")
        self.assertIn(" 0 % ", lines[1])
        self.assertNotIn(" 0 % ", lines[2])


class Command(unittest.TestCase):
    """What it refuses."""

    def run_command(self, *arguments):
        out, err = io.StringIO(), io.StringIO()
        with mock.patch("sys.argv", ["tables", *arguments]), redirect_stdout(out), \
                redirect_stderr(err):
            status = tables.common.run_main("tables", tables.run)
        return status, out.getvalue(), err.getvalue()

    def test_what_is_no_result(self):
        with tempfile.TemporaryDirectory() as folder:
            file = Path(folder) / "bad.json"
            for text, said in (("{}", "tables: no table of .*bad.json"),
                               ("{", "tables: .*bad.json is not JSON")):
                file.write_text(text)
                status, out, err = self.run_command("fpga", str(file))
                self.assertEqual((status, out), (2, ""))
                self.assertRegex(err, said)

    def test_usage(self):
        for arguments in ([], ["cells"], ["gates"], ["gates", "-x", "f"]):
            self.assertEqual(self.run_command(*arguments)[0], 2)

    def test_the_results_are_joined(self):
        with tempfile.TemporaryDirectory() as folder:
            file, out = Path(folder) / "a.json", Path(folder) / "all.json"
            file.write_text(json.dumps(result()))
            self.assertEqual(self.run_command("gates", "-o", str(out), str(file))[0], 0)
            self.assertEqual(json.loads(out.read_text())["designs"][0]["ge"], 60600.0)


if __name__ == "__main__":
    unittest.main()
