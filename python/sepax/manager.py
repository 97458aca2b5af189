# SPDX-License-Identifier: MIT
"""CollisionManager: many bodies by name, with the interface of trimesh.collision.

In place of trimesh's:  import sepax; trimesh.collision.CollisionManager = sepax.CollisionManager"""
from __future__ import annotations

import warnings
import weakref
from typing import Any, Dict, FrozenSet, Iterable, Iterator, List, NamedTuple, Optional, Set, Tuple

import numpy as np

from . import _arrays
from ._errors import ArgumentError, UndecidedWarning
from ._library import core
from ._verdicts import Code, Verdict
from .bodies import Body, collide, distance, pairs

EXTERNAL = "__external"
IDENTITY = np.eye(4)
DEPTH = ("sepax does not compute a penetration depth: the triangles and a common point are exact, "
         "a depth would be an estimate; FCL (trimesh.collision) has one")


class ContactData:
    """Two triangles that have a common point.

    names: the names of the two objects (a set). Each point has the world's coordinates."""

    def __init__(self, names: Tuple[Any, Any], triangles: Any, corners: Any) -> None:
        self.names = set(names)
        self._indices = {names[0]: int(triangles[0]), names[1]: int(triangles[1])}
        self._corners = corners
        self._point: Optional[np.ndarray] = None

    def index(self, name: Any) -> int:
        """The number of the face of this object's mesh."""
        return self._indices[name]

    @property
    def point(self) -> np.ndarray:
        """(3,): a point that both triangles have. Each coordinate is wrong by at most 2**-51 of
        the largest."""
        if self._point is None:
            a, b, pose_a, pose_b = self._corners
            lengths, points = np.empty(1), np.empty((1, 2, 3))
            core.triangle_pairs(a, b, pose_a, pose_b, 1, None, lengths, points)
            self._point = np.asarray(points[0, 0])
        return self._point

    @property
    def normal(self) -> np.ndarray:
        """(3,): the unit normal of the second object's triangle, or of the first's if the second
        has no area; zero if neither has."""
        for corners, pose in ((self._corners[1], self._corners[3]),
                              (self._corners[0], self._corners[2])):
            points = corners[0] @ pose[:3, :3].T
            normal = np.cross(points[1] - points[0], points[2] - points[0])
            length = np.linalg.norm(normal)
            if length > 0:
                return np.asarray(normal / length)
        return np.zeros(3)

    @property
    def depth(self) -> float:
        """Not computed: raises NotImplementedError."""
        raise NotImplementedError(DEPTH)


class DistanceData:
    """The distance of two objects: 0 if they collide or one is inside the other.

    names: the names of the two objects (a set). least, most: the interval that holds it."""

    def __init__(self, names: Tuple[Any, Any], found: "_Found") -> None:
        self.names = set(names)
        self.least, self.most = found.least, found.most
        self._value = found.value
        self._indices = {names[0]: int(found.triangles[0]), names[1]: int(found.triangles[1])}
        self._points = {names[0]: found.points[0], names[1]: found.points[1]}

    @property
    def distance(self) -> float:
        """The distance, right to one unit in the last place."""
        return self._value

    def index(self, name: Any) -> int:
        """The number of the nearest face of this object's mesh."""
        return self._indices[name]

    def point(self, name: Any) -> np.ndarray:
        """(3,): the nearest point of this object's surface, in the world's coordinates."""
        return np.asarray(self._points[name])


class _Found(NamedTuple):
    least: float
    value: float
    most: float
    points: np.ndarray
    triangles: np.ndarray


