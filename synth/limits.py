#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""limits - whether the outputs of a mapped netlist keep what a Liberty file allows:
max_capacitance, max_transition and max_fanout of their pins.

The loads are those that OpenSTA tells (`tell_limits` of synth/common.tcl), with the limits of the
same corner's library, as build/liberty tells it. max_transition is judged by OpenSTA itself.

    synth/limits.py TOLD CELLS.json

prints the summary of what tell_limits wrote as JSON.
"""
from __future__ import annotations

import json
import re
import sys
from pathlib import Path
from typing import Dict, List, NamedTuple, Tuple

import common
from common import Failed, Object, rounded

KINDS = ("capacitance", "transition", "fanout")
PARTS = 10000
SLOPE = re.compile(r"^(\S+) +([0-9.]+) +([0-9.]+) +-?[0-9.]+ \((?:MET|VIOLATED)\)$", re.M)


class Reached(NamedTuple):
    """How much of a limit a pin reaches: 1 is the limit itself."""
    kind: str
    pin: str  # the path from the top
    value: float
    limit: float

    @property
    def share(self) -> float:
        """The value over the limit."""
        return self.value / self.limit


def plain_pin(name: str) -> str:
    """A pin's path as the netlist has it; OpenSTA escapes brackets."""
    return name.replace("\\", "")


def fan_out_weight(cells: Object) -> float:
    """What a pin counts in a fan-out: the largest fanout_load of the library, 1 if it says none."""
    return max((pin.get("fanout_load") or 1 for cell in cells.values()
                for pin in cell["pins"].values()), default=1)


def outputs(said: str, library: Object) -> List[Reached]:
    """The capacitance and the fan-out of each output that has such a limit."""
    cells, farad = library["cells"], library["capacitance_unit_f"]
    weight = fan_out_weight(cells)
    found = []
    for line in said.splitlines():
        words = line.split(" ")
        if words[0] != "output":
            continue
        _, name, kind, load, pins = words
        name = plain_pin(name)
        if kind not in cells:
            raise Failed(f"the corner's library has no cell {kind}")
        of_pin = cells[kind]["pins"][name.rsplit("/", 1)[1]]
        for what, value in (("capacitance", float(load) / farad), ("fanout", int(pins) * weight)):
            limit = of_pin.get(f"max_{what}")
            if limit:
                found.append(Reached(what, name, value, limit))
    return found


def slopes(said: str) -> List[Reached]:
    """What OpenSTA says of max_transition, in ps: the pin with least slack, and all that exceed
    theirs."""
    return [Reached("transition", plain_pin(pin), float(value), float(limit))
            for pin, limit, value in SLOPE.findall(said) if float(limit) > 0]


def judged(said: str, library: Object, most: float = 1) -> Tuple[Object, List[Reached]]:
    """A summary by limit (null where the library has none): share of the limit that the worst pin
    reaches, that pin, and how many are over; and the pins that are over, the worst first. Of
    capacitances those that reach more than the share `most` are among the latter."""
    reached = outputs(said, library) + slopes(said)
    summary: Object = {}
    for kind in KINDS:
        own = [one for one in reached if one.kind == kind]
        worst = max(own, key=lambda one: one.share, default=None)
        summary[kind] = worst and {
            "worst": rounded(worst.share, PARTS), "pin": worst.pin,
            "over": len({one.pin for one in own if one.share > 1})}
    over: Dict[Tuple[str, str], Reached] = {
        (one.kind, one.pin): one for one in reached
        if one.share > (most if one.kind == "capacitance" else 1)}
    return summary, sorted(over.values(), key=lambda one: (-one.share, one.kind, one.pin))


def run() -> None:
    """The whole command."""
    _, rest = common.options("", __doc__)
    if len(rest) != 2:
        raise common.usage(__doc__)
    told, cells = rest
    print(json.dumps(judged(Path(told).read_text(errors="replace"),
                            common.read_json(Path(cells)))[0]))


if __name__ == "__main__":
    sys.exit(common.run_main("limits", run))
