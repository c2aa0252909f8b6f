"""The renders of the report: references, budgets by every method, and one knob at a time. Called by accuracy.py.

Seconds are processor time over threads, what the render takes where the machine does nothing else: the program's
processor time, less what reading the scene costs. `time_s` is the clock's. Two short renders tell what an iteration
costs; all others have the number of iterations that their seconds allow, so that a disturbance does not touch what they
find.
"""
import math
import os
import subprocess
import sys
from dataclasses import dataclass, field
from typing import Optional

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
FORETOLD = "median"  # the meter whose error is: short renders reach it
SIZE = "32x24"  # of cameras: the meters are what is judged
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
    least: int             # iterations of the longest render, whatever they take: 16 are the first to have an error
    reference: float       # budget of the reference over that of a render
    full: bool             # every value of every knob
    methods: tuple = METHODS
    light_paths: Optional[int] = None  # of an iteration, but where a knob says so; None: as the program takes


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


@dataclass
class Candidate:
    """A method in a scene, with words of its own, and what it costs: seconds before and in an iteration."""
    settings: Settings
    scene: Scene
    method: str
    threads: Optional[int] = None
    size: str = SIZE
    more: tuple = ()

    def __post_init__(self):
        words = [*self.more, "--map-cells"]  # nobody looks at the maps
        if self.settings.light_paths and "--light-paths" not in words:
            words += ["--light-paths", str(self.settings.light_paths)]
        self.renderer = Renderer(self.settings.ups, self.scene.path, self.threads, self.size, tuple(words))
        self.first = self.renderer.render(self.method, 1, ["--iterations", "1"])
        first = self.seconds(self.first)
        count = min(16, round(0.15 * self.settings.seconds / first))
        self.each, self.before = first, 0.0
        if count > 1 or self.settings.full:
            count = max(2, count)
            more = self.renderer.render(self.method, 1, ["--iterations", str(count)])
            self.each = max(self.share(more, self.seconds), 0.1 * first)
            self.before = max(first - self.each, 0.0)

    def seconds(self, summary):
        return seconds_of(self.scene, summary)

    def share(self, summary, cost):
        """An iteration's part of the cost, without what is done but once; of a single iteration, all."""
        if summary["iterations"] < 2:
            return cost(summary)
        return max((cost(summary) - cost(self.first)) / (summary["iterations"] - 1), 1e-3 * cost(self.first))

    def iterations(self, seconds, least=1):
        return max(least, round((seconds - self.before) / self.each))

    def render(self, seed, count, name):
        """(summary, tables)."""
        folder = os.path.join(self.settings.out, "renders", name)
        summary = self.renderer.render(self.method, seed, ["--iterations", str(count)], folder)
        return summary, tables_of(summary, folder)


def add_reference(settings, scene):
    """One long render; used again where the scene and the words are the same, for which its iterations are a power of
    two."""
    scene.reference_dir = os.path.join(settings.out, "references", scene.name)
    candidate = Candidate(settings, scene, REFERENCE_METHOD)
    count = candidate.iterations(settings.reference * settings.seconds, 2 * settings.least)
    scene.reference_summary = candidate.renderer.reference(
        REFERENCE_METHOD, REFERENCE_SEED, ["--iterations", str(2 ** round(math.log2(count)))], scene.reference_dir)
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
    candidates = {method: Candidate(settings, scene, method, more=("--target-of", FORETOLD)) for method in settings.methods}
    for k, budget in enumerate(budgets(settings)):
        for method, candidate in candidates.items():
            say(f"{scene.name}: {method}, {budget:g} s")
            count = candidate.iterations(budget, max(1, settings.least >> settings.rungs - 1 - k))
            summary, tables = candidate.render(k + 1, count, f"{scene.name}_{method}_{k}")
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
                summary.get("prediction", []), FORETOLD, longest["convergence"], *scales, made_at)]
    return rows, curves, predictions


# ---- knobs ----------------------------------------------------------------------------------------------------------

@dataclass(frozen=True)
class Knob:
    name: str
    title: str
    scene: str
    method: str
    values: tuple          # (text, {threads, size, more, grid})
    default: str           # text of the value that is taken without the knob; "" where it depends
    same_meters: bool = True
    image: bool = False    # judged, too


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
             tuple((size.replace("x", " × "), {"size": size}) for size in ("32x24", "64x48", "128x96", "256x192")), "",
             image=True),
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
    """One row a value, all for about the same seconds."""
    values = knob.values if settings.full else knob.values[:2]
    rows, curves = [], []
    for text, value in values:
        say(f"{knob.title}: {text}")
        scene, options = scenes[knob.scene], dict(value)
        if "grid" in options:
            grid = options.pop("grid")
            scene = make_scene(settings, knob.scene, f"{knob.scene}_{grid[0]}x{grid[1]}", grid=grid)
        name = f"knob_{knob.name}_{len(rows)}"
        candidate = Candidate(settings, scene, knob.method, **options)
        summary, tables = candidate.render(1, candidate.iterations(settings.seconds), name)
        row = {"knob": knob.name, "value": text, "scene": knob.scene, "method": knob.method,
               "iterations": summary["iterations"], "threads": summary["threads"],
               "seconds": candidate.seconds(summary),
               "cpu_ms_per_iteration": 1000 * summary["threads"] * candidate.share(summary, candidate.seconds),
               "clock_ms_per_iteration": 1000 * candidate.share(summary, lambda s: s["time_s"])}
        true = errors.against(tables, scene.reference)["true_p95"] if knob.same_meters else errors.UNKNOWN
        noise = image_noise(os.path.join(settings.out, "renders", name), summary) if knob.image else errors.UNKNOWN
        row |= {"true_p95": true, "image_noise": noise}
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

