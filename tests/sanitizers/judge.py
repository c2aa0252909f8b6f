#!/usr/bin/env python3
"""Judges the tests of a sanitizer's build: judge.py BUILD RELEASE, both directories, BUILD with results.xml (by ctest).

A test that failed counts as found where a sanitizer, a trap or a signal ended it, and wherever it is not GoogleTest's own
finding. That, too, counts as found where the test passes in RELEASE, the same engine without sanitizers, with the same
effort (UPS_TEST_EFFORT): it is no noise of few iterations then. Exit code 1 where something was found."""
import os
import re
import subprocess
import sys
import xml.etree.ElementTree

REPORT = re.compile(r"ERROR: \w+Sanitizer.*|WARNING: \w+Sanitizer.*|.*: runtime error: .*|a float trap: .*|"
                    r"terminate called .*|.*[Aa]ssertion .* failed.*")
NOISE = "readings too noisy"
NAMES_AT_ONCE = 100  # a command's arguments have a length


def cases_of(results):
    cases = {c.get("name"): c for c in xml.etree.ElementTree.parse(results).getroot().iter("testcase")}
    if not cases:
        raise SystemExit(f"{results}: no test ran")
    return cases


def finding(case):
    """None: nothing was found. NOISE: nothing but what GoogleTest found."""
    output = case.findtext("system-out") or ""
    report = REPORT.search(output)
    if report:
        return report[0]
    if case.get("status") != "fail":
        return None
    if re.search(r"^ *\d+ FAILED TESTS?$", output, re.M):
        return NOISE
    return "failed: " + (output.strip().splitlines() or ["without a word"])[-1]


def pass_in(release, names):
    """Those of the names whose tests pass there."""
    results = os.path.join(os.path.abspath(release), "results.xml")
    passed = set()
    for at in range(0, len(names), NAMES_AT_ONCE):
        some = names[at:at + NAMES_AT_ONCE]
        pattern = "^(" + "|".join(map(re.escape, some)) + ")( |$)"
        subprocess.run(["ctest", "--test-dir", release, "--parallel", str(os.cpu_count()), "--output-junit", results, "-R",
                        pattern], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, check=False)
        ran = cases_of(results)
        missing = [n for n in some if n not in ran]
        if missing:
            raise SystemExit(f"{release} has no test {missing[0]}: is it built?")
        passed.update(n for n in some if ran[n].get("status") == "run")
    return passed


def main():
    build, release = sys.argv[1:]
    cases = cases_of(os.path.join(build, "results.xml"))
    found = {name: f for name, c in cases.items() if (f := finding(c))}
    noisy = [name for name, f in found.items() if f == NOISE]
    passed = pass_in(release, noisy)
    for name in noisy:
        if name in passed:
            found[name] = "failed by its own finding, and passes without sanitizers"
        else:
            del found[name]
    unjudged = [name for name in noisy if name not in found]
    skipped = sum(c.get("status") == "notrun" for c in cases.values())
    seconds = sum(float(c.get("time") or 0) for c in cases.values())
    print(f"\n{len(cases)} tests in {seconds / 60:.0f} minutes of theirs: {len(found)} with a finding; {skipped} skipped by "
          f"themselves; {len(unjudged)} whose readings are too noisy to be judged, as without sanitizers:")
    print("  " + ", ".join(unjudged) if unjudged else "  none")
    for name, text in found.items():
        print(f"FOUND {name}: {text}")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
