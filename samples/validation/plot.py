#!/usr/bin/env python3
"""The picture of a validation: the deviation of every check, case by case and method by method.

  python3 samples/validation/plot.py out/validation/results.json validation.png

Also called by validate.py --plot.
"""
import json
import os
import sys
from types import SimpleNamespace

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "scenes_common"))
import need_numpy  # noqa: E402,F401
import matplotlib  # noqa: E402

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402
import numpy as np  # noqa: E402
from harness import RELATIVE_TOLERANCE  # noqa: E402
from tables import groups_of  # noqa: E402

COLOURS = {"ups": "#c0392b", "bpt": "#2471a3", "pt": "#239b56"}


def write(path, cases, rows, methods):
    groups = groups_of(cases)
    figure, axes = plt.subplots(figsize=(8, 0.34 * len(groups) + 1.4), dpi=110)
    band = 100 * RELATIVE_TOLERANCE
    axes.axvspan(-band, band, color="#e8eef2", zorder=0)
    axes.axvline(0, color="#888888", linewidth=0.6, zorder=1)
    largest = band
    for line, (_, _, members) in enumerate(groups):
        names = [c.name for c in members]
        for k, method in enumerate(methods):
            mine = (r.deviation for r in rows if r.case in names and r.method == method)
            deviations = [deviation for deviation in mine if deviation is not None]
            largest = max([largest, *map(abs, deviations)])
            height = line + (k - (len(methods) - 1) / 2) * 0.8 / len(methods)
            axes.scatter(deviations, np.full(len(deviations), height), s=11, alpha=0.6, linewidths=0, zorder=2,
                         color=COLOURS.get(method), label=method.upper() if line == 0 else None)
    axes.set_yticks(range(len(groups)), [title for _, title, _ in groups], fontsize=8)
    axes.set_ylim(len(groups) - 0.4, -0.6)
    axes.set_xlim(-1.15 * largest, 1.15 * largest)
    axes.tick_params(axis="x", labelsize=8)
    axes.set_xlabel(f"deviation of the illuminance from its reference, % (band: \u00b1{band:g} %)", fontsize=8)
    axes.legend(ncols=len(methods), fontsize=8, frameon=False, loc="lower right", bbox_to_anchor=(1, 1))
    for side in ("top", "right"):
        axes.spines[side].set_visible(False)
    figure.tight_layout()
    figure.savefig(path, metadata={"Software": None})
    plt.close(figure)


def main():
    if len(sys.argv) != 3:
        sys.exit("usage: plot.py results.json picture.png")
    with open(sys.argv[1], encoding="utf-8") as file:
        results = json.load(file)
    cases, rows = ([SimpleNamespace(**item) for item in results[kind]] for kind in ("cases", "rows"))
    write(sys.argv[2], cases, rows, results["methods"])


if __name__ == "__main__":
    main()
