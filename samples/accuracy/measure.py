"""The renders of the report: references, budgets by every method, and one knob at a time. Called by accuracy.py.

Seconds are processor time over threads, what the render takes where the machine does nothing else: the program's
processor time, less what reading the scene costs. `time_s` is the clock's.
"""
import os
import subprocess
import sys
from dataclasses import dataclass, field

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path[:0] = [os.path.join(HERE, "..", "scenes_common"), os.path.join(HERE, "..", "evaluation")]
import need_numpy  # noqa: E402,F401
import errors  # noqa: E402
import exr  # noqa: E402
import judged_scenes  # noqa: E402
import numpy as np  # noqa: E402
from measuring import MISSING  # noqa: E402
from renders import Renderer, cpu_s, read_table, run  # noqa: E402

METHODS = ("auto", "ups", "bpt", "pt", "ppm", "sppm")
REFERENCE_METHOD, REFERENCE_SEED = "ups", 1001
SIZE = "32x24"  # of cameras: the meters are what is judged
TOO_SHORT = "before the first iteration was done"
BATHROOM = os.path.join(HERE, "..", "bathroom", "bathroom.glb")
OFFICE = {"effects": ("desks", "gloss")}
SCENES = {
    "office": ("Office", "a room with glossy desks under a few IES downlights", OFFICE),
    "atrium": ("Atrium", "a hall with a glass roof, glass rails and hundreds of IES luminaires", {}),
    "bathroom": ("Bathroom", "IES wall lights, and lamps within reflectors and behind lenses, whose light glass, water "
                             "and chrome gather", {}),
}


@dataclass
class Scene:
    name: str
    path: str
    facts: dict            # of `ups info`
    read_cpu_s: float      # what reading it costs
    reference: dict = field(default_factory=dict)  # tables
    reference_summary: dict = field(default_factory=dict)
    reference_dir: str = ""


@dataclass
class Settings:
    ups: str
    out: str
    seconds: float         # budget of a render
    rungs: int             # budgets, each half of the next
    reference: float       # budget of the reference over that of a render
    full: bool             # every value of every knob


def make_scene(settings, name, folder=None, **options):
    if name == "bathroom":
        path = BATHROOM
    else:
        path = judged_scenes.make(name, os.path.join(settings.out, "scenes", folder or name),
                                  **{**SCENES[name][2], **options})
    before = cpu_s()
    facts = run([settings.ups, "info", "--json", path])["files"][0]
    return Scene(name, path, facts, cpu_s() - before)


def seconds_of(scene, summary):
    """Of a render on a machine that does nothing else."""
    return max(summary["cpu_s"] - scene.read_cpu_s, 0.1 * summary["cpu_s"]) / summary["threads"]


def tables_of(summary, folder):
    return {name: read_table(folder, name) for name in summary["meters"]}


def render(settings, scene, method, seed, limit, name, threads=None, size=SIZE, more=()):
    """(summary, tables); where the time is over before the first iteration is done, that one iteration is made."""
    folder = os.path.join(settings.out, "renders", name)
    renderer = Renderer(settings.ups, scene.path, threads, size, tuple(more))
    try:
        summary = renderer.render(method, seed, limit, folder)
    except SystemExit as stop:
        if TOO_SHORT not in str(stop.code):
            raise
        summary = renderer.render(method, seed, ["--iterations", "1"], folder)
    return summary, tables_of(summary, folder)


def add_reference(settings, scene):
    """One long render; used again where the scene and the words are the same."""
    scene.reference_dir = os.path.join(settings.out, "references", scene.name)
    renderer = Renderer(settings.ups, scene.path, None, SIZE)
    limit = ["--time", f"{settings.reference * settings.seconds:g}"]
    scene.reference_summary = renderer.reference(REFERENCE_METHOD, REFERENCE_SEED, limit, scene.reference_dir)
    scene.reference = tables_of(scene.reference_summary, scene.reference_dir)


def curve(scene, summary):
    """The convergence with seconds as everywhere here beside the clock's time."""
    scale = seconds_of(scene, summary) / summary["time_s"]
    return [{"seconds": c["time_s"] * scale, **c} for c in summary["convergence"]]


def stated(points, which="median"):
    return [(c["seconds"], c[f"{which}_relative_error"]) for c in points]


def row_of(scene, method, budget, seed, summary, tables):
    return {"scene": scene.name, "method": method, "budget_s": budget, "seed": seed,
            "iterations": summary["iterations"], "threads": summary["threads"], "time_s": summary["time_s"],
            "cpu_s": summary["cpu_s"], "seconds": seconds_of(scene, summary),
            "stated_median": errors.stated_bound(tables), **errors.against(tables, scene.reference),
            "light_missing": int(any(MISSING in w for w in summary["warnings"]))}


def budgets(settings):
    return [settings.seconds / 2 ** k for k in reversed(range(settings.rungs))]


