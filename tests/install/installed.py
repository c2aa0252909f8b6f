"""Does an installed UPS have what it should beside libraries that link? Called by run.sh: installed.py PREFIX LIBDIR BUILD

Its licence; notices and an SPDX document that name every library that its own ones are linked with; manual pages that say
what the program says; the bindings' and samples' sources; documents whose links lead somewhere.
"""
import json
import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
ROOT = HERE.parent.parent
sys.path.insert(0, str(ROOT / "samples" / "docs"))
import pages  # noqa: E402

OF_THE_SYSTEM = re.compile(r"(ld-linux.*|lib(c|m|dl|rt|pthread|stdc\+\+|gcc_s|z|asan|ubsan|tsan)\.so\.\d+|ld-.*)")
# Names of libraries and of what they are of, lower case.
OF = {"tbb": "onetbb", "iex": "openexr", "ilmthread": "openexr"}


def needed(file):
    listed = subprocess.run(["readelf", "-d", file], check=True, capture_output=True, text=True).stdout
    return [n for n in re.findall(r"NEEDED.*\[(.+)\]", listed) if not OF_THE_SYSTEM.fullmatch(n)]


def check_notices(prefix, libdir):
    documents = prefix / "share/doc/ups"
    assert (documents / "LICENSE").read_text() == (ROOT / "LICENSE").read_text()
    notices = (documents / "THIRD-PARTY.md").read_text(encoding="utf-8").lower()
    spdx = json.loads((documents / "ups.spdx.json").read_text(encoding="utf-8"))
    assert spdx["spdxVersion"] == "SPDX-2.3" and re.fullmatch(r"\d{4}(-\d\d){2}T[\d:]{8}Z", spdx["creationInfo"]["created"])
    packages = {p["SPDXID"]: p for p in spdx["packages"]}
    assert len(packages) == len(spdx["packages"])
    linked = [(r["spdxElementId"], r["relatedSpdxElement"]) for r in spdx["relationships"]]
    assert all(b in packages and a in packages | {"SPDXRef-DOCUMENT": 0} for a, b in linked)
    files = [f for f in (prefix / libdir).glob("libups*.so.*") if not f.is_symlink()]
    files += [f for f in [prefix / "bin/ups"] if f.exists()]
    if "-fsanitize" in os.environ.get("FLAGS", ""):
        files = []  # a sanitizer's build links more than is said of the others
    for file in files:
        own = "SPDXRef-" + file.name.split(".")[0].replace("_", "-")
        for library in needed(file):
            name = re.match(r"lib(ups_[a-z]+|[A-Za-z]+)", library)[1].lower()
            name = OF.get(name, name)
            found = [b for a, b in linked if a == own and packages[b]["name"].lower() in (name, "lib" + name)]
            assert found, f"ups.spdx.json does not say that {own} is linked with {library}"
            assert name.startswith("ups") or name in notices, f"THIRD-PARTY.md says nothing of {library}"
    for package in packages.values():
        if "homepage" in package:
            assert package["homepage"].lower() in notices, package


def check_sources(prefix):
    for file in ("lib/python3/dist-packages/ups/__init__.py", "lib/python3/dist-packages/ups/py.typed",
                 "share/ups/csharp/Ups.csproj", "share/ups/csharp/Ups.cs", "share/doc/ups/samples/c/room.c",
                 "share/doc/ups/samples/cpp/room.cpp", "share/doc/ups/samples/csharp/Room.cs",
                 "share/doc/ups/samples/python/room.py",
                 *(f"share/doc/ups/samples/docs/{p.name}" for p in (ROOT / "samples/docs").glob("*.md"))):
        assert (prefix / file).stat().st_size or file.endswith("py.typed"), file
    headers = {p.name for p in (ROOT / "include/ups").glob("*.h*")}
    installed = {p.name for p in (prefix / "include/ups").iterdir()}
    assert {n for n in headers - installed if n[4:-2] not in ("gltf", "exr", "ocio", "report")} == set(), headers - installed
    assert not list(prefix.rglob("__pycache__")) and not list(prefix.rglob("obj"))


def check_links(prefix):
    count = 0
    for file in (f for f in prefix.rglob("*.md") if "dist-info" not in str(f)):
        for _, words, target in pages.links(file.read_text(encoding="utf-8")):
            if not pages.is_external(target):
                count += 1
                where = target.partition("#")[0]
                assert not where or (file.parent / where).exists(), f"{file}: [{words}]({target}) leads nowhere"
    assert count > 20, count


def check_csharp(prefix):
    """The project finds what it reads where it is installed; without a .NET SDK nobody can ask it."""
    project = prefix / "share/ups/csharp/Ups.csproj"
    if not shutil.which("dotnet"):
        print("installed: no .NET SDK: Ups.csproj was not read")
        return
    asked = subprocess.run(["dotnet", "msbuild", project, "-getProperty:Version", "-getProperty:UpsLicense"],
                           capture_output=True, text=True, env={**os.environ, "DOTNET_NOLOGO": "1"})
    assert asked.returncode == 0, asked.stdout + asked.stderr
    told = json.loads(asked.stdout)["Properties"]
    assert re.fullmatch(r"\d+\.\d+\.\d+", told["Version"]) and Path(told["UpsLicense"]).exists(), told


def status_of(page):
    return page.read_text(encoding="utf-8").partition(".SH EXIT STATUS\n")[2]


def check_manual(prefix, build):
    program = build / "bin/ups"
    if not program.exists():
        return
    generator = ROOT / "src/tool/man/generate.py"
    subprocess.run([sys.executable, generator, program, "--check"], check=True)
    pages = {p.name for p in (prefix / "share/man/man1").iterdir()}
    assert pages == {p.name for p in generator.parent.glob("*.1")} and "ups.1" in pages, pages
    stopped = {p for p in pages if "the results so far" in status_of(prefix / "share/man/man1" / p)}
    assert stopped == {"ups.1", "ups-render.1", "ups-goniometer.1"}, stopped  # others end with nothing written


def main():
    prefix, libdir, build = Path(sys.argv[1]), sys.argv[2], Path(sys.argv[3])
    check_notices(prefix, libdir)
    check_sources(prefix)
    check_links(prefix)
    check_csharp(prefix)
    check_manual(prefix, build)


if __name__ == "__main__":
    main()
