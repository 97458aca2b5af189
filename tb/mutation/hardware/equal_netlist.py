# SPDX-License-Identifier: MIT
"""equal_netlist - the texts that tb/mutation/hardware/equal makes of a netlist: Yosys commands that
cut it, a miter of the design and its mutants in Verilog, and changes of BLIF and AIGER files."""
from __future__ import annotations

import re
from typing import Dict, Iterable, List, NamedTuple, Optional, Set

MEMORY_WORDS = 64  # a memory of so many words, or of
MEMORY_BITS = 500  # so many bits, is read as anything
ALONE = re.compile(r"flat <*= \{g_own, g_a, g_b\} == 40'd0|\(\{s, w, d\} == 30'd0\)")
PROJECTION = re.compile(r"-src sepax_(cmp[.]v|cop[.]v|nand[.]v|input[.]v:(39|41))")


class Failed(Exception):
    """Why nothing can be said of a mutant, in one line."""


def pattern(name: str) -> str:
    """A name as a pattern of Yosys, in which brackets have a meaning of their own."""
    return name.replace("[", "?").replace("]", "?")


# ------------------------------------------------------------------------- netlist, in RTLIL


def top_module(netlist: str) -> str:
    """The name of the module with the attribute top."""
    found = re.search(r"^attribute .top 1.*?^module .(\S+)", netlist, re.M | re.S)
    if not found:
        raise Failed("netlist.il has no top module")
    return found[1]


def module_lines(netlist: str, name: str) -> List[str]:
    """The lines of one module."""
    inside, lines = False, []
    for line in netlist.splitlines():
        if line.startswith("module "):
            inside = line.split()[1] == "\\" + name
        if inside:
            lines.append(line)
    return lines


def cell_types(netlist: str) -> Dict[str, str]:
    """The type of each cell by its name."""
    types: Dict[str, str] = {}
    for cell_type, name in re.findall(r"^\s*cell (\S+) (\S+)$", netlist, re.M):
        types.setdefault(name, cell_type)
    return types


def wires(lines: Iterable[str], name: str) -> List[str]:
    """The wires, without the first backslash, that match a regular expression to their end."""
    line = re.compile(rf"  wire .*\\({name})$")
    return [found[1] for found in map(line.match, lines) if found]


def cut(lines: List[str], top: str, names: Iterable[str]) -> List[str]:
    """Yosys commands after which these wires of the core are inputs of both copies, and outputs
    that are compared. A wire is the shortest name that ends so; the signs of orient3d are many."""
    core = "" if top == "sepax_narrow" else "[^ ]*narrow[.]"
    commands = []
    for name in names:
        many = name == "signs"
        ending = "(?:sign|d_a.a.b.b.)" if many else name
        found = wires(lines, f"{core}(?:[^ ]*[.])?{ending}")
        chosen = found if many or not found else [min(found, key=len)]
        commands += [f"expose -cut w:{pattern(wire)}" for wire in chosen]
    return commands


def overlapping(lines: List[str], top: str, sample: str) -> List[str]:
    """Yosys commands for a core behind an AABB test.

    A pair with disjoint AABBs goes into the core as zeros, so that disjoint_x is 0 for every pair
    there (proved by tb/mutation/hardware/disjoint). Whoever reads it reads 0 in both copies; where
    the mutant's is 1, the design's must be 1."""
    commands = []
    if re.search("--ii=1 .*--early-out=boxes", sample):
        commands += cut(lines, top, ["disjoint_x"])
    slot = re.compile(r"  wire width [0-9]* .((?:.*narrow[.])?slot_q)$")
    return commands + [f"expose w:{pattern(found[1])}" for found in map(slot.match, lines) if found]


class Memory:
    """Commands for the ports of memories: what is read is an input, what goes in is an output."""

    def __init__(self) -> None:
        self.done: Set[str] = set()
        self.renamed = 0

    def commands(self, signals: Iterable[str], command: str) -> List[str]:
        """A command for each wire of the signals; a wire without a name of its own gets one."""
        lines = []
        for name in " ".join(signals).replace("{", " ").replace("}", " ").split():
            if name[0] not in "\\$" or name in self.done:
                continue
            self.done.add(name)
            if name[0] == "$":
                self.renamed += 1
                lines.append(f"rename {name} memory_{self.renamed}")
                name = f"memory_{self.renamed}"
            lines.append(f"{command} w:{pattern(name[1:] if name[0] == chr(92) else name)}")
        return lines


