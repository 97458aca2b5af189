# SPDX-License-Identifier: MIT
"""A core as a component of Amaranth (0.5), with a stream of pairs and a stream of verdicts.

    from sepax.amaranth import Core
    core = Core("build/core", word=18, ii=3)
    m.submodules.core = core
    core.add_files(platform)          # the Verilog, for the platform that builds the design

`pairs` takes a payload of 18 signed coordinates, a1_x ... b3_z; `verdicts` gives the results of the
core in the order of the pairs. It needs the packages amaranth and sepax-io."""
from __future__ import annotations

from typing import Any

try:
    from amaranth.hdl import ClockSignal, Instance, Module, ResetSignal, signed, unsigned
    from amaranth.lib import data, stream, wiring
except ImportError as _error:
    from ._errors import MissingError
    raise MissingError(f"Amaranth is not here ({_error}): pip install 'amaranth>=0.5'") from None

from .hardware import Design, generate

HANDSHAKE = {"clk", "rst", "in_valid", "in_ready", "out_valid", "out_ready"}


class Core(wiring.Component):
    """A core of architecture exact with valid and ready on both sides.

    folder: where its Verilog is written. options: those of sepax.generate.
    design: the Design. pairs: In(stream), verdicts: Out(stream). The clock domain is sync."""

    def __init__(self, folder: Any, **options: Any) -> None:
        self.design: Design = generate(folder, **options)
        shapes = {"input": {}, "output": {}}
        for port in self.design.ports:
            if port.name not in HANDSHAKE:
                shapes[port.direction][port.name.split("_", 1)[1]] = (
                    signed if port.signed else unsigned)(port.width)
        self._has_ready = any(p.name == "out_ready" for p in self.design.ports)
        super().__init__({
            "pairs": wiring.In(stream.Signature(data.StructLayout(shapes["input"]))),
            "verdicts": wiring.Out(stream.Signature(data.StructLayout(shapes["output"]),
                                                    always_ready=not self._has_ready)),
        })

    def add_files(self, platform: Any) -> None:
        """Give the Verilog to a platform that builds the design."""
        for file in self.design.files:
            platform.add_file(file.name, file.read_text(encoding="utf-8"))

    def elaborate(self, platform: Any) -> Module:  # pylint: disable=unused-argument
        """The instance of the top module."""
        ports = {"i_clk": ClockSignal("sync"), "i_rst": ResetSignal("sync"),
                 "i_in_valid": self.pairs.valid, "o_in_ready": self.pairs.ready,
                 "o_out_valid": self.verdicts.valid}
        if self._has_ready:
            ports["i_out_ready"] = self.verdicts.ready
        for port in self.design.ports:
            if port.name not in HANDSHAKE:
                side, name = ("i", self.pairs) if port.direction == "input" else (
                    "o", self.verdicts)
                ports[f"{side}_{port.name}"] = getattr(name.payload, port.name.split("_", 1)[1])
        m = Module()
        m.submodules.core = Instance(self.design.top, **ports)
        return m
