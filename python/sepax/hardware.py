# SPDX-License-Identifier: MIT
"""Hardware: the Verilog of a core or an engine, as files and objects, made by the program sepax."""
from __future__ import annotations

import csv
import json
import os
import re
import subprocess
from pathlib import Path as FilePath
from typing import Any, Dict, List, NamedTuple, Tuple, Union

from ._errors import ArgumentError, MissingError, SepaxError
from .paths import program

Path = Union[str, "os.PathLike[str]"]


class Port(NamedTuple):
    """A port of the top module. direction: "input" or "output". width: bits."""
    name: str
    direction: str
    width: int
    signed: bool
    about: str


class Estimate(NamedTuple):
    """What a design is estimated to take, before any synthesis; each with its error.

    gates: gate equivalents (Nangate45, typical). flip_flops. energy: nJ for a pair that is
    "separated", "colliding", "coplanar": (value, error). latency: cycles. latency_ns.
    pairs_per_second. said: all that the program said."""
    gates: float
    gates_error: float
    flip_flops: float
    flip_flops_error: float
    energy: Dict[str, Tuple[float, float]]
    latency: int
    latency_ns: float
    pairs_per_second: float
    said: Dict[str, Any]


class Accuracy(NamedTuple):
    """Wrong verdicts of a design on pairs of triangles that are made to be hard.

    design: its options. pairs, collisions: how many, and how many of them collide. missed: pairs
    that collide and are called separated; missed_share: the interval of 95 % of their share of the
    collisions. deepest: how deep the deepest of them reach into each other, in LSB. false_alarms,
    false_share: of the separated pairs likewise. widest: the widest gap of these, in LSB."""
    design: str
    pairs: int
    collisions: int
    missed: int
    missed_share: Tuple[float, float]
    deepest: float
    false_alarms: int
    false_share: Tuple[float, float]
    widest: float


class Design:
    """A design that was written.

    folder: where it is. top: name of the top module. latency: cycles from a pair to its verdict.
    ii: cycles from a pair to the next. word: bits of a coordinate. ports: a list of Port.
    files: the Verilog files. options: those that name the design. said: sepax.json as a dict.
    registers: for an engine, the files of its registers (C, Markdown, SystemRDL)."""

    def __init__(self, folder: Path, prefix: str) -> None:
        self.folder = FilePath(folder)
        with open(self.folder / f"{prefix}.json", encoding="utf-8") as file:
            self.said: Dict[str, Any] = json.load(file)
        self.options: str = self.said["options"]
        self.top = _top(self.folder, prefix, self.said)
        self.latency: int = self.said.get("latency")
        self.ii: int = self.said.get("ii")
        self.word: int = self.said.get("word")
        self.ports: List[Port] = [Port(p["name"], p["direction"], p["width"], p["signed"],
                                       p.get("about", "")) for p in self.said["ports"]]
        self.files: List[FilePath] = sorted(self.folder.glob("*.v"))
        self.registers: List[FilePath] = sorted(self.folder.glob("*registers.*"))

    def port(self, name: str) -> Port:
        """The port of this name. Raises ArgumentError."""
        for port in self.ports:
            if port.name == name:
                return port
        raise ArgumentError(f"there is no port {name}; the ports are "
                            f"{', '.join(p.name for p in self.ports)}")

    def __repr__(self) -> str:
        return (f"<Design {self.top} in {self.folder}: {len(self.files)} files, latency "
                f"{self.latency}, II {self.ii}>")


def _top(folder: FilePath, prefix: str, said: Dict[str, Any]) -> str:
    """The last of the modules that are listed is the top."""
    modules = said.get("modules") or [path.stem for path in folder.glob(f"{prefix}_top.v")]
    return str(modules[-1])


def _words(options: Dict[str, Any]) -> List[str]:
    """Options of the program from keywords: extent_a=40 is --extent-a=40."""
    words = []
    for name, value in options.items():
        flag = "--" + name.replace("_", "-")
        if value is None or value is False:
            continue
        if value is not True and not isinstance(value, (int, float, str)):
            raise TypeError(f"{name} is {value!r}; give a number, a name, or True")
        words.append(flag if value is True else f"{flag}={value}")
    return words


def _run(command: str, words: List[str]) -> str:
    try:
        done = subprocess.run([program(), command, *words], capture_output=True, text=True,
                              check=False)
    except OSError as error:
        raise MissingError(f"the program sepax does not run ({error}): pip install sepax-io, or "
                           "correct SEPAX_PROGRAM") from None
    if done.returncode != 0:
        said = done.stderr.strip().splitlines() or [f"status {done.returncode}"]
        raise ArgumentError(re.sub(rf"^sepax {command}: |^.*sepax: ", "", said[0]))
    return done.stdout


