# SPDX-License-Identifier: MIT
"""Bodies: meshes with a search tree, and questions about two of them in one pose or many."""
from __future__ import annotations

import math
import os
import threading
from typing import Any, Dict, NamedTuple, Optional, Tuple, Union

import numpy as np

from . import _arrays
from ._errors import ArgumentError
from ._library import core
from ._verdicts import (Basis, Distance, Inside, Nearness, Nearnesses, Verdict, Verdicts, basis)

LENGTH_MOST = 2.0**1000
_THROUGH = "surfaces that pass through each other"
_SURFACES = "surfaces"
_SOLIDS = "surfaces and insides"


class Shell(NamedTuple):
    """The surface of a body.

    closed: the body is a solid: nearly every point of its edges is on an even number of triangles.
    consistent: no triangle is turned round.
    triangle: if one of the two is False, a triangle with an edge that breaks the rule; else None.
    edge: (2, 3), the ends of that edge; else None.
    parts: surfaces that hang together by edges. pieces: parts that touch are one piece."""
    closed: bool
    consistent: bool
    triangle: Optional[int]
    edge: Optional[np.ndarray]
    parts: int
    pieces: int


class Body:
    """A mesh with a search tree, which makes questions fast. It never changes; threads share it.

    vertices: (n, 3) numbers in any unit of length, finite and at most 2**1000. Arrays of float64
      and float32 are read where they are; other types are converted. Or an object with the
      attributes `vertices` and `faces`, such as a trimesh.Trimesh.
    faces: (m, 3) whole numbers, indices of vertices. Without faces, three rows of `vertices`
      after each other are a triangle, or `vertices` has the shape (m, 3, 3).
    threads: number of threads at most that build the tree; None: one for each processor.

    The body copies the mesh; it takes 230 to 310 bytes for each triangle. Nothing is rounded.
    Raises ArgumentError (a shape, an index beyond the vertices, NaN, no triangles), TypeError,
    LimitError (more than 2**31 - 2 triangles), MemoryError."""
    __slots__ = ("_handle", "_shell", "_lock", "_box", "coordinates", "account", "__weakref__")

    def __init__(self, vertices: Any, faces: Any = None, *, threads: Optional[int] = None) -> None:
        if faces is None and hasattr(vertices, "vertices") and hasattr(vertices, "faces"):
            vertices, faces = vertices.vertices, vertices.faces
        if faces is None:
            array = _arrays.numbers(vertices, "vertices", "fiu")
            if array.ndim == 3 and array.shape[1:] == (3, 3):
                vertices = array.reshape(-1, 3)
        points = _arrays.vertices_of(vertices)
        index = None if faces is None else _arrays.faces_of(faces, len(points))
        if index is None and len(points) % 3:
            raise ArgumentError(f"{len(points)} vertices without faces are no whole number of "
                                "triangles; give faces")
        self._handle = core.body_new(points, index, _arrays.threads_of(threads))
        self._shell = None
        self._lock = threading.Lock()
        self._box = _box_of(points, index)
        self.coordinates: str = str(points.dtype)
        self.account: Optional[Dict[str, Any]] = None

    @classmethod
    def load(cls, path: Union[str, "os.PathLike[str]"], *, unit_mm: Optional[float] = None,
             result_mm: Optional[float] = None, threads: Optional[int] = None,
             polygons: str = "refuse") -> "Body":
        """Read the body from a mesh file: STL, OBJ, PLY; with sepax-io also 3MF and DAE.

        unit_mm: length in mm of the file's unit, in place of what the file says.
        result_mm: length in mm of the body's unit: coordinates are multiplied by unit / result and
          rounded. None, or a file without a unit: coordinates stay as they are.
        polygons: a polygon that crosses itself: "refuse" the file, or divide it as a "fan" from
          its first corner, as many programs do.
        `account` of the body tells what the file has: format, unit, faces, and what was passed
        over. Raises FileError, FormatError (with the line and the cure), LimitError, MemoryError.
        """
        from .files import read_mesh  # pylint: disable=import-outside-toplevel,cyclic-import
        triangles, account = read_mesh(path, unit_mm=unit_mm, result_mm=result_mm,
                                       polygons=polygons)
        body = cls(triangles.reshape(-1, 3), threads=threads)
        body.account = account
        return body

    @classmethod
    def from_trimesh(cls, mesh: Any, *, threads: Optional[int] = None) -> "Body":
        """The body of a trimesh.Trimesh: its `vertices` and `faces` as they are. Trimesh merges
        vertices when it loads a file, which may move none; transforms of a scene do not count."""
        if not hasattr(mesh, "vertices") or not hasattr(mesh, "faces"):
            raise TypeError(f"{type(mesh).__name__} has no vertices and faces; of a trimesh.Scene "
                            "give scene.to_mesh(), or each of its geometries")
        return cls(mesh.vertices, mesh.faces, threads=threads)

    @property
    def box(self) -> np.ndarray:
        """(2, 3) of float64: the least and the greatest coordinates."""
        return self._box.copy()

    def shell(self) -> Shell:
        """Is the surface closed, and which parts has it? Exact; found once, in about 0.3 us for
        each triangle."""
        closed, consistent, facet, start, end, parts, pieces = core.shell_about(_shell(self))
        broken = not (closed and consistent)
        return Shell(closed, consistent, facet if broken else None,
                     np.array([start, end]) if broken else None, parts, pieces)

    @property
    def closed(self) -> bool:
        """Whether the body is a solid, so that others may be inside."""
        return self.shell().closed

    def __len__(self) -> int:
        """Number of triangles."""
        count: int = core.body_triangles(self._handle)
        return count

    def __repr__(self) -> str:
        return f"<Body of {len(self)} triangles, {self.coordinates}>"

    def __copy__(self) -> "Body":
        return self

    def __deepcopy__(self, _: Any) -> "Body":
        return self

    def __reduce__(self) -> Any:
        raise TypeError("a Body is not pickled; make it anew from its mesh in each process, or use "
                        "threads, which share it")


