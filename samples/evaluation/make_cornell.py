#!/usr/bin/env python3
"""A Cornell box with a highly glossy metal box and a solid glass box under a small lamp: cornell.glb.

The case of figure 11 of Hachisuka, Pantaleoni and Jensen (2012). The lamp is a matte square of 4 cm in a room of 1 m.
What lies beneath the glass is seen through the glass and lit through the glass, so that connections cannot make it
(bidirectional path tracing has trouble there); the metal mirrors the room in a lobe narrow enough that few photons
of a merge fall into it (photon mapping has trouble there).
"""
import math
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "scenes_common"))
import need_numpy  # noqa: E402,F401
from scene_script import make_scene  # noqa: E402
from shapes import box, check_closed, quad  # noqa: E402

SIDE, LAMP_SIDE, LAMP_FLUX = 1.0, 0.04, 1000.0
METAL_ROUGHNESS = 0.1  # GGX alpha 0.01


def build(scene):
    white, red, green = (scene.material(name, {"model": "matte", "reflectance": reflectance})
                         for name, reflectance in (("white", [0.74, 0.74, 0.72]), ("red", [0.62, 0.06, 0.05]),
                                                   ("green", [0.12, 0.45, 0.09])))
    metal = scene.material("metal", {"model": "metal", "reflectance": [0.92, 0.91, 0.88], "roughness": METAL_ROUGHNESS})
    glass = scene.material("glass", {"model": "glass", "ior": 1.5})
    middle, half = SIDE / 2, LAMP_SIDE / 2
    lamp = quad((middle - half, middle + half, SIDE - 0.004), (LAMP_SIDE, 0, 0), (0, -LAMP_SIDE, 0))
    emitter = scene.material("lamp", {"model": "matte", "reflectance": 0.0},
                             luminance=LAMP_FLUX / (math.pi * lamp.area()))
    # The front, at y = 0, is open.
    scene.shape("floor", quad((0, 0, 0), (SIDE, 0, 0), (0, SIDE, 0)), white)
    scene.shape("ceiling", quad((0, SIDE, SIDE), (SIDE, 0, 0), (0, -SIDE, 0)), white)
    scene.shape("back", quad((0, SIDE, 0), (SIDE, 0, 0), (0, 0, SIDE)), white)
    scene.shape("left", quad((0, 0, 0), (0, SIDE, 0), (0, 0, SIDE)), red)
    scene.shape("right", quad((SIDE, SIDE, 0), (0, -SIDE, 0), (0, 0, SIDE)), green)
    scene.shape("lamp", lamp, emitter)
    # A shade hides the lamp from the camera: the edges of so bright a thing would decide the errors of all methods.
    shade = box((middle - 0.04, middle - 0.032, SIDE - 0.03), (middle + 0.04, middle - 0.030, SIDE))
    scene.shape("shade", shade, white)
    tall = box((-0.145, -0.145, 0), (0.145, 0.145, 0.58)).turned("z", 30).moved(0.32, 0.66, 0)
    scene.shape("metal box", tall, metal)  # turned so that it shows the walls, not the open front
    # Set into the floor, so that the floor beneath is seen from the side: across a gap of air it would never be.
    low = check_closed(box((-0.145, -0.145, -0.002), (0.145, 0.145, 0.29)), "glass box")
    scene.shape("glass box", low.turned("z", -17).moved(0.67, 0.32, 0), glass)
    scene.camera("view", (middle, -1.38, middle), (middle, 0, middle), 39.5, 256, 256)


if __name__ == "__main__":
    make_scene(__file__, __doc__, build)
