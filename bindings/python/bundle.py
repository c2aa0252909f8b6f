"""Which libraries a wheel or a NuGet package has inside: this project's, and those that they need.

Called by setup.py and by ../csharp/pack.py.
"""
import re
import shutil
import subprocess
from pathlib import Path

# What every machine with Python has: the C and C++ run time, as the tags "manylinux" (PEP 600) have it, and zlib.
_OF_THE_SYSTEM = re.compile(r"(ld-linux.*|lib(c|m|dl|rt|pthread|stdc\+\+|gcc_s|z))\.so\.\d+")
# oneTBB takes memory from it where it finds it beside itself; nothing is linked with it.
_LOADED = {"libtbb.so.12": "libtbbmalloc.so.2"}


def copy_own(prefix, folder):
    """The libraries of an installed UPS by their SONAMEs, as links are not to be had in a wheel."""
    names = [p for p in prefix.rglob("libups*.so.*") if p.is_symlink()]
    if not names:
        raise SystemExit(f"no library in what `cmake --install` made in {prefix}")
    for name in names:
        shutil.copy(name, folder / name.name)


def _needed(library):
    """SONAME and file of each library that it needs, directly or not."""
    listed = subprocess.run(["ldd", library], check=True, capture_output=True, text=True).stdout
    if missing := re.findall(r"(\S+) => not found", listed):
        raise SystemExit(f"{library} needs {', '.join(missing)}, which this machine does not have")
    return re.findall(r"(\S+) => (\S+) \(", listed)


def _dependencies(libraries):
    found = {}
    for library in libraries:
        found.update((name, Path(file)) for name, file in _needed(library) if not _OF_THE_SYSTEM.fullmatch(name))
    for name, companion in _LOADED.items():
        if name in found and (file := found[name].with_name(companion)).exists():
            found[companion] = file
    return {name: file for name, file in found.items() if not name.startswith("libups")}


def _licence(file):
    """(package, its file of licences), which Debian has of every package."""
    owner = None
    for path in (file, file.resolve(), Path("/usr") / file.relative_to("/")):  # /lib is a link to /usr/lib
        asked = subprocess.run(["dpkg-query", "-S", path], capture_output=True, text=True)
        if asked.returncode == 0:
            owner = asked.stdout.split(":")[0]
    copyright = Path("/usr/share/doc") / (owner or "") / "copyright"
    if not owner or not copyright.is_file():
        raise SystemExit(f"no licence is known of {file}, which would go inside: not from a Debian package")
    return owner, copyright


def copy_dependencies(folder, licences):
    """Beside the libraries in `folder`, which then find one another there and nowhere else."""
    if not shutil.which("patchelf"):
        raise SystemExit("the libraries that go inside need patchelf (Debian: patchelf)")
    own = sorted(folder.iterdir())
    for name, file in sorted(_dependencies(own).items()):
        owner, text = _licence(file)
        shutil.copy(file, folder / name)
        shutil.copy(text, licences / owner)
    for library in folder.iterdir():
        subprocess.run(["patchelf", "--set-rpath", "$ORIGIN", library], check=True)
