#!/usr/bin/env python3
"""Breaks the engine in one place at a time and tells which test finds it. See README.md."""
import argparse
import concurrent.futures
import json
import os
import pathlib
import re
import subprocess
import sys
import threading
import time
import zlib

import schemata

ROOT = pathlib.Path(__file__).resolve().parents[2]
TABLES = pathlib.Path(__file__).resolve().parent / "mutants"
LAST_RESULT = pathlib.Path(__file__).resolve().parent / "README.md"
# Of rising cost, with the folders of code that they link. What is not there (a kind of test of a later or earlier
# time) is left out.
SCENE = "base geometry bsdf emitter sensor photometry scene"
EXECUTABLES = {"base/base_tests": "base", "bsdf/test_bsdf": "base geometry bsdf",
               "geometry/geometry_tests": "base geometry sensor photometry",
               "photometry/photometry_tests": "base photometry", "transport/transport_tests": SCENE + " transport",
               "render/render_tests": SCENE + " transport render", "scene/scene_tests": SCENE,
               "emitter/emitter_tests": "base photometry emitter", "oracle/test_oracle": SCENE + " transport",
               "stability/test_stability_parts": SCENE + " transport render",
               "api/api_tests": "all", "analytic/test_analytic": "all", "stability/test_stability": "all",
               "agreement/test_agreement": "all"}
TIERS = (0.1, 1.0, 10.0, float("inf"))  # s a test takes: all quick ones run before the first slow one
TIERS_OF_EQUIVALENT = 2  # unless they are asked for by name: no test can find them, if their reasons are right
LEAST_SHARE = 0.95


def build(tree, jobs):
    folder = tree / "build" / "release"
    env = dict(os.environ, CCACHE_BASEDIR=str(tree), CCACHE_NOHASHDIR="1")
    subprocess.run(["cmake", "-S", tree, "-B", folder, "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release",
                    "-DUPS_BUILD_TOOL=OFF", "-DUPS_BUILD_EXTRAS=OFF", "-DUPS_BUILD_SAMPLES=OFF", "-DUPS_BUILD_TESTS=ON",
                    "-DUPS_INSTALL=OFF"], check=True, env=env, stdout=subprocess.DEVNULL)
    there = [e for e in EXECUTABLES if (tree / "tests" / e).parent.is_dir()]
    subprocess.run(["cmake", "--build", folder, "--parallel", str(jobs), "--target"] +
                   [pathlib.Path(e).name for e in there], check=True, env=env)
    return [folder / "tests" / e for e in there]


class Run:
    """One executable with one mutant: did it fail, at which test, how long did it take."""

    def __init__(self, executable, number, tests, timeout, report=None):
        command = [executable, "--gtest_fail_fast", "--gtest_color=no", "--gtest_filter=" + ":".join(tests)]
        if report:
            command.append(f"--gtest_output=json:{report}")
        start = time.monotonic()
        try:
            done = subprocess.run(command, env=dict(os.environ, UPS_MUTANT=str(number)), stdout=subprocess.PIPE,
                                  stderr=subprocess.STDOUT, timeout=timeout, check=False)
            output, status, how = done.stdout, done.returncode, "" if done.returncode > 0 else "crash in "
        except subprocess.TimeoutExpired as e:
            output, status, how = e.stdout or b"", 1, "hang in "
        self.seconds = time.monotonic() - start
        self.output = output.decode(errors="replace")
        self.failed = status != 0
        if not self.failed:
            return
        failed = re.findall(r"^\[  FAILED  \] ([^\s,]+)", self.output, re.M)
        begun = re.findall(r"^\[ RUN      \] (\S+)", self.output, re.M)
        self.test = f"{how}{executable.name}: {(failed[:1] if failed and not how else begun[-1:] or ['start'])[0]}"


def tests_of(executable, wanted):
    listed = subprocess.run([executable, "--gtest_list_tests"], check=True, capture_output=True, text=True).stdout
    suite, tests = "", []
    for line in listed.splitlines():
        name = line.partition("#")[0].strip()
        if not line.startswith(" "):
            suite = name
        elif re.search(wanted, f"{executable.name}: {suite}{name}"):
            tests.append(suite + name)
    return tests


