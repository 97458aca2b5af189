# SPDX-License-Identifier: MIT
"""Tests of synth/netlist_verilog.py: names, ports, constants and outputs that are inputs."""
import unittest

from loading import load

netlist_verilog = load("synth/netlist_verilog.py")

NETLIST = {"modules": {"top": {
    "ports": {"a": {"direction": "input", "bits": [2]},
              "b": {"direction": "input", "bits": [3, 4]},
              "y": {"direction": "output", "bits": [5]},
              "z": {"direction": "output", "bits": [2, "1", 6]}},
    "cells": {"u.x[0]": {"type": "NAND2", "connections": {"A": [2], "B": [3], "Y": [5]}},
              "v": {"type": "INV", "connections": {"A": ["0"], "Y": [6]}},
              "w": {"type": "INV", "connections": {"A": [4], "Y": [7]}}},
    "netnames": {"a": {"bits": [2]}, "b": {"bits": [3, 4]}, "y": {"bits": [5]},
                 "inner.q": {"bits": [6]}}}}}


class Verilog(unittest.TestCase):
    """The lines of a small module."""

    def setUp(self):
        self.lines = "".join(netlist_verilog.verilog(NETLIST, "top")).split("\n")

    def test_ports(self):
        self.assertEqual(self.lines[:5], ["module top (a, b, y, z);", "  input a;",
                                          "  input [1:0] b;", "  output y;", "  output [2:0] z;"])

    def test_cells(self):
        self.assertIn("  NAND2 \\u.x[0]  (.A(a), .B(b[0]), .Y(y));", self.lines)
        self.assertIn("  INV v (.A(1'b0), .Y(\\inner.q ));", self.lines)
        self.assertIn("  INV w (.A(b[1]), .Y(net_7_));", self.lines)

    def test_wires_and_assignments(self):
        self.assertIn("  wire \\inner.q ;", self.lines)
        self.assertIn("  wire net_7_;", self.lines)
        self.assertNotIn("  wire y;", self.lines)
        for line in ("  assign z[0] = a;", "  assign z[1] = 1'b1;", "  assign z[2] = \\inner.q ;"):
            self.assertIn(line, self.lines)


if __name__ == "__main__":
    unittest.main()
