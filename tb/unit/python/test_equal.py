# SPDX-License-Identifier: MIT
"""Tests of tb/mutation/hardware/equal and equal_netlist.py: texts made of a netlist, and the
order of proofs with a Yosys and an ABC that are made up. tb/mutation/hardware/check runs the
real ones."""
from __future__ import annotations

import contextlib
import io
import os
import subprocess
import tempfile
import unittest
from pathlib import Path
from typing import Any, Dict, List, Tuple
from unittest import mock

from loading import load

equal = load("tb/mutation/hardware/equal")
text = equal.netlist_text

NETLIST = r"""module \part
  wire \lost.narrow.free
  cell $and $and$1
  end
end
attribute \keep 1
attribute \top 1
attribute \src "a"
module \sepax_top
  wire width 2 output 3 \long.narrow.core.free
  wire \a.narrow.free
  wire width 3 \b.narrow.x[1].sign
  wire \b.narrow.sign
  wire \other.free
  wire width 4 \a.narrow.slot_q
  wire width 4 \psa.axes[6].proj.inner.sum
  wire \narrow.disjoint_x
  wire \narrow.disjoint_y
  cell $logic_not $not$1
  end
  cell $and $and$1
  end
end
"""


class Netlist(unittest.TestCase):
    def setUp(self) -> None:
        self.lines = text.module_lines(NETLIST, "sepax_top")

    def test_top(self) -> None:
        self.assertEqual(text.top_module(NETLIST), "sepax_top")
        with self.assertRaises(text.Failed):
            text.top_module("module \\a\nend\n")

    def test_lines_of_a_module(self) -> None:
        self.assertEqual(self.lines[0], "module \\sepax_top")
        self.assertNotIn("  wire \\lost.narrow.free", self.lines)
        self.assertEqual(text.module_lines(NETLIST, "part")[1], "  wire \\lost.narrow.free")

    def test_the_first_cell_of_a_name_counts(self) -> None:
        self.assertEqual(text.cell_types(NETLIST), {"$and$1": "$and", "$not$1": "$logic_not"})

    def test_cut_the_shortest_wire(self) -> None:
        self.assertEqual(text.cut(self.lines, "sepax_top", ["free", "none"]),
                         ["expose -cut w:a.narrow.free"])
        self.assertEqual(text.cut(self.lines, "sepax_narrow", ["free"]),
                         ["expose -cut w:other.free"])

    def test_cut_all_signs(self) -> None:
        self.assertEqual(text.cut(self.lines, "sepax_top", ["signs"]),
                         ["expose -cut w:b.narrow.x?1?.sign", "expose -cut w:b.narrow.sign"])

    def test_overlapping(self) -> None:
        self.assertEqual(text.overlapping(self.lines, "sepax_top", "--ii=9 --early-out=boxes"),
                         ["expose w:a.narrow.slot_q"])
        self.assertEqual(
            text.overlapping(["  wire \\a.narrow.disjoint_x", "  wire \\narrow.disjoint_z"],
                             "sepax_top", "--ii=1 --word=4 --early-out=boxes"),
            ["expose -cut w:a.narrow.disjoint_x", "expose -cut w:narrow.disjoint_z"])

    def test_projections(self) -> None:
        self.assertEqual(text.projections(self.lines)[0],
                         "expose -cut w:psa.axes?6?.proj.inner.sum")
        self.assertEqual(len(text.projections([])), 2)

    def test_memories(self) -> None:
        def memory(words: int, bits: int, name: str) -> List[str]:
            return f"""  cell $mem_v2 \\{name}
    parameter \\SIZE {words}
    parameter \\WIDTH {bits}
    connect \\RD_CLK \\clk
    connect \\RD_DATA {{ \\{name}_q [3:0] $read${name} }}
    connect \\WR_ADDR \\{name}[1]_a
    connect \\WR_DATA {{ \\{name}_q 4'0000 }}
  end
    connect \\RD_DATA \\outside""".splitlines()

        self.assertEqual(text.memories(memory(64, 1, "m")), [
            "expose w:m?1?_a", "expose w:m_q", "rename $read$m memory_1",
            "expose -input w:memory_1"])
        self.assertEqual(text.memories(memory(63, 7, "m")), [])
        self.assertEqual(len(text.memories(memory(50, 10, "m") + memory(4, 1, "n"))), 4)


