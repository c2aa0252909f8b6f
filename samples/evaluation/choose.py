#!/usr/bin/env python3
"""Did `auto` choose well? CPU time x squared error of `auto` and of fixed methods, as ratios to the best fixed one.

  choose.py --ups build/release/bin/ups office bathroom [--methods auto pt bpt ups ups-connect] [--seconds 10]
  choose.py --ups build/release/bin/ups --baseline ../earlier/build/release/bin/ups all

Methods are those of `ups render`; "ups-connect-merge" is ups without these techniques. On a scene all take turns, for
about the same CPU time on one thread, or with --iterations for the same iterations. Columns: meters: CPU seconds
until the median meter's standard error is 1 %. Image: CPU time x relative variance as the pixels report it, and
without the worst 0.1 % of the pixels; with --reference SECONDS, of squared differences from an image by `ups` of so
long (trimmed: not relative). In brackets, over the best fixed method. One that misses light (it says so, or a mean
differs from that of `ups` by more than its noise and bias) is listed but is never the best. How costs are measured:
measuring.py.
"""
import argparse
import os

import judged_scenes
from measuring import (Candidate, chosen, image_costs, image_costs_by_reference, missed_light, print_table, take_turns,
                       to_1_percent)

FIXED = ("pt", "bpt", "ups", "ups-connect", "ups-merge")
BASELINE = "baseline "
HEADER = ("method", "iterations", "CPU, s", "meters, s to 1 %", "image", "image, trimmed", "", "techniques")


class Costs:
    """Of one scene. `of`: {label: (meters, image, trimmed image)}, None where the scene has no such sensor."""
    def __init__(self, runs, images):
        self.runs = runs
        self.of = {label: (to_1_percent(of_label) if of_label[0].meters else None, *images.get(label, (None, None)))
                   for label, of_label in runs.items()}
        self.missing = {label: missed_light(of_label, runs["ups"]) for label, of_label in runs.items()}

    def best(self, column):
        """The least of the fixed methods that miss nothing, of this program."""
        return min((costs[column] for label, costs in self.of.items()
                    if label != "auto" and not label.startswith(BASELINE) and not self.missing[label]
                    and costs[column] is not None), default=None)

    def ratios(self, label):
        """To the best; None where there is none."""
        return [None if cost is None else cost / self.best(column) for column, cost in enumerate(self.of[label])]

    def rows(self):
        for label, costs in self.of.items():
            cells = ["–" if cost is None else f"{cost:.3g} ({ratio:.2f})"
                     for cost, ratio in zip(costs, self.ratios(label))]
            run = self.runs[label][0]
            yield (label, str(run.report["iterations"]), f"{run.cpu_s:.1f}", *cells, self.missing[label],
                   chosen(run.report))


def measure(name, arguments, methods=("auto", *FIXED), baseline=None, iterations=None, reference=None):
    """Costs in one scene; `arguments`: ups, seconds, seeds, out."""
    out = os.path.join(arguments.out, name)
    scene, size = judged_scenes.make(name, out), judged_scenes.SIZES.get(name, judged_scenes.SIZE)
    ups = Candidate(arguments.ups, "ups", scene, "ups", size)  # what light there is
    candidates = [*(Candidate(arguments.ups, m, scene, m, size) for m in methods if m != "ups"), ups]
    if baseline:
        candidates += [Candidate(baseline, m, scene, BASELINE + m, size) for m in ("auto", "ups")]
    runs = take_turns(candidates, arguments.seconds, arguments.seeds, out, iterations)
    if reference is None:
        return Costs(runs, image_costs(runs))
    folder = os.path.join(out, "reference")
    ups.render(1001, ups.calibrated(reference), folder)
    return Costs(runs, image_costs_by_reference(runs, arguments.ups, folder))


def parse():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("scenes", nargs="+", choices=[*judged_scenes.NAMES, "all"], metavar="SCENE",
                        help=", ".join([*judged_scenes.NAMES, "all"]))
    parser.add_argument("--ups", default="build/release/bin/ups", help="the program")
    parser.add_argument("--baseline", help="another build of the program, whose auto and ups take turns too")
    parser.add_argument("--methods", nargs="+", default=["auto", *FIXED])
    parser.add_argument("--seconds", type=float, default=10, help="CPU time of a render (10)")
    parser.add_argument("--iterations", type=int, help="of every method, instead")
    parser.add_argument("--seeds", type=int, default=3, help="renders of each method (3)")
    parser.add_argument("--reference", type=float, metavar="SECONDS", help="judge images by one of so much CPU time")
    parser.add_argument("--out", default="out/choose")
    return parser.parse_args()


def main():
    arguments = parse()
    for name in judged_scenes.NAMES if "all" in arguments.scenes else arguments.scenes:
        print(f"\n{name}\n", flush=True)
        costs = measure(name, arguments, arguments.methods, arguments.baseline, arguments.iterations,
                        arguments.reference)
        print_table(HEADER, costs.rows())


if __name__ == "__main__":
    main()
