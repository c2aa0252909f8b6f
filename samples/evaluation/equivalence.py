#!/usr/bin/env python3
"""Does `auto` measure the same light as `ups` with all techniques? In every scene, to within 1 %.

  equivalence.py --ups build/release/bin/ups [SCENE ...] [--max-seconds 300]      --list prints the scenes

Compared are the means of each set of meters, of each quarter of each camera's image (mean luminance of R, G, B) and
the flux of each goniometer, by two one-sided t tests (Schuirmann 1987): the methods count as equal where it is proven
that their means differ by less than 1 %. Over all quantities of all scenes p is corrected by Holm (1979): the chance to
call even one pair equal that differs by 1 % or more is at most 5 %. Standard errors are those that the program reports;
of a quarter of an image, whose pixels share light paths, the spread of 8 seeds.

A pilot says how many iterations make the standard error of the difference a sixth of 1 %; then each method renders 8
seeds, once, and where that does not decide once more with 4 times the iterations and other seeds, and p is twice the
lesser one. Where --max-seconds a scene (wall time) do not allow that many iterations, what they allow is rendered. Not
decided is not passed: the exit code is 1 unless every quantity is proven equal. Where `auto` gives the very bits of
`ups`, nothing is left to test. Images are not too small: the discs of merging, about a pixel wide, lose light at edges,
which no error reports (at 128 x 96 pixels 0.6 % of the darkest quarter of the conference room).
"""
import argparse
import csv
import math
import os
import statistics
import sys
import tempfile
import time
from dataclasses import dataclass

sys.path.append(os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "scenes_common"))
import need_numpy  # noqa: E402,F401
import exr  # noqa: E402
import numpy as np  # noqa: E402
from every_scene import OPTIONS, every_scene  # noqa: E402
from renders import Renderer  # noqa: E402

MARGIN, ALPHA = 0.01, 0.05
WANTED = MARGIN / 6  # standard error of a difference, relative: leaves power where there is a bias, and after Holm
SEEDS, PILOT_SEEDS, BATCHES = 8, 4, 16
STAGES = 2
METHODS = ("auto", "ups")


def survival(t, dof):
    """P(T > t) of Student's t."""
    if t < 0:
        return 1 - survival(-t, dof)
    u = (np.arange(4000) + 0.5) / 4000
    x = t + u / (1 - u)
    log_scale = math.lgamma((dof + 1) / 2) - math.lgamma(dof / 2) - 0.5 * math.log(dof * math.pi)
    return float(np.mean(np.exp(log_scale - (dof + 1) / 2 * np.log1p(x ** 2 / dof)) / (1 - u) ** 2))


@dataclass
class Mean:
    value: float
    error: float
    dof: float

    def relative_error(self):
        return self.error / self.value if self.value > 0 else 0.0 if self.error == 0 else math.inf


@dataclass
class Pair:
    """One quantity by both methods. `p`: of the hypothesis that they differ by the margin or more."""
    scene: str
    what: str
    a: Mean
    b: Mean
    p: float = 1.0

    def __post_init__(self):
        s, d = math.hypot(self.a.error, self.b.error), abs(self.a.value - self.b.value)
        margin = MARGIN * abs(self.b.value)
        if s == 0:
            self.p = 0.0 if d <= margin else 1.0
        else:  # degrees of freedom: Welch
            dof = s ** 4 / sum(m.error ** 4 / m.dof for m in (self.a, self.b))
            self.p = survival((margin - d) / s, dof)
            self.p_within = survival((d - margin) / s, dof)

    def differs(self, alpha):
        """Is it proven that they differ by more than the margin?"""
        return (self.p == 1 if self.a.error == self.b.error == 0 else self.p_within < alpha)

    def words(self):
        if self.b.value == 0:
            return f"{self.a.value:.4g} against 0"
        s = math.hypot(self.a.error, self.b.error)
        return f"{100 * (self.a.value / self.b.value - 1):+.3f} % +- {100 * s / self.b.value:.3f} %"


def spread(values):
    return Mean(statistics.fmean(values), statistics.stdev(values) / math.sqrt(len(values)), len(values) - 1)


def reported(values, errors):
    """The mean of several seeds by their own errors; by their spread where one does not know its error."""
    if min(errors) < 0:
        return spread(values)
    return Mean(statistics.fmean(values), math.hypot(*errors) / len(errors), (BATCHES - 1) * len(errors))


def quarters(path):
    image = exr.read_rgb(path).mean(2)
    y, x = image.shape[0] // 2, image.shape[1] // 2
    return {f"{v}{h}": float(part.mean()) for v, rows in (("upper ", image[:y]), ("lower ", image[y:]))
            for h, part in (("left", rows[:, :x]), ("right", rows[:, x:]))}


def quantities(runs):
    """{what: Mean} of several seeds. `runs`: (report, folder) each."""
    means, reports = {}, [report for report, _ in runs]
    for name in reports[0]["meters"]:
        means[name] = reported(*([r["meters"][name][word] for r in reports]
                                 for word in ("mean_lx", "mean_standard_error_lx")))
    for name in reports[0].get("goniometers", {}):
        means[name] = reported(*([r["goniometers"][name][word] for r in reports]
                                 for word in ("flux_lm", "flux_standard_error_lm")))
    for name in reports[0]["cameras"]:
        parts = [quarters(os.path.join(folder, name + ".exr")) for _, folder in runs]
        means |= {f"{name}, {part}": spread([of_seed[part] for of_seed in parts]) for part in parts[0]}
    return means


