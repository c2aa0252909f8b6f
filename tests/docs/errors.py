#!/usr/bin/env python3
"""Are the errors true that the documentation derives from parameters? Run by ctest: errors.py [--cc CC] EXAMPLE...

A library that stands before libups and its extras is made from the headers: after each call of an example that went
well it makes the same call with one argument spoiled, for each fault that the function's page names, and looks at the
status, at the message and at the outputs, which must be as they were. Every fault has to be tried in some example.
"""
import argparse
import os
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT / "bindings"), str(ROOT / "samples" / "docs"), str(ROOT / "tests" / "abi"),
                str(ROOT / "tests" / "support")]
import rules  # noqa: E402
from check_abi import declaration, inclusions, library_of, read_api, run  # noqa: E402
from preload import preloaded  # noqa: E402

# What no call of an example can be followed by.
NOT_TRIED = {"ups_context_pop_log capacity small": "the call before took the message"}

START = r"""
#include <dlfcn.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static int failures;
static FILE *tried;

static void expect(const char *what, ups_status status, ups_status wanted, const char *message, int changed) {
  if (!tried) tried = fopen(getenv("UPS_TRIED"), "a");
  fprintf(tried, "%s\n", what);
  if (status == wanted && message[0] && !changed) return;
  ++failures;
  fprintf(stderr, "%s: status %d instead of %d, message \"%s\"%s\n", what, (int)status, (int)wanted, message,
          changed ? ", an output was touched" : "");
}

__attribute__((destructor)) static void end(void) {
  if (tried) fclose(tried);
  if (failures) _exit(3);
}
"""


def names_of(function):
    """What is tried of a function: a word for each fault of its page."""
    faults = [f"{p.name} {kind}" for p, kind, _ in rules.faults(function)]
    names = [p.name for p in function.parameters]
    if "capacity" in names:
        faults.append("capacity small")
    if any(p.type.name.endswith("_desc") and p.type.const for p in function.parameters):
        faults.append("desc later")
    return faults


