#!/usr/bin/env python3
"""The samples that weigh most in a render, each traced again: where do the bright specks come from?

  worst_samples.py --ups build/release/bin/ups [--scene samples/bathroom/bathroom.glb] [--method ups] [--time 60]
                   [--size 320x240] [--count 10] [--out out/worst_samples]

Prints a table, and writes of each path the text and a drawing in plan and section (N.txt, N.svg). The events of an eye
path: S scattered, M mirrored, R refracted, a small letter where roulette let fewer than a third go on.
"""
import argparse
import json
import os

from renders import run

LETTERS = {"scattered": "S", "mirrored": "M", "refracted": "R"}


def letter(vertex):
    sign = LETTERS.get(vertex["event"], "")
    return sign.lower() if vertex["survival"] < 1 / 3 else sign


def row_of(sample, path):
    own = [v for v in path["vertices"] if v["walk"] == 0]
    found = {}
    for c in path["contributions"]:
        found[c["technique"]] = found.get(c["technique"], 0) + c["value"]
    largest = path["contributions"][0]
    technique, value = max(found.items(), key=lambda item: item[1])
    total = sum(found.values())
    return [sample["address"], f"{sample['value']:.4g}", f"{sample['share']:.2f}", "".join(map(letter, own)),
            f"{max(v['throughput'] for v in own):.2f}", f"{technique} {value / total:.2f}",
            str(len(path["contributions"])),
            f"{largest['value'] / total:.2f}, weight {largest['weight']:.3f}, {largest['edges']} edges"]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--ups", required=True)
    parser.add_argument("--scene", default="samples/bathroom/bathroom.glb")
    parser.add_argument("--method", default="ups")
    parser.add_argument("--time", default="60")
    parser.add_argument("--iterations", help="instead of --time")
    parser.add_argument("--size", default="320x240")
    parser.add_argument("--count", type=int, default=10)
    parser.add_argument("--out", default="out/worst_samples")
    arguments = parser.parse_args()
    os.makedirs(arguments.out, exist_ok=True)
    settings = ["--method", arguments.method, "--size", arguments.size]
    limit = ["--iterations", arguments.iterations] if arguments.iterations else ["--time", arguments.time]
    summary = run([arguments.ups, "render", arguments.scene, *settings, *limit, "--json"])
    print(f"{summary['iterations']} iterations in {summary['time_s']:.1f} s\n")
    print("| sample | value | share | eye path | largest throughput | technique | contributions | the largest |")
    print("|---|---|---|---|---|---|---|---|")
    for i, sample in enumerate(summary["largest_samples"][:arguments.count], 1):
        drawing = os.path.join(arguments.out, f"{i}.svg")
        path = run([arguments.ups, "replay", arguments.scene, *settings, "--sample", sample["address"], "--json",
                    "--plot", drawing])
        with open(os.path.join(arguments.out, f"{i}.txt"), "w", encoding="utf-8") as file:
            file.write(path["text"])
        print("| " + " | ".join(row_of(sample, path)) + " |", flush=True)
    with open(os.path.join(arguments.out, "render.json"), "w", encoding="utf-8") as file:
        json.dump(summary, file, indent=1)


if __name__ == "__main__":
    main()
