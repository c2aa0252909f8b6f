#!/usr/bin/env python3
"""The main figures of `ups render --json` for people. Called by run.sh: summary.py render.json"""
import json
import sys


def known(value, form="{:.3g}"):
    return "unknown" if value < 0 else form.format(value)  # -1: not known


def main():
    if len(sys.argv) != 2:
        sys.exit("usage: summary.py render.json")
    with open(sys.argv[1], encoding="utf-8") as file:
        render = json.load(file)
    print(f"method {render['method']}, {render['iterations']} iterations in {render['time_s']:.1f} s on "
          f"{render['threads']} threads")
    print("techniques: " + ", ".join(render["techniques"]))
    print("effects: " + ", ".join(render["effects"]))
    flux = render["flux"]
    print(f"flux: {flux['emitted_lm']:.1f} lm emitted, {flux['absorbed_lm']:.1f} absorbed, "
          f"{flux['escaped_lm']:.1f} escaped")
    for name, meters in render["meters"].items():
        worst = meters["worst_relative_error_bound"]
        print(f"{name:>10}: mean {meters['mean_lx']:.1f} lx (standard error "
              f"{known(meters['mean_standard_error_lx'])} lx), {meters['min_lx']:.1f} to "
              f"{meters['max_lx']:.1f} lx, uniformity {meters['uniformity']:.2f}, "
              f"worst error bound {known(100 * worst)}{' %' if worst >= 0 else ''}")
    for name, camera in render["cameras"].items():
        print(f"{name:>10}: {camera['width']} x {camera['height']} pixels, mean luminance "
              f"{camera['mean_luminance_cd_m2']:.1f} cd/m2")
    for warning in render["warnings"]:
        print(f"warning: {warning}")


if __name__ == "__main__":
    main()