def times_of(report):
    suites = json.loads(report.read_text())["testsuites"]
    return {f"{s['name']}.{t['name']}": float(t["time"].rstrip("s"))
            for s in suites for t in s["testsuite"] if t["result"] == "COMPLETED"}


def libraries(folder):
    return (folder / "tree" / "build" / "release" / "src").rglob("*.so")


def is_newer(report, files):
    return report.exists() and all(f.stat().st_mtime < report.stat().st_mtime for f in files)


def time_limit(seconds):
    return 30 + 20 * seconds


def run_unchanged(executables, wanted, folder, resume):
    """Mutant 0: all tests must pass. Returns tiers of steps: executable, its tests of that tier, the time limit; and
    by executable the time that each of its tests takes."""
    times = {}
    for executable in executables:
        report = folder / (executable.name + ".json")
        tests = tests_of(executable, wanted)
        if not tests:
            continue
        by_test = times_of(report) if resume and is_newer(report, [executable, *libraries(folder)]) else {}
        if not set(tests) <= set(by_test):
            report.unlink(missing_ok=True)
            run = Run(executable, 0, tests, 3600, report)
            if run.failed:
                report.unlink(missing_ok=True)
                print(run.output[-4000:], file=sys.stderr)
                raise SystemExit(f"without any mutant {run.test} fails: that must be mended first")
            by_test = times_of(report)
        times[executable] = {t: by_test[t] for t in tests if t in by_test}  # others are disabled
        print(f"{executable.name}: {len(times[executable])} tests, {sum(times[executable].values()):.1f} s", flush=True)
    tiers, low = [], -1.0
    for high in TIERS:
        steps = []
        for executable, by_test in times.items():
            chosen = {t: s for t, s in by_test.items() if low < s <= high}
            if chosen:
                steps.append((executable, list(chosen), time_limit(sum(chosen.values()))))
        tiers.append(steps)
        low = high
    return tiers, times


def last_finders():
    """By mutant, of the table of the last result: `executable: test` that found it."""
    row = r"^\| (\w+) \|.*\| (?:crash in |hang in )?(\w+: [\w/.]+) \|[ 0-9]*\|$"
    return dict(re.findall(row, LAST_RESULT.read_text(), re.M))


def steps_of_last_finders(times):
    """By mutant: what is most likely to find it again, as far as it is among the tests."""
    known = {f"{e.name}: {t}": (e, [t], time_limit(s)) for e, tests in times.items() for t, s in tests.items()}
    return {name: [known[finder]] for name, finder in last_finders().items() if finder in known}


def test_mutant(mutant, steps, result):
    """Adds to its result; of earlier steps it has none, or the seconds that found nothing."""
    start = time.monotonic()
    folder = pathlib.Path(mutant.file).parent.name
    linked = {e.rpartition("/")[2]: folders.split() for e, folders in EXECUTABLES.items()}
    steps = [s for s in steps if {folder, "all"} & set(linked[s[0].name])]
    for executable, tests, timeout in sorted(steps, key=lambda s: s[0].parent.name != folder):  # its own tests first
        run = Run(executable, mutant.number, tests, timeout)
        if run.failed:
            result["found"] = run.test
            break
    result["seconds"] = round(result["seconds"] + time.monotonic() - start, 1)


def table_of(mutants, results):
    lines = ["| mutant | where | what was broken | found by | s |", "|---|---|---|---|---|"]
    for m in mutants:
        r = results[m.name]
        found = r["found"] or "**not found**"
        if m.equivalent:
            found = f"not: equivalent, {m.equivalent}" + (f" (seen by {found})" if r["found"] else "")
        lines.append(f"| {m.name} | `{m.file}` {m.function} | {m.breaks} | {found} | {r['seconds']:.0f} |")
    return "\n".join(lines)


def summary_of(mutants, results):
    equivalent = [m for m in mutants if m.equivalent]
    found = [m for m in mutants if results[m.name]["found"] and not m.equivalent]
    counted = len(mutants) - len(equivalent)
    share = len(found) / counted if counted else 1.0
    text = (f"{len(mutants)} mutants: {len(found)} found, {len(equivalent)} equivalent, "
            f"{counted - len(found)} survive; found of those that are not equivalent: {100 * share:.1f} %")
    return text, share