class _Object:
    """A body in its pose, with a box that holds it in the world's coordinates."""
    __slots__ = ("name", "body", "pose", "low", "high", "corners")

    def __init__(self, name: Any, body: Body, corners: Any, pose: Any) -> None:
        self.name, self.body, self.corners = name, body, corners
        self.place(pose)

    def place(self, pose: Any) -> None:
        """Take another pose."""
        matrix, count = _arrays.poses_of(pose if pose is not None else IDENTITY, "transform")
        if count is not None or matrix is None:
            raise ArgumentError("transform has several poses; give (4, 4)")
        core.poses_check(matrix)
        self.pose = matrix.copy()
        box = self.body._box  # pylint: disable=protected-access
        middle, half = (box[0] + box[1]) / 2, (box[1] - box[0]) / 2
        # Sums of three products round by less than 1e-15 of their terms; 1e-12 holds them all.
        turn, shift = np.abs(matrix[:3, :3]), np.abs(matrix[:3, 3])
        spare = 1e-12 * (turn @ (np.abs(middle) + half) + shift)
        centre = matrix[:3, :3] @ middle + matrix[:3, 3]
        self.low, self.high = centre - turn @ half - spare, centre + turn @ half + spare


Couple = Tuple[_Object, _Object]


class CollisionManager:
    """Bodies by name, each in its pose: which of them collide, and how near are they?

    The methods are those of trimesh.collision.CollisionManager, with these differences:
      - Verdicts are exact, and touching is a collision.
      - An object that is wholly inside another one collides with it (unless surfaces=True). If its
        surface or the other's is open, that is not decided: `undecided` names the pairs, and an
        UndecidedWarning tells so.
      - set_pair_ignored(a, b) leaves a pair out.
      - Distances are never negative, and contacts have no depth: sepax does not estimate how deep.

    mesh: a trimesh.Trimesh, another object with `vertices` and `faces`, or a sepax.Body. Build a
    Body once for meshes that are asked often. surfaces: True compares surfaces alone."""

    def __init__(self, *, surfaces: bool = False) -> None:
        self.surfaces = bool(surfaces)
        self.undecided: List[Tuple[Any, Any]] = []  # of the last question
        self._objs: Dict[Any, _Object] = {}
        self._ignored: Set[FrozenSet[Any]] = set()
        self._made: Dict[int, Tuple[Any, int, Body, Any]] = {}

    def __copy__(self) -> "CollisionManager":
        """Another manager of the same bodies: to move an object of one moves none of the other."""
        other = type(self)(surfaces=self.surfaces)
        other.undecided = list(self.undecided)
        other._objs = {name: _Object(name, o.body, o.corners, o.pose)
                       for name, o in self._objs.items()}
        other._ignored = set(self._ignored)
        return other

    def __deepcopy__(self, _: Any) -> "CollisionManager":
        return self.__copy__()

    def __repr__(self) -> str:
        return (f"<CollisionManager of {len(self._objs)} objects, "
                f"{len(self._ignored)} pairs ignored>")

    # ------------------------------------------------------------------ objects

    def add_object(self, name: Any, mesh: Any, transform: Any = None) -> Body:
        """Add an object, in place of one with this name. transform: (4, 4), or None.
        Returns its Body. Raises ArgumentError, TypeError."""
        body, corners = self._body_of(mesh)
        self._objs[name] = _Object(name, body, corners, transform)
        return body

    def remove_object(self, name: Any) -> None:
        """Remove the object. Raises ArgumentError (a ValueError) if there is none."""
        self._find(name)
        del self._objs[name]

    def set_transform(self, name: Any, transform: Any) -> None:
        """Move the object to this (4, 4) pose. Raises ArgumentError if there is none."""
        self._find(name).place(transform)

    def _find(self, name: Any) -> _Object:
        try:
            return self._objs[name]
        except KeyError:
            raise ArgumentError(f"{name} not in collision manager!") from None

    def _body_of(self, mesh: Any) -> Tuple[Body, Any]:
        """The body of a mesh, made once for each mesh as long as it does not change."""
        if isinstance(mesh, Body):
            return mesh, None
        if not hasattr(mesh, "vertices") or not hasattr(mesh, "faces"):
            raise TypeError(f"{type(mesh).__name__} is no mesh; give vertices and faces, or a Body")
        by_identity: Any = object.__hash__
        mark = hash(mesh) if type(mesh).__hash__ is not by_identity else None
        made = self._made.get(id(mesh))
        if made is not None and mark is not None and made[0]() is mesh and made[1] == mark:
            return made[2], made[3]
        body = Body(mesh.vertices, mesh.faces)
        corners = (np.array(mesh.vertices, np.float64), np.array(mesh.faces, np.int64))
        if mark is not None:
            try:
                number, known = id(mesh), self._made
                forget = weakref.ref(mesh, lambda _: known.pop(number, None))
                known[number] = (forget, mark, body, corners)
            except TypeError:
                pass
        return body, corners

    # -------------------------------------------------------------- pairs left out

    def set_pair_ignored(self, name_a: Any, name_b: Any, ignored: bool = True) -> None:
        """Leave the pair out of all questions about this manager's own objects (or, with
        ignored=False, in again). The names need not be there yet."""
        if name_a == name_b:
            raise ArgumentError(f"{name_a} and {name_b} are one object; give two names")
        (self._ignored.add if ignored else self._ignored.discard)(frozenset((name_a, name_b)))

    def is_pair_ignored(self, name_a: Any, name_b: Any) -> bool:
        """Whether the pair is left out."""
        return frozenset((name_a, name_b)) in self._ignored

    @property
    def ignored_pairs(self) -> Set[Tuple[Any, Any]]:
        """The pairs that are left out, each sorted by name."""
        return {_sorted(tuple(pair)) for pair in self._ignored}

    def clear_ignored_pairs(self) -> None:
        """Leave no pair out."""
        self._ignored.clear()

    # ---------------------------------------------------------------- collisions

    def in_collision_single(self, mesh: Any, transform: Any = None, return_names: bool = False,
                            return_data: bool = False) -> Any:
        """Does an object collide with any of the manager?

        Returns bool; with return_names also the set of names; with return_data also the list of
        ContactData, one for each pair of triangles. Raises ArgumentError, TypeError."""
        one = _Object(EXTERNAL, *self._body_of(mesh), transform)
        couples = _couples_of([one], list(self._objs.values()))
        return self._collisions(((b, a) for a, b in couples), return_names, return_data,
                                lambda a, b: a.name)

    def in_collision_internal(self, return_names: bool = False, return_data: bool = False) -> Any:
        """Do any two objects of the manager collide, but those of pairs that are left out?

        Returns bool; with return_names also the set of sorted pairs of names; with return_data
        also the list of ContactData."""
        return self._collisions(self._own_couples(), return_names, return_data,
                                lambda a, b: _sorted((a.name, b.name)))

    def in_collision_other(self, other_manager: "CollisionManager", return_names: bool = False,
                           return_data: bool = False) -> Any:
        """Does any object of this manager collide with any of the other one?

        Returns as in_collision_internal does; each pair has this manager's name first."""
        couples = _couples_of(list(self._objs.values()), _objects(other_manager))
        return self._collisions(couples, return_names, return_data, lambda a, b: (a.name, b.name))

    def _own_couples(self, name: Any = None) -> Iterator[Couple]:
        objects = list(self._objs.values())
        couples = _couples_within(objects) if name is None else _couples_of(
            [self._find(name)], [o for o in objects if o.name != name])
        return (c for c in couples if not self.is_pair_ignored(c[0].name, c[1].name))

    def _collisions(self, couples: Iterable[Couple], return_names: bool, return_data: bool,
                    naming: Any) -> Any:
        names: Set[Any] = set()
        contacts: List[ContactData] = []
        hit = False
        self.undecided = []
        for a, b in couples:
            code = _code_of(a, b, self.surfaces)
            if code == Code.UNDECIDED:
                self.undecided.append((a.name, b.name))
            elif code != Code.FREE:
                hit = True
                if not return_names and not return_data:
                    break
                names.add(naming(a, b))
                if return_data and code == Code.COLLIDES:
                    contacts += _contacts_of(a, b)
        self._warn()
        parts = (hit,) + ((names,) if return_names else ()) + ((contacts,) if return_data else ())
        return parts if len(parts) > 1 else hit

    def _warn(self) -> None:
        if self.undecided:
            a, b = self.undecided[0]
            warnings.warn(f"{a} may be inside {b} or the reverse, in {len(self.undecided)} pairs "
                          "(.undecided names them), because a surface is open: close it "
                          "(sepax.weld), or compare surfaces alone by "
                          "CollisionManager(surfaces=True)", UndecidedWarning, stacklevel=4)

    # ----------------------------------------------------------------- distances

    def min_distance_single(self, mesh: Any, transform: Any = None, return_name: bool = False,
                            return_data: bool = False) -> Any:
        """The least distance of an object from those of the manager.

        Returns a float (0 for a collision, infinity without objects); with return_name also the
        name; with return_data also DistanceData (None without objects)."""
        one = _Object(EXTERNAL, *self._body_of(mesh), transform)
        couples = [(o, one) for o in self._objs.values()]
        return self._least(couples, return_name, return_data, lambda a, b: a.name)

    def min_distance_internal(self, name: Any = None, return_names: bool = False,
                              return_data: bool = False) -> Any:
        """The least distance of any two objects of the manager, or of the object `name` from the
        others, without the pairs that are left out. Returns as min_distance_single does; names
        are a sorted pair."""
        objects = list(self._objs.values())
        if name is None:
            couples = [(a, b) for n, a in enumerate(objects) for b in objects[n + 1:]]
        else:
            couples = [(self._find(name), b) for b in objects if b.name != name]
        couples = [c for c in couples if not self.is_pair_ignored(c[0].name, c[1].name)]
        return self._least(couples, return_names, return_data,
                           lambda a, b: _sorted((a.name, b.name)))

    def min_distance_other(self, other_manager: "CollisionManager", return_names: bool = False,
                           return_data: bool = False) -> Any:
        """The least distance of an object of this manager from one of the other. Returns as
        min_distance_single does; names are (this manager's, the other's)."""
        couples = [(a, b) for a in self._objs.values() for b in _objects(other_manager)]
        return self._least(couples, return_names, return_data, lambda a, b: (a.name, b.name))

    def _least(self, couples: List[Couple], return_names: bool, return_data: bool,
               naming: Any) -> Any:
        best, found = None, None
        self.undecided = []
        for bound, n in _by_gap(couples):
            if found is not None and bound > found.value:
                break
            a, b = couples[n]
            now = self._distance_of(a, b, found.value if found is not None else None)
            if now is not None and (found is None or now.value < found.value):
                best, found = (a, b), now
                if now.value == 0:
                    break
        self._warn()
        names = naming(*best) if best else None
        data = DistanceData((best[0].name, best[1].name), found) if best and found else None
        length = found.value if found is not None else float("inf")
        parts = (length,) + ((names,) if return_names else ()) + ((data,) if return_data else ())
        return parts if len(parts) > 1 else length

    def _distance_of(self, a: _Object, b: _Object, limit: Optional[float]) -> Optional[_Found]:
        """The distance of two objects if it is at most the limit; 0 if one is inside the other."""
        inside = False
        if not self.surfaces and (a.low <= b.high).all() and (b.low <= a.high).all():
            code = _code_of(a, b, False)
            inside = code in (Code.A_INSIDE, Code.B_INSIDE)
            if code == Code.UNDECIDED:
                self.undecided.append((a.name, b.name))
        d = distance(a.body, b.body, a.pose, b.pose,
                     limit=limit if limit and not inside else None)
        if inside:
            return _Found(0.0, 0.0, 0.0, d.points, d.triangles)
        if not np.isfinite(d.value):
            return None
        return _Found(d.least, d.value, d.most, d.points, d.triangles)


