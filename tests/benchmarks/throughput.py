#!/usr/bin/env python3
"""How much light a second, and how near to what the ray tracer allows: whole renders by the program `ups`.

  throughput.py --ups build/benchmarks/bin/ups [--against OTHER/bin/ups] [--rounds 5] [--json FILE]

CPU time an iteration on one thread: of a longer render less a shorter one, so that loading and choosing do not count. All
programs take turns, in `--rounds` rounds; the tables have medians, and ratios over the rounds with their spread. Embree's
share is the CPU time that the same rays take by themselves, traced again within such a render (embree_rays.cpp), over the
render's. Thread scaling is by wall-clock time: for an idle machine. How to read it: README.md beside this script.
"""
import argparse
import json
import os
import statistics
import subprocess
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
SAMPLES = os.path.join(HERE, "..", "..", "samples")
sys.path[:0] = [os.path.join(SAMPLES, "scenes_common"), os.path.join(SAMPLES, "evaluation")]
import rooms  # noqa: E402
from measuring import print_table  # noqa: E402
from renders import Renderer  # noqa: E402

EMBREE_RAYS = 1_000_000
BATHROOM = os.path.join(SAMPLES, "bathroom", "bathroom.glb")


class Case:
    def __init__(self, group, label, scene, method, iterations, size=None, threads=1):
        self.group, self.label, self.scene, self.method = group, label, scene, method
        self.iterations, self.size, self.threads = iterations, size, threads

    def render(self, ups, iterations):
        renderer = Renderer(ups, self.scene, self.threads, self.size)
        report = renderer.render(self.method, 1, ["--iterations", str(iterations)])
        return {"cpu_s": report["cpu_s"], "wall_s": report["time_s"], **report["work"]}

    def iteration(self, ups):
        """What one costs and does."""
        few, many = self.render(ups, 1), self.render(ups, 1 + self.iterations)
        return {key: (many[key] - few[key]) / self.iterations for key in many}


def scene(folder, name, build, **words):
    return rooms.write(os.path.join(folder, name, "scene.glb"), build, **words)


def cases(folder):
    box = scene(folder, "box", rooms.box_with_balls)
    office = scene(folder, "office", rooms.office)
    yield Case("rooms", "box, ups", box, "ups", 8)
    yield Case("rooms", "box, bpt", box, "bpt", 8)
    yield Case("rooms", "bathroom, ups", BATHROOM, "ups", 5)
    yield Case("rooms", "office of 8 IES luminaires, auto", office, "auto", 60)
    for around in (16, 64, 384, 704):
        yield Case("triangles", f"{2 * around * (around - 2) + 24:,}",
                   scene(folder, f"box_{around}", rooms.box_with_balls, facets_around=around), "ups", 8)
    for count in (16, 64, 1024, 10000):
        yield Case("luminaires", f"{count:,}", scene(folder, f"hall_{count}", rooms.hall, luminaires=count), "auto", 30)
    for columns, rows in ((32, 24), (160, 120), (400, 300)):
        yield Case("meters", f"{columns * rows:,}",
                   scene(folder, f"office_{columns}", rooms.office, grid=(columns, rows)), "auto", 20)
    for size in ("256x256", "512x512", "1024x1024", "2048x2048"):
        yield Case("pixels", size, box, "ups", 8, size)
    for threads in (1, 2):
        yield Case("threads", str(threads), BATHROOM, "ups", 5, None, threads)


def embree_s_per_ray(case, ups, preload, rays_an_iteration):
    environment = {**os.environ, "LD_PRELOAD": preload, "UPS_EMBREE_RAYS": str(EMBREE_RAYS)}
    iterations = 2 + int(EMBREE_RAYS / rays_an_iteration)
    command = [ups, "render", case.scene, "--method", case.method, "--iterations", str(iterations), "--threads", "1"]
    done = subprocess.run(command, env=environment, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
    start = done.stderr.find('{"rays"')  # amid the program's own progress
    if start < 0:
        sys.exit(f"{' '.join(command)}: {preload} has not seen {EMBREE_RAYS} rays\n{done.stderr.strip()}")
    found = json.JSONDecoder().raw_decode(done.stderr[start:])[0]
    return found["embree_s"] / found["rays"]


def ratio(values, others):
    ratios = sorted(a / b for a, b in zip(values, others))
    return f"{statistics.median(ratios):.2f} ({ratios[0]:.2f} to {ratios[-1]:.2f})"


def measure(arguments):
    programs = [arguments.ups] + ([arguments.against] if arguments.against else [])
    out = []
    for case in cases(arguments.out):
        if arguments.only and case.group not in arguments.only:
            continue
        runs = {ups: [] for ups in programs}
        for _ in range(arguments.rounds):
            for ups in programs:
                runs[ups].append(case.iteration(ups))
        embree = None
        if case.group == "rooms":
            embree = embree_s_per_ray(case, arguments.ups, arguments.embree_rays, runs[arguments.ups][0]["rays"])
        out.append({"group": case.group, "case": case.label, "threads": case.threads, "embree_s_per_ray": embree,
                    "runs": [runs[ups] for ups in programs]})
        print(f"{case.group}: {case.label}", file=sys.stderr)
    return out


def rows(measured, group):
    first = None
    for m in measured:
        if m["group"] != group:
            continue
        runs = m["runs"][0]
        time = "wall_s" if group == "threads" else "cpu_s"
        cost, work = statistics.median(r[time] for r in runs), runs[0]
        pairs = min(p for p in (work["light_paths"], work["eye_paths"]) if p) if work["eye_paths"] else 0
        paths = work["light_paths"] + work["eye_paths"]
        first = first or cost / paths
        share = m["embree_s_per_ray"] and m["embree_s_per_ray"] * work["rays"] / cost
        yield (m["case"], f"{1e3 * cost:.1f}", f"{pairs / cost:,.0f}", f"{work['rays'] / cost / 1e6:.2f}",
               f"{work['rays'] / max(pairs, 1):.1f}", f"{share:.0%}" if share else "", f"{cost / paths / first:.2f}",
               ratio([r[time] for r in m["runs"][1]], [r[time] for r in runs]) if len(m["runs"]) > 1 else "")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--ups", default="build/benchmarks/bin/ups", help="the program")
    parser.add_argument("--against", help="another build's program: ratios of its time over the first one's")
    parser.add_argument("--embree-rays", help="default: ups_embree_rays.so beside the program")
    parser.add_argument("--rounds", type=int, default=3)
    parser.add_argument("--only", nargs="+", help="groups: rooms triangles luminaires meters pixels threads")
    parser.add_argument("--json", help="file for all figures")
    parser.add_argument("--out", default="out/throughput", help="folder for the scenes")
    arguments = parser.parse_args()
    arguments.embree_rays = os.path.abspath(
        arguments.embree_rays or os.path.join(os.path.dirname(arguments.ups), "ups_embree_rays.so"))
    measured = measure(arguments)
    if arguments.json:
        with open(arguments.json, "w", encoding="utf-8") as file:
            json.dump(measured, file, indent=1)
    for group in dict.fromkeys(m["group"] for m in measured):
        print(f"\n{group}\n")
        print_table((group, "ms an iteration", "path pairs/s", "M rays/s", "rays a pair", "Embree's share",
                     "a path, over the first", "other build's time over it"), rows(measured, group))


if __name__ == "__main__":
    main()
