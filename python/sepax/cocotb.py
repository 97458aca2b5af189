# SPDX-License-Identifier: MIT
"""Drivers for cocotb (1.9 or 2): the tops with AXI buses, by the models of cocotbext-axi.

    from sepax.cocotb import ObjectEngine

    @cocotb.test()
    async def run(dut):
        engine = ObjectEngine(dut, "build/engine/sepax_registers.h")
        await engine.reset()
        await engine.load(False, triangles_a)      # nine whole numbers each
        await engine.load(True, triangles_b)
        await engine.start()
        found, stopped = await engine.collisions()

`Stream` drives a core on AXI4-Stream (`--stream`), `ObjectEngine` the object engine (`--lanes`),
`TreeEngine` the tree engine (`--tree`). A test in examples/cocotb uses each of them. They need the
packages cocotb and cocotbext-axi."""
from __future__ import annotations

import os
import re
from random import Random
from typing import Any, Dict, Iterator, List, NamedTuple, Optional, Sequence, Set, Tuple, Union

try:
    import cocotb
    from cocotb.clock import Clock
    from cocotb.triggers import ClockCycles, RisingEdge
    from cocotbext.axi import (AxiLiteBus, AxiLiteMaster, AxiRamRead, AxiReadBus, AxiResp,
                               AxiStreamBus, AxiStreamFrame, AxiStreamSink, AxiStreamSource)
except ImportError as _error:
    from ._errors import MissingError
    raise MissingError(f"cocotb is not here ({_error}): pip install cocotb cocotbext-axi"
                       ) from None

from .hardware import Design

Triangle = Sequence[int]
Path = Union[str, "os.PathLike[str]"]
BITS = 2**32 - 1


def vertices(triangles: Sequence[Triangle]) -> List[int]:
    """Triangles of nine coordinates as transfers of 128 bits: {z, y, x}, 32 bits each."""
    return [(z & BITS) << 64 | (y & BITS) << 32 | x & BITS
            for t in triangles for x, y, z in (t[0:3], t[3:6], t[6:9])]


def stalls(seed: int) -> Iterator[bool]:
    """Pauses at random, in stretches of different density: for set_pause_generator."""
    random = Random(seed)
    while True:
        rate = random.choice((0, 0.1, 0.5, 0.9))
        for _ in range(random.randint(1, 40)):
            yield random.random() < rate


def signed(value: int) -> int:
    """32 bits as a signed number."""
    return value - 2**32 if value >= 2**31 else value


def register_map(header: Path) -> Tuple[Dict[str, int], Dict[str, int]]:
    """Of the C header of registers of a design: their addresses, and the masks of their bits, by
    their names without the prefix."""
    with open(header, encoding="utf-8") as file:
        text = file.read()
    prefix = re.search(r"#define (\w+_)IDENTITY\b", text).group(1)
    found = re.findall(rf"#define {prefix}(\w+) (0x\w+)u( /\*)?", text)
    return ({name: int(value, 16) for name, value, about in found if about},
            {name: int(value, 16) for name, value, about in found if not about})


class Top:
    """A module with a clock, a reset, a stream m_axis out and mostly a stream s_axis in.

    dut: cocotb's handle of the top. sink, source: cocotbext-axi's models of the streams.
    channels: of all buses, those of this side."""

    def __init__(self, dut: Any, period_ns: float = 10) -> None:
        self.dut = dut
        dut._log.setLevel("ERROR")  # the models of the buses tell every transfer
        cocotb.start_soon(Clock(dut.aclk, period_ns, "ns").start())
        self.clocked = {"clock": dut.aclk, "reset": dut.aresetn, "reset_active_level": False}
        stream = {"byte_lanes": 1, **self.clocked}  # a transfer is one number
        self.sink = AxiStreamSink(AxiStreamBus.from_prefix(dut, "m_axis"), **stream)
        self.channels = [self.sink]
        if hasattr(dut, "s_axis_tvalid"):
            self.source = AxiStreamSource(AxiStreamBus.from_prefix(dut, "s_axis"), **stream)
            self.channels.append(self.source)

    async def reset(self) -> None:
        """Reset for four cycles."""
        self.dut.aresetn.value = 0
        await ClockCycles(self.dut.aclk, 4)
        self.dut.aresetn.value = 1
        await RisingEdge(self.dut.aclk)

    def stall(self, seed: int) -> None:
        """Every valid and ready of this side at random from here on."""
        for k, channel in enumerate(self.channels):
            channel.set_pause_generator(stalls(8 * seed + k))


