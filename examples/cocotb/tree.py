# SPDX-License-Identifier: MIT
"""tree.py - drives the tree engine (sepax_engine of a design with --tree) over its buses; the
AxiRam of cocotbext-axi is its memory. docs/reference/tree-engine.md, Jobs."""
from cocotbext.axi import AxiRamRead, AxiReadBus

from engine import Engine


class TreeEngine(Engine):
    """The tree engine, with a memory of 64 Kbyte from address 0 on."""

    def __init__(self, dut, registers):
        super().__init__(dut, registers)
        self.memory = AxiRamRead(AxiReadBus.from_prefix(dut, "m_axi"), size=2**16, **self.clocked)
        self.channels += [self.memory.ar_channel, self.memory.r_channel]

    def put(self, address, data):
        self.memory.write(address, bytes(data))

    async def begin(self, jobs_at, jobs):
        """Start a batch: a list of jobs in the memory."""
        assert await self.write("LIST_LOW", jobs_at) and await self.write("LIST_HIGH", 0)
        assert await self.write("JOBS", jobs)
        assert await self.write("COMMAND", self.bit["COMMAND_START"])

    async def pose(self):
        """The transfers of the next pose: pairs that collide, then its end."""
        return (await self.sink.recv()).tdata