def scene_to_collision(scene: Any, *, surfaces: bool = False
                       ) -> Tuple[CollisionManager, Dict[Any, Body]]:
    """A CollisionManager of a trimesh.Scene, and its bodies by the name of their node."""
    manager = CollisionManager(surfaces=surfaces)
    bodies = {}
    for node in scene.graph.nodes_geometry:
        pose, geometry = scene.graph[node]
        bodies[node] = manager.add_object(node, scene.geometry[geometry], pose)
    return manager, bodies


def _code_of(a: _Object, b: _Object, surfaces: bool) -> Code:
    """The verdict on two objects."""
    verdict = collide(a.body, b.body, a.pose, b.pose, surfaces=surfaces)
    assert isinstance(verdict, Verdict)
    return verdict.code


def _objects(manager: Any) -> List[_Object]:
    if not isinstance(manager, CollisionManager):
        raise TypeError(f"the other manager is of type {type(manager).__name__}; give a "
                        "sepax.CollisionManager")
    return list(manager._objs.values())  # pylint: disable=protected-access


def _sorted(names: Tuple[Any, ...]) -> Tuple[Any, ...]:
    try:
        return tuple(sorted(names))
    except TypeError:
        return tuple(sorted(names, key=str))


def _boxes(objects: List[_Object]) -> Tuple[np.ndarray, np.ndarray]:
    return np.array([o.low for o in objects]), np.array([o.high for o in objects])


