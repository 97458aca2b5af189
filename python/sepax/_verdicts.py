# SPDX-License-Identifier: MIT
"""Answers: verdicts and intervals, each with what it rests on."""
from __future__ import annotations

import enum
import functools
from dataclasses import dataclass
from typing import Any, Iterator, Optional

import numpy as np

from ._errors import UndecidedError


class Code(enum.IntEnum):
    """The verdict on two bodies in one pose."""
    FREE = 0       # no common point, and neither is inside the other where that was asked
    COLLIDES = 1   # two triangles have a common point (or are as near as asked)
    A_INSIDE = 2   # a part of A is wholly inside B
    B_INSIDE = 3   # a part of B is wholly inside A
    UNDECIDED = 4  # it is not known what is inside, or a limit of work ended the search


class Inside(enum.IntEnum):
    """Is a part of a body wholly inside the other?"""
    UNKNOWN = 0
    OUTSIDE = 1
    INSIDE = 2


@dataclass(frozen=True)
class Basis:
    """What an answer rests on.

    coordinates: "float64" or "float32": the type of the vertices. No coordinate is rounded.
    poses: "none", "as given" (the 12 numbers of each matrix are used as they are), or "rounded"
      (computed from joint values; docs/reference/mechanisms.md has the bound).
    question: "surfaces and insides", "surfaces", or "surfaces that pass through each other".
    grid: length of one step of a grid to which coordinates were rounded, or None.
    distance: bodies count as colliding up to this distance.
    """
    coordinates: str = "float64"
    poses: str = "as given"
    question: str = "surfaces and insides"
    grid: Optional[float] = None
    distance: float = 0.0

    def __str__(self) -> str:
        exact = {"none": "the coordinates given", "as given": "the coordinates and matrices given",
                 "rounded": "the coordinates given and the poses as they are rounded"}[self.poses]
        near = f"; near is a distance of at most {self.distance!r}" if self.distance else \
            "; touching is a collision" if "through" not in self.question else ""
        grid = "" if self.grid is None else f", rounded to a grid of {self.grid!r}"
        return f"exact for {exact} ({self.coordinates}){grid}; {self.question}{near}"


@functools.lru_cache(maxsize=256)
def basis(coordinates: str, poses: str, question: str, distance: float = 0.0) -> Basis:
    """A Basis, each of which is made once."""
    return Basis(coordinates, poses, question, None, distance)


_CURE = ("close the surface (sepax.weld), ask with surfaces=True if insides do not matter, or "
         "raise the limit of work")


class Verdict:
    """The verdict on two bodies in one pose. It is true if they collide.

    code: a Code. basis: what the verdict rests on (Basis)."""
    __slots__ = ("code", "basis")

    def __init__(self, code: int, rests_on: Basis) -> None:
        self.code = Code(code)
        self.basis = rests_on

    @property
    def decided(self) -> bool:
        """Whether it is known if the bodies collide."""
        return self.code != Code.UNDECIDED

    @property
    def collides(self) -> bool:
        """True if the bodies have a common point (or are as near as asked).
        Raises UndecidedError if that is not known."""
        if self.code == Code.UNDECIDED:
            raise UndecidedError(f"it is undecided whether the bodies collide: {_CURE}")
        return self.code != Code.FREE

    @property
    def inside(self) -> bool:
        """True if a part of one body is wholly inside the other, and no surfaces meet."""
        return self.code in (Code.A_INSIDE, Code.B_INSIDE)

    def __bool__(self) -> bool:
        return self.collides

    def __repr__(self) -> str:
        return f"<{self.code.name}; {self.basis}>"


class Verdicts:
    """The verdicts on two bodies in n poses.

    codes: (n,) of uint8, each a Code. basis: what they rest on."""
    __slots__ = ("codes", "basis")

    def __init__(self, codes: np.ndarray, rests_on: Basis) -> None:
        self.codes = codes
        self.basis = rests_on

    @property
    def collides(self) -> np.ndarray:
        """(n,) of bool: proved to collide. An undecided pose is False here and in `free`."""
        collides: np.ndarray = (self.codes != Code.FREE) & (self.codes != Code.UNDECIDED)
        return collides

    @property
    def free(self) -> np.ndarray:
        """(n,) of bool: proved not to collide."""
        free: np.ndarray = self.codes == Code.FREE
        return free

    @property
    def inside(self) -> np.ndarray:
        """(n,) of bool: a part of one body is inside the other, and no surfaces meet."""
        inside: np.ndarray = (self.codes == Code.A_INSIDE) | (self.codes == Code.B_INSIDE)
        return inside

    @property
    def decided(self) -> np.ndarray:
        """(n,) of bool: proved to collide, or not to collide."""
        decided: np.ndarray = self.codes != Code.UNDECIDED
        return decided

    def any(self) -> bool:
        """Whether the bodies collide in any pose. Raises UndecidedError if none is proved to
        collide, but some are undecided."""
        if self.collides.any():
            return True
        if not self.decided.all():
            raise UndecidedError(f"{int((~self.decided).sum())} of {len(self)} poses are "
                                 f"undecided: {_CURE}")
        return False

    def __bool__(self) -> bool:
        raise TypeError("a list of verdicts is neither true nor false; use .any() or .collides")

    def __len__(self) -> int:
        return len(self.codes)

    def __getitem__(self, n: Any) -> Any:
        """The verdict of pose n; or of a slice, a mask or a list of numbers, these Verdicts."""
        codes = self.codes[n]
        return Verdicts(codes, self.basis) if isinstance(codes, np.ndarray) else \
            Verdict(codes, self.basis)

    def __iter__(self) -> Iterator[Verdict]:
        return (self[n] for n in range(len(self)))

    def __repr__(self) -> str:
        return (f"<{len(self)} poses: {int(self.collides.sum())} collide, "
                f"{int(self.free.sum())} free, {int((~self.decided).sum())} undecided; "
                f"{self.basis}>")


