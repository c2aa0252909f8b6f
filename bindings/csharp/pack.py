#!/usr/bin/env python3
"""Makes the NuGet package Ups of a build, with every library inside that a program needs beside the system's own:

    bindings/csharp/pack.py BUILD FOLDER [--artifacts DIR]

BUILD: build/release; FOLDER: where Ups.VERSION.nupkg goes; DIR: where dotnet builds, else a temporary folder.

In the package: the assemblies, runtimes/linux-x64/native with libups, the extras that were built and what they need
(Embree, oneTBB, OpenEXR, OpenColorIO ...), and licences/ with the terms of those as the system's packages state them. The
C and C++ run-time libraries are the system's: the package runs where they are as new as where it was built. Libraries for
other platforms go into a folder that UPS_RUNTIMES names, RID/native, and are taken along.
Needs the .NET SDK and patchelf.
"""
import argparse
import os
import re
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

HERE = Path(__file__).resolve().parent
SYSTEM = re.compile(r"(ld-linux.*|lib(c|m|dl|rt|pthread|resolv|util|gcc_s|stdc\+\+))\.so\.\d+$")


def run(*command):
    done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    if done.returncode:
        sys.exit(f"pack: {' '.join(map(str, command))} failed:\n{done.stdout}")
    return done.stdout


def own_libraries(build):
    """SONAME's file of the core and of each extra that was built."""
    found = sorted((build / "src").glob("api/libups.so.*.*")) + sorted((build / "src").glob("extras/*/libups_*.so.*.*"))
    found = [p for p in found if re.search(r"\.so\.\d+\.\d+$", p.name)]
    if not any(p.name.startswith("libups.so") for p in found):
        sys.exit(f"pack: no src/api/libups.so.* in {build}: build it first (cmake --build)")
    return found


def needed_by(library):
    """Name and path of each library that the loader finds for it, the system's own left out."""
    printed = run("ldd", library)
    if missing := re.findall(r"^\s*(\S+) => not found", printed, flags=re.M):
        sys.exit(f"pack: {library} needs {', '.join(missing)}, not found")
    for name, path in re.findall(r"^\s*(\S+) => (.*?) \(0x", printed, flags=re.M):
        if not SYSTEM.match(name):
            yield name, Path(path)
            allocator = Path(path).parent / "libtbbmalloc.so.2"  # oneTBB loads it by itself, where it is
            if name.startswith("libtbb.") and allocator.exists():
                yield allocator.name, allocator


def copy_libraries(build, folder):
    """Copies all into one folder, where they find each other. Returns the sources of what is not UPS."""
    folder.mkdir(parents=True)
    others = {}
    for library in own_libraries(build):
        others.update((name, path) for name, path in needed_by(library) if not name.startswith("libups"))
        shutil.copy(library, folder / library.name)
        # RPATH, not RUNPATH: it holds for what these libraries need in turn, which have none.
        run("patchelf", "--force-rpath", "--set-rpath", "$ORIGIN", folder / library.name)
    for name, path in others.items():
        shutil.copy(path.resolve(), folder / name)
    return others.values()


def copy_licences(libraries, folder):
    folder.mkdir()
    for library in libraries:
        owner = run("dpkg", "-S", f"*/{library.resolve().name}").split(":")[0]
        shutil.copy(Path("/usr/share/doc") / owner / "copyright", folder / f"{owner}.txt")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build", type=Path)
    parser.add_argument("folder", type=Path)
    parser.add_argument("--artifacts", type=Path)
    options = parser.parse_args()
    for tool in ("dotnet", "patchelf", "dpkg"):
        if not shutil.which(tool):
            sys.exit(f"pack: {tool} not found")
    with tempfile.TemporaryDirectory() as temporary:
        work = Path(temporary)
        runtimes = work / "runtimes"
        if "UPS_RUNTIMES" in os.environ:
            shutil.copytree(os.environ["UPS_RUNTIMES"], runtimes)
        others = copy_libraries(options.build.resolve(), runtimes / "linux-x64" / "native")
        copy_licences(others, work / "licences")
        run("dotnet", "pack", HERE / "Ups.csproj", "-c", "Release", "-o", options.folder.resolve(),
            "--artifacts-path", options.artifacts or work / "artifacts", f"-p:UpsRuntimes={runtimes}", f"-p:UpsLicences={work / 'licences'}")


if __name__ == "__main__":
    main()
