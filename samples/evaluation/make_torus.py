#!/usr/bin/env python3
"""A matte torus inside a block of glass, lit by a lamp as small as the sun: torus.glb.

The torus of table 2 of Hachisuka, Pantaleoni and Jensen (2012): every path to it from the lamp and from the eye
crosses the glass, so that only merging, or a path that meets the lamp by chance, finds its light. The lamp is a disc
1.1 degrees wide as the block sees it, twice the sun's width; a matte backdrop shows the block's shadow and caustics.
"""
import math
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "scenes_common"))
import need_numpy  # noqa: E402,F401
import numpy as np  # noqa: E402
from scene_script import make_scene  # noqa: E402
from shapes import arc, box, check_closed, lathe, sheet, torus  # noqa: E402

BLOCK_SIDE, RING_RADIUS, BAR_RADIUS = 0.20, 0.058, 0.024
LAMP_DISTANCE, LAMP_RADIUS, LAMP_FLUX = 1.0, 0.0096, 3000.0


def backdrop(width, front, back, height, rounding):
    """A floor that bends up into a wall at y = back."""
    bend = arc((0, 0), rounding, -90, 0, 12)
    path = np.vstack([[(front, 0)], [(back - rounding + a, rounding + b) for a, b in bend], [(back, height)]])
    return sheet([[(x, y, z) for x in (-width / 2, width / 2)] for y, z in path])


def build(scene):
    paper = scene.material("backdrop", {"model": "matte", "reflectance": [0.66, 0.64, 0.60]})
    clay = scene.material("torus", {"model": "matte", "reflectance": [0.72, 0.33, 0.12]})
    glass = scene.material("glass", {"model": "glass", "ior": 1.5})
    lamp = lathe([[(0, 0), (LAMP_RADIUS, 0)]], 32)  # faces down
    emitter = scene.material("lamp", {"model": "matte", "reflectance": 0.0},
                             luminance=LAMP_FLUX / (math.pi * lamp.area()))
    scene.shape("backdrop", backdrop(1.6, -0.8, 0.5, 0.9, 0.15), paper)
    # Plain edges: round ones would show the lamp in glints that every method finds by chance alone.
    block = check_closed(box((-BLOCK_SIDE / 2,) * 3, (BLOCK_SIDE / 2,) * 3), "block")
    middle = BLOCK_SIDE / 2 + 0.001  # glass does not touch what it stands on
    scene.shape("block", block.turned("z", 30).moved(0, 0, middle), glass)
    ring = check_closed(torus(RING_RADIUS, BAR_RADIUS), "torus")
    scene.shape("torus", ring.turned("x", 62).turned("z", 12).moved(0, 0, middle), clay)
    # From the left, the front and above.
    turn, tilt = -125.0, 35.0
    x, y, z = (LAMP_DISTANCE * v for v in (math.sin(math.radians(tilt)) * math.cos(math.radians(turn)),
                                          math.sin(math.radians(tilt)) * math.sin(math.radians(turn)),
                                          math.cos(math.radians(tilt))))
    scene.shape("lamp", lamp.turned("y", tilt).turned("z", turn).moved(x, y, z + middle), emitter)
    scene.camera("view", (0.0, -0.78, 0.42), (0, 0, 0.088), 27, 256, 256)


if __name__ == "__main__":
    make_scene(__file__, __doc__, build)
