#!/usr/bin/env python3
"""Does every source file compile for Windows? By MinGW-w64 and -fsyntax-only, against the dependencies' own headers;
nothing is linked or run. Called by ctest: windows.py BUILD_FOLDER, which has compile_commands.json. By hand:

    tests/portable/windows.py build/release --apart [FILE...]     each file (or these) by itself, with all warnings;
                                                                  some minutes

A compiler run costs a second for the headers alone, so many files are one: what they define without linkage under the
same name would collide, so such files are in different ones. Where one fails, its files are compiled apart, and what
fails then is told. Beside the sources: the public headers as C99, C++ and C++17, and whether each struct of theirs has
the layout there that tests/abi/layout.txt tells.
"""
import argparse
import concurrent.futures
import json
import re
import shlex
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
INCLUDE = ROOT / "include"
COMPILERS = ("x86_64-w64-mingw32-g++-posix", "x86_64-w64-mingw32-g++")  # std::thread needs the first's threads
SYSTEM_INCLUDE = [Path("/usr/local/include"), Path("/usr/include")]  # of which these alone are not of the host's:
DEPENDENCIES = ("embree3", "embree4", "oneapi", "tbb", "OpenEXR", "Imath", "OpenColorIO", "tiny_gltf.h", "nlohmann", "CLI")
WARNINGS = ["-Wall", "-Wextra", "-Wshadow", "-Wno-missing-field-initializers", "-Werror"]


def compiler_found():
    for name in COMPILERS:
        if shutil.which(name):
            return name
    sys.exit(f"There is no {COMPILERS[0]}, by which this test compiles for Windows: samples/setup.sh test installs it "
             "(Debian, Ubuntu: g++-mingw-w64-x86-64-posix)")


def sources():
    files = [f for folder in ("photometry", "src") for f in sorted((ROOT / folder).rglob("*.cpp"))]
    others = {ROOT / "src/platform" / system for system in ("linux", "macos", "posix")}
    return [f for f in files if not others & set(f.parents)]


def flags_of_sources(build):
    """By file: its definitions, and the folders of headers, from how the build compiles it here."""
    commands = {Path(c["file"]): shlex.split(c["command"]) for c in json.loads((build / "compile_commands.json").read_text())}
    flags = {}
    for file in sources():
        known = ROOT / "src/platform/paths.cpp" if "windows" in file.parts else file
        if known not in commands:
            sys.exit(f"{file} is not in {build}/compile_commands.json: configure with all extras and the program")
        words = commands[known]
        definitions = tuple(w for w in words if w.startswith("-D") and not w.endswith("_EXPORTS") and w != "-DNDEBUG")
        folders = [w[2:] for w in words if w.startswith("-I")] + [b for a, b in zip(words, words[1:]) if a == "-isystem"]
        flags[file] = definitions, folders
    return flags


def include_flags(all_folders, work):
    """Ours first; of the dependencies no folder that has the host's C library, too."""
    own = [f for f in all_folders if Path(f).is_relative_to(ROOT)]
    theirs = [f for f in all_folders if f not in own and Path(f) not in SYSTEM_INCLUDE]
    links = work / "dependencies"
    links.mkdir()
    for name in DEPENDENCIES:
        found = next((place / name for place in SYSTEM_INCLUDE if (place / name).exists()), None)
        if found:
            (links / name).symlink_to(found)
    return [f"-I{f}" for f in own] + [word for f in [links, *theirs] for word in ("-isystem", str(f))]


class Compiler:
    def __init__(self, name, work):
        self.name, self.work, self.includes = name, work, [f"-I{INCLUDE}"]

    def errors(self, text_or_file, *flags, language="c++"):
        """What it says; empty where it compiles."""
        name = self.name.replace("g++", "gcc") if language == "c" else self.name
        is_file = isinstance(text_or_file, Path)
        command = [name, "-x", language, "-fsyntax-only", "-ffp-contract=off", *self.includes, *flags,
                   str(text_or_file) if is_file else "-"]
        done = subprocess.run(command, input=None if is_file else text_or_file, capture_output=True, text=True)
        return done.stderr if done.returncode else ""


def names_without_linkage(text):
    """(namespace, name) of what stands in unnamed namespaces, roughly."""
    names, spaces = set(), []
    for line in text.splitlines():
        if re.match(r"namespace\b[^;=]*\{$", line):
            spaces.append(line)
        elif line.startswith("}  // namespace"):
            spaces = spaces[:-1]
        elif "namespace {" in spaces and re.match(r"[A-Za-z\[]", line) and not line.startswith(("template", "using namespace")):
            head = re.split(r"[({=;\[]", re.sub(r"\[\[.*?\]\]", "", line))[0]
            words = re.findall(r"\w+", head.split(" : ")[0])
            if words:
                names.add(("".join(spaces), words[-1]))
    return names


def without_repeated_lines(text, seen):
    """Constants that several files define alike stay in the first."""
    lines, spaces = [], []
    for line in text.splitlines():
        if re.match(r"namespace\b[^;=]*\{$", line):
            spaces.append(line)
        elif line.startswith("}  // namespace"):
            spaces = spaces[:-1]
        if re.match(r"(constexpr|using) [^(){}]*;", line) and spaces:
            key = "".join(spaces), line.split("//")[0].strip()
            if key in seen:
                line = ""
            seen.add(key)
        lines.append(line)
    return "\n".join(lines) + "\n"


