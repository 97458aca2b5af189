# SPDX-License-Identifier: MIT
"""parts - what was measured, as files of a folder: each with its time, commit and tools."""
from __future__ import annotations

import subprocess
import sys
import time
from pathlib import Path
from typing import Any, Dict, Iterable, List, Optional, Sequence

from campaigns import jq_text
from campaigns.jq_text import Number, add

Object = Dict[str, Any]

PROOFS = """axi flights contracts stream_proofs tree_proofs tree_boxes tree_stack tree_progress
multipliers pairs_proofs product_proofs sum_proofs count_proofs tree_counts host_proofs""".split()


class Bad(Exception):
    """Why the page cannot be made, in one line."""


def said_by(command: Sequence[str]) -> Optional[str]:
    """Standard output of a command; None if it fails or is missing."""
    try:
        done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL,
                              text=True, errors="replace", check=False)
    except OSError:
        return None
    return done.stdout if done.returncode == 0 else None


def made_at(file: Path) -> str:
    """When the file was written, in UTC."""
    return time.strftime("%Y-%m-%d %H:%M", time.gmtime(file.stat().st_mtime))


def commit_at(file: Path) -> str:
    """What HEAD was when the file was written."""
    when = time.strftime("%Y-%m-%d %H:%M:%S", time.localtime(file.stat().st_mtime))
    return (said_by(["git", "rev-parse", "--short=12", f"HEAD@{{{when}}}"]) or "unknown").strip()


class Parts:
    """The parts of a folder; `told` has a row of verify.json for each that was asked for."""

    def __init__(self, build: Path) -> None:
        self.build = build
        self.told: List[Object] = []

    def values(self, name: str) -> List[Any]:
        """The JSON values of a file of BUILD; none if it is missing, empty or no JSON."""
        file = self.build / name
        if not file.is_file() or file.stat().st_size == 0:
            return []
        try:
            return jq_text.load_all(file.read_text(encoding="utf-8", errors="replace"))
        except ValueError as error:
            print(f"verify: {file}: not JSON, told as not run: {error}", file=sys.stderr)
            return []

    def tell(self, part: str, name: str, stands: bool, own: Optional[Object] = None) -> None:
        """Note whether a part was run, when, at which commits and by which tools. A campaign's
        `own` object says commits and tools."""
        own = own or {}
        file = self.build / name
        commit = commit_at(file) if stands else ""
        if own.get("commits") is not None:
            commit = ", ".join(names(own["commits"], f"{file}: commits"))
        self.told.append({"part": part, "file": name, "run": stands,
                          "made": made_at(file) if stands else "", "commit": commit,
                          "by": "; ".join(names(own.get("by") or [], f"{file}: by"))})

    def measured(self, part: str) -> List[Object]:
        """The list of a part that stands in BUILD/verify/PART.json under the part's name."""
        name = f"verify/{part}.json"
        values = self.values(name)
        stands = bool(values) and isinstance(values[0], dict)
        self.tell(part, name, stands)
        return objects(values[0].get(part) or [], f"{self.build / name}: {part}") if stands else []

    def slurm(self) -> Any:
        """What the trial on a Slurm cluster measured, or None."""
        values = self.values("slurm/slurm.json")
        self.tell("slurm", "slurm/slurm.json", bool(values))
        return values[0].get("slurm") if values and isinstance(values[0], dict) else None

    def campaign(self, name: str) -> Object:
        """campaign.json of a campaign; an empty object if it is missing."""
        file = f"campaign/{name}/campaign.json"
        values = self.values(file)
        stands = bool(values) and values[0] not in (None, False)
        own = values[0] if stands and isinstance(values[0], dict) else {}
        self.tell(f"campaign-{name}", file, stands, own)
        return own

    def groups(self, name: str, campaign: Object) -> List[Object]:
        """The groups of a campaign in which a job has ended, each with its seconds of CPU."""
        times = self.values(f"campaign/{name}/times.json")
        timed = times[0].get("groups") or [] if times and isinstance(times[0], dict) else []
        where = f"{self.build}/campaign/{name}"
        cpu = {group["group"]: group.get("cpu")
               for group in objects(timed, f"{where}/times.json: groups")}
        return [{**group, "cpu": cpu.get(group["group"]) or 0}
                for group in objects(campaign.get("groups", []), f"{where}/campaign.json: groups")
                if group["passed"] + group["findings"] > 0]

    def proofs(self) -> List[Object]:
        """The proofs among the tests of tb/tests, each with the last line of its log."""
        lines = Path("tb/tests").read_text(encoding="utf-8").splitlines()
        tests = {line.split("|")[0].strip() for line in lines if "|" in line}
        return [self.proof(name) for name in PROOFS if name in tests]

    def proof(self, name: str) -> Object:
        """One proof. Its status file has the exit status, seconds and seconds of CPU; 77 means
        that the test was skipped."""
        file = self.build / f"test/{name}.status"
        if not file.is_file() or file.stat().st_size == 0:
            return {"name": name, "run": False, "passed": False}
        words = file.read_text(errors="replace").split("\n", 1)[0].split(None, 2)
        status, seconds, cpu = words + ["none", "", ""][len(words):]
        log = self.build / f"test/{name}.log"
        lines = log.read_bytes().decode(errors="replace").split("\n") if log.is_file() else [""]
        last = lines[-1] or lines[-2] if len(lines) > 1 else lines[-1]
        return {"name": name, "run": status != "77", "passed": status == "0",
                "seconds": as_number(seconds), "cpu": as_number(cpu),
                "said": last.replace("\t", " "),
                "made": made_at(file), "commit": commit_at(file)}


def total(rows: Iterable[Object], key: str) -> Number:
    """The sum of a key; a row without it counts 0."""
    return add(row.get(key) or 0 for row in rows)


def as_number(word: str) -> Number:
    """The number that a word is, or 0."""
    try:
        value = jq_text.load(word)
    except ValueError:
        return 0
    return value if isinstance(value, (int, float)) and not isinstance(value, bool) else 0


def names(value: Any, where: str) -> List[str]:
    """The value, if it is a list of strings."""
    if not isinstance(value, list) or not all(isinstance(item, str) for item in value):
        raise Bad(f"{where} is no list of strings; remove the file or make it anew")
    return value


def objects(value: Any, where: str) -> List[Object]:
    """The value, if it is a list of objects."""
    if not isinstance(value, list) or not all(isinstance(item, dict) for item in value):
        raise Bad(f"{where} is no list of objects; remove the file or make it anew")
    return value
