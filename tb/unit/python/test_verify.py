# SPDX-License-Identifier: MIT
"""Tests of scripts/verify: what it joins of a folder, what the page says, and exit statuses.

tb/campaign/page tests the same script with campaigns that were run."""
from __future__ import annotations

import contextlib
import io
import json
import os
import tempfile
import unittest
from pathlib import Path
from typing import Any, List, Tuple
from unittest import mock

from loading import PROJECT, load

verify = load("scripts/verify")

GROUP = {"group": "g", "jobs": 2, "passed": 2, "findings": 0, "missing": 0, "pairs": 3,
         "mismatches": 0}


class Folder(unittest.TestCase):
    """A folder of parts."""

    def setUp(self) -> None:
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.addCleanup(os.chdir, os.getcwd())
        os.chdir(PROJECT)
        self.build = Path(folder.name)
        tools = mock.patch.object(verify, "tool_versions", lambda: ["cc <1>"])  # these take seconds
        tools.start()
        self.addCleanup(tools.stop)

    def write(self, name: str, content: Any) -> None:
        file = self.build / name
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(content if isinstance(content, str) else json.dumps(content))

    def campaign(self, name: str, *groups: dict, cpu: float = 2) -> None:
        self.write(f"campaign/{name}/campaign.json",
                   {"commits": ["abc", "def"], "by": ["cc 1"], "groups": groups})
        self.write(f"campaign/{name}/times.json",
                   {"groups": [{"group": group["group"], "cpu": cpu} for group in groups]})

    def run_verify(self, *arguments: str) -> Tuple[int, str, str]:
        """Exit status, standard output and standard error of the script."""
        out, err = io.StringIO(), io.StringIO()
        with mock.patch("sys.argv", ["verify", *(arguments or [str(self.build)])]), \
                contextlib.redirect_stdout(out), contextlib.redirect_stderr(err):
            status = verify.main()
        return status, out.getvalue(), err.getvalue()

    def joined(self) -> dict:
        self.run_verify()
        return json.loads((self.build / "verify/verify.json").read_text())

    def page(self) -> str:
        self.run_verify()
        return (self.build / "verify/index.html").read_text()


class Parts(Folder):
    def test_nothing_was_run(self) -> None:
        joined = self.joined()
        self.assertEqual([part["run"] for part in joined["parts"]], [False] * 12)
        self.assertFalse(any(proof["run"] for proof in joined["proofs"]))
        self.assertGreater(len(joined["proofs"]), 3)
        self.assertEqual(self.page().count('<p class="none">not run</p>'), 6)

    def test_a_campaign_tells_commits_and_tools(self) -> None:
        self.campaign("hard", GROUP)
        part = next(p for p in self.joined()["parts"] if p["part"] == "campaign-hard")
        self.assertEqual((part["run"], part["commit"], part["by"]), (True, "abc, def", "cc 1"))

    def test_proofs_are_a_part_only_where_they_ran(self) -> None:
        self.assertNotIn("proofs", [part["part"] for part in self.joined()["parts"]])
        self.write("verify/proofs.json", {"proofs": [{"name": "p", "passed": True}]})
        joined = self.joined()
        self.assertIn("proofs", [part["part"] for part in joined["parts"]])
        self.assertEqual(joined["proofs"][0], {"run": True, "name": "p", "passed": True})

    def test_no_json_is_told_as_not_run(self) -> None:
        self.write("verify/mutants.json", '{"mutants": [')
        status, _, err = self.run_verify()
        self.assertEqual(status, 0)
        self.assertRegex(err, r"^verify: .*mutants.json: not JSON, told as not run: .*\n$")

    def test_status_files(self) -> None:
        self.write("test/axi.log", "first\nlast\tline")
        for content, expected in (("0 12 11", (True, True, 12, 11)), ("1 2 3", (True, False, 2, 3)),
                                  ("77 0 0", (False, False, 0, 0)), ("\n", (True, False, 0, 0)),
                                  ("x", (True, False, 0, 0)), ("0 1 a b", (True, True, 1, 0))):
            self.write("test/axi.status", content)
            proof = next(p for p in self.joined()["proofs"] if p["name"] == "axi")
            found = tuple(proof[key] for key in ("run", "passed", "seconds", "cpu"))
            self.assertEqual(found, expected, content)
            self.assertEqual(proof["said"], "last line")

    def test_the_commit_of_a_file(self) -> None:
        self.write("verify/mutants.json", {"mutants": []})
        self.assertRegex(self.joined()["parts"][1]["commit"], "^([0-9a-f]{12}|unknown)$")


