# SPDX-License-Identifier: MIT
"""Are the registers in SystemRDL those of the C header and of the page? Is each register and field
described in words that need no other row, as a debugger shows them? Has each register that can be
written a value after reset?

  registers.py FOLDER MAP   of sepax gen; MAP is sepax_registers or sepax_tree_registers. Exit
                            status 1 and a line for each difference
"""
import re
import sys

from systemrdl import RDLCompiler

DEFINE = r"#define SEPAX_(?:TREE_)?(\w+)"
ACCESS = {
    ("r", None): "read",
    ("w", None): "write",
    ("rw", None): "read, write",
    ("rw", "woclr"): "read, write 1 to clear",
}


def undescribed(register):
    """Registers and fields without a description of their own, and fields without a reset."""
    rows = [(register.inst_name, register.get_property("desc"))]
    for f in register.fields():
        name = f"{register.inst_name}.{f.inst_name}"
        if f.inst_name != "VALUE":
            rows.append((name, f.get_property("desc")))
        if f.is_sw_writable and f.get_property("reset") != 0:
            print(f"{name}: no value after reset")
            yield name
    for name, words in rows:
        if not words or re.match(r"(its|of (these|them)|the same|likewise)\b", words):
            print(f"{name}: no description of its own: {words!r}")
            yield name


def of_rdl(path):
    """({register: (address, access, {field: (lowest bit, bits)})}, number of undescribed)"""
    compiler = RDLCompiler()
    compiler.compile_file(path)
    registers, wrong = {}, 0
    for register in compiler.elaborate().top.registers():
        wrong += len(list(undescribed(register)))
        fields = {f.inst_name: (f.lsb, f.width) for f in register.fields()}
        access = {
            ACCESS[f.get_property("sw").name, getattr(f.get_property("onwrite"), "name", None)]
            for f in register.fields()
        }
        if fields == {"VALUE": (0, 32)}:
            fields = {}
        registers[register.inst_name] = (register.absolute_address, access.pop(), fields)
        assert not access
    return registers, wrong


def of_header(path):
    """The same without access."""
    registers, name = {}, ""
    for line in open(path):
        match = re.match(rf"{DEFINE} 0x([0-9a-f]+)u? /\*", line)
        if match:
            name = match[1]
            registers[name] = (int(match[2], 16), {})
            continue
        match = re.match(rf"{DEFINE} 0x([0-9a-f]+)u?$", line)
        if match and match[1].startswith(name + "_") and name:
            mask = int(match[2], 16)
            registers[name][1][match[1][len(name) + 1 :]] = (mask.bit_length() - 1, 1)
        match = re.match(rf"{DEFINE}\(value\) .*& 0x([0-9a-f]+)u?\) >> (\d+)\)$", line)
        if match:
            mask, low = int(match[2], 16), int(match[3])
            registers[name][1][match[1][len(name) + 1 :]] = (low, mask.bit_length() - low)
    return registers


def of_page(path):
    """{register: access}"""
    row = re.compile(r"\| 0x\w+ \| `(\w+)` \| ([^|]+) \|")
    return {m[1]: m[2] for m in map(row.match, open(path)) if m}


def main(folder, of):
    rdl, wrong = of_rdl(f"{folder}/{of}.rdl")
    header = of_header(f"{folder}/{of}.h")
    page = of_page(f"{folder}/{of}.md")
    for name in sorted({*rdl, *header, *page}):
        others = (*header.get(name, (None, None)), page.get(name))
        address, access, fields = rdl.get(name, (None, None, None))
        if (address, fields, access) != others:
            print(f"{name}: SystemRDL {(address, fields, access)}, others {others}")
            wrong += 1
    print(f"{len(rdl)} registers, {wrong} wrong")
    return int(wrong > 0 or not rdl)


sys.exit(main(*sys.argv[1:]))
