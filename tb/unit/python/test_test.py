# SPDX-License-Identifier: MIT
"""Tests of scripts/test: the list, the choice of tests, what becomes of a test, and who waits."""
import contextlib
import io
import os
import tempfile
import time
import unittest
from pathlib import Path

from loading import load

runner = load("scripts/test")


def a_test(name, command="true", tags=(), seconds=1.0):
    """A test of the list."""
    return runner.Test(name, set(tags), [], seconds, command)


class List(unittest.TestCase):
    """tb/tests."""

    def test_a_line(self):
        [found] = runner.parse("# a comment\n\n"
                               "cli | quick uses:x | power a/b | 3 | A=1 tb/cli | cat\n")
        self.assertEqual(found, runner.Test("cli", {"quick", "uses:x"}, ["power", "a/b"], 3,
                                            "A=1 tb/cli | cat"))

    def test_a_line_goes_on(self):
        [found] = runner.parse("a | | | 1 | one \\\n    two\n")
        self.assertEqual(found.command.split(), ["one", "two"])

    def test_what_makes_no_sense(self):
        for line, said in (("a | b", "tests:1: not NAME"), ("a | | | x | c", "'x' is not a number"),
                           (" | | | 1 | c", "not NAME"), ("a | | | 1 | ", "not NAME")):
            with self.assertRaisesRegex(runner.BadList, said):
                runner.parse(line)

    def test_the_list_itself(self):
        text = (runner.pathlib.Path(runner.__file__).parent.parent / "tb/tests").read_text()
        tests = runner.parse(text)
        self.assertGreater(len(tests), 100)
        self.assertGreater(len(runner.choose(tests, [], True)), 10)


class Choice(unittest.TestCase):
    """Which tests run."""

    tests = [a_test("cli", tags=["quick", "sanitized"]), a_test("sanitize/cli"),
             a_test("core/a", tags=["quick"]), a_test("core/b")]

    def names(self, names, quick=False):
        return [test.name for test in runner.choose(self.tests, names, quick)]

    def test_all(self):
        self.assertEqual(self.names([]), ["sanitize/cli", "core/a", "core/b"])

    def test_quick(self):
        self.assertEqual(self.names([], True), ["cli", "core/a"])

    def test_named(self):
        self.assertEqual(self.names(["cli", "core/*"]), ["cli", "core/a", "core/b"])

    def test_no_such_test(self):
        with self.assertRaisesRegex(runner.BadList, "no test is called 'nope'"):
            self.names(["cli", "nope"])

    def test_two_of_one_name(self):
        with self.assertRaisesRegex(runner.BadList, "two tests are called 'a'"):
            runner.choose([a_test("a"), a_test("a")], [], False)

    def test_sanitized_by_none(self):
        with self.assertRaisesRegex(runner.BadList, "no test is called 'sanitize/a'"):
            runner.choose([a_test("a", tags=["sanitized"])], [], False)


class Run(unittest.TestCase):
    """What becomes of a test."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.logs = Path(folder.name)

    def run_tests(self, *tests, jobs=2):
        """The exit status and the output."""
        out = io.StringIO()
        with contextlib.redirect_stdout(out):
            report = runner.Report(self.logs, len(tests))
            runner.run_all(list(tests), jobs, report, self.logs, dict(os.environ))
            status = report.finish()
        return status, out.getvalue()

    def test_passed_failed_skipped(self):
        status, out = self.run_tests(a_test("good"), a_test("bad", "echo why; exit 3"),
                                     a_test("none", "echo no tool; exit 77"), jobs=1)
        self.assertEqual(status, 1)
        self.assertIn("TAP version 14\n1..3\nok 1 - good # ", out)
        self.assertRegex(out, r"not ok 2 - bad # [^\n]*bad\.log\n#   why\n")
        self.assertIn("ok 3 - none # SKIP no tool\n", out)
        self.assertTrue(out.endswith("\n1 passed, 1 failed, 1 skipped\n"))

    def test_what_passes(self):
        self.assertEqual(self.run_tests(a_test("a"), a_test("b"))[0], 0)

    def test_only_skipped_is_a_failure(self):
        self.assertEqual(self.run_tests(a_test("a", "echo x; exit 77"))[0], 1)

    def test_killed_is_a_failure(self):
        self.assertEqual(self.run_tests(a_test("a", "kill -9 $$"))[0], 1)

    def test_timed_out_is_a_failure(self):
        patience, runner.PATIENCE = runner.PATIENCE, 0.2
        try:
            status, out = self.run_tests(a_test("a", "sleep 60"))
        finally:
            runner.PATIENCE = patience
        self.assertEqual(status, 1)
        self.assertIn("#   timed out after 0.2 s", out)

    def test_log_and_status(self):
        self.run_tests(a_test("a/b", "echo word; echo fault >&2"))
        self.assertEqual((self.logs / "a_b.log").read_text(), "word\nfault\n")
        self.assertEqual((self.logs / "a_b.status").read_text(), "0 0 0\n")

    def test_what_uses_the_same_runs_one_at_a_time(self):
        command = f"mkdir {self.logs}/mine && sleep 0.2 && rmdir {self.logs}/mine"
        tests = [a_test(str(n), command, ["uses:mine"]) for n in range(3)]
        self.assertEqual(self.run_tests(*tests, jobs=3)[0], 0)

    def test_others_run_at_once(self):
        began = time.monotonic()
        self.run_tests(*(a_test(str(n), "sleep 0.5") for n in range(3)), jobs=3)
        self.assertLess(time.monotonic() - began, 1.2)

    def test_one_that_waits_runs_beside_the_others(self):
        began = time.monotonic()
        self.run_tests(a_test("a", "sleep 0.5", ["waits"]), a_test("b", "sleep 0.5"), jobs=1)
        self.assertLess(time.monotonic() - began, 0.9)

    def test_of_those_that_wait_one_runs_at_a_time(self):
        began = time.monotonic()
        self.run_tests(*(a_test(str(n), "sleep 0.3", ["waits"]) for n in range(3)), jobs=3)
        self.assertGreater(time.monotonic() - began, 0.9)


if __name__ == "__main__":
    unittest.main()
