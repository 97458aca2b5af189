# SPDX-License-Identifier: MIT
"""Tests of synth/limits.py and synth/area/area_limits.py: which pins exceed a limit of the library,
and how a netlist is changed for it. tb/synth/limits maps whole designs."""
from __future__ import annotations

import json
import os
import unittest
from typing import Any, List
from unittest import mock

from loading import load

load("synth/common.py")
limits = load("synth/limits.py")
area_limits = load("synth/area/area_limits.py")


def pin(direction: str, **more: Any) -> dict:
    return {"direction": direction, "function": None, "capacitance": None, **more}


def gate(function: str, area: float, **limit: float) -> dict:
    return {"area": area, "state": [],
            "pins": {"A": pin("input", capacitance=2),
                     "Z": pin("output", function=function, **limit)}}


CELLS = {
    "INV_X1": gate("!A", 1, max_capacitance=10), "INV_X2": gate("!A", 2, max_capacitance=20),
    "INV_X8": gate("!A", 8, max_capacitance=80), "BUF_X1": gate("A", 2, max_capacitance=10),
    "BUF_X2": gate("A", 3, max_capacitance=20, max_fanout=3),
    "DFF_X1": {"area": 5, "state": [{"kind": "ff", "clocked_on": "CK", "next_state": "D"}],
               "pins": {"D": pin("input", capacitance=1), "CK": pin("input", capacitance=1),
                        "Q": pin("output", function="IQ", max_capacitance=10)}}}
LIBRARY = {"cells": CELLS, "capacitance_unit_f": 1e-15}
SAID = """output u/a\\[0\\]/Z INV_X1 1.2e-14 4
output b/Z BUF_X2 1e-14 4
output c/Z INV_X8 8e-15 70
max_transition

Pin          Limit     Trans     Slack
u/a\\[0\\]/Z  198.5350  136.6143   61.9207 (MET)
"""


class Judged(unittest.TestCase):
    def test_worst_and_over(self) -> None:
        summary, over = limits.judged(SAID, LIBRARY)
        self.assertEqual(summary, {
            "capacitance": {"worst": 1.2, "pin": "u/a[0]/Z", "over": 1},
            "transition": {"worst": 0.6881, "pin": "u/a[0]/Z", "over": 0},
            "fanout": {"worst": 1.3333, "pin": "b/Z", "over": 1}})
        self.assertEqual([(one.kind, one.pin) for one in over],
                         [("fanout", "b/Z"), ("capacitance", "u/a[0]/Z")])

    def test_nearly_over(self) -> None:
        near = "output c/Z INV_X8 7.9e-14 70\n"
        self.assertEqual(limits.judged(near, LIBRARY)[1], [])
        summary, over = limits.judged(near, LIBRARY, 0.98)
        self.assertEqual((summary["capacitance"]["over"], len(over)), (0, 1))

    def test_late_slopes(self) -> None:
        late = "".join(f"d/{name}  500.0000  502.5216   -2.5216 (VIOLATED)\n" for name in "ZA")
        summary, over = limits.judged("max_transition\n" + late + late, LIBRARY)
        self.assertEqual(summary["transition"], {"worst": 1.005, "pin": "d/Z", "over": 2})
        self.assertEqual(len(over), 2)

    def test_no_limits(self) -> None:
        self.assertEqual(limits.judged("", LIBRARY)[0],
                         {"capacitance": None, "transition": None, "fanout": None})

    def test_a_cell_of_another_library(self) -> None:
        with self.assertRaisesRegex(limits.Failed, "no cell NAND9"):
            limits.judged("output a/Z NAND9 1e-15 1", LIBRARY)


def netlist(readers: int, kind: str = "INV_X1", driver: str = "INV_X1") -> Any:
    """A module `part` whose cell g drives readers and, through a port, an inverter of the top."""
    cells = {"g": {"type": driver, "connections": {"A": [2], "Z": [3]}}}
    for i in range(readers):
        cells[f"r{i}"] = {"type": kind, "connections": {
            "CK" if kind == "DFF_X1" else "A": [3], "Z": [10 + i]}}
    return {"modules": {
        "part": {"ports": {"a": {"direction": "input", "bits": [2]},
                           "y": {"direction": "output", "bits": [3]}},
                 "cells": cells, "netnames": {"y": {"bits": [3]}, "z": {"bits": [29]}}},
        "top": {"ports": {}, "netnames": {"n": {"bits": [5, 6, 7]}}, "cells": {
            "u": {"type": "part", "connections": {"a": [4], "y": [5]}},
            "v": {"type": "part", "connections": {"a": [5], "y": [6]}},
            "i": {"type": "INV_X1", "connections": {"A": [5], "Z": [7]}}}}}}


