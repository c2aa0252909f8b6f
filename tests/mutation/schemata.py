"""Reads the tables of mutants and makes a source tree that holds all of them, to be built once.

A table is a text file of records, separated by empty lines; a line that starts with # is a comment:
  name: merge_divisor
  at: src/transport/techniques.cpp merge
  was: const double norm = «in.photon_norm(radius * radius)»;
  now: in.photon_norm(radius)
  breaks: the density of a merge
  equivalent: why no test can find it (only where that is so)
`was` is text that the file has once, with the place to be changed in «»; \\n is a line break. A place that ends with
a semicolon is a statement, any other an expression. Each becomes a choice by the number of the mutant, which the
program reads from the environment variable UPS_MUTANT; 0 or none leaves everything as it is."""
import pathlib
import re
import shutil
import subprocess
import zlib

FIELDS = ("name", "at", "was", "now", "breaks", "equivalent")
HEADER = """#pragma once
#include <cstdlib>
namespace ups_mutation {
inline int read_number() {
  const char* text = std::getenv("UPS_MUTANT");
  return text ? std::atoi(text) : 0;
}
inline const int number = read_number();
}  // namespace ups_mutation
"""


class Mutant:
    def __init__(self, fields, where):
        for field in FIELDS:
            setattr(self, field, fields.get(field, ""))
        missing = [f for f in FIELDS[:5] if f not in fields]
        if missing:
            raise SystemExit(f"{where}: mutant without {', '.join(missing)}")
        self.where = where
        self.file, _, self.function = self.at.partition(" ")
        self.was = self.was.replace("\\n", "\n")
        if self.was.count("«") != 1 or self.was.count("»") != 1:
            raise SystemExit(f"{where}: `was` of {self.name} must have one place in «»")
        self.text = self.was.replace("«", "").replace("»", "")
        self.start, self.old = self.was.index("«"), self.was[self.was.index("«") + 1:self.was.index("»")]
        self.number = 0  # of its choice, by place in the table
        if not self.old.endswith(";") and re.match(r"(if|for|while|return|throw)\b", self.now):
            raise SystemExit(f"{where}: `now` of {self.name} is a statement, its place is not: a semicolon at its end")

    def identity(self):  # a result holds as long as this is the same
        return zlib.crc32(f"{self.file}\n{self.was}\n{self.now}".encode())


def read_table(path):
    mutants, fields, first = [], {}, 0
    for number, line in enumerate(path.read_text().splitlines() + [""], 1):
        if line.startswith("#"):
            continue
        if line.strip():
            key, colon, value = line.partition(": ")
            if not colon or key not in FIELDS or key in fields:
                raise SystemExit(f"{path}:{number}: expected one of {', '.join(FIELDS)}, once each: {line}")
            first = first or number
            fields[key] = value
        elif fields:
            mutants.append(Mutant(fields, f"{path}:{first}"))
            fields, first = {}, 0
    return mutants


def read_mutants(folder):
    mutants = [m for path in sorted(folder.glob("*.txt")) for m in read_table(path)]
    seen = {}
    for number, m in enumerate(mutants, 1):
        m.number = number
        if m.name in seen:
            raise SystemExit(f"{m.where}: the name {m.name} is taken by {seen[m.name]}")
        seen[m.name] = m.where
    return mutants


def mutated(source, mutants):
    """The text of a file with all its mutants to choose from."""
    places = {}
    for m in mutants:
        if source.count(m.text) != 1:
            raise SystemExit(f"{m.where}: {m.file} has the text of {m.name} {source.count(m.text)} times instead of "
                             f"once; where the code has changed, the table must follow:\n{m.text}")
        at = source.index(m.text) + m.start
        places.setdefault((at, at + len(m.old)), []).append(m)
    out, last = [], 0
    for (begin, end), here in sorted(places.items()):
        if begin < last:
            raise SystemExit(f"{here[0].where}: the place of {here[0].name} overlaps that of another mutant")
        old = source[begin:end]
        out.append(source[last:begin])
        if old.endswith(";"):
            choices = "".join(f"if (ups_mutation::number == {m.number}) {{ {m.now} }} else " for m in here)
            out.append(f"{choices}{{ {old} }}")
        else:
            choices = "".join(f"ups_mutation::number == {m.number} ? ({m.now}) : " for m in here)
            out.append(f"({choices}({old}))")
        last = end
    return "".join(out) + source[last:]


def write(path, data):
    """Only where it differs, so that a second build is short."""
    if path.exists() and path.read_bytes() == data:
        return
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_bytes(data)


def mutated_files(root, mutants):
    """The texts of all files that have mutants, by name; ends the program where the table does not follow the code."""
    by_file = {}
    for m in mutants:
        if not (root / m.file).is_file():
            raise SystemExit(f"{m.where}: there is no file {m.file}")
        by_file.setdefault(m.file, []).append(m)
    return {name: mutated((root / name).read_text(encoding="utf-8"), here) for name, here in by_file.items()}


def make_tree(root, tree, mutants):
    """Copies the repository's files to `tree`, with the mutants in theirs."""
    texts = mutated_files(root, mutants)
    listed = subprocess.run(["git", "ls-files", "-z", "--cached", "--others", "--exclude-standard"], cwd=root,
                            check=True, capture_output=True).stdout.decode()
    files = [f for f in listed.split("\0") if f and (root / f).is_file()]
    header = tree / "mutation_number.h"
    write(header, HEADER.encode())
    for name in files:
        text = texts.get(name)
        write(tree / name, f'#include "{header}"\n{text}'.encode() if text else (root / name).read_bytes())
        shutil.copymode(root / name, tree / name)
    kept = set(files) | {"mutation_number.h"}
    for path in tree.rglob("*"):  # what the repository no longer has
        name = path.relative_to(tree)
        if path.is_file() and name.parts[0] != "build" and str(name) not in kept:
            path.unlink()
