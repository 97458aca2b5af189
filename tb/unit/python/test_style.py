# SPDX-License-Identifier: MIT
"""Tests of tb/project/style: each rule finds its fault, and only its fault."""
from __future__ import annotations

import os
import shutil
import subprocess
import tempfile
import unittest
from pathlib import Path

from loading import PROJECT, load

style = load("tb/project/style")
SPDX = "/* SPDX-License-Identifier: MIT */\n"

# A clang-format that finds a fault in each file whose text has two blanks in a row.
FAKE = """#!/bin/sh
if [ "$1" = --version ]; then echo "clang-format version VERSION"; exit 0; fi
status=0
for file; do
  ! grep -q '  ' "$file" 2> /dev/null || { echo "$file:1:1: error: code" >&2; status=1; }
done
exit $status
"""


class Lines(unittest.TestCase):
    def test_columns_are_characters(self) -> None:
        self.assertEqual(style.columns("aä€😀".encode()), 4)

    def test_only_longer_lines_are_found(self) -> None:
        text = "\n".join(["a" * 100, "b" * 101, "ä" * 100, "ä" * 101]).encode()
        self.assertEqual(style.long_lines("f", text), ["f:2: 101 columns", "f:4: 101 columns"])

    def test_files_that_are_left_out(self) -> None:
        for name in ("rtl/a.v", "docs/x.c", "tb/data/a", "README.md", "a/b.csv", "a.svg"):
            self.assertTrue(style.LEFT_OUT.match(name), name)
        for name in ("rtl_gen/a.c", "tb/database", "Makefile", "a.json.c", "scripts/docs/a"):
            self.assertFalse(style.LEFT_OUT.match(name), name)

    def test_files_of_clang_format(self) -> None:
        for name in ("a.c", "lib/a.h", "a.cpp"):
            self.assertTrue(style.C_FILE.match(name), name)
        for name in ("a.cc", "a.c.in", "a.v", "chapter"):
            self.assertFalse(style.C_FILE.match(name), name)


class Licence(unittest.TestCase):
    def test_a_source_names_it_at_its_head(self) -> None:
        named = b"#!/bin/sh\n# SPDX-License-Identifier: MIT\n"
        self.assertTrue(style.names_licence("a", named))
        self.assertFalse(style.names_licence("a.c", b"int x;\n"))
        self.assertFalse(style.names_licence("a.c", b"\n" * 4 + named))
        self.assertTrue(style.names_licence("tb/data.txt", b""))
        self.assertTrue(style.names_licence("LICENSE", b""))


class Python(unittest.TestCase):
    def test_what_is_python(self) -> None:
        self.assertTrue(style.is_python("a.py", b""))
        self.assertTrue(style.is_python("a", b"#!/usr/bin/env python3\n"))
        self.assertFalse(style.is_python("a", b"#!/bin/sh\n# python\n"))

    def test_docstring(self) -> None:
        self.assertIsNone(style.python_fault("a", b'"""What it does."""\nx = 1\n'))
        self.assertEqual(style.python_fault("a", b"# a comment\nx = 1\n"), "a:1: no docstring")

    def test_it_compiles(self) -> None:
        fault = style.python_fault("a", b'"""A."""\ndef f(:\n')
        self.assertRegex(fault, "^a:2: ")
        self.assertRegex(style.python_fault("a", b'"""A."""\nreturn 1\n'), "^a:2: ")
        self.assertRegex(style.python_fault("a", b'"""A."""\n\0'), "^a:[12]: ")

    def test_grammar_is_that_of_3_9(self) -> None:
        newer = b'"""A."""\nmatch 1:\n    case 1:\n        pass\n'
        self.assertRegex(style.python_fault("a", newer), "^a:[0-9]: ")


class Repository(unittest.TestCase):
    """The script in a repository of its own, with a clang-format that is a fake."""

    def setUp(self) -> None:
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = Path(folder.name)
        self.write("tb/project/style", (PROJECT / "tb/project/style").read_text())
        self.git("init", "-q")
        self.use("14.0.6")

    def write(self, name: str, text: str) -> None:
        file = self.root / name
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text)

    def git(self, *words: str) -> None:
        subprocess.run(["git", *words], cwd=self.root, check=True)

    def use(self, version: str) -> None:
        """Another version of clang-format."""
        self.write(".git/clang-format", FAKE.replace("VERSION", version))
        (self.root / ".git/clang-format").chmod(0o755)

    def run_style(self) -> subprocess.CompletedProcess[str]:
        environment = {**os.environ, "CLANG_FORMAT": str(self.root / ".git/clang-format")}
        environment.pop("FIRST_FAULT", None)
        return subprocess.run(["python3", self.root / "tb/project/style"], env=environment,
                              capture_output=True, text=True, check=False)

    def test_no_fault(self) -> None:
        self.write("a.c", SPDX + "int a;\n")
        done = self.run_style()
        self.assertEqual((done.returncode, done.stdout), (0, "2 cases, 0 wrong\n"))

    def test_each_rule(self) -> None:
        self.write("a.c", SPDX + "int  a;\n")
        self.write("b.h", "int " + "b" * 97 + ";\n")
        self.write("c.py", "c = 1\n")
        done = self.run_style()
        self.assertEqual(done.returncode, 1)
        self.assertEqual(done.stdout, "\n".join([
            "FAILED: lines over 100 columns: b.h:1: 102 columns",
            "FAILED: Python files without a docstring, or that do not compile: "
            "c.py:1: no docstring",
            "FAILED: sources without a licence: b.h", "c.py",
            "FAILED: clang-format has other lines: a.c:1:1: error: code",
            "4 cases, 4 wrong", ""]))

    def test_files_that_git_ignores_or_that_are_gone(self) -> None:
        self.write(".gitignore", "build/\n")
        self.write("build/a.c", "int  a;\n")
        self.write("gone.c", "int  a;\n")
        self.git("add", "gone.c")
        (self.root / "gone.c").unlink()
        self.assertEqual(self.run_style().stdout, "2 cases, 0 wrong\n")

    def test_another_clang_format(self) -> None:
        self.use("15.0.7")
        self.write("a.c", SPDX + "int  a;\n")
        done = self.run_style()
        self.assertEqual(done.returncode, 0)
        self.assertIn("no clang-format 14 here: C is not checked\n", done.stdout)

    def test_clang_format_that_fails_without_a_word(self) -> None:
        self.write("a.c", "int a;\n")
        self.write(".git/clang-format", FAKE.replace("VERSION", "14.0").replace(
            "status=0", "exit 9"))
        done = self.run_style()
        self.assertEqual(done.returncode, 1)
        self.assertIn("failed", done.stdout)

    def test_no_repository(self) -> None:
        shutil.rmtree(self.root / ".git")
        done = self.run_style()
        self.assertEqual((done.returncode, done.stdout), (
            77, "no git checkout: the files are not checked\n"))


if __name__ == "__main__":
    unittest.main()
