"""Cases with known illuminances: renders each by each method until the noise is small enough, and judges.

A `Case` writes a scene; its `Check`s say what the scene's meters must read. `run` gives one `Row` a check and method.
A row passes where

    |E - E_ref| <= max(0.5 % of E_ref, 3 standard errors)   and   standard error <= 0.2 % of E_ref;

where E_ref is 0, E must be exactly 0. Seeds are fixed: a case that passes once passes always on the same machine. How
often a right engine would fail with another seed: noise decides only where 3 standard errors exceed 0.5 %, and then
with probability P(|t| > 3) for Student's t with the 15 degrees of freedom of 16 batches, 0.9 % a check. With a standard
error of 0.1 % the 0.5 % are five standard errors: 0.02 %. What is found: an error of 1 % in 95 cases of 100 at the
largest noise.

Called by validate.py; the cases are in modules of their own, e.g. cie171.py, and tables.py writes the rows.
"""
import contextlib
import io
import math
import os
import sys
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, replace
from typing import Callable, Optional

import tables

sys.path.append(os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "evaluation"))
from renders import Renderer, read_table  # noqa: E402

RELATIVE_TOLERANCE = 0.005
SIGMAS = 3
LARGEST_NOISE = 0.002


@dataclass
class Check:
    """What a meter must read: the one of this index in the set `meters`, or, without index, the mean of the set (its
    standard error is then the set's own: meters of a set share light paths)."""
    meters: str
    reference: float  # lx; 0: exactly dark
    index: Optional[int] = None
    label: str = ""  # for tables; without it the set's name and the index
    note: str = ""  # beside the reference in tables, e.g. the published value
    judged: bool = True  # False: the reading is shown alone; the note says why

    def __post_init__(self):
        if not self.label:
            self.label = self.meters if self.index is None else f"{self.meters} {self.index}"


