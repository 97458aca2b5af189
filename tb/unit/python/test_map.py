# SPDX-License-Identifier: MIT
"""Tests of synth/area/map, of the modules beside it and of synth/common.py: what they decide
without Yosys and OpenSTA. tb/synth/netlist and tb/synth/timing map whole designs."""
from __future__ import annotations

import contextlib
import gzip
import io
import json
import os
import tempfile
import unittest
from pathlib import Path
from typing import Any, Dict, Tuple
from unittest import mock

from loading import PROJECT, load

common = load("synth/common.py")
library = load("synth/area/area_library.py")
efforts = load("synth/area/area_efforts.py")
area_map = load("synth/area/map")
Failed = area_map.Failed


class Folder(unittest.TestCase):
    """A folder with a small design and a small library."""

    def setUp(self) -> None:
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = Path(folder.name)
        self.write("rtl/sepax.f", "sepax_fa.v\nsepax_top.v\n")
        self.write("rtl/sepax_fa.v", "module sepax_fa #(parameter N = 8) ();\nendmodule\n")
        self.write("rtl/sepax_top.v", "  module sepax_top ();\nendmodule\n")
        self.describe("--word=4")
        self.write("lib.lib", "library")
        self.tool("liberty", """echo '{"cells": {"NAND2": {"area": 1}}}'""")
        environment = {"BUILD": str(self.root), "SEPAX": str(self.root / "sepax"),
                       "YOSYS": "true", "STA": "true"}
        patch = mock.patch.dict(os.environ, environment)
        patch.start()
        self.addCleanup(patch.stop)

    def write(self, name: str, text: str) -> Path:
        file = self.root / name
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text)
        return file

    def tool(self, name: str, script: str) -> None:
        self.write(name, f"#!/bin/sh\n{script}\n").chmod(0o755)

    def describe(self, design_options: str, **more: Any) -> None:
        self.write("rtl/sepax.json", json.dumps({"options": design_options, **more}))

    def run_map(self, *arguments: str) -> Tuple[int, str]:
        """Exit status and standard error."""
        err = io.StringIO()
        with mock.patch("sys.argv", ["map", *arguments]), contextlib.redirect_stderr(err):
            return area_map.main(), err.getvalue()

    def design(self, **given: str) -> Any:
        """A design that has begun."""
        options = {"o": str(self.root / "out"), "l": str(self.root / "lib.lib"), **given}
        design = area_map.Design(options, str(self.root / "rtl"))
        design.begin()
        return design


class Adders(Folder):
    def is_ripple(self, period: str, cell: str = "FA_X1") -> bool:
        """Whether additions are chains of full adders."""
        design = self.design(p=period)
        design.cells = {"NAND2": {"area": 1}, cell: {"area": 2}}
        commands = str(design.synthesis())
        self.assertEqual("ripple_adder.v" in commands, (design.out / "ripple_adder.v").is_file())
        (design.out / "ripple_adder.v").unlink(missing_ok=True)
        return "ripple_adder.v" in commands

    def test_where_the_clock_has_time(self) -> None:
        self.describe("--word=4 --clock-ns=20", clock_ns=20, adders="ripple")
        self.assertTrue(self.is_ripple("0"))
        self.assertTrue(self.is_ripple("20"))
        self.assertTrue(self.is_ripple("25"))
        self.assertFalse(self.is_ripple("19.9"))
        self.assertFalse(self.is_ripple("20", "NOT"))
        self.describe("--word=4 --clock-ns=20", clock_ns=20)
        self.assertFalse(self.is_ripple("20"))
        self.assertFalse(self.is_ripple("0"))


