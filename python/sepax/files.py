# SPDX-License-Identifier: MIT
"""Files of meshes and poses, and the mending of meshes and poses."""
from __future__ import annotations

import os
import re
from typing import Any, Dict, Optional, Tuple, Union

import numpy as np

from . import _arrays
from ._library import core, has_io
from ._errors import ArgumentError, FormatError

Path = Union[str, "os.PathLike[str]"]


def cure(error: FormatError) -> FormatError:
    """The error, with the cure of a Python user, who has no options of a command."""
    text = re.sub(r"give --package=(\S+):FOLDER", r"give packages={'\1': FOLDER}", str(error))
    text = re.sub(r"give --package$", "give packages={name: folder}", text)
    text = text.replace("give --polygons=fan", "give polygons='fan'")
    if "because lib" in text and not has_io:
        text = text.split("; install")[0] + "; pip install sepax-io"
    return FormatError(text)


def _lengths(unit_mm: Optional[float], result_mm: Optional[float]) -> Tuple[float, float]:
    def length(value: Optional[float], name: str) -> float:
        return 0.0 if value is None else _arrays.number_of(value, name, 1e-300, 1e12)
    return length(unit_mm, "unit_mm"), length(result_mm, "result_mm")


def fans_of(polygons: str) -> bool:
    """Whether polygons that cross themselves are divided, not refused."""
    if polygons not in ("refuse", "fan"):
        raise ArgumentError(f"polygons are {polygons!r}; give 'refuse' or 'fan'")
    return polygons == "fan"


def read_mesh(path: Path, *, unit_mm: Optional[float] = None, result_mm: Optional[float] = None,
              most: Optional[int] = None, polygons: str = "refuse"
              ) -> Tuple[np.ndarray, Dict[str, Any]]:
    """Read a mesh file: STL, OBJ, PLY; with sepax-io also 3MF and DAE.

    unit_mm, result_mm, polygons: as for Body.load. most: a file with more triangles is refused
      (20,000,000).
    Returns the triangles, (n, 3, 3) of float64 in the unit of the file or of the result, and an
    account: a dict of format, unit, unit_mm (0: the file names none), faces, triangles, divided
    (polygons), bent (polygons that are not flat), fans (polygons that cross themselves), unplaced
    (faces that are placed nowhere), others (what has no surface, and how often), remarks (what one
    may not expect of objects: what, how many, which).
    Raises FileError, FormatError (with the line and the cure), LimitError, MemoryError."""
    unit, result = _lengths(unit_mm, result_mm)
    try:
        facets, account = core.mesh_read(path, _arrays.count_of(most, "most"), unit, result,
                                         fans_of(polygons))
    except FormatError as error:
        raise cure(error) from None
    return np.frombuffer(facets, np.float64).reshape(-1, 3, 3), account


def write_stl(path: Path, triangles: Any, *,
              ascii: bool = False) -> None:  # pylint: disable=redefined-builtin
    """Write triangles (n, 3, 3) as STL: binary, rounded to float32, or ASCII with 17 digits, which
    loses nothing. The file appears whole or not at all.
    Raises ArgumentError (no triangles, NaN, a number that does not fit, a triangle that would lose
    its area by rounding) and FileError."""
    core.stl_write(_arrays.triangles_of(triangles), path, bool(ascii))


def weld(triangles: Any, length: float) -> Tuple[np.ndarray, Dict[str, Any]]:
    """Close a mesh whose vertices were rounded or torn apart: vertices within `length` of each
    other become one, and a vertex within `length` of an open edge divides it.

    triangles: (n, 3, 3). length: in their unit, 0 ... a tenth of the longest side of their box.
    Returns the triangles that stay, and a dict of moved (vertices), farthest (length that one
    moved), degenerate and duplicates (triangles left out), divided (edges).
    Raises ArgumentError, LimitError, MemoryError. Cost: about 1 us for each triangle."""
    facets, account = core.weld(_arrays.triangles_of(triangles),
                                _arrays.number_of(length, "length", 0.0, 2.0**1000))
    return np.frombuffer(facets, np.float64).reshape(-1, 3, 3), account


def read_poses(path: Path, *, nearest: bool = False) -> np.ndarray:
    """Read poses from a text file: 12 numbers a line, the rotation by rows, then the translation.

    nearest: replace each matrix by the nearest rotation (nearest_poses).
    Returns (n, 4, 4) of float64. Raises FileError and FormatError, which names the bad line."""
    numbers, _ = core.poses_read(path, bool(nearest))
    rows = np.frombuffer(numbers, np.float64).reshape(-1, 12)
    matrices = np.zeros((len(rows), 4, 4))
    matrices[:, :3, :3] = rows[:, :9].reshape(-1, 3, 3)
    matrices[:, :3, 3] = rows[:, 9:]
    matrices[:, 3, 3] = 1
    return matrices


def nearest_poses(poses: Any) -> np.ndarray:
    """The poses with each matrix replaced by the nearest rotation, up to rounding: for matrices
    that were printed with few decimals or computed in float32.

    poses: (4, 4) or (n, 4, 4). Returns a new array of the same shape.
    Raises ArgumentError if a number is not finite, a matrix is a reflection, or an entry would
    change by more than 0.01."""
    matrices, count = _arrays.poses_of(poses, "poses")
    if matrices is None:
        raise ArgumentError("poses are None; give (4, 4) or (n, 4, 4)")
    matrices = matrices.copy()
    if count != 0:
        core.poses_nearest(matrices)
    return matrices
