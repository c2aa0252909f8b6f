#!/usr/bin/env python3
"""What does an edit save a program? Counts it in the samples that edit a scene, one in each language, and compares with
the table in link_it_in_an_hour.md. Run by ctest:

    edits.py [--cc CC] [--write] LIBRARY LANGUAGE=COMMAND...     a sample: its first word a program, mono or python

Lines are those between [anew] and [end] that hold more than a remark. Calls are those of the library that have a status,
counted by one that stands before it: from the render before to the commit.
"""
import argparse
import os
import re
import shlex
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT / "bindings"), str(ROOT / "tests" / "abi"), str(ROOT / "tests" / "support")]
from c_header import CORE_HEADERS, parse_headers  # noqa: E402
from check_abi import declaration, inclusions, run  # noqa: E402
from preload import preloaded  # noqa: E402

GUIDE = ROOT / "samples" / "docs" / "link_it_in_an_hour.md"
SOURCES = {"C": "c/edits.c", "C++": "cpp/edits.cpp", "Python": "python/edits.py", "C#": "csharp/Edits.cs"}
EDITS = ["move", "dim", "aim", "remove"]

START = r"""
#include <dlfcn.h>
#include <stdio.h>
#include <stdlib.h>

static void *real_of(const char *name) {
  static void *library;
  if (!library) library = dlopen(getenv("UPS_REAL"), RTLD_NOW | RTLD_LOCAL);
  void *found = library ? dlsym(library, name) : NULL;
  if (!found) fprintf(stderr, "%s\n", dlerror()), abort();
  return found;
}
static void note(const char *name) {
  FILE *calls = fopen(getenv("UPS_CALLS"), "a");
  if (!calls || fprintf(calls, "%s\n", name) < 0 || fclose(calls)) abort();
}
"""


def forward(function):
    parameters = ", ".join(map(declaration, function.parameters)) or "void"
    returns = f"{'const ' * function.returns.const}{function.returns.name} {'*' * function.returns.pointers}"
    call = f"real({', '.join(p.name for p in function.parameters)})"
    has_status = function.returns.name == "ups_status"
    return (f"{returns}{function.name}({parameters}) {{\n  static {returns}(*real)({parameters});\n"
            f'  if (!real) *(void **)&real = real_of("{function.name}");\n'
            + (f'  note("{function.name}");\n' if has_status else "")
            + f"  {'' if returns.strip() == 'void' else 'return '}{call};\n}}\n")


def build_counter(cc, library, folder):
    """A libups of all names that programs and bindings look for."""
    functions = parse_headers(ROOT / "include" / "ups", CORE_HEADERS).functions
    source = Path(folder, "counter.c")
    source.write_text("\n".join(inclusions(ROOT / "include")) + START + "".join(map(forward, functions)))
    counter = Path(folder, "libups.so")
    run(cc, "-std=c99", "-D_GNU_SOURCE", "-w", "-shared", "-fPIC", "-I", ROOT / "include", source, "-o", counter)
    for name in {library.name, re.sub(r"(\.so\.\d+\.\d+).*", r"\1", library.resolve().name)} - {"libups.so"}:
        Path(folder, name).symlink_to("libups.so")
    return counter


def count_calls(command, counter, library, folder):
    """Of each edit, and of all that is described anew: the sample does one after the other, and renders after each."""
    calls = Path(folder, "calls")
    calls.unlink(missing_ok=True)
    environment = dict(os.environ, UPS_REAL=str(library), UPS_CALLS=str(calls), UPS_LIBRARY=str(counter),
                       PYTHONPATH=str(ROOT / "bindings" / "python"), PYTHONDONTWRITEBYTECODE="1")
    words = shlex.split(command)
    if len(words) > 1:
        environment["LD_LIBRARY_PATH"] = folder
    else:
        environment["LD_PRELOAD"] = preloaded(counter)["LD_PRELOAD"]
    run(*words, env=environment)
    names = calls.read_text().split()
    commits = [i for i, name in enumerate(names) if name == "ups_scene_commit"]
    if len(commits) != 1 + 2 * len(EDITS):
        sys.exit(f"{command}: {len(commits)} commits, not one and two for each edit")
    of_renders = ("ups_render", "ups_job", "ups_result")
    units = [sum(not name.startswith(of_renders) for name in names[a + 1:b + 1]) for a, b in zip(commits, commits[1:])]
    return units[0::2], units[1::2]


def count_lines(source):
    text = (ROOT / "samples" / source).read_text(encoding="utf-8")
    regions = re.findall(r"\[anew\][^\n]*\n(.*?)\[end\]", text, re.DOTALL)
    if not regions:
        sys.exit(f"{source}: no [anew] with its [end]")
    remark = re.compile(r'^\s*(//.*|#.*|/\*.*|""".*"""|)\s*$')
    return sum(not remark.match(line) for region in regions for line in region.splitlines())


def of_each(counts):
    """18, 18, 18, 17: "18, 17 to remove"; the same for all: one number."""
    usual = counts[0]
    others = [f"{n} to {edit}" for edit, n in zip(EDITS, counts) if n != usual]
    return ", ".join([str(usual), *others])


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("library", type=Path)
    parser.add_argument("samples", nargs="+", metavar="LANGUAGE=COMMAND")
    parser.add_argument("--cc", default="cc", help="C compiler")
    parser.add_argument("--write", action="store_true", help="write the table")
    arguments = parser.parse_args()
    rows = ["| | lines that describe the room | calls to describe it | calls of an edit |", "|---|---|---|---|"]
    with tempfile.TemporaryDirectory() as folder:
        counter = build_counter(arguments.cc, arguments.library, folder)
        for sample in arguments.samples:
            language, command = sample.split("=", 1)
            edit, anew = count_calls(command, counter, arguments.library.resolve(), folder)
            rows.append(f"| {language} | {count_lines(SOURCES[language])} | {of_each(anew)} | {of_each(edit)} |")
    table = "\n".join(rows)
    guide = GUIDE.read_text(encoding="utf-8")
    there = re.search(r"(?:^\|.*\n)+", guide[guide.index("## Edits\n"):guide.index("## Threads\n")], re.MULTILINE)
    if not there:
        sys.exit(f"{GUIDE.name} has no table under Edits")
    if arguments.write:
        GUIDE.write_text(guide.replace(there[0], table + "\n"), encoding="utf-8")
    elif there[0] != table + "\n":
        sys.exit(f"{GUIDE.name} has\n{there[0]}and the samples make it\n{table}\n--write writes that")
    print(table)


if __name__ == "__main__":
    main()