class Tools(unittest.TestCase):
    def test_first_lines(self) -> None:
        variables = {name: "/no/such" for name in ("VERILATOR", "YOSYS", "IVERILOG", "CLANG")}
        with mock.patch.dict(os.environ, {**variables, "CC": "echo", "PATH": "/bin"}):
            self.assertTrue(verify.tool_versions()[0].startswith("echo "))
            self.assertLessEqual(len(verify.tool_versions()), 2)  # echo, and z3 where it is

    def test_commands_that_fail(self) -> None:
        self.assertIsNone(verify.said_by(["/no/such"]))
        self.assertIsNone(verify.said_by(["false"]))
        self.assertEqual(verify.said_by(["echo", "a"]), "a\n")


class Sums(Folder):
    def test_exhaustive_is_complete(self) -> None:
        whole = {**GROUP, "pairs": 3 ** 18}
        self.campaign("exhaustive", whole, {**whole, "group": "h", "missing": 1},
                      {**whole, "group": "i", "pairs": 3 ** 18 - 1},
                      {**whole, "group": "none", "passed": 0})
        rows = self.joined()["exhaustive"]
        self.assertEqual([(row["what"], row["complete"], row["cpu"]) for row in rows],
                         [("g", True, 2), ("h", False, 2), ("i", False, 2)])

    def test_fuzzing_is_summed_by_target(self) -> None:
        self.write("verify/fuzz.json", {"fuzz": [
            {"target": "g", "runs": 1, "executions": 50, "findings": 0, "seconds": 1}]})
        self.campaign("fuzz", {**GROUP, "executions": 100})
        self.assertEqual(self.joined()["fuzz"], [
            {"target": "g", "runs": 3, "executions": 150, "findings": 0, "seconds": 3}])

    def test_mutants_of_jobs_are_summed_by_design(self) -> None:
        job = {"job": "j", "design": "new", "mutants": 10, "killed": 8, "equivalent": 1,
               "survivors": 1, "alive": [{"number": 3}], "control_mutants": 4, "control_killed": 4}
        self.write("verify/mutation.json", {"mutation": [{"design": "known", "score": 0.5}]})
        self.write("campaign/mutation/joined.jsonl", "\n".join(
            map(json.dumps, [job, {**job, "design": "known"}, job])))
        known, new = self.joined()["mutation"]
        self.assertEqual(known["design"], "known")
        self.assertEqual((new["jobs"], new["mutants"], new["score"]), (2, 20, 16 / 18))
        self.assertEqual((new["control"]["score"], len(new["alive"])), (1, 2))

    def test_no_score_without_mutants(self) -> None:
        self.assertIsNone(
            verify.with_score({"mutants": 2, "equivalent": 2, "killed": 0})["score"])

    def test_coverage_by_folder(self) -> None:
        self.write("verify/coverage.json", {"coverage": [
            {"file": "c_model/a.c", "lines": 10, "ran": 9, "branches": 4, "taken": 2},
            {"file": "c_model/b.c", "lines": 10, "ran": 10, "branches": 0, "taken": 0},
            {"file": "tb/c.c", "lines": 5, "ran": 0, "branches": 0, "taken": 0}]})
        self.assertEqual(self.joined()["coverage"], [
            {"folder": "c_model", "lines": 20, "ran": 19, "branches": 4, "taken": 2}])
        self.assertIn("<td>95 %</td>", self.page())

    def test_the_trial_on_slurm(self) -> None:
        self.assertIsNone(self.joined()["slurm"])
        self.write("slurm/slurm.json", {"slurm": {"nodes": 4}})
        self.assertEqual(self.joined()["slurm"], {"nodes": 4})


