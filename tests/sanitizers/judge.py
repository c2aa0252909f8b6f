#!/usr/bin/env python3
"""Judges the tests of a sanitizer's build: judge.py BUILD RELEASE, both build/PRESET of a clone, BUILD with
results.xml (by ctest).

A test that failed counts as found where a sanitizer, a trap or a signal ended it, and wherever it is not GoogleTest's own
finding. That, too, counts as found where the test passes in RELEASE, the same engine without sanitizers, with the same
effort (UPS_TEST_EFFORT): it is no noise of few iterations then. A test that the sanitizer ended as it found no address
space for itself is run again. Exit code 1 where something was found."""
import os
import pathlib
import re
import subprocess
import sys
import xml.etree.ElementTree

REPORT = re.compile(r"ERROR: \w+Sanitizer.*|WARNING: \w+Sanitizer.*|.*: runtime error: .*|a float trap: .*|"
                    r"terminate called .*|.*[Aa]ssertion .* failed.*")
NOISE = "readings too noisy"
# Hundreds of terabytes, now and then, in processes that load the library late: most likely its run time takes what lies
# before a thread's variables, where these start 16 bytes into a page, for the header that glibc 2.19 wrote there.
NO_ROOM = re.compile(r"ThreadSanitizer failed to allocate 0x[0-9a-f]{12}")
MOST_RUNS = 5
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


def run(folder, names, file):
    """Their cases, run by ctest in that build with what its preset asks for; results go into that file of it."""
    folder = os.path.abspath(folder)
    results = os.path.join(folder, file)
    root, preset = os.path.dirname(os.path.dirname(folder)), os.path.basename(folder)
    cases = {}
    for at in range(0, len(names), NAMES_AT_ONCE):
        some = names[at:at + NAMES_AT_ONCE]
        pathlib.Path(results).unlink(missing_ok=True)
        pattern = "^(" + "|".join(map(re.escape, some)) + ")( |$)"
        subprocess.run(["ctest", "--preset", preset, "--parallel", str(os.cpu_count()), "--output-junit", results, "-R",
                        pattern], cwd=root, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, check=False)
        ran = cases_of(results)
        missing = [n for n in some if n not in ran]
        if missing:
            raise SystemExit(f"{folder} has no test {missing[0]}: is it built?")
        cases.update((n, ran[n]) for n in some)
    return cases


def names_without_room(cases):
    """Of those of which nothing else was reported."""
    reports = {name: [m[0] for m in REPORT.finditer(c.findtext("system-out") or "")] for name, c in cases.items()}
    return [name for name, found in reports.items() if found and all(NO_ROOM.search(r) for r in found)]


def main():
    build, release = sys.argv[1:]
    cases = cases_of(os.path.join(build, "results.xml"))
    without_room = names_without_room(cases)
    for _ in range(MOST_RUNS - 1):
        cases.update(run(build, names_without_room(cases), "again.xml"))
    found = {name: f for name, c in cases.items() if (f := finding(c))}
    noisy = [name for name, f in found.items() if f == NOISE]
    without_sanitizers = run(release, noisy, "results.xml")
    for name in noisy:
        if without_sanitizers[name].get("status") == "run":
            found[name] = "failed by its own finding, and passes without sanitizers"
        else:
            del found[name]
    unjudged = [name for name in noisy if name not in found]
    skipped = sum(c.get("status") == "notrun" for c in cases.values())
    seconds = sum(float(c.get("time") or 0) for c in cases.values())
    print(f"\n{len(cases)} tests in {seconds / 60:.0f} minutes of theirs: {len(found)} with a finding; {skipped} skipped by "
          f"themselves; {len(unjudged)} whose readings are too noisy to be judged, as without sanitizers:")
    print("  " + ", ".join(unjudged) if unjudged else "  none")
    if without_room:
        print("Run again, as the sanitizer had found no address space for itself: " + ", ".join(without_room))
    for name, text in found.items():
        print(f"FOUND {name}: {text}")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
