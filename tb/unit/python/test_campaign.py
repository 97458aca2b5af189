# SPDX-License-Identifier: MIT
"""Tests of scripts/campaign and of its modules results and lists, without make and GNU parallel.

tb/campaign/check runs campaigns with GNU parallel, tb/campaign/slurm with Slurm."""
from __future__ import annotations

import contextlib
import io
import json
import os
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path
from typing import Any, List, Tuple
from unittest import mock

from loading import PROJECT, load

campaign = load("scripts/campaign")
results = campaign.results
lists = sys.modules["campaigns.lists"]
Job = results.Job


class Folder(unittest.TestCase):
    """A campaign's folder. Its engine runs the jobs in this process, one after the other."""

    def setUp(self) -> None:
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.addCleanup(os.chdir, os.getcwd())
        os.chdir(PROJECT)
        self.root = Path(folder.name)
        self.out = self.root / "out"
        self.ran: List[str] = []
        engine = campaign.Engine("sh", "none", self.run_here)
        for patch in (mock.patch.dict(campaign.ENGINES, {"here": engine}),
                      mock.patch.dict(os.environ, {"ENGINE": "here", "SHARE": ""}),
                      mock.patch.object(campaign, "versions", lambda: "cc <1>"),
                      mock.patch.object(campaign.signal, "signal")):
            patch.start()
            self.addCleanup(patch.stop)

    def run_here(self, given: Any, todo: List[str], _work: Path) -> None:
        self.ran += todo
        for name in todo:
            with tempfile.TemporaryDirectory() as work:
                campaign.run_job(given._replace(one=name), Path(work))

    def list(self, *rows: str) -> str:
        """A file of jobs; blanks stand for tabs before the command."""
        file = self.root / "list"
        file.write_text("".join("\t".join(row.split(" ", 2)) + "\n" for row in rows))
        return str(file)

    def run_campaign(self, *arguments: str) -> Tuple[int, str, str]:
        """Exit status, standard output and standard error."""
        out, err = io.StringIO(), io.StringIO()
        with mock.patch("sys.argv", ["campaign", *arguments]), \
                contextlib.redirect_stdout(out), contextlib.redirect_stderr(err):
            status = campaign.main()
        return status, out.getvalue(), err.getvalue()

    def run_list(self, *rows: str) -> Tuple[int, str, str]:
        return self.run_campaign("-o", str(self.out), "-f", self.list(*rows), "trial")

    def json(self, name: str) -> Any:
        return json.loads((self.out / name).read_text())


class Refusals(Folder):
    def setUp(self) -> None:
        super().setUp()
        for name, nothing in (("jobs", []), ("quiet", None)):  # no campaign begins by mistake
            patch = mock.patch.object(lists.Lists, name, mock.Mock(return_value=nothing))
            patch.start()
            self.addCleanup(patch.stop)

    def refused(self, words: str, *arguments: str) -> None:
        status, out, err = self.run_campaign(*arguments)
        self.assertEqual((status, out, err.count("\n")), (2, "", 1), err)
        self.assertIn(words, err)

    def test_command_line(self) -> None:
        for arguments in ((), ("-z", "hard"), ("-o",), ("-s",)):
            self.refused("usage: campaign [-s]", *arguments)
        self.refused("campaign: 'a/b' is no name of a campaign", "a/b")
        for jobs in ("0", "", "x", "01"):
            self.refused(f"'{jobs}' is no number of jobs", "-j", jobs, "hard")
        for share in ("x", "0", "-1", "1e"):
            self.refused(f"'{share}' is no share", "-p", share, "hard")

    def test_what_cannot_begin(self) -> None:
        some = ("-o", str(self.out))
        self.refused("there is no campaign nothing; scripts/campaign names them", *some, "nothing")
        self.refused("no list of jobs; start the campaign", *some, "-s", "hard")
        with mock.patch.dict(os.environ, {"ENGINE": "some"}):
            self.refused("'some' is neither parallel nor slurm", *some, "hard")
        with mock.patch.object(campaign.shutil, "which", lambda name: None):
            self.refused("sh not found; on Debian: apt-get install none", *some, "hard")

    def test_a_job_that_is_not_listed(self) -> None:
        self.out.mkdir()
        (self.out / "jobs.tsv").write_text("g\ta\tcommand 'true'\n")
        self.refused("trial has no job b", "-o", str(self.out), "-x", "b", "trial")

    def test_folder(self) -> None:
        self.refused("/dev/null/a cannot be made", "-o", "/dev/null/a", "-f", self.list(), "trial")
        self.assertFalse(self.out.exists())

    def test_lists(self) -> None:
        some = ("-o", str(self.out), "-f")
        self.refused("/no/list cannot be read", *some, "/no/list", "trial")
        self.refused("no jobs; groups are chosen", *some, self.list(), "trial")
        self.refused("not three columns in each line", *some, self.list("a b c", "a b"), "trial")
        for name in ("a/b", ".a", "", "ä"):
            self.refused("no name of a file, or twice", *some, self.list(f"g {name} c"), "trial")
        self.refused("job a: no name of a file, or twice", *some, self.list("g a c", "h a c"),
                     "trial")