class Mutants(unittest.TestCase):
    def test_absorbed(self) -> None:
        types = {"or": "$reduce_bool", "not": "$logic_not", "and": "$reduce_and", "add": "$add"}
        for mode, cell, port, is_absorbed in (
                ("cnot1", "or", "A", True), ("cnot1", "not", "B", True),
                ("cnot0", "or", "A", False), ("cnot0", "and", "A", True),
                ("cnot1", "and", "A", False),
                ("cnot1", "add", "A", False), ("cnot1", "or", "Y", False),
                ("cnot1", "gone", "A", False), ("inv", "or", "A", False)):
            line = f"mutate -mode {mode} -module \\m -cell {cell} -port {port} -portbit 0"
            self.assertEqual(text.absorbed(line, types), is_absorbed, line)

    def test_large_memories(self) -> None:
        self.assertTrue(text.in_large_memory("mutate -mode inv -cell \\a.word_q -port A"))
        self.assertFalse(text.in_large_memory("mutate -mode inv -cell \\a.word_qq -port A"))
        self.assertFalse(text.in_large_memory("mutate -mode inv -cell \\a_word_q -port A"))

    def test_source_line(self) -> None:
        line = "mutate -mode const0 -cell c -port A -portbit 1 -src sepax_x.v:31.7-31.9"
        self.assertEqual(text.source_line(line), ["sepax_x.v", "31"])
        self.assertIsNone(text.source_line(line.replace("const0", "const1")))
        self.assertIsNone(text.source_line(line.replace("-port A", "-port B")))

    def test_lines_where_lone_counts(self) -> None:
        for line in ("  flat <= {g_own, g_a, g_b} == 40'd0;", "flat = {g_own, g_a, g_b} == 40'd0",
                     "  x = ({s, w, d} == 30'd0);"):
            self.assertIsNotNone(text.ALONE.search(line), line)
        self.assertIsNone(text.ALONE.search("flat <= {g_own, g_a} == 40'd0"))

    def test_mutants_of_paper_that_are_tried(self) -> None:
        for place, is_tried in (("cmp.v:1", 1), ("cop.v:1", 1), ("nand.v:2", 1), ("input.v:39", 1),
                                ("input.v:40", 0), ("proj.v:1", 0)):
            found = text.PROJECTION.search(f"mutate -mode inv -src sepax_{place}")
            self.assertEqual(bool(found), bool(is_tried), place)


def port(direction: str, width: int = 1) -> Dict[str, Any]:
    return {"direction": direction, "bits": list(range(width))}


