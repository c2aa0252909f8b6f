#!/usr/bin/env python3
"""What each effect costs: one office, effects added one by one; CPU time until the median meter's noise is 1 %.

  cost_of_effects.py --ups build/release/bin/ups [--seconds 6] [--seeds 2]

Renders each room by method `auto` and by full Unified Path Sampling, all in turn, on one thread, seeds 1, 2, ..., and
prints a table in Markdown. How to read it: README.md beside this script.
"""
import argparse
import os
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path[:0] = [os.path.join(HERE, "..", "scenes_common"), os.path.join(HERE, "..", "evaluation")]
import rooms  # noqa: E402
from measuring import Candidate, chosen, print_table, take_turns, to_1_percent  # noqa: E402

STEPS = (("matte office, desks", "desks"), ("+ gloss on the desks", "gloss"), ("+ picture glass of 1 m²", "pane"),
         ("+ mirror of 1.8 m²", "mirror"), ("+ textured floor", "texture"),
         ("+ downlight with reflector", "downlight"), ("+ basin of water", "water"))
MANY = {"columns": 40, "rows": 25}


def steps():
    effects = []
    for title, effect in STEPS:
        effects.append(effect)
        yield title, {"effects": tuple(effects)}
    yield "+ 1,000 luminaires for 8", {"effects": tuple(effects), **MANY}


def rows(arguments):
    candidates, titles = [], []
    for k, (title, options) in enumerate(steps()):
        scene = rooms.write(os.path.join(arguments.out, str(k), "scene.glb"), rooms.office, **options)
        candidates += [Candidate(arguments.ups, method, scene, f"{method} {k}") for method in ("auto", "ups")]
        titles.append(title)
    runs = take_turns(candidates, arguments.seconds, arguments.seeds, os.path.join(arguments.out, "runs"))
    for k, title in enumerate(titles):
        auto, full = (to_1_percent(runs[f"{method} {k}"]) for method in ("auto", "ups"))
        yield (title, f"{auto:.2f}", f"{auto / to_1_percent(runs['auto 0']):.2f}", f"{full:.2f}", f"{full / auto:.2f}",
               chosen(runs[f"auto {k}"][0].report))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--ups", default="build/release/bin/ups", help="the program")
    parser.add_argument("--seconds", type=float, default=6, help="CPU time of a render (6)")
    parser.add_argument("--seeds", type=int, default=2, help="renders of each room and method (2)")
    parser.add_argument("--out", default="out/effects")
    print_table(("room", "auto, s to 1 %", "over the first", "ups, s to 1 %", "ups / auto", "techniques of auto"),
                rows(parser.parse_args()))


if __name__ == "__main__":
    main()
