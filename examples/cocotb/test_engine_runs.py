# SPDX-License-Identifier: MIT
"""test_engine_runs.py - runs of the object engine over AXI against the golden model: hard pairs,
stalls, moves, stops, interrupts, resets."""
from random import Random

import cocotb
from cocotb.triggers import ClockCycles, RisingEdge

import golden
from engine_bench import (LEAST, LOADED, MODEL, MOST, POINT, WORD, check_counts, check_run, load,
                          objects, ready, test)
from sepax.cocotb import vertices


@test
async def families(dut):
    """Hard pairs of every family, as fast as it goes."""
    engine = await ready(dut)
    for seed, family in enumerate(golden.families()):
        a, b = objects([family], 7, seed)
        await load(engine, a, b)
        await check_run(engine, a, b)


@test
async def families_stalled(dut):
    """Objects of many families, with every valid and ready at random."""
    engine = await ready(dut, stall=4)
    for seed in range(3):
        a, b = objects(golden.families()[seed::3], 3, seed)
        await load(engine, a, b)
        await check_run(engine, a, b)


@test
async def coplanar(dut):
    """Pairs in one plane: the verdict is decided, and flagged as coplanar."""
    engine = await ready(dut, stall=5)
    a, b = objects(["coplanar", "almost-coplanar", "parallel", "identical"], 6, 1)
    await load(engine, a, b)
    due = await check_run(engine, a, b)
    assert 0 < sum(found.coplanar for found in due.found) < len(due.found)


@test
async def degenerate(dut):
    """Triangles that are segments and points."""
    engine = await ready(dut, stall=6)
    a, b = objects(["degenerate", "sliver", "grid"], 6, 2)
    await load(engine, a, b)
    due = await check_run(engine, a, b)
    assert due.found


@test
async def corners(dut):
    """Coordinates at both ends of the range."""
    engine = await ready(dut)
    a, b = objects(["corners", "uniform"], 7, 3)
    await load(engine, a, b)
    await check_run(engine, a, b)


@test
async def sizes(dut):
    """Objects of one triangle, of fewer and more than there are lanes, of unlike sizes."""
    engine = await ready(dut, stall=7)
    a, b = objects(["local", "touch-face"], 9, 4)
    for count_a, count_b in (1, 1), (1, 18), (18, 1), (5, 3), (3, 5), (4, 4), (8, 9):
        await load(engine, a[:count_a], b[:count_b])
        await check_run(engine, a[:count_a], b[:count_b])


@test
async def back_pressure(dut):
    """Results that nobody takes: the run waits, what is offered stands, nothing is lost."""
    engine = await ready(dut)
    a, b = objects(["identical", "shared-vertex"], 9, 5)
    await load(engine, a, b)
    due = MODEL.engine(a, b)
    engine.sink.pause = True
    await engine.start()
    await RisingEdge(dut.m_axis_tvalid)
    await RisingEdge(dut.aclk)
    offered = dut.m_axis_tdata.value
    for _ in range(300):
        await RisingEdge(dut.aclk)
        assert dut.m_axis_tvalid.value == 1 and dut.m_axis_tdata.value == offered
    assert "BUSY" in await engine.status()
    engine.sink.pause = False
    found, stopped = await engine.collisions()
    assert found == due.found and not stopped
    await check_counts(engine, due)


@test
async def first(dut):
    """MODE.FIRST: a run ends at its first collision, which is that of a whole run."""
    engine = await ready(dut, stall=8)
    a, b = objects(["local", "touch-edges", "coplanar"], 10, 6)
    await load(engine, a, b)
    due = MODEL.engine(a, b)
    assert len(due.found) > 5
    await engine.start(first=True)
    found, stopped = await engine.collisions()
    assert found == due.found[:1] and stopped
    assert await engine.status() == LOADED | {"HIT", "STOPPED"}
    assert await engine.read("COLLISIONS") == 1
    assert await engine.read("FIRST_A") == due.found[0].a
    assert await engine.read("FIRST_B") == due.found[0].b
    await check_run(engine, a, b)  # and the next is whole again


@test
async def quiet(dut):
    """MODE.QUIET: the same counts, and no transfer."""
    engine = await ready(dut)
    a, b = objects(["local", "shared-edge"], 10, 7)
    await load(engine, a, b)
    await engine.start(quiet=True)
    await engine.idle()
    await check_counts(engine, MODEL.engine(a, b))
    assert engine.sink.empty() and engine.sink.idle()
    await check_run(engine, a, b)


@test
async def moves(dut):
    """B moved, also out of the word: such pairs are undecided, and flagged, if AABBs overlap."""
    engine = await ready(dut, stall=9)
    a, b = objects(["local", "corners", "touch-face"], 4, 8)
    await load(engine, a, b)
    random = Random(8)
    undecided = 0
    far = [(MOST, 0, 0), (0, LEAST, 0), (2**WORD - 1, 2**WORD - 1, -2**WORD)]
    for move in far + [[random.randint(-9, 9) for _ in range(3)] for _ in range(3)]:
        undecided += (await check_run(engine, a, b, move)).out_of_range
    assert undecided > 0