def _box_of(points: np.ndarray, index: Optional[np.ndarray]) -> np.ndarray:
    """The box of the vertices that triangles use; checked by the library before."""
    if index is not None:
        used = np.zeros(len(points), bool)
        used[index] = True
        points = points if used.all() else points[used]
    return np.array([points.min(axis=0), points.max(axis=0)], dtype=np.float64)


def _shell(body: Body) -> Any:
    """The handle of the shell, made at the first question about insides."""
    with body._lock:  # pylint: disable=protected-access
        if body._shell is None:  # pylint: disable=protected-access
            body._shell = core.shell_new(body._handle)  # pylint: disable=protected-access
        return body._shell  # pylint: disable=protected-access


def _handle(body: Any, name: str) -> Any:
    if not isinstance(body, Body):
        raise TypeError(f"{name} is of type {type(body).__name__}; give a sepax.Body")
    return body._handle  # pylint: disable=protected-access


def _rests_on(a: Body, b: Body, posed: bool, question: str, distance: float = 0.0) -> Basis:
    coordinates = a.coordinates if a.coordinates == b.coordinates else "float64 and float32"
    return basis(coordinates, "as given" if posed else "none", question, distance)


def _asked(a: Body, b: Body, surfaces: bool) -> Tuple[Any, Any, Any, Any]:
    """Handles of both bodies, and of their shells unless only surfaces are compared."""
    handle_a, handle_b = _handle(a, "a"), _handle(b, "b")
    if surfaces:
        return handle_a, handle_b, None, None
    return handle_a, handle_b, _shell(a), _shell(b)


def collide(a: Body, b: Body, pose_a: Any = None, pose_b: Any = None, *, surfaces: bool = False,
            strict: bool = False, threads: Optional[int] = None) -> Union[Verdict, Verdicts]:
    """Do two bodies collide, each in its pose? Exact for the doubles given; touching counts.

    pose_a, pose_b: a (4, 4) matrix, or n of them (n, 4, 4), or None for a body that stays. Its
      last column is the translation. The entries are used as they are; each matrix must be a
      rotation within 1e-6 (sepax.nearest_poses mends one that was printed with few decimals).
    surfaces: True compares surfaces alone, so a body that is wholly inside another one is free.
    strict: only surfaces that pass through each other count, not those that touch; insides are
      not looked at.
    threads: number of threads at most for n poses; None: one for each processor. Python's lock is
      released.

    Returns a Verdict, or Verdicts for n poses. Raises ArgumentError, with the number of the bad
    pose, and TypeError. Cost: 1 to 20 us for a pose of most bodies."""
    matrix_a, matrix_b, count, alone = _arrays.both_poses(pose_a, pose_b)
    handles = _asked(a, b, surfaces or strict)
    codes = np.empty(count, np.uint8)
    core.collide(*handles, matrix_a, matrix_b, count, _arrays.threads_of(threads), codes,
                 bool(strict))
    posed = matrix_a is not None or matrix_b is not None
    rests = _rests_on(a, b, posed, _THROUGH if strict else _SURFACES if surfaces else _SOLIDS)
    return Verdict(codes[0], rests) if alone else Verdicts(codes, rests)


