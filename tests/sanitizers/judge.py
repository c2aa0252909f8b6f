#!/usr/bin/env python3
"""Judges the tests of a sanitizer's build: judge.py RESULTS.xml (JUnit, by ctest).

A test that failed counts as found where a sanitizer, a trap or a signal ended it, and wherever it is not GoogleTest's own
finding that a reading is off or too noisy: renders of few iterations are (tests/support/effort.h), and the build without
sanitizers judges them. Exit code 1 where something was found."""
import re
import sys
import xml.etree.ElementTree

REPORT = re.compile(r"ERROR: \w+Sanitizer.*|WARNING: \w+Sanitizer.*|.*: runtime error: .*|a float trap: .*|"
                    r"terminate called .*|.*[Aa]ssertion .* failed.*")


def finding(case):
    """None: nothing was found."""
    output = case.findtext("system-out") or ""
    report = REPORT.search(output)
    if report:
        return report[0]
    if case.get("status") != "fail" or re.search(r"^ *\d+ FAILED TESTS?$", output, re.M):
        return None
    return "failed: " + (output.strip().splitlines() or ["without a word"])[-1]


def main():
    cases = list(xml.etree.ElementTree.parse(sys.argv[1]).getroot().iter("testcase"))
    if not cases:
        raise SystemExit("no test ran")
    for c in cases:  # without a parameter's value
        c.set("name", c.get("name").partition("  #")[0])
    found = [(c.get("name"), f) for c in cases if (f := finding(c))]
    by_status = {s: [c.get("name") for c in cases if c.get("status") == s] for s in ("fail", "notrun")}
    unjudged = [n for n in by_status["fail"] if n not in dict(found)]
    seconds = sum(float(c.get("time") or 0) for c in cases)
    print(f"\n{len(cases)} tests in {seconds / 60:.0f} minutes of theirs: {len(found)} with a finding; "
          f"{len(by_status['notrun'])} skipped by themselves; {len(unjudged)} whose readings are too noisy to be judged:")
    print("  " + ", ".join(unjudged) if unjudged else "  none")
    for name, text in found:
        print(f"FOUND {name}: {text}")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
