# SPDX-License-Identifier: MIT
"""Tests of synth/multivt/swap: chosen cells change their type, legally, and nothing else does."""
import copy
import unittest

from loading import load

swap = load("synth/multivt/swap")

NETLIST = {"modules": {"top": {"cells": {
    "a": {"type": "NAND2", "connections": {"A": [2]}},
    "b": {"type": "NAND2", "connections": {"A": [3]}},
    "c": {"type": "DFF", "connections": {"D": [4]}}}}}}
LEGAL = {"NAND2": {"cell": "NAND2_LL"}}


class Swap(unittest.TestCase):
    """One netlist."""

    def setUp(self):
        self.netlist = copy.deepcopy(NETLIST)

    def test_types_change_and_nothing_else(self):
        self.assertEqual(swap.swap(self.netlist, {"b"}, LEGAL), ["b NAND2 NAND2_LL\n"])
        wanted = copy.deepcopy(NETLIST)
        wanted["modules"]["top"]["cells"]["b"]["type"] = "NAND2_LL"
        self.assertEqual(self.netlist, wanted)
        self.assertEqual(swap.types_of(self.netlist), {"NAND2": 1, "NAND2_LL": 1, "DFF": 1})

    def test_what_is_not_legal(self):
        with self.assertRaisesRegex(swap.Failed, "not a legal swap: c DFF"):
            swap.swap(self.netlist, {"c"}, LEGAL)

    def test_a_cell_that_is_not_there(self):
        with self.assertRaisesRegex(swap.Failed, "1 of the chosen cells are not in the netlist"):
            swap.swap(self.netlist, {"a", "z"}, LEGAL)


if __name__ == "__main__":
    unittest.main()