class Answer(NamedTuple):
    """What a core on AXI4-Stream answers to a pair: docs/reference/exact.md, AXI4-Stream."""
    collision: bool
    coplanar: bool
    out_of_range: bool
    cut_short: bool
    band: int
    axis: int
    tag: int


class Stream(Top):
    """The core behind its two streams, of any width."""

    def transfers(self, pair: Sequence[Triangle]) -> List[int]:
        """A pair of triangles as transfers: six, two or one, as s_axis_tdata is wide."""
        v = vertices(pair)
        if len(self.dut.s_axis_tdata) == 128:
            return v
        triangles = [v[k] | v[k + 1] << 128 | v[k + 2] << 256 for k in (0, 3)]
        if len(self.dut.s_axis_tdata) == 512:
            return triangles
        return [triangles[0] | triangles[1] << 512]

    async def send(self, pairs: Sequence[Sequence[Triangle]], tags: Sequence[int]) -> None:
        """Send a batch of pairs [(a, b), ...] with a tag each; TLAST is with the last."""
        parts = [self.transfers(pair) for pair in pairs]
        await self.source.send(AxiStreamFrame(
            [word for words in parts for word in words],
            tuser=[tag for words, tag in zip(parts, tags) for _ in words]))

    async def batch(self) -> List[Answer]:
        """The answers to a batch, in the order of its pairs."""
        got = await self.sink.recv(compact=False)
        assert all(word & 0xfffff0c0 == 0 for word in got.tdata), "a bit that means nothing"
        return [Answer(bool(word & 1), bool(word & 2), bool(word & 4), bool(word & 8),
                       word >> 4 & 3, word >> 8 & 15, tag)
                for word, tag in zip(got.tdata, got.tuser)]


class Engine(Top):
    """An engine behind its buses. registers: the path of the C header of its registers.

    address, bit: addresses of the registers, and masks of their bits, by name."""

    def __init__(self, dut: Any, registers: Path, period_ns: float = 10) -> None:
        super().__init__(dut, period_ns)
        self.address, self.bit = register_map(registers)
        self.axi = AxiLiteMaster(AxiLiteBus.from_prefix(dut, "s_axi"), **self.clocked)
        self.channels += [self.axi.write_if.aw_channel, self.axi.write_if.w_channel,
                          self.axi.write_if.b_channel, self.axi.read_if.ar_channel,
                          self.axi.read_if.r_channel]

    async def write(self, name: str, value: int) -> bool:
        """Write a register; False if the engine answers with SLVERR."""
        return await self.write_at(self.address[name], (value % 2**32).to_bytes(4, "little"))

    async def write_at(self, address: int, data: bytes) -> bool:
        """Write bytes at an address; False if the engine answers with SLVERR."""
        response = await self.axi.write(address, data)
        return response.resp == AxiResp.OKAY

    async def read(self, name: str) -> Optional[int]:
        """Read a register; None if the engine answers with SLVERR."""
        return await self.read_at(self.address[name])

    async def read_at(self, address: int) -> Optional[int]:
        """Read 32 bits at an address; None if the engine answers with SLVERR."""
        response = await self.axi.read(address, 4)
        return int.from_bytes(response.data, "little") if response.resp == AxiResp.OKAY else None

    async def status(self) -> Set[str]:
        """STATUS, as the names of those of its bits that are 1."""
        value = await self.read("STATUS")
        return {name[7:] for name, mask in self.bit.items()
                if name.startswith("STATUS_") and value & mask}

    async def idle(self) -> None:
        """Wait for the end of a run."""
        while "BUSY" in await self.status():
            await ClockCycles(self.dut.aclk, 10)


class Found(NamedTuple):
    """A pair that collides: numbers of the triangles, and flags."""
    a: int
    b: int
    coplanar: bool
    out_of_range: bool


