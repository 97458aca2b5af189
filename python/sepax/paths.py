# SPDX-License-Identifier: MIT
"""Paths of robots: proofs for the motion between rows, and pages that show a path.

They are made by the program sepax: that of sepax-io, or the one that SEPAX_PROGRAM names, or the
one on PATH."""
from __future__ import annotations

import json
import os
import re
import shutil
import subprocess
import tempfile
from pathlib import Path as FilePath
from typing import Any, Dict, List, NamedTuple, Optional, Tuple, Union

import numpy as np

from . import _arrays
from ._errors import ArgumentError, FileError, MissingError, SepaxError

VERDICTS = {0: "free", 1: "collision", 3: "warning", 4: "undecided"}
Path = Union[str, "os.PathLike[str]"]


def program() -> str:
    """The path of the program sepax. Raises MissingError, which says how to install it."""
    given = os.environ.get("SEPAX_PROGRAM")
    if given:
        return given
    try:
        import sepax_io  # pylint: disable=import-outside-toplevel
        inside = FilePath(sepax_io.__file__).parent / "bin" / "sepax"
        if inside.is_file():
            return str(inside)
    except ImportError:
        pass
    found = shutil.which("sepax")
    if found is None:
        raise MissingError("the program sepax is not here: pip install sepax-io, or build it and "
                           "name it in SEPAX_PROGRAM")
    return found


class Certificate(NamedTuple):
    """What was proved of one pair of bodies between the rows.

    certified: free from the first row to the last. intervals: into how many the motion was
    divided. open, collision: where it is open, or where bodies meet; None if there is no such
    place. A place is a dict: `row`; `part` of the way to the next row, 0 ... 1, or its two ends;
    of a collision also `values`, {name of a joint: value}; of an open place `distance` in m."""
    certified: bool
    intervals: int
    open: Optional[Dict[str, Any]]
    collision: Optional[Dict[str, Any]]


class PairResult(NamedTuple):
    """One pair of bodies. least: (least, most) of its least clearance over all rows, in metres;
    row: where it is; points: (2, 3), the nearest points; these are None if bodies collide in no
    known way or nothing was measured. rows: number of rows with each verdict."""
    links: Tuple[str, str]
    verdict: str
    rows: Dict[str, int]
    least: Optional[Tuple[float, float]]
    row: Optional[int]
    points: Optional[np.ndarray]
    between: Optional[Certificate]


class Place(NamedTuple):
    """Where a path is not free first. row: number of the row. part: of the way to the next row,
    0 ... 1; 0: in the row itself. links: the names of the two bodies. values: {name of a joint:
    value}."""
    row: int
    part: float
    links: Tuple[str, str]
    values: Dict[str, float]


class PathResult:
    """The verdict on a path; ask `free`, as the result itself is neither true nor false.

    verdict: "free", "collision", "warning" or "undecided". pairs: a PairResult for each pair.
    first: the Place where it is not free first; None if all is free, or if the place is not known.
    proof: the file of the proof; None if none was asked for, or if not all is free.
    said: all that the program said, as a dict; its lines are those of a file in which row 0 is
    line 2."""

    def __init__(self, said: Dict[str, Any], proof: Optional[str]) -> None:
        self.said = said
        self.verdict: str = said["verdict"]
        self.proof = proof
        self.pairs: List[PairResult] = [_pair(p) for p in said["pairs"]]
        self.first = _first(said)

    def __bool__(self) -> bool:
        raise TypeError("the verdict on a path is neither true nor false; use .free or .verdict")

    @property
    def free(self) -> bool:
        """Free in all rows and between them."""
        return self.verdict == "free"

    @property
    def certified(self) -> bool:
        """The motion between the rows was proved free for each pair."""
        return all(p.between is not None and p.between.certified for p in self.pairs)

    def least(self) -> Optional[PairResult]:
        """The pair with the least clearance over all rows."""
        measured = [(p.least[1], n) for n, p in enumerate(self.pairs) if p.least is not None]
        return self.pairs[min(measured)[1]] if measured else None

    def __repr__(self) -> str:
        least = self.least()
        near = f", least clearance {least.least[0]!r} m of {' and '.join(least.links)} in row " \
               f"{least.row}" if least and least.least else ""
        first = ""
        if self.first:
            links, row = " and ".join(self.first.links), self.first.row
            first = f" of {links} " + (f"between rows {row} and {row + 1}" if self.first.part
                                       else f"in row {row}")
            near = ""
        return (f"<{self.verdict}{first}{', certified between the rows' if self.certified else ''}"
                f"{near}>")


