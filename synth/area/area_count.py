# SPDX-License-Identifier: MIT
"""area_count - what synth/area/map reads from Yosys and counts: the netlist that it keeps, names of
modules, and the area of each module.

A netlist is {"modules": {NAME: {"ports", "cells": {NAME: {"type", "connections"}}, "netnames"}}}.
"""
from __future__ import annotations

import re
from typing import Any, Dict, List, Optional

from common import Object, rounded

PARAMETRISED = re.compile(r"^\$paramod(\$[0-9a-f]+)?\\")


PARTS = 1000  # of an area that is told


def netlist_of(design: Object) -> Object:
    """What is kept of Yosys' JSON: neither the library's cells, which are black boxes, nor
    attributes."""
    return {"modules": {name: {
        "ports": module["ports"],
        "cells": {cell: {"type": of["type"], "connections": of["connections"]}
                  for cell, of in module["cells"].items()},
        "netnames": {net: {"bits": of["bits"]} for net, of in module["netnames"].items()},
    } for name, module in design["modules"].items()
        if not module.get("attributes", {}).get("blackbox")}}


# ---------------------------------------------------------------------------------- names


def binary(bits: str) -> int:
    """The value of a parameter as Yosys writes it: binary digits."""
    value = 0
    for bit in bits:
        value = 2 * value + ord(bit) - ord("0")
    return value


def readable_names(modules: Object) -> Dict[str, str]:
    """Names to read. Variants of a module get the first parameter that tells them apart, or all
    that differ: "sepax_dot (C_W=38)"."""
    variants: Dict[str, List[Any]] = {}
    for key, module in modules.items():
        name = module.get("attributes", {}).get("hdlname", key)
        parameters = module.get("parameter_default_values") or {}
        variants.setdefault(name[1:] if name.startswith("\\") else name, []).append(
            (key, {p: binary(bits) for p, bits in parameters.items()}))
    names = {}
    for name, rows in sorted(variants.items()):
        values = {p: len({row[1][p] for row in rows}) for p in rows[0][1]}
        differ = [p for p, number in values.items() if number > 1]
        shown = [p for p in differ if values[p] == len(rows)][:1] or differ
        for key, value in rows:
            told = ", ".join(f"{p}={value[p]}" for p in shown)
            names[key] = f"{name} ({told})" if told else name
    return names


def names_of(design: Object) -> List[Dict[str, str]]:
    """Each module's name in RTLIL, to read, and in plain characters."""
    def plain(name: str) -> str:
        name = re.sub(r"[^A-Za-z0-9_]+", "_", name)
        return name[:-1] if name.endswith("_") else name
    return [{"rtlil": key, "readable": name, "plain": plain(name)}
            for key, name in readable_names(design["modules"]).items()]


# --------------------------------------------------------------------------------- counting


def memory_bits(modules: Object, top: str, memory: str) -> int:
    """The bits of the memories below a module, before they were moved out of the netlist."""
    if PARAMETRISED.sub("", top).split("\\")[0] == memory:
        size = modules[top]["parameter_default_values"]
        return binary(size["WIDTH"]) * 2 ** binary(size["ADDRESS"])
    return sum(memory_bits(modules, cell["type"], memory)
               for cell in modules[top]["cells"].values() if cell["type"] in modules)


def instances(count: Dict[str, Dict[str, int]], top: str) -> Dict[str, int]:
    """How often each module stands below the top; the top stands once."""
    found: Dict[str, int] = {}

    def times(module: str) -> int:
        if module not in found:
            found[module] = 1 if module == top else sum(
                inside[module] * times(name) for name, inside in count.items() if module in inside)
        return found[module]
    return {module: times(module) for module in count}


def cell_facts(cell: Object) -> Object:
    """Area, registers, latches and what opens a clock gate, of a cell of the library. Of a gate
    that is made of a latch and an AND, an input of each opens it."""
    state = [part["kind"] for part in cell["state"]]
    latches = state.count("latch")
    opens = sum(pin.get("clock_gate") in ("enable", "test") for pin in cell["pins"].values())
    return {"area": cell.get("area") or 0, "ff": sum(kind.startswith("ff") for kind in state),
            "latches": latches, "opens": 2 if latches else opens}


def count_cells(netlist: Object) -> Dict[str, Dict[str, int]]:
    """The number of cells by type in each module."""
    count: Dict[str, Dict[str, int]] = {}
    for name, module in netlist["modules"].items():
        of_module = count.setdefault(name, {})
        for cell in module["cells"].values():
            of_module[cell["type"]] = of_module.get(cell["type"], 0) + 1
    return count


def area_by_module(netlist: Object, cells: Object, names: List[Dict[str, str]], top: str,
                   nand2_area: float) -> List[Object]:
    """A row for each module: its cells' area in GE, registers, clock gates, and how often it is
    there."""
    fact = {name: cell_facts(cell) for name, cell in cells.items()}
    readable = {row["plain"]: row["readable"] for row in names}
    count = count_cells(netlist)
    often = instances(count, top)
    rows = []
    for module, types in count.items():
        own = [(number, fact[kind]) for kind, number in types.items() if kind in fact]
        area = sum(number * of["area"] for number, of in own)
        rows.append({
            "name": readable.get(module), "instances": often[module],
            "ge": rounded(area / nand2_area, PARTS),
            "ge_total": rounded(area * often[module] / nand2_area, PARTS),
            "ff": sum(number * of["ff"] for number, of in own),
            "clock_gates": sum(number for number, of in own if of["opens"] > 0),
            "latches": sum(number * of["latches"] for number, of in own),
            "opens": sum(number * of["opens"] for number, of in own),
            "area": area * often[module]})
    return rows


def unknown_cells(netlist: Object, cells: Object) -> List[str]:
    """Types of cells that are neither a module nor a cell with an area."""
    types = {kind for types in count_cells(netlist).values() for kind in types}
    return sorted(kind for kind in types if kind not in netlist["modules"]
                  and not (cells.get(kind, {}).get("area") or 0))


def repeated_modules(netlist: Object, top: str) -> List[str]:
    """Modules without modules inside that stand more than once."""
    count = count_cells(netlist)
    often = instances(count, top)
    return [name for name, types in count.items()
            if often[name] > 1 and not any(kind in count for kind in types)]


def design_row(rows: List[Object], design: Object, timing: Optional[Object], multipliers: str,
               precision: str) -> Object:
    """The whole design: its options and what its modules come to."""
    def of_all(column: str) -> int:
        return sum(row[column] * row["instances"] for row in rows)
    shown = ("name", "instances", "ge", "ge_total", "ff", "clock_gates")
    generated = design["arch"] == "exact" or multipliers != ""
    return {
        "arch": design["arch"], "word": design["word"], "ii": design["ii"],
        "precision": precision or "exact", "options": design["options"],
        "latency": design["latency"], "timing": timing,
        "multipliers": "generated" if generated else "*",
        "area": rounded(sum(row["area"] for row in rows), PARTS),
        "ge": rounded(sum(row["ge_total"] for row in rows), PARTS),
        "ff": of_all("ff"), "clock_gates": of_all("clock_gates"),
        "clock_gate_inputs": of_all("opens"), "latches": of_all("latches"), "memory_bits": None,
        "modules": [{column: row[column] for column in shown}
                    for row in sorted(rows, key=lambda row: (-row["ge_total"], row["name"]))]}
