#!/usr/bin/env python3
"""Writes the luminous intensity distributions of this folder, and README.md with their flux.

    python3 make_profiles.py

They are designs of this project, not measurements. Each is shaped by a formula, scaled to its flux by the band rule
(planes by trapezoid weights, bands 2 pi (cos a - cos b) (I_a + I_b) / 2), rounded, and integrated again as written.
"""
import math
import os

HERE = os.path.dirname(os.path.abspath(__file__))


def lobe(direction, axis, exponent):
    """A rotationally symmetric lobe cos^exponent about an axis."""
    cosine = sum(a * b for a, b in zip(direction, axis))
    return max(0.0, cosine) ** exponent


def direction(c_deg, gamma_deg):
    c, g = math.radians(c_deg), math.radians(gamma_deg)
    return math.sin(g) * math.cos(c), math.sin(g) * math.sin(c), -math.cos(g)


def downlight(d):
    return lobe(d, (0, 0, -1), 18)


def panel(d):
    """A diffuser behind a thin prismatic sheet: Lambertian times a mild weakening towards grazing angles."""
    cosine = max(0.0, -d[2])
    return cosine * (0.85 + 0.15 * cosine)


def wall_washer(d):
    """Five parts down and four parts up, both tilted off the wall (C0 points into the room), little to the sides."""
    tilt_down, tilt_up = math.radians(12), math.radians(18)
    down = lobe(d, (math.sin(tilt_down), 0, -math.cos(tilt_down)), 9)
    up = lobe(d, (math.sin(tilt_up), 0, math.cos(tilt_up)), 6)
    return 5 * down + 4 * up if abs(d[2]) > 1e-9 else 0.0  # nothing along the plane of its openings


def steps(first, last, step):
    return [first + i * step for i in range(int(round((last - first) / step)) + 1)]


def band_flux(planes, gammas, table):
    if len(planes) == 1:
        mean = table[0]
    else:
        span = planes[-1] - planes[0]
        weights = [0.0] * len(planes)
        for i in range(len(planes) - 1):
            for j in (i, i + 1):
                weights[j] += 0.5 * (planes[i + 1] - planes[i]) / span
        mean = [sum(w * row[k] for w, row in zip(weights, table)) for k in range(len(gammas))]
    cosines = [math.cos(math.radians(g)) for g in gammas]
    return sum(math.pi * (cosines[k] - cosines[k + 1]) * (mean[k] + mean[k + 1]) for k in range(len(gammas) - 1))


def wrapped(values, per_line=12):
    words = ["%g" % v for v in values]
    return "".join(" ".join(words[i:i + per_line]) + "\r\n" for i in range(0, len(words), per_line))


def write(name, title, shape, planes, gammas, flux_lm, watts, width, length):
    table = [[shape(direction(c, g)) for g in gammas] for c in planes]
    scale = flux_lm / band_flux(planes, gammas, table)
    table = [[round(scale * v, 2) for v in row] for row in table]
    text = "IESNA:LM-63-2002\r\n[TEST] computed, not measured\r\n[TESTLAB] none\r\n[ISSUEDATE] 2026-01-01\r\n"
    text += "[MANUFAC] UPS project\r\n[LUMCAT] %s\r\n[LUMINAIRE] %s\r\nTILT=NONE\r\n" % (name, title)
    text += "1 -1 1 %d %d 1 2 %g %g 0\r\n1 1 %g\r\n" % (len(gammas), len(planes), width, length, watts)
    text += wrapped(gammas) + wrapped(planes) + "".join(wrapped(row) for row in table)
    with open(os.path.join(HERE, name + ".ies"), "w", newline="", encoding="ascii") as file:
        file.write(text)
    opening = "disc, %g m" % -width if width < 0 else "%g m along C0 x %g m along C90" % (length, width)
    peak = max(max(row) for row in table)
    return "| `%s.ies` | %s | %s | %.2f | %.1f |\n" % (name, title, opening, band_flux(planes, gammas, table), peak)


def main():
    rows = write("wall_washer", "wall luminaire with light up and down; C0 points away from the wall", wall_washer,
                 steps(0, 180, 10), steps(0, 180, 2.5), 800, 9, 0.12, 0.06)
    rows += write("downlight", "narrow recessed downlight", downlight, [0], steps(0, 90, 1), 900, 10, -0.08, -0.08)
    rows += write("panel_600", "recessed panel 0.6 m x 0.6 m, nearly Lambertian", panel, [0], steps(0, 90, 2.5), 4000,
                  34, 0.6, 0.6)
    with open(os.path.join(HERE, "README.md"), "w", encoding="ascii") as file:
        file.write("# Distributions of this project\n\nComputed by `make_profiles.py`, not measured; free for any use. "
                   "IES LM-63-2002, type C, absolute.\nThe flux is by the band rule, as photometry programs state it; "
                   "`tests/photometry` checks it.\n\n| file | what | luminous opening | flux, lm | peak, cd |\n"
                   "|---|---|---|---|---|\n" + rows)


if __name__ == "__main__":
    main()