def near(a: Body, b: Body, distance: float, pose_a: Any = None, pose_b: Any = None, *,
         surfaces: bool = False, work: Optional[int] = None,
         threads: Optional[int] = None) -> Union[Nearness, Nearnesses]:
    """Is the distance of two bodies at most `distance`? Exact for the doubles given, and faster
    than to measure it.

    distance: 0 ... 2**1000, in the unit of the meshes.
    work: end each search after so many units of about 0.1 us; what is not decided then is
      UNDECIDED. None: no limit.
    The other arguments are those of `collide`. A body inside another is near, unless `surfaces`.

    Returns a Nearness, or Nearnesses for n poses. Raises ArgumentError, TypeError."""
    limit = _arrays.number_of(distance, "distance", 0.0, LENGTH_MOST)
    matrix_a, matrix_b, count, alone = _arrays.both_poses(pose_a, pose_b)
    handles = _asked(a, b, surfaces)
    codes = np.empty(count, np.uint8)
    least = np.empty(count)
    pairs = np.empty((count, 2), np.int64)
    core.near(*handles, matrix_a, matrix_b, count, _arrays.threads_of(threads), codes, least, pairs,
              limit, _arrays.count_of(work, "work"))
    posed = matrix_a is not None or matrix_b is not None
    rests = _rests_on(a, b, posed, _SURFACES if surfaces else _SOLIDS, limit)
    if alone:
        return Nearness(codes[0], rests, float(least[0]), pairs[0])
    return Nearnesses(codes, rests, least, pairs)


def distance(a: Body, b: Body, pose_a: Any = None, pose_b: Any = None, *, relative: float = 0.0,
             absolute: float = 0.0, limit: Optional[float] = None, work: Optional[int] = None,
             seconds: Optional[float] = None, threads: Optional[int] = None) -> Distance:
    """The distance of the surfaces of two bodies, as an interval that is certain to hold it.

    relative, absolute: the search ends when most - least is at most relative * most, or at most
      `absolute`; 0 <= relative < 1. If both are 0, then the interval is that of one rounding.
      1e-6 saves time where many triangles are nearly equally far.
    limit: a longer distance is reported as infinite, which is faster. None: no limit.
    work, seconds: end each search after so many units (of about 0.1 us) or seconds; the interval
      is certain then, too.
    The other arguments are those of `collide`. The distance of a body that is inside another one
    is that of the surfaces, not 0.

    Returns a Distance; for n poses its fields are arrays. Raises ArgumentError, TypeError."""
    narrow = _arrays.number_of(relative, "relative", 0.0, math.nextafter(1.0, 0.0))
    width = _arrays.number_of(absolute, "absolute", 0.0, LENGTH_MOST)
    most = 0.0 if limit is None else _arrays.number_of(limit, "limit", 2.0**-1074, LENGTH_MOST)
    time = 0.0 if seconds is None else _arrays.number_of(seconds, "seconds", 1e-9, 1e9)
    matrix_a, matrix_b, count, alone = _arrays.both_poses(pose_a, pose_b)
    handle_a, handle_b = _handle(a, "a"), _handle(b, "b")
    codes = np.empty(count, np.uint8)
    interval = np.empty((count, 3))
    points = np.empty((count, 2, 3))
    pairs = np.empty((count, 2), np.int64)
    core.distance(handle_a, handle_b, None, None, matrix_a, matrix_b, count,
                  _arrays.threads_of(threads), codes, interval, points, pairs, most, narrow, width,
                  _arrays.count_of(work, "work"), time)
    points[pairs[:, 0] < 0] = np.nan
    posed = matrix_a is not None or matrix_b is not None
    rests = _rests_on(a, b, posed, _SURFACES)
    if alone:
        least, value, upper = interval[0].tolist()
        return Distance(least, value, upper, points[0], pairs[0], bool(codes[0] == 0), rests)
    return Distance(interval[:, 0], interval[:, 1], interval[:, 2], points, pairs, codes == 0,
                    rests)


