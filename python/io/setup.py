# SPDX-License-Identifier: MIT
"""setup.py - builds the package sepax-io: the extension of sepax with all readers, and the program
sepax. It needs libxml2, libzip, jansson and libmd with their headers, and make, in a checkout of
the project."""
import glob
import os
import shutil
import subprocess
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
ROOT = os.path.dirname(os.path.dirname(HERE))
sys.path.insert(0, os.path.join(ROOT, "python"))
os.chdir(HERE)
import build_core  # noqa: E402 # pylint: disable=wrong-import-position


class Build(build_core.BuildExt):
    """Also builds the program, and puts it beside the extension."""

    def run(self):
        super().run()
        # Relative, as make is called elsewhere: it knows by these names what an object is made of.
        build = os.path.relpath(os.environ.get("SEPAX_BUILD") or os.path.join(ROOT, "build"), ROOT)
        subprocess.run(["make", "-s", "-C", ROOT, f"BUILD={build}", f"{build}/sepax"], check=True)
        folder = os.path.join(self.build_lib, "sepax_io", "bin")
        os.makedirs(folder, exist_ok=True)
        shutil.copy(os.path.join(ROOT, build, "sepax"), folder)


build_core.BuildExt = Build
for leftover in glob.glob("*.egg-info"):
    shutil.rmtree(leftover)
build_core.setup("sepax-io", ROOT, with_libraries=True, packages=["sepax_io"],
                 install_requires=["sepax==" + build_core.version(ROOT)])
