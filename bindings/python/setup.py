"""Builds the package's wheel, with the libraries inside, which CMake builds from the project that this folder is in.

    pip install --no-build-isolation bindings/python
    UPS_BUNDLE=1 pip wheel --no-build-isolation --no-deps -w FOLDER bindings/python

The first is for this machine: Embree, oneTBB and what else the libraries need stay the system's. The second puts these
into the wheel too, with their licences, for machines that have Python and numpy alone. Neither needs a network:
setuptools and wheel (Debian: python3-setuptools, python3-wheel) are those of the Python that pip runs in.

Environment:
    UPS_BUNDLE   1: the second kind of wheel; needs patchelf
    UPS_BUILD    a finished build folder, whose libraries are taken; a relative path is one from the project's root.
                 Else it is configured and built in build/python
    CMAKE_ARGS   more options to configure with: -DUPS_BUILD_EXTRAS=AUTO leaves out extras that cannot be built
"""
import os
import platform
import re
import shlex
import subprocess
import sys
import tempfile
from pathlib import Path

from setuptools import Distribution, setup
from setuptools.command.build_py import build_py
from setuptools.command.sdist import sdist

try:
    from setuptools.command.bdist_wheel import bdist_wheel
except ImportError:  # setuptools before 70.1
    from wheel.bdist_wheel import bdist_wheel

sys.path.insert(0, str(Path(__file__).resolve().parent))  # builds run elsewhere
import bundle  # noqa: E402

HERE = Path(__file__).resolve().parent
PROJECT = HERE.parent.parent
OWN_BUILD = PROJECT / "build" / "python"
BUNDLED = os.environ.get("UPS_BUNDLE") == "1"


def version():
    numbers = re.search(r"^HEADER_VERSION = \((\d+), (\d+), (\d+)\)$", (HERE / "ups" / "_ffi.py").read_text(), re.M)
    return ".".join(numbers.groups())


def build_libraries():
    """The build folder that has them."""
    if os.environ.get("UPS_BUILD"):
        build = PROJECT / os.environ["UPS_BUILD"]  # pip runs this file in another folder than the caller's
        if not build.is_dir():
            raise SystemExit(f"UPS_BUILD={os.environ['UPS_BUILD']}: there is no folder {build}")
        return build
    options = ["-DCMAKE_BUILD_TYPE=Release", "-DUPS_BUILD_TOOL=OFF", "-DUPS_BUILD_TESTS=OFF", "-DUPS_BUILD_SAMPLES=OFF",
               *shlex.split(os.environ.get("CMAKE_ARGS", ""))]
    subprocess.run(["cmake", "-S", PROJECT, "-B", OWN_BUILD, *options], check=True)
    subprocess.run(["cmake", "--build", OWN_BUILD, "--parallel", str(len(os.sched_getaffinity(0)))], check=True)
    return OWN_BUILD


class BuildWithLibraries(build_py):
    """The Python files, the libraries in ups/lib and the licences in ups/licences."""

    def run(self):
        super().run()
        package = Path(self.build_lib) / "ups"
        libraries, licences = package / "lib", package / "licences"
        for folder in (libraries, licences):
            folder.mkdir(exist_ok=True)
            for old in folder.iterdir():
                old.unlink()
        with tempfile.TemporaryDirectory() as prefix:
            subprocess.run(["cmake", "--install", build_libraries(), "--prefix", prefix], check=True,
                           stdout=subprocess.DEVNULL)
            bundle.copy_own(Path(prefix), libraries)
        self.copy_file(str(PROJECT / "LICENSE"), str(licences / "UPS"))
        self.copy_file(str(PROJECT / "src/api/package/THIRD-PARTY.md"), str(licences))
        if BUNDLED:
            bundle.copy_dependencies(libraries, licences)


class PlatformWheel(bdist_wheel):
    """For any Python 3, as ctypes needs no compiled module, on one platform."""

    def get_tag(self):
        kind = "linux"
        if BUNDLED:  # pip refuses it where the C library is older than the one that it was built with
            kind = "manylinux_" + platform.libc_ver()[1].replace(".", "_")
        return "py3", "none", f"{kind}_{platform.machine()}"


class WithLibraries(Distribution):
    def has_ext_modules(self):
        return True  # as far as setuptools knows: a wheel of one platform


class NoSourceArchive(sdist):
    def run(self):
        raise SystemExit("ups has no source archive of its own: build the wheel from the project's source tree")


OWN_BUILD.mkdir(parents=True, exist_ok=True)
setup(version=version(), distclass=WithLibraries,
      cmdclass={"build_py": BuildWithLibraries, "bdist_wheel": PlatformWheel, "sdist": NoSourceArchive},
      # Beside the libraries' build, so that the source tree stays clean.
      options={"build": {"build_base": str(OWN_BUILD / "wheel")}, "egg_info": {"egg_base": str(OWN_BUILD)}})
