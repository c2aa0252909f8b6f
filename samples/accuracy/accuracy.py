#!/usr/bin/env python3
"""What accuracy costs in time: three scenes, six methods, six knobs; tables, pictures and one page that explains them.

  accuracy.py --ups build/release/bin/ups [--seconds 5] [--fast] [--light-paths N] [--out out/accuracy]

OUT gets report.html (it needs no other file), accuracy.png and the other pictures, and the tables errors.csv,
convergence.csv, times.csv, predictions.csv, knobs.csv and references.csv, in which -1 is what is not known. Nothing
else should run meanwhile. How the page is read stands on it.
"""
import argparse
import csv
import os
import sys
import time

import measure
import errors
import page
import plots

FULL = {"seconds": 5.0, "rungs": 4, "least": 24, "reference": 12.0, "full": True}
FAST = {"seconds": 0.3, "rungs": 2, "least": 2, "reference": 2.0, "full": False,
        "methods": ("auto", "ups", "pt"), "light_paths": 2048}
A_RENDER = 0.25  # seconds beside its budget: start, reading the scene, files
PICTURES = 15.0

COLUMNS = {
    "errors": ("scene", "method", "budget_s", "seed", "iterations", "threads", "time_s", "cpu_s", "seconds",
               "stated_median", "true_median", "true_p95", "mean_off", "bounds_held", "light_missing"),
    "convergence": ("scene", "method", "seconds", "time_s", "iterations", "median_relative_error",
                    "p95_relative_error", "worst_relative_error"),
    "times": ("scene", "method", "kind", "error", "status", "seconds"),
    "predictions": ("scene", "method", "criterion", "made_at_seconds", "relative_error", "predicted_seconds",
                    "low_seconds", "high_seconds", "limited_by", "actual_seconds", "status"),
    "knobs": ("knob", "value", "scene", "method", "iterations", "threads", "seconds", "cpu_ms_per_iteration",
              "clock_ms_per_iteration", "equal_seconds", "stated_median", "true_p95", "image_noise"),
    "references": ("scene", "method", "iterations", "time_s", "seconds", "stated_median"),
}


def parse():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--ups", default="build/release/bin/ups", help="the program")
    parser.add_argument("--seconds", type=float, help=f"the longest render but the references' ({FULL['seconds']:g})")
    parser.add_argument("--fast", action="store_true", help="a minute: short renders, three methods, two values of each knob")
    parser.add_argument("--light-paths", type=int,
                        help=f"of an iteration, but where a knob says so ({FAST['light_paths']} with --fast)")
    parser.add_argument("--out", default="out/accuracy")
    arguments = parser.parse_args()
    if arguments.seconds is not None and not 0.1 <= arguments.seconds <= 1e5:
        parser.error(f"--seconds {arguments.seconds:g}: a number of seconds from 0.1 to 100000 is wanted")
    if arguments.light_paths is not None and arguments.light_paths < 1:
        parser.error(f"--light-paths {arguments.light_paths}: a number from 1 on is wanted")
    if not os.access(arguments.ups, os.X_OK):
        parser.error(f"--ups {arguments.ups}: no such program; `samples/accuracy/run.sh` builds it")
    size = dict(FAST if arguments.fast else FULL)
    if arguments.seconds is not None:
        size["seconds"] = arguments.seconds
    if arguments.light_paths is not None:
        size["light_paths"] = arguments.light_paths
    return measure.Settings(os.path.abspath(arguments.ups), arguments.out, **size)


def expected(settings):
    """(renders, seconds)."""
    values = sum(len(k.values) if settings.full else 2 for k in measure.knobs())
    methods = len(measure.SCENES) * len(settings.methods)
    references = len(measure.SCENES) * settings.reference * settings.seconds
    candidates = methods + values + len(measure.SCENES)
    seconds = methods * sum(measure.budgets(settings)) + references + (values + 0.2 * candidates) * settings.seconds
    renders = methods * settings.rungs + values + len(measure.SCENES) + 2 * candidates
    return renders, seconds + A_RENDER * renders + PICTURES


def write_table(settings, name, rows):
    with open(os.path.join(settings.out, name + ".csv"), "w", newline="", encoding="utf-8") as file:
        writer = csv.DictWriter(file, COLUMNS[name])
        writer.writeheader()
        writer.writerows(rows)


