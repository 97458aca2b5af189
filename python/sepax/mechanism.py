# SPDX-License-Identifier: MIT
"""Mechanisms: links and joints with bodies on the links, from a URDF or from Python."""
from __future__ import annotations

import math
import os
import warnings
from typing import Any, Dict, List, Mapping, NamedTuple, Optional, Sequence, Tuple, Union

import numpy as np

from . import _arrays
from ._errors import ArgumentError, FormatError
from ._library import core
from ._verdicts import Basis, Code, Verdict, Verdicts, basis
from .bodies import Body, LENGTH_MOST, _handle, _shell
from .files import Path, cure, fans_of

KINDS = ("fixed", "revolute", "continuous", "prismatic")
VALUE_MOST = 1e12


class Joint(NamedTuple):
    """A joint between two links.

    kind: "fixed", "revolute" (value in radians), "continuous" (revolute without limits) or
      "prismatic" (value in units of length).
    parent, child: names of links; the joint moves the child.
    origin: (4, 4), the child's pose in the parent's coordinates at the value 0; None: no offset.
    axis: (3,), any length but 0. lower, upper: limits of the value.
    mimic: name of a joint that this one follows: its value is factor * (value of that) + offset."""
    name: str
    kind: str
    parent: str
    child: str
    origin: Any = None
    axis: Any = (0.0, 0.0, 1.0)
    lower: float = -math.inf
    upper: float = math.inf
    mimic: Optional[str] = None
    factor: float = 1.0
    offset: float = 0.0


class Answers(Verdicts):
    """The verdicts on a mechanism for n rows of joint values.

    codes: (n,) of uint8, each a Code; COLLIDES means as near as the clearance that was asked for.
    least, most: (n,), the interval of the least clearance of each row if it was measured, or else
      None; 0 where a body is inside another. In the unit of length of the mechanism.
    pair: (n,) of int64, the number of the pair that is near, inside or undecided; -1: none.
    nearest: (n,) of int64, the number of the pair with the least clearance; None if not measured.
    triangles: (n, 2) of int64, two triangles that are near; -1 without.
    pairs: the names of the links of each pair."""
    __slots__ = ("least", "most", "pair", "nearest", "triangles", "pairs")

    def __init__(self, codes: np.ndarray, rests_on: Basis, pair: np.ndarray,
                 triangles: np.ndarray, pairs: Sequence[Tuple[str, str]],
                 measured: Optional[Tuple[np.ndarray, np.ndarray, np.ndarray]]) -> None:
        super().__init__(codes, rests_on)
        self.pair, self.triangles, self.pairs = pair, triangles, list(pairs)
        self.least: Optional[np.ndarray] = measured[0] if measured else None
        self.most: Optional[np.ndarray] = measured[1] if measured else None
        self.nearest: Optional[np.ndarray] = measured[2] if measured else None

    def __getitem__(self, n: Any) -> Any:
        """The Verdict of row n; or of a slice, a mask or a list of numbers, these Answers."""
        codes = self.codes[n]
        if not isinstance(codes, np.ndarray):
            return Verdict(codes, self.basis)
        measured = None if self.least is None or self.most is None or self.nearest is None else (
            self.least[n], self.most[n], self.nearest[n])
        return Answers(codes, self.basis, self.pair[n], self.triangles[n], self.pairs, measured)

    def names(self, n: int) -> Optional[Tuple[str, str]]:
        """The links of the pair that decides row n: near, inside or undecided; None if free."""
        return self.pairs[self.pair[n]] if self.pair[n] >= 0 else None


def _packages(packages: Any) -> List[Tuple[str, str]]:
    if packages is None:
        return []
    if not isinstance(packages, Mapping):
        raise TypeError("packages are no dict; give {name: folder}")
    return [(str(name), os.fspath(folder)) for name, folder in packages.items()]


