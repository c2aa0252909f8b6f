#!/usr/bin/env python3
"""Which method is nearest to a reference after equal time? Runs `ups render` and prints one line a method.

  compare_methods.py --ups build/release/bin/ups --scene bathroom.glb --methods ups bpt ppm --time 60 --seeds 8

The reference is rendered with another seed: by default the method `ups` for 100 times the time. Meters:
error = sum |E - E_reference| / sum E_reference over all meters. Cameras: `ups compare` of the EXR images; the median
over the seeds beside the mean, as one firefly can make a mean. With --max-error the exit code is 1 when a method's mean
error of the meters is larger, with --min-rmse-ratio when mean or median RMSE of another method is not so many times
that of the first.
"""
import argparse
import math
import os
import statistics
import sys

from renders import Renderer, read_table


def illuminances(folder, names):
    return {name: [row["illuminance_lx"] for row in read_table(folder, name)] for name in names}


def meter_error(measured, reference):
    """sum |E - E_reference| / sum E_reference over all meters of all sets."""
    difference = total = 0.0
    for name, expected in reference.items():
        if len(measured[name]) != len(expected):
            sys.exit(f"meters {name}: {len(measured[name])} values, the reference has {len(expected)}")
        difference += sum(abs(a - b) for a, b in zip(measured[name], expected))
        total += sum(expected)
    return difference / total if total > 0 else math.nan


def mean(values):
    return sum(values) / len(values) if values else math.nan


def cell(values, width, scale=1.0, unit=""):
    """The mean for the table; a dash where the scene has nothing of the kind."""
    return f"{scale * mean(values):.4g}{unit}".rjust(width) if values else "-".rjust(width)


def judge(arguments, renderer, method, reference_dir, reference, names):
    """Renders one method with every seed; returns its line of the table."""
    line = {"method": method, "iterations": [], "time": [], "meters": [], "rmse": [], "relative_mse": []}
    for seed in range(1, arguments.seeds + 1):
        if seed == arguments.reference_seed:
            sys.exit(f"seed {seed} is the reference's: their errors would be the same")
        out = os.path.join(arguments.out, f"{method}_{seed}")
        summary = renderer.render(method, seed, ["--time", str(arguments.time)], out)
        line["iterations"].append(summary["iterations"])
        line["time"].append(summary["time_s"])
        if reference:
            line["meters"].append(meter_error(illuminances(out, names), reference))
        for camera in summary["cameras"]:
            compared = renderer.compare(camera, out, reference_dir)
            line["rmse"].append(compared["rmse"])
            line["relative_mse"].append(compared["relative_mse"])
    return line


def parse():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--ups", required=True, help="the program")
    parser.add_argument("--scene", required=True)
    parser.add_argument("--methods", nargs="+", default=["ups", "bpt", "ppm"])
    parser.add_argument("--time", type=float, default=30, help="seconds a render")
    parser.add_argument("--seeds", type=int, default=1, help="renders a method")
    parser.add_argument("--threads", type=int)
    parser.add_argument("--size", help="WxH of the cameras")
    parser.add_argument("--out", default="out/evaluation")
    parser.add_argument("--reference-method", default="ups")
    parser.add_argument("--reference-seed", type=int, default=1001)
    parser.add_argument("--reference-time", type=float, help="seconds; without it 100 times --time")
    parser.add_argument("--reference-iterations", type=int, help="instead of a time")
    parser.add_argument("--reference-dir", help="where the reference is kept; default: OUT/reference")
    parser.add_argument("--meters", nargs="+", help="names of the meter sets that count; default: all")
    parser.add_argument("--min-rmse-ratio", type=float,
                        help="fail where another method's RMSE is less than this many times the first method's")
    parser.add_argument("--max-error", type=float, help="fail above this error of the meters, e.g. 0.005")
    return parser.parse_args()


def main():
    arguments = parse()
    renderer = Renderer(arguments.ups, arguments.scene, arguments.threads, arguments.size)
    reference_dir = arguments.reference_dir or os.path.join(arguments.out, "reference")
    limit = (["--iterations", str(arguments.reference_iterations)] if arguments.reference_iterations
             else ["--time", str(arguments.reference_time or 100 * arguments.time)])
    reference_summary = renderer.reference(arguments.reference_method, arguments.reference_seed, limit, reference_dir)
    names = arguments.meters or list(reference_summary["meters"])
    unknown = set(names) - set(reference_summary["meters"])
    if unknown:
        sys.exit(f"no meters {sorted(unknown)}; the scene has {list(reference_summary['meters'])}")
    reference = illuminances(reference_dir, names)
    # A reference has noise of its own; the errors below cannot be read finer than this.
    total = sum(sum(values) for values in reference.values())
    noise = sum(max(row["standard_error_lx"], 0.0) for name in names for row in read_table(reference_dir, name))
    if names and total > 0:
        print(f"reference: mean standard error {100 * noise / total:.3f} % of the mean")

    print(f"{'method':>8} {'iterations':>10} {'time_s':>7} {'meters: error':>14} {'camera: RMSE':>13} {'median':>8} "
          f"{'relative MSE':>13}")
    failed, first = False, None
    for method in arguments.methods:
        line = judge(arguments, renderer, method, reference_dir, reference, names)
        error = mean(line["meters"])
        print(f"{method:>8} {mean(line['iterations']):10.0f} {mean(line['time']):7.1f} "
              f"{cell(line['meters'], 14, 100, ' %')} {cell(line['rmse'], 13)} "
              f"{cell([statistics.median(line['rmse'])] if line['rmse'] else [], 8)} {cell(line['relative_mse'], 13)}",
              flush=True)
        if arguments.max_error is not None and not error <= arguments.max_error:
            print(f"  over the limit of {100 * arguments.max_error:g} %")
            failed = True
        first = first or line
        if arguments.min_rmse_ratio is not None and line is not first:
            ratios = [of(line["rmse"]) / of(first["rmse"]) for of in (mean, statistics.median)]
            print(f"  RMSE over that of {first['method']}: mean {ratios[0]:.2f}, median {ratios[1]:.2f}")
            failed = failed or not min(ratios) >= arguments.min_rmse_ratio
    sys.exit(1 if failed else 0)


if __name__ == "__main__":
    main()
