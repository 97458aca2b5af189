# SPDX-License-Identifier: MIT
"""common - what Python scripts of synth share, as synth/common is what its shell scripts share.

A script's docstring holds its usage: a line that begins with "    synth/", and the lines after it
up to an empty line. Whatever cannot be done is raised as Failed; `run_main` turns it into one line
on standard error and exit status 2.
"""
from __future__ import annotations

import getopt
import gzip
import json
import math
import os
import re
import shutil
import subprocess
import sys
import zlib
from pathlib import Path
from typing import Any, Callable, Dict, List, Sequence, Tuple

Object = Dict[str, Any]

SYNTH = Path(__file__).resolve().parent
LIBRARY_CELLS = "read_liberty -lib -ignore_miss_func -ignore_miss_dir -ignore_miss_data_latch"
PLAIN_NUMBER = re.compile(r"[0-9]+\.?[0-9]*|\.[0-9]+")


class Failed(Exception):
    """Why it could not be done, in one line, and what the user can do."""


def run_main(name: str, main: Callable[[], None]) -> int:
    """Runs a script's `main`; returns its exit status. Tools read and print numbers with a point,
    whatever the locale says."""
    os.environ["LC_ALL"] = "C"
    try:
        main()
    except (Failed, OSError) as error:
        print(f"{name}: {error}", file=sys.stderr)
        return 2
    return 0


# ---------------------------------------------------------------------------------- arguments


def variable(name: str, default: str) -> str:
    """A variable of the environment; the default if it is empty, too."""
    return os.environ.get(name) or default


def default_library() -> str:
    """The cell library where none is given."""
    return variable("LIBERTY", "/usr/share/qflow/tech/osu018/osu018_stdcells.lib")


def reader() -> str:
    """The program that tells a Liberty file as JSON (synth/liberty)."""
    return f"{variable('BUILD', f'{SYNTH}/../build')}/liberty"


def other_corners(liberty: str) -> List[str]:
    """Files of the same cells at other corners: where the library is called *typ*, those beside it
    that are called *slow* and *fast* instead. synth/common has the same for shell scripts."""
    folder, name = os.path.split(liberty)
    return [] if "typ" not in name else [
        file for file in (os.path.join(folder, name.replace("typ", corner, 1))
                          for corner in ("slow", "fast")) if os.access(file, os.R_OK)]


def usage(docstring: str) -> Failed:
    """The usage that a script's docstring holds, in one line."""
    found = re.search(r"^    (synth/.*?)\n\n", docstring, re.M | re.S)
    assert found is not None
    return Failed("usage: " + " ".join(found[1].split()))


def options(letters: str, docstring: str) -> Tuple[Dict[str, str], List[str]]:
    """Options of the command line by letter, and its other arguments; `letters` is as of
    getopt."""
    try:
        given, rest = getopt.getopt(sys.argv[1:], letters)
    except getopt.GetoptError:
        raise usage(docstring) from None
    return {option[1:]: value for option, value in given}, rest


def check_number(option: str, value: str, what: str) -> None:
    """Refuses what is no number without a sign and an exponent."""
    if not PLAIN_NUMBER.fullmatch(value):
        raise Failed(f"{option} {value}: not a {what}")


def need_tools(*tools: str) -> None:
    """Refuses to begin without a tool."""
    for tool in tools:
        if shutil.which(tool) is None:
            raise Failed(f"{tool} not found; run scripts/setup, make build/liberty")


def need_library(file: str) -> None:
    """Refuses a library that cannot be read."""
    if not os.path.isfile(file) or not os.access(file, os.R_OK):
        raise Failed(f"cannot read the library {file}; give another")


def make_folder(folder: str) -> None:
    """Makes the folder of the results."""
    try:
        os.makedirs(folder, exist_ok=True)
    except OSError:
        raise Failed(f"cannot make {folder}; give another folder with -o") from None


# ------------------------------------------------------------------------------------ numbers


def plain(value: Any) -> Any:
    """A whole number without a point."""
    return int(value) if isinstance(value, float) and value == int(value) else value


def rounded(value: float, parts: int) -> Any:
    """The number, rounded half away from zero to so many parts of one."""
    return plain(math.copysign(math.floor(abs(value) * parts + 0.5), value) / parts)


# -------------------------------------------------------------------------------------- files


def read_json(file: Path) -> Any:
    """The JSON value of a file."""
    try:
        return json.loads(file.read_text(encoding="utf-8"))
    except ValueError as error:
        raise Failed(f"{file} is not JSON: {error}") from None


def write_json(file: Path, value: Any) -> None:
    """Writes JSON in one line."""
    file.write_text(json.dumps(value, separators=(",", ":"), ensure_ascii=False) + "\n",
                    encoding="utf-8")


