# SPDX-License-Identifier: MIT
"""area_limits - changes a mapped netlist where outputs exceed limits of the library: the cell
becomes a larger one of its kind, or, where there is none or too many pins read it, buffers take a
part of its load.

A module is changed once, for all of its instances. What was changed may exceed another limit, so
synth/area/map asks OpenSTA again until nothing is over.
"""
from __future__ import annotations

import math
import re
from typing import Dict, Iterable, Iterator, List, Optional, Tuple

from common import Object
from limits import Reached

SIZE = re.compile(r"(.*[^0-9])([0-9]+)")
MOST_GROUPS = 8  # that a net's readers are dealt to at once
Pin = Tuple[str, str]  # a cell of a module and its pin


def kind_of(cell: Object) -> str:
    """What a cell does, by its state and its pins: cells of a kind can take each other's place."""
    return repr((cell["state"], sorted((name, pin["direction"], pin["function"])
                                       for name, pin in cell["pins"].items())))


def larger_cells(cells: Object) -> Dict[str, List[str]]:
    """For each cell the larger ones of its name and kind, in order: NAND2_X2, NAND2_X4 of
    NAND2_X1."""
    families: Dict[Tuple[str, str], List[Tuple[int, str]]] = {}
    for name, cell in cells.items():
        size = SIZE.fullmatch(name)
        if size:
            families.setdefault((size[1], kind_of(cell)), []).append((int(size[2]), name))
    return {name: [other for bigger, other in sorted(family) if bigger > size]
            for family in families.values() for size, name in family}


def buffers(cells: Object) -> List[Tuple[str, str, str]]:
    """The library's buffers with their input and output, the smallest first."""
    found = []
    for name, cell in cells.items():
        inputs = [pin for pin, of in cell["pins"].items() if of["direction"] == "input"]
        out = [pin for pin, of in cell["pins"].items() if of["direction"] == "output"]
        if len(inputs) == len(out) == 1:
            function = re.sub("[ ();]", "", cell["pins"][out[0]]["function"] or "")
            if function in (inputs[0], "!!" + inputs[0]):
                found.append((cell["area"] or 0, name, inputs[0], out[0]))
    return [(name, pin, out) for _, name, pin, out in sorted(found)]


def clock_pins(cell: Object) -> List[str]:
    """The pins of a register, latch or clock gate at which a clock comes."""
    of_state = " ".join(part.get("clocked_on") or part.get("enable") or ""
                        for part in cell["state"])
    return re.findall(r"\w+", of_state) + [
        name for name, pin in cell["pins"].items() if pin.get("clock_gate") == "clock"]


