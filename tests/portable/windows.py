#!/usr/bin/env python3
"""Does every source file compile for Windows? By MinGW-w64 and -fsyntax-only, against the dependencies' own headers;
nothing is linked or run. Called by ctest: windows.py BUILD_FOLDER, which has compile_commands.json. By hand:

    tests/portable/windows.py build/release --apart [FILE...]     each file (or these) by itself, with all warnings;
                                                                  some minutes

A compiler run costs a second for the headers alone, so many files are one: what they define without linkage under the
same name is renamed. Where that fails, the files in which it does are tried without the others, and at last each by
itself: what fails then is told. Beside the sources: the public headers as C99, C++ and C++17, and whether each struct
of theirs has the layout there that tests/abi/layout.txt tells.
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
DEPENDENCIES = ("embree3", "embree4", "oneapi", "tbb", "OpenEXR", "Imath", "OpenColorIO", "tiny_gltf.h", "nlohmann",
                "CLI")
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
    commands = json.loads((build / "compile_commands.json").read_text())
    commands = {Path(c["file"]): shlex.split(c["command"]) for c in commands}
    flags = {}
    for file in sources():
        known = ROOT / "src/platform/paths.cpp" if "windows" in file.parts else file
        if known not in commands:
            sys.exit(f"{file} is not in {build}/compile_commands.json: configure with all extras and the program")
        words = commands[known]
        definitions = tuple(w for w in words if w.startswith("-D") and not w.endswith("_EXPORTS")
                            and w not in ("-DNDEBUG", "-DUPS_FLOAT_TRAPS"))
        folders = [w[2:] for w in words if w.startswith("-I")]
        folders += [after for word, after in zip(words, words[1:]) if word == "-isystem"]
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
        self.name, self.work, self.includes, self.runs = name, work, [f"-I{INCLUDE}"], 0

    def errors(self, text_or_file, *flags, language="c++"):
        """What it says; empty where it compiles."""
        name = self.name.replace("g++", "gcc") if language == "c" else self.name
        is_file = isinstance(text_or_file, Path)
        self.runs += 1
        command = [name, "-x", language, "-fsyntax-only", "-ffp-contract=off", *self.includes, *flags,
                   str(text_or_file) if is_file else "-"]
        done = subprocess.run(command, input=None if is_file else text_or_file, capture_output=True, text=True)
        return done.stderr if done.returncode else ""


def names_without_linkage(text):
    """Of what stands in unnamed namespaces, roughly."""
    names, spaces = set(), []
    for line in text.splitlines():
        if re.match(r"namespace\b[^;=]*\{$", line):
            spaces.append(line)
        elif line.startswith("}  // namespace"):
            spaces = spaces[:-1]
        elif "namespace {" in spaces and re.match(r"(?!template|static_assert|using [^=]*;)[A-Za-z\[]", line):
            head = re.split(r"[({=;\[]", re.sub(r"\[\[.*?\]\]", "", line))[0].split(" : ")[0].strip()
            constants = re.findall(r"(\w+)(?:\[\w*\])? = ", line) if line.startswith("const") else []
            found = constants or re.findall(r"(?<!::)\b\w+$", head)
            names.update(name for name in found if name != "void")
    return names


def as_one(files):
    """(file, text), where what has no linkage has a name of its file's own; members keep theirs."""
    out = []
    for number, file in enumerate(files):
        text = file.read_text()
        names = "|".join(sorted(names_without_linkage(text), key=len, reverse=True))
        if names:
            pattern, other = re.compile(rf"(?<![\w.>:])({names})\b"), rf"\1_of_{number}"
            lines = text.split("\n")
            text = "\n".join(s if s.startswith("#include") else pattern.sub(other, s) for s in lines)
        out.append((file, text))
    return out


def check_bundle(compiler, definitions, bundle):
    """Failures of its files. Those that it names are tried again without the others, at last each by itself; so
    are headers that it names."""
    text = "".join(f'#line 1 "{file}"\n{rest}' for file, rest in bundle)
    said = compiler.errors(text, "-std=c++20", *definitions)
    if not said:
        return {}
    places = {Path(place) for place in re.findall(r"^(/[^:]+):\d+:\d+: (?:fatal )?error", said, re.M)}
    named = [file for file, _ in bundle if file in places]
    if "fatal error" in said or not named:  # it stopped there, or does not tell where
        named = [file for file, _ in bundle]
    headers = places.difference(file for file, _ in bundle)
    errors = {header: compiler.errors(header, "-std=c++20", *definitions) for header in headers}
    if 1 < len(named) < len(bundle):
        errors |= check_bundle(compiler, definitions, as_one(named))
    else:
        errors |= {file: compiler.errors(file, "-std=c++20", *definitions) for file in named}
    return {file: text for file, text in errors.items() if text}


def check_sources(compiler, flags, jobs):
    all_definitions = dict.fromkeys(d for definitions, _ in flags.values() for d in definitions)
    upper = [f for f in flags if {"extras", "tool"} & set(f.parts)]  # has names of its own for what the core has
    core = sorted((f for f in flags if f not in upper), key=lambda f: "windows" in f.parts)  # <windows.h> comes last
    groups = [files for files in (core, upper) if files]
    failures = {}
    with concurrent.futures.ThreadPoolExecutor(jobs) as pool:
        runs = [pool.submit(check_bundle, compiler, tuple(all_definitions), as_one(files)) for files in groups]
        for run in runs:
            failures.update(run.result())
    print(f"{len(flags)} source files in {compiler.runs} runs of the compiler")
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
            said = compiler.errors(include, "-std=c99", *strict, *library, language="c")
            failures[f"{header.name} as C99 {library}"] = said
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