class Judge:
    """One scene: renders both methods until its pairs are decided or the time is over."""
    def __init__(self, arguments, name, path, folder):
        self.name, self.folder, self.words = name, folder, OPTIONS.get(name, [])
        self.renderer = Renderer(arguments.ups, path, arguments.threads, arguments.size)
        self.seconds_left = arguments.max_seconds
        self.methods = {}

    def render(self, method, iterations, seeds):
        runs = []
        for seed in seeds:
            out = os.path.join(self.folder, f"{method}_{seed}")
            start = time.monotonic()
            runs.append((self.renderer.render(method, seed, ["--iterations", str(iterations), *self.words], out), out))
            self.seconds_left -= time.monotonic() - start
        self.methods[method] = runs[0][0]["method"]
        return runs

    def affordable(self, wanted, pilot_seconds, stage):
        """Iterations of each method, so many that the time that is left is enough for the stages to come."""
        cost = sum(wanted[m] / BATCHES * pilot_seconds[m] for m in METHODS) * SEEDS / PILOT_SEEDS
        share = min(1.0, max(self.seconds_left, 0) / cost / (1 if stage else 1.5))
        return {m: max(BATCHES, int(share * wanted[m])) for m in METHODS}

    def pairs(self):
        pilots, seconds = {}, {}
        for m in METHODS:
            before = self.seconds_left
            pilots[m] = self.render(m, BATCHES, range(101, 101 + PILOT_SEEDS))
            seconds[m] = before - self.seconds_left
        means = {m: quantities(pilots[m]) for m in METHODS}
        if all(means["auto"][what] == means["ups"][what] for what in means["ups"]):
            return [Pair(self.name, what, Mean(m.value, 0, 1), Mean(m.value, 0, 1))
                    for what, m in means["ups"].items()], True
        wanted = {m: BATCHES * self.times(means[m]) for m in METHODS}
        pairs, count = {}, None
        for stage in range(STAGES):
            earlier, count = count, self.affordable(wanted, seconds, stage)
            if earlier and any(count[m] < 2 * earlier[m] for m in METHODS):
                break  # no time left for a better one
            done = {m: quantities(self.render(m, count[m], range(1 + SEEDS * stage, 1 + SEEDS * (stage + 1))))
                    for m in METHODS}
            for what in done["ups"]:
                pair = Pair(self.name, what, done["auto"][what], done["ups"][what])
                if what not in pairs or pair.p < pairs[what].p:
                    pairs[what] = pair
            # Holm asks the most of the least p: ALPHA over all the quantities there are, some hundreds.
            if all(p.p < ALPHA / 1000 for p in pairs.values()):
                break
            wanted = {m: 4 * count[m] for m in METHODS}
        for pair in pairs.values():
            pair.p = min(1.0, STAGES * pair.p)
        return list(pairs.values()), False

    @staticmethod
    def times(means):
        """How many times the pilot's samples a seed, so that all are as sure as is wanted."""
        known = [m.relative_error() for m in means.values() if m.relative_error() < math.inf]
        worst = max(known, default=0)
        return max(1, math.ceil((worst / (WANTED / math.sqrt(2))) ** 2 * PILOT_SEEDS / SEEDS))


def holm(pairs):
    """The pairs that are not proven equal."""
    ordered = sorted(pairs, key=lambda pair: pair.p)
    for k, pair in enumerate(ordered):
        if pair.p > ALPHA / (len(ordered) - k):
            return ordered[k:]
    return []


def parse(names):
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("scenes", nargs="*", metavar="SCENE", help="without any: all")
    parser.add_argument("--ups", default="build/release/bin/ups", help="the program")
    parser.add_argument("--max-seconds", type=float, default=600, help="wall time of a scene, about (600)")
    parser.add_argument("--size", default="256x192", help="WxH of the cameras (256x192)")
    parser.add_argument("--threads", type=int, help="default: all")
    parser.add_argument("--list", action="store_true", help="print the scenes' names")
    parser.add_argument("--out", default="out/equivalence", help="folder of equivalence.csv")
    arguments = parser.parse_args()
    unknown = set(arguments.scenes) - set(names)
    if unknown:
        parser.error(f"{sorted(unknown)} are none of the scenes")
    return arguments


def main():
    scenes = every_scene()
    arguments = parse(scenes)
    if arguments.list:
        return print("\n".join(scenes))
    os.makedirs(arguments.out, exist_ok=True)
    pairs = []
    with open(os.path.join(arguments.out, "equivalence.csv"), "w", newline="", encoding="utf-8") as file:
        table = csv.writer(file)
        table.writerow(["scene", "quantity", "auto", "error", "ups", "error", "p"])
        for name in arguments.scenes or scenes:
            with tempfile.TemporaryDirectory(prefix="ups-equivalence-") as folder:
                judge = Judge(arguments, name, scenes[name](folder), folder)
                found, same_bits = judge.pairs()
            pairs += found
            table.writerows([p.scene, p.what, p.a.value, p.a.error, p.b.value, p.b.error, p.p] for p in found)
            file.flush()
            worst = max(found, key=lambda pair: pair.p, default=None)
            print(f"{name}: auto is {judge.methods['auto']}, {len(found)} quantities, "
                  + ("the same bits" if same_bits else "none" if worst is None else
                     f"least sure: {worst.what}, {worst.words()}, p {worst.p:.2g}"), flush=True)
    failed = holm(pairs)
    print(f"\n{len(pairs)} quantities, {len(pairs) - len(failed)} proven equal within {100 * MARGIN:g} %")
    for pair in failed:
        verdict = "DIFFERS" if pair.differs(ALPHA / len(pairs)) else "UNDECIDED"
        print(f"{verdict} {pair.scene}, {pair.what}: {pair.words()}, p {pair.p:.2g}")
    sys.exit(1 if failed or not pairs else 0)


if __name__ == "__main__":
    main()
