# SPDX-License-Identifier: MIT
"""Single triangles: of doubles in poses, and of integers as the hardware has them."""
from __future__ import annotations

from typing import Any, NamedTuple, Optional, Tuple

import numpy as np

from . import _arrays
from ._errors import ArgumentError
from ._library import core
from .bodies import mesh_of


class TriangleVerdicts(NamedTuple):
    """collision: touching counts. strict: the triangles pass through each other. coplanar: all six
    vertices are in one plane. axis: the number of the first axis that separates, 10, 11 (normals),
    1 ... 9 (edges), 12 (in the common plane), or 0. Each (n,), exact, and always decided."""
    collision: np.ndarray
    strict: np.ndarray
    coplanar: np.ndarray
    axis: np.ndarray


def _verdicts(rows: np.ndarray) -> TriangleVerdicts:
    return TriangleVerdicts(rows[:, 0] != 0, rows[:, 1] != 0, rows[:, 2] != 0, rows[:, 3])


def _two(a: Any, b: Any) -> Tuple[np.ndarray, np.ndarray]:
    first, second = _arrays.triangles_of(a, "a"), _arrays.triangles_of(b, "b")
    if len(first) != len(second):
        raise ArgumentError(f"a has {len(first)} triangles and b has {len(second)}; give as many")
    return first, second


def triangles_collide(a: Any, b: Any, pose_a: Any = None, pose_b: Any = None, *,
                      threads: Optional[int] = None) -> TriangleVerdicts:
    """Judge pairs of triangles: a[n] in its pose against b[n] in its. Exact for the doubles given.

    a, b: (3, 3) or (n, 3, 3) finite numbers. Poses: (4, 4) for all, (n, 4, 4), or None.
    Returns TriangleVerdicts. Raises ArgumentError, TypeError."""
    first, second = _two(a, b)
    matrix_a, matrix_b = _poses(pose_a, pose_b, len(first))
    rows = np.empty((len(first), 4), np.uint8)
    core.triangle_pairs(first, second, matrix_a, matrix_b, _arrays.threads_of(threads), rows, None,
                        None)
    return _verdicts(rows)


def triangles_distance(a: Any, b: Any, pose_a: Any = None, pose_b: Any = None, *,
                       threads: Optional[int] = None) -> Tuple[np.ndarray, np.ndarray]:
    """Distances of pairs of triangles, each right to one unit in the last place; 0 if and only if
    they collide. Returns (n,) distances and (n, 2, 3) nearest points. Arguments are those of
    triangles_collide; coordinates are at most 2**1000."""
    first, second = _two(a, b)
    for array, name in ((first, "a"), (second, "b")):
        if array.size and np.abs(array).max() > 2.0**1000:
            raise ArgumentError(f"{name} has a coordinate beyond 2**1000; scale the mesh")
    matrix_a, matrix_b = _poses(pose_a, pose_b, len(first))
    lengths, points = np.empty(len(first)), np.empty((len(first), 2, 3))
    core.triangle_pairs(first, second, matrix_a, matrix_b, _arrays.threads_of(threads), None,
                        lengths, points)
    return lengths, points


def _poses(pose_a: Any, pose_b: Any,
           count: int) -> Tuple[Optional[np.ndarray], Optional[np.ndarray]]:
    matrix_a, matrix_b, n, alone = _arrays.both_poses(pose_a, pose_b)
    if not alone and n != count:
        raise ArgumentError(f"{n} poses for {count} pairs of triangles; give as many, or one")
    return matrix_a, matrix_b


class Grid(NamedTuple):
    """A grid: the coordinate x becomes the integer round((x - offset) / resolution).

    resolution: units of the mesh for one step. offset: the point that becomes 0. word: bits of a
    coordinate, 4 ... 32."""
    resolution: float
    offset: Tuple[float, float, float]
    word: int

    @classmethod
    def fit(cls, a: Any, b: Any = None, *, word: int = 18) -> "Grid":
        """The finest grid of `word` bits that holds the meshes, each (vertices, faces) or an
        object with these attributes. Raises ArgumentError, TypeError."""
        meshes = mesh_of(a, "a") + (() if b is None else mesh_of(b, "b"))
        return cls(*core.grid_fit(_word(word), *meshes))

    def quantise(self, mesh: Any) -> np.ndarray:
        """The triangles of a mesh on the grid, (n, 3, 3) of int32. Each coordinate is rounded
        once, to the nearest integer. Raises ArgumentError if one does not fit `word` bits."""
        points, index = mesh_of(mesh, "mesh")
        out = np.empty((len(index) if index is not None else len(points) // 3, 3, 3), np.int32)
        core.grid_quantise(points, index, float(self.resolution), tuple(map(float, self.offset)),
                           _word(self.word), out)
        return out


def _word(word: Any) -> int:
    return _arrays.count_of(word, "word", 2**31 - 1) or 18


def _integers(value: Any, name: str) -> np.ndarray:
    array = _arrays.numbers(value, name, "iu")
    if array.ndim == 2:
        array = array[None]
    if array.ndim != 3 or array.shape[1:] != (3, 3):
        raise ArgumentError(f"{name} has the shape {array.shape}; give (n, 3, 3)")
    if array.dtype != np.int32 and array.size and (
            int(array.min()) < -2**31 or int(array.max()) >= 2**31):
        raise ArgumentError(f"{name} has a coordinate that does not fit 32 bits; use Grid.quantise")
    return np.require(array, np.int32, ("C", "A"))


def exact(a: Any, b: Any, *, threads: Optional[int] = None) -> TriangleVerdicts:
    """Judge pairs of integer triangles: the golden model of the hardware, right for every int32.
    a, b: (n, 3, 3) whole numbers. Returns TriangleVerdicts. Raises ArgumentError, TypeError."""
    first, second = _integers(a, "a"), _integers(b, "b")
    if len(first) != len(second):
        raise ArgumentError(f"a has {len(first)} triangles and b has {len(second)}; give as many")
    rows = np.empty((len(first), 4), np.uint8)
    core.grid_exact(first, second, _arrays.threads_of(threads), rows)
    return _verdicts(rows)


def exact_collisions(a: Any, b: Any) -> np.ndarray:
    """Like exact(a, b).collision, by vector instructions: (n,) of bool. Fastest for coordinates of
    up to 20 bits."""
    first, second = _integers(a, "a"), _integers(b, "b")
    if len(first) != len(second):
        raise ArgumentError(f"a has {len(first)} triangles and b has {len(second)}; give as many")
    count = len(first)
    columns = [np.ascontiguousarray(t.reshape(count, 9).T) for t in (first, second)]
    bits = np.zeros((count + 63) // 64, np.uint64)
    core.grid_exact_bits(*columns, count, bits)
    numbers = np.arange(count)
    found: np.ndarray = bits[numbers // 64] >> (numbers % 64).astype(np.uint64) & np.uint64(1)
    return np.asarray(found != 0)


def exact_pairs(a: Any, b: Any, *, threads: Optional[int] = None) -> np.ndarray:
    """All colliding pairs of two integer meshes, (n, 2) of int64, sorted. a, b: (n, 3, 3) and
    (m, 3, 3) whole numbers. Raises ArgumentError, TypeError, LimitError, MemoryError."""
    found = core.grid_colliding(_integers(a, "a"), _integers(b, "b"), _arrays.threads_of(threads))
    return np.frombuffer(found, np.uintp).astype(np.int64).reshape(-1, 2)
