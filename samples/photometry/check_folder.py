#!/usr/bin/env python3
"""Reads every photometric file of a folder with `ups info --json` and compares what comes out with what a list expects.

    samples/photometry/check_folder.py FOLDER [EXPECTED] [--ups build/release/bin/ups] [--tolerance 0.0005]

EXPECTED (MANIFEST.md of the folder if left out) names the files, relative to FOLDER:
  - .csv with the columns file, flux_lm, twin, refused. flux_lm: by the band rule; twin: another file's name or its
    beginning, of the same light; refused: anything where the file must be refused. Cells may be empty.
  - .md with tables whose first column is the file, in backquotes, and one of whose columns is headed `expected` or
    starts with `flux`. Read from that cell: `123.4 lm` (or a number alone), `must be rejected`, `same ... as NAME`,
    `identical ... to NAME`, `as NAME`; from any cell: `same lamp` (as the last row above without these words, another
    table of it: within 0.5 % of flux, 1 % of peak and 0.5 degrees).
Exit code: 0 all as expected, 1 something is not, 2 wrong usage.
"""
import argparse
import csv
import json
import os
import re
import subprocess
import sys

TWIN = re.compile(r"(?:\bsame (?:\w+ )?as|\bidentical \w+ to|^as) `?([\w./]+)")
FLUX = re.compile(r"([\d.]+) lm(?!/)")
TWIN_TOLERANCE = (5e-4, 5e-4, 0.05)  # flux and peak, relative; beam edges, degrees: files are written with few digits
OTHER_TABLE = (5e-3, 1e-2, 0.5)


class Expected:
    def __init__(self, file, flux=None, twin=None, refused=False, tolerances=TWIN_TOLERANCE):
        self.file, self.flux, self.twin, self.refused, self.tolerances = file, flux, twin, refused, tolerances


def from_csv(path):
    with open(path, newline="", encoding="utf-8") as file:
        return [Expected(row["file"], float(row["flux_lm"]) if row.get("flux_lm") else None, row.get("twin") or None,
                         bool(row.get("refused"))) for row in csv.DictReader(file)]


def from_cell(file, cell, words, model):
    """model: the last file that was not another table of the same lamp."""
    twin, flux = TWIN.search(cell), FLUX.search(cell) or re.match(r"([\d.]+)", cell)
    if "must be rejected" in cell:
        return Expected(file, refused=True)
    expected = Expected(file, float(flux[1]) if flux and not twin else None, twin[1] if twin else None)
    if "same lamp" in words and model:
        expected.twin, expected.tolerances = model, OTHER_TABLE
    return expected


def from_markdown(path):
    rows, column, model = [], None, None
    with open(path, encoding="utf-8") as lines:
        for line in lines:
            cells = [cell.strip() for cell in line.strip().strip("|").split("|")]
            if not line.startswith("|"):
                column = None
            elif column is None:
                column = next((i for i, c in enumerate(cells) if c == "expected" or c.startswith("flux")), -1)
            elif column > 0 and re.fullmatch(r"`[^`]+`", cells[0]):
                rows.append(from_cell(cells[0].strip("`"), cells[column], " ".join(cells), model))
                if rows[-1].tolerances is TWIN_TOLERANCE:
                    model = rows[-1].file
    return rows


def read(program, files):
    done = subprocess.run([program, "info", "--json", *files], stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                          check=False)
    if done.returncode not in (0, 1) or not done.stdout:
        sys.exit(f"{program} info failed:\n{done.stderr.decode()}")
    return {entry["file"]: entry for entry in json.loads(done.stdout)["files"]}


def differences(a, b, tolerances):
    """In words, how the light of two files differs by more than (flux, peak, degrees)."""
    found = []
    for key, tolerance in (("flux_lm", tolerances[0]), ("peak_cd", tolerances[1])):
        if abs(a[key] - b[key]) > tolerance * b[key]:
            found.append(f"{key} {a[key]:.7g} is not {b[key]:.7g}")
    for plane in ("c0_c180", "c90_c270"):
        for lobe in ("beam", "field"):
            for key in ("from_deg", "to_deg"):
                x, y = a[lobe][plane][key], b[lobe][plane][key]
                if abs(x - y) > tolerances[2]:
                    found.append(f"{lobe} {plane} {key} {x:.4g} is not {y:.4g}")
    return found


def check(expected, entries, names, tolerance):
    """(what was found, what is wrong or '')"""
    entry = entries[names[expected.file]]
    error = entry.get("error", "")
    if expected.refused:
        said = error.removeprefix(entry["file"] + ": ")
        return said, "" if re.search(r"line \d+", error) else "is not refused with its line"
    if error:
        return "", error.removeprefix(entry["file"] + ": ")
    found = f"{entry['format']}, {entry['flux_lm']:.2f} lm"
    wrong = []
    if expected.flux is not None:
        off = entry["flux_lm"] / expected.flux - 1
        found += f", {100 * off:+.4f} %"
        if abs(off) > tolerance:
            wrong.append(f"flux is not {expected.flux} lm")
    if expected.twin:
        twins = [path for name, path in names.items()
                 if name == expected.twin or os.path.basename(name).startswith(expected.twin)]
        if len(twins) != 1:
            return found, f"{len(twins)} files are called {expected.twin}"
        wrong += differences(entry, entries[twins[0]], expected.tolerances)
        found += f", twin of {os.path.basename(twins[0])}"
    warnings = len(entry["warnings"])
    return found + (f", {warnings} warnings" if warnings else ""), "; ".join(wrong)


def main():
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("folder")
    parser.add_argument("expected", nargs="?")
    parser.add_argument("--ups", default="build/release/bin/ups")
    parser.add_argument("--tolerance", type=float, default=0.0005, help="of the flux, relative (0.0005)")
    arguments = parser.parse_args()
    path = arguments.expected or os.path.join(arguments.folder, "MANIFEST.md")
    try:
        rows = from_csv(path) if path.endswith(".csv") else from_markdown(path)
    except (OSError, KeyError, ValueError) as error:
        parser.error(f"{path}: {error!r}")
    if not rows:
        parser.error(f"{path}: no table of files and what is expected of them")
    names = {row.file: os.path.join(arguments.folder, row.file) for row in rows}
    entries = read(arguments.ups, list(names.values()))
    failed = 0
    for row in rows:
        found, wrong = check(row, entries, names, arguments.tolerance)
        failed += bool(wrong)
        print(f"{'FAILED' if wrong else 'ok':6} {row.file}: {found}{' -- ' if wrong and found else ''}{wrong}")
    print(f"{len(rows)} files, {failed} not as expected")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
