# SPDX-License-Identifier: MIT
"""accuracy_page - the page of what scripts/experiments/accuracy counted, as HTML. Every share has
its interval of 95 %."""
from __future__ import annotations

import html
import re
from pathlib import Path
from typing import Dict, List, Sequence

from accuracy_counts import (Row, chosen, false_alarms, length, missed, option, share_text, wilson)

Cells = Sequence[str]
ERRORS = ["missed (95 %)", "deepest, LSB", "false alarms (95 %)", "widest gap, LSB"]
# What a design has unless it says otherwise.
USUAL = re.compile(r" --(ii=[0-9]+|coplanar=exact|clock-ns=[0-9.]+|block-float=off"
                   r"|coplanarity=plane|inequality=correct|epsilon=1\b)")

STYLE = """body { font: 15px/1.5 sans-serif; max-width: 60em; margin: 2em auto; padding: 0 1em }
table { border-collapse: collapse; margin: 1em 0 }
td, th { border: 1px solid #ccc; padding: .2em .6em; text-align: right }
td:first-child, th:first-child { text-align: left }
img { max-width: 100% }"""

PAGE = """<!DOCTYPE html>
<html lang="en"><head><meta charset="utf-8"><title>sepax: speed against error</title>
<style>
{style}
</style></head><body>
<h1>Speed against error</h1>
<p>This page compares how often each method is wrong with how fast it is. Every design point judges
seeded pairs of each family of hard cases. The truth is the exact verdict on the same W-bit
integers, which an oracle in rational numbers confirms (<code>tb/oracle</code>). A <b>missed</b>
collision is the dangerous error; its depth is the shortest translation that would separate the
triangles. A <b>false alarm</b> costs time; its gap is the distance of the triangles. A verdict is
<b>flipped</b> if it changes when the same pair is given in another vertex order, exchanged, moved,
mirrored or scaled by two. A pair is <b>proper</b> if both triangles have an area, else
<b>degenerate</b>. Degenerate pairs are counted apart, because most tests are not made for them.</p>
<p>Numbers in brackets are the interval that holds the share with a confidence of 95 %. "none (&lt;
s)" says that none was found and that the interval ends at s, which is 3 / N. Made by
<code>make experiment NAME=accuracy</code> on {machine}. All figures are in
<a href="accuracy.csv">accuracy.csv</a> and <a href="accuracy.json">accuracy.json</a>.</p>
<h2>W = 18, proper pairs</h2>{main}
<h2>W = 18, degenerate pairs</h2>{degenerate}
<p>{speed}</p>
{cost}
<p>{heat_missed}{heat_false}</p>
<h2>Meshes</h2>
<p>The pairs of triangles of two meshes, fitted into 18 bits, whose AABBs are not more than 1 LSB
apart. Triangles are surfaces: a body that is wholly inside another collides with none of its
triangles, so no design sees the collision; <code>sepax check</code> does.</p>
{meshes}
<h2>What a verdict on a grid is worth</h2>
<p>Each of the 18 coordinates of a pair is moved by -1, 0 or 1 LSB at random, and the changed exact
verdicts are counted. The last column counts the verdicts that differ between the grid and the
files. For an answer about the bodies, not about the grid, use <code>sepax check</code> without
<code>--grid</code>, or with a clearance.</p>
{nudged}
<h2>A filter</h2>
<p><code>filtered</code> is never wrong. It computes in doubles with a bound on the rounding of each
sign, and in exact integers if a sign is in doubt. So many pairs need no integers:</p>
{settled}
<h2>How many bits? (proper pairs, from here on)</h2>
<p>{missed_word}{false_word}</p>
<p>Is the word long enough? Here the truth is that of the real triangles, before they were rounded
to W bits. The errors that are left are not errors of arithmetic: a verdict that is exact on
integers can be wrong by about one LSB.</p>
<p>{real_word}</p>{real}
<h2>Guard bits of architecture paper</h2>
<p>{missed_guard}
{false_guard}</p>
{guard}
<h2>What each shortcut of the paper costs</h2>
<p>The coplanarity test and the inequality as they are printed, and the tolerance of
coplanarity.</p>
{shortcuts}
<p>At full precision the right coplanarity test misses nothing. Its false alarms in proper pairs,
family by family, with the tolerance of 1 LSB and without it:</p>
{families}
<h2>The Verilog</h2>
<p>The same families through the verilated designs. Each verdict is compared with that of the golden
model:</p>
<pre>{rtl}</pre>
<p>Software on one core, the families uniform and local in turn, and the slowest family:</p>
<pre>{bench}</pre>
</body></html>
"""


def short(design: str) -> str:
    """A design's options without the usual ones."""
    return USUAL.sub("", design).replace("--arch=", "").replace("--", "")


def table(heads: Cells, rows: Sequence[Cells]) -> str:
    """A table; what is between tags is text."""
    lines = ["<table><tr>" + "".join(f"<th>{html.escape(head)}</th>" for head in heads) + "</tr>"]
    lines += ["<tr>" + "".join(f"<td>{html.escape(cell)}</td>" for cell in row) + "</tr>"
              for row in rows]
    return "\n".join(lines) + "</table>"


