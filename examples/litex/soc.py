#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""soc - a SoC of LiteX with a tree engine, simulated: a VexRiscv asks the engine about two bodies
that lie in LiteDRAM, and the library is asked the same.

  soc.py [-o FOLDER] [--poses=N] [--seed=S] [--word=W] [--ii=II]

README.md says what it is made of. Exit status: 0, all agree; 1, some differ; 2, an error."""
import argparse
import logging
import os
import shutil
import struct
import subprocess
import sys
from pathlib import Path
from typing import List, NamedTuple, Tuple

import numpy as np
import sepax
from litedram.modules import MT48LC16M16
from litedram.phy.model import SDRAMPHYModel
from litex.build.generic_platform import Pins, Subsignal
from litex.build.sim import SimPlatform
from litex.soc.integration import export
from litex.soc.integration.soc_core import SoCCore
from litex.gen import LiteXModule
from migen import ClockDomain
from sepax.litex import TreeEngine

HERE = Path(__file__).resolve().parent
DRIVER = HERE.parent.parent / "drivers" / "tree_engine"
BYTES = HERE.parent / "soc" / "firmware"
RISCV = os.environ.get("RISCV", "riscv64-unknown-elf-")  # prefix of the compiler
CLOCK = 100_000_000
BUS_ERROR = 1 << 4  # bit of the status of a pose
FILE_UNIT = 4096  # trees and records begin at multiples of it
IO = [("sys_clk", 0, Pins(1)), ("sys_rst", 0, Pins(1)),
      ("serial", 0, *[Subsignal(f"{side}_{name}", Pins(bits)) for side in ("source", "sink")
                      for name, bits in (("valid", 1), ("ready", 1), ("data", 8))])]


class Clocks(LiteXModule):
    """One clock, and a reset that the simulation drives."""

    def __init__(self, platform):
        self.cd_sys = ClockDomain()
        self.comb += [self.cd_sys.clk.eq(platform.request("sys_clk")),
                      self.cd_sys.rst.eq(platform.request("sys_rst"))]


class Chip(SoCCore):
    """A VexRiscv, 64 MB of SDRAM with a cache, and the tree engine. dram: words in the SDRAM."""

    def __init__(self, folder, dram, **options):
        platform = SimPlatform("SIM", IO)
        self.crg = Clocks(platform)
        super().__init__(platform, clk_freq=CLOCK, cpu_type="vexriscv", uart_name="sim",
                         integrated_rom_size=0x8000, integrated_sram_size=0x2000,
                         ident="sepax", ident_version=False)
        module = MT48LC16M16(CLOCK, "1:1")
        self.sdrphy = SDRAMPHYModel(module=module, data_width=32, clk_freq=CLOCK, init=dram)
        self.add_sdram("sdram", phy=self.sdrphy, module=module, l2_cache_size=8192)
        self.tree = TreeEngine(platform, folder / "tree", **options)
        self.tree.connect(self)


# ------------------------------------------------------------------------------- the bodies

def body(folder, name, *shape):
    """A mesh of whole numbers, its tree, and the numbers in the mesh of the tree's triangles."""
    program = sepax.paths.program()
    files = [folder / f"{name}.{kind}" for kind in ("stl", "obj", "sxt")]
    subprocess.run([program, "mesh", *shape, "-o", files[0]], check=True,
                   stdout=subprocess.DEVNULL)
    triangles = np.rint(sepax.read_mesh(files[0])[0]).astype(np.int64)
    flat = np.all(triangles[:, 0] == triangles[:, 1], axis=1)
    flat |= np.all(triangles[:, 1] == triangles[:, 2], axis=1)
    flat |= np.all(triangles[:, 2] == triangles[:, 0], axis=1)
    triangles = triangles[~flat]
    with open(files[1], "w", encoding="utf-8") as file:
        for vertex in triangles.reshape(-1, 3):
            file.write("v {} {} {}\n".format(*vertex))
        for n in range(len(triangles)):
            file.write(f"f {3 * n + 1} {3 * n + 2} {3 * n + 3}\n")
    subprocess.run([program, "tree", files[1], "--resolution=1", "--word=12", "-o", files[2]],
                   check=True, stdout=subprocess.DEVNULL)
    tree = files[2].read_bytes()
    numbers = struct.unpack(f"<{len(triangles)}I", tree[-4 * len(triangles):])
    return triangles, tree, numbers


