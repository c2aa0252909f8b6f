"""Errors of one render, and of many against time: what the program states, and what a reference says of it.

Of a meter, relative is over max(E, 5 % of its set's mean), as the program's own relative errors are. Every number that
is not known is -1, as in the program's tables. Called by measure.py, accuracy.py and the tests.
"""
import math

import numpy as np

DARK = 0.05       # of a set's mean
UNKNOWN = -1.0
LEVELS = (0.05, 0.02, 0.01)


def columns(tables, name):
    """{set: rows} as one array."""
    return np.array([row[name] for rows in tables.values() for row in rows])


def floors(tables):
    """What each meter's errors are relative to."""
    parts = []
    for rows in tables.values():
        values = np.array([row["illuminance_lx"] for row in rows])
        parts.append(np.maximum(values, DARK * values.mean()))
    return np.concatenate(parts)


def against(tables, reference):
    """A render's meters against the reference's: what half and 95 % of them are within, how far the mean is off, and
    the share of meters whose stated bound, with the reference's, holds."""
    E, E_ref = columns(tables, "illuminance_lx"), columns(reference, "illuminance_lx")
    off = np.abs(E - E_ref)
    relative = off / floors(reference)
    bound, bound_ref = columns(tables, "error_bound_lx"), columns(reference, "error_bound_lx")
    known = (bound >= 0) & (bound_ref >= 0)
    held = float(np.mean(off[known] <= np.hypot(bound, bound_ref)[known])) if known.any() else UNKNOWN
    return {"true_median": float(np.median(relative)), "true_p95": float(np.percentile(relative, 95)),
            "mean_off": float(E.sum() / E_ref.sum() - 1), "bounds_held": held}


def stated_bound(tables):
    """The median meter's relative 95 % bound; -1 where it is not known of every second meter."""
    bound = columns(tables, "error_bound_lx")
    relative = np.where(bound >= 0, bound / floors(tables), math.inf)
    median = float(np.median(relative))
    return median if math.isfinite(median) else UNKNOWN


def known_points(points):
    """(seconds, error) pairs that a logarithmic plot can show, by time."""
    return sorted((s, e) for s, e in points if s > 0 and e > 0)


def at_time(points, seconds):
    """The error at a time within the curve, between its points on logarithmic scales; -1 elsewhere."""
    points = known_points(points)
    if not points or not points[0][0] * (1 - 1e-9) <= seconds <= points[-1][0] * (1 + 1e-9):
        return UNKNOWN
    s, e = np.log(points).T
    return float(np.exp(np.interp(math.log(seconds), s, e)))


def time_to(points, level):
    """(status, seconds): when the error falls below the level for good. `reached`; `sooner` than the first point;
    `later` than the last; `unknown` without any point, and then -1."""
    points = known_points(points)
    if not points:
        return "unknown", UNKNOWN
    above = [k for k, (_, error) in enumerate(points) if error > level]
    if not above:
        return "sooner", points[0][0]
    if above[-1] == len(points) - 1:
        return "later", points[-1][0]
    (s0, e0), (s1, e1) = points[above[-1]:above[-1] + 2]
    fraction = math.log(e0 / level) / math.log(e0 / e1)
    return "reached", s0 * (s1 / s0) ** fraction


def came_true(row):
    """Whether the actual time lies within a prediction's limits (no lower one: never, no upper one: any time after);
    None where the longer render ended too soon to say."""
    low, high = (math.inf if row[key] < 0 else row[key] for key in ("low_seconds", "high_seconds"))
    if row["status"] == "later":
        return False if row["actual_seconds"] > high else None
    return low <= row["actual_seconds"] <= high


def predicted_and_actual(predictions, criterion, curve, scale, curve_scale, made_at):
    """Rows of one render's "prediction" of the criterion, `worst` or `median`, beside when a longer one got there.
    Times of the clock are multiplied by the scales; errors that were reached before are left out."""
    for p in predictions:
        status, actual = time_to([(c["time_s"] * curve_scale, c[f"{criterion}_relative_error"]) for c in curve],
                                 p["relative_error"])
        low, high, seconds = ((p[key] * scale if p[key] >= 0 else UNKNOWN) for key in ("low", "high", "seconds"))
        if status == "reached" and actual <= made_at or status == "sooner":
            continue
        yield {"criterion": criterion, "made_at_seconds": made_at, "relative_error": p["relative_error"],
               "predicted_seconds": seconds, "low_seconds": low, "high_seconds": high, "limited_by": p["limited_by"],
               "actual_seconds": actual if status in ("reached", "later") else UNKNOWN, "status": status}
