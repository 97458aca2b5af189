# SPDX-License-Identifier: MIT
"""area_efforts - how hard abc maps each module where synth/area/map sizes cells for a clock.

The efforts of the modules rise until the clock is met. Modules on paths that are too slow are
mapped again with a higher effort; a module that becomes slower by the last effort goes back.
"""
from __future__ import annotations

import re
from typing import Dict, Iterable, List, Sequence, Tuple

# No cell drives more than N others, and each piece of logic between registers and full adders is to
# be done in D ps (of Nangate45): N:D. The last effort maps for delay, where larger cells load the
# registers before them.
EFFORTS = """24:1300 24:920 24:860 24:800 16:900 12:800 10:700 8:600 6:500 5:400
24:860:map,-B,0.9""".split()
HIGHEST = len(EFFORTS)
ROUNDS = 16
WIDE, NARROW = 3, 10  # modules rise that take a third of a slow path; else those that take a tenth

SCRIPT = "+strash;dch,-f;{map};topo;buffer,-c,-N,{n};topo;upsize,-D,{d};dnsize,-D,{d}"

Efforts = Dict[str, int]
Times = Dict[str, float]


def abc_script(effort: int, scale: float) -> str:
    """What abc is asked of an effort, 1 ... HIGHEST. `scale` is the time of the library's corner
    and of the period, relative to Nangate45 at the design's own clock."""
    fan_out, picoseconds, *mapper = EFFORTS[effort - 1].split(":")
    limit = int(int(picoseconds) * scale)
    return SCRIPT.format(map=f"{mapper[0]},-D,{limit}" if mapper else "amap,-m", n=fan_out, d=limit)


def abc_commands(efforts: Efforts, before: Efforts, scale: float) -> str:
    """Yosys commands that map the modules whose effort has changed, and select them."""
    changed = [module for module in efforts if efforts[module] != before.get(module)]
    lines = []
    for effort in range(1, HIGHEST + 1):
        modules = [module for module in changed if efforts[module] == effort]
        if modules:
            lines.append(f"abc -liberty liberty.lib -script {abc_script(effort, scale)} "
                         + " ".join(modules))
    return "\n".join([*lines, " ".join(["select", *changed])])


def first_effort(period: float, scale: float) -> int:
    """The lowest effort whose D is well within the period, in ns; else the highest."""
    for number, effort in enumerate(EFFORTS, 1):
        if int(effort.split(":")[1]) * scale <= 800 * period:
            return number
    return HIGHEST


def as_text(efforts: Efforts) -> str:
    """A module and its effort a line."""
    return "".join(f"{module} {effort}\n" for module, effort in efforts.items())


def rows(text: str) -> List[Tuple[str, str]]:
    """A module and a value a line."""
    return [(module, value) for module, value in map(str.split, text.splitlines())]


def risen_to_last(before: Efforts, after: Efforts) -> List[str]:
    """The modules that have just got the highest effort."""
    return [module for module, effort in after.items()
            if effort == HIGHEST and before[module] < HIGHEST]


def slowed(modules: Iterable[str], before: Times, now: Times) -> List[str]:
    """Of these modules those that take longer of a slow path than before."""
    return [module for module in modules if now.get(module, 0) > before.get(module, 0)]


def hierarchy(modules: Dict[str, Dict]) -> str:
    """Of a netlist's instances of modules: the module, the instance, its module; one a line."""
    return "".join(f"{name} {instance} {cell['type']}\n" for name, module in modules.items()
                   for instance, cell in module["cells"].items() if cell["type"] in modules)


def worst_slack(said: str) -> str:
    """The worst slack, in ns, that OpenSTA says; empty if it finds no path."""
    found = re.findall(r"^worst slack.*?(\S+)$", said, re.M)
    return found[-1] if found else ""


def plain_modules(names: Sequence[Dict[str, str]], cells: Dict) -> List[str]:
    """The modules of names.json that are no cells, sorted."""
    return sorted({row["plain"] for row in names} - set(cells))