@test
async def stop(dut):
    """STOP amid a run: what was found until then is a beginning of what there is."""
    engine = await ready(dut)
    a, b = objects(["identical", "local", "coplanar"], 12, 9)
    await load(engine, a, b)
    due = MODEL.engine(a, b)
    await engine.start()
    await ClockCycles(dut.aclk, 200)
    assert await engine.write("COMMAND", engine.bit["COMMAND_STOP"])
    found, stopped = await engine.collisions()
    assert stopped and 0 < len(found) < len(due.found)
    assert found == due.found[:len(found)]
    assert await engine.status() == LOADED | {"HIT", "STOPPED"}
    await check_run(engine, a, b)


@test
async def interrupts(dut):
    """PENDING tells what has happened, ENABLE lets it raise the interrupt, a 1 clears."""
    engine = await ready(dut)
    done, hit, loaded = (engine.bit[f"PENDING_{name}"] for name in ("DONE", "HIT", "LOADED"))

    async def interrupt():
        await ClockCycles(dut.aclk, 2)
        return int(dut.irq.value)

    await engine.load(False, [POINT])
    assert await engine.read("PENDING") == loaded and not await interrupt()
    assert await engine.write("ENABLE", loaded) and await interrupt()
    assert await engine.write("PENDING", done | hit) and await interrupt()
    assert await engine.write("PENDING", loaded) and not await interrupt()
    await engine.send(True, vertices([POINT])[:2])  # not whole, but it has come
    assert await interrupt()
    assert await engine.write("PENDING", 7)
    for enable in done, hit:
        assert await engine.write("ENABLE", enable)
        for b, due in ([9, 9, 9] * 3, done), (POINT, done | hit):
            await engine.load(True, [b])
            assert await engine.write("PENDING", 7)
            await engine.start(quiet=True)
            await engine.idle()
            assert await engine.read("PENDING") == due
            assert await interrupt() == int(due & enable != 0)


@test
async def while_busy(dut):
    """During a run START, MODE and moves are refused, and no vertex is taken."""
    engine = await ready(dut)
    a, b = objects(["identical"], 12, 10)
    await load(engine, a, b)
    engine.sink.pause = True
    await engine.start()
    await ClockCycles(dut.aclk, 100)
    assert not await engine.write("COMMAND", engine.bit["COMMAND_START"])
    assert not await engine.write("MODE", 1)
    for axis in "XYZ":
        assert not await engine.write(f"MOVE_{axis}", 1)
    assert await engine.write("ENABLE", 0)
    task = cocotb.start_soon(engine.load(True, [POINT]))
    for _ in range(50):
        await RisingEdge(dut.aclk)
        assert dut.s_axis_tready.value == 0
    engine.sink.pause = False
    found, stopped = await engine.collisions()
    assert found == MODEL.engine(a, b).found and not stopped
    await task
    await check_run(engine, a, [POINT])


@test
async def reload(dut):
    """Each object can be loaded anew alone; a wrong one takes the place of a good one."""
    engine = await ready(dut, stall=11)
    a, b = objects(["local", "touch-edge"], 8, 11)
    c, d = objects(["big-tiny", "tangent"], 5, 12)
    await load(engine, a, b)
    await check_run(engine, a, b)
    await engine.load(False, c)
    await check_run(engine, c, b)
    await engine.send(True, vertices(d)[:-1])
    assert await engine.status() >= {"LOADED_A", "PARTIAL"}
    assert not await engine.write("COMMAND", engine.bit["COMMAND_START"])
    await engine.load(True, d)
    await check_run(engine, c, d)


@test
async def reset_amid_run(dut):
    """A reset amid a run: all is as after the first reset, and the next run is right."""
    engine = await ready(dut)
    a, b = objects(["identical", "shared-vertex", "local"], 8, 13)
    for cycles in 1, 30, 77, 150:
        await engine.write("ENABLE", 7)
        await load(engine, a, b)
        await engine.start()
        await ClockCycles(dut.aclk, cycles)
        await engine.reset()
        engine.sink.clear()
        assert dut.irq.value == 0 and dut.m_axis_tvalid.value == 0
        for name in "MODE STATUS ENABLE PENDING COUNT_A COUNT_B".split():
            assert await engine.read(name) == 0, name
        assert not await engine.write("COMMAND", engine.bit["COMMAND_START"])
        await ClockCycles(dut.aclk, 200)
        assert dut.m_axis_tvalid.value == 0 and engine.sink.empty()
    await load(engine, a, b)
    await check_run(engine, a, b)


@test
async def reset_amid_object(dut):
    """A reset amid an object: the next vertex is the first of one."""
    engine = await ready(dut)
    for count in 4, 5:
        task = cocotb.start_soon(engine.send(False, vertices([POINT] * 4)))
        await ClockCycles(dut.aclk, count)
        await engine.reset()
        task.kill()
        assert await engine.status() == set()
        await load(engine, [POINT], [POINT, POINT])
        await check_run(engine, [POINT], [POINT, POINT])
