# SPDX-License-Identifier: MIT
"""Arrays of the caller, brought into the form that the library reads in place.

An array of the right type and order is used where it is. Any other is copied once."""
from __future__ import annotations

from typing import Any, Optional, Tuple

import numpy as np

from ._errors import ArgumentError, LimitError

INDEX_MOST = 2**32 - 1


def numbers(value: Any, name: str, kinds: str = "fiub") -> np.ndarray:
    """The value as an array of numbers."""
    if isinstance(value, np.ma.MaskedArray) and np.ma.is_masked(value):
        raise ArgumentError(f"{name} has masked entries; fill them in")
    try:
        array = np.asarray(value)
    except (ValueError, TypeError) as error:
        raise ArgumentError(f"{name} is not an array of numbers: {error}") from None
    if array.dtype.kind not in kinds:
        raise TypeError(f"{name} has the type {array.dtype}; give "
                        f"{'whole numbers' if 'f' not in kinds else 'numbers'}")
    return array


def _shape_error(name: str, array: np.ndarray, want: str) -> ArgumentError:
    return ArgumentError(f"{name} has the shape {array.shape}; give {want}")


def vertices_of(value: Any) -> np.ndarray:
    """(n, 3) of float64, or float32 if it is that, each row in one piece."""
    array = numbers(value, "vertices", "fiu")
    if array.ndim != 2 or array.shape[1] != 3:
        raise _shape_error("vertices", array, "(n, 3)")
    if not array.dtype.isnative:
        array = array.astype(array.dtype.newbyteorder("="))
    if array.dtype not in (np.float64, np.float32):
        if array.dtype.itemsize > 8 and array.dtype.kind == "f":
            raise TypeError(f"vertices have the type {array.dtype}, which does not fit float64; "
                            "round them by .astype(float)")
        if array.dtype.kind in "iu" and array.dtype.itemsize == 8 and array.size and (
                int(array.max()) > 2**53 or int(array.min()) < -2**53):
            raise ArgumentError("a vertex has a whole number beyond 2**53, which is not exact as "
                                "float64; move or scale the mesh")
        array = array.astype(np.float64)
    rows = array.strides[0] if array.shape[0] > 1 else 3 * array.itemsize
    if array.strides[1] != array.itemsize or rows < 3 * array.itemsize or \
            not array.flags.aligned:
        array = np.array(array, order="C")
    return array


def faces_of(value: Any, vertices: int) -> np.ndarray:
    """(m, 3) of uint32, contiguous. The library checks that indices are below `vertices`."""
    array = numbers(value, "faces", "iu")
    if array.ndim != 2 or array.shape[1] != 3:
        raise _shape_error("faces", array, "(m, 3): divide other polygons into triangles")
    if array.dtype != np.uint32:
        if array.size and array.dtype.kind == "i" and int(array.min()) < 0:
            row = int(np.argmax((array < 0).any(axis=1)))
            raise ArgumentError(f"face {row} has a negative index, {array[row].tolist()}; indices "
                                f"are 0 ... {vertices - 1}")
        if array.size and int(array.max()) > INDEX_MOST:
            raise ArgumentError(f"a face has the index {int(array.max())}; indices are 0 ... "
                                f"{vertices - 1}")
    return np.require(array, np.uint32, ("C", "A"))


def triangles_of(value: Any, name: str = "triangles") -> np.ndarray:
    """(n, 3, 3) of finite float64, contiguous; one triangle (3, 3) becomes (1, 3, 3)."""
    array = numbers(value, name, "fiu")
    if array.ndim == 2:
        array = array[None]
    if array.ndim != 3 or array.shape[1:] != (3, 3):
        raise _shape_error(name, array, "(3, 3) or (n, 3, 3): corners, then x, y, z")
    array = np.require(array, np.float64, ("C", "A"))
    if not np.isfinite(array).all():
        raise ArgumentError(f"{name} have NaN or infinite coordinates; mend them")
    return array


def poses_of(value: Any, name: str) -> Tuple[Optional[np.ndarray], Optional[int]]:
    """The matrices as float64, contiguous, and their number: None for one pose or no pose."""
    if value is None:
        return None, None
    if not (type(value) is np.ndarray and value.dtype == np.float64 and
            value.flags.c_contiguous and value.flags.aligned):
        value = np.require(numbers(value, name), np.float64, ("C", "A"))
    if value.shape == (4, 4):
        return value, None
    if value.ndim == 3 and value.shape[1:] == (4, 4):
        return value, value.shape[0]
    raise _shape_error(name, value, "(4, 4) or (n, 4, 4): rotation, translation in the last "
                       "column, last row 0 0 0 1")


def both_poses(pose_a: Any, pose_b: Any
               ) -> Tuple[Optional[np.ndarray], Optional[np.ndarray], int, bool]:
    """Matrices of A and B, the number of questions, and whether it is one question alone."""
    array_a, count_a = poses_of(pose_a, "pose_a")
    array_b, count_b = poses_of(pose_b, "pose_b")
    if count_a is None and count_b is None:
        return array_a, array_b, 1, True
    if count_a is not None and count_b is not None and count_a != count_b:
        raise ArgumentError(f"pose_a has {count_a} poses and pose_b has {count_b}; give as many, "
                            "or one (4, 4) for all")
    return array_a, array_b, count_a if count_a is not None else count_b or 0, False


def number_of(value: Any, name: str, least: float, most: float) -> float:
    """A finite number within the range."""
    try:
        number = float(value)
    except (TypeError, ValueError):
        raise TypeError(f"{name} is {value!r}; give a number") from None
    if not least <= number <= most:
        raise ArgumentError(f"{name} is {number!r}; give {least!r} ... {most!r}")
    return number


def count_of(value: Any, name: str, most: int = 2**62) -> int:
    """A whole number from 1 on, or 0 for None, which means no limit."""
    if value is None:
        return 0
    if isinstance(value, (bool, np.bool_)) or not isinstance(value, (int, np.integer)):
        raise TypeError(f"{name} is {value!r}; give a whole number, or None")
    if not 1 <= int(value) <= most:
        raise ArgumentError(f"{name} is {value}; give 1 ... {most}, or None")
    return int(value)


def threads_of(value: Any) -> int:
    """A number of threads; 0 for one on each processor."""
    return count_of(value, "threads", 256)


def output(shape: Any, dtype: Any) -> np.ndarray:
    """A new array for answers; too many are an error of Python's kind."""
    try:
        return np.empty(shape, dtype)
    except ValueError as error:
        raise LimitError(f"{shape} answers: {error}") from None