class Miter(unittest.TestCase):
    def miter(self, **ports: Dict[str, Any]) -> List[str]:
        return text.miter({name.replace("__", "."): p for name, p in ports.items()}).splitlines()

    def test_a_core(self) -> None:
        self.assertEqual(self.miter(clk=port("input"), rst=port("input"), mutant=port("input", 16),
                                    y=port("output", 3)), [
            "`default_nettype none",
            "module miter(differ, \\clk , \\rst );",
            "  output wire differ;",
            "  input wire [0:0] \\clk ;",
            "  input wire [0:0] \\rst ;",
            "  wire [2:0] \\y_0 , \\y_1 ;",
            "  reg begun = 1'b0;",
            "  reg [15:0] mutant = 16'd0;",
            "  always @(posedge clk) mutant <= mutant;",
            "  mutants m0(.mutant(16'd0), .\\clk (\\clk ), .\\rst (\\rst ), .\\y (\\y_0 ));",
            "  mutants m1(.mutant(mutant), .\\clk (\\clk ), .\\rst (\\rst ), .\\y (\\y_1 ));",
            "  always @(posedge clk) begun <= begun || rst;",
            "  assign differ = begun && (1'b0 || \\y_0 != \\y_1 );",
            "endmodule"])

    def test_an_engine(self) -> None:
        lines = self.miter(aclk=port("input"))
        self.assertIn("  always @(posedge aclk) begun <= begun || !aresetn;", lines)

    def test_a_part_without_a_reset(self) -> None:
        self.assertIn("  always @(posedge clk) begun <= begun || 1'b1;", self.miter())

    def test_both_read_what_the_design_says(self) -> None:
        lines = self.miter(a__free__i=port("input"), a__again__i=port("input"))
        self.assertIn("  mutants m1(.mutant(mutant), .\\a.free.i (\\a.free_0 ), "
                      ".\\a.again.i (\\a.again_0 ));", lines)

    def test_disjoint_boxes(self) -> None:
        lines = self.miter(a__disjoint_x__i=port("input"), a__disjoint_x=port("output"),
                           narrow__slot_q=port("output", 4))
        self.assertIn("m0(.mutant(16'd0), .\\a.disjoint_x.i (1'b0), .", "\n".join(lines))
        self.assertEqual(lines[-2], "  assign differ = begun && (1'b0 || \\narrow.slot_q_0 != "
                         "\\narrow.slot_q_1  || (\\narrow.slot_q_0 [3] && "
                         "\\a.disjoint_x_0 < \\a.disjoint_x_1 ));")

    def test_projections_of_the_faces_normals(self) -> None:
        name = "psa[3].proj.vertex[2].inner.sum.i"
        verilog = text.miter({name: port("input", 5)})
        self.assertIn(f"  input wire [4:0] \\{name} ;\n", verilog)
        self.assertIn(f".\\{name} (\\{name} )", verilog)

    def test_projections_of_the_ends_of_an_edge(self) -> None:
        def line(n: int, k: int) -> str:
            verilog = text.miter({f"axes[{n}].proj.vertex[{k}].inner.sum.i": port("input", 5)})
            return next(part for part in verilog.splitlines() if "idle_0" in part)

        def expected(n: int, name: str, table: int, edge: int, before: int, own: int) -> str:
            of = [f"\\axes[{n}].proj.vertex[{k}].inner.sum.i " for k in (before, own)]
            return (f"  wire [4:0] \\axes{name} = (\\axes[6].cmp.idle_0 ? {table} : {edge}) ? "
                    f"{of[0]} : {of[1]};")

        self.assertEqual(line(0, 1), expected(0, "010", 1, 1, 0, 1))
        self.assertEqual(line(1, 1), expected(1, "110", 0, 1, 0, 1))
        self.assertEqual(line(4, 5), expected(4, "421", 1, 1, 4, 5))
        self.assertEqual(line(5, 3), expected(5, "501", 1, 1, 5, 3))
        self.assertEqual(line(5, 4), expected(5, "511", 0, 0, 3, 4))
        self.assertEqual(line(1, 5), expected(1, "121", 0, 1, 4, 5))
        self.assertEqual(line(8, 3), expected(8, "801", 1, 1, 5, 3))
        self.assertEqual(line(8, 2), expected(8, "820", 0, 0, 1, 2))

    def test_coplanar_counts_with_a_word(self) -> None:
        lines = self.miter(cop__coplanar=port("output"), a__idle=port("output", 2))
        self.assertIn("  wire [1:0] \\a.idle_0 , \\a.idle_1 ;", lines)
        self.assertIn("  assign differ = begun && (1'b0 || (\\words.step_0 [5:3] != 0 && "
                      "\\cop.coplanar_0 != \\cop.coplanar_1 ));", lines)


class Files(unittest.TestCase):
    def test_shared_registers(self) -> None:
        blif = (".inputs clk\n.outputs differ\n.latch a m0.r re clk 0\n.latch b m1.r re clk 0\n"
                ".latch c m0.s 0\n.latch d m1.s 0\n.latch e begun 0\n.end\n")
        self.assertEqual(text.share(blif).splitlines(), [
            ".inputs clk", ".latch a m0.r re clk 0", ".names m0.r m1.r", "1 1",
            ".names a b other1", "10 1", "01 1", ".names differ other1 any1", "1- 1", "-1 1",
            ".latch c m0.s 0", ".names m0.s m1.s", "1 1", ".names c d other2", "10 1", "01 1",
            ".names any1 other2 any2", "1- 1", "-1 1", ".latch e begun 0", ".outputs any2", ".end"])

    def test_no_registers(self) -> None:
        self.assertEqual(text.share(".outputs a\n.end\n"), ".outputs differ\n.end\n")
        with self.assertRaisesRegex(text.Failed, "no register r"):
            text.share(".latch b m1.r 0\n.end\n")

    def test_the_number_begins(self) -> None:
        aiger = (b"aig 9 1 4 1 3\n2\n4 0\n6\n8\n20\n\x01\n\x02rest\n"
                 b"l1 mutant[2]\nl3 mutant[0]\nl2 x\n")
        bits = text.number_bits(aiger)
        self.assertEqual(bits, {1: 2, 3: 0})
        self.assertEqual(text.begun(aiger, bits, 5),
                         aiger.replace(b"\n4 0\n", b"\n4 1\n").replace(b"\n8\n", b"\n8 1\n"))
        self.assertEqual(text.begun(aiger, bits, 1).split(b"\n")[1:5], [b"2", b"4 0", b"6", b"8 1"])
        with self.assertRaises(text.Failed):
            text.begun(b"", bits, 1)


