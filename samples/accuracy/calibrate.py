#!/usr/bin/env python3
"""Does what the program states of its meters hold? Renders scenes of known answer with many seeds and counts.

  calibrate.py --ups build/release/bin/ups [--scenes mirror water ...] [--seeds 100] [--seed N] [--out out/calibration]
  calibrate.py --ups build/release/bin/ups --target [--seeds 50] [--seed N] [--out out/calibration]

Wanted of every scene: the stated bound of 95 % holds in 93 to 99 % of the readings that are sampled with noise, and the
median of bound / |error| is at most 5. The exit code is 1 where a scene is beyond that by more than 2 standard errors,
by the spread over the seeds. Seeds are new in each run; the first is printed, and --seed repeats it.

With --target instead: of renders that a target of 2 % ends, at least 93 % must keep it.

OUT gets calibration.csv, a row a scene, and calibration_meters.csv, a row a meter, or targets.csv. README.md says what
stands in them.
"""
import argparse
import csv
import os
import secrets
import sys
from concurrent.futures import ProcessPoolExecutor

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path[:0] = [os.path.join(HERE, "..", "scenes_common"), os.path.join(HERE, "..", "evaluation")]
import need_numpy  # noqa: E402,F401
import calibration  # noqa: E402
import known_light  # noqa: E402
import referenced_light  # noqa: E402
import stopping  # noqa: E402
from renders import Renderer, read_table  # noqa: E402

SCENES = {"mirror": lambda: (known_light.mirror(64), known_light.mirror(256)),
          "water": lambda: (known_light.water(),),
          "parabola": lambda: (known_light.parabola(),),
          "caustic": lambda: (known_light.caustic(1024, 64), known_light.caustic(16384, 64)),
          "office": lambda: (referenced_light.office(),),
          "atrium": lambda: (referenced_light.atrium(),),
          "bathroom": lambda: (referenced_light.bathroom(),)}


def render(ups, path, words, size, seed, out):
    """The rows of the scene's meters. Called in processes of its own."""
    summary = Renderer(ups, path, 1, size, ("--map-cells",)).render("auto", seed, list(words), out)
    return [row for name in summary["meters"] for row in read_table(out, name)]


def readings_of(ups, pool, scene, seeds, out):
    folder = os.path.join(out, scene.name)
    os.makedirs(folder, exist_ok=True)
    path = scene.scene(folder)
    truth, truth_noise = scene.truth(ups, path, folder)
    runs = [pool.submit(render, ups, path, scene.words, scene.size, seed, os.path.join(folder, f"seed_{k}"))
            for k, seed in enumerate(seeds)]
    return calibration.read([run.result() for run in runs], truth, truth_noise)


def told(value, form):
    return "-" if value == calibration.UNKNOWN else format(value, form)


def print_scene(title, row):
    apart = "; ".join(f"{kind} {told(row[kind + '_held'], '.1%')} of {row[kind + '_readings']}"
                      for kind in ("exact", "dark", "unknown") if row[kind + "_readings"])
    print(f"{title}: bounds hold in {told(row['noisy_held'], '.1%')} (+- {told(row['noisy_held_error'], '.1%')}) of "
          f"{row['noisy_readings']}{'; ' + apart if apart else ''}; width {told(row['width'], '.2f')} "
          f"(+- {told(row['width_error'], '.2f')}); error {told(row['rms_error'], '.2%')} rms, "
          f"{told(row['error_over_stated'], '.2f')} of the standard error stated, "
          f"spread {told(row['spread_over_stated'], '.2f')}", flush=True)
    if row["reference_over_error"] > 0:
        print(f"  the reference's standard error is {row['reference_over_error']:.2f} of that error", flush=True)


def write_table(path, rows):
    with open(path, "w", newline="", encoding="utf-8") as file:
        writer = csv.DictWriter(file, list(rows[0]))
        writer.writeheader()
        writer.writerows({key: f"{value:.6g}" if isinstance(value, float) else value for key, value in row.items()}
                         for row in rows)


def parse():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--ups", default="build/release/bin/ups", help="the program")
    parser.add_argument("--scenes", nargs="+", choices=list(SCENES), default=list(SCENES), metavar="SCENE",
                        help="some of: " + ", ".join(SCENES))
    parser.add_argument("--target", action="store_true",
                        help="instead, of the office and the bathroom: renders that a target of 2 %% ends")
    parser.add_argument("--seeds", type=int, help="renders of each scene (100; with --target 50)")
    parser.add_argument("--seed", type=int, help="the first seed")
    parser.add_argument("--jobs", type=int, default=1, help="renders at once, each on one thread (1)")
    parser.add_argument("--out", default="out/calibration")
    arguments = parser.parse_args()
    if arguments.seeds is None:
        arguments.seeds = 50 if arguments.target else 100
    if arguments.seeds < 2:
        parser.error("--seeds: at least 2, of whose spread the figures are judged")
    if arguments.target and not {"office", "bathroom"} & set(arguments.scenes):
        parser.error("--target: of the scenes office and bathroom alone")
    return arguments


def tell(failures):
    for failure in failures:
        print(f"  FAILED: {failure}", flush=True)
    return bool(failures)


def calibrate(arguments, pool, seeds):
    """Whether a scene fails."""
    rows, meters, failed = [], [], False
    for name in arguments.scenes:
        for scene in SCENES[name]():
            readings = readings_of(arguments.ups, pool, scene, seeds, arguments.out)
            row = {"scene": scene.name, "seeds": len(seeds), **calibration.figures(readings)}
            print_scene(scene.title, row)
            failed |= tell(calibration.failures(row))
            rows.append(row)
            meters += [{"scene": scene.name, **m} for m in calibration.of_meters(readings)]
            write_table(os.path.join(arguments.out, "calibration.csv"), rows)
            write_table(os.path.join(arguments.out, "calibration_meters.csv"), meters)
    return failed


def end_by_target(arguments, pool, seeds):
    """Whether a target is not kept."""
    rows, failed = [], False
    for row, failures in stopping.measure(arguments.ups, pool, arguments.scenes, seeds, arguments.out):
        print(f"{row['scene']}, {row['criterion']} meter to {row['target']:.0%}: kept in {row['kept']:.0%} of "
              f"{row['seeds']} seeds (largest true error {row['largest_error']:.2%}, mean {row['mean_error']:.2%}), "
              f"bounds hold in {row['held']:.1%}; {row['iterations']:.0f} iterations, {row['cpu_s']:.1f} s of "
              "processor time", flush=True)
        failed |= tell(failures)
        rows.append(row)
        write_table(os.path.join(arguments.out, "targets.csv"), rows)
    return failed


def main():
    arguments = parse()
    first = arguments.seed if arguments.seed is not None else secrets.randbelow(2 ** 31)
    print(f"seeds from {first}", flush=True)
    seeds = range(first, first + arguments.seeds)
    with ProcessPoolExecutor(arguments.jobs) as pool:
        failed = (end_by_target if arguments.target else calibrate)(arguments, pool, seeds)
    sys.exit(1 if failed else 0)


if __name__ == "__main__":
    main()
