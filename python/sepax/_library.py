# SPDX-License-Identifier: MIT
"""The compiled library: that of sepax-io if it is installed, or else the package's own."""
from __future__ import annotations

import importlib
from typing import Any, Dict, Tuple

from ._errors import BY_CODE, MissingError


def _load() -> Tuple[Any, bool]:
    """The extension and whether it is that of sepax-io. Both have the same functions; two of one
    version are never mixed, because handles of one are unknown to the other."""
    own = importlib.import_module("sepax._core")
    try:
        more = importlib.import_module("sepax_io._core")
    except ImportError:
        return own, False
    if more.about()["version"] != own.about()["version"]:
        raise MissingError(
            f"sepax is version {own.about()['version']}, and sepax-io is version "
            f"{more.about()['version']}: pip install --upgrade sepax sepax-io", name="sepax_io")
    return more, True


core, has_io = _load()
core.set_exceptions(*BY_CODE)


def features() -> Dict[str, Any]:
    """What this installation can do.

    Returns a dict: "version" (of the C library), "simd" ("portable", "avx2" or "avx512"),
    "threads" (processors), "formats" (of meshes), "urdf" (bool), "missing" (for each format that
    is not read, how to get it)."""
    about = core.about()
    formats = ["STL", "OBJ", "PLY"]
    missing = {}
    for name, there in (("DAE", about["libxml2"]), ("URDF", about["libxml2"]),
                        ("3MF", about["libxml2"] and about["libzip"])):
        if there:
            formats += [name] if name != "URDF" else []
        else:
            missing[name] = "pip install sepax-io"
    return {"version": about["version"], "simd": about["simd"], "threads": about["threads"],
            "formats": formats, "urdf": bool(about["libxml2"]), "missing": missing}
