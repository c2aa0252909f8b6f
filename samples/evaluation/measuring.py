"""What accuracy costs: CPU time x squared standard error, of methods, programs and scenes that take turns.

For unbiased estimators the product does not depend on how long a render was. Meters: of the median meter, the standard
error that the program reports over max(E, 5 % of its set's mean); `to_1_percent` is the CPU time at which it would be
1 %. Images: the mean over the pixels of their reported variance, relative, with and without the worst 0.1 % of the
pixels; where a reference is given, of their squared difference from it instead. CPU time is user and system time of the
whole program, its preparations too, on one thread: what else runs on the machine matters little, and to all that take
turns alike.

Called by the commands of this folder and of samples/effects.
"""
import math
import os
import statistics
import sys
from dataclasses import dataclass
from typing import Optional

sys.path.append(os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "scenes_common"))
import need_numpy  # noqa: E402,F401
import exr  # noqa: E402
import numpy as np  # noqa: E402
from renders import Renderer, read_table, squared_errors  # noqa: E402

TECHNIQUES = ("emitter_hit", "light_sample", "connect", "sensor_connect", "merge", "sensor_hit", "mirror_sample")
DARK_METERS = 0.05   # of the set's mean: darker meters are judged as if they had so much
DARK_PIXELS = 1e-2   # of the squared mean, as `ups compare` has it
TRIMMED = 1e-3       # of the pixels
BATCHES = 16         # of the reported standard errors; a multiple of it fills all alike
MISSING = " is missing: no technique"  # in the warnings


@dataclass
class Candidate:
    """One program with one method: auto, ups, ... or "ups-connect-merge", without these techniques; on one scene."""
    ups: str
    method: str
    scene: str
    label: str = ""
    size: Optional[str] = None  # WxH of the cameras

    def __post_init__(self):
        self.label = self.label or self.method

    def render(self, seed, iterations, out=None):
        method, *left_out = self.method.split("-")
        unknown = set(left_out) - set(TECHNIQUES)
        if unknown:
            sys.exit(f"{self.method}: {sorted(unknown)} are none of {list(TECHNIQUES)}")
        limit = ["--iterations", str(iterations)]
        if left_out:
            limit += ["--techniques", ",".join(t for t in TECHNIQUES if t not in left_out)]
        return Renderer(self.ups, self.scene, 1, self.size).render(method, seed, limit, out)

    def calibrated(self, seconds):
        """Iterations that take about so much CPU time, with what a render costs once."""
        count = BATCHES // 4
        spent = self.render(1, count)["cpu_s"]
        each = spent / count
        while spent < seconds / 4:
            more = self.render(1, 4 * count)["cpu_s"]
            each = max(more - spent, 0.01 * more) / (3 * count)
            count, spent = 4 * count, more
        return BATCHES * max(1, round((count + (seconds - spent) / each) / BATCHES))


@dataclass
class Run:
    report: dict
    out: str
    meters: dict  # name: rows of the table

    @property
    def cpu_s(self):
        return self.report["cpu_s"]

    def noise(self):
        """The median meter's relative standard error; unknown ones count as the largest."""
        errors = []
        for name, rows in self.meters.items():
            dark = DARK_METERS * self.report["meters"][name]["mean_lx"]
            errors += [r["standard_error_lx"] / max(r["illuminance_lx"], dark)
                       if r["standard_error_lx"] >= 0 and dark > 0 else math.inf for r in rows]
        return statistics.median(errors) if errors else math.nan

    def bias_lx(self, name):
        return statistics.fmean(r["bias_lx"] for r in self.meters[name])


def take_turns(candidates, seconds, seeds, out, iterations=None):
    """{label: [Run of each seed]}. Every candidate renders for about `seconds`, or all with the same `iterations`; one
    seed after another, in each all candidates."""
    counts = {c.label: iterations or c.calibrated(seconds) for c in candidates}
    runs = {c.label: [] for c in candidates}
    for seed in range(1, seeds + 1):
        for k, c in enumerate(candidates):
            folder = os.path.join(out, f"{k}_{seed}")
            report = c.render(seed, counts[c.label], folder)
            runs[c.label].append(Run(report, folder, {name: read_table(folder, name) for name in report["meters"]}))
    return runs


def to_1_percent(runs):
    """CPU seconds until the median meter's standard error is 1 %: the mean over the runs."""
    return statistics.fmean(run.cpu_s * (run.noise() / 0.01) ** 2 for run in runs)


