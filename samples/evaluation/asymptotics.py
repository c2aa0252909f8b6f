#!/usr/bin/env python3
"""How fast does the error fall? Slopes of log MSE against log time, by method, against theory.

  UPS_LIBRARY=build/release/src/api python3 samples/evaluation/asymptotics.py [--seeds 16] [--out out/asymptotics]

Two scenes with an exact answer, one sensor each.

sds      A spot without extent, folded by four plane mirrors onto a black plate that one pixel measures the illuminance
         of: specular from end to end, so that only merging on the plate finds it. (A point meter would choose its own
         disc afterwards, and follow no schedule.) With the mirrors' images the light is that of a source
         at the unfolded distance; its intensities are such that the illuminance is E0 (1 - (x / R)^2) at x from the
         beam's axis, so that a disc of radius r is biased by -(r / R)^2 / 2 exactly, at every radius, and the pixel on
         the axis reads E0 = rho^4 I / d^2. Mirrors of rho = 0.6: roulette keeps 1.5 * 0.6^4 of the
         paths (`light_reserve` in src/transport/walk.h). Without that the directions of the photons would be one
         stratified (Sobol) pattern, whose noise falls faster than theory, which is about independent photons, has it;
         as roulette's numbers are of that pattern too, some of it is left.
diffuse  A closed cube, its walls matte (rho = 0.7) and all emitting L: E = pi L / (1 - rho) at every point. Light of
         many bounces, which unbiased techniques carry.

Theory. The mean of n iterations of r^2_{i+1} = r^2_i (i + alpha) / (i + 1), f_i = r^2_i / r^2_1, has the bias
b sum f_i / n, b that of the first disc, and the variance sum 1 / f_i / (M n^2), M photons in the first disc (Knaus,
Zwicker 2011). For large n these fall as n^(alpha - 1) and n^-alpha, the MSE of merging alone as
n^-min(alpha, 2 - 2 alpha): best at alpha = 2/3, by n^-2/3. Unbiased techniques: 1/n; UPS the same where they carry the
light, as merging gets a weight that falls with r^2. PPM is listed by diffuse light, where its disc sees no curvature
and has no bias, and so is SPPM, which does the same there; in `sds` all of them merge on the plate as UPS does.

Constants. Variance and bias of the first disc are balanced so that the term that theory says wins does so from the
first iterations on: for alpha = 1/2 the variance (small disc: b^2 M = 0.01), for alpha = 0.8 the bias (wide disc:
b^2 M = 6), for 2/3 both are alike (b^2 M = 0.25) and fall alike. 2.5 decades of iterations.

The time is iterations times the measured seconds of one, so that other programs on the machine do not bend the line.
Every point is made of renders of its own: no two share a photon. Short renders are cheap: they get up to 8 times the
seeds. The slope is a weighted least squares fit; its interval is the 95 % bootstrap over seeds, each point's resampled
independently. `at these n` is the slope that a fit to the sums above has, without their limit of large n; `inside`: it
lies in the interval. The exit code is 1 where one lies outside the 99.5 % interval: by chance 5 % of all choices of
seeds.
"""
import argparse
import csv
import math
import multiprocessing
import os
import sys
import time

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path[:0] = [os.path.join(HERE, "..", "scenes_common"), os.path.join(HERE, "..", "..", "bindings", "python")]
import need_numpy  # noqa: E402,F401
import numpy as np  # noqa: E402
import ups  # noqa: E402

BEAM_RADIUS, MIRRORS, REFLECTANCE = 0.25, 4, 0.6
RESERVE = 1.5  # of light paths: roulette begins beyond
WALLS, LUMINANCE = 0.7, 100.0
ITERATIONS = {"sds": [8, 14, 25, 45, 80, 142, 253, 450, 800, 1423, 2530],
              "diffuse": [4, 7, 13, 22, 40, 71, 126, 225, 400, 711, 1265]}


def merging_slope(alpha):
    return -min(alpha, 2 - 2 * alpha)


