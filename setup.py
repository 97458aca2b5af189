# SPDX-License-Identifier: MIT
"""setup.py - builds the package sepax: its C extension from lib/, io/ and python/core.

The extension needs a C compiler and the headers of Python, and no other library."""
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "python"))
import build_core  # noqa: E402 # pylint: disable=wrong-import-position

build_core.setup("sepax", packages=["sepax"], package_dir={"sepax": "python/sepax"})
