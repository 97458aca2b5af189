# SPDX-License-Identifier: MIT
"""golden.py - the C golden models of libsepax by ctypes: what a design must answer, and hard pairs
to ask it. The headers in lib/ and c_model/ say what the functions compute."""
import ctypes
import os
from collections import namedtuple
from ctypes import POINTER, Structure, byref, c_bool, c_char, c_int, c_int32, c_size_t, c_uint64

from sepax.cocotb import Found

folder = os.environ.get("LIBSEPAX", "build")
ctypes.CDLL(f"{folder}/libsepax.so.0", mode=ctypes.RTLD_GLOBAL)
library = ctypes.CDLL(f"{folder}/libsepax-model.so.0")  # finds what libsepax has, too


class Error(Structure):
    _fields_ = [("code", c_int), ("text", c_char * 512)]


class Vec(Structure):
    _fields_ = [("x", c_int32), ("y", c_int32), ("z", c_int32)]


class Tri(Structure):
    _fields_ = [("v", Vec * 3)]


class Pair(Structure):
    _fields_ = [("a", Tri), ("b", Tri), ("na", Vec), ("nb", Vec)]


class Verdict(Structure):
    _fields_ = [("collision", c_bool), ("strict", c_bool), ("coplanar", c_bool), ("axis", c_int)]


class Pairs(Structure):
    _fields_ = [("pair", POINTER(c_size_t * 2)), ("count", c_size_t), ("ended", c_bool)]


class EngineRun(Structure):
    _fields_ = [("pairs", c_uint64), ("candidates", c_uint64), ("passes", c_uint64),
                ("found", Pairs), ("collisions", c_uint64), ("first", c_size_t),
                ("out_of_range", c_uint64), ("cycles", c_uint64)]


class Opaque(Structure):
    """A sepax_config or a sepax_design, and more: Python only hands it on."""
    _fields_ = [("bytes", c_char * 8192)]


class Random(Structure):
    _fields_ = [("state", c_uint64)]


library.sepax_config_default.restype = Opaque
library.sepax_exact.restype = Verdict
library.sepax_family_name.restype = ctypes.c_char_p
library.sepax_family_triangles.restype = Pair
for name in "sepax_config_parse sepax_design_init sepax_object_engine".split():
    library[name].restype = c_bool

Run = namedtuple("Run", "pairs candidates collisions out_of_range found")


def triangle(coordinates):
    """Nine coordinates, x y z of three vertices, as a sepax_tri."""
    return Tri.from_buffer_copy((c_int32 * 9)(*coordinates))


def exact(a, b):
    """The verdict of sepax_exact on two triangles of nine coordinates."""
    return library.sepax_exact(byref(triangle(a)), byref(triangle(b)))


def families():
    """The names of the families of hard pairs, coplanar and degenerate ones among them."""
    names = []
    while name := library.sepax_family_name(len(names)):
        names.append(name.decode())
    return names


def hard_pairs(family, word, count, seed):
    """Seeded pairs of a family: [(a, b), ...], nine coordinates each."""
    number, random = families().index(family), Random(seed)
    pairs = [library.sepax_family_triangles(number, word, byref(random)) for _ in range(count)]
    return [(list((c_int32 * 9).from_buffer(p.a)), list((c_int32 * 9).from_buffer(p.b)))
            for p in pairs]


class Design:
    """A design by its options, as `sepax gen` takes them."""

    def __init__(self, options):
        config, error = library.sepax_config_default(), Error()
        self.design = Opaque()
        if not (library.sepax_config_parse(byref(config), options.encode(), byref(error))
                and library.sepax_design_init(byref(self.design), byref(config), byref(error))):
            raise ValueError(error.text.decode())

    def engine(self, a, b, move=(0, 0, 0), word=32):
        """A run of the object engine: all triangles of a against those of b, which is moved."""
        run, error = EngineRun(), Error()
        if not library.sepax_object_engine(
                byref(self.design), (Tri * len(a))(*map(triangle, a)), c_size_t(len(a)),
                (Tri * len(b))(*map(triangle, b)), c_size_t(len(b)), (c_int32 * 3)(*move),
                byref(run), byref(error)):
            raise ValueError(error.text.decode())
        found = []
        for i, j in run.found.pair[:run.found.count]:
            moved = [c + move[k % 3] for k, c in enumerate(b[j])]
            outside = not all(-2**(word - 1) <= c < 2**(word - 1) for c in moved)
            found.append(Found(i, j, not outside and exact(a[i], moved).coplanar, outside))
        library.sepax_pairs_free(byref(run.found))
        return Run(run.pairs, run.candidates, run.collisions, run.out_of_range, found)