def relative_variances(runs):
    """{camera: {label: [a variance a pixel, of each run]}}, over the squared median of all runs' images."""
    cameras = {}
    for name in next(iter(runs.values()))[0].report["cameras"]:
        layers = {label: [exr.read_layers(os.path.join(r.out, name + ".exr")) for r in of_label]
                  for label, of_label in runs.items()}
        middle = np.median([image[""].mean(2) for of_label in layers.values() for image in of_label], 0)
        scale = middle ** 2 + DARK_PIXELS * middle.mean() ** 2
        cameras[name] = {label: [(image["standard_error"] ** 2).mean(2) / scale for image in of_label]
                         for label, of_label in layers.items()}
    return cameras


def trimmed(values):
    """The mean without the largest."""
    ordered = np.sort(values, axis=None)
    return float(ordered[:len(ordered) - math.ceil(TRIMMED * len(ordered))].mean())


def image_costs(runs):
    """{label: (CPU time x relative variance, the same without the worst pixels)}, over all cameras; {} without any."""
    costs = {}
    for of_camera in relative_variances(runs).values():
        for label, variances in of_camera.items():
            pairs = [(run.cpu_s * float(v.mean()), run.cpu_s * trimmed(v)) for run, v in zip(runs[label], variances)]
            mean = [statistics.fmean(p) for p in zip(*pairs)]
            costs[label] = [a + b for a, b in zip(costs.get(label, (0, 0)), mean)]
    return costs


def image_costs_by_reference(runs, ups, reference_dir):
    """As image_costs, from squared differences to the images in `reference_dir`; the whole one is relative, the trimmed
    one is in units of the image."""
    costs = {}
    for label, of_label in runs.items():
        pairs = []
        for run in of_label:
            for camera in run.report["cameras"]:
                errors = squared_errors(Renderer(ups, "").compare(camera, run.out, reference_dir))
                pairs.append((run.cpu_s * errors["relative_mse"], run.cpu_s * errors["trimmed_rmse"]))
        if pairs:
            costs[label] = [statistics.fmean(p) for p in zip(*pairs)]
    return costs


def light_means(runs):
    """{what: (mean, standard error, bias)} of one candidate: each set of meters by the errors that it reports, each
    camera by the spread of its seeds (0 where there is but one)."""
    means, count = {}, len(runs)
    for name in runs[0].report["meters"]:
        sets = [run.report["meters"][name] for run in runs]
        error = math.sqrt(sum(max(s["mean_standard_error_lx"], 0) ** 2 for s in sets)) / count
        means[name] = (statistics.fmean(s["mean_lx"] for s in sets), error,
                       statistics.fmean(run.bias_lx(name) for run in runs))
    for name in runs[0].report["cameras"]:
        values = [run.report["cameras"][name]["mean_luminance_cd_m2"] for run in runs]
        spread = statistics.stdev(values) / math.sqrt(count) if count > 1 else 0.0
        means[name] = (statistics.fmean(values), spread, 0.0)
    return means


def missed_light(runs, complete):
    """Why the candidate does not count, or "": the program says so, or a mean differs from that of `complete`, a
    method that samples all light: meters' by more than the noise (4 standard errors) and the biases, images' by more
    than the noise and 1 %, as few seeds hardly know their spread and images report no bias."""
    if any(MISSING in w for run in runs for w in run.report["warnings"]):
        return "misses light (it says so)"
    expected = light_means(complete)
    for name, (mean, error, bias) in light_means(runs).items():
        mean_of_all, error_of_all, bias_of_all = expected[name]
        allowed = 4 * math.hypot(error, error_of_all) + abs(bias) + abs(bias_of_all)
        if name in runs[0].report["cameras"]:
            allowed = max(allowed, 0.01 * mean_of_all)
        if abs(mean - mean_of_all) > allowed:
            return f"{name}: {100 * (mean / mean_of_all - 1):+.2f} %" if mean_of_all else f"{name} is not dark"
    return ""


def chosen(report):
    """The techniques that ran; where `auto` chose, by sensor with the gain that it predicted, and light paths of an
    iteration. Reports of earlier programs have no "choice"."""
    choice = report.get("choice", {})
    if all(c["predicted_gain"] == 1 for c in choice.values()):
        return " ".join(report["techniques"])
    texts = []
    for sensor, c in choice.items():
        merge = "merge_caustics" if c["photons"] == "caustic" else "merge"
        words = " ".join(merge if t == "merge" else t for t in c["techniques"])
        texts.append(f"{sensor}: {words} ({c['predicted_gain']:.1f} x)")
    return "; ".join([*texts, f"{c['light_paths']} light paths"])


def print_table(header, rows):
    """Markdown."""
    print("| " + " | ".join(header) + " |\n|" + " --- |" * len(header))
    for row in rows:
        print("| " + " | ".join(row) + " |", flush=True)