def memories(lines: Iterable[str]) -> List[str]:
    """Yosys commands that take large memories out of the proof."""
    reads, writes = [], []
    inside = large = False
    words = 0
    for line in lines:
        part = line.split(None, 2)
        if line.startswith("  cell $mem_v2 "):
            inside, large, words = True, False, 0
        elif line.startswith("  end"):
            inside = False
        elif inside and part[1:2] == ["\\SIZE"]:
            words = int(part[2])
            large = words >= MEMORY_WORDS
        elif inside and part[1:2] == ["\\WIDTH"]:
            large = large or words * int(part[2]) >= MEMORY_BITS
        elif inside and large and part[:1] == ["connect"]:
            if part[1] == "\\RD_DATA":
                reads.append(part[2])
            elif re.search("_(ADDR|DATA|EN)$", part[1]):
                writes.append(part[2])
    memory = Memory()
    return memory.commands(writes, "expose") + memory.commands(reads, "expose -input")


def projections(lines: Iterable[str]) -> List[str]:
    """Yosys commands for the architecture paper: the sums of products are inputs, and what the
    datapath gets from the comparing units is compared."""
    sums = wires(lines, r"[^\\]*[.]inner[.]sum")
    return [f"expose -cut w:{pattern(wire)}" for wire in sums] + [
        "delete -output w:*.inner.sum; expose w:words.step w:cop.coplanar w:axes?6?.cmp.idle",
        "opt_clean"]


# ------------------------------------------------------------------------------------ mutants


def in_large_memory(mutant: str) -> bool:
    """A mutant of a memory that is read as anything."""
    found = re.match(r"mutate .* -cell \\*([^ ]*) ", mutant)
    return found is not None and found[1].endswith(".word_q")


def absorbed(mutant: str, types: Dict[str, str]) -> bool:
    """An input of an OR is inverted where another input is 1, or an input of an AND where another
    is 0."""
    found = re.match(r"mutate -mode (cnot[01]) .* -cell ([^ ]*) -port [AB] ", mutant)
    if not found:
        return False
    gates = ("[$](reduce_(or|bool)|logic_(not|and|or))" if found[1] == "cnot1"
             else "[$]reduce_and")
    return re.fullmatch(gates, types.get(found[2], "")) is not None


def source_line(mutant: str) -> Optional[List[str]]:
    """Of a mutant that makes a bit of an input A constant 0: the file and the line, from 1, of its
    cell."""
    found = re.match(r"mutate -mode const0 .* -port A .* -src ([^ ]*[.]v):([1-9][0-9]*)[.]", mutant)
    return [found[1], found[2]] if found else None


# -------------------------------------------------------------------------------------- miter


class Port(NamedTuple):
    """A port of the module with the mutants."""
    name: str
    direction: str
    width: int

    @property
    def bits(self) -> str:
        """Its range in Verilog."""
        return f"[{self.width - 1}:0] "