class Mechanism:
    """A tree of links, held together by joints, with bodies on links and the pairs of bodies that
    are compared. It never changes; threads share it.

    links: names. joints: a list of Joint. bodies: {name of a link: Body, in its coordinates}.
    pairs: a list of (link, link) to compare; None: all bodies but those of links that one joint or
    fixed joints alone hold together. surfaces: True does not look whether a body is inside another.
    Raises ArgumentError (two roots, a cycle, a name that is not there, ...), TypeError."""

    def __init__(self, links: Sequence[str], joints: Sequence[Joint], *,
                 bodies: Optional[Mapping[str, Body]] = None,
                 pairs: Optional[Sequence[Tuple[str, str]]] = None,
                 surfaces: bool = False) -> None:
        names = [_name(name, "a link") for name in links]
        handle = core.mechanism_new(names, _rows_of(names, joints))
        on_links = {} if bodies is None else dict(bodies)
        for link, body in on_links.items():
            _number(names, link, "link")
            _handle(body, f"the body of {link}")
        self._begin(handle)
        solids = {link: (body,) for link, body in on_links.items()}
        self._complete(on_links, solids, self._default_pairs(list(on_links)) if pairs is None
                       else pairs, surfaces)

    @classmethod
    def from_urdf(cls, urdf: Path, srdf: Optional[Path] = None, *,
                  packages: Optional[Mapping[str, Any]] = None, unit: Optional[float] = None,
                  surfaces: bool = False, polygons: str = "refuse") -> "Mechanism":
        """Read a robot: links, joints and collision geometry, with its mesh files.

        srdf: disables pairs. With it all pairs are compared but those that it disables; without
          it, all but neighbours at one joint and links that fixed joints alone hold together.
          An SRDF that names another robot is used, with a UserWarning.
        packages: {name: folder} of package://name/.
        unit: length in metres of the unit of mesh files; None: as they say, STL, OBJ and PLY in
          metres. surfaces: True does not look whether a body is inside another.
        polygons: of mesh files, as for Body.load.
        Lengths are metres, angles radians. Spheres, cylinders and capsules become polyhedra that
        hold them, at most 0.25 % of the radius larger. It needs sepax-io.
        Raises FormatError (line and cure; or that sepax-io is missing), FileError, ArgumentError.
        """
        if isinstance(urdf, str) and urdf.lstrip().startswith("<"):
            raise ArgumentError("urdf is the text of a robot; write it into a file, and give the "
                                "file's name")
        try:
            handle = core.robot_read(_packages(packages), urdf)
        except FormatError as error:
            raise cure(error) from None
        mechanism = cls.__new__(cls)
        mechanism._begin(handle)
        name, count, shapes, bare, others = core.robot_about(handle)
        found, joined, rigid, disabled, srdf_others, meant = core.robot_pairs(handle, srdf)
        if meant is not None and name is not None and meant != name:
            warnings.warn(f"{srdf} is for a robot '{meant}'; {urdf} is '{name}'", stacklevel=2)
        scale = 0.0 if unit is None else _arrays.number_of(unit, "unit", 1e-9, 1e9)
        bodies, solids = _bodies_of(handle, mechanism.links, shapes, scale, fans_of(polygons))
        numbers = np.frombuffer(found, np.uintp).reshape(-1, 2)
        pairs = [(mechanism.links[a], mechanism.links[b]) for a, b in numbers]
        mechanism._complete(bodies, solids, pairs, surfaces)
        mechanism._files = (os.path.abspath(urdf), None if srdf is None else os.path.abspath(srdf),
                            [(name, os.path.abspath(folder)) for name, folder in
                             _packages(packages)], unit, polygons)
        mechanism.name = name
        mechanism.account = {"shapes": len(shapes), "without_surface": [
            mechanism.links[link] for link, _ in bare], "passed_over": others,
            "passed_over_srdf": srdf_others, "pairs_of_one_joint": joined,
            "pairs_without_joint": rigid, "pairs_disabled": disabled,
            "links_of_file": count}
        return mechanism

    # ------------------------------------------------------------------- making

    def _begin(self, handle: Any) -> None:
        self._handle = handle
        self._machine = None
        self._files: Optional[Tuple[str, Optional[str], List[Tuple[str, str]],
                                    Optional[float], str]] = None
        self.name: Optional[str] = None
        self.account: Dict[str, Any] = {}
        links, rows, root = core.mechanism_about(handle)
        self.links: List[str] = links
        self.root: str = links[root]
        self.joints: List[Joint] = []
        self._driven: List[int] = []
        for n, row in enumerate(rows):
            name, kind, parent, child, axis, lower, upper, mimic, factor, offset, driven = row
            self.joints.append(Joint(name, KINDS[kind], links[parent], links[child], None, axis,
                                     lower, upper, rows[mimic][0] if mimic >= 0 else None, factor,
                                     offset))
            self._driven += [n] if driven else []

    def _complete(self, bodies: Mapping[str, Body], solids: Mapping[str, Tuple[Body, ...]],
                  pairs: Sequence[Tuple[str, str]], surfaces: bool) -> None:
        self.bodies: Dict[str, Body] = dict(bodies)
        self.surfaces = bool(surfaces)
        order = list(self.bodies)
        self.pairs: List[Tuple[str, str]] = [(str(a), str(b)) for a, b in pairs]
        if not self.pairs:
            return
        numbers = np.array([[_number(order, a, "body on link"), _number(order, b, "body on link")]
                            for a, b in self.pairs], np.uintp)
        parts = tuple((self.links.index(link), _handle(self.bodies[link], link),
                       None if surfaces else tuple(_shell(s) for s in solids[link]))
                      for link in order)
        self._machine = core.machine_new(self._handle, parts, numbers)

    def _default_pairs(self, order: List[str]) -> List[Tuple[str, str]]:
        """All pairs of bodies but those of one joint, or between which all joints are fixed."""
        rigid = {link: link for link in self.links}
        parent = {j.child: j for j in self.joints}

        def base(link: str) -> str:
            while link in parent and parent[link].kind == "fixed":
                link = parent[link].parent
            return link

        rigid = {link: base(link) for link in self.links}
        joined = {frozenset((j.parent, j.child)) for j in self.joints}
        return [(a, b) for n, a in enumerate(order) for b in order[n + 1:]
                if rigid[a] != rigid[b] and frozenset((a, b)) not in joined]

    # ------------------------------------------------------------------- values

    @property
    def driven(self) -> List[str]:
        """The names of the joints that have a value of their own, in the order of columns."""
        return [self.joints[n].name for n in self._driven]

    def _rows(self, values: Any) -> Tuple[np.ndarray, bool]:
        """(n, joints) of float64, contiguous, and whether it is one row alone."""
        if isinstance(values, Mapping):
            return self._rows_of_dict(values)
        array = _arrays.numbers(values, "values", "fiu").astype(np.float64, copy=False)
        alone = array.ndim == 1
        array = array[None] if alone else array
        if array.ndim != 2 or array.shape[1] != len(self._driven):
            raise ArgumentError(f"values have the shape {array.shape}; give (n, "
                                f"{len(self._driven)}), a column for each of "
                                f"{', '.join(self.driven) or 'no joint'}")
        return self._check(self._spread(array)), alone

    def _rows_of_dict(self, values: Mapping[str, Any]) -> Tuple[np.ndarray, bool]:
        unknown = [str(name) for name in values if name not in self.driven]
        if unknown:
            raise ArgumentError(f"no joint {unknown[0]} is driven; the names are "
                                f"{', '.join(self.driven)}")
        missing = [name for name in self.driven if name not in values]
        if missing:
            raise ArgumentError(f"joint {missing[0]} has no value; give one for each of "
                                f"{', '.join(self.driven)}")
        columns = [_arrays.numbers(values[name], f"joint {name}", "fiu") for name in self.driven]
        try:
            columns = list(np.broadcast_arrays(*columns)) if columns else []
        except ValueError:
            raise ArgumentError("joints have different numbers of values") from None
        alone = not columns or columns[0].ndim == 0
        array = np.stack([np.atleast_1d(c) for c in columns], axis=-1) if columns else \
            np.empty((1, 0))
        if array.ndim != 2:
            raise ArgumentError("a joint has values of more than one dimension; give (n,)")
        return self._check(self._spread(array)), alone

    def _spread(self, array: np.ndarray) -> np.ndarray:
        rows = np.zeros((array.shape[0], len(self.joints)))
        rows[:, self._driven] = array
        return rows

    def _check(self, rows: np.ndarray) -> np.ndarray:
        bad = ~(np.abs(rows) <= VALUE_MOST)
        if bad.any():
            row, joint = np.argwhere(bad)[0]
            raise ArgumentError(f"row {row}: joint {self.joints[joint].name} is "
                                f"{rows[row, joint]}; give -1e12 ... 1e12")
        return rows

    def outside_limits(self, values: Any) -> np.ndarray:
        """(n,) of bool: a value is beyond the limits of its joint. Verdicts do not look at limits.
        values: as for `check`."""
        rows, _ = self._rows(values)
        low = np.array([j.lower for j in self.joints])
        high = np.array([j.upper for j in self.joints])
        outside: np.ndarray = ((rows < low) | (rows > high))[:, self._driven]
        return np.asarray(outside.any(axis=1))

    def poses(self, values: Any, *, threads: Optional[int] = None) -> Dict[str, np.ndarray]:
        """The pose of each link in the coordinates of the root, {name: (n, 4, 4)}, or (4, 4) for
        one row. The rounding is bounded: docs/reference/mechanisms.md. values: as for `check`."""
        rows, alone = self._rows(values)
        out = np.empty((len(rows), len(self.links), 4, 4))
        core.mechanism_poses(self._handle, rows, len(rows), _arrays.threads_of(threads), out)
        return {name: out[0, n] if alone else out[:, n] for n, name in enumerate(self.links)}

    # ---------------------------------------------------------------- questions

    def check(self, values: Any, *, clearance: float = 0.0, travel: Any = None,
              measure: bool = False, relative: float = 0.0, absolute: float = 0.0,
              work: Optional[int] = None, threads: Optional[int] = None) -> Answers:
        """Do any two bodies of a pair collide, or come as near as `clearance`, for each row?

        values: (n, j), a row of values of the driven joints (`driven` names the columns) in
          radians and units of length; (j,) for one row; or {name of a joint: (n,) values}.
        clearance: 0 ... 2**1000, in the unit of length: two bodies are near up to this distance.
        travel: (j,), how far each joint may be from its value, independently of the others; or
          {name: travel}. FREE then holds for all these positions. None: the values alone.
        measure: also find the least clearance, `least` ... `most`, of each row, to a tolerance of
          `relative` or `absolute`.
        work: units of about 0.1 us for each row; what is not decided then is UNDECIDED.
        threads: at most so many; None: one for each processor. Python's lock is released.

        Only the rows are looked at, not the motion between them: that is `certify`. Verdicts are
        exact for the poses as they are rounded. Returns Answers. Raises ArgumentError, TypeError.
        """
        if self._machine is None and self._files is not None:
            raise ArgumentError(f"{self._files[0]} leaves no pair to compare: {len(self.bodies)} "
                                "links have <collision>; give it to two links that move against "
                                "each other (<visual> is not looked at)")
        if not self.bodies and self._files:
            raise ArgumentError("no link of the URDF has a <collision> element, so there are no "
                                "bodies; a <visual> is none")
        if self._machine is None:
            raise ArgumentError("no pairs of bodies are compared; give bodies to two links that "
                                "move against each other, or pairs")
        rows, _ = self._rows(values)
        limit = _arrays.number_of(clearance, "clearance", 0.0, LENGTH_MOST)
        count = len(rows)
        codes = np.empty(count, np.uint8)
        pair, nearest = np.empty(count, np.int64), np.empty(count, np.int64)
        triangles, interval = np.empty((count, 2), np.int64), np.empty((count, 2))
        core.machine_ask(self._machine, rows, count, _arrays.threads_of(threads),
                         self._travel(travel), limit, _arrays.count_of(work, "work"),
                         bool(measure), _arrays.number_of(relative, "relative", 0.0, 1 - 2.0**-53),
                         _arrays.number_of(absolute, "absolute", 0.0, LENGTH_MOST), codes, pair,
                         triangles, interval, nearest)
        inside = (codes == Code.A_INSIDE) | (codes == Code.B_INSIDE)
        interval[inside] = 0
        nearest[inside] = pair[inside]
        rests = basis("float64", "rounded", "surfaces" if self.surfaces else
                      "surfaces and insides", limit)
        measured = (interval[:, 0], interval[:, 1], nearest) if measure else None
        return Answers(codes, rests, pair, triangles, self.pairs, measured)

    def _travel(self, travel: Any) -> Optional[np.ndarray]:
        if travel is None:
            return None
        rows, alone = self._rows(travel)
        if not alone:
            raise ArgumentError("travel is one number for each driven joint")
        if (rows < 0).any():
            raise ArgumentError("a travel is negative; give 0 or more")
        first: np.ndarray = rows[0]
        return first

    def certify(self, values: Any, **options: Any) -> Any:
        """Check the rows and the motion between them: see sepax.paths.certify. The mechanism must
        come from a URDF."""
        from .paths import certify  # pylint: disable=import-outside-toplevel,cyclic-import
        return certify(self, values, **options)

    def page(self, values: Any, file: Optional[Path] = None, **options: Any) -> Any:
        """An HTML page that shows the bodies and plays the rows: see sepax.paths.page."""
        from .paths import page  # pylint: disable=import-outside-toplevel,cyclic-import
        return page(self, values, file, **options)

    def __copy__(self) -> "Mechanism":
        return self

    def __deepcopy__(self, _: Any) -> "Mechanism":
        return self

    def __reduce__(self) -> Any:
        raise TypeError("a Mechanism is not pickled; read its URDF in each process, or use "
                        "threads, which share it")

    def __repr__(self) -> str:
        name = f" {self.name}" if self.name else ""
        return (f"<Mechanism{name}: {len(self.links)} links, {len(self._driven)} "
                f"driven joints, {len(self.bodies)} bodies, {len(self.pairs)} pairs>")