class Jobs(Folder):
    def test_a_result(self) -> None:
        status, out, _ = self.run_list("g a echo noise; echo '{\"pairs\": 5, \"x\": 1.0}'")
        self.assertEqual(status, 0)
        result = self.json("results/a.json")
        self.assertEqual(list(result), ["group", "job", "command", "finding", "pairs", "x", "by",
                                        "commit", "host", "seconds", "cpu", "check"])
        self.assertEqual(result["command"], "command 'echo noise; echo '\\''{\"pairs\": 5, "
                         "\"x\": 1.0}'\\'''")
        self.assertFalse(result["finding"])
        self.assertRegex(out, r"^  g: 1 of 1 jobs passed, 0 findings, 0 missing; 5 pairs, 1 x")
        self.assertTrue(out.endswith("\ntrial: 1 of 1 jobs passed, 0 findings, 0 missing\n"))

    def test_a_finding_stands(self) -> None:
        for expected in (["a"], []):
            self.ran = []
            status, out, _ = self.run_list("g a echo said >&2; echo '{}'; exit 1")
            self.assertEqual((status, self.ran), (1, expected))
            self.assertIn("trial: 0 of 1 jobs passed, 1 findings, 0 missing\n", out)
        self.assertEqual((self.out / "results/a.log").read_text(), "said\n")

    def test_an_error_is_tried_three_times(self) -> None:
        status, out, err = self.run_list("g a echo said >&2; exit 3", "g b echo '{}'")
        self.assertEqual((status, self.ran), (1, ["a", "b", "a", "a"]))
        line = "trial: a: status 3: command 'echo said >&2; exit 3'\n"
        self.assertEqual(err, line * 3)
        self.assertEqual((self.out / "errors/a").read_text(), line + "said\n")
        self.assertIn(f"  error: {line}", out)
        self.assertIn("1 of 2 jobs passed, 0 findings, 1 missing", out)

    def test_an_error_is_forgotten_once_it_is_mended(self) -> None:
        (self.root / "mended").write_text("")
        job = f"g a test -e {self.root}/mended && echo '{{}}' || exit 2"
        (self.root / "mended").unlink()
        self.assertEqual(self.run_list(job)[0], 1)
        (self.root / "mended").write_text("")
        self.assertEqual(self.run_list(job)[0], 0)
        self.assertFalse((self.out / "errors/a").exists())

    def test_no_object_is_an_error(self) -> None:
        for said in ("true", "echo [1]", "echo text", "exit 1", "echo '{}'; echo x"):
            self.ran = []
            self.assertEqual(self.run_list(f"g a {said}")[0], 1, said)
            self.assertEqual(len(self.ran), 3)

    def test_another_command_is_run_again(self) -> None:
        self.run_list("g a echo '{}'", "g b echo '{}'")
        self.ran = []
        self.run_list("g a echo '{}' ", "g b echo '{}'")
        self.assertEqual(self.ran, ["a"])

    def test_kinds_know_their_variables(self) -> None:
        command = 'echo "$out $work $log $name $#"'
        done = subprocess.run(lists.run_kinds(command, "1", "2", "3", "4", "5"),
                              stdout=subprocess.PIPE, text=True, check=True)
        self.assertEqual(done.stdout, "1 2 3 4 1\n")

    def test_tasks_of_an_array(self) -> None:
        file = self.root / "todo"
        file.write_text("a\nb\nc\nd\ne\n")
        given = campaign.command_line(["-o", "o", "-t", f"1/2:{file}", "trial"])
        with mock.patch.object(campaign.subprocess, "run") as run:
            campaign.run_task(given)
        self.assertEqual([call.args[0] for call in run.call_args_list], [
            ["scripts/campaign", "-o", "o", "-x", job, "trial"] for job in "bd"])