class Nearness(Verdict):
    """The verdict on the distance of two bodies in one pose: true if it is at most the distance
    that was asked for.

    least: the distance is at least this, in units of the meshes (seldom close to the distance).
    triangles: (2,) of int64, a triangle of A and one of B that are as near; -1 if none was found.
    """
    __slots__ = ("least", "triangles")

    def __init__(self, code: int, rests_on: Basis, least: float, triangles: np.ndarray) -> None:
        super().__init__(code, rests_on)
        self.least = least
        self.triangles = triangles


class Nearnesses(Verdicts):
    """Verdicts on the distance of two bodies in n poses: `least` (n,), `triangles` (n, 2)."""
    __slots__ = ("least", "triangles")

    def __init__(self, codes: np.ndarray, rests_on: Basis, least: np.ndarray,
                 triangles: np.ndarray) -> None:
        super().__init__(codes, rests_on)
        self.least = least
        self.triangles = triangles

    def __getitem__(self, n: Any) -> Any:
        """The Nearness of pose n; or of a slice, a mask or a list of numbers, these Nearnesses."""
        codes, least, triangles = self.codes[n], self.least[n], self.triangles[n]
        return Nearnesses(codes, self.basis, least, triangles) if isinstance(codes, np.ndarray) \
            else Nearness(codes, self.basis, float(least), triangles)


class Distance:
    """The distance of the surfaces of two bodies: least <= distance <= most, both certain.

    least, most: floats, or (n,) of float64 for n poses. `most` is infinite beyond a limit.
    value: the distance of the two triangles: without tolerances and limits it is the distance of
      the bodies, right to one unit in the last place; 0 if and only if they collide.
    points: (2, 3) or (n, 2, 3): a point of A and one of B that are nearest, in the common
      coordinates. NaN if `most` is infinite.
    triangles: (2,) or (n, 2) of int64: the triangles with these points; -1 if `most` is infinite.
    decided: False if a limit of work or time ended the search. The interval is certain all the
      same, but may be wider than the tolerance.
    basis: what the interval rests on."""
    __slots__ = ("least", "value", "most", "points", "triangles", "decided", "basis")

    def __init__(self, least: Any, value: Any, most: Any, points: np.ndarray,
                 triangles: np.ndarray, decided: Any, rests_on: Basis) -> None:
        self.least = least
        self.value = value
        self.most = most
        self.points = points
        self.triangles = triangles
        self.decided = decided
        self.basis = rests_on

    def __len__(self) -> int:
        return len(self._many())

    def __getitem__(self, n: Any) -> "Distance":
        """The distance in pose n; or of a slice, a mask or a list of numbers, these distances."""
        least = self._many()[n]
        if isinstance(least, np.ndarray):
            return Distance(least, self.value[n], self.most[n], self.points[n],
                            self.triangles[n], self.decided[n], self.basis)
        return Distance(float(least), float(self.value[n]), float(self.most[n]),
                        self.points[n], self.triangles[n], bool(self.decided[n]), self.basis)

    def __iter__(self) -> Iterator["Distance"]:
        return (self[n] for n in range(len(self._many())))

    def _many(self) -> np.ndarray:
        if not isinstance(self.least, np.ndarray):
            raise TypeError("this is the distance in one pose; use .value, .least and .most")
        return self.least

    def __repr__(self) -> str:
        if isinstance(self.least, float):
            return f"<{self.value!r}, in {self.least!r} ... {self.most!r}; {self.basis}>"
        least = float(np.min(self.value)) if len(self.least) else np.inf
        return f"<{len(self.least)} poses, least distance {least!r}; {self.basis}>"

    def __float__(self) -> float:
        if isinstance(self.value, np.ndarray):
            raise TypeError(f"these are the distances in {len(self.value)} poses; use .value")
        return float(self.value)
