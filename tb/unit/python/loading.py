# SPDX-License-Identifier: MIT
"""loading - load a script of the project, which has no ending .py, as a module for a test."""
from __future__ import annotations

import importlib.machinery
import importlib.util
import sys
from pathlib import Path
from types import ModuleType

PROJECT = Path(__file__).resolve().parents[3]

sys.dont_write_bytecode = True  # no __pycache__ beside the scripts


def load(path: str) -> ModuleType:
    """The script at a path below the project's folder. A module beside it can be imported, as it
    can where the script runs by itself."""
    file = PROJECT / path
    if str(file.parent) not in sys.path:
        sys.path.insert(0, str(file.parent))
    loader = importlib.machinery.SourceFileLoader("script_" + path.replace("/", "_"), str(file))
    spec = importlib.util.spec_from_loader(loader.name, loader)
    assert spec is not None
    module = importlib.util.module_from_spec(spec)
    sys.modules[loader.name] = module  # dataclasses look their module up
    loader.exec_module(module)
    return module
