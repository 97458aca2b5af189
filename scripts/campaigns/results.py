# SPDX-License-Identifier: MIT
"""results - the results of a campaign: which of them stand, their sums, and the page.

Each job leaves one line of JSON, whose member `check` is a checksum of the others. A result stands
while it is whole and its job still has the same command.
"""
from __future__ import annotations

import os
from pathlib import Path
from typing import Any, Dict, Iterable, List, NamedTuple, Optional

from campaigns import jq_text
from campaigns.jq_text import Number, add, dump, grouped, html, rounded, text

Object = Dict[str, Any]

NOT_JOINED = ("host", "seconds", "cpu", "check")  # they differ from run to run
COUNTS = ("group", "jobs", "passed", "findings", "missing")
ERRORS_TOLD = 5


class Job(NamedTuple):
    """A line of jobs.tsv."""
    group: str
    name: str
    command: str  # a kind of scripts/campaigns/kinds and its arguments, in shell


def read_jobs(file: Path) -> List[Job]:
    """The jobs of jobs.tsv."""
    lines = file.read_text(encoding="utf-8", errors="surrogateescape").split("\n")
    return [Job(*line.split("\t", 2)) for line in lines if line.count("\t") >= 2]


def write_aside(file: Path, content: str) -> None:
    """Writes a file aside and renames it, so that nobody reads half of it."""
    aside = file.with_name(f"{file.name}.{os.getpid()}")
    aside.write_text(content, encoding="utf-8", errors="surrogateescape")
    aside.replace(file)


# ------------------------------------------------------------------------------- one result


def checksum(result: Object) -> int:
    """The checksum of a result without its check."""
    total = 0
    for character in dump({key: value for key, value in result.items() if key != "check"}):
        total = (total * 31 + ord(character)) % 1000000007
    return total


def whole(line: str) -> Optional[Object]:
    """The result that a line holds; None if it is damaged."""
    try:
        result = jq_text.load(line)
    except ValueError:
        return None
    if not isinstance(result, dict) or result.get("check") != checksum(result):
        return None
    return result


def stands(file: Path, job: Job) -> bool:
    """Whether the result of a job need not be made again."""
    try:
        lines = file.read_text(encoding="utf-8", errors="replace").splitlines()
    except OSError:
        return False
    result = whole(lines[0]) if len(lines) == 1 else None
    return (result is not None and result.get("command") == job.command
            and result.get("job") == job.name)


def standing(out: Path) -> Dict[Job, Object]:
    """The jobs whose results stand, in the order of jobs.tsv."""
    found = {}
    for file in sorted((out / "results").glob("*.json")):
        if file.name.startswith("."):
            continue  # of a job that was ended
        for line in file.read_text(encoding="utf-8", errors="replace").splitlines():
            result = whole(line)
            if result is not None:
                found[result.get("job"), result.get("command")] = result
    return {job: found[job.name, job.command] for job in read_jobs(out / "jobs.tsv")
            if (job.name, job.command) in found}


# ------------------------------------------------------------------------------------ sums


def by_group(results: Iterable[Object]) -> Dict[str, List[Object]]:
    """The results of each group, sorted by the groups' names."""
    groups: Dict[str, List[Object]] = {}
    for result in results:
        groups.setdefault(result["group"], []).append(result)
    return dict(sorted(groups.items()))


def counts(results: List[Object], jobs: int) -> Object:
    """How the jobs ended."""
    findings = sum(bool(result.get("finding")) for result in results)
    return {"jobs": jobs, "passed": len(results) - findings, "findings": findings,
            "missing": jobs - len(results)}


def sums(results: List[Object]) -> Object:
    """The sum of each number that the results hold."""
    total: Object = {}
    for result in results:
        for key, value in result.items():
            if isinstance(value, (int, float)) and not isinstance(value, bool):
                total[key] = total.get(key, 0) + value
    return total


def spent(results: List[Object]) -> Object:
    """Seconds, and seconds of CPU."""
    return {key: add(result.get(key) or 0 for result in results) for key in ("seconds", "cpu")}


