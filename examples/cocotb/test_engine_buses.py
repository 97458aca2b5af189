# SPDX-License-Identifier: MIT
"""test_engine_buses.py - the object engine over AXI: what its registers hold and refuse, and
objects that are not whole."""
import cocotb
from cocotb.triggers import ClockCycles, RisingEdge

from engine_bench import (DESIGN, LEAST, LOADED, MEMORY_A, MEMORY_B, MOST, POINT, WORD, check_run,
                          load, ready, test)
from sepax.cocotb import Found, signed, vertices

READ_ONLY = ("ID GENERATOR DESIGN MEMORY STATUS COUNT_A COUNT_B PAIRS CANDIDATES COLLISIONS "
             "OUT_OF_RANGE WARNINGS CYCLES FIRST_A FIRST_B").split()

# ------------------------------------------------------------------------------ registers


@test
async def identity(dut):
    """The constant registers say what was generated."""
    engine = await ready(dut)
    assert await engine.read("ID") == int.from_bytes(b"SPXA", "big")
    major, minor, patch = map(int, DESIGN["version"].split("."))
    assert await engine.read("GENERATOR") == major << 16 | minor << 8 | patch
    assert await engine.read("DESIGN") == (
        DESIGN["ii"] << 24 | DESIGN["cores"] << 16 | DESIGN["lanes"] << 8 | WORD)
    memory = (MEMORY_B.bit_length() - 1) << 8 | (MEMORY_A.bit_length() - 1)
    assert await engine.read("MEMORY") == memory


@test
async def after_reset(dut):
    """Nothing is set and nothing is there after a reset."""
    engine = await ready(dut)
    for name in "MODE STATUS ENABLE PENDING COUNT_A COUNT_B MOVE_X MOVE_Y MOVE_Z".split():
        assert await engine.read(name) == 0, name
    assert dut.irq.value == 0


@test
async def unknown_addresses(dut):
    """A read of an address without a register, or of COMMAND, is an error."""
    engine = await ready(dut)
    await load(engine, [POINT], [POINT])
    await check_run(engine, [POINT], [POINT])  # counts are undefined before the first run
    readable = set(engine.address.values()) - {engine.address["COMMAND"]}
    for address in range(0, 128, 4):
        assert (await engine.read_at(address) is not None) == (address in readable), address
        if address > max(readable):
            assert not await engine.write_at(address, bytes(4)), address


@test
async def read_only(dut):
    """A write to a register that is read only is an error and changes nothing."""
    engine = await ready(dut)
    before = [await engine.read(name) for name in READ_ONLY[:7]]
    for name in READ_ONLY:
        assert not await engine.write(name, 1), name
    assert [await engine.read(name) for name in READ_ONLY[:7]] == before


@test
async def byte_strobes(dut):
    """A write of some bytes is an error and changes nothing."""
    engine = await ready(dut)
    assert await engine.write("ENABLE", 5)
    for length in 1, 2, 3:
        for first in range(5 - length):
            address = engine.address["ENABLE"] + first
            assert not await engine.write_at(address, bytes([2, 0, 0][:length])), (first, length)
    assert await engine.read("ENABLE") == 5


@test
async def unused_bits(dut):
    """A 1 in a bit without a meaning is an error and changes nothing."""
    engine = await ready(dut)
    for name, used in ("MODE", 3), ("ENABLE", 7), ("PENDING", 7), ("COMMAND", 0):
        for bit in range(32):
            if not used >> bit & 1 and (name, bit) not in (("COMMAND", 0), ("COMMAND", 1)):
                assert not await engine.write(name, 1 << bit), (name, bit)
    assert not await engine.write("COMMAND", 3)
    for name in "MODE ENABLE PENDING".split():
        assert await engine.read(name) == 0, name
    assert await engine.write("COMMAND", engine.bit["COMMAND_STOP"])  # of no run
    assert await engine.status() == set()


