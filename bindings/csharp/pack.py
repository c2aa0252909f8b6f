#!/usr/bin/env python3
"""Makes the NuGet package Ups of a build, with every library inside that a program needs beside the system's own:

    bindings/csharp/pack.py BUILD FOLDER [--artifacts DIR]

BUILD: build/release; FOLDER: where Ups.VERSION.nupkg goes; DIR: where dotnet builds, else a temporary folder.

In the package: the assemblies, runtimes/linux-x64/native with libups, the extras that were built and what they need
(Embree, oneTBB, OpenEXR, OpenColorIO, Cairo ...), and licences/ with the terms of those as the system's packages state them.
zlib and the C and C++ run time are the system's: the package runs where they are as new as where it was built. Libraries for
other platforms are taken along from a folder that UPS_RUNTIMES names: RID/native. Needs the .NET SDK and patchelf.
"""
import argparse
import os
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent / "python"))
import bundle  # noqa: E402


def run(*command):
    done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    if done.returncode:
        sys.exit(f"pack: {' '.join(map(str, command))} failed:\n{done.stdout}")
    return done.stdout


def copy_own(build, folder):
    """The core and each extra that was built, by their SONAMEs."""
    links = [*(build / "src").glob("api/libups.so.*.*"), *(build / "src").glob("extras/*/libups_*.so.*.*")]
    links = [p for p in links if p.is_symlink()]
    if not any(p.name.startswith("libups.so") for p in links):
        sys.exit(f"pack: no src/api/libups.so.* in {build}: build it first (cmake --build)")
    folder.mkdir(parents=True)
    for link in links:
        shutil.copy(link, folder / link.name)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build", type=Path)
    parser.add_argument("folder", type=Path)
    parser.add_argument("--artifacts", type=Path)
    options = parser.parse_args()
    if not shutil.which("dotnet"):
        sys.exit("pack: no .NET SDK: dotnet is not on PATH")
    with tempfile.TemporaryDirectory() as temporary:
        work = Path(temporary)
        runtimes = work / "runtimes"
        if "UPS_RUNTIMES" in os.environ:
            shutil.copytree(os.environ["UPS_RUNTIMES"], runtimes)
        copy_own(options.build.resolve(), runtimes / "linux-x64" / "native")
        (work / "licences").mkdir()
        shutil.copy(HERE.parents[1] / "src/api/package/THIRD-PARTY.md", work / "licences")
        bundle.copy_dependencies(runtimes / "linux-x64" / "native", work / "licences")
        run("dotnet", "pack", HERE / "Ups.csproj", "-c", "Release", "-o", options.folder.resolve(),
            "--artifacts-path", options.artifacts or work / "artifacts", f"-p:UpsRuntimes={runtimes}",
            f"-p:UpsLicences={work / 'licences'}")


if __name__ == "__main__":
    main()