def _name(name: Any, what: str) -> str:
    if not isinstance(name, str) or not name or "\0" in name:
        raise TypeError(f"{what} is named {name!r}; give a name")
    return name


def _number(names: Sequence[str], name: Any, what: str) -> int:
    try:
        return list(names).index(name)
    except ValueError:
        raise ArgumentError(f"there is no {what} {name!r}; the names are "
                            f"{', '.join(map(str, names))}") from None


def _rows_of(links: Sequence[str], joints: Sequence[Joint]) -> List[Tuple[Any, ...]]:
    rows = []
    names = [_name(j.name, "a joint") if isinstance(j, Joint) else None for j in joints]
    if len(set(names)) != len(names) or len(set(links)) != len(links):
        raise ArgumentError("two links or two joints have one name")
    for j in joints:
        if not isinstance(j, Joint):
            raise TypeError(f"a joint is of type {type(j).__name__}; give sepax.Joint")
        if j.kind not in KINDS:
            raise ArgumentError(f"joint {j.name} is of kind {j.kind!r}; give {', '.join(KINDS)}")
        origin, count = _arrays.poses_of(np.eye(4) if j.origin is None else j.origin, "origin")
        axis = _arrays.numbers(j.axis, "axis", "fiu")
        if count is not None or axis.shape != (3,):
            raise ArgumentError(f"joint {j.name}: give an origin of (4, 4) and an axis of (3,)")
        numbers = [_arrays.number_of(x, f"joint {j.name}", -math.inf, math.inf)
                   for x in (j.lower, j.upper, j.factor, j.offset)]
        rows.append((j.name, KINDS.index(j.kind), _number(links, j.parent, "link"),
                     _number(links, j.child, "link"), origin, tuple(map(float, axis)), numbers[0],
                     numbers[1], -1 if j.mimic is None else _number(names, j.mimic, "joint"),
                     numbers[2], numbers[3]))
    return rows


def _bodies_of(handle: Any, links: List[str], shapes: List[Tuple[Any, ...]], scale: float,
               fans: bool) -> Tuple[Dict[str, Body], Dict[str, Tuple[Body, ...]]]:
    """The body of each link, of all its shapes, and each of its shapes as a solid."""
    triangles: Dict[str, List[bytearray]] = {}
    for n, shape in enumerate(shapes):
        try:
            facets = core.robot_shape(handle, n, scale, fans)
        except FormatError as error:
            raise cure(error) from None
        triangles.setdefault(links[shape[0]], []).append(facets)
    bodies, solids = {}, {}
    for link, parts in triangles.items():
        whole = bytearray().join(parts)
        once = core.distinct(whole)
        bodies[link] = Body(np.frombuffer(once, np.float64).reshape(-1, 3))
        solids[link] = (bodies[link],) if len(parts) == 1 and len(once) == len(whole) else tuple(
            Body(np.frombuffer(part, np.float64).reshape(-1, 3)) for part in parts)
    return bodies, solids