def chosen_by(mutants, names):
    if not names:
        return mutants
    known = {str(m.number): m for m in mutants} | {m.name: m for m in mutants}
    chosen = []
    for name in names:
        at = [known[name]] if name in known else [m for m in mutants if re.search(name, f"{m.file} {m.name}")]
        if not at:
            raise SystemExit(f"no mutant has the number or name {name}, nor does its file match; see --list")
        chosen += [m for m in at if m not in chosen]
    return chosen


def arguments():
    p = argparse.ArgumentParser(description=__doc__)
    p.add_argument("mutants", nargs="*", help="numbers, names, or regular expressions of `file name`; all by default")
    p.add_argument("--list", action="store_true", help="lists the mutants and ends; an error where the code has changed under them")
    p.add_argument("--tests", default="", metavar="REGEX", help="only tests whose `executable: suite.name` matches")
    p.add_argument("--jobs", type=int, default=1, help="mutants that are tested at a time (1)")
    p.add_argument("--resume", action="store_true",
                   help="goes on from the results of an earlier run, as far as mutants and tests are the same")
    p.add_argument("--folder", type=pathlib.Path, default=ROOT / "build" / "mutation",
                   help="of the build and results (build/mutation)")
    return p.parse_args()


def main():
    args = arguments()
    everything = schemata.read_mutants(TABLES)
    mutants = chosen_by(everything, args.mutants)
    if args.list:
        schemata.mutated_files(ROOT, everything)  # does the table follow the code?
        for m in mutants:
            print(f"{m.number:4} {m.name:32} {m.at}: {m.breaks}")
        return 0
    folder = args.folder.resolve()
    folder.mkdir(parents=True, exist_ok=True)
    schemata.make_tree(ROOT, folder / "tree", everything)
    tiers, times = run_unchanged(build(folder / "tree", os.cpu_count()), args.tests, folder, args.resume)
    results, path, lock = {}, folder / "results.json", threading.Lock()
    if path.exists():  # of the others, and with --resume of these
        same = {m.name: m.identity() for m in everything if args.resume or m not in mutants}
        results = {n: r for n, r in json.loads(path.read_text()).items() if same.get(n) == r["identity"]}
    tests = zlib.crc32(json.dumps(sorted(t for tier in tiers for _, names, _ in tier for t in names)).encode())
    for m in mutants:
        if m.name not in results or not (results[m.name]["found"] or results[m.name]["tests"] == tests):
            results[m.name] = {"identity": m.identity(), "tests": tests, "found": None, "seconds": 0.0, "tiers": 0}

    def tiers_of(mutant):
        return TIERS_OF_EQUIVALENT if mutant.equivalent and not args.mutants else len(tiers)

    def one(mutant, steps, tiers_met):
        result = results[mutant.name]
        test_mutant(mutant, steps, result)
        with lock:
            result["tiers"] = tiers_met
            path.with_suffix(".new").write_text(json.dumps(results, indent=1))
            path.with_suffix(".new").replace(path)
            if result["found"] or tiers_met == tiers_of(mutant):
                print(f"{mutant.name}: {result['found'] or 'NOT FOUND'} ({result['seconds']} s)", flush=True)

    def all_of(chosen, steps_of, tiers_met):
        with concurrent.futures.ThreadPoolExecutor(args.jobs) as pool:
            list(pool.map(lambda m: one(m, steps_of(m), tiers_met), chosen))

    finders = steps_of_last_finders(times)
    again = [m for m in mutants if m.name in finders and not results[m.name]["found"] and not results[m.name]["tiers"]]
    print(f"-- {len(again)} mutants, each the test that found it last", flush=True)
    all_of(again, lambda m: finders[m.name], 0)
    for tier, steps in enumerate(tiers):  # all that are left meet the quick tests first
        left = [m for m in mutants if not results[m.name]["found"] and results[m.name]["tiers"] <= tier < tiers_of(m)]
        print(f"-- {len(left)} mutants, {sum(len(tests) for _, tests, _ in steps)} tests", flush=True)
        all_of(left, lambda m, s=steps: s, tier + 1)
    text, share = summary_of(mutants, results)
    report = table_of(mutants, results) + "\n\n" + text + "\n"
    (folder / "table.md").write_text(report)
    print("\n" + report, end="")
    return 0 if share >= LEAST_SHARE else 1


if __name__ == "__main__":
    sys.exit(main())