# region, method, alpha, first radius in m (0: from the scene), light paths an iteration, slope by theory
CASES = [
    ("sds", "UPS", 1 / 2, 0.25 * BEAM_RADIUS, 512, merging_slope(1 / 2)),
    ("sds", "UPS", 2 / 3, 0.45 * BEAM_RADIUS, 512, merging_slope(2 / 3)),
    ("sds", "UPS", 0.8, 0.8 * BEAM_RADIUS, 512, merging_slope(0.8)),
    ("sds", "BIDIRECTIONAL_PHOTON_MAPPING", 2 / 3, 0.45 * BEAM_RADIUS, 512, merging_slope(2 / 3)),
    ("diffuse", "PPM", 2 / 3, 0.05, 256, merging_slope(2 / 3)),
    ("diffuse", "SPPM", 2 / 3, 0.05, 256, merging_slope(2 / 3)),
    ("diffuse", "PATH_TRACING", 0, 0, 0, -1.0),
    ("diffuse", "LIGHT_TRACING", 0, 0, 256, -1.0),
    ("diffuse", "BIDIRECTIONAL", 0, 0, 256, -1.0),
    ("diffuse", "UPS", 2 / 3, 0, 256, -1.0),
]
SHORT = {"PATH_TRACING": "PT", "BIDIRECTIONAL": "BPT", "LIGHT_TRACING": "LT", "BIDIRECTIONAL_PHOTON_MAPPING": "BPM"}


def slope_at(case):
    """What a fit to the exact sums gives at the iterations of the case."""
    region, method, alpha, radius, light_paths, theory = CASES[case]
    if theory == -1:
        return theory
    n = np.array(ITERATIONS[region])
    i = np.arange(1, n[-1])
    f = np.concatenate([[1], np.cumprod((i + alpha) / (i + 1))])
    variance, bias = np.cumsum(1 / f)[n - 1] / n ** 2, 0
    if region == "sds":
        x2 = (radius / BEAM_RADIUS) ** 2
        b = x2 / 2
        photons = light_paths * RESERVE * REFLECTANCE ** MIRRORS * x2 * (2 - x2)
        variance, bias = variance * (1 - b) ** 2 / photons, b * np.cumsum(f)[n - 1] / n
    return np.polyfit(np.log(n), np.log(variance + bias ** 2), 1)[0]


def add_quad(scene, corner, u, v, material):
    corner, u, v = (np.asarray(p, float) for p in (corner, u, v))
    positions = [corner, corner + u, corner + u + v, corner + v]
    scene.add_instance(scene.add_mesh(positions, [(0, 1, 2), (0, 2, 3)], material))


def folded_beam(context):
    """The beam runs at 45 degrees between the mirrors z = 0 and z = 1, at y = 0, and leaves them after four hits."""
    scene = ups.Scene(context)
    mirror = scene.add_material(model=ups.MaterialModel.MIRROR, reflectance_rgb=[REFLECTANCE] * 3)
    add_quad(scene, (-1, -1, 0), (4.2, 0, 0), (0, 2, 0), mirror)
    add_quad(scene, (-1, -1, 1), (5.0, 0, 0), (0, 2, 0), mirror)
    start, direction = np.array([0, 0, 0.5]), np.array([1, 0, -1]) / math.sqrt(2)
    distance = 4.5 * math.sqrt(2)  # from z = 0.5 by four hits to z = 0 again
    widest = math.atan(BEAM_RADIUS / distance)
    gamma = np.linspace(0, widest, 200)
    illuminance = 1 - (np.tan(gamma) / math.tan(widest)) ** 2
    profile = ups.Profile.from_table(context, [0], np.degrees(gamma), [100 * illuminance / np.cos(gamma) ** 3])
    # The nadir, local -Z, along the beam.
    z = -direction
    x = np.array([0.0, 1.0, 0.0])
    scene.add_luminaire(profile, use_opening=0, to_world=np.column_stack([x, np.cross(z, x), z, start]))
    black = scene.add_material(reflectance_rgb=[0] * 3)
    along = np.array([1, 0, 1]) / math.sqrt(2)
    add_quad(scene, np.array([4.5, -0.5, 0]) - 0.5 * along, along, (0, 1, 0), black)
    up = -direction  # the pixel looks along local -Z
    pixel = scene.add_camera(1, 1, vertical_fov_rad=1e-3, illuminance=1,
                             to_world=np.column_stack([x, np.cross(up, x), up, np.array([4.5, 0, 0]) + 0.2 * up]))
    scene.commit()
    exact = REFLECTANCE ** MIRRORS * 100 / distance ** 2
    return scene, lambda result: result.image(pixel, ups.Channel.ILLUMINANCE)[0, 0], exact


