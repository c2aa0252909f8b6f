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

import schemata

ROOT = pathlib.Path(__file__).resolve().parents[2]
TABLES = pathlib.Path(__file__).resolve().parent / "mutants"
# Of rising cost. What is not there (a kind of test of a later or earlier time) is left out.
EXECUTABLES = ["base/base_tests", "bsdf/test_bsdf", "geometry/geometry_tests", "photometry/photometry_tests",
               "render/render_tests", "transport/transport_tests", "scene/scene_tests", "emitter/emitter_tests",
               "oracle/test_oracle", "api/api_tests", "analytic/test_analytic", "stability/test_stability",
               "agreement/test_agreement"]
TIERS = (0.1, 1.0, 10.0, float("inf"))  # s a test takes: all quick ones run before the first slow one
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


def run_unchanged(executables, wanted, folder):
    """Mutant 0: all tests must pass. Returns the steps of a run: executable, its tests of one tier, the time limit."""
    times = {}
    for executable in executables:
        report = folder / (executable.name + ".json")
        report.unlink(missing_ok=True)
        tests = tests_of(executable, wanted)
        if not tests:
            continue
        run = Run(executable, 0, tests, 3600, report)
        if run.failed:
            print(run.output[-4000:], file=sys.stderr)
            raise SystemExit(f"without any mutant {run.test} fails: that must be mended first")
        suites = json.loads(report.read_text())["testsuites"]
        times[executable] = {f"{s['name']}.{t['name']}": float(t["time"].rstrip("s"))
                             for s in suites for t in s["testsuite"] if t["result"] == "COMPLETED"}
        print(f"{executable.name}: {len(times[executable])} tests, {run.seconds:.1f} s", flush=True)
    steps, low = [], -1.0
    for high in TIERS:
        for executable, by_test in times.items():
            chosen = {t: s for t, s in by_test.items() if low < s <= high}
            if chosen:
                steps.append((executable, list(chosen), 30 + 20 * sum(chosen.values())))
        low = high
    return steps


def test_mutant(mutant, steps):
    start = time.monotonic()
    found = None
    for executable, tests, timeout in steps:
        run = Run(executable, mutant.number, tests, timeout)
        if run.failed:
            found = run.test
            break
    return {"identity": mutant.identity(), "found": found, "seconds": round(time.monotonic() - start, 1)}


def table_of(mutants, results):
    lines = ["| mutant | where | what was broken | found by | s |", "|---|---|---|---|---|"]
    for m in mutants:
        r = results[m.name]
        found = r["found"] or (f"not: equivalent, {m.equivalent}" if m.equivalent else "**not found**")
        lines.append(f"| {m.name} | `{m.file}` {m.function} | {m.breaks} | {found} | {r['seconds']:.0f} |")
    return "\n".join(lines)


def summary_of(mutants, results):
    found = [m for m in mutants if results[m.name]["found"]]
    equivalent = [m for m in mutants if m.equivalent and not results[m.name]["found"]]
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
    p.add_argument("--list", action="store_true", help="lists the mutants and ends")
    p.add_argument("--tests", default="", metavar="REGEX", help="only tests whose `executable: suite.name` matches")
    p.add_argument("--jobs", type=int, default=1, help="mutants that are tested at a time (1)")
    p.add_argument("--resume", action="store_true", help="keeps earlier results of mutants that are the same")
    p.add_argument("--folder", type=pathlib.Path, default=ROOT / "build" / "mutation",
                   help="of the build and results (build/mutation)")
    return p.parse_args()


def main():
    args = arguments()
    everything = schemata.read_mutants(TABLES)
    mutants = chosen_by(everything, args.mutants)
    if args.list:
        for m in mutants:
            print(f"{m.number:4} {m.name:32} {m.at}: {m.breaks}")
        return 0
    folder = args.folder.resolve()
    folder.mkdir(parents=True, exist_ok=True)
    schemata.make_tree(ROOT, folder / "tree", everything)
    steps = run_unchanged(build(folder / "tree", os.cpu_count()), args.tests, folder)
    results, path, lock = {}, folder / "results.json", threading.Lock()
    if path.exists():  # of the others, and with --resume of these
        same = {m.name: m.identity() for m in everything if args.resume or m not in mutants}
        results = {n: r for n, r in json.loads(path.read_text()).items() if same.get(n) == r["identity"]}

    def one(mutant):
        result = test_mutant(mutant, steps)
        with lock:
            results[mutant.name] = result
            path.write_text(json.dumps(results, indent=1))
            print(f"{mutant.name}: {result['found'] or 'NOT FOUND'} ({result['seconds']} s)", flush=True)

    with concurrent.futures.ThreadPoolExecutor(args.jobs) as pool:
        list(pool.map(one, [m for m in mutants if m.name not in results]))
    text, share = summary_of(mutants, results)
    report = table_of(mutants, results) + "\n\n" + text + "\n"
    (folder / "table.md").write_text(report)
    print("\n" + report, end="")
    return 0 if share >= LEAST_SHARE else 1


if __name__ == "__main__":
    sys.exit(main())
