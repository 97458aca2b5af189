# SPDX-License-Identifier: MIT
"""axi.py - what the bus tops have in common: clock, reset, vertices as transfers, stalls."""
from random import Random

import cocotb
from cocotb.clock import Clock
from cocotb.triggers import ClockCycles, RisingEdge
from cocotbext.axi import AxiStreamBus, AxiStreamSink, AxiStreamSource


def vertices(triangles):
    """Triangles of nine coordinates as transfers of 128 bits: {z, y, x}, 32 bits each."""
    mask = 2**32 - 1
    return [(z & mask) << 64 | (y & mask) << 32 | x & mask
            for t in triangles for x, y, z in (t[0:3], t[3:6], t[6:9])]


def stalls(seed):
    """Pauses at random, in stretches of different density."""
    random = Random(seed)
    while True:
        rate = random.choice((0, 0.1, 0.5, 0.9))
        for _ in range(random.randint(1, 40)):
            yield random.random() < rate


class Top:
    """A module with a clock, a reset, a stream m_axis out and mostly a stream s_axis in."""

    def __init__(self, dut):
        self.dut = dut
        dut._log.setLevel("ERROR")  # the models of the buses tell every transfer
        cocotb.start_soon(Clock(dut.aclk, 10, "ns").start())
        self.clocked = {"clock": dut.aclk, "reset": dut.aresetn, "reset_active_level": False}
        stream = {"byte_lanes": 1, **self.clocked}  # a transfer is one number
        self.sink = AxiStreamSink(AxiStreamBus.from_prefix(dut, "m_axis"), **stream)
        self.channels = [self.sink]
        if hasattr(dut, "s_axis_tvalid"):
            self.source = AxiStreamSource(AxiStreamBus.from_prefix(dut, "s_axis"), **stream)
            self.channels.append(self.source)

    async def reset(self):
        self.dut.aresetn.value = 0
        await ClockCycles(self.dut.aclk, 4)
        self.dut.aresetn.value = 1
        await RisingEdge(self.dut.aclk)

    def stall(self, seed):
        """Every valid and ready of this side at random from here on."""
        for k, channel in enumerate(self.channels):
            channel.set_pause_generator(stalls(8 * seed + k))
