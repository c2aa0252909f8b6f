"""Which libraries a wheel, a NuGet package or a bundle has inside: this project's, and those that they need.

Called by setup.py, ../csharp/pack.py and src/api/package/make_bundle.py.
"""
import hashlib
import re
import shutil
import subprocess
from pathlib import Path

# What every machine with Python has: the C and C++ run time, as the tags "manylinux" (PEP 600) have it, and zlib. And a
# sanitizer's run time, of which a process has one.
_OF_THE_SYSTEM = re.compile(r"(ld-linux.*|lib(c|m|dl|rt|pthread|stdc\+\+|gcc_s|z|asan|tsan|ubsan))\.so\.\d+")
# oneTBB takes memory from it where it finds it by this name beside itself; nothing is linked with it. Once there is none, it
# goes on where oneTBB alone would end the process (ups_base.h). It loads itself by its name, so that it keeps that.
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


def _licences(files):
    """Of each file (package, its file of licences), which Debian has of every package."""
    names = {file: (file, file.resolve(), Path("/usr") / file.relative_to("/")) for file in files}  # /lib is a link there
    asked = subprocess.run(["dpkg-query", "-S", *(path for paths in names.values() for path in paths)],
                           capture_output=True, text=True)  # fails where one of them has no owner
    owners = {path: packages.split(":")[0]
              for packages, _, path in (line.rpartition(": ") for line in asked.stdout.splitlines())}
    found = {}
    for file, paths in names.items():
        owner = next((owners[str(path)] for path in reversed(paths) if str(path) in owners), None)
        text = Path("/usr/share/doc") / (owner or "") / "copyright"
        if not owner or not text.is_file():
            raise SystemExit(f"no licence is known of {file}, which would go inside: not from a Debian package")
        found[file] = owner, text
    return found


def _name_apart(name, file):
    """A SONAME that no other program's library has: libtbb.so.12 is libtbb-0123abcd.so.12, as auditwheel has it."""
    stem, ending = name.split(".so", 1)
    return f"{stem}-{hashlib.sha256(file.read_bytes()).hexdigest()[:8]}.so{ending}"


def _patchelf(*arguments):
    return subprocess.run(["patchelf", *arguments], check=True, capture_output=True, text=True).stdout


def copy_dependencies(folder, licences):
    """Beside the libraries in `folder`, which then find one another there and nowhere else.

    Under names of their own: a process takes a library for loaded where one of its SONAME is, so that a host with another
    oneTBB or Cairo would get these, or these that.
    """
    if not shutil.which("patchelf"):
        raise SystemExit("the libraries that go inside need patchelf (Debian: patchelf)")
    own = sorted(folder.iterdir())
    names = {}
    dependencies = _dependencies(own)
    licences_of = _licences(set(dependencies.values()))
    for name, file in sorted(dependencies.items()):
        owner, text = licences_of[file]
        names[name] = _name_apart(name, file)
        target = folder / (name if name in _LOADED.values() else names[name])
        shutil.copy(file, target)
        target.chmod(0o755)  # what is read-only cannot be named
        _patchelf("--set-soname", names[name], target)
        shutil.copy(text, licences / owner)
    for library in folder.iterdir():
        _patchelf("--set-rpath", "$ORIGIN", library)
        renamed = [n for n in _patchelf("--print-needed", library).split() if n in names]
        if renamed:  # in a call of its own: patchelf 0.14 forgets it beside another change
            _patchelf(*(a for n in renamed for a in ("--replace-needed", n, names[n])), library)
