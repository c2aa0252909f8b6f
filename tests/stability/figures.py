#!/usr/bin/env python3
"""What the tests of a ctest run have measured: figures.py LOG, ctest's LastTest.log. A line a test, its figures below."""
import re
import sys


def main() -> None:
    name, figures, seconds = "", [], 0.0
    for line in open(sys.argv[1], encoding="utf-8", errors="replace"):
        if found := re.match(r"\d+/\d+ Testing: (.*)", line):
            name, figures = found[1], []
        elif line.startswith("[ MEASURED ] "):
            figures.append(line[len("[ MEASURED ] "):].strip())
        elif found := re.match(r"Test time = +([\d.]+) sec", line):
            seconds = float(found[1])
        elif line.startswith(("Test Passed", "Test Failed")) and name:
            print(f"{name}  ({seconds:.0f} s){'' if 'Passed' in line else '  FAILED'}")
            for figure in figures:
                print("    " + figure)


if __name__ == "__main__":
    main()
