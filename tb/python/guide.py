# SPDX-License-Identifier: MIT
"""guide - run the examples of docs/guides/python.md in the current folder. Examples of packages for
hardware that are not here are skipped.

  guide.py GUIDE.md"""
import doctest
import importlib.util
import sys
from pathlib import Path

import numpy

FLAGS = doctest.ELLIPSIS | doctest.NORMALIZE_WHITESPACE | doctest.IGNORE_EXCEPTION_DETAIL


HARDWARE = {"sepax.amaranth": "amaranth", "sepax.cocotb": "cocotbext", "sepax.litex": "litedram"}


def lacking(source):
    """The package that an example imports and that is not here."""
    for module, package in HARDWARE.items():
        if f"from {module} import" in source and importlib.util.find_spec(package) is None:
            return package
    return None


def examples(text, name):
    """The examples of a text. What follows an import that fails, up to the next words, is not
    run."""
    parser, kept, skipped, package = doctest.DocTestParser(), [], {}, None
    for part in parser.parse(text, name):
        if not isinstance(part, doctest.Example):
            package = package if not part.strip() else None
            continue
        package = package or lacking(part.source)
        if package is None:
            kept.append(part)
        else:
            skipped[package] = skipped.get(package, 0) + 1
    return doctest.DocTest(kept, {"__name__": "__main__"}, name, name, 0, text), skipped


def main():
    """Run them, and say how many passed."""
    numpy.set_printoptions(legacy="1.25" if numpy.lib.NumpyVersion(numpy.__version__) >= "2.0.0"
                           else False)
    test, skipped = examples(Path(sys.argv[1]).read_text(encoding="utf-8"), sys.argv[1])
    done = doctest.DocTestRunner(optionflags=FLAGS).run(test)
    for package, count in skipped.items():
        print(f"{count} skipped: no {package}")
    print(f"{done.attempted - done.failed} passed, {done.failed} failed")
    return 0 if done.failed == 0 and done.attempted > 30 else 1


if __name__ == "__main__":
    sys.exit(main())
