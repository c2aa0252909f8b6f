#!/usr/bin/env python3
"""What `auto` must show: prints each figure beside what is wanted; the exit code is 1 where one is not reached.

  must_show.py --ups build/release/bin/ups --baseline ../earlier/build/release/bin/ups [glass hall best bathroom]

glass     an office with 1 m2 of picture glass by auto, over the one without it by pt; without it auto over the
          baseline's auto: CPU time to the same noise of the meters
hall      the same flux from 1,024 and 10,000 luminaires, over 16: CPU time to the same noise
best      auto over the best fixed method in each scene of choose.py; always-full ups over auto in the office and the
          conference room
bathroom  ups over the baseline's ups at equal CPU time: squared error of the image without the worst 0.1 % of the
          pixels, against a reference by the baseline; variance of the meters

Costs are CPU time x squared standard error (measuring.py). Without --baseline what needs it is left out. Programs and
methods take turns on one thread, seeds 1, 2, ...; the figures are ratios, so the machine may do something else too.
"""
import argparse
import os
import statistics
import sys

import choose
import judged_scenes
from measuring import BATCHES, Candidate, image_costs_by_reference, take_turns, to_1_percent


class Figures:
    """Prints figures as they come; remembers whether one missed what is wanted."""
    def __init__(self):
        self.missed = False

    def tell(self, what, figure, wanted, at_least=False):
        reached = figure >= wanted if at_least else figure <= wanted
        self.missed |= not reached
        print(f"{what}: {figure:.2f}, wanted {'>=' if at_least else '<='} {wanted:g}{'' if reached else ': MISSED'}",
              flush=True)


def costs(arguments, candidates, out):
    """{label: CPU seconds to 1 %}"""
    runs = take_turns(candidates, arguments.seconds, arguments.seeds, out)
    return {label: to_1_percent(of_label) for label, of_label in runs.items()}


def glass(arguments, figures):
    out = os.path.join(arguments.out, "glass")
    plain, pane = (judged_scenes.make(name, os.path.join(out, name)) for name in ("office", "office_glass"))
    candidates = [Candidate(arguments.ups, "pt", plain), Candidate(arguments.ups, "auto", plain),
                  Candidate(arguments.ups, "auto", pane, "with glass")]
    if arguments.baseline:
        candidates.append(Candidate(arguments.baseline, "auto", plain, "baseline"))
    of = costs(arguments, candidates, out)
    figures.tell("office with 1 m2 of glass by auto over the one without by pt", of["with glass"] / of["pt"], 1.15)
    if arguments.baseline:
        figures.tell("office without glass by auto over the baseline", of["auto"] / of["baseline"], 0.5)


def hall(arguments, figures):
    out = os.path.join(arguments.out, "hall")
    of = costs(arguments, [Candidate(arguments.ups, "auto", judged_scenes.make("hall", os.path.join(out, f"of_{n}"),
                                                                               luminaires=n), n)
                           for n in (16, 1024, 10000)], out)
    for n, wanted in ((1024, 2), (10000, 3)):
        figures.tell(f"hall of {n} luminaires over 16, by auto ({of[n]:.2f} s to 1 %)", of[n] / of[16], wanted)


def best(arguments, figures):
    for name in judged_scenes.NAMES:
        measured = choose.measure(name, arguments)
        whats = ("meters", "image", "image without the worst pixels")
        for what, ratio, auto, full in zip(whats, measured.ratios("auto"), measured.of["auto"], measured.of["ups"]):
            if ratio is None:
                continue
            figures.tell(f"{name}, {what}: auto over the best fixed method", ratio, 1.1)
            if name in ("office", "conference"):
                figures.tell(f"{name}, {what}: always-full ups over auto", full / auto, 2, at_least=True)


def bathroom(arguments, figures):
    if not arguments.baseline:
        return print("bathroom: left out, it needs --baseline")
    out, size = os.path.join(arguments.out, "bathroom"), judged_scenes.SIZES["bathroom"]
    scene = judged_scenes.make("bathroom", out)
    now = Candidate(arguments.ups, "ups", scene, "ups", size)
    before = Candidate(arguments.baseline, "ups", scene, "baseline", size)
    # At equal time, as what merging brings does not fall as 1 / time: so long that whole batches differ little in it.
    seconds = max(arguments.seconds, *(16 * c.render(1, BATCHES // 4)["cpu_s"] for c in (now, before)))
    runs = take_turns([now, before], seconds, arguments.seeds, out)
    reference = os.path.join(out, "reference")
    before.render(1001, before.calibrated(arguments.reference * seconds), reference)
    images = image_costs_by_reference(runs, arguments.ups, reference)
    figures.tell("bathroom: squared error of ups without the worst 0.1 % of the pixels over the baseline",
                 images["ups"][1] / images["baseline"][1], 0.6)
    figures.tell("bathroom: variance of the meters by ups over the baseline",
                 to_1_percent(runs["ups"]) / to_1_percent(runs["baseline"]), 0.5)
    spent = {label: statistics.fmean(run.cpu_s for run in of_label) for label, of_label in runs.items()}
    print("  CPU seconds of a render: " + ", ".join(f"{label} {s:.1f}" for label, s in spent.items()))


def run_cases(doc, cases, out, **numbers):
    """The command line of a script of cases, functions of (arguments, figures) by name; numbers: (default, help) of further
    options. Exits with 1 where a figure is missed."""
    parser = argparse.ArgumentParser(description=doc, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("cases", nargs="*", metavar="CASE", help="some of: " + ", ".join(cases))
    parser.add_argument("--ups", default="build/release/bin/ups", help="the program")
    parser.add_argument("--baseline", help="an earlier build of the program")
    for name, (default, help_text) in numbers.items():
        parser.add_argument(f"--{name}", type=float, default=default, help=f"{help_text} ({default})")
    parser.add_argument("--seeds", type=int, default=4, help="renders of each (4)")
    parser.add_argument("--out", default=out)
    arguments = parser.parse_args()
    unknown = set(arguments.cases) - set(cases)
    if unknown:
        parser.error(f"{sorted(unknown)}: the cases are {list(cases)}")
    figures = Figures()
    for name in arguments.cases or cases:
        cases[name](arguments, figures)
    sys.exit(1 if figures.missed else 0)


if __name__ == "__main__":
    run_cases(__doc__, {case.__name__: case for case in (glass, hall, best, bathroom)}, "out/must_show",
              seconds=(10, "CPU time of a render"), reference=(12, "of the bathroom: renders' times so much"))