class Mender:
    """A netlist that is changed in place, once. What cells a net comes to is kept, because it only
    weighs loads."""

    def __init__(self, netlist: Object, top: str, cells: Object, drive: int) -> None:
        self.modules = netlist["modules"]
        self.top = top
        self.cells = cells
        self.larger = larger_cells(cells)
        self.buffer = (buffers(cells)[:drive] or [None])[-1]
        self.clocks = {name: clock_pins(cell) for name, cell in cells.items()}
        self.read: Dict[str, Dict[int, List[Tuple[Pin, int]]]] = {}  # by module and net
        self.reached: Dict[Tuple[str, int], List[Pin]] = {}
        self.next: Dict[str, int] = {}  # a net's number, by module

    def place(self, path: str) -> Tuple[str, str, str]:
        """The module, the cell in it and the pin that a path from the top leads to."""
        *instances, cell, pin = path.split("/")
        module = self.top
        for instance in instances:
            module = self.modules[module]["cells"][instance]["type"]
        return module, cell, pin

    # ------------------------------------------------------------------------------- what is read

    def is_output(self, kind: str, pin: str) -> bool:
        """Whether a pin of a cell, or of an instance of a module, drives its net."""
        of = self.cells[kind]["pins"] if kind in self.cells else self.modules[kind]["ports"]
        return of.get(pin, {}).get("direction") == "output"

    def readers(self, module: str, net: int) -> List[Tuple[Pin, int]]:
        """The pins of cells and instances of a module that read a net, with the place in it."""
        if module not in self.read:
            found: Dict[int, List[Tuple[Pin, int]]] = {}
            for name, cell in self.modules[module]["cells"].items():
                for pin, bits in cell["connections"].items():
                    if not self.is_output(cell["type"], pin):
                        for place, bit in enumerate(bits):
                            if isinstance(bit, int):
                                found.setdefault(bit, []).append(((name, pin), place))
            self.read[module] = found
        return self.read[module].get(net, [])

    def leaves(self, module: str, reader: Pin, place: int) -> List[Pin]:
        """The library's cells and pins that a reader comes to, through the hierarchy below."""
        kind = self.modules[module]["cells"][reader[0]]["type"]
        if kind in self.cells:
            return [(kind, reader[1])]
        net = self.modules[kind]["ports"][reader[1]]["bits"][place]
        if (kind, net) not in self.reached:
            self.reached[kind, net] = [leaf for inner, at in self.readers(kind, net)
                                       for leaf in self.leaves(kind, inner, at)]
        return self.reached[kind, net]

    def new_nets(self, module: str, number: int) -> int:
        """The first of so many new nets of a module, which has other readers from now on."""
        if module not in self.next:
            self.next[module] = 1 + max(bit for of in self.modules[module]["netnames"].values()
                                        for bit in of["bits"] if isinstance(bit, int))
        self.read.pop(module, None)
        first = self.next[module]
        self.next[module] += number
        return first

    def load(self, leaves: Iterable[Pin]) -> float:
        """What cells' pins are to who drives them, in the library's unit."""
        return sum(self.cells[kind]["pins"][pin]["capacitance"] or 0 for kind, pin in leaves)

    # ------------------------------------------------------------------------------ what is changed

    def mend(self, over: List[Reached]) -> int:
        """Changes what drives the pins that are over a limit, once for each cell; how many were
        changed."""
        worst: Dict[Tuple[str, str, str], Reached] = {}
        for one in over:
            module, cell, pin = self.place(one.pin)
            kind = self.modules[module]["cells"][cell]["type"]
            if self.is_output(kind, pin):  # what reads a net with a late slope has a driver
                worst.setdefault((module, cell, pin), one)
        return sum(self.mend_one(module, cell, pin, one)
                   for (module, cell, pin), one in worst.items())

    def mend_one(self, module: str, name: str, pin: str, one: Reached) -> bool:
        """Another size, or a buffer; whether there was either."""
        cell = self.modules[module]["cells"][name]
        if one.kind != "fanout":
            found = self.size_for(cell["type"], pin, one)
            if found:
                cell["type"] = found
                return True
        return self.split(one)

    def size_for(self, kind: str, pin: str, one: Reached) -> Optional[str]:
        """The least larger cell; for a capacitance the least that may drive it, or the largest."""
        larger = self.larger.get(kind, [])
        if one.kind == "capacitance":
            fits = [name for name in larger
                    if (self.cells[name]["pins"][pin].get("max_capacitance") or 0) >= one.value]
            return (fits or larger[-1:] or [None])[0]
        return larger[0] if larger else None

    def split(self, one: Reached) -> bool:
        """Puts buffers into the net that a path's pin drives: in that module which has the most
        readers of it, one for each group of them but the first; where none has two, one in front of
        all that the pin drives. There are as many groups as the net exceeds its limit, two at
        least. A clock is not split."""
        *instances, name, pin = one.pin.split("/")
        module, _, _ = self.place(one.pin)
        cell = self.modules[module]["cells"][name]
        net = cell["connections"][pin][0]
        parts = [(of, inner, [(reader, at, self.leaves(of, reader, at))
                              for reader, at in self.readers(of, inner)])
                 for of, inner in self.parts(instances, module, net)]
        if self.buffer is None or any(pin in self.clocks[kind] for _, _, found in parts
                                      for _, _, leaves in found for kind, pin in leaves):
            return False
        buffer, pin_in, pin_out = self.buffer
        most, inner, found = max(parts, key=lambda part: len(part[2]))
        if len(found) < 2:
            most, inner = module, net
        here = self.modules[most]
        groups = min(max(2, math.ceil(one.share)), MOST_GROUPS)
        new = self.new_nets(most, groups)
        if len(found) > 1:
            nets = [(inner, bit) for bit in self.move(here, found, inner, new, groups)]
        else:
            cell["connections"][pin] = [new]
            nets = [(new, net)]
        for number, (source, driven) in enumerate(nets, new):
            here["cells"][f"fanout_{number}_limit"] = {
                "type": buffer, "connections": {pin_in: [source], pin_out: [driven]}}
            here["netnames"][f"fanout_{number}_net"] = {"bits": [number]}
        return True

    def parts(self, instances: List[str], module: str, net: int) -> List[Tuple[str, int]]:
        """The modules, and the nets in them, that a net of a module leads to: itself, those below,
        and through output ports those above. `instances` lead from the top to the module."""
        found = [(module, net), *self.parts_below(module, net)]
        if instances:
            [above, instance, _] = self.place("/".join([*instances, ""]))
            connections = self.modules[above]["cells"][instance]["connections"]
            for port, of in self.modules[module]["ports"].items():
                if of["direction"] == "output":
                    for bit, outside in zip(of["bits"], connections.get(port, [])):
                        if bit == net and isinstance(outside, int):
                            found += self.parts(instances[:-1], above, outside)
        return found

    def parts_below(self, module: str, net: int) -> Iterator[Tuple[str, int]]:
        """The modules below in which a net is read."""
        for (name, pin), place in self.readers(module, net):
            kind = self.modules[module]["cells"][name]["type"]
            if kind in self.modules:
                inner = self.modules[kind]["ports"][pin]["bits"][place]
                yield kind, inner
                yield from self.parts_below(kind, inner)

    def move(self, here: Object, found: List[Tuple[Pin, int, List[Pin]]], net: int, new: int,
             groups: int) -> List[int]:
        """Deals readers to groups of about the same load. The first group stays, unless an output
        port keeps the net; each of the others gets a net from `new` on. Returns these nets."""
        at_ports = any(net in port["bits"] and port["direction"] == "output"
                       for port in here["ports"].values())
        first = 1 if at_ports else 0
        whole = sum(self.load(leaves) for _, _, leaves in found) or 1
        before = 0.0
        dealt: Dict[int, int] = {}
        for number, ((name, pin), place, leaves) in enumerate(found):
            group = first + min(int(before / whole * (groups - first)), groups - first - 1)
            if number == len(found) - 1 and not dealt:
                group = max(group, 1)
            if group > 0:
                bit = dealt.setdefault(group, new + len(dealt))
                here["cells"][name]["connections"][pin][place] = bit
            before += self.load(leaves)
        return list(dealt.values())