class Damage(Folder):
    def test_damaged_results_are_made_again(self) -> None:
        jobs = [f"g {name} echo '{{\"pairs\": 16}}'" for name in "abcdefgh"]
        self.run_list(*jobs)
        file = {name: self.out / f"results/{name}.json" for name in "abcdefgh"}
        whole = file["a"].read_text()
        file["a"].write_text(whole[:40])
        file["b"].write_text(file["b"].read_text().replace(":16", ":17"))
        file["c"].write_text("")
        file["d"].write_bytes(bytes(range(128, 256)))
        file["e"].write_text("null\n")
        file["f"].write_text(file["g"].read_text())
        file["h"].write_text(file["h"].read_text() * 2)
        self.ran = []
        status, out, _ = self.run_campaign("-o", str(self.out), "-s", "trial")
        self.assertEqual((status, self.ran), (0, []))
        self.assertIn("trial: 2 of 8 jobs passed, 0 findings, 6 missing", out)
        self.run_list(*jobs)
        self.assertEqual(self.ran, list("abcdef"))
        self.assertEqual(file["a"].read_text()[:40], whole[:40])

    def test_a_result_with_something_behind_is_not_the_jobs(self) -> None:
        self.run_list("g a echo '{}'")
        file = self.out / "results/a.json"
        job = results.read_jobs(self.out / "jobs.tsv")[0]
        self.assertTrue(results.stands(file, job))
        file.write_text(file.read_text() * 2)
        self.assertFalse(results.stands(file, job))
        self.assertFalse(results.stands(self.out / "no", job))

    def test_checksum(self) -> None:
        # The sum that jq gave of this result when scripts/campaign was a shell script.
        self.assertEqual(results.checksum({"a": 1.0, "b": "é", "check": 7}), 502786491)
        self.assertIsNone(results.whole('{"a": 1, "check": 5}'))

    def test_files_of_jobs_that_were_ended(self) -> None:
        self.run_list("g a echo '{}'")
        (self.out / "results/a.json").rename(self.out / "results/.a.json")
        self.assertEqual(results.standing(self.out), {})


class Shares(Folder):
    def jobs(self, *numbers: int) -> List[Any]:
        return [Job(f"g{group}", f"{group}-{n}", "c") for group, number in enumerate(numbers)
                for n in range(number)]

    def test_spread_over_each_group(self) -> None:
        def chosen(share: float, *numbers: int) -> List[str]:
            return [job.name for job in campaign.shared(self.jobs(*numbers), share)]

        self.assertEqual(chosen(0.26, 8, 1), ["0-0", "0-3", "0-7", "1-0"])
        self.assertEqual(chosen(0.0001, 3, 2), ["0-0", "1-0"])
        self.assertEqual(len(chosen(1, 8, 3)), 11)
        self.assertEqual(len(chosen(0.1, 10, 20)), 3)

    def test_the_rest_is_missing(self) -> None:
        rows = [f"g {n} echo '{{}}'" for n in range(4)]
        arguments = ("-o", str(self.out), "-f", self.list(*rows), "-p", "0.5", "trial")
        status, out, _ = self.run_campaign(*arguments)
        self.assertEqual((status, len(self.ran)), (0, 2))
        self.assertIn("2 of 4 jobs passed, 0 findings, 2 missing", out)

    def test_groups_that_are_not_chosen_stay(self) -> None:
        self.out.mkdir()
        campaign.write_jobs(self.out, [Job("a", "a-2", "c"), Job("a", "a-10", "c")])
        campaign.write_jobs(self.out, [Job("b", "b-1", "c")])
        campaign.write_jobs(self.out, [Job("a", "a-3", "d")])
        self.assertEqual((self.out / "jobs.tsv").read_text(), "a\ta-3\td\nb\tb-1\tc\n")