def _place(place: Optional[Dict[str, Any]]) -> Optional[Dict[str, Any]]:
    """Lines of the file are 1 for the header, so row 0 is line 2."""
    if place is None:
        return None
    found = {"row": place["from"]["line"] - 2, "part": place["part"]}
    if "values_m_rad" in place:
        found["values"] = place["values_m_rad"]
    if place.get("distance_mm") is not None:
        found["distance"] = place["distance_mm"] / 1000
    return found


def _first(said: Dict[str, Any]) -> Optional[Place]:
    """The first place, and the pair of which this is the first place."""
    place = said.get("first")
    if place is None:
        return None
    for pair in said["pairs"]:
        between = (pair.get("between") or {}).get("collision")
        if place["part"]:
            here = between is not None and (between["from"]["line"], between["part"]) == (
                place["line"], place["part"])
        else:
            here = any(pair["first"][kind] and pair["first"][kind]["line"] == place["line"]
                       for kind in ("collision", "undecided", "warning"))
        if here:
            return Place(place["line"] - 2, place["part"], (pair["a"], pair["b"]),
                         dict(place.get("values_m_rad") or {}))
    return None


def _pair(said: Dict[str, Any]) -> PairResult:
    least, between = said.get("least_clearance"), said.get("between")
    low, high = least["interval_mm"] if least else (0, 0)
    interval = (low / 1000, high / 1000) if least else None
    return PairResult(
        (said["a"], said["b"]), said["verdict"], dict(said["lines"]), interval,
        least["line"] - 2 if least else None,
        np.array(least["points_mm"]) / 1000 if least and least.get("points_mm") else None,
        Certificate(bool(between["certified"]), int(between["intervals"]),
                    _place(between.get("open")), _place(between.get("collision")))
        if between else None)


def _csv(mechanism: Any, values: Any, times: Any) -> str:
    rows, _ = mechanism._rows(values)  # pylint: disable=protected-access
    driven = mechanism._driven  # pylint: disable=protected-access
    if not len(rows):
        raise ArgumentError("the path has no rows")
    for name in mechanism.driven:
        if any(c in name for c in ',"\n\r[]'):
            raise ArgumentError(f"joint {name!r} has a comma, quote or bracket in its name")
    units = ["m" if mechanism.joints[n].kind == "prismatic" else "rad" for n in driven]
    heads = [f"{name} [{unit}]" for name, unit in zip(mechanism.driven, units)]
    columns = [rows[:, n] for n in driven]
    if times is not None:
        seconds = _arrays.numbers(times, "times", "fiu").astype(np.float64)
        if seconds.shape != (len(rows),):
            raise ArgumentError(f"times have the shape {seconds.shape}; give ({len(rows)},)")
        heads.insert(0, "time [s]")
        columns.insert(0, seconds)
    lines = [",".join(heads)]
    lines += [",".join(repr(float(x)) for x in row) for row in zip(*columns)]
    return "\n".join(lines) + "\n"


def _run(mechanism: Any, values: Any, times: Any, options: List[str], folder: str) -> Any:
    files = mechanism._files  # pylint: disable=protected-access
    if files is None:
        raise ArgumentError("the mechanism was made in Python; the motion between rows is checked "
                            "for one of Mechanism.from_urdf")
    urdf, srdf, packages, unit, polygons = files
    path = os.path.join(folder, "path.csv")
    with open(path, "w", encoding="utf-8") as file:
        file.write(_csv(mechanism, values, times))
    command = [program(), "path", "--json", *options]
    command += [f"--srdf={srdf}"] if srdf else []
    command += [f"--package={name}:{where}" for name, where in packages]
    command += [f"--unit={unit!r}m"] if unit is not None else []
    command += [f"--polygons={polygons}"]
    command += ["--surfaces"] if mechanism.surfaces else []
    try:
        done = subprocess.run([*command, urdf, path], capture_output=True, text=True, check=False)
    except OSError as error:
        raise MissingError(f"the program sepax does not run ({error}): pip install sepax-io, or "
                           "correct SEPAX_PROGRAM") from None
    if done.returncode not in VERDICTS:
        raise _failed(done.stderr.strip() or f"status {done.returncode}", path)
    return json.loads(done.stdout)