class Wrapper:
    """The C of one function that stands before the library's."""

    def __init__(self, function):
        self.f, self.last_error = function, f"{library_of(function)}_last_error"
        names = [p.name for p in function.parameters]
        self.outputs = [] if "capacity" in names else [
            p for p in function.parameters
            if p.type.pointers and not p.type.const and not (p.type.name in rules.HANDLES and p.type.pointers == 1)
            and p.type.name != "void"]

    def call(self, **instead):
        return f"real({', '.join(instead.get(p.name, p.name) for p in self.f.parameters)})"

    def attempt(self, what, call, wanted="INVALID_ARGUMENT", before="", after=""):
        """Between them the outputs are compared; one that is itself replaced is as it was in any case."""
        keep = "".join(f"unsigned char was_{o.name}[sizeof *{o.name}]; "
                       f"if ({o.name}) memcpy(was_{o.name}, {o.name}, sizeof *{o.name}); " for o in self.outputs)
        changed = " || ".join(f"({o.name} && memcmp(was_{o.name}, {o.name}, sizeof *{o.name}))" for o in self.outputs)
        return (f"  {{ {before}{keep}ups_status s = {call}; {after}\n"
                f'    expect("{self.f.name} {what}", s, UPS_ERROR_{wanted}, {self.last_error}(), {changed or 0}); }}\n')

    def fault(self, p, kind):
        t, what = p.type, f"{p.name} {kind}"
        if kind == "null":
            yield self.attempt(what, self.call(**{p.name: "NULL"}))
        elif kind == "id":
            for number in ("0", "0x7fffffff"):
                yield self.attempt(what, self.call(**{p.name: f"({t.name}){{{number}}}"}))
        elif kind in ("desc", "size"):
            # A description may be NULL where that means all defaults; an output has its own first field.
            yield f"  if ({p.name}) {{ {t.name} copy; memcpy(&copy, {p.name}, sizeof copy); copy.struct_size = 0;\n"
            yield self.attempt(what, self.call(**{p.name: "&copy"})) + "  }\n"
        elif kind == "memory":
            yield self.attempt(what, self.call(capacity="1", **{self.memory().name: "NULL"}))
        elif kind == "index":
            yield self.attempt(what, self.call(**{p.name: f"({t.name})-1"}))

    def memory(self):
        names = [p.name for p in self.f.parameters]
        return self.f.parameters[names.index("capacity") - 1]

    def too_small(self):
        m = self.memory()
        size = "1" if m.type.name == "void" else f"sizeof *{m.name}"
        before = f"void *some = malloc(all * {size}); "
        size_alone = self.call(capacity="0", needed="&all", **{m.name: "NULL"})
        return (f"  {{ size_t all = 0; if ({size_alone} == UPS_OK && all > 1)\n"
                + self.attempt("capacity small", self.call(capacity="all - 1", **{m.name: "some"}), "BUFFER_TOO_SMALL",
                               before, "free(some);") + "  }\n")

    def later(self):
        p = next(p for p in self.f.parameters if p.type.name.endswith("_desc") and p.type.const)
        before = (f"struct {{ {p.type.name} d; uint64_t more; }} later; memcpy(&later.d, {p.name}, sizeof later.d); "
                  "later.d.struct_size = sizeof later; later.more = 1; ")
        attempt = self.attempt("desc later", self.call(**{p.name: "&later.d"}), "UNSUPPORTED", before)
        return f"  if ({p.name})\n{attempt}"

    def text(self):
        parameters = ", ".join(map(declaration, self.f.parameters)) or "void"
        faults = [text for p, kind, _ in rules.faults(self.f) for text in self.fault(p, kind)]
        all_names = names_of(self.f)
        faults += [self.too_small()] if "capacity small" in all_names else []
        faults += [self.later()] if "desc later" in all_names else []
        return (f"ups_status {self.f.name}({parameters}) {{\n"
                f"  static ups_status (*real)({parameters});\n"
                f'  if (!real) *(void **)&real = dlsym(RTLD_NEXT, "{self.f.name}");\n'
                f"  ups_status status = {self.call()};\n  if (status != UPS_OK) return status;\n"
                + "".join(faults) + "  return status;\n}\n")


def build(cc, functions, folder):
    source = Path(folder, "errors.c")
    source.write_text("\n".join(inclusions(ROOT / "include")) + START + "".join(Wrapper(f).text() for f in functions))
    run(cc, "-std=c99", "-D_GNU_SOURCE", "-w", "-shared", "-fPIC", "-I", ROOT / "include", source, "-o", Path(folder, "errors.so"))
    return Path(folder, "errors.so")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("examples", nargs="+", metavar="EXAMPLE", help="a program")
    parser.add_argument("--cc", default="cc", help="C compiler")
    arguments = parser.parse_args()
    functions = [f for f in read_api().functions if rules.can_fail(f)]
    failed = False
    with tempfile.TemporaryDirectory() as folder:
        environment = preloaded(build(arguments.cc, functions, folder)) | {"UPS_TRIED": f"{folder}/tried"}
        for example in arguments.examples:
            done = subprocess.run([os.path.abspath(example)], env=environment, cwd=folder, capture_output=True,
                                  text=True)
            if done.returncode:
                print(f"{Path(example).name}: {done.returncode}\n{done.stdout}{done.stderr}")
                failed = True
        tried = set(Path(folder, "tried").read_text().splitlines())
    wanted = {f"{f.name} {fault}" for f in functions for fault in names_of(f)} - set(NOT_TRIED)
    for fault in sorted(wanted - tried):
        print(f"no example tries {fault}")
    print(f"{len(wanted & tried)} of {len(wanted)} faults of {len(functions)} functions were tried")
    sys.exit(failed or bool(wanted - tried))


if __name__ == "__main__":
    main()
