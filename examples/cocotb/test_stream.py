# SPDX-License-Identifier: MIT
"""test_stream.py - the core on AXI4-Stream against the golden model: hard pairs, tags, batches,
pairs that are out of range or cut short, stalls, resets."""
import json
import os
from random import Random

import cocotb
from cocotb.triggers import ClockCycles, RisingEdge
from cocotb.utils import get_sim_time
from cocotbext.axi import AxiStreamFrame

import golden
from sepax.cocotb import Answer, Stream

with open(f"{os.environ['SEPAX_RTL']}/sepax.json") as file:
    DESIGN = json.load(file)
WORD, II, TAG = DESIGN["word"], DESIGN["ii"], DESIGN["tag"]
TRANSFERS = {"vertex": 6, "triangle": 2, "pair": 1}[DESIGN["stream"]]
LEAST, MOST = -2**(WORD - 1), 2**(WORD - 1) - 1

test = cocotb.test(timeout_time=60, timeout_unit="us")


async def ready(dut, stall=None):
    """The core behind a reset; with a seed all valid and ready come at random."""
    stream = Stream(dut)
    await stream.reset()
    if stall is not None:
        stream.stall(stall)
    return stream


def due(pair, tag, out_of_range=False, cut_short=False):
    """What the golden model answers to a pair of triangles."""
    if out_of_range or cut_short:
        return Answer(True, False, True, cut_short, 0, 14, tag)
    verdict = golden.exact(*pair)
    return Answer(verdict.collision, verdict.coplanar, False, False, 0, verdict.axis, tag)


def draw_tags(pairs, random):
    return [random.getrandbits(TAG) for _ in pairs]


async def check(stream, pairs, random):
    """A batch of pairs with tags at random is answered as it should be."""
    tags = draw_tags(pairs, random)
    await stream.send(pairs, tags)
    assert await stream.batch() == list(map(due, pairs, tags))


@test
async def families(dut):
    """Hard pairs of every family, as fast as it goes."""
    stream = await ready(dut)
    for seed, family in enumerate(golden.families()):
        await check(stream, golden.hard_pairs(family, WORD, 12, seed), Random(seed))


@test
async def families_stalled(dut):
    """The same with every valid and ready at random."""
    stream = await ready(dut, stall=1)
    for seed, family in enumerate(golden.families()):
        await check(stream, golden.hard_pairs(family, WORD, 4, seed), Random(seed))


@test
async def in_a_plane(dut):
    """Coplanar and degenerate pairs among others."""
    stream = await ready(dut, stall=2)
    pairs = [pair for few in zip(*(golden.hard_pairs(family, WORD, 12, 3) for family in (
        "coplanar", "local", "degenerate", "parallel"))) for pair in few]
    assert {golden.exact(*pair).coplanar for pair in pairs} == {False, True}
    await check(stream, pairs, Random(3))


@test
async def batches(dut):
    """TLAST goes with its pair: batches of one pair, of some, one right behind the other."""
    stream = await ready(dut, stall=3)
    pairs = golden.hard_pairs("local", WORD, 6, 4)
    sizes = 1, 1, 2, 6, 1, 5, 3
    for tag, size in enumerate(sizes):
        await stream.send(pairs[:size], [tag] * size)
    for tag, size in enumerate(sizes):
        assert await stream.batch() == [due(pair, tag) for pair in pairs[:size]]


@test
async def tags(dut):
    """A tag is that of a pair's last transfer; every bit of it travels."""
    stream = await ready(dut)
    for tag in [1 << bit for bit in range(TAG)] + [0, 2**TAG - 1]:
        pair, = golden.hard_pairs("uniform", WORD, 1, tag)
        tuser = [tag ^ 1] * (TRANSFERS - 1) + [tag]
        await stream.source.send(AxiStreamFrame(stream.transfers(pair), tuser=tuser))
        assert await stream.batch() == [due(pair, tag)]