class Refusals(Folder):
    def refused(self, words: str, *arguments: str) -> None:
        status, said = self.run_map(*arguments)
        self.assertEqual((status, said.count("\n")), (2, 1), said)
        self.assertTrue(said.startswith("map: "), said)
        self.assertIn(words, said)

    def test_usage(self) -> None:
        words = ("usage: synth/area/map [-l LIBERTY] [-c \"LIBERTY ...\"] [-n NAND2] "
                 "[-p PERIOD] [-m SEPAX] [-r ROUNDS] [-g] -o OUT_DIR RTL_DIR\n")
        for arguments in ((), ("a",), ("-o", "a"), ("-z",), ("-o",), ("-o", "a", "b", "c")):
            self.refused(words, *arguments)

    def test_input(self) -> None:
        out, rtl = str(self.root / "out"), str(self.root / "rtl")
        some = ("-l", str(self.root / "lib.lib"), "-o", out)
        self.refused("no/design holds no design (sepax.f, sepax.json)", *some, "no/design")
        self.refused("cannot read the library /no.lib", "-l", "/no.lib", "-o", out, rtl)
        self.refused("cannot make /dev/null/a", *some[:2], "-o", "/dev/null/a", rtl)
        for period in ("x", "-1", "1.2.3", ".", "1e3"):
            self.refused(f"-p {period}: not a period in ns", *some, "-p", period, rtl)
        with mock.patch.dict(os.environ, {"YOSYS": "/no/yosys"}):
            self.refused("/no/yosys not found; run scripts/setup", *some, rtl)
        with mock.patch.dict(os.environ, {"STA": "/no/sta"}):
            self.refused("or give -p 0 for the area alone", *some, "-p", "1", rtl)
        self.write("rtl/sepax.json", "{")
        self.refused("sepax.json is not JSON", *some, rtl)

    def test_libraries(self) -> None:
        some = ("-o", str(self.root / "out"), "-l")
        rtl = str(self.root / "rtl")
        self.write("cut.lib.gz", "no gzip")
        self.refused("is it whole?", *some, str(self.root / "cut.lib.gz"), rtl)
        self.tool("liberty", "echo 'a.lib: line 1: no library' >&2; exit 2")
        self.refused("map: a.lib: line 1: no library\n", *some, str(self.root / "lib.lib"), rtl)
        for cells, words in (("", "has no cells"), ('"INV": {"area": 1}', "no 2-input NAND"),
                             ('"NAND2": {"area": 1}, "sepax_fa": {}', "rename them: sepax_fa")):
            self.tool("liberty", f"""echo '{{"cells": {{{cells}}}}}'""")
            self.refused(words, *some, str(self.root / "lib.lib"), rtl)


class Period(Folder):
    def test_without_a_clock(self) -> None:
        self.describe("--word=4 --clock-ns=2")
        self.assertFalse(self.design().timed)
        self.assertFalse(self.design(p="0").timed)
        self.assertFalse(self.design(p="0.0").timed)

    def test_the_designs_own_in_nangate45(self) -> None:
        self.describe("--word=4 --clock-ns=1.5")
        nangate = self.write("nangate45_typ.lib", "")
        self.assertEqual(self.design(l=str(nangate)).period, "1.5")
        self.assertEqual(self.design(l=str(nangate), p="3").period, "3")
        self.describe("--word=4")
        self.assertEqual(self.design(l=str(nangate)).period, "0")

    def test_scale(self) -> None:
        self.describe("--clock-ns=2", slower=1.5)
        self.assertEqual(self.design(p="4").scale, 3)
        self.describe("--word=4")
        self.tool("sepax", "echo WORD=18 CLOCK_NS=8 II=3")
        self.assertEqual(self.design(p="4").scale, 0.5)
        self.tool("sepax", "exit 1")
        with self.assertRaisesRegex(Failed, "no standard clock"):
            self.design(p="4")

    def test_what_an_earlier_run_left_is_removed(self) -> None:
        left = [self.write(f"out/{name}", "") for name in
                ("area.json", "inside.json", "outside.json", "netlist.v", "yosys.log")]
        other = self.write("out/kept.txt", "")
        self.design()
        self.assertFalse(any(file.exists() for file in left))
        self.assertTrue(other.exists())


