# SPDX-License-Identifier: MIT
"""test_tree.py - the tree engine against its golden model: batches of jobs in a memory that stalls,
its modes, jobs that are refused, memory that ends too soon."""
import json
import math
import os
from random import Random

import cocotb
from cocotb.triggers import ClockCycles

import golden
from golden_tree import Body, batch, job_bytes, pose_bytes
from sepax.cocotb import TreeEngine

FOLDER = os.environ["SEPAX_RTL"]
with open(f"{FOLDER}/sepax.json") as file:
    DESIGN = json.load(file)
WORD = DESIGN["word"]
FIRST, QUIET, ROW, AGAIN, COLD = (1 << k for k in range(5))
JOBS_AT, POSES_AT, BODIES_AT = 0x100, 0x1000, 0x4000
HIT, REFUSED, LAST = 1, 32, 64

test = cocotb.test(timeout_time=300, timeout_unit="us")


async def ready(dut, stall=None):
    """The engine behind a reset, and behind a collision: where a pose has none, FIRST is that of
    one before, and undefined before any. With a seed all valid and ready come at random."""
    engine = TreeEngine(dut, f"{FOLDER}/sepax_tree_registers.h")
    await engine.reset()
    body = Body([[0] * 9], WORD, BODIES_AT)
    engine.put(BODIES_AT, body.image)
    engine.put(POSES_AT, pose_bytes(body, body, (1, 0, 0, 0, 1, 0, 0, 0, 1), (0, 0, 0)))
    engine.put(JOBS_AT, job_bytes(body, body, POSES_AT, 1))
    await check_batch(engine)
    if stall is not None:
        engine.stall(stall)
    return engine


def rotation(random):
    """A rotation about any axis, by rows."""
    w, x, y, z = (random.gauss(0, 1) for _ in range(4))
    n = math.sqrt(w * w + x * x + y * y + z * z)
    w, x, y, z = w / n, x / n, y / n, z / n
    return (1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y),
            2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x),
            2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y))


def scene(engine, family, triangles, poses, seed, modes=0):
    """Two bodies of hard pairs and a job for them, as the engine's memory has them."""
    random = Random(seed)
    pairs = golden.hard_pairs(family, WORD, triangles, seed)
    a = Body([pair[0] for pair in pairs], WORD, BODIES_AT)
    b = Body([pair[1] for pair in pairs], WORD, BODIES_AT + (len(a.image) + 4095 & -4096))
    for body in a, b:
        engine.put(body.address, body.image)
    for n in range(poses):
        shift = [random.uniform(-9, 9) for _ in range(3)]
        engine.put(POSES_AT + 256 * n, pose_bytes(a, b, rotation(random), shift))
    engine.put(JOBS_AT, job_bytes(a, b, POSES_AT, poses, modes))


async def check_batch(engine, jobs=1):
    """Every pair, and all of the ends of poses that is defined, is that of the golden model."""
    due = batch(DESIGN["options"], engine.memory.read(0, 2**16), JOBS_AT, jobs)
    await engine.begin(JOBS_AT, jobs)
    for n, (found, end) in enumerate(due):
        *got, got_end = split(await engine.pose())
        assert got == found, n
        assert len(got_end) == len(end)
        for k, (word, (value, defined)) in enumerate(zip(got_end, end)):
            value |= LAST << 32 if k == 0 and n == len(due) - 1 else 0
            assert word & defined == value & defined, (n, k, hex(word), hex(value))
    await engine.idle()
    assert await engine.read("POSES") == len(due)
    assert await engine.read("HITS") == sum(end[0][0] >> 32 & HIT for _, end in due)
    return due


def split(transfers):
    """The pairs of a pose, and its end as the last element."""
    return transfers[:-8] + [transfers[-8:]]


@test
async def poses(dut):
    """Bodies of several families in poses at random, as fast as it goes."""
    engine = await ready(dut)
    for seed, family in enumerate(("local", "coplanar", "degenerate")):
        scene(engine, family, 9, 3, seed)
        due = await check_batch(engine)
        assert len(due) == 3


@test
async def poses_stalled(dut):
    """The same with memory, results and registers that stall at random."""
    engine = await ready(dut, stall=1)
    for seed, family in enumerate(("touch-face", "grid")):
        scene(engine, family, 9, 3, 10 + seed)
        await check_batch(engine)


@test
async def modes(dut):
    """Poses that end at their first collision, that send nothing, that try the last one first."""
    engine = await ready(dut)
    for mode in FIRST, QUIET, AGAIN, COLD, FIRST | QUIET | AGAIN | COLD:
        scene(engine, "local", 9, 2, 4, mode)
        due = await check_batch(engine)
        assert due[0][1][0][0] >> 32 & HIT  # the second pose has a row to try first


@test
async def refused(dut):
    """A job whose bits mean nothing is refused, and the batch ends; the next one is right."""
    engine = await ready(dut)
    scene(engine, "local", 5, 2, 4, modes=128)
    await engine.begin(JOBS_AT, 1)
    assert (await engine.pose())[0] >> 32 == 1 << 31 | REFUSED | LAST
    await engine.idle()
    assert await engine.status() == {"REFUSED"}
    scene(engine, "local", 5, 2, 4)
    await check_batch(engine)


@test
async def reset_amid_batch(dut):
    """A reset amid a batch, and the next batch is right."""
    engine = await ready(dut, stall=2)
    scene(engine, "local", 9, 2, 5)
    for cycles in 10, 100, 200:
        await engine.begin(JOBS_AT, 1)
        await ClockCycles(dut.aclk, cycles)
        await engine.reset()
        engine.sink.clear()
        assert await engine.status() == set()
        await check_batch(engine)
