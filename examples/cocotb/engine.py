# SPDX-License-Identifier: MIT
"""engine.py - drives the object engine (sepax_engine) over its three AXI buses by the models of
cocotbext-axi. docs/reference/object-engine.md tells what the registers and the streams mean."""
import re

from cocotb.triggers import ClockCycles
from cocotbext.axi import AxiLiteBus, AxiLiteMaster, AxiResp, AxiStreamFrame

from axi import Top, vertices
from golden import Found


def register_map(path):
    """Of a C header of registers: their addresses, and the masks of their bits."""
    with open(path) as file:
        found = re.findall(r"#define SEPAX_(?:TREE_)?(\w+) (0x\w+)u( /\*)?", file.read())
    return ({name: int(value, 16) for name, value, about in found if about},
            {name: int(value, 16) for name, value, about in found if not about})


def signed(value):
    """32 bits as a signed number."""
    return value - 2**32 if value >= 2**31 else value


class Engine(Top):
    """The engine behind its buses; `registers` is the path of its C header."""

    def __init__(self, dut, registers):
        super().__init__(dut)
        self.address, self.bit = register_map(registers)
        self.axi = AxiLiteMaster(AxiLiteBus.from_prefix(dut, "s_axi"), **self.clocked)
        self.channels += [self.axi.write_if.aw_channel, self.axi.write_if.w_channel,
                          self.axi.write_if.b_channel, self.axi.read_if.ar_channel,
                          self.axi.read_if.r_channel]

    async def write(self, name, value):
        """Write a register; False if the engine answers with SLVERR."""
        return await self.write_at(self.address[name], (value % 2**32).to_bytes(4, "little"))

    async def write_at(self, address, data):
        response = await self.axi.write(address, data)
        return response.resp == AxiResp.OKAY

    async def read(self, name):
        """Read a register; None if the engine answers with SLVERR."""
        return await self.read_at(self.address[name])

    async def read_at(self, address):
        response = await self.axi.read(address, 4)
        return int.from_bytes(response.data, "little") if response.resp == AxiResp.OKAY else None

    async def status(self, *names):
        """STATUS, as the names of those of its bits that are 1."""
        value = await self.read("STATUS")
        return {name[7:] for name, mask in self.bit.items()
                if name.startswith("STATUS_") and value & mask}

    async def load(self, is_b, triangles):
        """Load object A or B and wait until it has been taken."""
        await self.send(int(is_b), vertices(triangles))

    async def send(self, tdest, transfers):
        """Send transfers with one destination, or with one each; TLAST is with the last."""
        await self.source.send(AxiStreamFrame(transfers, tdest=tdest))
        await self.source.wait()
        await ClockCycles(self.dut.aclk, 2)

    async def move(self, offset):
        for axis, value in zip("XYZ", offset):
            assert await self.write(f"MOVE_{axis}", value)

    async def start(self, **mode):
        """Begin a run: start(first=True, quiet=True)."""
        bits = sum(self.bit[f"MODE_{name.upper()}"] for name, on in mode.items() if on)
        assert await self.write("MODE", bits)
        assert await self.write("COMMAND", self.bit["COMMAND_START"])

    async def collisions(self):
        """The results of a run that sends them: [Found, ...], and whether it was stopped."""
        *found, end = (await self.sink.recv()).tdata
        assert end >> 63 == 1, "the last transfer is not the end of a run"
        assert end & 2**32 - 1 == len(found), "the end counts other transfers"
        assert end >> 32 & 0x3fffffff == 0
        for word in found:
            assert word >> 58 == 0, "a bit that means nothing here"
        return [Found(w & 2**32 - 1, w >> 32 & 2**24 - 1, bool(w >> 56 & 1), bool(w >> 57 & 1))
                for w in found], bool(end >> 62 & 1)

    async def idle(self):
        """Wait for the end of a run."""
        while "BUSY" in await self.status():
            await ClockCycles(self.dut.aclk, 10)
