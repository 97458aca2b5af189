# SPDX-License-Identifier: MIT
"""Exceptions: their texts name what was wrong, and the cure."""
from __future__ import annotations


class SepaxError(Exception):
    """Base of all exceptions of this package but those of Python itself (TypeError, MemoryError,
    KeyboardInterrupt)."""


class ArgumentError(SepaxError, ValueError):
    """An argument is outside its documented range: a shape, an index, a NaN, a pose that is no
    rotation."""


class LimitError(SepaxError, ValueError):
    """The input has more triangles, bits or bytes than a limit allows."""


class FileError(SepaxError, OSError):
    """A file cannot be opened, read or written."""


class FormatError(SepaxError, ValueError):
    """A file breaks the rules of its format, or this build cannot read the format."""


class MissingError(SepaxError, ImportError):
    """A part of sepax or another package is not installed; the text says how to install it."""


class UndecidedError(SepaxError):
    """A verdict that is not decided was used as if it were yes or no."""


class UndecidedWarning(UserWarning):
    """A pair of bodies is neither proved free nor proved to collide."""


# By the number of sepax_code in sepax.h; 4 (cancelled) and 7 (no design) do not happen here.
BY_CODE = (RuntimeError, ArgumentError, MemoryError, LimitError, RuntimeError, FileError,
           FormatError, RuntimeError)
