# SPDX-License-Identifier: MIT
"""accuracy_counts - shares of wrong verdicts with their intervals, and the tables that are made of
accuracy.csv (scripts/experiments/accuracy).

A confidence interval is Wilson's, of 95 %. If nothing was found among N, it ends at about 3 / N
(the rule of three), and a table says "none (< 3 / N)".
"""
from __future__ import annotations

import csv
import math
import re
from pathlib import Path
from typing import Callable, Dict, List, NamedTuple, Optional, Sequence

Z = 1.959964  # of 95 %, both sides
CONTACT = 1e-7  # LSB: what is less deep is mere contact, but for rounding in the measurement
FEW = 100  # so many cases are few enough to be counted out in a table

Row = Dict[str, str]


class Share(NamedTuple):
    """How often something happened, with the interval of 95 %."""
    found: int
    of: int
    low: float
    high: float

    @property
    def drawn(self) -> float:
        """The share; if nothing was found, 3 / N."""
        return self.found / self.of if self.found else 3 / self.of


def wilson(found: int, of: int) -> Share:
    """Wilson's interval of 95 %."""
    share = found / of
    middle = (share + Z * Z / (2 * of)) / (1 + Z * Z / of)
    half = Z * math.sqrt(share * (1 - share) / of + Z * Z / (4 * of * of)) / (1 + Z * Z / of)
    return Share(found, of, max(middle - half, 0), min(middle + half, 1))


def read_counts(file: Path) -> List[Row]:
    """The rows of accuracy.csv."""
    with open(file, encoding="utf-8", newline="") as opened:
        return list(csv.DictReader(opened))


def option(design: str, name: str) -> str:
    """What an option of a design says; empty if it has none."""
    found = re.search(f"--{name}=([^ ]+)", design)
    return found[1] if found else ""


def missed(row: Row) -> Optional[Share]:
    """Of the collisions."""
    of = int(row["collisions"])
    return wilson(int(row["missed"]), of) if of else None


def false_alarms(row: Row) -> Optional[Share]:
    """Of the separated pairs."""
    of = int(row["pairs"]) - int(row["collisions"])
    return wilson(int(row["false_alarms"]), of) if of else None


def wrong(row: Row) -> Optional[Share]:
    """Of all pairs."""
    return wilson(int(row["missed"]) + int(row["false_alarms"]), int(row["pairs"]))


def chosen(rows: List[Row], study: str, triangles: str, family: str = "all") -> List[Row]:
    """The rows of a study: of proper or of any pairs, of all families or of one."""
    return [row for row in rows
            if (row["study"], row["family"], row["triangles"]) == (study, family, triangles)]


def main_rows(rows: List[Row]) -> List[Row]:
    """All proper pairs of each design at W = 18."""
    return chosen(rows, "main", "proper")


# --------------------------------------------------------------------------------------- text


def percent(value: float) -> str:
    """In percent, with two digits that count, without zeros at the end."""
    if value == 0:
        return "0"
    return f"{float(f'{100 * value:.2g}'):.9f}".rstrip("0").rstrip(".")


def decimals_of(share: Share) -> int:
    """The decimals of a share in percent: two digits that count, or as many as tell the ends of
    its interval apart."""
    width, value = 100 * (share.high - share.low), 100 * share.found / share.of
    return max(0, math.ceil(-math.log10(width)), 1 - math.floor(math.log10(value)))


def share_text(share: Optional[Share], counted: bool = True) -> str:
    """A share with its interval. It says how many were found if they are few and `counted`; if
    nothing was found, it says where the interval ends: 3 / N."""
    if share is None:
        return "-"
    if not share.found:
        return f"none (< {percent(3 / share.of)} %)"
    value, low, high = (f"{100 * part:.{decimals_of(share)}f}"
                        for part in (share.found / share.of, share.low, share.high))
    count = f"{share.found}, " if counted and share.found < FEW else ""
    return f"{count}{value} % ({low} ... {high})"


def length(text: str, share: Optional[Share]) -> str:
    """A depth or a gap in LSB, if there are wrong verdicts."""
    value = float(text)
    if share is None or not share.found:
        return "-"
    return "contact" if value < CONTACT else \
        f"{float(f'{value:.3g}'):,.9f}".rstrip("0").rstrip(".")


def markdown(heads: Sequence[str], rows: Sequence[Sequence[str]]) -> str:
    """A table."""
    return "\n".join(["| " + " | ".join(heads) + " |", "|" + " --- |" * len(heads),
                      *("| " + " | ".join(row) + " |" for row in rows)])


# ------------------------------------------------------------------------------------- tables

METHODS = {
    "exact": "`exact`", "filtered": "`filtered`", "paper full": "`paper`, full precision",
    "paper word": "`paper`, every number 18 bits", "guigue64": "float64, Guigue and Devillers",
    "float64": "float64, SAT", "interval64": "float64, interval test", "float32": "float32, SAT",
    "guigue32": "float32, Guigue and Devillers", "interval32": "float32, interval test"}


def speeds(row: Row) -> List[str]:
    """Millions of pairs a second in software and, at II = 3, in hardware."""
    return [f"{float(row[key]) / 1e6:.1f} M" if row[key] else "-"
            for key in ("software_pairs_per_s", "hardware_pairs_per_s")]