def design_list(folder: Path, given: str) -> Path:
    """The list of the modules' files of the design in a folder: sepax.f, or PREFIX.f."""
    found = [file for file in sorted(folder.glob("*.f")) if file.with_suffix(".json").is_file()]
    if len(found) > 1:
        raise Failed(f"{given} holds several designs: {', '.join(file.name for file in found)}; "
                     "give each a folder of its own")
    if not found:
        raise Failed(f"{given} holds no design (sepax.f, sepax.json); "
                     f"make one with 'sepax gen -o {given}'")
    return found[0]


def option_of(design: Object, name: str) -> str:
    """The value of an option of the design that sepax.json describes, or an empty string."""
    found = re.search(f"--{name}=([^ ]+)", design.get("options", ""))
    return found[1] if found else ""


def plain_copy(library: str, copy: Path) -> None:
    """Copies a Liberty file, plain or .gz, as a plain file."""
    try:
        opened = gzip.open(library) if library.endswith(".gz") else open(library, "rb")
        with opened as source, copy.open("wb") as out:
            shutil.copyfileobj(source, out)
    except (OSError, EOFError, zlib.error):
        raise Failed(f"cannot read the library {library}; is it whole?") from None


def read_cells(library: Path, out: Path) -> Object:
    """The cells of a plain Liberty file; also written to `out`, as JSON."""
    with out.open("wb") as file:
        done = subprocess.run([reader(), str(library)], stdout=file, stderr=subprocess.PIPE,
                              check=False)
    if done.returncode != 0:
        raise Failed(done.stderr.decode(errors="replace").strip())
    cells = read_json(out)["cells"]
    if not cells:
        raise Failed(f"{library} has no cells; give a Liberty file")
    return cells


# -------------------------------------------------------------------------------------- tools


def run_tool(command: Sequence[str], out: Path, what: str) -> None:
    """Runs a filter of the project, its standard output in a file."""
    with out.open("wb") as file:
        done = subprocess.run(command, stdout=file, stderr=subprocess.PIPE, check=False)
    if done.returncode != 0:
        said = done.stderr.decode(errors="replace").strip().splitlines() or ["no message"]
        raise Failed(f"{what}: {said[0]}")


def first_line(command: Sequence[str], given: str = "") -> str:
    """The first line that a tool prints."""
    done = subprocess.run(command, input=given, stdout=subprocess.PIPE, text=True, check=False)
    return done.stdout.split("\n", 1)[0]


def standard_clock() -> float:
    """The clock period, in ns, of designs for which none is given."""
    sepax = variable("SEPAX", f"{variable('BUILD', f'{SYNTH}/../build')}/sepax")
    try:
        said = subprocess.run([sepax, "name", "--make"], stdout=subprocess.PIPE, text=True,
                              check=False).stdout
    except OSError:
        said = ""
    found = re.search(r"^CLOCK_NS=([0-9.]+)$", said.replace(" ", "\n"), re.M)
    if not found:
        raise Failed(f"{sepax} says no standard clock; make build/sepax")
    return float(found[1])


def run_yosys(folder: Path, script: str, library: str) -> None:
    """Yosys in a folder, which gets yosys.log."""
    with (folder / "yosys.out").open("wb") as out:
        done = subprocess.run([variable("YOSYS", "yosys"), "-q", "-l", "yosys.log", "-p", script],
                              cwd=folder, stdout=out, stderr=subprocess.STDOUT, check=False)
    if done.returncode == 0:
        return
    log = folder / "yosys.log"
    said = log.read_text(errors="replace") if log.exists() else ""
    error = re.search(r"^.*ERROR: (.*)$", said, re.M)
    raise Failed(f"yosys with {os.path.basename(library)}: {error[1] if error else ''} (see {log})")


def run_sta(folder: Path, script: Path, log: Path, values: Dict[str, Any]) -> str:
    """OpenSTA on a design; returns what it says, which also is in the log. `values` are set for
    the script: liberty (files), netlist, top, and what the script reads beside."""
    commands = folder / "sta.tcl"
    commands.write_text(
        "".join(f'set {name} "{value}"\n' for name, value in values.items())
        + f'source "{SYNTH}/common.tcl"\nsource "{script}"\nputs end\nexit\n')
    with log.open("wb") as out:
        done = subprocess.run([variable("STA", "sta"), "-no_splash", "-exit", str(commands)],
                              stdout=out, stderr=subprocess.STDOUT, check=False)
    if done.returncode != 0:
        raise Failed(f"OpenSTA fails; see {log}")
    said = log.read_text(errors="replace")
    checked = re.sub(r"^check_setup$.*?(^check_setup done$|\Z)", "", said, flags=re.M | re.S)
    found = re.search(r"^(warning|error).*", checked, re.M | re.I)
    if found:
        raise Failed(f"OpenSTA: {found[0]} (see {log})")
    if not said.endswith("end\n") or said.splitlines()[-1] != "end":
        raise Failed(f"OpenSTA stopped early; see {log}")
    commands.unlink()
    return said