def measure_methods(settings, scene, say):
    """Every method with every budget, each a render of its own seed: (rows, {method: curve of the longest},
    predictions)."""
    rows, curves, summaries = [], {}, {}
    for k, budget in enumerate(budgets(settings)):
        for method in METHODS:
            say(f"{scene.name}: {method}, {budget:g} s")
            summary, tables = render(settings, scene, method, k + 1, ["--time", f"{budget:g}"],
                                     f"{scene.name}_{method}_{k}")
            rows.append(row_of(scene, method, budget, k + 1, summary, tables))
            curves[method] = curve(scene, summary)
            summaries.setdefault(method, []).append(summary)
    predictions = []
    for method, of_method in summaries.items():
        longest = scene.reference_summary if method == REFERENCE_METHOD else of_method[-1]
        for summary in of_method if longest is scene.reference_summary else of_method[:-1]:
            made_at = seconds_of(scene, summary)
            scales = (made_at / summary["time_s"], seconds_of(scene, longest) / longest["time_s"])
            predictions += [{"scene": scene.name, "method": method, **p} for p in errors.predicted_and_actual(
                summary.get("prediction", []), longest["convergence"], *scales, made_at)]
    return rows, curves, predictions


# ---- knobs ------------------------------------------------------------------------------------------------------------

@dataclass(frozen=True)
class Knob:
    name: str
    title: str
    scene: str
    method: str
    values: tuple          # (text, {threads, size, more, grid})
    default: str           # text of the value that is taken without the knob; "" where it depends
    same_meters: bool = True


def words(option, values):
    return tuple((str(v), {"more": (option, str(v))}) for v in values)


def thread_counts():
    count, cores = [1], len(os.sched_getaffinity(0))
    while 2 * count[-1] < cores:
        count.append(2 * count[-1])
    return sorted({*count, cores})


def knobs():
    grids = ((8, 6), (16, 12), (32, 24), (64, 48))
    return (
        Knob("light_paths", "Light paths an iteration", "bathroom", "ups",
             words("--light-paths", (1024, 4096, 16384, 65536)), "16384"),
        Knob("alpha", "Radius alpha", "bathroom", "ups", (*words("--alpha", (0.4, 0.55)), ("2/3", {}),
                                                          *words("--alpha", (0.8, 0.95))), "2/3"),
        Knob("threads", "Threads", "office", "auto",
             tuple((str(n), {"threads": n}) for n in thread_counts()), str(thread_counts()[-1])),
        Knob("meters", "Meters", "office", "auto",
             tuple((f"{c * r:,}", {"grid": (c, r)}) for c, r in grids), "", same_meters=False),
        Knob("pixels", "Pixels of the image", "atrium", "auto",
             tuple((size.replace("x", " × "), {"size": size}) for size in ("32x24", "64x48", "128x96", "256x192")), ""),
        Knob("path_length", "Path length, edges", "office", "auto",
             (*words("--max-path-length", (2, 3, 4, 6)), ("no limit", {})), "no limit"),
    )


def image_noise(folder, summary):
    """The median pixel's relative standard error of the first camera; -1 where there is none or it is not known."""
    for name in summary["cameras"]:
        layers = exr.read_layers(os.path.join(folder, name + ".exr"))
        light, noise = layers[""].mean(2), layers["standard_error"].mean(2)
        relative = np.where(noise >= 0, noise / np.maximum(light, errors.DARK * light.mean()), np.inf)
        median = float(np.median(relative))
        return median if np.isfinite(median) else errors.UNKNOWN
    return errors.UNKNOWN


def measure_knob(settings, knob, scenes, say):
    """One row a value, all for about the same seconds: a short render counts the iterations of the long one."""
    values = knob.values if settings.full else knob.values[:2]
    rows, curves = [], []
    for text, value in values:
        say(f"{knob.title}: {text}")
        scene, options = scenes[knob.scene], dict(value)
        if "grid" in options:
            grid = options.pop("grid")
            scene = make_scene(settings, knob.scene, f"{knob.scene}_{grid[0]}x{grid[1]}", grid=grid)
        name = f"knob_{knob.name}_{len(rows)}"
        short, _ = render(settings, scene, knob.method, 1, ["--time", f"{settings.seconds / 4:g}"], name, **options)
        spent = max(seconds_of(scene, short), 1e-3)
        count = max(1, round(short["iterations"] * settings.seconds / spent))
        summary, tables = render(settings, scene, knob.method, 1, ["--iterations", str(count)], name, **options)
        seconds = seconds_of(scene, summary)
        row = {"knob": knob.name, "value": text, "scene": knob.scene, "method": knob.method,
               "iterations": summary["iterations"], "threads": summary["threads"], "seconds": seconds,
               "cpu_ms_per_iteration": 1000 * seconds * summary["threads"] / summary["iterations"],
               "clock_ms_per_iteration": 1000 * summary["time_s"] / summary["iterations"]}
        true = errors.against(tables, scene.reference)["true_p95"] if knob.same_meters else errors.UNKNOWN
        row |= {"true_p95": true, "image_noise": image_noise(os.path.join(settings.out, "renders", name), summary)}
        curves.append(stated(curve(scene, summary)))
        rows.append(row)
    # A curve ends with a record, before the render does.
    ends = [errors.known_points(c)[-1][0] for c in curves if errors.known_points(c)]
    equal = min(ends) if ends else errors.UNKNOWN
    for row, points in zip(rows, curves):
        row |= {"equal_seconds": equal, "stated_median": errors.at_time(points, equal)}
    return rows


def processor_model():
    try:
        with open("/proc/cpuinfo", encoding="utf-8") as file:
            return next((line.split(":", 1)[1].strip() for line in file if line.startswith("model name")), "")
    except OSError:
        return ""


def version(ups):
    return subprocess.run([ups, "--version"], stdout=subprocess.PIPE, text=True, check=True).stdout.strip()