PROVED = "Property proved.\n"
DIFFERS = "Output 0 of miter \"a\" was asserted in frame 7.  Time\n"


class Script(unittest.TestCase):
    """A folder of mutants. `said` is what ABC says of each mutant, one try after the other."""

    def setUp(self) -> None:
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = Path(folder.name)
        (self.root / "rtl").mkdir()
        self.write("netlist.il", NETLIST)
        self.write("rtl/sample", "400 1 --word=4 --ii=9")
        self.write("mutants", "mutate -mode inv -cell \\a -port A\n" * 3)
        self.said: Dict[int, List[str]] = {}
        self.miters: List[Tuple[List[str], List[int]]] = []

    def write(self, name: str, content: str) -> None:
        (self.root / name).write_text(content)

    def run_equal(self, *arguments: str) -> Tuple[int, str, str]:
        """Exit status, standard output and standard error."""
        out, err = io.StringIO(), io.StringIO()
        tried: List[int] = []
        case = self

        def miter(self: Any, cuts: List[str], numbers: List[int]) -> None:
            case.miters.append((cuts, list(numbers)))
            self.bits = {"miter": {}, "shared": {}}
            for name in self.bits:
                (self.tools.work / f"{name}.aig").write_bytes(name.encode())

        def begun(aiger: bytes, bits: Dict[int, int], number: int) -> bytes:
            tried.append(number)
            return aiger

        def prove(self: Any, commands: str) -> str:
            case.commands.append(commands)
            left = case.said.get(tried[-1], [])
            return left.pop(0) if left else "no\n"

        self.commands: List[str] = []
        with mock.patch("sys.argv", ["equal", *arguments]), \
                mock.patch.object(equal.Equal, "miter", miter), \
                mock.patch.object(equal.netlist_text, "begun", begun), \
                mock.patch.object(equal.Tools, "prove", prove), \
                mock.patch.object(equal.shutil, "which", lambda name: name), \
                contextlib.redirect_stdout(out), contextlib.redirect_stderr(err):
            status = equal.main()
        return status, out.getvalue(), err.getvalue()

    def test_usage(self) -> None:
        for arguments, words in (((), "usage: equal [-q]"), (("-z", "a"), "-z not recognized"),
                                 ((str(self.root), "x"), "'x' is no number of a mutant"),
                                 ((str(self.root), "4"), "has no mutant 4"),
                                 ((str(self.root), "0"), "has no mutant 0"),
                                 (("/no/such", "1"), "netlist.il cannot be read")):
            status, out, err = self.run_equal(*arguments)
            self.assertEqual((status, out, err.count("\n")), (2, "", 1), err)
            self.assertIn(words, err)

    def test_effort(self) -> None:
        with mock.patch.dict(os.environ, {"EFFORT": "ten"}):
            self.assertEqual(self.run_equal(str(self.root), "1")[0], 2)
        with mock.patch.dict(os.environ, {"EFFORT": ""}):
            self.run_equal(str(self.root), "1")
            self.assertEqual(self.commands[:2], [
                "scorr; pdr -T 10", "lcorr; scorr; bmc3 -T 30 -F 40; pdr -T 30"])
            self.assertEqual(equal.effort_of(True), 1)

    def test_nothing_to_do(self) -> None:
        self.assertEqual(self.run_equal("/no/such"), (0, "", ""))
        self.assertEqual(self.miters, [])

    def test_both_tries(self) -> None:
        self.said = {1: [PROVED], 2: ["no\n", PROVED], 3: [DIFFERS, DIFFERS]}
        status, out, _ = self.run_equal(str(self.root), "1", "2", "3")
        self.assertEqual((status, out), (
            0, "1 equivalent, by what goes into its registers\n"
            "2 equivalent, by scorr and pdr\n3 differs in cycle 7\n"))
        self.assertEqual((self.root / "equal-3").read_text(), "differs in cycle 7\n")
        self.assertEqual(len(self.miters), 1)

    def test_with_any_outputs_of_the_core(self) -> None:
        self.said = {1: [PROVED], 2: ["", "", DIFFERS, "proved unreachable\n"],
                     3: ["", "", "", "", DIFFERS]}
        _, out, _ = self.run_equal(str(self.root), "1", "2", "3")
        self.assertEqual(out, "1 equivalent, by what goes into its registers\n"
                         "2 equivalent, by what goes into its registers, "
                         "with any outputs of the core\n3 open\n")
        self.assertEqual(self.miters[1][1], [2, 3])
        self.assertEqual(self.miters[1][0], [
            "expose w:a.narrow.slot_q", "expose -cut w:a.narrow.free",
            "expose -cut w:b.narrow.x?1?.sign", "expose -cut w:b.narrow.sign"])

    def test_quick(self) -> None:
        self.said = {1: [PROVED], 2: [DIFFERS]}
        _, out, _ = self.run_equal("-q", str(self.root), "1", "2", "3")
        self.assertEqual(out, "1 equivalent, by lcorr\n2 differs in cycle 7\n")
        self.assertEqual(self.commands, ["lcorr; pdr -T 1"] * 3)
        self.assertFalse((self.root / "equal-3").exists())

    def test_no_difference_counts_of_an_engine_or_a_part(self) -> None:
        self.said = {1: [DIFFERS]}
        self.assertEqual(self.run_equal("-q", "-p", "part", str(self.root), "1")[1], "")

    def test_no_proof_is_needed(self) -> None:
        self.write("mutants", """mutate -mode cnot1 -module \\m -cell $not$1 -port A -portbit 0
mutate -mode inv -cell \\a.word_q -port A
mutate -mode const0 -cell c -port A -portbit 1 -src sepax_x.v:2.7-31.9
mutate -mode const0 -cell c -port A -portbit 1 -src sepax_x.v:1.7-31.9
mutate -mode const0 -cell c -port A -portbit 1 -src sepax_none.v:1.7-31.9
""")
        self.write("rtl/sepax_x.v", "flat\n  assign x = ({s, w, d} == 30'd0);\n")
        status, out, _ = self.run_equal("-q", str(self.root), "1", "2", "3", "4", "5")
        self.assertEqual((status, out), (0, "1 equivalent, by its gate\n2 open\n"
                         "3 equivalent, by tb/mutation/hardware/lone\n"))
        self.assertEqual(self.miters[0][1], [2, 3, 4, 5])

    def test_paper(self) -> None:
        self.write("rtl/sample", "400 1 --arch=paper")
        self.write("mutants", "mutate -mode inv -src sepax_cmp.v:3.1\nmutate -mode inv -src b:1\n")
        self.said = {1: [PROVED]}
        _, out, _ = self.run_equal(str(self.root), "1", "2")
        self.assertEqual(out, "1 equivalent, by scorr and pdr, with any outputs of the projections "
                         "of paper\n")
        self.assertEqual(self.miters[0][1], [1])
        self.assertEqual(self.run_equal(str(self.root), "2")[1], "")
        self.assertEqual(len(self.miters), 1)

    def test_clearance(self) -> None:
        self.write("rtl/sample", "400 1 --clearance=2")
        self.run_equal(str(self.root), "1")
        self.assertEqual(self.miters[1][0][1:], ["expose -cut w:a.narrow.free"])


