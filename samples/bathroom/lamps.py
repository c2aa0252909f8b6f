"""The lamps of the bathroom: a recessed downlight modelled down to its emitter, and an up-and-down light measured as
an IES file.

Called by make_bathroom.py. Lengths are metres, +Z up.
"""
import math

import numpy as np

from shapes import arc, check_closed, icosphere, lathe, merged, tube

# Downlight; its z = 0 is the ceiling.
FOCAL_LENGTH = 0.010
RIM_RADIUS = 0.040      # of the reflector and of the tube under it
REFLECTOR_DEPTH = RIM_RADIUS ** 2 / (4 * FOCAL_LENGTH)
REFLECTOR_RIM_Z = 0.022
EMITTER_RADIUS = 0.0035
LENS_EDGE_TOP_Z, LENS_EDGE_Z, LENS_CURVATURE = 0.008, 0.005, 0.100
LENS_RADIUS = 0.0406    # reaches into the wall of the tube, so that no light passes beside it
FLANGE_RADIUS = 0.052
CEILING_HOLE_RADIUS = 0.046

# Wall lamp; its z = 0 is the middle. The opening of the file encloses the body, so that the body hides none of it.
BODY_RADIUS, BODY_HALF_HEIGHT = 0.036, 0.090
OPENING_DIAMETER, OPENING_HEIGHT = 0.074, 0.184
WALL_LAMP_REACH = 0.085  # of its axis from the wall
WALL_LAMP_FLUX = 600.0


def downlight_reflector():
    """Paraboloid with its focus at the emitter; front side inwards."""
    vertex = REFLECTOR_RIM_Z + REFLECTOR_DEPTH
    r = np.linspace(0, RIM_RADIUS, 41)
    profile = np.stack([r, vertex - r ** 2 / (4 * FOCAL_LENGTH), -r / (2 * FOCAL_LENGTH), -np.ones_like(r)], 1)
    return lathe([profile], 96)


def downlight_trim():
    """Tube from the reflector's rim to the flange under the ceiling; the flange's edge pierces the ceiling, so that
    reflector, tube, flange and ceiling close off the space above."""
    return lathe([[(RIM_RADIUS, REFLECTOR_RIM_Z), (RIM_RADIUS, -0.003)],
                  [(RIM_RADIUS, -0.003), (FLANGE_RADIUS, -0.003)],
                  [(FLANGE_RADIUS, -0.003), (FLANGE_RADIUS, 0.003)]], 96)


def downlight_lens():
    """Biconvex: the beam of the reflector crosses over under it and spreads to about 25 degrees on each side."""
    half_angle = math.degrees(math.asin(LENS_RADIUS / LENS_CURVATURE))
    centre_distance = LENS_CURVATURE * math.cos(math.radians(half_angle))
    below, above = LENS_EDGE_Z + centre_distance, LENS_EDGE_TOP_Z - centre_distance
    lower = arc((0, below), LENS_CURVATURE, -90, half_angle - 90, 24)
    upper = arc((0, above), LENS_CURVATURE, 90 - half_angle, 90, 24)
    lens = lathe([np.concatenate([lower, lower - (0, below)], 1),
                  [(LENS_RADIUS, LENS_EDGE_Z), (LENS_RADIUS, LENS_EDGE_TOP_Z)],
                  np.concatenate([upper, upper - (0, above)], 1)], 96)
    return check_closed(lens, "downlight lens")


def downlight_emitter():
    focus_z = REFLECTOR_RIM_Z + REFLECTOR_DEPTH - FOCAL_LENGTH
    return check_closed(icosphere(EMITTER_RADIUS, 2), "emitter").moved(0, 0, focus_z)


def wall_lamp_body():
    """A round bar with domed ends, on an arm from a rosette; the wall is at y = +WALL_LAMP_REACH."""
    top = arc((0, BODY_HALF_HEIGHT - 0.008), 1, 0, 90, 8) * (BODY_RADIUS, 1)
    top[:, 1] = BODY_HALF_HEIGHT - 0.008 + 0.008 * np.sin(np.radians(np.linspace(0, 90, 9)))
    bar = lathe([np.vstack([top[::-1] * (1, -1), top])], 48)
    arm = tube([(0, BODY_RADIUS - 0.004, 0), (0, WALL_LAMP_REACH, 0)], 0.008)
    rosette = tube([(0, WALL_LAMP_REACH - 0.012, 0), (0, WALL_LAMP_REACH + 0.001, 0)], 0.035, 48)
    return merged([bar, arm, rosette])


def write_wall_lamp_ies(path):
    """LM-63-2002, absolute photometry: two lobes along the vertical with a faint glow to the side."""
    gamma = np.arange(0, 180.1, 2.5)
    cosine = np.cos(np.radians(gamma))
    shape = np.where(cosine > 0, np.abs(cosine) ** 3, 0.8 * np.abs(cosine) ** 3) + 0.04 * np.sin(np.radians(gamma))
    # Flux by the band rule: each band's solid angle times the mean of its two intensities.
    flux = (2 * np.pi * -np.diff(cosine) * (shape[1:] + shape[:-1]) / 2).sum()
    candela = shape * WALL_LAMP_FLUX / flux
    lines = ["IESNA:LM-63-2002", "[TEST] computed by make_bathroom.py", "[TESTLAB] none", "[ISSUEDATE] 2026-01-01",
             "[MANUFAC] UPS samples", "[LUMINAIRE] wall lamp, up and down, 600 lm", "TILT=NONE",
             f"1 -1 1 {len(gamma)} 1 1 2 {-OPENING_DIAMETER} {-OPENING_DIAMETER} {OPENING_HEIGHT}", "1 1 8"]
    for values, form in ((gamma, "{:.1f}"), (np.zeros(1), "{:.1f}"), (candela, "{:.3f}")):
        words = [form.format(v) for v in values]
        lines += [" ".join(words[k:k + 12]) for k in range(0, len(words), 12)]
    with open(path, "w", newline="\r\n") as file:
        file.write("\n".join(lines) + "\n")