def _couples_of(first: List[_Object], second: List[_Object]) -> Iterator[Couple]:
    """Couples whose boxes meet, one of each list."""
    if not first or not second:
        return
    low, high = _boxes(second)
    for a in first:
        for n in np.nonzero(((low <= a.high) & (a.low <= high)).all(axis=1))[0]:
            yield a, second[n]


def _couples_within(objects: List[_Object]) -> Iterator[Couple]:
    """Couples of one list whose boxes meet: sorted along x, each is compared with those that begin
    before it ends."""
    if len(objects) < 2:
        return
    low, high = _boxes(objects)
    order = np.argsort(low[:, 0], kind="stable")
    low, high = low[order], high[order]
    ends = np.searchsorted(low[:, 0], high[:, 0], side="right")
    for n, end in enumerate(ends):
        others = slice(n + 1, end)
        meet = ((low[others] <= high[n]) & (low[n] <= high[others])).all(axis=1)
        for k in np.nonzero(meet)[0]:
            a, b = sorted((order[n], order[n + 1 + k]))
            yield objects[a], objects[b]


def _by_gap(couples: List[Couple]) -> List[Tuple[float, int]]:
    """The numbers of the couples with a lower bound on the distance of each, the least first."""
    if not couples:
        return []
    low_a, high_a = _boxes([a for a, _ in couples])
    low_b, high_b = _boxes([b for _, b in couples])
    apart = np.maximum(np.maximum(low_a - high_b, low_b - high_a), 0)
    bound = np.sqrt((apart**2).sum(axis=1)) * (1 - 1e-12)
    return [(float(bound[n]), int(n)) for n in np.argsort(bound, kind="stable")]


def _contacts_of(a: _Object, b: _Object) -> List[ContactData]:
    found = pairs(a.body, b.body, a.pose, b.pose).triangles
    return [ContactData((a.name, b.name), row, _Corners(a, b, row)) for row in found]


class _Corners:
    """The corners and poses of two triangles, looked up when they are asked for."""
    __slots__ = ("_a", "_b", "_row")

    def __init__(self, a: _Object, b: _Object, row: np.ndarray) -> None:
        self._a, self._b, self._row = (a.corners, a.pose), (b.corners, b.pose), row

    def __iter__(self) -> Iterator[np.ndarray]:
        for (corners, _), n in ((self._a, self._row[0]), (self._b, self._row[1])):
            yield self._of(corners, n)
        yield self._a[1]
        yield self._b[1]

    def __getitem__(self, n: int) -> np.ndarray:
        return list(self)[n]

    @staticmethod
    def _of(corners: Any, n: int) -> np.ndarray:
        if corners is None:
            raise ArgumentError("a contact of a sepax.Body has no points, because a Body does not "
                                "give its mesh back; add the mesh in place of the Body")
        return np.ascontiguousarray(corners[0][corners[1][n]])[None]