class ObjectEngine(Engine):
    """The object engine: docs/reference/object-engine.md."""

    async def load(self, is_b: bool, triangles: Sequence[Triangle]) -> None:
        """Load object A or B and wait until it has been taken."""
        await self.send(int(is_b), vertices(triangles))

    async def send(self, tdest: Any, transfers: Sequence[int]) -> None:
        """Send transfers with one destination, or with one each; TLAST is with the last."""
        await self.source.send(AxiStreamFrame(transfers, tdest=tdest))
        await self.source.wait()
        await ClockCycles(self.dut.aclk, 2)

    async def move(self, offset: Sequence[int]) -> None:
        """Move object B by whole numbers x, y, z."""
        for axis, value in zip("XYZ", offset):
            assert await self.write(f"MOVE_{axis}", value), f"MOVE_{axis} refuses {value}"

    async def start(self, **mode: bool) -> None:
        """Begin a run: start(first=True, quiet=True)."""
        bits = sum(self.bit[f"MODE_{name.upper()}"] for name, on in mode.items() if on)
        assert await self.write("MODE", bits), "MODE is refused"
        assert await self.write("COMMAND", self.bit["COMMAND_START"]), "START is refused"

    async def collisions(self) -> Tuple[List[Found], bool]:
        """The results of a run that sends them: [Found, ...], and whether it was stopped."""
        *found, end = (await self.sink.recv()).tdata
        assert end >> 63 == 1, "the last transfer is not the end of a run"
        assert end & 2**32 - 1 == len(found), "the end counts other transfers"
        assert end >> 32 & 0x3fffffff == 0
        for word in found:
            assert word >> 58 == 0, "a bit that means nothing here"
        return [Found(w & 2**32 - 1, w >> 32 & 2**24 - 1, bool(w >> 56 & 1), bool(w >> 57 & 1))
                for w in found], bool(end >> 62 & 1)


class TreeEngine(Engine):
    """The tree engine, with a memory of `size` bytes from address 0 on: docs/reference/
    tree-engine.md. The dut is the module that `with_ids` writes.

    memory: cocotbext-axi's AxiRamRead."""

    def __init__(self, dut: Any, registers: Path, size: int = 2**16, period_ns: float = 10
                 ) -> None:
        super().__init__(dut, registers, period_ns)
        self.memory = AxiRamRead(AxiReadBus.from_prefix(dut, "m_axi"), size=size, **self.clocked)
        self.channels += [self.memory.ar_channel, self.memory.r_channel]

    def put(self, address: int, data: Sequence[int]) -> None:
        """Write bytes into the memory."""
        self.memory.write(address, bytes(data))

    async def begin(self, jobs_at: int, jobs: int) -> None:
        """Start a batch: a list of jobs in the memory."""
        for name, value in (("LIST_LOW", jobs_at), ("LIST_HIGH", jobs_at >> 32), ("JOBS", jobs),
                            ("COMMAND", self.bit["COMMAND_START"])):
            assert await self.write(name, value), f"{name} refuses {value}"

    async def pose(self) -> List[int]:
        """The transfers of the next pose: pairs that collide, then its end of eight transfers."""
        return (await self.sink.recv()).tdata


def with_ids(folder: Path, file: Path, prefix: str = "sepax") -> str:
    """Write a module with the ports of a tree engine and AXI IDs, which cocotbext-axi wants.

    folder: of the design. file: the Verilog file to write. Returns the name of the module, which
    is PREFIX_tree."""
    design = Design(folder, prefix)
    name = f"{prefix}_tree"
    ports = [f"  {p.direction:6} wire {f'[{p.width - 1}:0]' if p.width > 1 else '':7} {p.name}"
             for p in design.ports]
    ports += ["  output wire [0:0]   m_axi_arid", "  input  wire [0:0]   m_axi_rid"]
    pins = [f"    .{p.name}({p.name})" for p in design.ports]
    with open(file, "w", encoding="utf-8") as out:
        out.write(f"// {design.top} with AXI IDs, which are 0: cocotbext-axi wants them.\n"
                  f"`default_nettype none\n\nmodule {name} (\n" + ",\n".join(ports) +
                  f"\n);\n  assign m_axi_arid = 1'b0;\n\n  {design.top} engine (\n" +
                  ",\n".join(pins) + "\n  );\nendmodule\n\n`default_nettype wire\n")
    return name
