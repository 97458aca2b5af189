# SPDX-License-Identifier: MIT
"""area_limits - changes a mapped netlist where outputs exceed limits of the library: the cell
becomes a larger one of its kind, or, where there is none or too many pins read it, a buffer takes
half of its load.

A module is changed once, for all of its instances. What was changed may exceed another limit, so
synth/area/map asks OpenSTA again until nothing is over.
"""
from __future__ import annotations

import re
from typing import Dict, Iterable, Iterator, List, Optional, Tuple

from common import Object
from limits import Reached

SIZE = re.compile(r"(.*[^0-9])([0-9]+)")
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
    """A netlist that is changed in place."""

    def __init__(self, netlist: Object, top: str, cells: Object, drive: int) -> None:
        self.modules = netlist["modules"]
        self.top = top
        self.cells = cells
        self.larger = larger_cells(cells)
        self.buffer = (buffers(cells)[:drive] or [None])[-1]
        self.clocks = {name: clock_pins(cell) for name, cell in cells.items()}

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

    def readers(self, module: str, net: int) -> Iterator[Tuple[Pin, int]]:
        """The pins of cells and instances of a module that read a net, with the place in it."""
        for name, cell in self.modules[module]["cells"].items():
            for pin, bits in cell["connections"].items():
                if net in bits and not self.is_output(cell["type"], pin):
                    for place, bit in enumerate(bits):
                        if bit == net:
                            yield (name, pin), place

    def leaves(self, module: str, reader: Pin, place: int) -> List[Pin]:
        """The library's cells and pins that a reader comes to, through the hierarchy below."""
        kind = self.modules[module]["cells"][reader[0]]["type"]
        if kind in self.cells:
            return [(kind, reader[1])]
        net = self.modules[kind]["ports"][reader[1]]["bits"][place]
        return [leaf for inner, at in self.readers(kind, net)
                for leaf in self.leaves(kind, inner, at)]

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
        """Puts a buffer into the net that a path's pin drives: in that module which has the most
        readers of it, in front of the second half of their load; where none has two, in front of
        all that the pin drives. A clock is not split."""
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
        new = 1 + max((bit for of in here["netnames"].values() for bit in of["bits"]
                       if isinstance(bit, int)), default=inner)
        if len(found) > 1:
            self.move_half(here, found, inner, new)
            connections = {pin_in: [inner], pin_out: [new]}
        else:
            cell["connections"][pin] = [new]
            connections = {pin_in: [new], pin_out: [net]}
        here["cells"][f"fanout_{new}_limit"] = {"type": buffer, "connections": connections}
        here["netnames"][f"fanout_{new}_net"] = {"bits": [new]}
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

    def move_half(self, here: Object, found: List[Tuple[Pin, int, List[Pin]]], net: int,
                  new: int) -> None:
        """Moves readers to another net, the last ones, until they are half of the load; all, if an
        output port keeps the net."""
        at_ports = any(net in port["bits"] and port["direction"] == "output"
                       for port in here["ports"].values())
        half = 0 if at_ports else sum(self.load(leaves) for _, _, leaves in found) / 2
        kept = 0.0
        for number, ((name, pin), place, leaves) in enumerate(found):
            last = number == len(found) - 1
            if kept >= half or last:
                here["cells"][name]["connections"][pin][place] = new
            kept += self.load(leaves)