@dataclass
class Case:
    name: str  # of files and on the command line
    title: str
    build: Callable[[str], object]  # writes the .glb (and files it refers to beside it)
    checks: list
    methods: tuple = ("ups", "bpt", "pt")
    fast: object = ("ups", "bpt", "pt")  # the methods by which the tests run it; {method: iterations}: with so many
    options: tuple = ()  # more words for `ups render`
    iterations: object = 64  # to begin with; a number, or {method: number}
    cannot: tuple = ()  # ((method, why it cannot sample this case), ...); not in `methods`
    tables: bool = True  # of the program, also where means alone are judged
    group: str = ""  # cases of one group share a line of the summary; without it each has its own
    long: bool = False  # takes many times as long as others: is started first

    def __post_init__(self):
        self.group = self.group or self.name

    def for_tests(self):
        """Maps take the program longer than most of these renders do: few, and coarse ones."""
        chosen = self.fast if isinstance(self.fast, dict) else {}
        return replace(self, methods=tuple(m for m in self.methods if m in self.fast), tables=False,
                       options=(*self.options, "--map-cells"),
                       iterations={m: chosen.get(m, self.first_iterations(m)) for m in self.methods})

    def unjudged(self, share):
        """Once by one in `share` of the iterations, however noisy."""
        iterations = {m: max(self.first_iterations(m) // share, 1) for m in self.methods}
        return replace(self, iterations=iterations, checks=[replace(c, judged=False) for c in self.checks])

    def first_iterations(self, method):
        return self.iterations.get(method, 64) if isinstance(self.iterations, dict) else self.iterations


@dataclass
class Row:
    case: str
    check: str
    method: str
    E: float  # lx
    standard_error: float  # lx
    bias: Optional[float]  # lx, as the program estimates it; None for means of sets
    E_ref: float  # lx
    deviation: Optional[float]  # %; None where E_ref is 0
    tolerance: float  # lx
    passed: Optional[bool]  # None: not judged
    note: str
    iterations: int
    time_s: float


def quiet(error, reference):
    """Is the noise small enough? More iterations darken no meter."""
    return reference == 0 or 0 <= error <= LARGEST_NOISE * reference


def judge(case, method, check, reading, iterations, time_s):
    value, error, bias = reading
    reference = check.reference
    tolerance = max(RELATIVE_TOLERANCE * reference, SIGMAS * error) if reference else 0.0
    passed = bool(abs(value - reference) <= tolerance and quiet(error, reference)) if check.judged else None
    deviation = 100 * (value / reference - 1) if reference else None
    return Row(case.name, check.label, method, value, error, bias, reference, deviation, tolerance, passed, check.note,
               iterations, time_s)


def noise(standard_error, error_bound):
    """Light that no path or too few have found has no standard error: half of its bound of 95 % stands for it."""
    return standard_error if standard_error >= 0 else error_bound / 2


def read_meters(folder, summary):
    """{set: ((mean, its standard error, None), [(E, standard error, bias), ...])}; without a folder means alone."""
    sets = {}
    for name, meters in summary["meters"].items():
        readings = [(row["illuminance_lx"], noise(row["standard_error_lx"], row["error_bound_lx"]), row["bias_lx"])
                    for row in (read_table(folder, name) if folder else ())]
        mean = meters["mean_lx"], noise(meters["mean_standard_error_lx"], meters["mean_error_bound_lx"]), None
        sets[name] = (mean, readings)
    return sets


def growth(rows):
    """How many times as many iterations should make the noisiest check quiet: twice at least, 8 times at most, four
    times where its noise is not known. Noise falls with the root of the iterations; a tenth more is for luck."""
    noises = [r.standard_error / r.E_ref for r in rows if r.passed is not None and r.E_ref]
    if any(n < 0 for n in noises):
        return 4
    return min(max(math.ceil(1.1 * (max(noises) / LARGEST_NOISE) ** 2), 2), 8)


def run_case(renderer, case, method, out, cap):
    """Renders with more iterations until no check is too noisy; the rows of the last render."""
    iterations, seconds = case.first_iterations(method), 0.0
    if not case.tables and all(c.index is None for c in case.checks):
        out = None
    while True:
        summary = renderer.render(method, 1, ["--iterations", str(iterations)], out)
        sets = read_meters(out, summary)
        seconds += summary["time_s"]
        rows = []
        for check in case.checks:
            mean, readings = sets[check.meters]
            reading = mean if check.index is None else readings[check.index]
            rows.append(judge(case, method, check, reading, summary["iterations"], seconds))
        if all(r.passed is None or quiet(r.standard_error, r.E_ref) for r in rows) or iterations >= cap:
            return rows
        iterations = min(iterations * growth(rows), cap)


def build(case, out):
    """The case's folder within `out`, and the scene file written there."""
    folder = os.path.join(out, case.name)
    os.makedirs(folder, exist_ok=True)
    scene = os.path.join(folder, case.name + ".glb")
    with contextlib.redirect_stdout(io.StringIO()):  # the builder says what it has written
        case.build(scene)
    return folder, scene


def run(ups, cases, methods, out, jobs=1, cap=65536, report=print):
    """The rows of all cases by the methods that can sample them, so many renders at once, each on one thread: short
    renders use two badly. `report` gets a line of text a case and method."""
    wanted = []
    for case in cases:
        folder, scene = build(case, out)
        renderer = Renderer(ups, scene, 1, more=case.options)
        wanted += [(renderer, case, m, os.path.join(folder, m), cap) for m in methods if m in case.methods]
    rows = []
    with ThreadPoolExecutor(jobs) as pool:
        futures = {k: pool.submit(run_case, *wanted[k])
                   for k in sorted(range(len(wanted)), key=lambda k: not wanted[k][1].long)}
        for k, (_, case, method, _, _) in enumerate(wanted):
            done = futures[k].result()
            rows += done
            report(tables.progress_line(case, method, done))
    return rows