def bundles(files):
    """Lists of (file, text) without collisions."""
    out = []
    for file in files:
        text = file.read_text()
        for bundle in out:
            seen = set(bundle["seen"])
            rest = without_repeated_lines(text, seen)
            names = names_without_linkage(rest)
            if not names & bundle["names"]:
                bundle.update(seen=seen, names=bundle["names"] | names, files=bundle["files"] + [(file, rest)])
                break
        else:
            seen = set()
            rest = without_repeated_lines(text, seen)
            out.append({"seen": seen, "names": names_without_linkage(rest), "files": [(file, rest)]})
    return [b["files"] for b in out]


def check_bundle(compiler, definitions, bundle):
    """Failures of its files. Those that it names are tried again without the others, at last each by itself."""
    text = "".join(f'#line 1 "{file}"\n{rest}' for file, rest in bundle)
    said = compiler.errors(text, "-std=c++20", *definitions)
    if not said:
        return {}
    named = [file for file, _ in bundle if re.search(rf"^{re.escape(str(file))}:\d+:\d+: (fatal )?error", said, re.M)]
    if 1 < len(named) < len(bundle):
        return check_bundle(compiler, definitions, [(file, file.read_text()) for file in named])
    errors = {file: compiler.errors(file, "-std=c++20", *definitions) for file in named or [file for file, _ in bundle]}
    return {file: text for file, text in errors.items() if text}


def check_sources(compiler, flags, jobs):
    groups = {}
    for file, (definitions, _) in flags.items():  # apart: what has names of its own for the same, and <windows.h>
        place = next((p for p in ("photometry", "platform", "extras", "tool") if p in file.relative_to(ROOT).parts), "core")
        groups.setdefault((place, definitions), []).append(file)
    failures = {}
    with concurrent.futures.ThreadPoolExecutor(jobs) as pool:
        runs = [pool.submit(check_bundle, compiler, definitions, bundle)
                for (_, definitions), files in groups.items() for bundle in bundles(files)]
        for run in runs:
            failures.update(run.result())
    print(f"{len(flags)} source files in {len(runs)} runs of the compiler")
    return failures


def check_apart(compiler, flags, jobs):
    with concurrent.futures.ThreadPoolExecutor(jobs) as pool:
        errors = dict(zip(flags, pool.map(
            lambda f: compiler.errors(f, "-std=c++20", "-O1", *WARNINGS, *flags[f][0]), flags)))
    print(f"{len(flags)} source files, each by itself")
    return {file: text for file, text in errors.items() if text}


def layout_text():
    """A C program that compiles where the layout is the committed one."""
    lines, struct = ["#include <stddef.h>"], None
    lines += [f"#include <ups/{h.name}>" for h in sorted((INCLUDE / "ups").glob("*.h"))]
    for line in (ROOT / "tests/abi/layout.txt").read_text().splitlines():
        name, *numbers = line.split()
        if line.startswith("  "):
            lines += [f'_Static_assert(offsetof({struct}, {name}) == {numbers[0]}, "{struct}.{name}");',
                      f'_Static_assert(sizeof((({struct}*)0)->{name}) == {numbers[1]}, "{struct}.{name}");']
        elif name.startswith("ups_"):
            struct = name
            lines.append(f'_Static_assert(sizeof({name}) == {numbers[0]}, "{name}");')
        else:
            lines.append(f'_Static_assert({name} == {numbers[0]}, "{name}");')
    return "\n".join(lines) + "\n", len(lines)


def check_headers(compiler):
    failures = {}
    strict = ("-Wall", "-Wextra", "-Wpedantic", "-Werror")
    headers = sorted((INCLUDE / "ups").glob("*.h"))
    for header in headers:
        include = f"#include <ups/{header.name}>\n"
        for library in ((), ("-DUPS_BUILD",), ("-DUPS_STATIC",)):
            failures[f"{header.name} as C99 {library}"] = compiler.errors(include, "-std=c99", *strict, *library, language="c")
        failures[f"{header.name} as C++"] = compiler.errors(include, "-std=c++11", *strict)
    classes = sorted((INCLUDE / "ups").rglob("*.hpp"))
    everything = "".join(f"#include <{header.relative_to(INCLUDE)}>\n" for header in classes)
    failures["the headers of C++17"] = compiler.errors(everything, "-std=c++17", *strict)
    text, count = layout_text()
    failures["layout.txt"] = compiler.errors(text, "-std=c11", language="c")
    print(f"{len(headers)} headers of C, {len(classes)} of C++, {count} facts of their layout")
    return {name: text for name, text in failures.items() if text}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build", type=Path)
    parser.add_argument("files", type=Path, nargs="*")
    parser.add_argument("--apart", action="store_true")
    parser.add_argument("--jobs", type=int, default=1)
    options = parser.parse_args()
    name = compiler_found()
    flags = flags_of_sources(options.build)
    with tempfile.TemporaryDirectory() as folder:
        compiler = Compiler(name, Path(folder))
        failures = check_headers(compiler)
        compiler.includes = include_flags(list(dict.fromkeys(f for _, fs in flags.values() for f in fs)), Path(folder))
        wanted = {f.resolve() for f in options.files}
        if wanted:
            flags = {f: v for f, v in flags.items() if f in wanted}
        failures |= (check_apart if options.apart else check_sources)(compiler, flags, options.jobs)
    for name, text in failures.items():
        print(f"\n{name} does not compile for Windows:\n{text}")
    sys.exit(1 if failures else 0)


if __name__ == "__main__":
    main()
