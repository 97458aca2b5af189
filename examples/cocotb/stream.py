# SPDX-License-Identifier: MIT
"""stream.py - drives the core on AXI4-Stream (sepax_stream): pairs in, verdicts out, a tag with
each. docs/reference/exact.md, AXI4-Stream."""
from collections import namedtuple

from cocotbext.axi import AxiStreamFrame

from axi import Top, vertices

Answer = namedtuple("Answer", "collision coplanar out_of_range cut_short band axis tag")


class Stream(Top):
    """The core behind its two streams."""

    def transfers(self, pair):
        """A pair of triangles as transfers: six, two or one, as s_axis_tdata is wide."""
        v = vertices(pair)
        if len(self.dut.s_axis_tdata) == 128:
            return v
        triangles = [v[k] | v[k + 1] << 128 | v[k + 2] << 256 for k in (0, 3)]
        if len(self.dut.s_axis_tdata) == 512:
            return triangles
        return [triangles[0] | triangles[1] << 512]

    async def send(self, pairs, tags):
        """Send a batch of pairs [(a, b), ...] with a tag each; TLAST is with the last."""
        parts = [self.transfers(pair) for pair in pairs]
        await self.source.send(AxiStreamFrame(
            [word for words in parts for word in words],
            tuser=[tag for words, tag in zip(parts, tags) for _ in words]))

    async def batch(self):
        """The answers to a batch, in the order of its pairs."""
        got = await self.sink.recv(compact=False)
        assert all(word & 0xfffff0c0 == 0 for word in got.tdata), "a bit that means nothing"
        return [Answer(bool(word & 1), bool(word & 2), bool(word & 4), bool(word & 8),
                       word >> 4 & 3, word >> 8 & 15, tag)
                for word, tag in zip(got.tdata, got.tuser)]
