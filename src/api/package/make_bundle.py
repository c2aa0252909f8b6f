#!/usr/bin/env python3
"""Makes an archive of a build with every shared library that a program must bring along, for those who ship their own:

    src/api/package/make_bundle.py build/release FOLDER        writes FOLDER/ups-VERSION-linux-ARCHITECTURE.tar.gz

In it: lib with libups, the extras that were built and what they need (Embree, oneTBB, OpenEXR, Cairo ...), which find
one another wherever the folder is, under names that no other library of the program has; headers, CMake and pkg-config files; the Python package, bindings' and samples' sources;
licences with the terms of what was taken along. Beside a program go lib's files *.so.*, with an rpath of $ORIGIN/lib or the
like. The C and C++ run time and zlib are the system's: as new as where the bundle was made, or newer. Needs patchelf.
"""
import argparse
import platform
import re
import shutil
import subprocess
import sys
import tarfile
import tempfile
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parents[2] / "bindings" / "python"))
import bundle  # noqa: E402


def install(build, prefix):
    """Without the program."""
    for component in ("runtime", "development", "python"):
        done = subprocess.run(["cmake", "--install", build, "--prefix", prefix, "--component", component],
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
        if done.returncode:
            sys.exit(f"make_bundle: cmake --install {build} failed; was it built (cmake --build)?\n{done.stdout}")


def keep_shared(prefix):
    """Static libraries, and what pkg-config and CMake say for them, need others' development files."""
    for file in (*prefix.rglob("*.a"), *prefix.rglob("upsStaticTargets*.cmake")):
        file.unlink()
    for folder in prefix.glob("share/doc/libups*"):  # of the Debian packages
        shutil.rmtree(folder)
    for file in prefix.rglob("*.pc"):
        file.write_text(re.sub(r"^\w+\.private:.*\n", "", file.read_text(), flags=re.M))


def add_dependencies(prefix):
    own = [p for p in prefix.rglob("libups.so.*") if not p.is_symlink()][0].parent
    licences = prefix / "licences"
    licences.mkdir()
    with tempfile.TemporaryDirectory() as temporary:
        libraries = Path(temporary)
        bundle.copy_own(prefix, libraries)
        bundle.copy_dependencies(libraries, licences)
        for library in libraries.iterdir():
            target = own / library.name
            shutil.copy(library, target.resolve() if target.is_symlink() else target)


def version(prefix):
    numbers = re.findall(r"^#define UPS_VERSION_\w+ (\d+)$", (prefix / "include/ups/ups_base.h").read_text(), re.M)
    return ".".join(numbers)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build", type=Path)
    parser.add_argument("folder", type=Path)
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as temporary:
        prefix = Path(temporary) / "ups"
        install(options.build, prefix)
        keep_shared(prefix)
        add_dependencies(prefix)
        name = f"ups-{version(prefix)}-linux-{platform.machine()}"
        options.folder.mkdir(parents=True, exist_ok=True)
        with tarfile.open(options.folder / f"{name}.tar.gz", "w:gz", compresslevel=4) as archive:
            archive.add(prefix, name)
    print(options.folder / f"{name}.tar.gz")


if __name__ == "__main__":
    main()
