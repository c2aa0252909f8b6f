#!/usr/bin/env python3
"""Does the ABI stay what it was? Run by ctest, a subcommand a question; and by hand to accept a change:

    tests/abi/check_abi.py layout --write        after a struct changed
    tests/abi/check_abi.py defaults --write --library LIBRARIES      after a default changed
    tests/abi/check_abi.py baseline --write      after any change; a breaking one also needs a new SONAME

LIBRARIES: libups.so and its extras, all of a build.

exports   the dynamic symbols of each library are the functions that its headers declare (those of libups stand in
          src/api/exports.txt, too), and all have the version of the SONAME
headers   every public header compiles alone, as strict C99 without hidden padding and as C++17
layout    size and offset of every struct and field, and the value of every enumerator, are those of layout.txt
defaults  every field of every *_desc that its *_init fills is that of defaults.txt
baseline  libabigail finds no difference to baseline.abi. It reads a library of empty functions made from the headers,
          types and signatures without any C++; `exports` ties the real library to the same headers. Exit code 77:
          skipped.
"""
import argparse
import difflib
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

HERE = Path(__file__).resolve().parent
ROOT = HERE.parent.parent
INCLUDE = ROOT / "include"
sys.path.insert(0, str(ROOT / "bindings"))
import c_header  # noqa: E402

SKIPPED = 77


def run(*command, cwd=None, env=None):
    done = subprocess.run([str(c) for c in command], capture_output=True, text=True, cwd=cwd, env=env)
    if done.returncode:
        sys.exit(f"{' '.join(map(str, command))}\n{done.stdout}{done.stderr}")
    return done.stdout


def compare(name, committed, found, advice):
    difference = list(difflib.unified_diff(committed, found, name, "now", lineterm=""))
    if difference:
        sys.exit("\n".join(difference) + f"\n{advice}")


def abi_version(api):
    """What programs and library must agree in: before 1.0 the minor version, too."""
    major, minor = api.version["MAJOR"], api.version["MINOR"]
    return f"0.{minor}" if major == 0 else str(major)


def soname(api, library="ups"):
    return f"lib{library}.so.{abi_version(api)}"


def symbol_version(api):
    return f"UPS_{abi_version(api)}"


# ---- exports


def read_api():
    return c_header.parse_headers(INCLUDE / "ups", c_header.ALL_HEADERS)


def library_of(function):
    return Path(function.header).stem if function.header in c_header.EXTRA_HEADERS else "ups"


def check_library(library, declared, version):
    symbols, unversioned = set(), set()
    for line in run("nm", "-D", "--defined-only", "--format=posix", library).splitlines():
        name, kind = line.split()[:2]
        if kind != "A":  # the names of symbol versions
            symbols.add(name.split("@")[0])
            if name.split("@")[-1] != version:
                unversioned.add(name)
    compare("headers", sorted(declared), sorted(symbols), f"{library} exports something else.")
    if unversioned:
        sys.exit(f"{library}: not of version {version}: {' '.join(sorted(unversioned))}")
    print(f"{library}: {len(symbols)} functions are declared and exported")


def check_exports(arguments):
    api = read_api()
    listed = (ROOT / "src/api/exports.txt").read_text(encoding="utf-8").split()
    if len(set(listed)) != len(listed):
        sys.exit("src/api/exports.txt lists a function twice")
    compare("src/api/exports.txt", sorted(listed), sorted(f.name for f in api.functions if library_of(f) == "ups"),
            "The headers declare something else.")
    for library in map(Path, arguments.library):
        name = library.name.removeprefix("lib").split(".")[0]
        check_library(library, [f.name for f in api.functions if library_of(f) == name], symbol_version(api))


# ---- headers


