"""The lamps of the bathroom: a recessed downlight modelled down to its emitter, and an up-and-down light measured as
an IES file.

Called by make_bathroom.py. Lengths are metres, +Z up.
"""
import math

import numpy as np

from ies import write_axial
from shapes import check_closed, icosphere, lathe, merged, tube

# Downlight; its z = 0 is the ceiling.
FOCAL_LENGTH = 0.010
RIM_RADIUS = 0.040      # of the reflector and of the tube under it
REFLECTOR_DEPTH = RIM_RADIUS ** 2 / (4 * FOCAL_LENGTH)
REFLECTOR_RIM_Z = 0.022
EMITTER_RADIUS = 0.0025
LENS_TOP_Z, LENS_BOTTOM_Z = 0.009, 0.004
LENS_RING_WIDTH, LENS_SLOPE = 0.0100, 0.75
LENS_RADIUS = 0.0406    # reaches into the wall of the tube, so that no light passes beside it
FLANGE_RADIUS = 0.052
CEILING_HOLE_RADIUS = 0.046

# Wall lamp: a hoop around its luminous disc, which shines up and down. z = 0 is the disc.
OPENING_DIAMETER = 0.110
HOOP_RADIUS, HOOP_THICKNESS = 0.0585, 0.003  # of its circle, of its bar
WALL_LAMP_REACH = 0.105  # of its axis from the wall
WALL_LAMP_FLUX = 300.0


def downlight_reflector():
    """Paraboloid with its focus at the emitter; front side inwards."""
    vertex = REFLECTOR_RIM_Z + REFLECTOR_DEPTH
    r = np.linspace(0, RIM_RADIUS + 0.0003, 33)  # pierces the tube
    profile = np.stack([r, vertex - r ** 2 / (4 * FOCAL_LENGTH), -r / (2 * FOCAL_LENGTH), -np.ones_like(r)], 1)
    return lathe([profile], 80)


def downlight_trim():
    """Tube from the reflector's rim to the flange under the ceiling; the flange's edge pierces the ceiling, so that
    reflector, tube, flange and ceiling close off the space above."""
    return lathe([[(RIM_RADIUS, REFLECTOR_RIM_Z), (RIM_RADIUS, -0.003)],
                  [(RIM_RADIUS, -0.003), (FLANGE_RADIUS, -0.003)],
                  [(FLANGE_RADIUS, -0.003), (FLANGE_RADIUS, 0.003)]], 80)


def downlight_lens():
    """Flat above, concentric rings below: they spread the narrow beam of the reflector into a flood. Two terms of the
    series of a triangular wave: most of the surface has nearly the same slope, and its edges are round."""
    r = np.linspace(0, LENS_RADIUS, 81)
    x = 2 * math.pi / LENS_RING_WIDTH * r
    depth = LENS_SLOPE * LENS_RING_WIDTH / (2 * math.pi) * (np.cos(x) + np.cos(3 * x) / 9)
    slope = LENS_SLOPE * (np.sin(x) + np.sin(3 * x) / 3)
    wave = np.stack([r, LENS_BOTTOM_Z - depth, slope, -np.ones_like(r)], 1)
    edge = (LENS_RADIUS, wave[-1, 1])
    lens = lathe([wave, [edge, (LENS_RADIUS, LENS_TOP_Z)], [(LENS_RADIUS, LENS_TOP_Z), (0, LENS_TOP_Z)]], 64)
    return check_closed(lens, "downlight lens")


def downlight_emitter():
    focus_z = REFLECTOR_RIM_Z + REFLECTOR_DEPTH - FOCAL_LENGTH
    return check_closed(icosphere(EMITTER_RADIUS, 2), "emitter").moved(0, 0, focus_z)


def wall_lamp_body():
    """The hoop on an arm from a rosette; the wall is at y = +WALL_LAMP_REACH."""
    turn = np.radians(np.linspace(0, 360, 97))
    circle = HOOP_RADIUS * np.stack([np.cos(turn), np.sin(turn), np.zeros_like(turn)], 1)
    hoop = tube(circle, HOOP_THICKNESS, 16, capped=False)
    arm = tube([(0, HOOP_RADIUS + 0.001, 0), (0, WALL_LAMP_REACH, 0)], HOOP_THICKNESS + 0.001)
    rosette = tube([(0, WALL_LAMP_REACH - 0.012, 0), (0, WALL_LAMP_REACH + 0.001, 0)], 0.035, 48)
    return merged([hoop, arm, rosette])


def write_wall_lamp_ies(path):
    """LM-63-2002, absolute photometry: two lobes along the vertical with a faint glow to the side."""
    gamma = np.arange(0, 180.1, 2.5)
    cosine = np.cos(np.radians(gamma))
    shape = np.where(cosine > 0, np.abs(cosine) ** 3, 0.8 * np.abs(cosine) ** 3) + 0.04 * np.sin(np.radians(gamma))
    # Flux by the band rule: each band's solid angle times the mean of its two intensities.
    flux = (2 * np.pi * -np.diff(cosine) * (shape[1:] + shape[:-1]) / 2).sum()
    candela = shape * WALL_LAMP_FLUX / flux
    comments = [("TEST", "computed by make_bathroom.py"), ("TESTLAB", "none"), ("ISSUEDATE", "2026-01-01"),
                ("MANUFAC", "UPS samples"), ("LUMINAIRE", f"wall lamp, up and down, {WALL_LAMP_FLUX:.0f} lm")]
    write_axial(path, gamma, candela, comments, OPENING_DIAMETER, watts=8)