def method_table(rows: List[Row]) -> str:
    """Who errs, and how, and how fast it is."""
    of_method = {f"{option(row['design'], 'arch')} {option(row['design'], 'precision')}".strip():
                 row for row in main_rows(rows)}
    lines = []
    for key, name in METHODS.items():
        row = of_method[key]
        lost, alarms = missed(row), false_alarms(row)
        lines.append([name, share_text(lost), length(row["deepest_missed_lsb"], lost),
                      share_text(alarms), length(row["widest_false_lsb"], alarms),
                      share_text(wilson(int(row["flipped"]), int(row["varied"]))), *speeds(row)])
    return markdown(["proper pairs, W = 18", "missed (95 %)", "deepest, LSB",
                     "false alarms (95 %)", "widest gap, LSB", "flipped (95 %)",
                     "software, pairs/s", "hardware, pairs/s"], lines)


def word_table(rows: List[Row]) -> str:
    """What doubles miss, over W; what the filter settles."""
    proper = {(option(row["design"], "arch"), int(option(row["design"], "word"))): row
              for row in chosen(rows, "word", "proper")}
    lines = []
    for word in sorted({word for _, word in proper}):
        if word < 14:
            continue
        settled = proper["filtered", word]
        share = int(settled["settled"]) / int(settled["pairs"])
        lines.append([str(word), f"{int(settled['collisions']):,}",
                      share_text(missed(proper["float64", word])),
                      share_text(missed(proper["guigue64", word])),
                      f"{100 * share:.2f} %"])
    return markdown(["W", "collisions", "SAT (95 %)", "Guigue and Devillers (95 %)",
                     "settled by the filter"], lines)


def guard_table(rows: List[Row]) -> str:
    """Collisions that paper misses over its guard bits, without and with block floating point."""
    found: Dict[int, Dict[str, Row]] = {}
    for row in chosen(rows, "guard", "any"):
        bits = option(row["design"], "precision")
        number = 0 if bits == "word" else int(bits.split("=")[1])
        found.setdefault(number, {})[option(row["design"], "block-float")] = row
    lines = []
    for number, both in sorted(found.items()):
        if number in (0, 10, 18, 22, 30) or number >= 36:
            cells = [str(number) + (" (`word`)" if number == 0 else "")]
            for row in (both["off"], both["on"]):
                share = missed(row)
                cells += [f"{int(row['missed']):,}", share_text(share, counted=False),
                          length(row["deepest_missed_lsb"], share)]
            lines.append(cells)
    return markdown(["guard bits", "missed", "share (95 %)", "deepest, LSB",
                     "with block floating point", "share (95 %)", "deepest, LSB"], lines)


SHORTCUTS = [("as corrected", "plane", "correct", "1"),
             ("coplanarity as printed (plane offsets)", "paper", "correct", "1"),
             ("inequality as printed", "plane", "printed", "1"),
             ("both as printed", "paper", "printed", "1"),
             ("tolerance 0", "plane", "correct", "0"),
             ("tolerance 16 LSB", "plane", "correct", "16")]


def shortcut_table(rows: List[Row]) -> str:
    """What the shortcuts of the paper cost, at full precision and with 18 bits of each number."""
    keys = ("precision", "coplanarity", "inequality", "epsilon")
    found = {tuple(option(row["design"], key) for key in keys): row
             for study in ("shortcut", "epsilon") for row in chosen(rows, study, "any")}
    lines = []
    for name, *choice in SHORTCUTS:
        cells = [name]
        for precision in ("full", "word"):
            row = found[(precision, *choice)]
            cells += [share_text(missed(row)), share_text(false_alarms(row))]
        lines.append(cells)
    return markdown(["", "missed, full", "false alarms, full", "missed, word",
                     "false alarms, word"], lines)


# Why paper at full precision gives false alarms, by family.
REASONS = {
    "uniform": "normal", "local": "normal", "sliver": "normal", "touch-face": "normal",
    "touch-edge": "normal", "big-tiny": "normal", "shared-vertex": "normal",
    "touch-edges": "tolerance", "shared-edge": "tolerance", "identical": "tolerance",
    "grid": "tolerance", "almost-coplanar": "tolerance, then normal", "tangent": "tolerance",
    "parallel": "tolerance; without it as coplanar",
    "coplanar": "without tolerance: not seen as coplanar", "corners": "normal"}


def family_table(rows: List[Row]) -> str:
    """False alarms of paper at full precision, family by family, with the tolerance of 1 LSB and
    without."""
    found = {(row["family"], option(row["design"], "epsilon")): row for row in rows
             if row["study"] == "epsilon" and row["triangles"] == "proper"
             and option(row["design"], "precision") == "full"}
    lines = []
    for family, reason in REASONS.items():
        row = found[family, "1"]
        cells = [family, f"{int(row['pairs']) - int(row['collisions']):,}"]
        for epsilon in ("1", "0"):
            row = found[family, epsilon]
            alarms = false_alarms(row)
            cells += [share_text(alarms), length(row["widest_false_lsb"], alarms)]
        lines.append([*cells, reason])
    return markdown(["family", "separated", "false (95 %)", "widest gap, LSB",
                     "false, tolerance 0 (95 %)", "widest", "why"], lines)


# Tables of docs/developers/results/accuracy.md by their names.
TABLES: Dict[str, Callable[[List[Row]], str]] = {
    "methods": method_table, "words": word_table, "guards": guard_table,
    "shortcuts": shortcut_table, "families": family_table}
