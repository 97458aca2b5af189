# SPDX-License-Identifier: MIT
"""netlist_verilog - a flat netlist as Verilog. Yosys takes minutes for a million cells."""
from __future__ import annotations

import re
from typing import Any, Dict, Iterator, Union

Bit = Union[int, str]
PLAIN = re.compile(r"[A-Za-z_][A-Za-z0-9_]*")


def escaped(name: str) -> str:
    """A name as Verilog writes it."""
    return name if PLAIN.fullmatch(name) else f"\\{name} "


def net_names(module: Dict[str, Any]) -> Dict[int, str]:
    """A name for each net: that of a port, else the shortest that it has."""
    names: Dict[int, str] = {}
    for name, net in sorted(module["netnames"].items(), key=lambda item: len(item[0])):
        bits = net["bits"]
        for i, bit in enumerate(bits):
            if isinstance(bit, int) and bit not in names:
                names[bit] = escaped(name if len(bits) == 1 else f"{name}[{i}]")
    for name, port in module["ports"].items():
        for i, bit in enumerate(port["bits"]):
            if isinstance(bit, int) and port["direction"] == "input":
                names[bit] = escaped(name) if len(port["bits"]) == 1 else f"{escaped(name)}[{i}]"
    return names


def verilog(netlist: Dict[str, Any], top: str) -> Iterator[str]:
    """The lines of the module `top`, whose cells are of the library."""
    module = netlist["modules"][top]
    names = net_names(module)

    def net(bit: Bit) -> str:
        if isinstance(bit, str):
            return "1'b1" if bit == "1" else "1'b0"
        if bit not in names:
            names[bit] = f"net_{bit}_"
            wires.append(names[bit])
        return names[bit]
    inputs = {bit for port in module["ports"].values() if port["direction"] == "input"
              for bit in port["bits"]}
    wires = [name for bit, name in names.items() if bit not in inputs]
    ports = [escaped(name) for name in module["ports"]]
    cells = []
    for name, cell in module["cells"].items():
        pins = ", ".join(f".{escaped(pin)}({net(bits[0])})"
                         for pin, bits in cell["connections"].items() if bits)
        cells.append(f"  {escaped(cell['type'])} {escaped(name)} ({pins});\n")
    yield f"module {escaped(top)} ({', '.join(ports)});\n"
    for name, port in module["ports"].items():
        width = len(port["bits"])
        span = f"[{width - 1}:0] " if width > 1 else ""
        yield f"  {port['direction']} {span}{escaped(name)};\n"
    outputs = {escaped(name) for name, port in module["ports"].items()
               if port["direction"] == "output" and len(port["bits"]) == 1}
    for name in wires:
        if name not in outputs:
            yield f"  wire {name};\n"
    yield from cells
    for name, port in module["ports"].items():
        if port["direction"] != "output":
            continue
        for i, bit in enumerate(port["bits"]):
            own = escaped(name) if len(port["bits"]) == 1 else f"{escaped(name)}[{i}]"
            if net(bit) != own:
                yield f"  assign {own} = {net(bit)};\n"
    yield "endmodule\n"
