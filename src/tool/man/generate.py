#!/usr/bin/env python3
"""Writes the manual pages beside this file, ups.1 and one for each command, from what the program says of itself:

    src/tool/man/generate.py build/release/bin/ups            after a change of its options
    src/tool/man/generate.py build/release/bin/ups --check    exit code 1 where a page is not what would be written
"""
import argparse
import re
import subprocess
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
ENTRY = re.compile(r"^  (\S.*?)(?: {2,}(\S.*))?$")
SECTION = re.compile(r"^([A-Z][A-Za-z ]*):$")
CONTINUED = re.compile(r"^ {6,}(\S.*)$")
EXIT_STATUS = """.SH EXIT STATUS
.TP
0
Done.
.TP
1
It failed; the reason is on standard error.
.TP
2
The command line was wrong; nothing was done.
"""
STOPPED_STATUS = """.TP
129, 130, 143
SIGHUP, Ctrl\\-C or SIGTERM stopped %s; the results so far are written.
"""
STOPPED = {"ups": "render or goniometer", "ups render": "it", "ups goniometer": "it"}  # by the name of the page


def say(program, *arguments):
    return subprocess.run([program, *arguments], check=True, capture_output=True, text=True).stdout


def escaped(text):
    for character, name in (("\\", "\\e"), ("-", "\\-"), ("`", "\\(ga"), ("^", "\\(ha"), ("'", "\\(aq")):
        text = text.replace(character, name)
    return re.sub(r"^([.])", r"\\&\1", text)


def split(text):
    """(summary, usage, [(title, [(entry, description)])], notes) of what --help prints."""
    summary, usage, sections, notes = "", "", [], []
    for line in filter(None, text.splitlines()):
        if line.startswith("Usage: "):
            usage = line.removeprefix("Usage: ")
        elif not usage:
            summary = line
        elif not notes and (section := SECTION.match(line)):
            sections.append((section[1], []))
        elif not notes and (continued := CONTINUED.match(line)):
            sections[-1][1][-1][1] += continued[1]
        elif not notes and (entry := ENTRY.match(line)):
            sections[-1][1].append([entry[1].strip(), (entry[2] or "").strip()])
        else:
            notes.append(line)
    return summary, usage, sections, notes


def page(name, version, text, commands=()):
    """The page of `ups` or of `ups COMMAND`; commands: all of them, for what to see besides."""
    summary, usage, sections, notes = split(text)
    title = name.replace(" ", "-")
    lines = [f'.TH {title.upper()} 1 "" "UPS {version}" "User commands"', ".SH NAME",
             f"{escaped(title)} \\- {escaped(summary[0].lower() + summary[1:])}", ".SH SYNOPSIS",
             f".B {name}", escaped(usage.removeprefix(name).strip())]
    if notes:
        lines.append(".SH DESCRIPTION")
        for note in notes:
            lines += [escaped(note), ".br"] if note[-1] in ".:" else [escaped(note)]
        if lines[-1] == ".br":
            lines.pop()
    for section, entries in sections:
        lines.append(f".SH {section.upper()}")
        for entry, description in entries:
            lines += [".TP", f".B {escaped(entry)}", escaped(description) if description else "\\&"]
    others = [f"ups\\-{c} (1)" for c in commands] if name == "ups" else ["ups (1)"]
    status = EXIT_STATUS + (STOPPED_STATUS % STOPPED[name] if name in STOPPED else "")
    return "\n".join([*lines, status + ".SH SEE ALSO"] + [f".BR {other}" for other in others]) + "\n"


def pages(program):
    version = say(program, "--version").split()[1]
    overview = say(program, "--help")
    commands = [entry for title, entries in split(overview)[2] if title == "Subcommands" for entry, _ in entries]
    yield "ups.1", page("ups", version, overview, commands)
    for command in commands:
        yield f"ups-{command}.1", page(f"ups {command}", version, say(program, command, "--help"))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("--check", action="store_true")
    options = parser.parse_args()
    found = dict(pages(options.program))
    committed = {p.name: p.read_text(encoding="utf-8") for p in HERE.glob("*.1")}
    if not options.check:
        for name in committed.keys() - found.keys():
            (HERE / name).unlink()
        for name, text in found.items():
            (HERE / name).write_text(text, encoding="utf-8")
    elif found != committed:
        differing = sorted(n for n in found.keys() | committed.keys() if found.get(n) != committed.get(n))
        sys.exit(f"not what the program says: {', '.join(differing)}; run {HERE.name}/{Path(__file__).name} PROGRAM")


if __name__ == "__main__":
    main()