def furnace(context):
    scene = ups.Scene(context)
    wall = scene.add_material(reflectance_rgb=[WALLS] * 3, luminance_cd_m2=[LUMINANCE] * 3)
    x, y, z = np.eye(3)
    for corner, u, v in ((0 * x, x, y), (0 * x, y, z), (0 * x, z, x), (z, y, x), (x, z, y), (y, x, z)):
        add_quad(scene, corner, u, v, wall)
    meter = scene.add_meters([[0.4, 0.3, 0.6]], normals=(0, 0, 1))
    scene.commit()
    return scene, lambda result: result.meters(meter)["illuminance_lx"][0], math.pi * LUMINANCE / (1 - WALLS)


def measure(job):
    """One render: relative error and seconds an iteration."""
    case, iterations, seed = job
    region, method, alpha, radius, light_paths, _ = CASES[case]
    with ups.Context(thread_count=1) as context:
        scene, read, exact = (folded_beam if region == "sds" else furnace)(context)
        result = scene.render(method=ups.Method[method], iteration_count=iterations, seed=seed, radius_alpha=alpha,
                              merge_radius_m=radius, light_paths_per_iteration=light_paths)
        return case, iterations, float(read(result)) / exact - 1, result.info.elapsed_s / iterations


def slope_of(iterations, squares, rng=None):
    """Of log mean square against log iterations; each point's squares are resampled where there is an rng."""
    if rng is not None:
        squares = [row[rng.integers(0, len(row), len(row))] for row in squares]
    mean = np.array([row.mean() for row in squares])
    # Standard error of log mean: never below 10 % over the root of the seeds, so that no point decides alone.
    error = np.array([max(row.std(ddof=1) / row.mean(), 0.1) / math.sqrt(len(row)) for row in squares])
    return np.polyfit(np.log(iterations), np.log(mean), 1, w=1 / error)


def fit(iterations, squares, resamples=2000):
    """Slope and offset; quantiles of the slope: 95 % and 99.5 %."""
    rng = np.random.default_rng(1)
    slope, offset = slope_of(iterations, squares)
    slopes = [slope_of(iterations, squares, rng)[0] for _ in range(resamples)]
    return slope, offset, np.quantile(slopes, [0.025, 0.975, 0.0025, 0.9975])


def name_of(case):
    region, method, alpha, *_ = CASES[case]
    return f"{region}, {SHORT.get(method, method)}" + (f", alpha {alpha:.3g}" if alpha else "")


