#!/usr/bin/env python3
"""The evaluation of Hachisuka, Pantaleoni and Jensen (2012) on scenes of the same kinds: equal time, several methods.

  paper.py --ups build/release/bin/ups cornell bathroom        or: paper.py all

For each scene: makes it; measures how many iterations a second each method does, the methods in turn; renders each
method and seed with the iterations that T, T/2, T/4 ... seconds allow, so that a disturbance of the machine changes the
time that is printed but not the images; compares with a reference and subtracts the reference's own variance. Writes
out/paper/SCENE/: results.csv, ratios.md, rmse.png (error against time and against samples), panel.png.
RMSE is over all pixels and channels, in cd/m2; over the seeds, the root of the mean of squares.
"""
import argparse
import csv
import math
import os
import statistics
import subprocess
import sys
from dataclasses import dataclass, field

import paper_report
from renders import Renderer, squared_errors

HERE = os.path.dirname(os.path.abspath(__file__))
CAMERA = "view"
MIN_ITERATIONS = 6  # of the slowest method at a time point: the rounding to whole ones then moves RMSE by 4 % at most


@dataclass
class Scene:
    """script: and its options. What the paper says of its scene: minutes and samples per pixel (table 2), RMSE."""
    script: list
    minutes: float
    samples: dict
    rmse: dict = field(default_factory=dict)
    reference_method: str = "ups"


def table_2(bpt, ppm, sppm, ups):
    return {"bpt": bpt, "ppm": ppm, "sppm": sppm, "ups": ups}


SCENES = {
    "bathroom": Scene(["../bathroom/make_bathroom.py", "--picture"], 240, table_2(1396, 9494, 5313, 2085),
                      {"bpt": 0.07836, "ppm": 0.04638, "ups": 0.01246}),
    "cornell": Scene(["make_cornell.py"], 32, table_2(264, 1838, 679, 484),
                     {"bpt": 0.09146, "ppm": 0.08874, "ups": 0.01536}),
    "treasures": Scene(["make_treasures.py"], 120, table_2(367, 1386, 1184, 618)),
    "conference": Scene(["make_conference.py"], 30, table_2(120, 799, 475, 237), reference_method="bpt"),
    "statue": Scene(["make_statue.py"], 10, table_2(38, 205, 112, 72)),
    "torus": Scene(["make_torus.py"], 60, table_2(448, 2438, 1508, 738)),
}


def make_scene(scene, out):
    path = os.path.join(out, "scene.glb")
    command = [sys.executable, os.path.join(HERE, scene.script[0]), *scene.script[1:], "--out", path]
    subprocess.run(command, check=True, stdout=subprocess.DEVNULL)
    return path


def calibrate(renderer, methods, seconds):
    """{method: iterations a second}: the better of two short renders, in turn so that a slow spell meets all."""
    rates = dict.fromkeys(methods, 0.0)
    for _ in range(2):
        for method in methods:
            summary = renderer.render(method, 1, ["--time", f"{seconds:g}"])
            rates[method] = max(rates[method], summary["iterations"] / summary["time_s"])
    return rates


def measured(renderer, method, seed, iterations, out, reference_dir):
    """One line of results.csv. `excess`: the mean squared errors behind it."""
    summary = renderer.render(method, seed, ["--iterations", str(iterations)], out)
    compared = renderer.compare(CAMERA, out, reference_dir)
    c, excess, camera = compared["channels"], squared_errors(compared), summary["cameras"][CAMERA]
    return {"method": method, "seed": seed, "time_s": summary["time_s"], "iterations": summary["iterations"],
            "samples_per_pixel": summary["work"]["eye_paths"] / (camera["width"] * camera["height"]),
            "rmse": math.sqrt(max(excess["rmse"], 0)), "trimmed_rmse": math.sqrt(max(excess["trimmed_rmse"], 0)),
            "relative_mse": max(excess["relative_mse"], 0), "excess": excess, "out": out,
            "reference_share": max(c["noise_b"], 0) / c["mse"] if c["mse"] > 0 else 0}


def pooled(lines):
    """The seeds of one method at one time; a square that is not positive is below the noise of the reference: nan."""
    def root(name):
        square = statistics.fmean(line["excess"][name] for line in lines)
        return math.sqrt(square) if square > 0 else math.nan

    return {"rmse": root("rmse"), "trimmed_rmse": root("trimmed_rmse"),
            "median_rmse": statistics.median(line["rmse"] for line in lines),
            "relative_mse": statistics.fmean(line["excess"]["relative_mse"] for line in lines),
            "reference_share": max(line["reference_share"] for line in lines),
            **{name: statistics.fmean(line[name] for line in lines)
               for name in ("time_s", "iterations", "samples_per_pixel")}}


