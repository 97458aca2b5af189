#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""datasheet - the datasheet of a generated design says what the design is: the ports of
NAME.json, its latency, the registers of NAME_registers.md, the estimate of `sepax gen --estimate`;
HTML and Markdown have the same tables; the waveform is well formed.

usage: datasheet.py DIR NAME ESTIMATE.json
       datasheet.py DIR NAME write FILE    of an engine: awready, wready and bvalid after a write, a
                                           line of FILE for each cycle, are those of the waveform
"""
import json
import re
import sys
import xml.etree.ElementTree
from html.parser import HTMLParser
from pathlib import Path

LEVELS = set("p01=x.|")
VOID = {"meta"}


class Page(HTMLParser):
    """Rows of all tables; elements that stay open; addresses that a browser would fetch."""

    def __init__(self):
        super().__init__()
        self.open, self.rows, self.cell, self.fetched = [], [], None, []

    def handle_starttag(self, tag, attrs):
        self.fetched += [value for name, value in attrs if name in ("src", "href")]
        if tag not in VOID:
            self.open.append(tag)
        if tag == "tr":
            self.rows.append([])
        if tag in ("td", "th"):
            self.cell = ""

    def handle_endtag(self, tag):
        if not self.open or self.open.pop() != tag:
            raise ValueError(f"</{tag}> closes another element")
        if tag in ("td", "th"):
            self.rows[-1].append(self.cell)
            self.cell = None

    def handle_data(self, data):
        if self.cell is not None:
            self.cell += data


def markdown_rows(text):
    """All rows of tables, without backticks and entities."""
    rows = []
    for line in text.splitlines():
        if line.startswith("|") and not re.fullmatch(r"[|\- ]*", line):
            cells = re.split(r"(?<!\\)\|", line)[1:-1]
            rows.append([re.sub(r"\\([|*])", r"\1", cell).replace("`", "").replace("&lt;", "<")
                         .replace("&gt;", ">").replace("&amp;", "&").strip() for cell in cells])
    return rows


def check(what, wanted, found):
    if wanted != found:
        sys.exit(f"datasheet: {what}: {found}, not {wanted}")


def check_wave(doc, name):
    wave = json.loads((doc / f"{name}_handshake.json").read_text())
    lengths = {len(lane["wave"]) for lane in wave["signal"] if lane}
    check("cycles of the lanes", 1, len(lengths))
    for lane in wave["signal"]:
        check(f"levels of {lane['name']}", set(), set(lane["wave"]) - LEVELS)
        check(f"values of {lane['name']}", lane["wave"].count("="), len(lane.get("data", [])))
    picture = xml.etree.ElementTree.parse(doc / f"{name}_handshake.svg")
    shown = "".join(picture.getroot().itertext())
    for lane in wave["signal"]:
        for word in [lane["name"]] + lane.get("data", []):
            check(f"{word} in the picture", True, word in shown)


def check_costs(rows, estimate):
    shown = {row[0]: row[1:] for row in rows if len(row) == 3}
    check("gates", "ge" in estimate, "gates" in shown)
    if "ge" in estimate:
        value, error = (re.sub(r"[^\d.]", "", cell) for cell in shown["gates"])
        check("gates", f"{estimate['ge'] / 1000:.1f}", value)
        check("error of the gates", f"{estimate['ge_error'] / 1000:.1f}", error)
        check("flip-flops", f"{estimate['flip_flops']:.0f}", shown["flip-flops"][0])
    for pairs, of in estimate.get("energy", {}).items():
        found = shown[f"energy of a pair that is {pairs}"][0]
        check(f"energy, {pairs}", f"{of['nj']:.3f} nJ", found)


def levels(lane, cycles):
    """0 or 1 in each of the first cycles; after a gap nothing changes."""
    shown = lane.replace("|", ".").ljust(cycles, ".")[:cycles]
    for i in range(1, cycles):
        shown = shown[:i] + (shown[i - 1] if shown[i] == "." else shown[i]) + shown[i + 1:]
    return shown


def check_write(doc, name, found):
    wave = json.loads((doc / f"{name}_handshake.json").read_text())
    lanes = {lane["name"]: lane["wave"] for lane in wave["signal"] if lane}
    for k, signal in enumerate(("awready", "wready", "bvalid")):
        check(signal, "".join(line[k] for line in found), levels(lanes[f"s_axi_{signal}"],
                                                                 len(found)))


def main():
    folder, name = Path(sys.argv[1]), sys.argv[2]
    doc = folder / "doc"
    if sys.argv[3] == "write":
        check_write(doc, name, Path(sys.argv[4]).read_text().split())
        return
    design = json.loads((folder / f"{name}.json").read_text())
    rows = markdown_rows((doc / f"{name}.md").read_text())
    ports = [row for row in rows if len(row) == 4 and row[1] in ("in", "out")]
    check("ports", [[p["name"], {"input": "in", "output": "out"}[p["direction"]],
                     str(p["width"]) + (", signed" if p["signed"] else ""), p["about"]]
                    for p in design["ports"]], ports)
    latency = [row[1].split()[0] for row in rows if row[0].startswith("latency")]
    check("latency", [str(design["latency"])], latency)
    registers = list(folder.glob(f"{name}*_registers.md"))
    wanted = markdown_rows(registers[0].read_text())[1:] if registers else []
    check("registers", wanted, [row for row in rows if len(row) == 5][1:])
    check_costs(rows, json.loads(Path(sys.argv[3]).read_text()))
    check_wave(doc, name)
    page = Page()
    page.feed((doc / f"{name}.html").read_text())
    check("open elements", [], page.open)
    check("fetched", [], page.fetched)
    check("tables of the HTML", rows, [[c.strip() for c in row] for row in page.rows])


main()