def check_headers(arguments):
    c = [arguments.cc, "-std=c99", "-pedantic", "-Wall", "-Wextra", "-Wstrict-prototypes", "-Wpadded"]
    cxx = [arguments.cxx, "-std=c++17", "-pedantic", "-Wall", "-Wextra"]
    headers = sorted((INCLUDE / "ups").glob("*.h"))
    with tempfile.TemporaryDirectory() as folder:
        for header in headers:
            for compiler, suffix in ((c, "c"), (cxx, "cpp")):
                source = Path(folder, f"{header.stem}.{suffix}")
                source.write_text(f"#include <ups/{header.name}>\nextern int ups_not_empty;\n")
                run(*compiler, "-Werror", "-I", INCLUDE, "-c", source, "-o", source.with_suffix(".o"))
    print(f"{len(headers)} headers compile alone as C99 and as C++17")


# ---- layout


def inclusions(include):
    """Of ups.h and the extras' headers there."""
    extras = [name for name in c_header.EXTRA_HEADERS if Path(include, "ups", name).exists()]
    return [f"#include <ups/{name}>" for name in ("ups.h", *extras)]


def measure_layout(cc, api, include):
    """A line for each struct with its size, field with its offset and size, enumerator with its value."""
    lines = ["#include <stdio.h>", *inclusions(include), "int main(void) {"]
    for s in api.structs:
        lines.append(f'printf("{s.name} %zu\\n", sizeof({s.name}));')
        for f in s.fields:
            lines.append(f'printf("  {f.name} %zu %zu\\n", offsetof({s.name}, {f.name}), '
                         f'sizeof((({s.name} *)0)->{f.name}));')
    for e in api.enums:
        lines += [f'printf("{name} %d\\n", (int){name});' for name, _ in e.members]
    lines.append("return 0; }")
    with tempfile.TemporaryDirectory() as folder:
        source = Path(folder, "layout.c")
        source.write_text("\n".join(lines))
        run(cc, "-std=c99", "-I", include, source, "-o", source.with_suffix(""))
        return run(source.with_suffix("")).splitlines()


def check_layout(arguments):
    found = measure_layout(arguments.cc, read_api(), INCLUDE)
    if arguments.write:
        (HERE / "layout.txt").write_text("\n".join(found) + "\n")
        return
    committed = (HERE / "layout.txt").read_text().splitlines()
    compare("tests/abi/layout.txt", committed, found,
            "The layout changed. A field at the end of a *_desc or *_info is compatible, a new enumerator too;\n"
            "anything else breaks programs. To accept: tests/abi/check_abi.py layout --write")
    print(f"{len(found)} sizes, offsets and values are those of layout.txt")


# ---- defaults


def default_lines(api, struct):
    """C that prints the fields of the variable d, a line each; the elements of an array in one."""
    for field in struct.fields[1:]:
        kind = api.aliases.get(field.type.name, field.type.name)
        index = "[i]" if field.type.count else ""
        value = f"d.{field.name}{index}"
        if field.type.pointers:
            pattern, value = "%s", f'{value} ? "set" : "NULL"'
        elif kind in ("float", "double"):
            pattern, value = ("%.9g" if kind == "float" else "%.17g"), f"(double){value}"
        elif api.struct(kind):
            pattern, value = "%u", f"(unsigned){value}.v"
        else:
            sign = "unsigned " if kind[0] in "us" else ""  # uint32_t, size_t
            pattern, value = "%llu" if sign else "%lld", f"({sign}long long){value}"
        yield f'  printf("  {field.name}");'
        yield f'  for (int i = 0; i < {max(1, field.type.count)}; ++i) printf(" {pattern}", {value});'
        yield '  printf("\\n");'


