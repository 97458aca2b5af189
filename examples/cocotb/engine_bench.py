# SPDX-License-Identifier: MIT
"""engine_bench.py - what the tests of the object engine share: seeded objects, and a run of which
each pair, flag and count is that of the golden model."""
import json
import os

import cocotb

import golden
from sepax.cocotb import ObjectEngine

FOLDER = os.environ["SEPAX_RTL"]
with open(f"{FOLDER}/sepax.json") as file:
    DESIGN = json.load(file)
WORD, MEMORY_A, MEMORY_B = DESIGN["word"], DESIGN["memory_a"], DESIGN["memory_b"]
LEAST, MOST = -2**(WORD - 1), 2**(WORD - 1) - 1
MODEL = golden.Design(DESIGN["options"])
LOADED = {"LOADED_A", "LOADED_B"}
POINT = [1, 1, 1] * 3  # a triangle that is a point

test = cocotb.test(timeout_time=120, timeout_unit="us")


async def ready(dut, stall=None):
    """The engine behind a reset; with a seed all valid and ready come at random."""
    engine = ObjectEngine(dut, f"{FOLDER}/sepax_registers.h")
    await engine.reset()
    if stall is not None:
        engine.stall(stall)
    return engine


def objects(families, count, seed):
    """Objects A and B of hard pairs: pair n has triangle n of both."""
    pairs = [pair for k, family in enumerate(families)
             for pair in golden.hard_pairs(family, WORD, count, 100 * seed + k)]
    return [a for a, _ in pairs], [b for _, b in pairs]


async def load(engine, a, b):
    await engine.load(False, a)
    await engine.load(True, b)
    assert await engine.status() >= LOADED


async def check_run(engine, a, b, move=(0, 0, 0)):
    """A whole run over what is loaded gives the pairs, flags and counts of the golden model."""
    due = MODEL.engine(a, b, move, WORD)
    await engine.move(move)
    await engine.start()
    found, stopped = await engine.collisions()
    await engine.idle()
    assert found == due.found
    assert not stopped
    await check_counts(engine, due)
    return due


async def check_counts(engine, due):
    for name in ("pairs", "candidates", "collisions", "out_of_range"):
        assert await engine.read(name.upper()) == getattr(due, name), name
    assert await engine.read("WARNINGS") == 0
    status = LOADED | ({"HIT"} if due.found else set())
    status |= {"OUT_OF_RANGE"} if due.out_of_range else set()
    assert await engine.status() == status
    if due.found:
        assert await engine.read("FIRST_A") == due.found[0].a
        assert await engine.read("FIRST_B") == due.found[0].b
