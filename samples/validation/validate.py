#!/usr/bin/env python3
"""Renders the validation cases, judges every check, and writes the tables.

  python3 samples/validation/validate.py --ups build/release/bin/ups [--methods ups bpt pt] [--cases cie_5_2 ...]
      [--fast] [--unjudged N] [--jobs N] [--plot] --out out/validation

OUT gets results.json, results.md, with --plot validation.png, and for each case its scene and the program's files. The
readings of chosen --cases are printed too. Exit code 1 where a check fails. What the cases are: README.md.
"""
import argparse
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "scenes_common"))
import need_numpy  # noqa: E402,F401
import cie171  # noqa: E402
import fixtures  # noqa: E402
import harness  # noqa: E402
import tables  # noqa: E402


def all_cases():
    return [*cie171.cases(), *fixtures.cases()]


def parse(cases):
    names, groups = ([*dict.fromkeys(words)] for words in ((c.name for c in cases), (c.group for c in cases)))
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--ups", required=True, help="the program")
    parser.add_argument("--methods", nargs="+", default=["ups", "bpt", "pt"])
    parser.add_argument("--cases", nargs="+", metavar="CASE", choices=[*names, *groups],
                        help="cases or groups of cases: " + " ".join(groups))
    parser.add_argument("--fast", action="store_true", help="only what the tests run")
    low_effort = os.environ.get("UPS_TEST_EFFORT") == "low"  # of tests under sanitizers
    parser.add_argument("--unjudged", type=int, default=64 if low_effort else 0, metavar="N",
                        help="nothing is judged: an Nth of the iterations, to see that all of it runs")
    processors = len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count()
    parser.add_argument("--jobs", type=int, default=processors, help="renders at once, each on one thread")
    parser.add_argument("--plot", action="store_true", help="needs matplotlib")
    parser.add_argument("--out", default="out/validation")
    return parser.parse_args()


def main():
    cases = all_cases()
    arguments = parse(cases)
    if arguments.cases:
        cases = [c for c in cases if c.name in arguments.cases or c.group in arguments.cases]
    if arguments.fast:
        cases = [c.for_tests() for c in cases if c.fast]
    if arguments.unjudged:
        cases = [c.unjudged(arguments.unjudged) for c in cases]
        print(f"nothing is judged: one in {arguments.unjudged} of the iterations")
    rows = harness.run(os.path.abspath(arguments.ups), cases, arguments.methods, arguments.out, arguments.jobs)
    tables.write_json(os.path.join(arguments.out, "results.json"), cases, rows, arguments.methods)
    tables.write_markdown(os.path.join(arguments.out, "results.md"), cases, rows, arguments.methods)
    print("\n" + tables.summary_table(cases, rows, arguments.methods))
    if arguments.cases:
        print("\n" + "\n".join(tables.check_table(case, rows, arguments.methods) for case in cases))
    if arguments.plot:
        import plot  # the only part that needs matplotlib
        plot.write(os.path.join(arguments.out, "validation.png"), cases, rows, arguments.methods)
    failed = [r for r in rows if r.passed is False]
    for r in failed:
        print(f"FAILED {r.case} {r.method} {r.check}: {r.E:.6g} +- {r.standard_error:.2g} lx, expected {r.E_ref:.6g}",
              file=sys.stderr)
    sys.exit(1 if failed or not rows else 0)


if __name__ == "__main__":
    main()
