# SPDX-License-Identifier: MIT
"""Plots, for what one would rather look at. They need matplotlib."""
from __future__ import annotations

from typing import Any, List, Tuple

import numpy as np

from ._errors import ArgumentError
from ._verdicts import Code
from .mechanism import Answers

SHADES = {Code.COLLIDES: "#d33", Code.A_INSIDE: "#d33", Code.B_INSIDE: "#d33",
          Code.UNDECIDED: "#93c"}


def plot_clearance(axes: Any, answers: Answers, times: Any = None, *, unit: str = "m") -> None:
    """Draw the least clearance of each row. Rows that collide are shaded red, undecided rows
    violet.

    axes: of matplotlib. answers: of Mechanism.check with measure=True. times: (n,) seconds; None:
    the number of each row. unit: the unit of length of the mechanism.
    Raises ArgumentError if nothing was measured or `times` has another shape."""
    if answers.least is None or answers.most is None:
        raise ArgumentError("nothing was measured; give measure=True to Mechanism.check")
    x = np.arange(len(answers)) if times is None else np.asarray(times, float)
    if x.shape != (len(answers),):
        raise ArgumentError(f"times have the shape {x.shape}; give ({len(answers)},)")
    upper = np.where(np.isfinite(answers.most), answers.most, answers.least)
    axes.fill_between(x, answers.least, upper, color="#9bd", linewidth=0)
    axes.plot(x, upper, color="#147", linewidth=1.2)
    for begin, end in _runs(answers.codes):
        shade = SHADES.get(Code(answers.codes[begin]))
        if shade:
            axes.axvspan(x[begin], x[end], color=shade, alpha=0.25, linewidth=0)
    axes.set_xlabel("row" if times is None else "time, s")
    axes.set_ylabel(f"least clearance, {unit}")
    axes.set_ylim(bottom=0)
    if len(x) > 1:
        axes.set_xlim(x.min(), x.max())


def _runs(codes: np.ndarray) -> List[Tuple[int, int]]:
    """The first and the last row of each run of equal codes."""
    change = np.nonzero(np.diff(codes))[0] + 1
    edges = [0, *change.tolist(), len(codes)]
    return [(a, b - 1) for a, b in zip(edges, edges[1:]) if b > a]
