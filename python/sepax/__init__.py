# SPDX-License-Identifier: MIT
"""sepax: do two bodies collide, where, and how far are they from each other?

Exact verdicts and certain distances of meshes, robots and their paths, by the C library libsepax.

    import sepax
    a = sepax.Body(vertices, faces)          # or sepax.Body.load("part.stl")
    b = sepax.Body.load("tool.stl")
    bool(sepax.collide(a, b, pose))          # pose: (4, 4); for (n, 4, 4) n verdicts in one call
    sepax.distance(a, b, pose).least         # an interval that is certain: least ... most

docs/guides/python.md of the project is the guide."""
from ._errors import (ArgumentError, FileError, FormatError, LimitError, MissingError, SepaxError,
                      UndecidedError, UndecidedWarning)
from ._library import core as _core, features
from ._verdicts import (Basis, Code, Distance, Inside, Nearness, Nearnesses, Verdict, Verdicts)
from .bodies import (Body, Pairs, Shell, Within, collide, distance, meshes_pairs, near, pairs,
                     within)
from .files import nearest_poses, read_mesh, read_poses, weld, write_stl
from .hardware import (Accuracy, Design, Estimate, Port, accuracy, estimate, generate,
                       plot_accuracy, plot_area)
from .manager import CollisionManager, ContactData, DistanceData, scene_to_collision
from .mechanism import Answers, Joint, Mechanism
from .paths import Certificate, PathResult, program
from .plots import plot_clearance
from .triangles import (Grid, TriangleVerdicts, exact, exact_collisions, exact_pairs,
                        triangles_collide, triangles_distance)

__version__: str = _core.about()["version"]

__all__ = [
    "Accuracy", "Answers", "ArgumentError", "Basis", "Body", "Certificate", "Code",
    "CollisionManager", "ContactData", "Design", "Distance", "DistanceData", "Estimate",
    "FileError", "FormatError", "Grid", "Inside", "Joint", "LimitError", "Mechanism",
    "MissingError", "Nearness", "Nearnesses", "Pairs", "PathResult", "Port", "SepaxError", "Shell",
    "TriangleVerdicts", "UndecidedError", "UndecidedWarning", "Verdict", "Verdicts", "Within",
    "accuracy", "collide", "distance", "estimate", "exact", "exact_collisions", "exact_pairs",
    "features", "generate", "meshes_pairs", "near", "nearest_poses", "pairs", "plot_accuracy",
    "plot_area", "plot_clearance", "program", "read_mesh", "read_poses", "scene_to_collision",
    "triangles_collide", "triangles_distance", "weld", "within", "write_stl"]
