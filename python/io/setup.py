# SPDX-License-Identifier: MIT
"""setup.py - builds the package sepax-io: the extension of sepax with all readers, and the programs
sepax and sepax-certificate-check. It needs libxml2, libzip, jansson and libmd with their headers,
pkg-config and make. The sources are those of the checkout; the source distribution has a copy of
them in `project`."""
import glob
import os
import shutil
import subprocess
import sys

from setuptools.command.sdist import sdist

HERE = os.path.dirname(os.path.abspath(__file__))
COPY = os.path.join(HERE, "project")
ROOT = COPY if os.path.isdir(COPY) else os.path.dirname(os.path.dirname(HERE))
PARTS = ("LICENSE", "Makefile", "scripts", "lib", "io", "c_model", "rtl_gen", "drivers", "program",
         "python/build_core.py", "python/core", "python/sepax")
LIBRARIES = {"libxml-2.0": "libxml2-dev", "libzip": "libzip-dev", "jansson": "libjansson-dev",
             "libmd": "libmd-dev"}
sys.path.insert(0, os.path.join(ROOT, "python"))
os.chdir(HERE)
import build_core  # noqa: E402 # pylint: disable=wrong-import-position


def lacking():
    """What is not here, with the package of Debian that has it."""
    tools = [(name, name) for name in ("make", "pkg-config") if shutil.which(name) is None]
    if tools:
        return tools
    return [(name, package) for name, package in LIBRARIES.items()
            if subprocess.run(["pkg-config", "--exists", name], check=False).returncode != 0]


PROGRAMS = ("sepax", "sepax-certificate-check")


class Build(build_core.BuildExt):
    """Also builds the programs, and puts them beside the extension."""

    def run(self):
        super().run()
        # Relative, as make is called elsewhere: it knows by these names what an object is made of.
        build = os.path.relpath(os.environ.get("SEPAX_BUILD") or os.path.join(ROOT, "build"), ROOT)
        subprocess.run(["make", "-s", "-C", ROOT, f"BUILD={build}",
                        *(f"{build}/{name}" for name in PROGRAMS)], check=True)
        folder = os.path.join(self.build_lib, "sepax_io", "bin")
        os.makedirs(folder, exist_ok=True)
        for name in PROGRAMS:
            shutil.copy(os.path.join(ROOT, build, name), folder)


class SourceDistribution(sdist):
    """Has a copy of what the build needs from the checkout."""

    def make_release_tree(self, base_dir, files):
        super().make_release_tree(base_dir, [name for name in files
                                             if not name.startswith((os.pardir, "project"))])
        for part in PARTS:
            source, copy = os.path.join(ROOT, part), os.path.join(base_dir, "project", part)
            if os.path.isdir(source):
                shutil.copytree(source, copy, ignore=shutil.ignore_patterns("__pycache__", "*.pyc"))
            else:
                os.makedirs(os.path.dirname(copy), exist_ok=True)
                shutil.copy2(source, copy)


making = not {"sdist", "egg_info", "dist_info"}.intersection(sys.argv)
missing = lacking()
if missing and making:
    sys.exit("sepax-io: no " + ", no ".join(name for name, _ in missing) +
             "; on Debian: apt-get install " + " ".join(package for _, package in missing))
build_core.BuildExt = Build
for leftover in glob.glob("*.egg-info"):
    shutil.rmtree(leftover)
build_core.setup("sepax-io", ROOT, with_libraries=not missing, packages=["sepax_io"],
                 commands={"sdist": SourceDistribution},
                 install_requires=["sepax==" + build_core.version(ROOT)])
