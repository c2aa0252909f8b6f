#!/usr/bin/env python3
"""What do meters of every kind cost? 50,000 of five kinds against as many planar ones, in the office of make_office.py.

  python3 samples/evaluation/meter_kinds.py --ups build/release/bin/ups [--rounds 3] [--iterations 192]

Each kind has a grid of 125 x 80, planar at 0.75 m, the others at 1.2 m; the planar render has five such grids at these
heights. The figure: CPU time on one thread times the mean squared relative standard error of the meters, which is the
time to any error that noise limits, as the ratio of both renders; they take turns, seeds are 1, 2, ... Exit code 1
where it is above 1.5.
"""
import argparse
import csv
import os
import resource
import subprocess
import sys
import tempfile

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "scenes_common"))
import need_numpy  # noqa: E402,F401
import make_office  # noqa: E402
from gltf_builder import Frame, GltfBuilder  # noqa: E402

KINDS = ["planar", "cylindrical", "semicylindrical", "hemispherical", "spherical"]
COLUMNS, ROWS, LIMIT = 125, 80, 1.5


def write_office(path, kinds):
    scene = GltfBuilder("UPS meter_kinds.py")
    make_office.build(scene, meters=False)
    size = {"width_m": make_office.LENGTH, "height_m": make_office.WIDTH}
    for number, kind in enumerate(kinds):
        middle = (make_office.LENGTH / 2, make_office.WIDTH / 2, 0.75 if number == 0 else 1.2)
        if kind == "semicylindrical":  # a grid that faces up has no horizontal facing: points that look along y
            step = (make_office.LENGTH / COLUMNS, make_office.WIDTH / ROWS)
            points = [[(c + 0.5) * step[0] - size["width_m"] / 2, (r + 0.5) * step[1] - size["height_m"] / 2, 0]
                      for r in range(ROWS) for c in range(COLUMNS)]
            scene.meters(kind, Frame.upright(middle), kind=kind, points_m=points, normals=[[0, 1, 0]] * len(points))
        else:
            scene.meters(f"{kind}_{number}", Frame.upright(middle), kind=kind, columns=COLUMNS, rows=ROWS, **size)
    scene.write(path)


def cpu_seconds(command):
    def children():
        used = resource.getrusage(resource.RUSAGE_CHILDREN)
        return used.ru_utime + used.ru_stime
    before = children()
    subprocess.run(command, check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    return children() - before


def squared_error(folder):
    """Mean over all meters of (standard error / illuminance)^2."""
    total, count = 0.0, 0
    for name in os.listdir(folder):
        if not name.endswith(".csv"):
            continue
        with open(os.path.join(folder, name), newline="") as table:
            for row in csv.DictReader(table):
                error, value = float(row["standard_error_lx"]), float(row["illuminance_lx"])
                if error < 0 or value <= 0:
                    sys.exit(f"{name}: a meter has no error yet; more iterations would be right")
                total, count = total + (error / value) ** 2, count + 1
    return total / count


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--ups", required=True)
    parser.add_argument("--rounds", type=int, default=3)
    parser.add_argument("--iterations", type=int, default=192)
    parser.add_argument("--method", default="auto")
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        costs = {}
        for name, kinds in (("kinds", KINDS), ("planar", ["planar"] * len(KINDS))):
            write_office(os.path.join(folder, f"{name}.glb"), kinds)
            costs[name] = []
        for seed in range(1, options.rounds + 1):
            for name in costs:
                out = os.path.join(folder, f"{name}{seed}")
                seconds = cpu_seconds([options.ups, "render", os.path.join(folder, f"{name}.glb"), "--iterations",
                                       str(options.iterations), "--seed", str(seed), "--threads", "1", "--method",
                                       options.method, "--out", out])
                square = squared_error(out)
                costs[name].append(seconds * square)
                print(f"{name}, seed {seed}: {seconds:.1f} s, error {100 * square ** 0.5:.2f} %, "
                      f"to 1 % {seconds * square / 1e-4:.0f} s", flush=True)
    ratio = sum(costs["kinds"]) / sum(costs["planar"])
    print(f"five kinds over planar: {ratio:.2f} (at most {LIMIT})")
    return ratio > LIMIT


if __name__ == "__main__":
    sys.exit(main())