class Within(NamedTuple):
    """a_in_b, b_in_a: an Inside each, or (n,) of uint8 for n poses."""
    a_in_b: Any
    b_in_a: Any


def within(a: Body, b: Body, pose_a: Any = None, pose_b: Any = None, *,
           threads: Optional[int] = None) -> Within:
    """Is a part of one body wholly inside the other? Exact; ask it only of bodies whose surfaces
    do not meet (`collide` asks both). UNKNOWN where it may be inside a surface that is open.

    Arguments are those of `collide`. Raises ArgumentError, TypeError. Cost: a few us for each part
    of a body that lies within the box of the other."""
    matrix_a, matrix_b, count, alone = _arrays.both_poses(pose_a, pose_b)
    handles = _asked(a, b, False)
    codes = np.empty((count, 2), np.uint8)
    core.within(*handles, matrix_a, matrix_b, count, _arrays.threads_of(threads), codes)
    if alone:
        return Within(Inside(codes[0, 0]), Inside(codes[0, 1]))
    return Within(codes[:, 0], codes[:, 1])


class Pairs(NamedTuple):
    """triangles: (n, 2) of int64, a triangle of A and one of B in each row.
    complete: False if a limit ended the search, so there may be more."""
    triangles: np.ndarray
    complete: bool


def pairs(a: Body, b: Body, pose_a: Any = None, pose_b: Any = None, *, distance: float = 0.0,
          most: Optional[int] = None, strict: bool = False,
          seconds: Optional[float] = None) -> Pairs:
    """The pairs of triangles that collide, or whose distance is at most `distance`, in one pose.

    most, seconds: end after so many pairs or seconds. strict: only pairs that pass through each
    other (with a distance: that are nearer). Each pose is None or (4, 4).
    Returns Pairs. Raises ArgumentError, TypeError, MemoryError."""
    limit = _arrays.number_of(distance, "distance", 0.0, LENGTH_MOST)
    time = 0.0 if seconds is None else _arrays.number_of(seconds, "seconds", 1e-9, 1e9)
    matrix_a, matrix_b, _, alone = _arrays.both_poses(pose_a, pose_b)
    if not alone:
        raise ArgumentError("pairs are listed for one pose at a time; give (4, 4)")
    found, ended = core.bodies_pairs(_handle(a, "a"), _handle(b, "b"), matrix_a, matrix_b, limit,
                                     _arrays.count_of(most, "most"), bool(strict), time)
    return Pairs(np.frombuffer(found, np.uintp).astype(np.int64).reshape(-1, 2), not ended)


def meshes_pairs(a: Any, b: Any, pose_a: Any = None, pose_b: Any = None, *, first: bool = False,
                 threads: Optional[int] = None) -> np.ndarray:
    """The colliding pairs of two meshes that are asked once: no tree is built, so it is faster
    than to make two bodies. Exact, and sorted by the triangle of A.

    a, b: each (vertices, faces), or a mesh with these attributes. first: one pair at most.
    Returns (n, 2) of int64. Raises ArgumentError, TypeError, LimitError, MemoryError."""
    matrix_a, matrix_b, _, alone = _arrays.both_poses(pose_a, pose_b)
    if not alone:
        raise ArgumentError("pairs are listed for one pose at a time; give (4, 4)")
    found, _ = core.meshes_pairs(*mesh_of(a, "a"), matrix_a, *mesh_of(b, "b"), matrix_b,
                                 bool(first), _arrays.threads_of(threads))
    return np.frombuffer(found, np.uintp).astype(np.int64).reshape(-1, 2)


def mesh_of(mesh: Any, name: str) -> Tuple[np.ndarray, Optional[np.ndarray]]:
    """Vertices and faces of (vertices, faces), or of an object with these attributes."""
    if hasattr(mesh, "vertices") and hasattr(mesh, "faces"):
        mesh = (mesh.vertices, mesh.faces)
    if not isinstance(mesh, tuple) or len(mesh) != 2:
        raise TypeError(f"{name} is of type {type(mesh).__name__}; give (vertices, faces)")
    points = _arrays.vertices_of(mesh[0])
    index = None if mesh[1] is None else _arrays.faces_of(mesh[1], len(points))
    if index is None and len(points) % 3:
        raise ArgumentError(f"{len(points)} vertices without faces are no whole number of "
                            "triangles; give faces")
    return points, index
