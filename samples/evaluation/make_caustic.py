#!/usr/bin/env python3
"""A spotlight with a modelled reflector over a table, with a glass ball in its beam: caustic.glb.

A spherical emitter of 5 mm and 1000 lm at the focus of a parabolic mirror (f = 20 mm, rim radius 60 mm, reflectance
0.9) whose aperture is 1 m above a matte table; a ball of radius 0.1 m, n = 1.5, centred 0.25 m above the table. Every
light path but the direct one ends in a caustic. 32 x 32 cell means over 0.8 m x 0.8 m of the table.
"""
import math
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "scenes_common"))
import need_numpy  # noqa: E402,F401
import numpy as np  # noqa: E402
from gltf_builder import Frame  # noqa: E402
from scene_script import make_scene  # noqa: E402
from shapes import check_closed, icosphere, lathe, quad  # noqa: E402

FLUX, EMITTER_RADIUS = 1000.0, 0.0025
FOCAL_LENGTH, RIM_RADIUS, APERTURE_HEIGHT = 0.020, 0.060, 1.0
BALL_RADIUS, BALL_HEIGHT = 0.1, 0.25


def parabolic_mirror():
    """Opens downwards, front side inwards: z = vertex - r^2 / 4f, with the normals of the paraboloid."""
    vertex = APERTURE_HEIGHT + RIM_RADIUS ** 2 / (4 * FOCAL_LENGTH)
    r = np.linspace(0, RIM_RADIUS, 49)
    profile = np.stack([r, vertex - r ** 2 / (4 * FOCAL_LENGTH), -r / (2 * FOCAL_LENGTH), -np.ones_like(r)], 1)
    return lathe([profile], 128), vertex - FOCAL_LENGTH


def build(scene):
    table = scene.material("table", {"model": "matte", "reflectance": 0.5})
    mirror = scene.material("mirror", {"model": "mirror", "reflectance": 0.9})
    glass = scene.material("glass", {"model": "glass", "ior": 1.5})
    bulb = icosphere(EMITTER_RADIUS, 3)
    emitter = scene.material("emitter", {"model": "matte", "reflectance": 0.0},
                             luminance=FLUX / (math.pi * bulb.area()))
    reflector, focus_height = parabolic_mirror()
    ball = check_closed(icosphere(BALL_RADIUS, 5), "ball")
    scene.shape("table", quad((-1, -1, 0), (2, 0, 0), (0, 2, 0)), table)
    scene.shape("reflector", reflector, mirror)
    scene.shape("emitter", check_closed(bulb, "emitter").moved(0, 0, focus_height), emitter)
    scene.shape("ball", ball.moved(0, 0, BALL_HEIGHT), glass)
    scene.meters("table", Frame.upright((0, 0, 0)), width_m=0.8, height_m=0.8, columns=32, rows=32, area=True)


if __name__ == "__main__":
    make_scene(__file__, __doc__, build)