class Sums(Folder):
    def setUp(self) -> None:
        super().setUp()
        self.run_list("g a echo '{\"pairs\": 2000, \"ok\": true, \"t\": 0.5}'",
                      "g b echo '{\"pairs\": 3000, \"t\": 1}'",
                      "f c echo '{\"executions\": 7}'; exit 1", "f d exit 9")

    def test_campaign(self) -> None:
        campaign_json = self.json("campaign.json")
        self.assertEqual(list(campaign_json), ["campaign", "jobs", "passed", "findings", "missing",
                                               "commits", "by", "groups"])
        self.assertEqual(campaign_json["by"], ["cc <1>"])
        self.assertEqual(campaign_json["groups"], [
            {"group": "f", "jobs": 2, "passed": 0, "findings": 1, "missing": 1, "executions": 7},
            {"group": "g", "jobs": 2, "passed": 2, "findings": 0, "missing": 0, "pairs": 5000,
             "t": 1.5}])

    def test_times(self) -> None:
        times = self.json("times.json")
        self.assertEqual(list(times), ["seconds", "cpu", "hosts", "groups"])
        self.assertEqual([group["group"] for group in times["groups"]], ["f", "g"])
        self.assertEqual(times["hosts"], [os.uname().nodename])

    def test_joined_lines_do_not_depend_on_the_run(self) -> None:
        lines = (self.out / "joined.jsonl").read_text().splitlines()
        self.assertEqual([json.loads(line)["job"] for line in lines], ["c", "a", "b"])
        self.assertTrue(lines[1].endswith('"by":"cc <1>","commit":"%s"}'
                                          % json.loads(lines[1])["commit"]))

    def test_page(self) -> None:
        page = (self.out / "index.html").read_text()
        self.assertIn("<h1>trial: 2 of 4 jobs passed, 1 findings</h1>\n<p>1 missing; ", page)
        self.assertIn(", cc &lt;1&gt;</p>", page)
        self.assertIn("<tr><td>g</td><td>2</td><td>2</td><td>0</td><td>0</td>", page)
        self.assertIn("<td>5,000 pairs, 1.5 t</td></tr>\n", page)
        self.assertTrue(page.endswith("</table></body></html>\n"))

    def test_rates(self) -> None:
        joined = results.Joined("trial", self.out)
        joined.cpu = {"g": 2, "f": 0}
        self.assertIn("; 5000 pairs, 1.5 t; 2500 a second of CPU\n", joined.text())
        self.assertIn("; 7 executions\n", joined.text())
        self.assertEqual([joined.rate({"group": "g", "executions": 5}),
                          joined.rate({"group": "f", "pairs": 5})], [3, 0])


