# SPDX-License-Identifier: MIT
"""guide - run the examples of docs/guides/python.md in the current folder.

  guide.py GUIDE.md"""
import doctest
import sys

import numpy

FLAGS = doctest.ELLIPSIS | doctest.NORMALIZE_WHITESPACE | doctest.IGNORE_EXCEPTION_DETAIL


def main():
    """Run them, and say how many passed."""
    numpy.set_printoptions(legacy="1.25" if numpy.lib.NumpyVersion(numpy.__version__) >= "2.0.0"
                           else False)
    done = doctest.testfile(sys.argv[1], module_relative=False, optionflags=FLAGS)
    print(f"{done.attempted - done.failed} passed, {done.failed} failed")
    return 0 if done.failed == 0 and done.attempted > 30 else 1


if __name__ == "__main__":
    sys.exit(main())