@test
async def coordinates_out_of_range(dut):
    """A coordinate beyond the word, wherever it stands: undecided, and only this pair."""
    stream = await ready(dut, stall=4)
    pairs, answers = [], []
    for k in range(18):
        for value in LEAST, LEAST - 1, MOST, MOST + 1, -2**31, 2**31 - 1:
            flat = [3 * (n % 7) for n in range(18)]
            flat[k] = value
            pairs.append((flat[:9], flat[9:]))
            answers.append(due(pairs[-1], k % 2**TAG, not LEAST <= value <= MOST))
    await stream.send(pairs, [answer.tag for answer in answers])
    assert await stream.batch() == answers


@cocotb.test(timeout_time=60, timeout_unit="us", skip=TRANSFERS == 1)
async def cut_short(dut):
    """TLAST within a pair: undecided, and flagged; the next transfer begins a pair."""
    stream = await ready(dut, stall=5)
    for count in range(1, TRANSFERS):
        whole, broken = golden.hard_pairs("touch-edges", WORD, 2, count)
        part = stream.transfers(whole) + stream.transfers(broken)[:count]
        await stream.source.send(AxiStreamFrame(part, tuser=7))
        await stream.send([whole], [8])
        assert await stream.batch() == [due(whole, 7), due(broken, 7, cut_short=True)], count
        assert await stream.batch() == [due(whole, 8)], count


@test
async def unused_bits(dut):
    """Bits of a transfer that mean nothing may be anything."""
    stream, random = await ready(dut), Random(6)
    used = sum(stream.transfers(([-1] * 9, [-1] * 9))[0] >> 128 * k & (1 << 96) - 1 and
               (1 << 96) - 1 << 128 * k for k in range(8))
    for pair in golden.hard_pairs("shared-edge", WORD, 12, 6):
        noise = [random.getrandbits(len(dut.s_axis_tdata)) & ~used for _ in range(TRANSFERS)]
        words = [word | bits for word, bits in zip(stream.transfers(pair), noise)]
        await stream.source.send(AxiStreamFrame(words, tuser=6))
        assert await stream.batch() == [due(pair, 6)]


@test
async def back_pressure(dut):
    """Verdicts that nobody takes: what is offered stands, the core fills up, nothing is lost."""
    stream = await ready(dut)
    pairs = golden.hard_pairs("local", WORD, 40, 7)
    tags = draw_tags(pairs, Random(7))
    stream.sink.pause = True
    await stream.send(pairs, tags)
    await RisingEdge(dut.m_axis_tvalid)
    await RisingEdge(dut.aclk)
    offered = dut.m_axis_tdata.value, dut.m_axis_tuser.value
    for _ in range(500):
        await RisingEdge(dut.aclk)
        assert dut.m_axis_tvalid.value == 1
        assert (dut.m_axis_tdata.value, dut.m_axis_tuser.value) == offered
    assert dut.s_axis_tready.value == 0
    stream.sink.pause = False
    assert await stream.batch() == list(map(due, pairs, tags))


@test
async def speed(dut):
    """A pair every II cycles, or in as many as it has transfers, whichever is more."""
    stream = await ready(dut)
    pairs = [pair for pair in golden.hard_pairs("uniform", WORD, 60, 8)
             if golden.exact(*pair).axis != 12][:40]
    await stream.send(pairs, [0] * 40)
    await RisingEdge(dut.m_axis_tvalid)
    begin = get_sim_time("ns")
    assert len(await stream.batch()) == 40
    cycles = (get_sim_time("ns") - begin) / 10
    assert abs(cycles - 39 * max(II, TRANSFERS)) <= max(II, TRANSFERS), cycles


@test
async def reset_amid_pair(dut):
    """A reset amid a pair: the next transfer begins one, and no old verdict comes."""
    stream = await ready(dut)
    pairs = golden.hard_pairs("identical", WORD, 9, 9)
    for cycles in 3, 5, 16, 31:
        await stream.send(pairs, [1] * 9)
        await ClockCycles(dut.aclk, cycles)
        await stream.reset()
        stream.sink.clear()
        await check(stream, pairs, Random(cycles))
    assert stream.sink.empty()
