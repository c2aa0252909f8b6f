"""What renders with many seeds say of the errors that they state, where the truth is known: does a bound of 95 % hold
in 95 % of the readings, and is it no wider than it must be? Called by calibrate.py and the tests.

Readings of one seed share their light paths, so how sure a figure is comes from the spread over the seeds: 400 draws of
as many seeds out of those that ran (bootstrap, Efron 1979). Of no share is it taken to be less than that of as many
independent readings.
"""
import math
from dataclasses import dataclass

import need_numpy  # noqa: F401
import numpy as np
from errors import DARK, UNKNOWN

HELD = (0.93, 0.99)   # wanted: the share of the bounds of 95 % that hold
WIDEST = 5.0          # wanted: the median of bound / |error|; 2.9 where errors are Gaussian
ALLOWED = 2.0         # standard errors beyond these limits: a scene right at one fails in 2 % of the runs
DRAWS = 400
COLUMNS = {"E": "illuminance_lx", "noise": "standard_error_lx", "bias": "bias_lx", "bound": "error_bound_lx"}


@dataclass
class Readings:
    """Arrays of one row a seed and one column a meter, lx; of the truth one number a meter, and its standard error."""
    E: np.ndarray
    noise: np.ndarray
    bias: np.ndarray
    bound: np.ndarray
    truth: np.ndarray
    truth_noise: np.ndarray

    def __post_init__(self):
        self.error = self.E - self.truth
        # A reference's own error comes on top of what a bound is to hold.
        self.held = np.abs(self.error) <= np.hypot(self.bound, 2 * self.truth_noise)
        self.floor = np.maximum(self.truth, DARK * self.truth.mean())
        self.unknown = self.noise < 0            # no light path or too few: the rule of three
        self.exact = (self.noise == 0) & (self.truth > 0)
        self.dark = ~self.unknown & (self.truth == 0)
        self.noisy = ~(self.unknown | self.exact | self.dark)


def read(tables, truth, truth_noise):
    """Of each seed's rows, as the program's tables have them."""
    values = {name: np.array([[row[column] for row in rows] for rows in tables]) for name, column in COLUMNS.items()}
    return Readings(**values, truth=np.asarray(truth, float), truth_noise=np.asarray(truth_noise, float))


def draws(seeds):
    """Rows of indices of seeds; the same ones each time."""
    return np.random.default_rng(1).integers(0, seeds, (DRAWS, seeds))


def share(readings, which):
    """(share of bounds that hold among the readings of a kind, its standard error, how many readings)."""
    held, count = (readings.held & which).sum(1), which.sum(1)
    total = int(count.sum())
    if total == 0:
        return UNKNOWN, UNKNOWN, 0
    drawn = draws(len(count))
    ratios = held[drawn].sum(1) / np.maximum(count[drawn].sum(1), 1)
    at_limit = math.sqrt(HELD[1] * (1 - HELD[1]) / total)
    return held.sum() / total, max(float(ratios.std()), at_limit), total


def width(readings):
    """(median of bound / |error| of the noisy readings, its standard error)."""
    if not readings.noisy.any():
        return UNKNOWN, UNKNOWN
    with np.errstate(divide="ignore"):
        ratios = np.where(readings.noisy, readings.bound / np.abs(readings.error), np.nan)
    drawn = [float(np.nanmedian(ratios[rows])) for rows in draws(len(ratios))]
    return float(np.nanmedian(ratios)), float(np.std(drawn))


def root_mean(squares, which):
    return math.sqrt(float(squares[which].mean())) if which.any() else UNKNOWN


def over(a, b):
    return a / b if a >= 0 and b > 0 else UNKNOWN


def figures(readings):
    """Everything that is told of a scene, as a row of the table."""
    r, row = readings, {}
    for kind in ("noisy", "exact", "dark", "unknown"):
        row[f"{kind}_held"], row[f"{kind}_held_error"], row[f"{kind}_readings"] = share(r, getattr(r, kind))
    row["width"], row["width_error"] = width(r)
    error = root_mean((r.error / r.floor) ** 2, r.noisy)
    stated = root_mean((r.noise / r.floor) ** 2, r.noisy)
    spread = root_mean(((r.E - r.E.mean(0)) / r.floor) ** 2, r.noisy) * math.sqrt(len(r.E) / max(len(r.E) - 1, 1))
    row |= {"rms_error": error, "error_over_stated": over(error, stated), "spread_over_stated": over(spread, stated),
            "reference_over_error": over(math.sqrt(float(((r.truth_noise / r.floor) ** 2).mean())), error)}
    return row


def failures(row):
    """What of a scene is not as wanted, beyond the chance of so few seeds."""
    found = []
    if not row["noisy_readings"]:
        found.append("no reading has noise")
    for kind in ("noisy", "exact", "dark", "unknown"):
        held, allowed = row[f"{kind}_held"], ALLOWED * row[f"{kind}_held_error"]
        if row[f"{kind}_readings"] and held + allowed < HELD[0]:
            found.append(f"bounds hold in {held:.1%} of the {kind} readings, wanted {HELD[0]:.0%} less {allowed:.1%}")
    if row["noisy_readings"]:
        held, allowed = row["noisy_held"], ALLOWED * row["noisy_held_error"]
        if held - allowed > HELD[1]:
            found.append(f"bounds hold in {held:.1%} of the noisy readings, wanted {HELD[1]:.0%} more {allowed:.1%}")
        if row["width"] - ALLOWED * row["width_error"] > WIDEST:
            found.append(f"half the bounds are {row['width']:.1f} errors wide or more, wanted {WIDEST:g}")
    return found


def of_meters(readings):
    """A row a meter: where a scene fails. `off`: the mean error over its standard error by the spread of the seeds, so
    how surely there is bias; `spread_over_stated`: is the noise as stated?"""
    r = readings
    for m in range(len(r.truth)):
        spread = float(r.E[:, m].std(ddof=1)) if len(r.E) > 1 else UNKNOWN
        stated = root_mean(r.noise[:, m] ** 2, r.noise[:, m] > 0)
        mean = float(r.error[:, m].mean())
        with np.errstate(divide="ignore"):
            ratio = float(np.median(r.bound[:, m] / np.abs(r.error[:, m])))
        yield {"meter": m, "truth_lx": r.truth[m], "truth_error_lx": r.truth_noise[m], "mean_error_lx": mean,
               "off": mean / (spread / math.sqrt(len(r.E))) if spread > 0 else UNKNOWN, "spread_lx": spread,
               "stated_noise_lx": stated, "spread_over_stated": over(spread, stated),
               "mean_bias_stated_lx": float(r.bias[:, m].mean()), "mean_bound_lx": float(r.bound[:, m].mean()),
               "held": float(r.held[:, m].mean()), "width": ratio, "unknown": float(r.unknown[:, m].mean())}
