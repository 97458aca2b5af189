#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""What slang (pyslang) says of a design.

    slang.py [-D MACRO] FILE.f

Prints its errors and warnings. FILE.f lists the modules' files, the top last. Exit status 1: there
is an error or a warning; 2: the files cannot be read.
"""
import sys
from pathlib import Path

import pyslang


def main() -> int:
    """The command line."""
    *macros, listed = sys.argv[1:]
    folder = Path(listed).parent
    files = [str(folder / name) for name in Path(listed).read_text(encoding="ascii").split()]
    driver = pyslang.driver.Driver()
    driver.addStandardArgs()
    command = ["slang", "--std", "1364-2005", "-Wextra", *macros, "--top", Path(files[-1]).stem]
    if not (driver.parseCommandLine(" ".join(command + files)) and driver.processOptions() and
            driver.parseAllSources()):
        return 2
    compilation = driver.createCompilation()
    driver.reportCompilation(compilation, True)
    driver.reportDiagnostics(True)
    engine = driver.diagEngine
    return 1 if engine.numErrors + engine.numWarnings > 0 else 0


if __name__ == "__main__":
    sys.exit(main())