def errors(row: Row) -> List[str]:
    """The cells under ERRORS."""
    lost, alarms = missed(row), false_alarms(row)
    return [share_text(lost), length(row["deepest_missed_lsb"], lost),
            share_text(alarms), length(row["widest_false_lsb"], alarms)]


def part(found: str, of: str) -> str:
    """A share with its interval, of two columns; "-" if nothing was tried."""
    return share_text(wilson(int(found), int(of))) if int(of or 0) else "-"


def designs(rows: List[Row], study: str, triangles: str = "proper") -> List[List[str]]:
    """A line for each design point of a study, all families."""
    return [[short(row["design"]), *errors(row), part(row["flipped"], row["varied"])]
            for row in chosen(rows, study, triangles)]


def design_table(rows: List[Row], *studies: str, triangles: str = "proper") -> str:
    """The design points of one or more studies."""
    lines = [line for study in studies for line in designs(rows, study, triangles)]
    return table(["design", *ERRORS, "flipped by a turn (95 %)"], lines)


def mesh_table(rows: List[Row]) -> str:
    """A line for each pair of meshes and design point."""
    return table(["meshes", "design", "pairs", "collisions", *ERRORS],
                 [[row["family"], short(row["design"]), row["pairs"], row["collisions"],
                   *errors(row)]
                  for row in rows if row["study"] == "meshes" and row["triangles"] == "any"])


def nudged_table(rows: List[Row], differ: Dict[str, str]) -> str:
    """Exact verdicts that change by 1 LSB; `differ`: those that the grid changes, of meshes."""
    return table(["pairs", "moved", "changed (95 %)", "not as in the files"],
                 [[row["family"], row["nudged"], part(row["changed_by_1_lsb"], row["nudged"]),
                   differ.get(row["family"], "-")]
                  for row in rows if row["study"] in ("main", "meshes") and
                  row["triangles"] == "any" and option(row["design"], "arch") == "exact"])


def settled_table(rows: List[Row]) -> str:
    """Pairs that the filter settles."""
    found: Dict[str, Dict[str, str]] = {}
    for row in rows:
        if option(row["design"], "arch") != "filtered":
            continue
        if row["study"] == "word" and row["family"] == "all":
            what = f"families, W = {option(row['design'], 'word')}"
        elif row["study"] == "meshes":
            what = f"{row['family']}, W = 18"
        else:
            continue
        pairs = int(row["pairs"])
        found.setdefault(what, {})[row["triangles"]] = \
            f"{100 * int(row['settled']) / pairs:.2f} %" if pairs else "-"
    return table(["pairs", "proper", "degenerate"],
                 [[what, of.get("proper", "-"), of.get("degenerate", "-")]
                  for what, of in found.items()])


def family_table(rows: List[Row]) -> str:
    """False alarms of paper at full precision, with the tolerance of 1 LSB and without."""
    found: Dict[str, Dict[str, Row]] = {}
    for row in rows:
        if row["study"] == "epsilon" and row["triangles"] == "proper" and \
                option(row["design"], "precision") == "full":
            found.setdefault(row["family"], {})[option(row["design"], "epsilon")] = row
    lines = []
    for family, of in found.items():
        some = next(iter(of.values()))
        alarms = [cell for epsilon in ("1", "0")
                  for cell in (errors(of[epsilon])[2:] if epsilon in of else ["-", "-"])]
        lines.append([family, str(int(some["pairs"]) - int(some["collisions"])), *alarms])
    return table(["family", "separated", "false, epsilon = 1 (95 %)", "widest gap, LSB",
                  "false, epsilon = 0 (95 %)", "widest gap, LSB"], lines)


def picture(name: str, words: str) -> str:
    """An image of the folder."""
    return f'<img src="{name}.svg" alt="{words}">'


def page(out: Path, rows: List[Row]) -> str:
    """The page of a folder with accuracy.csv (`rows`), grid.csv, rtl.txt, bench.txt, machine.txt
    and pictures."""
    differ = dict(line.rsplit(",", 1) for line in (out / "grid.csv").read_text().splitlines())
    cost = picture("cost", "gates against error") if (out / "cost.svg").exists() else (
        "<p>Gates against error: not known here; <code>make experiment NAME=accuracy</code> without"
        " QUICK maps the designs.</p>")
    return PAGE.format(
        style=STYLE, machine=html.escape((out / "machine.txt").read_text().strip()),
        main=design_table(rows, "main"),
        degenerate=design_table(rows, "main", triangles="degenerate"),
        speed=picture("speed", "speed against error"), cost=cost,
        heat_missed=picture("heat-missed", "missed by family"),
        heat_false=picture("heat-false", "false alarms by family"),
        meshes=mesh_table(rows), nudged=nudged_table(rows, differ), settled=settled_table(rows),
        missed_word=picture("missed-word", "missed over W"),
        false_word=picture("false-word", "false alarms over W"),
        real_word=picture("real-word", "real triangles"), real=design_table(rows, "real"),
        missed_guard=picture("missed-guard", "missed over guard bits"),
        false_guard=picture("false-guard", "false alarms over guard bits"),
        guard=design_table(rows, "guard"),
        shortcuts=design_table(rows, "shortcut", "epsilon"), families=family_table(rows),
        rtl=html.escape((out / "rtl.txt").read_text().rstrip("\n")),
        bench=html.escape((out / "bench.txt").read_text().rstrip("\n")))
