# SPDX-License-Identifier: MIT
"""Tests of synth/timing/corner: what OpenSTA says, and its critical path by modules and signals."""
import unittest

from loading import load

corner = load("synth/timing/corner")

NETLIST = {"modules": {
    "top": {"ports": {}, "cells": {
        "core.x": {"type": "core", "connections": {}},
        "_3_": {"type": "INV", "connections": {"A": [2], "ZN": [3]}}},
        "netnames": {"_wire_": {"bits": [9]}, "out": {"bits": [2, 3]}}},
    "core": {"ports": {}, "cells": {
        "_1_": {"type": "DFF", "connections": {"D": [5], "Q": [6]}},
        "_2_": {"type": "NAND", "connections": {"A": [6], "ZN": [7]}}},
        "netnames": {"state_q": {"bits": [6]}, "_7_": {"bits": [7]}}}}}
NAMES = [{"plain": "core", "readable": "core (N=2)"}]
LOG = r"""clocked 1
loads 12
endpoint 2.5e-01 core.x/_1_/D
endpoint -1e-1 out[1]
constant y
hold 0.0812345

path
Startpoint: core.x/_1_
   0.0000    0.0000   clock clk (rise edge)
   0.0000    0.0000 ^ core\.x/_1_/CK (DFF)
   0.1500    0.1500 v core\.x/_1_/Q (DFF)
   0.1000    0.2500 ^ core\.x/_2_/ZN (NAND)
   0.0500    0.3000 v _3_/ZN (INV)
   0.0000    0.3000 v out[1] (out)
             0.3000   data arrival time
path done
least 0.75 0.000000e+00
end
"""


class Corner(unittest.TestCase):
    """A log and its netlist."""

    def setUp(self):
        self.netlist = corner.Netlist(NETLIST, NAMES)

    def test_numbers(self):
        found = corner.corner(LOG, self.netlist, "x.lib", 0.7)
        self.assertEqual([found[key] for key in (
            "slack_ns", "least_period_ns", "fmax_mhz", "hold_slack_ns", "endpoints",
            "constant_endpoints", "late_endpoints", "most_loads")],
            [-0.05, 0.75, 1333.3, 0.0812, 2, 1, 1, 12])

    def test_path_by_instances(self):
        path = corner.corner(LOG, self.netlist, "x.lib", 1)["critical_path"]
        self.assertEqual(path["from"], {"instance": "core.x", "module": "core (N=2)",
                                        "signal": "state_q"})
        self.assertEqual(path["to"], {"instance": "", "module": "top", "signal": "out[1]"})
        self.assertEqual(path["steps"], [
            {"instance": "core.x", "module": "core (N=2)", "signal": "state_q", "ns": 0.25,
             "cells": 2},
            {"instance": "", "module": "top", "signal": "out[1]", "ns": 0.05, "cells": 1}])

    def test_no_path(self):
        with self.assertRaisesRegex(corner.Failed, "no path"):
            corner.corner("\npath\ndata arrival time", self.netlist, "x.lib", 1)

    def test_two_tops(self):
        with self.assertRaisesRegex(corner.Failed, "several top modules"):
            corner.Netlist({"modules": {"a": {"cells": {}}, "b": {"cells": {}}}}, [])


if __name__ == "__main__":
    unittest.main()
