# SPDX-License-Identifier: MIT
"""lists - the jobs of each campaign of scripts/campaign.

A function of LISTS gives the jobs of its campaign. A job's command is a kind of
scripts/campaigns/kinds and its arguments.
"""
from __future__ import annotations

import hashlib
import os
import re
import shutil
import subprocess
import sys
from pathlib import Path
from typing import Callable, Dict, Iterator, List, Sequence

from campaigns.results import Job

WORDS = (18, 4, 8, 12, 16, 24, 32)
KINDS = "scripts/campaigns/kinds"


class Failed(Exception):
    """Why a campaign cannot begin, in one line."""


def run_kinds(command: str, *arguments: str) -> List[str]:
    """A shell command with the functions of scripts/campaigns/kinds. Its variables out, work, log
    and name are the first arguments, not of the environment, where make would read them."""
    script = f'set -u; out=$1 work=$2 log=$3 name=$4; shift 4; . {KINDS}; {command}'
    return ["sh", "-c", script, "campaign", *arguments]


class Lists:
    """The lists of a campaign `name` in the folder `out`; `groups` are the beginnings of the names
    of groups that are chosen, none: all."""

    def __init__(self, name: str, out: Path, work: Path, groups: Sequence[str]) -> None:
        self.name = name
        self.out = out
        self.work = work
        self.groups = groups

    def jobs(self) -> List[Job]:
        """The jobs that are chosen."""
        return list(LISTS[self.name](self))

    def chosen(self, group: str) -> bool:
        """Whether a group is to be made."""
        return not self.groups or any(group.startswith(begin) for begin in self.groups)

    # --------------------------------------------------------------------------------- programs

    def quiet(self, *command: str) -> None:
        """Runs a command that says something only if it fails."""
        try:
            done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                                  text=True, errors="replace", check=False)
        except OSError as error:
            raise Failed(str(error)) from None
        if done.returncode != 0:
            print("\n".join(done.stdout.splitlines()[-20:]), file=sys.stderr)
            raise Failed(f"{' '.join(command)} fails")

    def said(self, *command: str) -> str:
        """What a command prints, without the ends of the last lines."""
        try:
            done = subprocess.run(command, stdout=subprocess.PIPE, text=True, check=True)
        except (OSError, subprocess.CalledProcessError):
            raise Failed(f"{' '.join(command)} fails") from None
        return done.stdout.rstrip("\n")

    def keep(self, program: str, name: str) -> str:
        """Copies a program under a name with its checksum; returns its place below the campaign's
        folder. Debug information does not count."""
        bare = self.work / "kept"
        self.quiet("objcopy", "-g", "-R", ".note.gnu.build-id", program, str(bare))
        digest = hashlib.sha1(bare.read_bytes()).hexdigest()[:12]
        kept = f"tools/{name}-{digest}"
        copy = self.out / kept
        if not os.access(copy, os.X_OK):
            aside = copy.with_name(copy.name + ".new")
            shutil.copy(bare, aside)
            aside.replace(copy)
        return kept

    def cosim(self, word: int, ii: int) -> str:
        """The verilated design, kept."""
        if sys.stderr.isatty():
            print(f"campaign: exact, W = {word}, II = {ii} is verilated", file=sys.stderr)
        design = [f"WORD={word}", f"II={ii}"]
        core = self.said("make", "-s", "core", *design)
        self.quiet("make", "-s", f"{core}/cosim", *design)
        return self.keep(f"{core}/cosim", f"exact-w{word}-ii{ii}")

    def sources(self) -> str:
        """A checksum of the scripts and tools that a job runs."""
        return self.said(*run_kinds("sources", str(self.out), str(self.work), "/dev/null",
                                    self.name))

    def library(self) -> str:
        """The cell library, which is also set in the environment: Nangate45 where it is at
        hand."""
        for file in (os.environ.get("LIBERTY") or "", "../shared/pdk/nangate45_typ.lib.gz",
                     "/usr/share/qflow/tech/osu018/osu018_stdcells.lib"):
            if file and os.access(file, os.R_OK):
                os.environ["LIBERTY"] = file
                return file
        raise Failed("no cell library; give LIBERTY=file.lib[.gz]")

    # ------------------------------------------------------------------------------------ lists

    def hard(self) -> Iterator[Job]:
        """10^9 pairs through exact, W = 18, II = 1; what `make experiment NAME=hard` sends through
        each of 34 more designs; 10^10 through the library. A job is a second or two."""
        for ii in (1, 2, 3, 6, 9):
            for word in WORDS:
                if self.chosen(f"exact-w{word}-ii{ii}"):
                    yield from self.hard_design(word, ii)
        for word in (18, 4, 8, 12, 16, 20, 24, 28, 32):
            if self.chosen(f"library-w{word}"):
                yield from self.hard_library(word)

    def hard_design(self, word: int, ii: int) -> Iterator[Job]:
        """The jobs of one design."""
        group, tool = f"exact-w{word}-ii{ii}", self.cosim(word, ii)
        many = 1 if word != 18 else 1000 if ii == 1 else 20
        design = f"{word}{ii}"
        for number in range(1, many + 1):
            yield Job(group, f"{group}-families-{number:04d}",
                      f"pairs {tool} --count=1000000 --seed=1{design}{number:04d}")
        yield Job(f"{group}-stressed", f"{group}-stressed",
                  f"pairs {tool} --count=1050000 --seed=2{design} --stress=3{design}")
        yield Job(f"{group}-corners", f"{group}-corners", f"pairs {tool} --corners --count=20000")

    def hard_library(self, word: int) -> Iterator[Job]:
        """The jobs of the library at one word length."""
        self.quiet("make", "-s", "build/hard-pairs")
        group, tool = f"library-w{word}", self.keep("build/hard-pairs", "hard-pairs")
        for number in range(1, (3000 if word == 18 else 250) + 1):
            yield Job(group, f"{group}-{number:04d}",
                      f"pairs {tool} {word} 2000000 {word}{number:04d}")

    def exhaustive(self) -> Iterator[Job]:
        """The 3^18 pairs of coordinates -1, 0, 1 at each II, 3^13 in a job."""
        for ii in (1, 2, 3, 6, 9):
            group = f"exact-w18-ii{ii}"
            if self.chosen(group):
                tool = self.cosim(18, ii)
                for number in range(3 ** 5):
                    yield Job(group, f"{group}-{number:03d}", f"pairs {tool} "
                              f"--ternary={number * 3 ** 13} --count={3 ** 13}")

    def area_sweep(self) -> Iterator[Job]:
        """The designs of `make experiment NAME=area-sweep`."""
        library = self.library()
        sources = self.sources()
        for ii in (1, 2, 3, 4, 6, 9, 18):
            for word in (8, 12, 16, 18, 20, 24, 28, 32):
                group = f"w{word}-ii{ii}"
                if self.chosen(group):
                    yield Job(group, group, f"area {sources} {library} {word} {ii}")

    def calibrate(self) -> Iterator[Job]:
        """The designs of `make experiment NAME=calibrate`."""
        library = self.library()
        sources = self.sources()
        for clock in ("1", "1.5", "2", "3"):
            for ii in (1, 3):
                for word in (8, 12, 16, 18, 20, 24, 28, 32):
                    group = f"w{word}-ii{ii}-{clock}ns"
                    if self.chosen(group):
                        yield Job(group, group,
                                  f"calibrate {sources} {library} {word} {ii} {clock}")

    def accuracy(self) -> Iterator[Job]:
        """The design points of `make experiment NAME=accuracy`; those of the study `main` in ten
        jobs, a seed each."""
        points = self.said("scripts/experiments/accuracy", "-l").splitlines()
        tool = self.keep("build/sepax", "sepax")
        for point in points:
            study, pairs, flips, *options = point.split()
            group = re.sub(" [0-9]+ [0-9]+", "", point, count=1)
            group = re.sub("[ =]", "-", re.sub(" --nudges=[0-9]+|--", "", group))
            if not self.chosen(group):
                continue
            seeds = 10 if study == "main" else 1
            words = [f"--count={share(pairs, seeds)}"]
            words += [f"--flips={share(flips, seeds)}"] if int(flips) > 0 else []
            for option in options:
                name, _, value = option.partition("=")
                words.append(f"{name}={share(value, seeds)}" if name == "--nudges" else option)
            for seed in range(1, seeds + 1):
                yield Job(group, f"{group}-{seed}",
                          f"accuracy {tool} {' '.join(words)} --seed={seed}")

    def mutation(self) -> Iterator[Job]:
        """2,000 mutants of each design of `make experiment NAME=mutation`, 250 with a seed."""
        sources = self.sources()
        for line in self.said("make", "-s", "mutations").splitlines():
            variables = line.split()
            group = os.path.basename(self.said("make", "-s", "core", *variables))
            if self.chosen(group):
                options = self.said("make", "-s", "options", *variables)
                for seed in range(1, 9):
                    yield Job(group, f"{group}-{seed}", f"mutation {sources} 250 {seed} {options}")

    def fuzz(self) -> Iterator[Job]:
        """10^7 executions of each target and more, 100,000 in a job; the corpora of `make
        experiment NAME=fuzz` are where they begin."""
        clang = os.environ.get("CLANG")
        self.quiet("make", "-s", "fuzz-targets", *([f"CLANG={clang}"] if clang else []))
        (self.out / "corpus").mkdir(parents=True, exist_ok=True)
        if os.path.isdir("build/fuzz/corpus"):
            self.quiet("cp", "-rn", "build/fuzz/corpus", str(self.out))
        for file in sorted(Path("build/fuzz/fuzz").iterdir()):
            if self.chosen(file.name):
                tool = self.keep(str(file), file.name)
                for number in range(1, 101):
                    yield Job(file.name, f"{file.name}-{number:03d}",
                              f"fuzz {tool} {file.name} 100000 {number}")


def share(number: str, seeds: int) -> str:
    """A number divided among so many seeds."""
    return f"{int(number) / seeds:g}" if int(number) % seeds else str(int(number) // seeds)


LISTS: Dict[str, Callable[[Lists], Iterator[Job]]] = {
    "hard": Lists.hard, "exhaustive": Lists.exhaustive, "calibrate": Lists.calibrate,
    "area-sweep": Lists.area_sweep, "accuracy": Lists.accuracy, "mutation": Lists.mutation,
    "fuzz": Lists.fuzz}