def times(error_rows, curves):
    """When each method is below 5, 2 and 1 %: by what it states (its longest render), and by what the reference says
    (all its renders)."""
    for (scene, method), curve in curves.items():
        truth = [(r["seconds"], r["true_p95"]) for r in error_rows if (r["scene"], r["method"]) == (scene, method)]
        for kind, points in (("stated", measure.stated(curve)), ("true", truth)):
            for level in errors.LEVELS:
                status, seconds = errors.time_to(points, level)
                yield {"scene": scene, "method": method, "kind": kind, "error": level, "status": status,
                       "seconds": seconds}


def measure_all(settings):
    """{table: rows}, {(scene, method): curve}, {name: Scene}."""
    renders, seconds = expected(settings)
    print(f"{renders} renders of up to {settings.seconds:g} s and {len(measure.SCENES)} references of "
          f"{settings.reference * settings.seconds:g} s: about {seconds / 60:.0f} min" if seconds > 90 else
          f"{renders} renders: about {seconds:.0f} s", flush=True)
    started = time.monotonic()

    def say(what):
        print(f"{time.monotonic() - started:5.0f} s  {what}", file=sys.stderr, flush=True)

    scenes, curves = {}, {}
    tables = {name: [] for name in COLUMNS}
    for name in measure.SCENES:
        scene = scenes[name] = measure.make_scene(settings, name)
        say(f"{name}: reference")
        measure.add_reference(settings, scene)
        summary = scene.reference_summary
        tables["references"].append({
            "scene": name, "method": measure.REFERENCE_METHOD, "iterations": summary["iterations"],
            "time_s": summary["time_s"], "seconds": measure.seconds_of(scene, summary),
            "stated_median": errors.stated_bound(scene.reference)})
        rows, of_scene, predictions = measure.measure_methods(settings, scene, say)
        tables["errors"] += rows
        tables["predictions"] += predictions
        curves |= {(name, method): curve for method, curve in of_scene.items()}
    for knob in measure.knobs():
        tables["knobs"] += measure.measure_knob(settings, knob, scenes, say)
    tables["convergence"] = [{"scene": scene, "method": method, **{key: c[key] for key in COLUMNS["convergence"][2:]}}
                             for (scene, method), curve in curves.items() for c in curve]
    tables["times"] = list(times(tables["errors"], curves))
    return tables, curves, scenes


def draw(settings, tables, curves):
    """{name: SVG bytes}; each is written as PNG, too."""
    figures, panels = {}, []
    for name, (title, _, _) in measure.SCENES.items():
        rows = [r for r in tables["errors"] if r["scene"] == name]
        of_methods = {m: [r for r in rows if r["method"] == m] for m in settings.methods}
        marked = [m for m, of_method in of_methods.items() if any(r["light_missing"] for r in of_method)]
        truth = {m: [(r["seconds"], r["true_p95"]) for r in of_method] for m, of_method in of_methods.items()}
        floor = next(r["stated_median"] for r in tables["references"] if r["scene"] == name)
        panels.append((title, truth, floor, marked))
        figures[f"true_{name}"] = plots.error_figure(truth, f"{title}: true error",
                                                     "95 % of the meters are within, %", floor, marked)
        stated = {m: measure.stated(curves[name, m]) for m in settings.methods}
        figures[f"stated_{name}"] = plots.error_figure(stated, f"{title}: stated error",
                                                       "bound of the median meter, %", None, marked)
    for knob in measure.knobs():
        rows = [r for r in tables["knobs"] if r["knob"] == knob.name]
        figures[f"knob_{knob.name}"] = plots.knob_figure(f"{knob.title} ({knob.scene}, {knob.method})", rows)
    figures["predictions"] = plots.prediction_figure(tables["predictions"])
    drawn = {}
    for name, figure in figures.items():
        if figure is not None:
            plots.png(figure, os.path.join(settings.out, name + ".png"))
            drawn[name] = plots.svg(figure)
    plots.png(plots.main_figure(panels), os.path.join(settings.out, "accuracy.png"))
    return drawn


def main():
    settings = parse()
    os.makedirs(settings.out, exist_ok=True)
    tables, curves, scenes = measure_all(settings)
    for name, rows in tables.items():
        write_table(settings, name, rows)
    pictures = draw(settings, tables, curves)
    with open(os.path.join(settings.out, "report.html"), "w", encoding="utf-8") as file:
        file.write(page.page(settings, tables, scenes, pictures))
    print(f"{os.path.join(settings.out, 'report.html')}: open it in a browser; tables and pictures are beside it")


if __name__ == "__main__":
    main()