class Lists(Folder):
    """The campaigns' own lists, with a make and an objcopy that are made up."""

    def setUp(self) -> None:
        super().setUp()
        (self.out / "tools").mkdir(parents=True)
        self.quiet: List[Tuple[str, ...]] = []

        def quiet(_self: Any, *command: str) -> None:
            self.quiet.append(command)
            if command[0] == "objcopy":
                Path(command[-1]).write_text(command[-2])
                Path(command[-1]).chmod(0o755)

        def said(_self: Any, *command: str) -> str:
            if command[0] == "sh":
                return "SUM"
            if command[:3] == ("make", "-s", "mutations"):
                return "WORD=4 II=9\nTREE=1"
            if command[:3] == ("make", "-s", "core"):
                return "build/core/" + "-".join(command[3:])
            if command[:3] == ("make", "-s", "options"):
                return "--" + " --".join(command[3:])
            return "main 1000 200 --family=all --nudges=30\nother 40 0 --word=8"

        for name, function in (("quiet", quiet), ("said", said)):
            patch = mock.patch.object(lists.Lists, name, function)
            patch.start()
            self.addCleanup(patch.stop)

    def jobs(self, name: str, *groups: str) -> List[Any]:
        return lists.Lists(name, self.out, self.root, groups).jobs()

    def test_hard(self) -> None:
        jobs = self.jobs("hard")
        self.assertEqual(len(jobs), 6180)
        by_name = {job.name: job for job in jobs}
        tool = self.jobs("hard", "exact-w4-ii9")[0].command.split()[1]
        self.assertRegex(tool, "^tools/exact-w4-ii9-[0-9a-f]{12}$")
        self.assertTrue((self.out / tool).exists())
        self.assertEqual(by_name["exact-w4-ii9-families-0001"], Job(
            "exact-w4-ii9", "exact-w4-ii9-families-0001",
            f"pairs {tool} --count=1000000 --seed=1490001"))
        self.assertEqual(by_name["exact-w4-ii9-stressed"].command,
                         f"pairs {tool} --count=1050000 --seed=249 --stress=349")
        self.assertEqual(by_name["exact-w4-ii9-corners"].group, "exact-w4-ii9-corners")
        self.assertRegex(by_name["library-w18-3000"].command, "hard-pairs-.* 18 2000000 183000$")

    def test_groups_by_their_beginning(self) -> None:
        self.assertEqual({job.group for job in self.jobs("hard", "library-w8", "library-w2")},
                         {"library-w8", "library-w20", "library-w24", "library-w28"})

    def test_exhaustive_has_every_pair(self) -> None:
        jobs = self.jobs("exhaustive", "exact-w18-ii2")
        starts = [int(job.command.split("--ternary=")[1].split()[0]) for job in jobs]
        self.assertEqual(starts, list(range(0, 3 ** 18, 3 ** 13)))
        self.assertTrue(jobs[0].command.endswith(" --count=1594323"))

    def test_designs_of_sweeps(self) -> None:
        library = self.root / "a.lib"
        library.write_text("")
        with mock.patch.dict(os.environ, {"LIBERTY": str(library)}):
            self.assertEqual(self.jobs("area-sweep", "w8-ii18"), [
                Job("w8-ii18", "w8-ii18", f"area SUM {library} 8 18")])
            self.assertEqual(len(self.jobs("area-sweep")), 56)
            self.assertEqual(self.jobs("calibrate", "w8-ii1-1.5"), [
                Job("w8-ii1-1.5ns", "w8-ii1-1.5ns", f"calibrate SUM {library} 8 1 1.5")])
            self.assertEqual(len(self.jobs("calibrate")), 64)

    def test_no_library(self) -> None:
        with mock.patch.object(lists.os, "access", lambda file, mode: False), \
                self.assertRaisesRegex(lists.Failed, "no cell library; give LIBERTY"):
            self.jobs("area-sweep")

    def test_accuracy(self) -> None:
        jobs = self.jobs("accuracy")
        self.assertEqual([job.name for job in jobs], [
            *(f"main-family-all-{seed}" for seed in range(1, 11)), "other-word-8-1"])
        tool = jobs[0].command.split()[1]
        self.assertEqual(jobs[0].command, f"accuracy {tool} --count=100 --flips=20 --family=all "
                         "--nudges=3 --seed=1")
        self.assertEqual(jobs[10].command, f"accuracy {tool} --count=40 --word=8 --seed=1")

    def test_mutation(self) -> None:
        jobs = self.jobs("mutation")
        self.assertEqual(len(jobs), 16)
        self.assertEqual(jobs[8], Job("TREE=1", "TREE=1-1", "mutation SUM 250 1 --TREE=1"))

    def test_fuzz(self) -> None:
        os.chdir(self.root)
        for file in ("build/fuzz/fuzz/b", "build/fuzz/fuzz/a", "build/fuzz/corpus/a"):
            Path(file).parent.mkdir(parents=True, exist_ok=True)
            Path(file).write_text(file)
        with mock.patch.dict(os.environ, {"CLANG": "cl"}):
            jobs = self.jobs("fuzz")
        self.assertEqual([job.name for job in jobs][::100], ["a-001", "b-001"])
        self.assertRegex(jobs[99].command, "^fuzz tools/a-[0-9a-f]{12} a 100000 100$")
        self.assertEqual(self.quiet[0], ("make", "-s", "fuzz-targets", "CLANG=cl"))
        self.assertIn("build/fuzz/corpus", self.quiet[1])

    def test_a_share_of_a_number(self) -> None:
        self.assertEqual([lists.share("1000000", 10), lists.share("5", 10)], ["100000", "0.5"])


