# SPDX-License-Identifier: MIT
"""sepax_io: readers of sepax that need libraries. `import sepax` finds them by itself.

It has the programs sepax and sepax-certificate-check, too."""
import os
import sys


def _run(name: str) -> None:
    os.execv(os.path.join(os.path.dirname(os.path.abspath(__file__)), "bin", name), sys.argv)


def sepax() -> None:
    """The program sepax."""
    _run("sepax")


def sepax_certificate_check() -> None:
    """The program sepax-certificate-check."""
    _run("sepax-certificate-check")
