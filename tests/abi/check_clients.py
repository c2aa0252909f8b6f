#!/usr/bin/env python3
"""Do programs that were compiled with an earlier version of the same SONAME still run? Run by ctest, a subcommand a
question; what they were compiled with is frozen in released/VERSION/ups:

released  every function of then has its signature; every field its offset and size, every enumerator its value;
          structs grew at their end alone, and only those that begin with struct_size
clients   the program beside that header, and one that has every *_init fill a struct of then, are compiled with it,
          linked with libraries of then (empty functions, no versions of symbols) and run with these
"""
import argparse
import itertools
import os
import tempfile
from pathlib import Path

import check_abi
from check_abi import c_header, run

HERE = Path(__file__).resolve().parent
INCLUDE = check_abi.INCLUDE


def releases():
    """(version, folder of its headers, Api) of each whose SONAME is still this one's."""
    node = check_abi.symbol_version(c_header.parse_headers(INCLUDE / "ups"))
    for folder in sorted((HERE / "released").iterdir()):
        extras = [name for name in c_header.EXTRA_HEADERS if (folder / "ups" / name).exists()]  # some came later
        api = c_header.parse_headers(folder / "ups", ["ups.h", *extras])
        if check_abi.symbol_version(api) == node:
            yield folder.name, folder, api


# ---- released


def read_layout(lines):
    """({struct: size}, {struct: {field: (offset, size)}}, {enumerator: value})"""
    sizes, fields, values = {}, {}, {}
    for line in lines:
        words = line.split()
        if line.startswith("  "):
            fields[list(sizes)[-1]][words[0]] = (int(words[1]), int(words[2]))
        elif words[0].startswith("UPS_"):
            values[words[0]] = int(words[1])
        else:
            sizes[words[0]], fields[words[0]] = int(words[1]), {}
    return sizes, fields, values


def changed_structs(then, now):
    (old_sizes, old_fields, old_values), (sizes, fields, values) = then, now
    for struct, size in old_sizes.items():
        if struct not in sizes:
            yield f"{struct} is gone"
            continue
        may_grow = next(iter(old_fields[struct])) == "struct_size"
        if sizes[struct] < size or (sizes[struct] > size and not may_grow):
            yield f"{struct} had {size} bytes, has {sizes[struct]}"
        for field, place in old_fields[struct].items():
            same = [place] if field.startswith("reserved") else [fields[struct].get(field)]
            if same != [place]:  # what was reserved may have got a name
                yield f"{struct}.{field} was at {place[0]} with {place[1]} bytes, is {same[0]}"
    for name, value in old_values.items():
        if values.get(name) != value:
            yield f"{name} was {value}, is {values.get(name)}"


def changed_functions(then, now):
    signatures = {f.name: (f.returns, [p.type for p in f.parameters]) for f in now.functions}
    for f in then.functions:
        if signatures.get(f.name) != (f.returns, [p.type for p in f.parameters]):
            yield f"{f.name} has another signature, or is gone"


def check_released(arguments):
    now = check_abi.read_api()
    layout = read_layout(check_abi.measure_layout(arguments.cc, now, INCLUDE))
    for version, folder, api in releases():
        then = read_layout(check_abi.measure_layout(arguments.cc, api, folder))
        changes = [*changed_structs(then, layout), *changed_functions(api, now)]
        if changes:
            raise SystemExit("\n".join(changes) + f"\nPrograms of {version} break: such a change needs a new SONAME.")
        print(f"{version}: {len(api.functions)} functions, {len(api.structs)} structs and all values are as they were")


# ---- clients


def initialiser(api, folder):
    """A program that has every *_init fill a struct of the size of then, and looks at the bytes behind it."""
    lines = ["#include <stdio.h>", "#include <string.h>", *check_abi.inclusions(folder), "int main(void) {",
             "int failures = 0;"]
    for f in api.functions:
        if f.name.endswith("_init"):
            struct = f.parameters[0].type.name
            lines.append(f"""{{
  struct {{ {struct} v; unsigned char end[256]; }} s;
  int touched = 0;
  memset(&s, 0xA5, sizeof s);
  {f.name}(&s.v, sizeof s.v);
  for (int i = 0; i < 256; ++i) touched += s.end[i] != 0xA5;
  if (touched || s.v.struct_size != sizeof s.v) {{ puts("{f.name} writes beyond struct_size"); ++failures; }}
}}""")
    return "\n".join([*lines, "return failures != 0;", "}"])


def build_client(arguments, source, folder, libraries):
    program = source.with_suffix("")
    run(arguments.cc, "-std=c99", "-Wall", "-Wextra", "-Werror", *arguments.flags.split(), "-I", folder, source,
        *libraries, "-o", program)
    if "UPS_" in run("readelf", "--version-info", program):
        raise SystemExit(f"{source.name} asks for versions of symbols, as programs of then did not")
    return program


def check_clients(arguments):
    folders = [str(Path(library).resolve().parent) for library in arguments.library]
    environment = dict(os.environ, LD_LIBRARY_PATH=":".join(folders))
    for version, folder, api in releases():
        with tempfile.TemporaryDirectory() as temporary:
            work = Path(temporary)
            old = [check_abi.build_empty_library(arguments.cc, list(functions), folder, work, name,
                                                 check_abi.soname(api, name))
                   for name, functions in itertools.groupby(api.functions, check_abi.library_of)]
            sources = [work / "initialiser.c", work / "client.c"]
            sources[0].write_text(initialiser(api, folder))
            sources[1].write_text((folder / "client.c").read_text())
            for source in sources:
                program = build_client(arguments, source, folder, old)
                print(f"{version}: {source.stem}", run(program, env=environment).strip())


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("question", choices=("released", "clients"))
    parser.add_argument("--library", nargs="+", help="libups.so and its extras, for clients")
    parser.add_argument("--cc", default="cc", help="C compiler")
    parser.add_argument("--flags", default="", help="of the compiler, such as the library's sanitizer")
    arguments = parser.parse_args()
    globals()["check_" + arguments.question](arguments)


if __name__ == "__main__":
    main()
