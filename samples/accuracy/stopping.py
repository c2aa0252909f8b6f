"""Is a target kept that a render ended by? Renders of the office's work plane and of the bathroom's floor end by the
target of 2 % with many seeds; the same error is then taken against the reference. Called by calibrate.py --target.
"""
import os
import statistics
from dataclasses import dataclass
from typing import Callable

import referenced_light
import numpy as np
from calibration import ALLOWED, HELD, read
from referenced_light import Referenced, make_bathroom_floor, make_office
from renders import Renderer, read_table

TARGET = 0.02
MOST = 8192  # iterations; a render that the target has not ended by then has not reached it
CRITERIA = {"mean": np.mean, "worst": np.max}


@dataclass(frozen=True)
class Plane:
    name: str
    make: Callable[[str], str]
    judge: Referenced  # whose reference has the meters
    sets: tuple
    criteria: tuple    # of CRITERIA


def planes():
    # The bathroom's worst meter would take hours.
    return (Plane("office", make_office, referenced_light.office(), ("workplane",), ("mean", "worst")),
            Plane("bathroom_floor", make_bathroom_floor, referenced_light.bathroom(), ("floor",), ("mean",)))


def render(ups, path, criterion, seed, out):
    """(summary, rows of the meters). Called in processes of its own, so that the processor time is its own, too."""
    words = ["--target-error", str(TARGET), "--target-of", criterion, "--iterations", str(MOST)]
    summary = Renderer(ups, path, 1).render("auto", seed, words, out)
    return summary, [row for name in summary["meters"] for row in read_table(out, name)]


def figures(runs, criterion, truth, truth_noise):
    """A row of the table. `kept`: the share of the seeds whose true error is below the target, by the same criterion,
    the reference's own noise taken out; `held`: the share of the readings whose bound holds when they end."""
    readings = read([rows for _, rows in runs], truth, truth_noise)
    true = np.sqrt(np.maximum(readings.error ** 2 - readings.truth_noise ** 2, 0)) / readings.floor
    errors = CRITERIA[criterion](true, axis=1)
    iterations = [summary["iterations"] for summary, _ in runs]
    return {"kept": float(np.mean(errors <= TARGET)), "largest_error": float(errors.max()),
            "mean_error": float(errors.mean()), "held": float(readings.held.mean()),
            "reached": statistics.fmean(n < MOST for n in iterations), "iterations": statistics.fmean(iterations),
            "cpu_s": statistics.fmean(summary["cpu_s"] for summary, _ in runs)}


def failures(row, seeds):
    found = []
    if row["reached"] < 1:
        found.append(f"{1 - row['reached']:.0%} of the renders did not reach the target in {MOST} iterations")
    allowed = ALLOWED * (HELD[0] * (1 - HELD[0]) / seeds) ** 0.5
    if row["kept"] + allowed < HELD[0]:
        found.append(f"the target is kept in {row['kept']:.0%} of the seeds, wanted {HELD[0]:.0%} less {allowed:.0%}")
    return found


def measure(ups, pool, scenes, seeds, out):
    """(row, failures) of each plane of these scenes and each criterion."""
    for plane in planes():
        if plane.judge.name not in scenes:
            continue
        folder = os.path.join(out, f"target_{plane.name}")
        os.makedirs(folder, exist_ok=True)
        path = plane.make(folder)
        judged = os.path.join(out, plane.judge.name)
        os.makedirs(judged, exist_ok=True)
        truth, truth_noise = plane.judge.truth(ups, plane.judge.scene(judged), judged, plane.sets)
        for criterion in plane.criteria:
            runs = [run.result() for run in [
                pool.submit(render, ups, path, criterion, seed, os.path.join(folder, f"{criterion}_{k}"))
                for k, seed in enumerate(seeds)]]
            row = {"scene": plane.name, "criterion": criterion, "target": TARGET, "seeds": len(seeds),
                   **figures(runs, criterion, truth, truth_noise)}
            yield row, failures(row, len(seeds))
