#!/usr/bin/env python3
"""Does what a render foretells hold? Says of each seed what it foretold at a quarter of the way, over what it took.

  foretold.py --ups build/release/bin/ups [--scenes office atrium bathroom] [--seeds 10] [--out out/foretold]

A render of each seed ends by a target; where its curve of convergence meets the target for good are the actual
iterations. Another render of the same seed, so with the same random numbers, ends at a quarter of these, and what it
foretells for the target is compared. Its seconds become iterations by what its own took, so that it does not matter
what else runs on the machine.

Wanted: foretold over actual within a factor of 1.5 in 9 of 10 seeds; a quarter that foretells nothing is a miss.
The exit code is 1 where that is not reached. OUT gets foretold.csv, a row a seed; README.md says what stands in it.
"""
import argparse
import math
import os
import sys
from types import SimpleNamespace

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path[:0] = [os.path.join(HERE, "..", "scenes_common"), os.path.join(HERE, "..", "evaluation")]
import need_numpy  # noqa: E402,F401
import errors  # noqa: E402
import measure  # noqa: E402
from calibrate import write_table  # noqa: E402
from must_show import Figures  # noqa: E402
from renders import Renderer  # noqa: E402
from stopping import MOST  # noqa: E402

QUARTER, FACTOR, WANTED = 0.25, 1.5, 0.9
ERRORS = (0.05, 0.02, 0.01, 0.005)  # that every render foretells
# The criterion, and further words of `ups render`. The program knows no error before its 16th iteration: the office's
# median meter is at 1 % by then, and the atrium's soon after unless its iterations are small.
SCENES = {"office": ("p95", ()), "atrium": ("median", ("--light-paths", "1024")), "bathroom": ("median", ())}


def in_iterations(early, predictions, once):
    """Seconds of the clock as iterations, by what the render's own took; `once`: what is done but once, as iterations.
    """
    def count(seconds):
        took = early["iterations"] + once
        return took * seconds / early["time_s"] - once if seconds >= 0 else errors.UNKNOWN
    return [{**p, **{key: count(p[key]) for key in ("seconds", "low", "high")}} for p in predictions]


def done_once(curve):
    first, last = curve[0], curve[-1]
    each = (last["time_s"] - first["time_s"]) / (last["iterations"] - first["iterations"])
    return max(first["time_s"] / each - first["iterations"], 0.0)


def compare(renderer, criterion, error, seed):
    """A row of the table."""
    target = ["--target-of", criterion]
    whole = renderer.render("auto", seed, ["--target-error", str(error), "--iterations", str(MOST), *target])
    curve = [{**c, "time_s": c["iterations"]} for c in whole["convergence"]]
    status, actual = errors.time_to([(c["time_s"], c[f"{criterion}_relative_error"]) for c in curve], error)
    row = {"seed": seed, "status": status, "actual_iterations": actual, "made_at_iterations": errors.UNKNOWN,
           "foretold_iterations": errors.UNKNOWN, "low_iterations": errors.UNKNOWN, "high_iterations": errors.UNKNOWN,
           "limited_by": "", "ratio": errors.UNKNOWN, "came_true": errors.UNKNOWN}
    if status != "reached":
        return row
    count = max(1, round(QUARTER * actual))
    early = renderer.render("auto", seed, ["--iterations", str(count), *target])
    made = [p for p in early["prediction"] if math.isclose(p["relative_error"], error)]
    made = in_iterations(early, made, done_once(whole["convergence"]))
    for found in errors.predicted_and_actual(made, criterion, curve, 1.0, 1.0, count):
        told = found["predicted_seconds"]
        row |= {"made_at_iterations": count, "foretold_iterations": told, "low_iterations": found["low_seconds"],
                "high_iterations": found["high_seconds"], "limited_by": found["limited_by"],
                "ratio": told / actual if told >= 0 else errors.UNKNOWN, "came_true": int(errors.came_true(found))}
    return row


def told_of(row):
    if row["status"] != "reached":
        return "not reached" if row["status"] == "later" else "too soon"
    if row["made_at_iterations"] < 0:
        return "nothing foretold"
    return f"{row['ratio']:.2f}" if row["ratio"] >= 0 else "never"


def judge(name, criterion, error, rows, figures):
    within = sum(1 / FACTOR <= row["ratio"] <= FACTOR for row in rows)
    held = sum(row["came_true"] == 1 for row in rows)
    taken = sorted(row["actual_iterations"] for row in rows)
    print(f"{name}, {error:.1%} of the {criterion} meter after {taken[0]:.0f} to {taken[-1]:.0f} iterations; foretold "
          f"over actual: {', '.join(map(told_of, rows))}; {held} of {len(rows)} within [low, high]")
    figures.tell(f"{name}: seeds within a factor of {FACTOR:g}, of {len(rows)}", within, WANTED * len(rows),
                 at_least=True)


def parse():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--ups", default="build/release/bin/ups", help="the program")
    parser.add_argument("--scenes", nargs="+", choices=list(SCENES), default=list(SCENES), metavar="SCENE",
                        help="some of: " + ", ".join(SCENES))
    parser.add_argument("--seeds", type=int, default=10, help="of each scene (10)")
    parser.add_argument("--seed", type=int, default=1, help="the first one (1)")
    parser.add_argument("--error", type=float, default=0.01, choices=ERRORS, help="the target (0.01)")
    parser.add_argument("--target-of", choices=("worst", "p95", "mean", "median"),
                        help="its criterion (of the bathroom and the atrium median, of the office p95)")
    parser.add_argument("--threads", type=int, default=1, help="of a render (1: of more, the clock wavers)")
    parser.add_argument("--out", default="out/foretold")
    return parser.parse_args()


def main():
    arguments = parse()
    os.makedirs(arguments.out, exist_ok=True)
    figures, table = Figures(), []
    for name in arguments.scenes:
        criterion, more = SCENES[name]
        criterion = arguments.target_of or criterion
        scene = measure.make_scene(SimpleNamespace(ups=arguments.ups, out=arguments.out), name)
        renderer = Renderer(arguments.ups, scene.path, arguments.threads, measure.SIZE, more)
        rows = []
        for seed in range(arguments.seed, arguments.seed + arguments.seeds):
            rows.append({"scene": name, "criterion": criterion, "relative_error": arguments.error,
                         **compare(renderer, criterion, arguments.error, seed)})
            write_table(os.path.join(arguments.out, "foretold.csv"), table + rows)
        table += rows
        judge(name, criterion, arguments.error, rows, figures)
    sys.exit(1 if figures.missed else 0)


if __name__ == "__main__":
    main()
