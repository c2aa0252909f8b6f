#!/usr/bin/env python3
"""Does each check of the ABI notice what it is there for? Run by ctest: check_red.py --library LIBRARIES [--cc CC]

In a scratch copy of the headers and the checks one thing is changed at a time, in a header, in the list of exports or
in what the library does; the checks that have to fail must, and say why. That they pass without is what they are run for
by themselves.
"""
import argparse
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "support"))
import check_abi  # noqa: E402
from check_abi import c_header  # noqa: E402
from preload import preloaded  # noqa: E402

ROOT = check_abi.ROOT


class Scratch:
    """What the checks read, to be changed; the library, whose behaviour a preloaded one can change."""

    def __init__(self, folder, arguments):
        self.root, self.cc, self.flags = Path(folder), arguments.cc, arguments.flags
        self.libraries = [Path(library).resolve() for library in arguments.library]
        for part in ("include", "tests/abi"):
            shutil.copytree(ROOT / part, self.root / part, ignore=shutil.ignore_patterns("__pycache__"))
        for part in ("bindings/c_header.py", "src/api/exports.txt"):
            (self.root / part).parent.mkdir(parents=True)
            shutil.copy(ROOT / part, self.root / part)

    def ask(self, question, library=None, before=()):
        """(whether it passed, what it said); `before`: libraries that stand before all others."""
        program = "check_clients.py" if question in ("released", "clients") else "check_abi.py"
        libraries = [library] if library else self.libraries
        command = [sys.executable, self.root / "tests/abi" / program, question, "--cc", self.cc,
                   f"--flags={self.flags}", "--library", *libraries]
        done = subprocess.run(command, capture_output=True, text=True, env=preloaded(*before))
        return done.returncode, done.stdout + done.stderr

    def edit(self, name, old, new):
        file = self.root / name
        text = file.read_text(encoding="utf-8")
        assert text.count(old) == 1, f"{name} has {old!r} {text.count(old)} times"
        file.write_text(text.replace(old, new), encoding="utf-8")

    def shim(self, body):
        """A library that stands before this one and changes what ups_render_desc_init leaves."""
        source = self.root / "shim.c"
        source.write_text(f"""#define _GNU_SOURCE
#include <dlfcn.h>
#include <ups/ups.h>
void ups_render_desc_init(ups_render_desc *desc, uint32_t struct_size) {{
  void (*real)(ups_render_desc *, uint32_t) =
      (void (*)(ups_render_desc *, uint32_t))dlsym(RTLD_NEXT, "ups_render_desc_init");
  real(desc, struct_size);
  {body}
}}
""")
        check_abi.run(self.cc, "-shared", "-fPIC", "-w", "-I", check_abi.INCLUDE, source, "-o", self.root / "shim.so")
        return self.root / "shim.so"

    def unversioned(self):
        functions = c_header.parse_headers(check_abi.INCLUDE / "ups").functions
        folder = self.root / "unversioned"
        folder.mkdir()
        return check_abi.build_empty_library(self.cc, functions, check_abi.INCLUDE, folder)


OBSERVER = "typedef struct ups_observer_desc {\n  uint32_t struct_size;\n"
READING = "} ups_meter_part_reading;"
VERSION = "UPS_API uint32_t ups_version(void);\n"
NAME = "UPS_API const char *ups_status_name(ups_status status);\n"
IMPORT = "typedef struct ups_gltf_import_desc {\n  uint32_t struct_size;\n"
EXR_ERROR = "UPS_API const char *ups_exr_last_error(void);\n"
BASE, RENDER, GLARE = "include/ups/ups_base.h", "include/ups/ups_render.h", "include/ups/ups_glare.h"
GLTF, EXR = "include/ups/ups_gltf.h", "include/ups/ups_exr.h"

# What is changed, how, and what each check that has to notice says of it.
CHANGES = {
    "a field in the middle of a struct": (
        lambda s: s.edit(GLARE, OBSERVER, OBSERVER + "  float invented[2];\n"),
        {"layout": "invented", "released": "ups_observer_desc.to_world", "baseline": "invented"}),
    "a field in the middle of a struct of an extra": (
        lambda s: s.edit(GLTF, IMPORT, IMPORT + "  float invented[2];\n"),
        {"layout": "invented", "released": "ups_gltf_import_desc", "baseline": "invented"}),
    "a function that an extra does not have": (
        lambda s: s.edit(EXR, EXR_ERROR, EXR_ERROR + "UPS_API uint32_t ups_exr_vision(void);\n"),
        {"exports": "exports something else"}),
    "hidden padding in a struct": (
        lambda s: s.edit(GLARE, OBSERVER, OBSERVER + "  float invented;\n"), {"headers": "padding struct"}),
    "an element of arrays that grows": (
        lambda s: s.edit(RENDER, READING, "  float invented;\n" + READING),
        {"layout": "invented", "released": "ups_meter_part_reading had 16 bytes", "baseline": "invented"}),
    "another value of an enumerator": (
        lambda s: s.edit(BASE, "UPS_TIMEOUT = 1,", "UPS_TIMEOUT = 3,"),
        {"layout": "UPS_TIMEOUT 3", "released": "UPS_TIMEOUT was 1, is 3"}),
    "another type of a parameter": (
        lambda s: s.edit(BASE, NAME, NAME.replace("ups_status status", "int64_t status")),
        {"released": "ups_status_name has another signature", "baseline": "ups_status_name"}),
    "a function that is not declared any more": (
        lambda s: s.edit(BASE, VERSION, ""),
        {"exports": "-ups_version", "released": "ups_version", "baseline": "ups_version"}),
    "a function that the library does not have": (
        lambda s: (s.edit(BASE, VERSION, VERSION + "UPS_API uint32_t ups_vision(void);\n"),
                   s.edit("src/api/exports.txt", "ups_version\n", "ups_version\nups_vision\n")),
        {"exports": "exports something else"}),
    "a function that is not listed": (
        lambda s: s.edit("src/api/exports.txt", "ups_version\n", ""), {"exports": "ups_version"}),
}
# What the library does otherwise: (the library instead of it, or what is preloaded), and what notices.
BEHAVIOURS = {
    "another default": (lambda s: {"before": [s.shim("desc->target_relative_error = 0.125f;")]},
                        {"defaults": "+  target_relative_error 0.125"}),
    "more written than there is room for": (
        lambda s: {"before": [s.shim("((unsigned char *)desc)[struct_size] = 1;")]},
        {"clients": "ups_render_desc_init writes beyond struct_size"}),
    "symbols without a version": (lambda s: {"library": s.unversioned()}, {"exports": "not of version UPS_"}),
}


def expect(what, question, answer, words):
    code, said = answer
    if code == check_abi.SKIPPED:
        print(f"{what}: {question} cannot run here")
    elif code == 0:
        sys.exit(f"{what}: {question} did not notice")
    elif words not in said:
        sys.exit(f"{what}: {question} failed, but did not say {words!r}:\n{said}")
    else:
        print(f"{what}: {question} fails")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--library", nargs="+", required=True)
    parser.add_argument("--cc", default="cc")
    parser.add_argument("--flags", default="", help="of the compiler, such as the library's sanitizer")
    arguments = parser.parse_args()
    for what, (change, noticed) in (CHANGES | BEHAVIOURS).items():
        with tempfile.TemporaryDirectory() as folder:
            scratch = Scratch(folder, arguments)
            changed = change(scratch)
            instead = changed if what in BEHAVIOURS else {}
            for question, words in noticed.items():
                expect(what, question, scratch.ask(question, **instead), words)


if __name__ == "__main__":
    main()