def generate(folder: Path, *, prefix: str = "sepax", **options: Any) -> Design:
    """Write the Verilog of a design into a folder, which is made if it is missing.

    options: those of `sepax gen`, with _ in place of -: word=18, ii=3, clock_ns=2.0, arch="exact",
      target="ecp5", stream="pair", lanes=16, tree=True, ... docs/reference/commands.md lists them.
    prefix: the first part of all names.
    Returns a Design. Raises ArgumentError with the option and its range, MissingError without the
    program (pip install sepax-io)."""
    if not isinstance(prefix, str) or not prefix.isidentifier():
        raise ArgumentError(f"prefix is {prefix!r}; give a name of Verilog")
    if not options.get("arch") in (None, "exact", "paper", "conference"):
        raise ArgumentError(f"arch is {options['arch']!r}; give exact, paper or conference")
    words = _words(options)
    _run("gen", [*words, f"--prefix={prefix}", "-o", os.fspath(folder)])
    try:
        return Design(folder, prefix)
    except (OSError, KeyError, json.JSONDecodeError) as error:
        raise SepaxError(f"{folder} has no design that can be read: {error}") from None


def estimate(**options: Any) -> Estimate:
    """Estimate a design without writing it. options: as for `generate`.
    Returns an Estimate. Raises ArgumentError, MissingError."""
    said = json.loads(_run("gen", [*_words(options), "--estimate", "--json"]))
    energy = {name: (value["nj"], value["error_nj"]) for name, value in
              (said.get("energy") or {}).items()}
    return Estimate(said["ge"], said["ge_error"], said["flip_flops"], said["flip_flops_error"],
                    energy, said["latency"], said["latency_ns"], said["pairs_per_second"], said)


def accuracy(*, family: str = "local", pairs: int = 100000, seed: int = 1, truth: str = "real",
             **options: Any) -> Accuracy:
    """Count the wrong verdicts of a design, by its golden model.

    family: of pairs; "local": triangles of all sizes near each other; `sepax vectors --list` lists
    them. pairs: how many. truth: "real": the right verdict is that of the triangles before they
    were rounded to W bits; "quantised": that of the rounded triangles, so that only the arithmetic
    of the design can be wrong. options: those of `sepax accuracy`: word, arch, precision, ...
    Returns an Accuracy. Raises ArgumentError, MissingError."""
    said = _run("accuracy", [*_words(options), f"--family={family}", f"--count={pairs}",
                             f"--seed={seed}", f"--truth={truth}", "--csv"])
    row = next(row for row in csv.DictReader(said.splitlines())
               if row["family"] == family and row["triangles"] == "any")

    def interval(name: str) -> Tuple[float, float]:
        return float(row[f"{name}_low"]), float(row[f"{name}_high"])
    return Accuracy(row["design"], int(row["pairs"]), int(row["collisions"]), int(row["missed"]),
                    interval("missed"), float(row["deepest_missed_lsb"]),
                    int(row["false_alarms"]), interval("false"), float(row["widest_false_lsb"]))


def plot_accuracy(axes: Any, words: Any = (8, 10, 12, 14, 16), *, gates: float = 1.212e6,
                  pairs: int = 100000, ii: int = 1, **options: Any) -> List[Accuracy]:
    """Draw speed against error, a point for each word length; matplotlib's axes.

    The speed is that of as many cores as fit into `gates`, which is the size of the paper's chip.
    The error is the share of collisions that are missed because coordinates are rounded to W bits:
    the interval of 95 %. pairs: pairs of triangles for each point.
    Returns the accuracies, in the order of `words`."""
    found = []
    for word in words:
        guess = estimate(word=word, ii=ii, **options)
        speed = guess.pairs_per_second * (gates // guess.gates)
        found.append(accuracy(word=word, pairs=pairs, **options))
        low, high = found[-1].missed_share
        middle = found[-1].missed / found[-1].collisions or high
        axes.errorbar(speed / 1e9, middle, yerr=[[middle - low], [high - middle]], color="#147",
                      marker="o" if low > 0 else "v", markersize=4, capsize=2, linewidth=1)
        axes.annotate(f"W = {word}", (speed / 1e9, middle), xytext=(6, 3),
                      textcoords="offset points", fontsize=8)
    axes.set_yscale("log")
    axes.margins(x=0.1, y=0.12)
    axes.set_xlabel(f"billion pairs a second, {gates / 1e3:.0f}K GE")
    axes.set_ylabel("collisions missed")
    return found


def plot_area(axes: Any, words: Any = (12, 18, 24), iis: Any = (1, 2, 3, 6, 9, 18),
              **options: Any) -> Dict[int, List[Estimate]]:
    """Draw gates against throughput, a line for each word length; matplotlib's axes.
    Returns the estimates by word length, in the order of `iis`."""
    found: Dict[int, List[Estimate]] = {}
    for word in words:
        found[word] = [estimate(word=word, ii=ii, **options) for ii in iis]
        axes.errorbar([e.pairs_per_second / 1e6 for e in found[word]],
                      [e.gates / 1e3 for e in found[word]],
                      yerr=[e.gates_error / 1e3 for e in found[word]], marker="o", capsize=2,
                      linewidth=1, markersize=3, label=f"{word} bits")
    axes.set_xscale("log")
    ticks = sorted({round(e.pairs_per_second / 1e6) for line in found.values() for e in line})
    axes.set_xticks(ticks, [str(t) for t in ticks])
    axes.minorticks_off()
    axes.set_xlabel("pairs a second, million")
    axes.set_ylabel("thousand GE")
    axes.legend(frameon=False)
    return found