def plot(path, rows):
    import matplotlib
    matplotlib.use("Agg")
    from matplotlib import pyplot as plt
    figure, axes = plt.subplots(1, 2, figsize=(12, 5.5))
    for axis, region in zip(axes, ("sds", "diffuse")):
        for colour, row in zip(plt.cm.tab10.colors, (r for r in rows if r["region"] == region)):
            n = np.array(ITERATIONS[region])
            t = row["seconds"] * n
            mse = np.array([e.mean() for e in row["squares"]])
            noise = np.array([e.std(ddof=1) / math.sqrt(len(e)) for e in row["squares"]])
            label = f"{row['name'].split(', ', 1)[1]}: {row['slope']:.2f} [{row['low']:.2f}, {row['high']:.2f}]"
            axis.errorbar(t, mse, np.minimum(noise, 0.9 * mse), fmt="o", markersize=4, color=colour, label=label)
            axis.plot(t, np.exp(row["offset"]) * n ** row["slope"], color=colour)
            middle = len(t) // 2
            fitted = np.exp(row["offset"]) * n[middle] ** row["slope"]
            axis.plot(t, fitted * (t / t[middle]) ** row["theory"], "--", color=colour, linewidth=1)
        axis.set(xscale="log", yscale="log", xlabel="time, s (iterations x seconds of one)", ylabel="relative MSE",
                 title={"sds": "specular from end to end: only merging finds it",
                        "diffuse": "diffuse: unbiased techniques carry the light"}[region])
        axis.grid(True, which="major", alpha=0.4)
        axis.legend(title="measured slope, dashed: theory for large n", fontsize=8)
    figure.tight_layout()
    figure.savefig(path, dpi=110)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--out", default="out/asymptotics")
    parser.add_argument("--seeds", type=int, default=16, help="of the longest renders")
    parser.add_argument("--processes", type=int, default=os.cpu_count())
    names = sorted({SHORT.get(method, method) for _, method, *_ in CASES})
    parser.add_argument("--methods", nargs="+", choices=names, default=names)
    arguments = parser.parse_args()
    if arguments.seeds < 8:
        parser.error("--seeds: an interval needs at least 8")
    os.makedirs(arguments.out, exist_ok=True)
    start = time.monotonic()
    jobs = []
    cases = [i for i, (_, method, *_) in enumerate(CASES) if SHORT.get(method, method) in arguments.methods]
    for case in cases:
        region = CASES[case][0]
        for k, n in enumerate(ITERATIONS[region]):
            more = min(8, max(1, ITERATIONS[region][-1] // (8 * n)))
            jobs += [(case, n, 1000 * k + seed) for seed in range(1, more * arguments.seeds + 1)]
    jobs.sort(key=lambda job: -job[1])  # long ones first, so that both processes end together
    errors, seconds = {}, {}
    with multiprocessing.Pool(arguments.processes) as pool:
        for case, n, error, each in pool.imap_unordered(measure, jobs, chunksize=1):
            errors.setdefault((case, n), []).append(error)
            if n == ITERATIONS[CASES[case][0]][-1]:
                seconds.setdefault(case, []).append(each)
    rows, failed = [], False
    print(f"{'region':8} {'method':6} {'alpha':>5} {'slope':>7} {'95 % interval':>17} {'theory':>7} {'at these n':>10} "
          f"{'inside':>6} {'ms/iteration':>12}")
    for case in cases:
        region, method, alpha, radius, light_paths, theory = CASES[case]
        squares = [np.array(errors[case, n]) ** 2 for n in ITERATIONS[region]]
        slope, offset, (low, high, lowest, highest) = fit(ITERATIONS[region], squares)
        expected = slope_at(case)
        inside = low <= expected <= high
        failed |= not lowest <= expected <= highest
        row = {"name": name_of(case), "region": region, "method": SHORT.get(method, method), "alpha": alpha,
               "slope": slope, "low": low, "high": high, "theory": theory, "expected": expected, "inside": inside,
               "squares": squares, "offset": offset, "seconds": float(np.median(seconds[case])),
               "light_paths": light_paths, "first_radius_m": radius}
        rows.append(row)
        print(f"{region:8} {row['method']:6} {alpha:5.3f} {slope:7.3f} [{low:7.3f}, {high:7.3f}] {theory:7.3f} "
              f"{expected:10.3f} {'yes' if inside else 'NO':>6} {1000 * row['seconds']:12.3f}", flush=True)
    with open(os.path.join(arguments.out, "slopes.csv"), "w", newline="", encoding="utf-8") as file:
        columns = ["region", "method", "alpha", "slope", "low", "high", "theory", "expected", "inside", "seconds",
                   "light_paths", "first_radius_m"]
        table = csv.DictWriter(file, columns, extrasaction="ignore")
        table.writeheader()
        table.writerows(rows)
    with open(os.path.join(arguments.out, "errors.csv"), "w", newline="", encoding="utf-8") as file:
        table = csv.writer(file)
        table.writerow(["region", "method", "alpha", "iterations", "time_s", "relative_mse", "mean_relative_error",
                        "renders"])
        for case, row in zip(cases, rows):
            for n in ITERATIONS[row["region"]]:
                e = np.array(errors[case, n])
                table.writerow([row["region"], row["method"], row["alpha"], n, n * row["seconds"], (e ** 2).mean(),
                                e.mean(), len(e)])
    plot(os.path.join(arguments.out, "asymptotics.png"), rows)
    print(f"{arguments.out}: slopes.csv, errors.csv, asymptotics.png, {time.monotonic() - start:.0f} s")
    sys.exit(1 if failed else 0)


if __name__ == "__main__":
    main()