def poses_of(count, seed):
    """Rotations and shifts, from deep in each other to far apart."""
    rng = np.random.default_rng(seed)
    poses = []
    for n in range(count):
        q = rng.normal(size=4)
        w, x, y, z = q / np.linalg.norm(q)
        turn = np.array([[1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
                         [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
                         [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)]])
        way = rng.normal(size=3)
        shift = way / np.linalg.norm(way) * 900 * (n + 0.5) / count
        poses.append((turn, np.rint(shift * 2**20) / 2**20))
    return poses


def fixed(pose):
    """A pose in whole numbers of 2^-20, as the engine takes it."""
    return tuple(np.rint(part * 2**20).astype(np.int64) for part in pose)


def library(a, b, pose):
    """The pairs that collide, by the library: the vertices of b are moved and rounded once."""
    turn, shift = fixed(pose)
    moved = (b.reshape(-1, 3) @ turn.T + shift + 2**19) >> 20
    corners = np.arange(moved.size // 3).reshape(-1, 3)
    found = sepax.meshes_pairs(
        (a.reshape(-1, 3).astype(float), np.arange(a.size // 3).reshape(-1, 3)),
        (moved.astype(float), corners))
    return {tuple(pair) for pair in found.tolist()}


# --------------------------------------------------------------------------- firmware, simulation

def scene_header(poses, places):
    """C arrays of the poses, and where the trees are in the memory."""
    lines = ["/* Made by soc.py. */", f"enum {{ POSES = {len(poses)} }};"]
    lines += [f"#define {name} 0x{place:x}u" for name, place in places.items()]
    lines.append("static const int32_t matrix_of[POSES][3][3] = {")
    lines += ["{" + ", ".join("{" + ", ".join(map(str, row)) + "}" for row in turn.tolist()) + "},"
              for turn, _ in map(fixed, poses)]
    lines.append("};\nstatic const int64_t shift_of[POSES][3] = {")
    lines += ["{" + ", ".join(map(str, shift.tolist())) + "}," for _, shift in map(fixed, poses)]
    return "\n".join(lines + ["};", ""])


def firmware(chip, folder, scene):
    """Compile the firmware with the addresses of this chip; its words."""
    made = folder / "firmware"
    shutil.rmtree(made, ignore_errors=True)
    (made / "generated").mkdir(parents=True)
    regions = chip.bus.regions
    written = {
        "generated/csr.h": export.get_csr_header(chip.csr_regions, chip.constants,
                                                 chip.mem_map["csr"]),
        "generated/mem.h": export.get_mem_header(regions),
        "generated/soc.h": export.get_soc_header(chip.constants, with_access_functions=False),
        "scene.h": scene,
        "memory.ld": "MEMORY {{ rom (rx) : ORIGIN = 0x{:x}, LENGTH = 0x{:x}\n"
                     "  ram (rwx) : ORIGIN = 0x{:x}, LENGTH = 0x{:x} }}\n".format(
                         regions["rom"].origin, regions["rom"].size,
                         regions["sram"].origin, regions["sram"].size),
    }
    for name, text in written.items():
        (made / name).write_text(text, encoding="utf-8")
    soc = Path(export.__file__).parent.parent
    elf, binary = made / "firmware.elf", made / "firmware.bin"
    sources = [HERE / "firmware" / "start.S", HERE / "firmware" / "main.c",
               BYTES / "bytes.c", DRIVER / "sepax_tree_driver.c"]
    subprocess.run([f"{RISCV}gcc", "-march=rv32im", "-mabi=ilp32", "-Os", "-std=gnu11",
                    "-ffreestanding", "-nostdlib", "-Wall", "-Wextra", "-Werror", f"-I{made}",
                    f"-I{DRIVER}", f"-I{BYTES}", "-isystem", soc / "software" / "include",
                    "-isystem", soc / "cores" / "cpu" / "vexriscv", f"-L{made}",
                    "-T", HERE / "firmware" / "firmware.ld", "-Wl,--no-warn-rwx-segments",
                    "-o", elf, *sources, "-lgcc"], check=True)
    subprocess.run([f"{RISCV}objcopy", "-O", "binary", elf, binary], check=True)
    data = binary.read_bytes()
    data += bytes(-len(data) % 4)
    return list(struct.unpack(f"<{len(data) // 4}I", data))


def simulate(chip, folder, words):
    """Write the Verilog of the chip with the firmware in its ROM, verilate it, run it."""
    chip.init_rom("rom", contents=words, auto_size=False)
    made = folder / "chip"
    made.mkdir(exist_ok=True)
    before = Path.cwd()
    os.chdir(made)
    try:
        verilog = chip.platform.get_verilog(chip, name="chip")
        verilog.write("chip.v")
    finally:
        os.chdir(before)
    sources = [str(Path(name)) for name, *_ in chip.platform.sources]
    with open(made / "verilate.log", "w", encoding="utf-8") as log:
        subprocess.run(["verilator", "--cc", "--exe", "--build", "-O3", "--x-assign", "fast",
                        "--noassert", "-Wno-fatal", "-Wno-lint", "--top-module", "chip", "-j", "2",
                        "-MAKEFLAGS", "OPT_FAST=-Og OPT_GLOBAL=-O1",
                        "--Mdir", "obj", "-o", "../run", "chip.v", *sources, HERE / "sim.cpp"],
                       cwd=made, check=True, stdout=log, stderr=log)
    return subprocess.run(["./run"], cwd=made, check=True, capture_output=True, text=True).stdout


class Answer(NamedTuple):
    """What the firmware was told of a pose: pairs of triangles, and the 16 numbers of its end."""
    pairs: List[Tuple[int, int]]
    end: List[int]

    status = property(lambda self: self.end[1])
    cycles = property(lambda self: self.end[4])
    collisions = property(lambda self: self.end[6])
    first = property(lambda self: tuple(self.end[12:14]))


def parse(said):
    """The answers in each batch of the firmware's: {name: [Answer, ...]}. Without the firmware's
    last word there are none."""
    batches, pairs = {}, []
    *lines, last = said.splitlines() or [""]
    for line in lines if last == "end" else []:
        kind, *words = line.split()
        if kind == "batch":
            answers = batches[words[0]] = []
        elif kind == "pair":
            pairs.append((int(words[0]), int(words[1])))
        else:
            answers.append(Answer(pairs, [int(word) for word in words]))
            pairs = []
    return batches


def compare(said, poses, meshes, numbers):
    """A line for each pose of the firmware's, beside the library. 0: all agree."""
    batches = parse(said)
    everything, first, again = (batches.get(name, []) for name in ("all", "first", "again"))
    wrong = 0
    print("pose  pairs  library  cycles")
    for n, (each, one, more) in enumerate(zip(everything, first, again)):
        want = library(*meshes, poses[n])
        found = [(numbers[0][a], numbers[1][b]) for a, b in each.pairs]
        right = (set(found) == want and each.collisions == len(found) == len(want)
                 and each.first == (each.pairs[0] if want else (0, 0))
                 and all(answer.status == bool(want) and answer.first == each.first
                         for answer in (each, one, more)))
        print(f"{n:4}  {each.collisions:5}  {len(want):7}  {one.cycles:6}"
              f"{'' if right else f'  WRONG, status {each.status}'}")
        wrong += not right
    outside = [name for name in ("triangles", "poses", "jobs")
               if [answer.status for answer in batches.get(name, [])] == [BUS_ERROR]]
    print(f"bus errors outside of the SDRAM: {', '.join(outside)}")
    asked = min(len(everything), len(first), len(again))
    print(f"{asked} poses of {len(poses)}, {wrong} differ")
    return 0 if asked == len(poses) and wrong == 0 and len(outside) == 3 else 1


def main():
    """Make, simulate, compare."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("-o", "--output", type=Path, default=Path("build/litex"), metavar="FOLDER",
                        help="where all is made (build/litex)")
    for option, number, what in (("poses", 8, "poses of the body b"), ("seed", 1, "of the poses"),
                                 ("word", 12, "bits of a coordinate of the engine, 12 or more"),
                                 ("ii", 3, "cycles of its core for a pair")):
        parser.add_argument(f"--{option}", type=int, default=number, help=f"{what} ({number})")
    given = parser.parse_args()
    for tool in (RISCV + "gcc", "verilator"):
        if shutil.which(tool) is None:
            parser.exit(2, f"soc: no {tool}; run scripts/setup, or give RISCV=PREFIX\n")
    logging.disable(logging.INFO)
    folder = given.output.resolve()
    folder.mkdir(parents=True, exist_ok=True)
    a, tree_a, numbers_a = body(folder, "a", "sphere", "--triangles=200", "--size=600")
    b, tree_b, numbers_b = body(folder, "b", "box", "--triangles=108", "--size=500")
    dram, places = b"", {}
    for name, tree in (("TREE_A", tree_a), ("TREE_B", tree_b)):
        places[name] = len(dram)
        dram += tree + bytes(-len(tree) % FILE_UNIT)
    places["RECORDS"] = len(dram)
    poses = poses_of(given.poses, given.seed)
    chip = Chip(folder, list(struct.unpack(f"<{len(dram) // 4}I", dram)), word=given.word,
                ii=given.ii)
    chip.finalize()
    said = simulate(chip, folder, firmware(chip, folder, scene_header(poses, places)))
    (folder / "said.txt").write_text(said, encoding="utf-8")
    return compare(said, poses, (a, b), (numbers_a, numbers_b))


if __name__ == "__main__":
    sys.exit(main())