class Files(Folder):
    def files(self, cells: Dict[str, Any], **given: str) -> Any:
        design = self.design(**given)
        design.cells = cells
        design.choose_files()
        return design

    def names(self, design: Any) -> list:
        return [Path(file.strip('"')).name for file in design.files]

    def test_as_they_are(self) -> None:
        design = self.files({})
        self.assertEqual((design.top, design.late), ("sepax_top", ""))
        listed = (self.root / "out/files.txt").read_text()
        self.assertEqual(listed, f'"{self.root}/rtl/sepax_fa.v"\n"{self.root}/rtl/sepax_top.v"\n')
        self.assertEqual((self.root / "out/full_adder.v").read_text(), "")

    def test_the_librarys_full_adder(self) -> None:
        design = self.files({"FA_X1": {}})
        self.assertEqual(design.files, ["full_adder.v", f'"{self.root}/rtl/sepax_top.v"'])
        self.assertIn("FA_X1 fa (.A(a[i]), .B(b[i]), .CI(c[i]), .S(sum[i]), .CO(carry[i]));",
                      (self.root / "out/full_adder.v").read_text())

    def test_memories_of_an_engine_are_left_out(self) -> None:
        names = ["sepax_ram.v", "sepax_engine_logic.v", "sepax_engine.v"]
        self.write("rtl/sepax.f", "".join(name + "\n" for name in names))
        for name in names:
            self.write(f"rtl/{name}", "")
        design = self.files({})
        self.assertEqual((design.top, design.late), ("sepax_engine_logic", "read_*"))
        self.assertEqual(self.names(design), ["sepax_engine_logic.v"])

    def test_generated_multipliers(self) -> None:
        self.write("rtl/sepax.f", "sepax_mul.v\nsepax_top.v\n")
        self.write("rtl/sepax_mul.v", "")
        rows = {"vertex": 4, "normal": 4, "normal_product": 8, "axis": 9, "product": 13, "edge": 5,
                "cross_product": 10}
        self.describe("--word=4", formats=[{"name": name, "width": bits, "exact": bits}
                                           for name, bits in rows.items()])

        def make(command: list, **_: Any) -> Any:
            if command[0] == "program":
                folder = Path(command[-1])
                folder.mkdir()
                for name in (f"{folder.name}_biased.v", "sepax_fa.v", "sepax_digit.v"):
                    (folder / name).write_text("")
            return mock.Mock(returncode=command[0] != "program")

        with mock.patch.object(area_map.area_multipliers.subprocess, "run", make):
            design = self.files({}, m="program")
            self.assertEqual([Path(file.strip('"')).name for file in design.files[1:]], [
                "sepax_digit.v", "sepax_fa.v", "sepax_mul.v", "sepax_mul_4x4_biased.v",
                "sepax_mul_5x5_biased.v", "sepax_mul_9x4_biased.v"])
            chosen = (self.root / "out/multipliers/sepax_mul.v").read_text()
            self.assertIn("if (A_W == 4 && B_W == 9 && FULL_W == 13) begin : m_4_9_13\n"
                          "      sepax_mul_9x4 of (.a(b), .b(a), .p(full));", chosen)
            with self.assertRaisesRegex(Failed, "no multipliers; is other the program?"):
                self.files({}, m="other")

    def test_no_multipliers_to_generate(self) -> None:
        self.assertEqual(self.files({}, m="program").multipliers, "")


class Library(unittest.TestCase):
    def test_classes(self) -> None:
        self.assertEqual(library.of_class("memory"), ["sepax_ram"])
        self.assertEqual(library.of_class_one("adder"), "sepax_fa")
        self.assertIn("sepax_digit", library.of_class("dissolved"))

    def test_areas_of_the_lef(self) -> None:
        lef = "MACRO LATCH\n  SIZE 2.4 BY 20 ;\nMACRO FF\n  SIZE 5 BY 20 ;\n"
        liberty = ("cell (LATCH) {\n  area : 0;\n}\n  cell ( FF ) {\n area: 0.00 ;\n"
                   " cell (BUF) {\n area : 0;\n cell (LATCH) {\n area : 0.5;\n")
        self.assertEqual(library.fill_areas(liberty, lef),
                         liberty.replace("area : 0;", "area : 48;", 1)
                         .replace("area: 0.00 ;", "area: 100;"))

    def test_nand(self) -> None:
        cells = {"NAND2X2": {"area": 3}, "nd2_small": {"area": 2}, "AND2": {"area": 1},
                 "NAND2_0": {"area": 0}, "NAND2_NO": {}}
        self.assertEqual(library.smallest_nand(cells, ""), "nd2_small")
        self.assertEqual(library.smallest_nand(cells, "NAND2X2"), "NAND2X2")
        self.assertIsNone(library.smallest_nand(cells, "NAND2_0"))

    def test_modules_of_verilog(self) -> None:
        self.assertEqual(library.modules_of("module a (\n  module  b;\n// module c\n"), ["a", "b"])

    def test_plain_names(self) -> None:
        rtlil = ("module \\top\n  cell $paramod\\m \\u\n    connect \\A \\B\n  end\n"
                 "  cell \\m \\v\n  end\n  cell $and $1\n  end\nend\n"
                 "module $paramod\\m\n  wire \\w\nend\nmodule \\m\n  wire \\w\n  end\nend\n"
                 "module \\other\nend\n")
        plain = {"$paramod\\m": "m_1", "m": "m_1", "top": "top"}
        self.assertEqual(library.renamed(rtlil, plain), (
            "module \\top\n  cell \\m_1 \\u\n    connect \\A \\B\n  end\n"
            "  cell \\m_1 \\v\n  end\n  cell $and $1\n  end\nend\n"
            "module \\m_1\n  wire \\w\nend\nmodule \\other\nend\n"))