class Miter:
    """A module of two copies of the netlist, one of which has a mutant switched on; its output
    `differ` says that the copies differ. A copy is written once, with @ for its number, 0 or 1."""

    def __init__(self) -> None:
        self.clock = "clk"
        self.reset = "1'b1"  # of a part without a reset
        self.heads = ""
        self.ports = ""
        self.text = ""
        self.differ = ""
        self.slots = ""
        self.apart: List[str] = []

    def add(self, port: Port) -> None:
        """One port; what it is for is in its name."""
        name = port.name
        if name == "rst":
            self.reset = name
        elif name == "aclk":
            self.clock, self.reset = name, "!aresetn"
        if re.search("disjoint_[xz].i$", name):
            self.connect(name, "1'b0")
        elif name.endswith(".sum.i"):
            self.input(port)
            self.connect(name, self.sum(port))
        elif name.endswith(".idle") or name == "cop.coplanar":
            self.connect(name, f"\\{name}_@ ")
            self.text += f"  wire {port.bits}\\{name}_0 , \\{name}_1 ;\n"
            if name == "cop.coplanar":
                self.differ += (" || (\\words.step_0 [5:3] != 0 && "
                                "\\cop.coplanar_0 != \\cop.coplanar_1 )")
        elif re.search("(again|free).i$", name):  # both copies read the design's
            self.connect(name, f"\\{re.sub('[.]i$', '', name)}_0 ")
        elif name == "mutant":
            return
        elif port.direction == "input":
            self.input(port)
            self.connect(name, f"\\{name} ")
        elif port.direction == "output":
            self.output(port)

    def connect(self, name: str, signal: str) -> None:
        """Connects a port of the copies."""
        self.ports += f", .\\{name} ({signal})"

    def input(self, port: Port) -> None:
        """Makes a port an input of the miter."""
        self.heads += f", \\{port.name} "
        self.text += f"  input wire {port.bits}\\{port.name} ;\n"

    def output(self, port: Port) -> None:
        """Compares an output of the copies."""
        of = [f"\\{port.name}_0 ", f"\\{port.name}_1 "]
        self.text += f"  wire {port.bits}{of[0]}, {of[1]};\n"
        self.connect(port.name, f"\\{port.name}_@ ")
        if re.search("(narrow[.]|^)slot_q$", port.name):
            self.slots = f"\\{port.name}_0 [{port.width - 1}] && "
        if re.search("disjoint_[xz]$", port.name):
            self.apart.append(f"{of[0]}< {of[1]}")
        else:
            self.differ += f" || {of[0]}!= {of[1]}"

    def sum(self, port: Port) -> str:
        """What the copies read in place of a sum of the projections.

        Vertices 0 ... 2 are A's, 3 ... 5 are B's. On an axis that is normal to an edge the ends of
        the edge have the same projection (proved by tb/mutation/hardware/lone)."""
        on, number, vertex = [re.split(r"[\[\]]", port.name)[at] for at in (0, 1, 3)]
        n, k = int(number), int(vertex)
        if on != "axes":
            return free_sum(on, n, k)
        of_b = int(k >= 3)
        k -= 3 * of_b
        # The edges to which the axis is normal, by table: theirs are k and the vertex before it.
        edge = int(k == ((n % 3 if of_b else n // 3) + 1) % 3)
        table = int(k == (n % 3 + 1) % 3 and bool(of_b) == (n >= 3)) if n < 6 else edge
        before = (k + 2) % 3
        name = f"\\{on}{n}{k}{of_b}"
        self.text += (f"  wire {port.bits}{name} = (\\axes[6].cmp.idle_0 ? {table} : {edge}) ? "
                      f"{free_sum(on, n, before + 3 * of_b)} : {free_sum(on, n, k + 3 * of_b)};\n")
        return name + " "

    def verilog(self) -> str:
        """The module. Nothing counts before the first reset."""
        differ = self.differ + "".join(f" || ({self.slots}{pair})" for pair in self.apart)
        copies = "".join(
            f"  mutants m{copy}(.mutant({mutant}){self.ports.replace('@', str(copy))});\n"
            for copy, mutant in enumerate(["16'd0", "mutant"]))
        return f"""`default_nettype none
module miter(differ{self.heads});
  output wire differ;
{self.text}  reg begun = 1'b0;
  reg [15:0] mutant = 16'd0;
  always @(posedge {self.clock}) mutant <= mutant;
{copies}  always @(posedge {self.clock}) begun <= begun || {self.reset};
  assign differ = begun && (1'b0{differ});
endmodule
"""


def free_sum(on: str, number: int, vertex: int) -> str:
    """The input for a sum."""
    return f"\\{on}[{number}].proj.vertex[{vertex}].inner.sum.i "


def miter(ports: Dict[str, Dict]) -> str:
    """The miter of a module with these ports, as Yosys' JSON tells them."""
    made = Miter()
    for name, port in ports.items():
        made.add(Port(name, port["direction"], len(port["bits"])))
    return made.verilog()


# ------------------------------------------------------------------------------ BLIF and AIGER


def share(blif: str) -> str:
    """The miter's BLIF in which the mutant's copy reads the registers of the design's copy, and
    what goes into its own registers is compared. If both are the same in one cycle, they are the
    same in the next."""
    into: Dict[str, str] = {}
    lines, shared = [], 0
    for line in blif.splitlines():
        words = line.split()
        first = words[0] if words else ""
        if first == ".latch" and words[2].startswith("m0."):
            into[words[2][3:]] = words[1]
        if first == ".latch" and words[2].startswith("m1."):
            register = words[2][3:]
            if register not in into:
                raise Failed(f"no register {register}")
            before = f"any{shared}" if shared else "differ"
            shared += 1
            lines += [f".names m0.{register} {words[2]}", "1 1",
                      f".names {into[register]} {words[1]} other{shared}", "10 1", "01 1",
                      f".names {before} other{shared} any{shared}", "1- 1", "-1 1"]
            continue
        if first == ".outputs":
            continue
        if first == ".end":
            lines.append(f".outputs {f'any{shared}' if shared else 'differ'}")
        lines.append(line)
    return "".join(line + "\n" for line in lines)


def number_bits(aiger: bytes) -> Dict[int, int]:
    """Which bit of the mutant's number each latch is, by the AIGER file's table of symbols."""
    return {int(latch): int(bit)
            for latch, bit in re.findall(rb"^l([0-9]+) mutant\[([0-9]+)\]$", aiger, re.M)}


def begun(aiger: bytes, bits: Dict[int, int], number: int) -> bytes:
    """The AIGER file in which the mutant's number is switched on. The number's bits are latches
    that keep what they begin with, so they begin with the number."""
    header = re.match(rb"aig [0-9]+ [0-9]+ ([0-9]+) ", aiger)
    if not header:
        raise Failed("ABC writes no AIGER file")
    latches = int(header[1])
    *lines, gates = aiger.split(b"\n", latches + 1)
    for latch, bit in bits.items():
        following = lines[latch + 1].split()[0]
        lines[latch + 1] = b"%s %d" % (following, number >> bit & 1)
    return b"\n".join([*lines, gates])