class Mended(unittest.TestCase):
    def mend(self, design: Any, kind: str, value: float, path: str = "u/g/Z") -> int:
        mender = area_limits.Mender(design, "top", CELLS, 2)
        return mender.mend([limits.Reached(kind, path, value, 10)])

    def test_sizes(self) -> None:
        for kind, value, wanted in (("capacitance", 12, "INV_X2"), ("capacitance", 30, "INV_X8"),
                                    ("capacitance", 300, "INV_X8"), ("transition", 12, "INV_X2")):
            design = netlist(2)
            self.assertEqual(self.mend(design, kind, value), 1)
            self.assertEqual(design["modules"]["part"]["cells"]["g"]["type"], wanted)

    def test_a_register_is_no_inverter(self) -> None:
        self.assertEqual(area_limits.larger_cells(CELLS)["DFF_X1"], [])
        self.assertEqual(area_limits.larger_cells(CELLS)["INV_X1"], ["INV_X2", "INV_X8"])

    def test_once_for_all_instances(self) -> None:
        design = netlist(2)
        over = [limits.Reached("transition", path, 12, 10)
                for path in ("v/g/Z", "u/g/Z", "u/r0/A", "i/A")]
        self.assertEqual(area_limits.Mender(design, "top", CELLS, 2).mend(over), 1)
        self.assertEqual(design["modules"]["part"]["cells"]["g"]["type"], "INV_X2")

    def connected(self, design: Any, module: str = "part") -> List[Any]:
        return sorted((name, cell["connections"]) for name, cell in
                      design["modules"][module]["cells"].items() if name[0] in "gf")

    def test_a_port_stays(self) -> None:
        design = netlist(2)
        self.assertEqual(self.mend(design, "fanout", 12), 1)
        self.assertEqual(self.connected(design), [
            ("fanout_30_limit", {"A": [3], "Z": [30]}), ("g", {"A": [2], "Z": [3]})])
        cells = design["modules"]["part"]["cells"]
        self.assertEqual([cells[name]["connections"]["A"] for name in ("r0", "r1")], [[30], [30]])

    def test_half_of_the_load(self) -> None:
        design = netlist(4)
        design["modules"]["part"]["ports"].pop("y")
        design["modules"]["top"]["cells"] = {"u": design["modules"]["top"]["cells"]["u"]}
        self.assertEqual(self.mend(design, "capacitance", 12), 1)  # a larger cell first
        self.mend(design, "fanout", 12)
        cells = design["modules"]["part"]["cells"]
        self.assertEqual([cells[f"r{i}"]["connections"]["A"][0] for i in range(4)],
                         [3, 3, 30, 30])

    def test_groups(self) -> None:
        design = netlist(6)
        design["modules"]["part"]["ports"].pop("y")
        design["modules"]["top"]["cells"] = {"u": design["modules"]["top"]["cells"]["u"]}
        self.mend(design, "fanout", 25)
        cells = design["modules"]["part"]["cells"]
        self.assertEqual([cells[f"r{i}"]["connections"]["A"][0] for i in range(6)],
                         [3, 3, 30, 30, 31, 31])
        self.assertEqual(self.connected(design), [
            ("fanout_30_limit", {"A": [3], "Z": [30]}), ("fanout_31_limit", {"A": [3], "Z": [31]}),
            ("g", {"A": [2], "Z": [3]})])

    def test_only_a_port(self) -> None:
        design = netlist(0, driver="BUF_X2")
        design["modules"]["top"]["cells"].pop("i")
        self.assertEqual(self.mend(design, "capacitance", 30), 1)
        self.assertEqual(self.connected(design), [
            ("fanout_30_limit", {"A": [30], "Z": [3]}), ("g", {"A": [2], "Z": [30]})])

    def test_where_it_is_read(self) -> None:
        design = netlist(0, driver="BUF_X2")
        self.assertEqual(self.mend(design, "fanout", 12), 1)
        self.assertEqual(self.connected(design, "top"), [
            ("fanout_8_limit", {"A": [5], "Z": [8]})])
        cells = design["modules"]["top"]["cells"]
        self.assertEqual(cells["v"]["connections"]["a"] + cells["i"]["connections"]["A"], [5, 8])

    def test_inside_of_what_reads_it(self) -> None:
        design = netlist(3)
        self.assertEqual(self.mend(design, "fanout", 12, "u/g/Z"), 1)
        design["modules"]["top"]["cells"]["d"] = {
            "type": "BUF_X2", "connections": {"A": [8], "Z": [4]}}
        design["modules"]["part"]["cells"]["g2"] = {
            "type": "INV_X1", "connections": {"A": [2], "Z": [40]}}
        self.assertEqual(self.mend(design, "fanout", 12, "d/Z"), 1)
        cells = design["modules"]["part"]["cells"]
        self.assertEqual([cells[name]["connections"]["A"] for name in ("g", "g2")], [[2], [31]])

    def test_clocks_are_not_split(self) -> None:
        design = netlist(3, "DFF_X1")
        before = json.dumps(design)
        self.assertEqual(self.mend(design, "fanout", 12), 0)
        self.assertEqual(json.dumps(design), before)


class Corners(unittest.TestCase):
    def test_beside_the_typical_one(self) -> None:
        common = load("synth/common.py")
        there = {"/p/cells_slow.lib.gz", "/p/other_typ.lib", "/typ/fast.lib"}
        with mock.patch.object(os, "access", lambda file, _: file in there):
            self.assertEqual(common.other_corners("/p/cells_typ.lib.gz"), ["/p/cells_slow.lib.gz"])
            self.assertEqual(common.other_corners("/typ/fast.lib"), [])


if __name__ == "__main__":
    unittest.main()