class Efforts(unittest.TestCase):
    def test_script(self) -> None:
        self.assertEqual(
            efforts.abc_script(1, 0.5), "+strash;dch,-f;amap,-m;topo;buffer,-c,-N,24;topo;"
            "upsize,-D,650;dnsize,-D,650")
        self.assertIn(";map,-B,0.9,-D,860;", efforts.abc_script(efforts.HIGHEST, 1))

    def test_only_changed_modules_are_mapped(self) -> None:
        lines = efforts.abc_commands({"a": 2, "b": 1, "c": 2, "d": 3}, {"b": 1, "d": 1}, 1)
        *commands, select = lines.split("\n")
        self.assertEqual([line.split()[-2:] for line in commands[:1]], [["a", "c"]])
        self.assertEqual([line.split()[-1] for line in commands], ["c", "d"])
        self.assertEqual(select, "select a c d")

    def test_first(self) -> None:
        self.assertEqual(efforts.first_effort(2, 1), 1)
        self.assertEqual(efforts.first_effort(1, 1), 4)
        self.assertEqual(efforts.first_effort(0.1, 1), efforts.HIGHEST)

    def test_modules_that_the_last_effort_slows_down(self) -> None:
        last = efforts.HIGHEST
        self.assertEqual(efforts.risen_to_last({"a": last - 1, "b": last, "c": 1},
                                               {"a": last, "b": last, "c": 2}), ["a"])
        before, now = {"a": 1.0, "b": 1.0}, {"a": 1.5, "b": 1.0}
        self.assertEqual(efforts.slowed(["a", "b", "c"], before, now), ["a"])

    def test_hierarchy(self) -> None:
        modules = {"top": {"cells": {"u": {"type": "m"}, "g": {"type": "INV"}}},
                   "m": {"cells": {}}}
        self.assertEqual(efforts.hierarchy(modules), "top u m\n")

    def test_slack(self) -> None:
        self.assertEqual(efforts.worst_slack("a\nworst slack max -0.1234\nend\n"), "-0.1234")
        self.assertEqual(efforts.worst_slack("No paths found.\n"), "")

    def test_plain_modules(self) -> None:
        self.assertEqual(efforts.plain_modules([{"plain": "b"}, {"plain": "a"}, {"plain": "b"},
                                                {"plain": "FA"}], {"FA": {}}), ["a", "b"])


