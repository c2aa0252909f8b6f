#!/usr/bin/env python3
"""Do two methods measure the same light, meter by meter? Runs `ups render` twice and compares within the errors.

  check_reference.py --ups build/release/bin/ups --scene bathroom_check.glb --method ups --time 60 \\
      --reference-method pt --reference-time 900

For every meter z = (E - E_reference) / sqrt(s^2 + s_reference^2), s the standard errors of 16 batches, so that z is
nearly Student's t with 15 to 30 degrees of freedom and rms z is about 1.05 where the methods agree. Fails where a
|z| is above 4 (one of 32 right meters is, once in 30 checks at worst) or the total differs by over 3 standard errors s
and 0.5 % (once in 110 to 190 where s is above 0.17 %); of the total 4.7 s, or 0.5 % + 1.7 s, is found in 95 cases of
100: s is printed, below 0.2 % it is 1 %.
"""
import argparse
import math
import os
import sys

from renders import Renderer, read_table


def render(arguments, method, seed, seconds):
    out = os.path.join(arguments.out, method)
    rows, summary = [], Renderer(arguments.ups, arguments.scene).render(method, seed, ["--time", str(seconds)], out)
    for name in summary["meters"]:
        rows += [(name, row["illuminance_lx"], row["standard_error_lx"]) for row in read_table(out, name)]
    return rows, summary


def parse():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--ups", required=True, help="the program")
    parser.add_argument("--scene", required=True)
    parser.add_argument("--method", default="ups")
    parser.add_argument("--time", type=float, default=60, help="seconds")
    parser.add_argument("--reference-method", default="pt")
    parser.add_argument("--reference-time", type=float, default=900, help="seconds")
    parser.add_argument("--out", default="out/check_reference")
    return parser.parse_args()


def main():
    arguments = parse()
    measured, summary = render(arguments, arguments.method, 1, arguments.time)
    reference, reference_summary = render(arguments, arguments.reference_method, 1001, arguments.reference_time)
    scores = []
    print(f"{'meter':>14} {arguments.method + ', lx':>12} {'+-':>7} "
          f"{arguments.reference_method + ', lx':>12} {'+-':>7} {'z':>6}")
    for i, ((name, e, s), (_, e_reference, s_reference)) in enumerate(zip(measured, reference)):
        scores.append((e - e_reference) / math.hypot(s, s_reference))
        print(f"{name + ' ' + str(i):>14} {e:12.2f} {s:7.2f} {e_reference:12.2f} {s_reference:7.2f} {scores[-1]:6.2f}")
    mean, mean_reference = (sum(r[1] for r in rows) / len(rows) for rows in (measured, reference))
    # The sets' own mean errors: meters of a set share photons.
    error = math.sqrt(sum((meters["mean_standard_error_lx"] * sum(r[0] == name for r in measured) / len(measured)) ** 2
                          for s in (summary, reference_summary) for name, meters in s["meters"].items()))
    difference = mean - mean_reference
    print(f"mean {mean:.2f} and {mean_reference:.2f} lx: {100 * difference / mean_reference:+.2f} % +- "
          f"{100 * error / mean_reference:.2f} %; rms z {math.sqrt(sum(z * z for z in scores) / len(scores)):.2f}, "
          f"worst {max(map(abs, scores)):.2f}")
    wrong = max(map(abs, scores)) > 4 or abs(difference) > max(3 * error, 0.005 * mean_reference)
    sys.exit("they do not agree" if wrong else 0)


if __name__ == "__main__":
    main()