class Commands(unittest.TestCase):
    def test_what_fails(self) -> None:
        some = lists.Lists("hard", Path("o"), Path("w"), [])
        err = io.StringIO()
        with contextlib.redirect_stderr(err), self.assertRaisesRegex(lists.Failed, "^sh .* fails"):
            some.quiet("sh", "-c", "seq 30; exit 1")
        self.assertEqual(err.getvalue().split(), [str(n) for n in range(11, 31)])
        with self.assertRaises(lists.Failed):
            some.said("false")
        self.assertEqual(some.said("printf", "a\n\n"), "a")

    def test_versions(self) -> None:
        said = {"cc": "cc 1\nmore\n", "verilator": "Verilator 5.006 2023\n", "yosys": "",
                "clang": "clang 14; Debian\nmore\n"}
        tools = {variable: "" for variable in ("CC", "VERILATOR", "YOSYS", "CLANG")}
        with mock.patch.object(campaign, "output_of", lambda command: said[command[0]]), \
                mock.patch.dict(os.environ, tools):
            self.assertEqual(campaign.versions(), "cc 1; Verilator 5.006; clang 14;  Debian")


class Engines(unittest.TestCase):
    def setUp(self) -> None:
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = Path(folder.name)
        self.given = campaign.command_line(["-o", str(self.root), "-j", "3", "trial"])

    def tool(self, name: str, script: str) -> None:
        file = self.root / name
        file.write_text(f"#!/bin/sh\n{script}\n")
        file.chmod(0o755)
        patch = mock.patch.dict(os.environ, {"PATH": f"{self.root}:{os.environ['PATH']}"})
        patch.start()
        self.addCleanup(patch.stop)

    def test_parallel(self) -> None:
        self.tool("parallel", f'echo "$*" > {self.root}/called; cat > {self.root}/names')
        campaign.run_parallel(self.given, ["a", "b"], self.root)
        self.assertEqual((self.root / "names").read_text(), "a\nb\n")
        self.assertIn(f"-j 3 scripts/campaign -o {self.root} -x {{}} trial\n",
                      (self.root / "called").read_text())

    def test_an_interrupted_parallel_is_ended(self) -> None:
        engine = mock.MagicMock()
        engine.__enter__.return_value = engine
        engine.wait.side_effect = [campaign.Interrupted, 0]
        with mock.patch.object(campaign.subprocess, "Popen", return_value=engine), \
                self.assertRaises(campaign.Interrupted):
            campaign.run_parallel(self.given, ["a"], self.root)
        self.assertEqual(engine.terminate.call_count, 2)

    def slurm(self, *queues: str, status: int = 0) -> List[str]:
        """Runs three jobs; `queues` is what squeue says, one time after the other. Returns the
        arguments of sbatch."""
        self.tool("sbatch", f'printf "%s\\n" "$@" > {self.root}/called; exit {status}')
        left = [queue if queue != "unknown" else None for queue in queues]
        with mock.patch.object(campaign, "queued", lambda label: left.pop(0)), \
                mock.patch.object(campaign.time, "sleep"), \
                mock.patch.dict(os.environ, {"TASKS": "2"}), \
                open(os.devnull, "w") as null, contextlib.redirect_stderr(null):
            campaign.run_slurm(self.given, ["a", "b", "c"], self.root)
        self.assertEqual(left, [])
        called = self.root / "called"
        return called.read_text().splitlines() if called.exists() else []

    def test_slurm(self) -> None:
        arguments = self.slurm("", "x", "unknown", "")
        self.assertIn("--array=0-1", arguments)
        self.assertRegex(arguments[0], "^--job-name=sepax-trial-[0-9]+$")
        [todo] = (self.root / "slurm").glob("todo-*")
        self.assertEqual(todo.read_text(), "a\nb\nc\n")
        self.assertEqual(arguments[-1], f"--wrap=exec scripts/campaign -o '{self.root}' "
                         f"-t $SLURM_ARRAY_TASK_ID/2:'{todo}' trial")

    def test_an_array_in_the_queue_is_waited_for(self) -> None:
        self.assertEqual(self.slurm("x", "x", ""), [])

    def test_sbatch_fails(self) -> None:
        with self.assertRaisesRegex(campaign.Failed, "sbatch fails"):
            self.slurm("", status=1)

    def test_queue(self) -> None:
        self.tool("squeue", 'echo "$5"')
        self.assertEqual(campaign.queued("label"), "label")
        self.tool("squeue", "exit 1")
        self.assertIsNone(campaign.queued("label"))


if __name__ == "__main__":
    unittest.main()
