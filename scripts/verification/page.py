# SPDX-License-Identifier: MIT
"""page - verify.json as a page of tables in HTML."""
from __future__ import annotations

from typing import Any, List, Optional, Tuple

from campaigns.jq_text import Number, grouped, html, rounded, text
from verification.parts import Object, total

HEAD = """<!DOCTYPE html>
<html lang="en"><head><meta charset="utf-8"><title>sepax: verification</title>
<style>
body { font: 15px/1.5 sans-serif; max-width: 60em; margin: 2em auto; padding: 0 1em }
table { border-collapse: collapse; margin: 1em 0 }
td, th { border: 1px solid #ccc; padding: .2em .6em; text-align: right }
td:first-child, th:first-child { text-align: left }
.wrong { background: #fcc } .none { color: #777 }
</style></head><body>
<h1>Verification</h1>
"""
Row = Tuple[bool, List[Any]]  # is it wrong, its cells


def table(head: List[str], rows: List[Row]) -> str:
    """A table, or that nothing was run; rows that are wrong are marked. A cell without a value is
    "-"."""
    if not rows:
        return '<p class="none">not run</p>'
    lines = []
    for wrong, cells in rows:
        mark = ' class="wrong"' if wrong else ""
        said = ("-" if cell is None or cell is False else cell for cell in cells)
        lines.append(f"<tr{mark}>" + "".join(f"<td>{html(grouped(cell))}</td>" for cell in said)
                     + "</tr>")
    titles = "".join(f"<th>{title}</th>" for title in head)
    return f"<table><tr>{titles}</tr>" + "\n".join(lines) + "</table>"


def percent(share: Optional[Number]) -> str:
    """A share of one with two decimals: 88.89 %."""
    return "-" if share is None else f"{text(rounded(share * 10000) / 100)} %"


def ratio(part: Number, whole: Number) -> Optional[float]:
    """A share of a whole, or None if the whole is 0."""
    return part / whole if whole else None


def rate(count: Number, seconds: Optional[Number]) -> Any:
    """How many a second, or "-" if no time was taken."""
    return rounded(count / seconds) if (seconds or 0) > 0 else "-"


def hours(seconds: Number) -> float:
    """Seconds as hours with two decimals."""
    return rounded(seconds / 36) / 100


def result(proof: Object) -> str:
    """How a proof ended."""
    if not proof["run"]:
        return "not run"
    return "proved" if proof.get("passed") else "FAILED"


def proof_rows(proofs: List[Object]) -> List[Row]:
    return [(proof["run"] and not proof.get("passed"),
             [proof["name"], result(proof), proof.get("seconds"), proof.get("commit"),
              proof.get("said")]) for proof in proofs]


def exhaustive_rows(rows: List[Object]) -> List[Row]:
    return [(row["findings"] > 0,
             [row["what"], row["pairs"], row["of"], "yes" if row["complete"] else "no",
              row["mismatches"], hours(row["cpu"]), rate(row["pairs"], row["cpu"])])
            for row in rows]


def sampled_rows(rows: List[Object]) -> List[Row]:
    return [(row["findings"] > 0,
             [row["what"], row["pairs"], row["passed"], row["jobs"], row["mismatches"],
              hours(row["cpu"]), rate(row["pairs"], row["cpu"])]) for row in rows]


def fuzz_rows(rows: List[Object]) -> List[Row]:
    return [(row["findings"] > 0,
             [row["target"], row["executions"], row["runs"], row["findings"],
              rate(row["executions"], row["seconds"])]) for row in rows]


def mutation_rows(rows: List[Object]) -> List[Row]:
    return [(False, [*(row.get(key) for key in (
        "design", "mutants", "killed", "equivalent", "survivors")), percent(row.get("score")),
        percent((row.get("control") or {}).get("score"))]) for row in rows]


def mutant_rows(rows: List[Object]) -> List[Row]:
    return [(False, [*(row.get(key) for key in ("place", "mutants", "killed", "equivalent")),
                     len(row.get("alive") or []), percent(row.get("score"))]) for row in rows]


def coverage_rows(rows: List[Object]) -> List[Row]:
    return [(False, [row["folder"], row["lines"], row["ran"],
                     percent(ratio(row["ran"], row["lines"])), row["branches"], row["taken"],
                     percent(row["taken"] / max(row["branches"], 1))]) for row in rows]


def part_rows(parts: List[Object]) -> List[Row]:
    return [(False, [part["part"], part["made"] if part["run"] else "not run", part["commit"],
                     part["by"], part["file"]]) for part in parts]


def page(joined: Object) -> str:
    """index.html."""
    tools = "; ".join(html(tool) for tool in joined["tools"])
    fuzz = joined["fuzz"]
    lines = [
        f"""<p>Commit {joined["commit"]}. {tools}. Made by
<code>make experiment NAME=verify</code> of what stands; figures:
<a href="verify.json">verify.json</a>. What is not covered:
docs/developers/verification/README.md.</p>""",
        "<h2>Proved</h2>",
        table(["proof", "result", "seconds", "commit", "said"], proof_rows(joined["proofs"])),
        "<h2>Exhaustive: all pairs with coordinates -1, 0, 1</h2>",
        table(["design", "pairs", "of", "complete", "mismatches", "hours of CPU",
               "pairs a second"], exhaustive_rows(joined["exhaustive"])),
        "<h2>Sampled: seeded hard pairs</h2>",
        table(["what", "pairs", "jobs that passed", "of", "mismatches", "hours of CPU",
               "pairs a second"], sampled_rows(joined["sampled"])),
        "<h2>Fuzzing</h2>",
        table(["target", "executions", "runs", "findings", "a second"], fuzz_rows(fuzz)),
        *([f"<p>{grouped(total(fuzz, 'executions'))} executions in all.</p>"] if fuzz else []),
        "<h2>Mutants of the hardware</h2>",
        table(["design", "mutants", "killed", "equivalent", "survivors", "score",
               "score of decision, queues, control"], mutation_rows(joined["mutation"])),
        "<h2>Mutants of the C code</h2>",
        table(["place", "mutants", "killed", "equivalent", "alive", "score"],
              mutant_rows(joined["mutants"])),
        "<h2>Coverage of the C code</h2>",
        table(["folder", "lines", "ran", "", "branches", "taken", ""],
              coverage_rows(joined["coverage"])),
        "<h2>Parts</h2>",
        table(["part", "made (UTC)", "commit", "by", "file"], part_rows(joined["parts"])),
        "</body></html>"]
    return HEAD + "\n".join(lines) + "\n"