def measure_defaults(arguments):
    api = read_api()
    lines = ["#include <stdio.h>", *inclusions(INCLUDE), "int main(void) {"]
    for f in api.functions:
        if f.name.endswith("_init"):
            struct = api.struct(f.parameters[0].type.name)
            lines += [f"{{ {struct.name} d;", f"  {f.name}(&d, sizeof d);", f'  puts("{struct.name}");',
                      *default_lines(api, struct), "}"]
    lines.append("return 0; }")
    libraries = [Path(library).resolve() for library in arguments.library]
    with tempfile.TemporaryDirectory() as folder:
        source = Path(folder, "defaults.c")
        source.write_text("\n".join(lines))
        run(arguments.cc, "-std=c99", *arguments.flags.split(), "-I", INCLUDE, source, *libraries,
            *(f"-Wl,-rpath,{library.parent}" for library in libraries), "-o", source.with_suffix(""))
        return run(source.with_suffix("")).splitlines()


def check_defaults(arguments):
    found = measure_defaults(arguments)
    if arguments.write:
        (HERE / "defaults.txt").write_text("\n".join(found) + "\n")
        return
    compare("tests/abi/defaults.txt", (HERE / "defaults.txt").read_text().splitlines(), found,
            "Defaults changed, by which programs get other results without being compiled anew.\n"
            "To accept: tests/abi/check_abi.py defaults --write --library LIBRARIES")
    print(f"{len(found)} structs and defaults are those of defaults.txt")


# ---- baseline


def declaration(v):
    star = f"{v.type.name} {'*' * v.type.pointers}{v.name}" + (f"[{v.type.count}]" if v.type.count else "")
    return "const " + star if v.type.const else star


def build_empty_library(cc, functions, include, folder, name="ups", soname=None):
    lines = inclusions(include)
    for f in functions:
        returns = declaration(c_header.Variable(f.name, f.returns))
        parameters = ", ".join(map(declaration, f.parameters)) or "void"
        body = "" if f.returns == c_header.Type("void", False, 0, 0) else "return 0; "
        lines.append(f"{returns}({parameters}) {{ {body}}}")
    Path(folder, f"{name}.c").write_text("\n".join(lines) + "\n")
    called = [f"-Wl,-soname,{soname}"] if soname else []
    run(cc, "-std=c99", "-g", "-w", "-shared", "-fPIC", *called, "-I", include, f"{name}.c", "-o", f"lib{name}.so",
        cwd=folder)
    return Path(folder, f"lib{name}.so")


def check_baseline(arguments):
    if not shutil.which("abidw") or not shutil.which("abidiff"):
        print("skipped: abidw and abidiff are not installed (Debian's package abigail-tools)")
        sys.exit(SKIPPED)
    baseline = HERE / "baseline.abi"
    with tempfile.TemporaryDirectory() as folder:
        library = build_empty_library(arguments.cc, read_api().functions, INCLUDE, folder)
        if arguments.write:
            run("abidw", "--no-show-locs", "--no-corpus-path", "--no-comp-dir-path", "--no-architecture", library,
                "--out-file", baseline)
            return
        done = subprocess.run(["abidiff", "--no-architecture", baseline, library], capture_output=True, text=True)
    if done.returncode:  # a bit set: 1 and 2 errors, 4 a change, 8 a change that surely breaks programs
        sys.exit(f"{done.stdout}{done.stderr}\nabidiff: exit code {done.returncode}. New functions and fields at the "
                 "end of a *_desc or *_info are compatible;\nanything else breaks programs and needs a new SONAME. "
                 "To accept: tests/abi/check_abi.py baseline --write")
    print("libabigail finds no difference to baseline.abi")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("question", choices=("exports", "headers", "layout", "defaults", "baseline"))
    parser.add_argument("--library", nargs="+", help="libups.so and its extras, for exports and defaults")
    parser.add_argument("--cc", default="cc", help="C compiler")
    parser.add_argument("--cxx", default="c++", help="C++ compiler")
    parser.add_argument("--flags", default="", help="of the C compiler for programs that use the library")
    parser.add_argument("--write", action="store_true", help="layout, defaults, baseline: write the committed file")
    arguments = parser.parse_args()
    globals()["check_" + arguments.question](arguments)


if __name__ == "__main__":
    main()
