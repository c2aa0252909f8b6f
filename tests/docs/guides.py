#!/usr/bin/env python3
"""Runs the guides of samples/docs as a reader would: writes their files, runs their commands, reads what they print.

    tests/docs/guides.py BUILD LIBDIR             installs BUILD and runs all guides
    tests/docs/guides.py BUILD LIBDIR --write     puts what was printed into the guides

In a guide <!-- file: NAME --> stands before a file, <!-- files of GUIDE --> before commands that need the files of
another, <!-- not run: REASON --> before commands that are left out, and <!-- output --> before what the commands above
it print. Of that, words must be as they are, numbers within 10 %, errors (after "within" and "error") within a factor of
two: the same seed gives the same bits in one version, but the guides are to survive the next one. This is no test of
accuracy: it finds guides that tell of another program. A line of it that is "..." stands for any lines.
"""
import argparse
import os
import re
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent.parent
FOLDER = ROOT / "samples/docs"
sys.path.insert(0, str(FOLDER))
import pages  # noqa: E402

BLOCK = re.compile(r"(?:^<!-- (?P<mark>[^\n]*?) -->\n)?^```(?P<kind>\w*)\n(?P<text>.*?)^```$", re.S | re.M)
# A sanitizer's run time that stands before all programs is not for CMake, which then may wait for ever for what it runs.
WITHOUT_SANITIZER = 'cmake() { LD_PRELOAD="" command cmake "$@"; }\n' if "LD_PRELOAD" in os.environ else ""
NUMBER = re.compile(r"(?P<error>\b(?:within|error) )?(?<![\w.])(?P<value>-?\d+(?:\.\d+)?(?:e-?\d+)?)(?![\w.]*\d)")


def same_number(told, found):
    a, b = float(told["value"]), float(found["value"])
    return max(a, b) <= 2 * min(a, b) if told["error"] else abs(a - b) <= 0.1 * abs(a)


def same_line(told, found):
    return NUMBER.sub("#", told) == NUMBER.sub("#", found) and all(
        map(same_number, NUMBER.finditer(told), NUMBER.finditer(found)))


def agrees(told, found):
    """Whether lines agree, where "..." stands for any."""
    if not told:
        return not found
    if told[0].strip() == "...":
        return any(agrees(told[1:], found[i:]) for i in range(len(found) + 1))
    return bool(found) and same_line(told[0], found[0]) and agrees(told[1:], found[1:])


def run(commands, folder, environment):
    script = WITHOUT_SANITIZER + commands + "\nexport -p >.environment"
    done = subprocess.run(["bash", "-euo", "pipefail", "-c", script], cwd=folder, env=environment,
                          stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, timeout=300)
    if done.returncode != 0:
        sys.exit(f"{commands}\nended with {done.returncode}:\n{done.stdout}{done.stderr}")
    exported = subprocess.run(["bash", "-c", ". ./.environment; env -0"], cwd=folder, capture_output=True, text=True)
    environment.update(e.split("=", 1) for e in exported.stdout.split("\0") if "=" in e and not e.startswith("BASH_"))
    return done.stdout


def write_file(folder, block):
    """Whether the block is a file, which is then there."""
    name = re.fullmatch(r"file: (\S+)", block["mark"] or "")
    if name:
        (folder / name[1]).write_text(block["text"], encoding="utf-8")
    return name is not None


def try_guide(path, prefix, write):
    text = path.read_text(encoding="utf-8")
    environment = {**os.environ, "PREFIX": str(prefix), "PATH": f"{prefix}/bin:{os.environ['PATH']}"}
    wrong, ran, printed, news = [], 0, "", []
    with tempfile.TemporaryDirectory() as folder:
        (Path(folder) / "samples").symlink_to(ROOT / "samples")
        for block in BLOCK.finditer(text):
            mark = block["mark"] or ""
            if mark.startswith("files of "):
                other = (FOLDER / f"{mark.removeprefix('files of ')}.md").read_text(encoding="utf-8")
                for match in BLOCK.finditer(other):
                    write_file(Path(folder), match)
            if write_file(Path(folder), block):
                continue
            if mark == "output":
                told, found = block["text"].rstrip().split("\n"), printed.rstrip().split("\n")
                if write and "..." not in told:
                    news.append((block.span(), f"<!-- output -->\n```\n{printed.rstrip()}\n```"))
                elif not agrees(told, found):
                    wrong.append(f"{path.name} says\n{block['text']}but it was\n{printed}")
            elif block["kind"] == "sh" and not mark.startswith("not run: "):
                printed = run(block["text"], folder, environment)
                ran += 1
            elif not mark.startswith("not run: "):
                wrong.append(f"{path.name}: a block that is no file, command or output: {block[0][:80]}")
    for (start, end), new in reversed(news):
        text = text[:start] + new + text[end:]
    if news:
        path.write_text(text, encoding="utf-8")
    if not ran:
        wrong.append(f"{path.name} has no commands that are run")
    return wrong


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build")
    parser.add_argument("libdir")
    parser.add_argument("--write", action="store_true")
    parser.add_argument("--only", choices=pages.GUIDES)
    options = parser.parse_args()
    wrong = []
    with tempfile.TemporaryDirectory() as folder:
        prefix = Path(folder) / "prefix"
        subprocess.run(["cmake", "--install", options.build, "--prefix", prefix], check=True, stdout=subprocess.DEVNULL)
        if options.libdir != "lib":  # the guides say lib
            (prefix / "lib").mkdir(exist_ok=True)
            for entry in (prefix / options.libdir).iterdir():
                (prefix / "lib" / entry.name).symlink_to(entry)
        for guide in [options.only] if options.only else pages.GUIDES:
            wrong += try_guide(FOLDER / f"{guide}.md", prefix, options.write)
    print(*wrong, sep="\n", end="\n" if wrong else "")
    sys.exit(bool(wrong))


if __name__ == "__main__":
    main()