class Page(Folder):
    def test_figures(self) -> None:
        self.assertEqual(verify.page.percent(16 / 18), "88.89 %")
        self.assertEqual(verify.page.percent(None), "-")
        self.assertEqual([verify.page.rate(7, seconds) for seconds in (2, 0, None)], [4, "-", "-"])
        self.assertEqual(verify.page.hours(5400), 1.5)

    def test_cells(self) -> None:
        rows: List[Any] = [(False, [12000, None, "<x>"]), (True, [0, False, ""])]
        self.assertEqual(
            verify.page.table(["a", "b", "c"], rows),
            "<table><tr><th>a</th><th>b</th><th>c</th></tr>"
            "<tr><td>12,000</td><td>-</td><td>&lt;x&gt;</td></tr>\n"
            '<tr class="wrong"><td>0</td><td>-</td><td></td></tr></table>')

    def test_head(self) -> None:
        page = self.page()
        self.assertTrue(page.startswith("<!DOCTYPE html>"))
        self.assertIn(". cc &lt;1&gt;. Made by", page)
        self.assertTrue(page.endswith("</body></html>\n"))

    def test_results_of_proofs(self) -> None:
        self.write("verify/proofs.json", {"proofs": [
            {"name": "good", "passed": True}, {"name": "bad"}, {"name": "left", "run": False}]})
        page = self.page()
        self.assertIn("<tr><td>good</td><td>proved</td>", page)
        self.assertIn('<tr class="wrong"><td>bad</td><td>FAILED</td>', page)
        self.assertIn("<tr><td>left</td><td>not run</td>", page)


class Status(Folder):
    def test_what_is_told(self) -> None:
        self.campaign("hard", {**GROUP, "pairs": 12000})
        status, out, _ = self.run_verify()
        self.assertEqual(status, 0)
        self.assertRegex(out, r"^0 of [1-9][0-9]* proofs passed\nexhaustive: 0 of 5 designs\n"
                              r"sampled: 12,000 hard pairs, 0 mismatches\nfuzz: 0 executions")
        self.assertTrue(out.endswith(
            f"{self.build}/verify/index.html {self.build}/verify/verify.json\n"))

    def test_a_finding(self) -> None:
        for name in ("hard", "exhaustive", "fuzz"):
            self.campaign(name, {**GROUP, "findings": 1})
            self.assertEqual(self.run_verify()[0], 1, name)
            self.campaign(name, GROUP)
            self.assertEqual(self.run_verify()[0], 0, name)

    def test_a_proof_that_failed(self) -> None:
        self.write("test/axi.status", "1 2 3")
        self.assertEqual(self.run_verify()[0], 1)

    def test_bad_input(self) -> None:
        self.assertEqual(self.run_verify("/no/such"),
                         (2, "", "verify: no folder /no/such; run make build\n"))
        damaged = [
            ("campaign/hard/campaign.json", {"commits": "abc", "groups": []}),
            ("campaign/hard/campaign.json", {"commits": [], "groups": {}}),
            ("campaign/hard/campaign.json", {"groups": [{"group": "g"}]}),
            ("verify/fuzz.json", {"fuzz": [{"runs": 1}]}),
            ("verify/mutation.json", {"mutation": [1]})]
        for name, content in damaged:
            self.write(name, content)
            status, out, err = self.run_verify()
            self.assertEqual((status, out, err.count("\n")), (2, "", 1), content)
            self.assertFalse((self.build / "verify/verify.json").exists())
            (self.build / name).unlink()


if __name__ == "__main__":
    unittest.main()
