# SPDX-License-Identifier: MIT
"""golden_tree.py - trees, poses, jobs and the golden model of the tree engine by ctypes, as
c_model/sepax_tree.h has them."""
import ctypes
from ctypes import (CFUNCTYPE, POINTER, Structure, byref, c_bool, c_double, c_int, c_size_t, c_uint,
                    c_uint8, c_uint32, c_uint64, c_void_p)

from golden import Design, Error, Opaque, Tri, library, triangle


class Grid(Structure):
    _fields_ = [("resolution", c_double), ("offset", c_double * 3), ("word", c_int)]


class Pose(Structure):
    _fields_ = [("rotation", c_double * 9), ("translation", c_double * 3)]


class Near(Structure):
    _fields_ = [("triangle", c_uint32 * 2), ("leaf", c_uint32 * 2), ("child", c_int * 2),
                ("out_of_range", c_bool), ("collision", c_bool), ("coplanar", c_bool),
                ("band", c_int)]


class Walk(Structure):
    _fields_ = [(name, c_uint64) for name in (
        "entries steps rows pairs near collisions out_of_range warnings passes").split()] + [
            ("found", Near), ("cycles", c_uint64), ("deepest", c_uint64), ("damaged", c_bool),
            ("ended", c_bool)]


class Job(Structure):
    _fields_ = [("body", c_uint8 * 32 * 2), ("poses", c_uint64), ("count", c_uint32),
                ("modes", c_uint32), ("budget", c_uint32), ("leaf", c_uint32 * 2),
                ("child", c_int * 2)]


class Memory(Structure):
    _fields_ = [("byte", c_void_p), ("address", c_uint64), ("size", c_uint64)]


EACH = CFUNCTYPE(None, c_void_p, POINTER(Near))


class Batch(Structure):
    _fields_ = [("design", POINTER(Opaque)), ("memory", POINTER(Memory)), ("list", c_uint64),
                ("jobs", c_uint32), ("each", EACH), ("context", c_void_p), ("job", c_uint32),
                ("pose", c_uint32), ("has_row", c_bool), ("row", Near), ("current", Job)]


class Result(Structure):
    _fields_ = [("job", c_uint32), ("pose", c_uint32), ("status", c_uint), ("modes", c_uint),
                ("run", Walk)]


library.sepax_tree_image.restype = c_void_p
for name in "sepax_tree_new sepax_tree_pose_make sepax_tree_next".split():
    library[name].restype = c_bool
FIRST, QUIET, HIT = 1, 2, 1


def check(done, error):
    if not done:
        raise ValueError(error.text.decode())


class Body:
    """The tree of a body, and its place in the memory of the engine."""

    def __init__(self, triangles, word, address):
        self.tree, error, size, record = c_void_p(), Error(), c_size_t(), (c_uint8 * 32)()
        check(library.sepax_tree_new(
            byref(self.tree), (Tri * len(triangles))(*map(triangle, triangles)),
            c_size_t(len(triangles)), byref(Grid(1, (c_double * 3)(), word)), byref(error)), error)
        library.sepax_tree_body(self.tree, c_uint64(address), record)
        image = library.sepax_tree_image(self.tree, byref(size))
        self.address, self.record = address, bytes(record)
        self.image = ctypes.string_at(image, size.value)


def pose_bytes(a, b, rotation, translation):
    """The pose of body b, nine and three numbers, a where it stands, as the engine reads it."""
    pose, error, packed = Opaque(), Error(), (c_uint8 * 144)()
    given = Pose((c_double * 9)(*rotation), (c_double * 3)(*translation))
    check(library.sepax_tree_pose_make(byref(pose), a.tree, None, b.tree, byref(given),
                                       ctypes.c_int64(0), byref(error)), error)
    library.sepax_tree_pose_pack(byref(pose), packed)
    return bytes(packed)


def job_bytes(a, b, poses, count, modes=0):
    """A job: bodies a and b in poses from an address on."""
    job, packed = Job(poses=poses, count=count, modes=modes), (c_uint8 * 128)()
    job.body[0][:], job.body[1][:] = a.record, b.record
    library.sepax_tree_job_pack(byref(job), packed)
    return bytes(packed)


def batch(options, memory, jobs_at, jobs):
    """What the engine sends for a list of jobs in a memory from address 0 on: of each pose the
    pairs, and its end."""
    near = []

    @EACH
    def each(_, pair):
        p = pair.contents
        near.append(p.triangle[0] | p.triangle[1] << 32 | p.coplanar << 56 | p.out_of_range << 57)

    design, data, error, more = Design(options), (c_uint8 * len(memory))(*memory), Error(), c_bool()
    whole = Memory(ctypes.addressof(data), 0, len(memory))
    state = Batch(ctypes.pointer(design.design), ctypes.pointer(whole), jobs_at, jobs, each)
    poses = []
    while True:
        result, before = Result(), len(near)
        check(library.sepax_tree_next(byref(state), byref(result), byref(more), byref(error)),
              error)
        if not more:
            break
        poses.append(([] if result.modes & QUIET else near[before:], end_of_pose(result)))
    return poses


def end_of_pose(result):
    """The eight transfers of docs/reference/tree-engine.md, Results, but for the bit LAST:
    [(value, mask), ...]. A mask has a 1 where a bit is defined."""
    run, found = result.run, result.run.found
    row = [found.child[k] << 23 | found.leaf[k] for k in range(2)]
    hit = result.status & HIT != 0
    ran = not (hit and result.modes & FIRST)  # to its end: all counters are exact
    return [(low | high << 32, (2**32 - 1) * (low_defined | high_defined << 32))
            for low, high, low_defined, high_defined in (
                (run.steps, 1 << 31 | result.status, ran, True),
                (result.job, result.pose, True, True),
                (0, run.near, False, True),  # cycles
                (run.collisions, run.warnings, True, ran),
                (run.out_of_range, run.pairs, ran, ran),
                (run.rows, run.entries, ran, ran),
                (*found.triangle, hit, hit),
                (*row, hit, hit))]
