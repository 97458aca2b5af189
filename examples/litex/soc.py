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
    """Rotations and shifts in 2^-20, from far apart to deep in each other."""
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
        poses.append((np.rint(turn * 2**20).astype(np.int64),
                      np.rint(shift * 2**20).astype(np.int64)))
    return poses


def library(a, b, pose):
    """The pairs that collide, by the library: the vertices of b are moved and rounded once."""
    turn, shift = pose
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
              for turn, _ in poses]
    lines.append("};\nstatic const int64_t shift_of[POSES][3] = {")
    lines += ["{" + ", ".join(map(str, shift.tolist())) + "}," for _, shift in poses]
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
               DRIVER / "sepax_tree_driver.c"]
    subprocess.run([f"{RISCV}gcc", "-march=rv32im", "-mabi=ilp32", "-Os", "-std=gnu11",
                    "-ffreestanding", "-nostdlib", "-Wall", "-Wextra", "-Werror", f"-I{made}",
                    f"-I{DRIVER}", "-isystem", soc / "software" / "include",
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


def compare(said, poses, meshes, numbers):
    """A line for each pose of the firmware's, beside the library. 0: all agree."""
    wrong, found, asked = 0, set(), 0
    before, _, outside = "\n".join(said).partition("outside\n")
    print("pose  pairs  library  cycles")
    for line in before.splitlines():
        words = line.split()
        if words[0] == "pair":
            found.add((numbers[0][int(words[1])], numbers[1][int(words[2])]))
        elif words[0] == "pose":
            pose, status, collisions, cycles = map(int, words[1:])
            want = library(*meshes, poses[pose])
            right = found == want and collisions == len(want) and status == bool(want)
            print(f"{pose:4}  {collisions:5}  {len(want):7}  {cycles:6}"
                  f"{'' if right else f'  WRONG, status {status}'}")
            wrong, found, asked = wrong + (not right), set(), asked + 1
    lines = outside.splitlines()
    refused = lines[:1] and lines[0].split()[2:3] == [str(BUS_ERROR)] and lines[1:] == ["end"]
    print("jobs outside of the SDRAM:", "a bus error" if refused else " / ".join(lines))
    print(f"{asked} poses of {len(poses)}, {wrong} differ")
    return 0 if asked == len(poses) and wrong == 0 and refused else 1


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
    return compare(said.splitlines(), poses, (a, b), (numbers_a, numbers_b))


if __name__ == "__main__":
    sys.exit(main())