class Rounds(Folder):
    """Sizing with a Yosys and an OpenSTA that are made up: `slacks` is what each round reaches."""

    def size(self, slacks: list, *paths: str) -> Tuple[Any, int]:
        design = self.design(p="2")
        instances = {"u": "m", "v": "n", "w": "o"}
        self.write("out/names.json", json.dumps(
            [{"plain": name} for name in ("top", *instances.values())]))
        self.write("out/netlist.json", json.dumps({"modules": {
            "top": {"cells": {name: {"type": of} for name, of in instances.items()}},
            **{of: {"cells": {}} for of in instances.values()}}}))
        design.top = "top"
        left = list(slacks)

        def check() -> str:
            slack = str(left.pop(0)) if len(left) > 1 else str(left[0])
            pins = "".join(f" 1.0 1.0 ^ {path} (INV)\n" for path in paths or ["g/Z"])
            self.write("out/sta.log", f"Startpoint: a\n{pins} {slack} slack\n")
            return slack

        mapped = []
        with mock.patch.object(design, "map_modules", lambda abc, n: mapped.append(abc)), \
                mock.patch.object(design, "check_timing", check), \
                mock.patch.object(design, "over_limits", lambda: []):
            design.size_cells()
        self.mapped = mapped
        return json.loads(design.timing), len(mapped)

    def setUp(self) -> None:
        super().setUp()
        self.describe("--clock-ns=2")

    def test_met_at_once(self) -> None:
        timing, rounds = self.size([0.1])
        self.assertEqual(timing, {"period_ns": 2, "slack_ns": 0.1, "met": True, "rounds": 1,
                                  "changed_for_limits": 0, "over_limits": 0})
        self.assertEqual(rounds, 1)

    def test_only_slow_modules_rise(self) -> None:
        timing, _ = self.size([-0.2, -0.1, 0.0], "u/g/Z")
        self.assertEqual((timing["met"], timing["rounds"]), (True, 3))
        self.assertEqual((self.root / "out/efforts.txt").read_text(), "m 3\nn 1\no 1\ntop 1\n")
        self.assertTrue(self.mapped[0].endswith("select m n o top"))
        self.assertTrue(self.mapped[2].endswith("select m"))

    def test_modules_of_a_tenth_rise_where_none_takes_a_third(self) -> None:
        timing, _ = self.size([-0.2, 0.0], "u/g/Z", "v/g/Z", "w/g/Z", "g/Z")
        self.assertEqual((timing["met"], timing["rounds"]), (True, 2))
        self.assertTrue(self.mapped[1].endswith("select m n o top"))

    def test_it_ends_at_the_highest_effort(self) -> None:
        timing, rounds = self.size([-0.2])
        self.assertEqual((timing["met"], rounds), (False, efforts.HIGHEST))

    def test_the_last_effort_is_barred_where_it_is_slower(self) -> None:
        with mock.patch.object(area_map.Design, "times",
                               mock.Mock(side_effect=lambda: {"top": next(self.clock)})):
            self.clock = iter(range(100))
            slacks = [-0.2] * (efforts.HIGHEST - 1) + [-0.3, 0.1]
            timing, _ = self.size(slacks)
        self.assertEqual((self.root / "out/efforts.txt").read_text(),
                         f"m 1\nn 1\no 1\ntop {efforts.HIGHEST - 1}\n")
        self.assertTrue(timing["met"])


class Common(Folder):
    def test_plain_copy(self) -> None:
        packed = self.root / "a.lib.gz"
        packed.write_bytes(gzip.compress(b"library"))
        copy = self.root / "copy"
        common.plain_copy(str(packed), copy)
        self.assertEqual(copy.read_bytes(), b"library")
        packed.write_bytes(packed.read_bytes()[:-9])
        with self.assertRaisesRegex(common.Failed, "is it whole"):
            common.plain_copy(str(packed), copy)

    def test_yosys(self) -> None:
        self.tool("yosys", 'echo "$*" > called; echo "x ERROR: no module" > yosys.log; exit 1')
        with mock.patch.dict(os.environ, {"YOSYS": str(self.root / "yosys")}):
            with self.assertRaisesRegex(common.Failed, r"^yosys with a.lib: no module \(see .*\)"):
                common.run_yosys(self.root, "script", "/b/a.lib")
        self.assertEqual((self.root / "called").read_text(), "-q -l yosys.log -p script\n")

    def sta(self, script: str) -> str:
        self.tool("sta", script)
        with mock.patch.dict(os.environ, {"STA": str(self.root / "sta")}):
            return common.run_sta(self.root, Path("a.tcl"), self.root / "log", {"top": "t"})

    def test_sta(self) -> None:
        said = "echo check_setup; echo Warning: a; echo check_setup done; echo slack; echo end"
        self.assertIn("slack\n", self.sta(f'cp "$3" {self.root}/given; {said}'))
        self.assertEqual((self.root / "given").read_text(),
                         f'set top "t"\nsource "{PROJECT}/synth/common.tcl"\nsource "a.tcl"\n'
                         "puts end\nexit\n")
        for script, words in (("exit 1", "OpenSTA fails"), ("echo", "stopped early"),
                              ("echo 'Error: bad'; echo end", r"OpenSTA: Error: bad \(see")):
            with self.assertRaisesRegex(common.Failed, words):
                self.sta(script)

    def test_a_tool_that_fails(self) -> None:
        with self.assertRaisesRegex(common.Failed, "^filter: first$"):
            common.run_tool(["sh", "-c", "printf 'first\\nsecond\\n' >&2; exit 5"],
                            self.root / "a", "filter")


if __name__ == "__main__":
    unittest.main()
