# SPDX-License-Identifier: MIT
"""amaranth_core - a core in a design of Amaranth, simulated by Icarus Verilog.

  amaranth_core.py COUNT

COUNT pairs go through the streams with random gaps on both sides. Each verdict is compared with
sepax.exact. The last line is "COUNT pairs, N mismatches"."""
import subprocess
import sys

import numpy as np
import sepax
from amaranth.back import verilog
from amaranth.hdl import Module
from amaranth.lib import wiring
from sepax.amaranth import Core

NAMES = [f"{side}{k}_{axis}" for side in "ab" for k in (1, 2, 3) for axis in "xyz"]
BENCH = """`timescale 1ns/1ps
module bench;
  reg clk = 0, rst = 1;
  reg [{width} - 1:0] pairs [0:{count} - 1];
  reg valid = 0, ready = 0;
  wire pairs_ready, verdicts_valid;
  wire [{out} - 1:0] verdict;
  integer sent = 0, got = 0, seed = 1, file;
  top dut(.clk(clk), .rst(rst), .pairs__valid(valid), .pairs__ready(pairs_ready),
          .pairs__payload(pairs[sent]), .verdicts__valid(verdicts_valid),
          .verdicts__ready(ready), .verdicts__payload(verdict));
  always #1 clk = !clk;
  initial begin
    $readmemh("pairs.hex", pairs);
    file = $fopen("verdicts.txt", "w");
    repeat (4) @(posedge clk);
    #0.1 rst = 0;
  end
  always @(posedge clk) if (!rst) begin
    if (verdicts_valid && ready) begin
      $fdisplay(file, "%b", verdict);
      got = got + 1;
      if (got == {count}) begin $fclose(file); $finish; end
    end
    if (valid && pairs_ready) begin sent = sent + 1; valid <= #0.1 0; end
    if ((!valid || pairs_ready) && sent < {count}) valid <= #0.1 $random(seed) % 4 != 0;
    ready <= #0.1 $random(seed) % 4 != 0;
  end
  initial #{patience} begin $display("hung"); $finish; end
endmodule
"""


class Top(wiring.Component):
    """A design with a core, whose streams are its ports."""

    def __init__(self, core):
        self.core = core
        super().__init__({name: member for name, member in core.signature.members.items()})

    def elaborate(self, platform):
        """The core, and both streams."""
        m = Module()
        m.submodules.core = self.core
        wiring.connect(m, wiring.flipped(self.pairs), self.core.pairs)
        wiring.connect(m, self.core.verdicts, wiring.flipped(self.verdicts))
        return m


def main():
    """Make, simulate, compare."""
    count, word = int(sys.argv[1]), 8
    core = Core("core", word=word, ii=3)
    rng = np.random.default_rng(4)
    small = rng.integers(-3, 4, (2, count // 2, 3, 3))
    large = rng.integers(-2**(word - 1), 2**(word - 1), (2, count - count // 2, 3, 3))
    a, b = np.concatenate([small, large], axis=1)
    widths = {n: core.design.port("in_" + n).width for n in NAMES}
    order = [p.name[3:] for p in core.design.ports
             if p.direction == "input" and p.name[3:] in widths]
    with open("pairs.hex", "w", encoding="utf-8") as file:
        for p, q in zip(a.reshape(count, 9).tolist(), b.reshape(count, 9).tolist()):
            values, number, place = dict(zip(NAMES, p + q)), 0, 0
            for name in order:  # the first field is the lowest
                number |= (values[name] % 2**widths[name]) << place
                place += widths[name]
            file.write(f"{number:x}\n")
    outputs = [p for p in core.design.ports if p.direction == "output" and
               p.name not in ("in_ready", "out_valid")]
    with open("top.v", "w", encoding="utf-8") as file:
        file.write(verilog.convert(Top(core), name="top"))
    with open("bench.v", "w", encoding="utf-8") as file:
        file.write(BENCH.format(width=sum(widths.values()), count=count,
                                out=sum(p.width for p in outputs), patience=400 * count))
    subprocess.run(["iverilog", "-g2005", "-o", "bench", "bench.v", "top.v",
                    *map(str, core.design.files)], check=True)
    subprocess.run(["vvp", "-n", "bench"], check=True)
    with open("verdicts.txt", encoding="utf-8") as file:
        lines = file.read().split()
    place = 0
    for port in outputs:
        if port.name == "out_collision":
            break
        place += port.width
    got = np.array([line[-1 - place] == "1" for line in lines])
    want = sepax.exact(a, b).collision
    if len(got) != count:
        sys.exit(f"{len(got)} verdicts of {count} pairs")
    wrong = int((got != want).sum())
    print(f"{count} pairs, {int(want.sum())} collide, {wrong} mismatches")
    return 0 if wrong == 0 and 0 < want.sum() < count else 1


if __name__ == "__main__":
    sys.exit(main())