class Joined:
    """All results that stand."""

    def __init__(self, name: str, out: Path) -> None:
        self.out = out
        results = list(standing(out).values())
        self.lines = [{key: value for key, value in result.items() if key not in NOT_JOINED}
                      for result in results]
        self.times = {
            **spent(results), "hosts": sorted({result["host"] for result in results}),
            "groups": [{"group": group, **spent(members)}
                       for group, members in by_group(results).items()]}
        jobs: Dict[str, int] = {}
        for job in read_jobs(out / "jobs.tsv"):
            jobs[job.group] = jobs.get(job.group, 0) + 1
        members = by_group(self.lines)
        self.campaign = {
            "campaign": name, **counts(self.lines, sum(jobs.values())),
            "commits": sorted({line["commit"] for line in self.lines}),
            "by": sorted({line["by"] for line in self.lines}),
            "groups": [{"group": group, **counts(members.get(group, []), number),
                        **sums(members.get(group, []))} for group, number in sorted(jobs.items())]}
        self.cpu: Dict[str, Number] = {
            group["group"]: group["cpu"] for group in self.times["groups"]}

    def rate(self, group: Object) -> int:
        """Pairs or executions in a second of CPU; 0 if no time was taken."""
        number = group.get("pairs", group.get("executions", 0))
        seconds = self.cpu.get(group["group"], 0)
        return rounded(number / seconds) if seconds > 0 else 0

    def keep(self) -> None:
        """Writes all four files."""
        write_aside(self.out / "joined.jsonl", "".join(dump(line) + "\n" for line in self.lines))
        write_aside(self.out / "times.json", dump(self.times, 2) + "\n")
        write_aside(self.out / "campaign.json", dump(self.campaign, 2) + "\n")
        write_aside(self.out / "index.html", self.page())

    def text(self) -> str:
        """What is told: a line for each group, one for the campaign, the first errors."""
        lines = []
        for group in self.campaign["groups"]:
            more = ", ".join(f"{text(value)} {key}" for key, value in group.items()
                             if key not in COUNTS)
            has_rate = (group.get("pairs", group.get("executions", 0)) > 0
                        and self.cpu.get(group["group"], 0) > 0)
            lines.append(f"  {group['group']}: {ended(group)}" + (f"; {more}" if more else "")
                         + (f"; {self.rate(group)} a second of CPU" if has_rate else ""))
        lines.append(f"{self.campaign['campaign']}: {ended(self.campaign)}")
        errors = sorted(file for file in (self.out / "errors").glob("*") if file.is_file())
        for file in errors[:ERRORS_TOLD]:
            said = file.read_text(encoding="utf-8", errors="replace")
            lines.append("  error: " + said.split("\n", 1)[0])
        return "\n".join(lines) + "\n"

    def page(self) -> str:
        """index.html."""
        campaign = self.campaign
        rows = []
        for group in campaign["groups"]:
            more = ", ".join(f"{grouped(value)} {key}" for key, value in group.items()
                             if key not in COUNTS)
            cells = [*(group[key] for key in COUNTS),
                     rounded(self.cpu.get(group["group"], 0)), self.rate(group), more]
            rows.append("<tr>" + "".join(f"<td>{html(grouped(cell))}</td>" for cell in cells)
                        + "</tr>\n")
        hours = rounded(self.times["cpu"] / 36) / 100
        return (HEAD + f"<h1>{campaign['campaign']}: {campaign['passed']} of {campaign['jobs']} "
                f"jobs passed, {campaign['findings']} findings</h1>\n"
                f"<p>{campaign['missing']} missing; {text(hours)} hours of CPU, commit "
                f"{', '.join(campaign['commits'])}, {html('; '.join(campaign['by']))}</p>\n"
                + TABLE + "".join(rows) + "</table></body></html>\n")


def ended(of: Object) -> str:
    """How the jobs of a group or of the campaign ended."""
    return (f"{text(of['passed'])} of {text(of['jobs'])} jobs passed, {text(of['findings'])} "
            f"findings, {text(of['missing'])} missing")


HEAD = """<!DOCTYPE html>
<html lang="en"><head><meta charset="utf-8"><title>sepax: campaign</title>
<style>
body { font: 15px/1.5 sans-serif; max-width: 60em; margin: 2em auto; padding: 0 1em }
table { border-collapse: collapse; margin: 1em 0 }
td, th { border: 1px solid #ccc; padding: .2em .6em; text-align: right }
td:first-child, th:first-child, td:last-child { text-align: left }
</style></head><body>
"""
TABLE = ("<table><tr><th>group</th><th>jobs</th><th>passed</th><th>findings</th><th>missing</th>"
         "<th>seconds of CPU</th><th>a second</th><th>sums</th></tr>\n")
