# SPDX-License-Identifier: MIT
"""litex_golden - what examples/litex/soc.py left in a folder, against the golden model of the tree
engine: each pair in its order, and each number of the ends of poses that is defined.

  litex_golden.py FOLDER SAID ...

SAID is what the firmware said: said.txt, or others of which each line of output tells the name.

It needs examples/litex and examples/cocotb among the modules, and LIBSEPAX=build."""
import json
import sys
from ctypes import byref, c_bool, c_char_p, c_size_t, c_uint8, c_uint64, c_void_p, string_at
from pathlib import Path

from golden import Error, library
from golden_tree import FIRST, QUIET, batch, check, job_bytes, pose_bytes
import soc

PAGE = 4096
JOB_AT = PAGE
library.sepax_tree_read.restype = c_bool


class File:
    """A tree of a file, and its place in the memory of the engine."""

    def __init__(self, path, address):
        self.tree, error, size, record = c_void_p(), Error(), c_size_t(), (c_uint8 * 32)()
        check(library.sepax_tree_read(byref(self.tree), c_char_p(str(path).encode()),
                                      byref(error)), error)
        library.sepax_tree_body(self.tree, c_uint64(address), record)
        image = library.sepax_tree_image(self.tree, byref(size))
        self.address, self.record = address, bytes(record)
        self.image = string_at(image, size.value)
        self.end = address + -(-len(self.image) // PAGE) * PAGE


def expected(folder, poses, modes):
    """What the golden model sends for a job of all poses."""
    options = json.loads((folder / "tree" / "sepax.json").read_text("utf-8"))["options"]
    a = File(folder / "a.sxt", 2 * PAGE)
    b = File(folder / "b.sxt", a.end)
    memory = bytearray(b.end + 256 * len(poses))
    for body in a, b:
        memory[body.address:body.address + len(body.image)] = body.image
    for n, (turn, shift) in enumerate(poses):
        at = b.end + 256 * n
        memory[at:at + 144] = pose_bytes(a, b, turn.ravel(), shift)
    memory[JOB_AT:JOB_AT + 128] = job_bytes(a, b, b.end, len(poses), modes)
    return batch(options, memory, JOB_AT, 1)


def differences(answers, due):
    """Numbers of poses that differ, and how many numbers were compared."""
    wrong, compared = [], 0
    for n, (answer, (pairs, end)) in enumerate(zip(answers, due)):
        right = [pair[0] | pair[1] << 32 for pair in answer.pairs] == \
            [word & ~(7 << 56) for word in pairs]
        for k, (value, defined) in enumerate(end):
            if k == 0:  # the driver takes away the bits that mark an end, and LAST
                defined &= 2**32 - 1 | 63 << 32
            for half in range(2):
                bits = defined >> 32 * half & 2**32 - 1
                compared += bits != 0
                right &= (answer.end[2 * k + half] ^ value >> 32 * half) & bits == 0
        wrong += [] if right else [n]
    return wrong, compared


def main():
    """Compare the batches of all pairs, and those of the first pair."""
    folder = Path(sys.argv[1])
    poses = soc.poses_of(8, 1)
    jobs = {"all": 0, "first": FIRST | QUIET, "again": FIRST | QUIET}
    due = {name: expected(folder, poses, modes) for name, modes in jobs.items()}
    failed = False
    for path in map(Path, sys.argv[2:]):
        batches = soc.parse(path.read_text("utf-8"))
        for name in jobs:
            answers = batches.get(name, [])
            wrong, compared = differences(answers, due[name])
            print(f"{path.stem}, {name}: {len(answers)} poses of {len(due[name])}, "
                  f"{compared} numbers, differ: {wrong}")
            failed |= wrong != [] or len(answers) != len(due[name])
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
