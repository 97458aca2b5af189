# SPDX-License-Identifier: MIT
"""A tree engine as a module of LiteX (2024.12), with its memory in LiteDRAM.

    from sepax.litex import TreeEngine
    self.tree = TreeEngine(platform, "build/tree", word=18, ii=3)
    self.tree.connect(self)           # after add_sdram

`connect` gives the engine a place on the bus of the SoC for its registers, a port of LiteDRAM,
and an interrupt. The engine's addresses are those of the processor. It needs the packages litex,
litedram and sepax-io. The firmware compiles drivers/tree_engine/sepax_tree_driver.c, whose three
accesses are to the region `tree` and to the CSRs tree_result, tree_state and tree_take:
examples/litex/firmware/main.c."""
from __future__ import annotations

from typing import Any

try:
    from litedram.frontend.axi import LiteDRAMAXI2Native
    from litex.gen import LiteXModule
    from litex.soc.integration.soc import SoCRegion
    from litex.soc.interconnect import axi, stream
    from litex.soc.interconnect.csr import CSR, CSRField, CSRStatus
    from litex.soc.interconnect.csr_eventmanager import EventManager, EventSourceLevel
    from migen import FSM, ClockSignal, If, Instance, NextState, NextValue, ResetSignal, Signal
except ImportError as _error:
    from ._errors import MissingError
    raise MissingError(f"LiteX is not here ({_error}): pip install litex litedram") from None

from ._errors import ArgumentError
from .hardware import Design, generate

PAGE_BITS = 12     # no burst of the engine crosses a page
BURSTS = 32        # that the engine has open at most
REGISTERS = 0x80  # bytes of its place on the bus


class Fence(LiteXModule):
    """Answers DECERR to bursts outside of a memory. LiteDRAM answers OKAY to every address, so
    that an engine with a wrong pointer would read other bytes than it was to read.

    inside: where the memory is asked; outside: what asks. Both: axi.AXIInterface, read only.
    origin, size: of the memory, in bytes, multiples of 4096."""

    def __init__(self, outside: Any, inside: Any, origin: int, size: int) -> None:
        page = Signal(outside.address_width - PAGE_BITS)
        within, opened = Signal(), Signal(max=BURSTS + 1)
        beats = Signal(8)
        ask, end = Signal(), Signal()
        self.comb += [
            page.eq(outside.ar.addr[PAGE_BITS:]),
            within.eq((page >= (origin >> PAGE_BITS)) & (page < ((origin + size) >> PAGE_BITS))),
            ask.eq(inside.ar.valid & inside.ar.ready),
            end.eq(inside.r.valid & inside.r.ready & inside.r.last),
        ]
        self.sync += opened.eq(opened + ask - end)
        self.fsm = FSM(reset_state="PASS")
        self.fsm.act(
            "PASS",
            inside.r.connect(outside.r),
            If(within & (opened != BURSTS), outside.ar.connect(inside.ar)),
            # Answers come in order: those before this one have to be here.
            If(outside.ar.valid & ~within & (opened == 0),
               outside.ar.ready.eq(1), NextValue(beats, outside.ar.len), NextState("REFUSE")))
        self.fsm.act(
            "REFUSE",
            outside.r.valid.eq(1), outside.r.resp.eq(axi.RESP_DECERR),
            outside.r.last.eq(beats == 0),
            If(outside.r.ready,
               NextValue(beats, beats - 1), If(beats == 0, NextState("PASS"))))


class TreeEngine(LiteXModule):
    """A tree engine.

    platform: gets the Verilog (None: `design.files` are for the caller). folder: where it is
    written. options: those of sepax.generate.
    design: the Design. registers: axi.AXILiteInterface, on which the engine answers.
    memory: axi.AXIInterface of 128 bits, from which it reads. results: stream.Endpoint of 64 bits,
    `last` with the end of a pose; the CSRs take them unless results="stream".
    CSRs: result (64 bits), state (valid, last), take (a write takes the result), ev (interrupt)."""

    def __init__(self, platform: Any, folder: Any, *, results: str = "csr",
                 **options: Any) -> None:
        if results not in ("csr", "stream"):
            raise ArgumentError(f"results is {results!r}; give csr or stream")
        self.design: Design = generate(folder, tree=True, **options)
        width = {port.name: port.width for port in self.design.ports}
        self.registers = axi.AXILiteInterface(data_width=width["s_axi_rdata"])
        self.memory = axi.AXIInterface(data_width=width["m_axi_rdata"],
                                       address_width=width["m_axi_araddr"], id_width=1)
        self.results = stream.Endpoint([("data", width["m_axis_tdata"])])
        irq = Signal()
        ports = {"i_aclk": ClockSignal("sys"), "i_aresetn": ~ResetSignal("sys"),
                 "o_irq": irq, "o_m_axis_tvalid": self.results.valid,
                 "i_m_axis_tready": self.results.ready, "o_m_axis_tdata": self.results.data,
                 "o_m_axis_tlast": self.results.last}
        buses = {"s_axi": self.registers, "m_axi": self.memory}
        for port in self.design.ports:
            prefix, _, name = port.name.rpartition("_")
            if prefix not in buses:
                continue
            for channel in ("aw", "ar", "w", "r", "b"):
                if name.startswith(channel):
                    signal = getattr(getattr(buses[prefix], channel), name[len(channel):])
                    ports[f"{port.direction[0]}_{port.name}"] = signal[:port.width]
                    break
        self.specials += Instance(self.design.top, **ports)
        for file in self.design.files if platform is not None else ():
            platform.add_source(str(file.resolve()))

        self.ev = EventManager()
        self.ev.engine = EventSourceLevel(description="a bit is set in PENDING and ENABLE")
        self.ev.finalize()
        self.comb += self.ev.engine.trigger.eq(irq)
        if results == "csr":
            self._result = CSRStatus(64, name="result", description="The result that waits.")
            self._state = CSRStatus(name="state", fields=[
                CSRField("valid", description="a result waits"),
                CSRField("last", description="it is the last one of its pose")])
            self._take = CSR(name="take")
            self.comb += [self._result.status.eq(self.results.data),
                          self._state.fields.valid.eq(self.results.valid),
                          self._state.fields.last.eq(self.results.last),
                          self.results.ready.eq(self._take.re)]

    def connect(self, soc: Any, name: str = "tree", memory: str = "main_ram",
                sdram: str = "sdram") -> None:
        """Connect the engine to a SoC: registers as region `name` of its bus, memory to a port of
        LiteDRAM, interrupt if the processor has any. The engine reads the region `memory`; a burst
        beyond it is a bus error. Call it after soc.add_sdram. soc.mem_map[name] may give the
        address of the region; a SoC without a processor needs that."""
        if memory not in soc.bus.regions or not hasattr(soc, sdram):
            raise ArgumentError(f"the SoC has no {memory} or no {sdram}; call add_sdram first")
        region = soc.bus.regions[memory]
        soc.bus.add_slave(name, self.registers, SoCRegion(
            origin=soc.mem_map.get(name), size=REGISTERS, cached=False))
        port = getattr(soc, sdram).crossbar.get_port(data_width=self.memory.data_width)
        inside = axi.AXIInterface(data_width=self.memory.data_width, id_width=1,
                                  address_width=self.memory.address_width)
        self.fence = Fence(self.memory, inside, region.origin, region.size)
        self.native = LiteDRAMAXI2Native(inside, port, r_buffer_depth=64,
                                         base_address=region.origin)
        if soc.irq.enabled:
            soc.irq.add(name, use_loc_if_exists=True)