class Tools(unittest.TestCase):
    def setUp(self) -> None:
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.work = Path(folder.name)
        with mock.patch.object(equal.shutil, "which", lambda name: name):
            self.tools = equal.Tools(self.work, 1)

    def script(self, commands: str) -> str:
        file = self.work / "tool"
        file.write_text("#!/bin/sh\n" + commands)
        file.chmod(0o755)
        return str(file)

    def test_no_abc(self) -> None:
        with mock.patch.object(equal.shutil, "which", lambda name: None), \
                self.assertRaises(equal.BadInput):
            equal.Tools(self.work, 1)

    def test_yosys_fails(self) -> None:
        tool = self.script('{ seq 4; echo; echo 5; } > "$3"; exit 1')
        with mock.patch.dict(os.environ, {"YOSYS": tool}):
            with self.assertRaisesRegex(text.Failed, "^yosys: 3; 4; 5$"):
                self.tools.yosys("-p", "x")

    def test_abc_makes_no_file(self) -> None:
        self.tools.abc = self.script("exit 0")
        with self.assertRaisesRegex(text.Failed, "does not read miter.blif"):
            self.tools.aiger("miter")

    def test_what_abc_says(self) -> None:
        self.tools.abc = self.script('cat "$2"; echo said')
        self.assertEqual(self.tools.prove("pdr"), f"read_aiger {self.work}/one.aig; strash; "
                         "scleanup; pdr\nsaid\n")

    def test_abc_is_ended(self) -> None:
        ended = subprocess.TimeoutExpired("abc", 5)
        with mock.patch.object(equal.subprocess, "run", side_effect=ended) as run:
            self.assertEqual(self.tools.prove("pdr"), "")
        self.assertEqual(run.call_args.kwargs["timeout"], 5)


if __name__ == "__main__":
    unittest.main()