def evaluate(arguments, name):
    scene, out = SCENES[name], os.path.join(arguments.out, name)
    os.makedirs(out, exist_ok=True)
    more = ("--merge-radius", f"{arguments.merge_radius:g}") if arguments.merge_radius else ()
    renderer = Renderer(arguments.ups, make_scene(scene, out), arguments.threads, more=more)
    reference_dir = os.path.join(out, "reference")
    limit = ["--time", f"{arguments.reference_time or 12 * arguments.time:g}"]
    reference = renderer.reference(arguments.reference_method or scene.reference_method, arguments.reference_seed,
                                   limit, reference_dir)
    rates = calibrate(renderer, arguments.methods, max(arguments.time / 4, 0.5))
    print(f"{name}: reference {reference['method']}, {reference['iterations']} iterations in "
          f"{reference['time_s']:.1f} s; iterations a second: "
          + ", ".join(f"{method} {rate:.3g}" for method, rate in rates.items()), flush=True)
    times = [arguments.time / 2 ** k for k in range(arguments.halvings, -1, -1)]
    left_out = [time for time in times[:-1] if min(rates.values()) * time < MIN_ITERATIONS]
    if left_out:
        print(f"{name}: too short for {MIN_ITERATIONS} iterations, left out: "
              + ", ".join(f"{t:g} s" for t in left_out))
    times = times[len(left_out):]
    lines = {(method, time): [] for method in arguments.methods for time in times}
    for seed in range(1, arguments.seeds + 1):
        for time in times:
            for method in arguments.methods:
                iterations = max(1, round(rates[method] * time))
                folder = os.path.join(out, "images", f"{method}_{time:g}s_{seed}")
                lines[method, time].append(measured(renderer, method, seed, iterations, folder, reference_dir))
        spent = {method: lines[method, times[-1]][-1]["time_s"] for method in arguments.methods}
        print(f"{name}: seed {seed}, time of {times[-1]:g} s: "
              + ", ".join(f"{method} {s:.2f} s" for method, s in spent.items()), flush=True)
    write_csv(os.path.join(out, "results.csv"), name, lines)
    points = {key: pooled(of_seeds) for key, of_seeds in lines.items()}
    table = paper_report.ratios(name, scene, arguments.methods, times, points)
    with open(os.path.join(out, "ratios.md"), "w", encoding="utf-8") as file:
        file.write(table)
    print(table, flush=True)
    paper_report.plot(os.path.join(out, "rmse.png"), name, arguments.methods, times, points, lines)
    paper_report.panel(os.path.join(out, "panel.png"), name, scene, arguments.methods, times[-1], points, lines,
                       reference_dir, CAMERA)


def write_csv(path, name, lines):
    columns = ["method", "seed", "time_s", "iterations", "samples_per_pixel", "rmse", "trimmed_rmse", "relative_mse"]
    with open(path, "w", newline="", encoding="utf-8") as file:
        writer = csv.writer(file)
        writer.writerow(["scene", *columns])
        for of_seeds in lines.values():
            for line in of_seeds:
                writer.writerow([name, *(f"{line[c]:.6g}" if isinstance(line[c], float) else line[c] for c in columns)])


def parse():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("scenes", nargs="+", choices=[*SCENES, "all"], metavar="SCENE",
                        help=", ".join([*SCENES, "all"]))
    parser.add_argument("--ups", default="build/release/bin/ups", help="the program")
    parser.add_argument("--methods", nargs="+", default=["bpt", "ppm", "sppm", "ups"])
    parser.add_argument("--time", type=float, default=10, help="T: seconds of the longest renders (10)")
    parser.add_argument("--halvings", type=int, default=4, help="further points of the curve: T/2, T/4 ... (4)")
    parser.add_argument("--seeds", type=int, default=3, help="renders of each method and time (3)")
    parser.add_argument("--threads", type=int, help="default: all")
    parser.add_argument("--merge-radius", type=float, help="first radius of all pixels, m; default: the library's own")
    parser.add_argument("--reference-method", help="default: ups; in the conference room bpt")
    parser.add_argument("--reference-time", type=float, help="seconds; default: 12 T")
    parser.add_argument("--reference-seed", type=int, default=1001)
    parser.add_argument("--out", default="out/paper")
    arguments = parser.parse_args()
    if arguments.reference_seed <= arguments.seeds:
        parser.error("the reference needs a seed of its own")
    return arguments


def main():
    arguments = parse()
    for name in SCENES if "all" in arguments.scenes else arguments.scenes:
        evaluate(arguments, name)


if __name__ == "__main__":
    main()