@test
async def move_range(dut):
    """A move has W + 1 bits, signed; a longer one is an error and changes nothing."""
    engine = await ready(dut, stall=1)
    for axis in "XYZ":
        for value in -2**WORD, 2**WORD - 1, -1, 0, ord(axis):
            assert await engine.write(f"MOVE_{axis}", value)
            assert signed(await engine.read(f"MOVE_{axis}")) == value
        for value in -2**WORD - 1, 2**WORD, 2**31 - 1, -2**31:
            assert not await engine.write(f"MOVE_{axis}", value), value
    assert [await engine.read(f"MOVE_{axis}") for axis in "XYZ"] == list(b"XYZ")


@test
async def data_before_address(dut):
    """A write whose data come long before its address; a response that is not taken for long."""
    engine = await ready(dut)
    address, data, response = engine.channels[2:5]
    for early in address, data:
        early.pause = True
        task = cocotb.start_soon(engine.write("ENABLE", 6))
        await ClockCycles(dut.aclk, 50)
        assert not task.done()
        response.pause = True
        early.pause = False
        await ClockCycles(dut.aclk, 50)
        assert not task.done() and dut.s_axi_bvalid.value == 1
        response.pause = False
        assert await task
        assert await engine.read("ENABLE") == 6
        assert await engine.write("ENABLE", 0)


# -------------------------------------------------------------------------------- objects


@test
async def start_refused(dut):
    """START is an error without A, without B, and while an object is coming."""
    engine = await ready(dut)
    start = engine.bit["COMMAND_START"]
    assert not await engine.write("COMMAND", start)
    await engine.load(False, [POINT])
    assert not await engine.write("COMMAND", start)
    await engine.load(True, [POINT])
    engine.source.pause = True  # one vertex, and then nothing
    cocotb.start_soon(engine.send(True, vertices([POINT])))
    await ClockCycles(dut.aclk, 3)
    engine.source.pause = False
    await RisingEdge(dut.s_axis_tvalid)
    engine.source.pause = True
    await ClockCycles(dut.aclk, 5)
    assert await engine.status() >= {"LOADING", "LOADED_A"}
    assert not await engine.write("COMMAND", start)
    engine.source.pause = False
    await ClockCycles(dut.aclk, 10)
    assert await engine.status() == LOADED
    assert await engine.write("COMMAND", start)
    found, _ = await engine.collisions()
    assert found == [Found(0, 0, True, False)]


@test
async def short_object(dut):
    """An object that ends within a triangle is not there; the other one stays."""
    engine = await ready(dut, stall=2)
    await engine.load(False, [POINT, POINT])
    for transfers in 1, 2, 4, 5:
        await engine.load(True, [POINT])
        assert await engine.status() == LOADED
        await engine.send(True, vertices([POINT, POINT])[:transfers])
        assert await engine.status() == {"LOADED_A", "PARTIAL"}, transfers
        assert await engine.read("COUNT_B") == 0
    assert await engine.read("COUNT_A") == 2


@test
async def long_object(dut):
    """The memories hold what they should; one triangle more, and the object is not there."""
    engine = await ready(dut)
    for is_b, most in (False, MEMORY_A), (True, MEMORY_B):
        name = "AB"[is_b]
        await engine.load(is_b, [POINT] * most)
        assert f"LOADED_{name}" in await engine.status()
        assert await engine.read(f"COUNT_{name}") == most
        await engine.load(is_b, [POINT] * (most + 1))
        status = await engine.status()
        assert "FULL" in status and f"LOADED_{name}" not in status
        assert await engine.read(f"COUNT_{name}") == 0


@test
async def coordinates_out_of_range(dut):
    """A coordinate beyond the word, wherever it stands, and the object is not there."""
    engine = await ready(dut)
    for k in range(9):
        for value, fits in (LEAST, True), (LEAST - 1, False), (MOST, True), (MOST + 1, False):
            other = list(POINT)
            other[k] = value
            await engine.load(False, [POINT, other, POINT])
            assert await engine.status() == ({"LOADED_A"} if fits else {"WORD"}), (k, value)


@test
async def destination(dut):
    """The destination of the first vertex counts; that of the others is not read."""
    engine = await ready(dut, stall=3)
    for is_b in False, True:
        dest = [int(is_b)] + [int(not is_b)] * 5
        await engine.send(dest, vertices([POINT, POINT]))
    assert await engine.status() == LOADED
    assert [await engine.read("COUNT_A"), await engine.read("COUNT_B")] == [2, 2]
