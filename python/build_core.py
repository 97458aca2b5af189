# SPDX-License-Identifier: MIT
"""build_core.py - compiles the extension of the packages sepax and sepax-io.

Both have the same functions. That of sepax-io also reads what needs libraries: URDF, SRDF and DAE
(libxml2), 3MF (libxml2 and libzip)."""
import concurrent.futures
import glob
import os
import re
import subprocess
import sys
import sysconfig

import setuptools
from setuptools.command.build_ext import build_ext

# As scripts/make/flags.mk has them; without -ffp-contract=off proofs of rounding do not hold.
FLAGS = ["-std=c11", "-D_POSIX_C_SOURCE=200809L", "-ffp-contract=off", "-O2", "-g0",
         "-fvisibility=hidden", "-Wno-unused-result"]
SOURCES = ["lib/*/*.c", "io/reader/*.c", "io/robot/*.c", "io/text/*.c", "python/core/*.c"]
WITHOUT = ["io/missing/*.c"]
WITH = ["io/xml/*.c", "io/robot/libxml2/*.c", "io/archive/*.c"]
# The buffers of arrays are in the stable interface of Python since 3.11.
STABLE = (3, 11)


def version(root):
    """The version of the library, as its header has it."""
    with open(os.path.join(root, "lib/sepax.h"), encoding="utf-8") as header:
        parts = re.findall(r"^#define SEPAX_VERSION_[A-Z]+ (\d+)$", header.read(), re.M)
    return ".".join(parts)


def is_stable():
    """Whether one wheel serves this Python and all later ones."""
    return sys.version_info >= STABLE and not sysconfig.get_config_var("Py_GIL_DISABLED")


def pkg_config(what):
    """The words of pkg-config for the libraries of sepax-io."""
    return subprocess.run(["pkg-config", what, "libxml-2.0", "libzip"], capture_output=True,
                          text=True, check=True).stdout.split()


class BuildExt(build_ext):
    """Compiles the files of an extension at once, as many as there are processors."""

    def build_extension(self, ext):
        compiler = self.compiler
        one_by_one = compiler.compile
        jobs = int(os.environ.get("SEPAX_JOBS") or os.cpu_count() or 1)

        def compile_all(sources, **options):
            with concurrent.futures.ThreadPoolExecutor(jobs) as pool:
                done = pool.map(lambda source: one_by_one([source], **options), sources)
                return [name for names in done for name in names]

        compiler.compile = compile_all
        try:
            super().build_extension(ext)
        finally:
            compiler.compile = one_by_one


def extension(name, root, with_libraries):
    """The extension, its files relative to the current folder."""
    patterns = SOURCES + (WITH if with_libraries else WITHOUT)
    sources = sorted(file for pattern in patterns
                     for file in glob.glob(os.path.join(root, pattern)))
    stable = is_stable()
    macros = [("Py_LIMITED_API", f"0x{STABLE[0]:02X}{STABLE[1]:02X}0000")] if stable else []
    link = ["-Wl,-Bsymbolic-functions"] if sys.platform.startswith("linux") else []
    return setuptools.Extension(
        name, sources=[os.path.relpath(file) for file in sources],
        include_dirs=[os.path.relpath(os.path.join(root, folder)) for folder in ("lib", "io")],
        define_macros=macros, py_limited_api=stable,
        depends=[os.path.relpath(file) for folder in ("lib", "io", "python/core")
                 for file in glob.glob(os.path.join(root, folder, "**/*.h"), recursive=True)],
        extra_compile_args=[*FLAGS, *os.environ.get("SEPAX_COMPILE", "").split(),
                            *(pkg_config("--cflags") if with_libraries else [])],
        extra_link_args=link + (pkg_config("--libs") if with_libraries else []) +
        ["-lm", "-pthread"])


def setup(name, root=".", with_libraries=False, commands=None, **more):
    """Call setuptools for the package `name`, whose extension is _core."""
    objects = os.environ.get("SEPAX_OBJECTS") or os.path.join(root, "build/python/objects")
    options = {"build": {"build_base": os.path.join(objects, name)}}
    if is_stable():
        options["bdist_wheel"] = {"py_limited_api": f"cp{STABLE[0]}{STABLE[1]}"}
    package = more["packages"][0]
    setuptools.setup(version=version(root), cmdclass={"build_ext": BuildExt, **(commands or {})},
                     options=options,
                     ext_modules=[extension(f"{package}._core", root, with_libraries)],
                     package_data={package: ["py.typed", "*.pyi", "bin/*"]}, zip_safe=False,
                     **more)