def _failed(said: str, path: str) -> SepaxError:
    """The error of the program, in the words of a Python user: rows for lines of the path, which
    begin after one line of names, and arguments for options."""
    said = re.sub(r"^(\S*/)?sepax path: ", "", said)
    of_path = f"{path}:" in said
    said = re.sub(rf"{re.escape(path)}:(\d+)", lambda m: f"row {int(m[1]) - 2}", said)
    said = said.replace(path, "the path").replace("--ignore-limits", "ignore_limits=True")
    said = re.sub(r"--package=(\w+):FOLDER", r'packages={"\1": FOLDER}', said)
    said = re.sub(r"--(clearance|warning|resolution|intervals|unit)\b", r"\1", said)
    if " rad is " in said and "limit" in said:
        said += "; a value of this joint is in radians"
    kind = ArgumentError if of_path else FileError if "cannot" in said else SepaxError
    return kind(said)


def _length(name: str, value: Optional[float]) -> List[str]:
    if value is None:
        return []
    return [f"--{name}={_arrays.number_of(value, name, 0.0, 1e9)!r}m"]


def certify(mechanism: Any, values: Any, *, times: Any = None, clearance: Optional[float] = None,
            warning: Optional[float] = None, resolution: Optional[float] = None,
            intervals: Optional[int] = None, proof: Optional[Path] = None,
            ignore_limits: bool = False, threads: Optional[int] = None) -> PathResult:
    """Check the rows of a path and the motion between them, in which all joints move linearly.
    The files of the mechanism are read again, as the proof names them with their sums.

    mechanism: of Mechanism.from_urdf. values: rows of joint values, as for Mechanism.check.
    times: (n,) seconds, or None. clearance, warning: lengths in m; up to `clearance` two bodies
      collide, up to `warning` they are reported. resolution: motions of so many m are not divided
      further (1e-6). intervals: at most so many for each pair (262,144), and
      one for each motion.
    proof: a folder that gets path.csv and certificate.json, the proof for the program
      sepax-certificate-check (docs/reference/certificate.md).
    ignore_limits: accept values beyond the limits of their joints.
    Returns PathResult. Raises MissingError without the program sepax, ArgumentError, SepaxError
    with the line and the cure."""
    options = ["--certify", *_length("clearance", clearance), *_length("warning", warning),
               *_length("resolution", resolution)]
    options += ["--ignore-limits"] if ignore_limits else []
    count = _arrays.count_of(intervals, "intervals", 2**40)
    options += [f"--intervals={count}"] if count else []
    workers = _arrays.threads_of(threads)
    options += [f"--threads={workers}"] if workers else []
    if proof is None:
        with tempfile.TemporaryDirectory() as folder:
            return PathResult(_run(mechanism, values, times, options, folder), None)
    try:
        os.makedirs(proof, exist_ok=True)
    except OSError as error:
        raise _not_written(proof, error) from None
    file = os.path.join(os.fspath(proof), "certificate.json")
    said = _run(mechanism, values, times, [*options, f"--certificate={file}"], os.fspath(proof))
    return PathResult(said, file if said["verdict"] == "free" and os.path.exists(file) else None)


def _not_written(path: Path, error: OSError) -> FileError:
    return FileError(f"{os.fspath(path)}: {error.strerror}; give a place that can be written")


class Page:
    """A page of a path: a notebook shows it; `html` is its text."""

    def __init__(self, html: str, height: int) -> None:
        self.html = html
        self._height = height

    def _repr_html_(self) -> str:
        import html  # pylint: disable=import-outside-toplevel
        return (f'<iframe srcdoc="{html.escape(self.html, quote=True)}" '
                f'style="width: 100%; height: {self._height}px; border: 0"></iframe>')

    def __repr__(self) -> str:
        return f"<Page of {len(self.html)} characters; the last value of a cell shows it>"


def page(mechanism: Any, values: Any, file: Optional[Path] = None, *, times: Any = None,
         clearance: Optional[float] = None, warning: Optional[float] = None,
         ignore_limits: bool = False, height: int = 640) -> Page:
    """An HTML page that shows the bodies in a browser and plays the path (WebGL, no network).

    file: also write it there. height: of the frame in a notebook, in pixels. The other arguments
    are those of `certify`. It needs three.js: the package libjs-three of Debian, or a folder in
    the environment variable SEPAX_THREE. Returns a Page, which a notebook shows."""
    with tempfile.TemporaryDirectory() as folder:
        made = os.path.join(folder, "page.html")
        options = [f"--page={made}", *_length("clearance", clearance),
                   *_length("warning", warning)]
        options += ["--ignore-limits"] if ignore_limits else []
        _run(mechanism, values, times, options, folder)
        with open(made, encoding="utf-8") as text:
            html = text.read()
    if file is not None:
        try:
            with open(file, "w", encoding="utf-8") as out:
                out.write(html)
        except OSError as error:
            raise _not_written(file, error) from None
    return Page(html, height)
