#!/usr/bin/env python3
"""A conference room of matte surfaces alone under large luminous ceiling panels: conference.glb.

The case of figure 8 of Hachisuka, Pantaleoni and Jensen (2012): nothing here is hard for bidirectional path tracing,
so that a method that adds photon merging can only lose the time that merging costs.
"""
import math
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "scenes_common"))
import need_numpy  # noqa: E402,F401
import numpy as np  # noqa: E402
import plant  # noqa: E402
from scene_script import make_scene  # noqa: E402
from shapes import box, curve, lathe, merged, quad, rounded_box, sheet, tube  # noqa: E402

LENGTH, WIDTH, HEIGHT = 7.0, 5.0, 2.8             # x, y, z
PANELS, PANEL_FLUX = [(2.0, 2.5), (5.0, 2.5)], 9000.0
PANEL_LENGTH, PANEL_WIDTH = 2.0, 1.2
TABLE_AT, TABLE_LENGTH, TABLE_WIDTH, TABLE_Z = (3.5, 2.5), 3.6, 1.4, 0.74
PAINTS = {"plaster": [0.78, 0.77, 0.74], "blue wall": [0.28, 0.38, 0.50], "carpet": [0.20, 0.22, 0.26],
          "wood": [0.50, 0.33, 0.19], "dark wood": [0.25, 0.15, 0.09], "fabric": [0.60, 0.22, 0.12],
          "frame": [0.12, 0.12, 0.13], "paper": [0.82, 0.82, 0.80], "board": [0.80, 0.81, 0.82],
          "leaf": [0.10, 0.30, 0.08], "clay": [0.55, 0.52, 0.48], "chart": [0.70, 0.35, 0.10]}


def table():
    """(top, feet): a boat-shaped top on two plinths."""
    angle = np.arange(160) * 2 * np.pi / 160
    c, s = np.cos(angle), np.sin(angle)
    reach = (np.abs(c) ** 3.2 + np.abs(s) ** 3.2) ** (-1 / 3.2)
    rings = []
    for z, scale in ((TABLE_Z - 0.045, 0.0), (TABLE_Z - 0.045, 0.975), (TABLE_Z - 0.03, 1.0), (TABLE_Z - 0.006, 1.0),
                     (TABLE_Z, 0.994), (TABLE_Z, 0.0)):
        rings.append(np.stack([TABLE_LENGTH / 2 * scale * reach * c, TABLE_WIDTH / 2 * scale * reach * s,
                               np.full(len(c), z)], -1))
    top = merged([sheet(pair, wrap=True) for pair in zip(rings, rings[1:])])
    feet = [rounded_box((x - 0.30, -0.28, 0), (x + 0.30, 0.28, TABLE_Z - 0.04), 0.01, 2) for x in (-0.95, 0.95)]
    return top, merged(feet)


def chair():
    """(upholstery, frame) of an office chair that looks towards +y; the origin is on the floor below its seat."""
    seat = rounded_box((-0.24, -0.23, 0.41), (0.24, 0.24, 0.48), 0.03, 4)
    back = rounded_box((-0.22, -0.03, 0), (0.22, 0.03, 0.50), 0.028, 4).turned("x", 9).moved(0, -0.24, 0.56)
    frame = [tube([(0, 0, 0.05), (0, 0, 0.42)], 0.028, 16),
             tube(curve([(0, -0.05, 0.40), (0, -0.26, 0.42), (0, -0.31, 0.66)]), 0.016, 12)]
    for k in range(5):
        a = math.radians(72 * k + 18)
        frame.append(tube([(0, 0, 0.09), (0.28 * math.cos(a), 0.28 * math.sin(a), 0.055)], [0.022, 0.016], 10))
        frame.append(tube([(0.28 * math.cos(a), 0.28 * math.sin(a), 0), (0.28 * math.cos(a), 0.28 * math.sin(a), 0.06)],
                          0.025, 10))
    for side in (-0.27, 0.27):
        frame.append(tube(curve([(side * 0.8, 0.0, 0.43), (side, 0.0, 0.47), (side, 0.0, 0.64)]), 0.013, 10))
        frame.append(rounded_box((side - 0.03, -0.13, 0.64), (side + 0.03, 0.15, 0.665), 0.011, 2))
    return merged([seat, back]), merged(frame)


def ceiling_and_panels():
    """The panels hang 3 cm below the ceiling in shallow frames."""
    hx, hy, t = PANEL_LENGTH / 2, PANEL_WIDTH / 2, 0.03
    bottom, panels, frames = HEIGHT - 0.04, [], []
    for x, y in PANELS:
        panels.append(quad((x - hx, y + hy, HEIGHT - 0.03), (PANEL_LENGTH, 0, 0), (0, -PANEL_WIDTH, 0)))
        for y0 in (y - hy - t, y + hy):
            frames.append(box((x - hx - t, y0, bottom), (x + hx + t, y0 + t, HEIGHT)))
        for x0 in (x - hx - t, x + hx):
            frames.append(box((x0, y - hy, bottom), (x0 + t, y + hy, HEIGHT)))
    return quad((0, WIDTH, HEIGHT), (LENGTH, 0, 0), (0, -WIDTH, 0)), merged(panels), merged(frames)


def add_room(scene, m):
    ceiling, panels, frames = ceiling_and_panels()
    emitter = scene.material("panel", {"model": "matte", "reflectance": 0.7},
                             luminance=PANEL_FLUX * len(PANELS) / (math.pi * panels.area()))
    scene.shape("ceiling", ceiling, m["plaster"])
    scene.shape("panels", panels, emitter)
    scene.shape("panel frames", frames, m["board"])
    scene.shape("floor", quad((0, 0, 0), (LENGTH, 0, 0), (0, WIDTH, 0)), m["carpet"])
    up = (0, 0, HEIGHT)
    scene.shape("walls", merged([quad((0, 0, 0), (0, WIDTH, 0), up), quad((0, WIDTH, 0), (LENGTH, 0, 0), up),
                                 quad((LENGTH, 0, 0), (-LENGTH, 0, 0), up)]), m["plaster"])
    scene.shape("end wall", quad((LENGTH, WIDTH, 0), (0, -WIDTH, 0), up), m["blue wall"])
    # On the far long wall a whiteboard, on the end wall a projection screen and a door; skirting all around.
    scene.shape("whiteboard", rounded_box((2.1, WIDTH - 0.03, 0.95), (4.3, WIDTH, 2.05), 0.008, 2), m["board"])
    lines = [box((2.3 + 0.28 * k, WIDTH - 0.034, 1.15), (2.42 + 0.28 * k, WIDTH - 0.028, 1.15 + h))
             for k, h in enumerate((0.25, 0.42, 0.36, 0.58, 0.50, 0.71))]
    scene.shape("chart", merged(lines), m["chart"])
    rails = [box((2.08, WIDTH - 0.04, z), (4.32, WIDTH, z + 0.025)) for z in (0.93, 2.045)]
    scene.shape("whiteboard rails", merged(rails), m["frame"])
    scene.shape("screen", rounded_box((LENGTH - 0.03, 1.5, 0.95), (LENGTH, 3.5, 2.10), 0.008, 2), m["paper"])
    scene.shape("screen case", box((LENGTH - 0.09, 1.42, 2.10), (LENGTH, 3.58, 2.20)), m["frame"])
    scene.shape("door", merged([box((5.35, WIDTH - 0.02, 0), (6.25, WIDTH, 2.05)),
                                box((5.45, WIDTH - 0.035, 0.15), (6.15, WIDTH, 0.9)),
                                box((5.45, WIDTH - 0.035, 1.05), (6.15, WIDTH, 1.92))]), m["wood"])
    scene.shape("door handle", tube([(5.44, WIDTH - 0.06, 1.02), (5.56, WIDTH - 0.06, 1.02)], 0.011, 12), m["frame"])
    skirting = [box((0, WIDTH - 0.015, 0), (5.3, WIDTH, 0.09)), box((LENGTH - 0.015, 0, 0), (LENGTH, WIDTH, 0.09))]
    scene.shape("skirting", merged(skirting), m["dark wood"])


def add_furniture(scene, m):
    tx, ty = TABLE_AT
    top, feet = table()
    scene.shape("table top", top.moved(tx, ty, 0), m["wood"])
    scene.shape("table feet", feet.moved(tx, ty, 0), m["dark wood"])
    seats = [(x, y, turn + wobble) for y, turn in ((ty - 0.98, 0), (ty + 0.98, 180))
             for x, wobble in ((tx - 1.15, 9), (tx - 0.38, -6), (tx + 0.38, 4), (tx + 1.15, -11))]
    seats.append((tx + 2.12, ty, 97))
    for name, part, paint in zip(("cushions", "chair frames"), chair(), ("fabric", "frame")):
        scene.shape(name, merged([part.turned("z", turn).moved(x, y, 0) for x, y, turn in seats]), m[paint])
    fronts = [rounded_box((x, WIDTH - 0.435, 0.06), (x + 0.67, WIDTH - 0.40, 0.77), 0.008, 2) for x in (0.52, 1.21)]
    cabinet = rounded_box((0.5, WIDTH - 0.42, 0), (1.9, WIDTH, 0.80), 0.01, 2)
    scene.shape("cabinet", merged([cabinet, *fronts]), m["dark wood"])
    for name, part, paint in zip(("pot", "soil", "leaves"), (plant.pot(), plant.soil(), plant.leaves()),
                                 ("clay", "dark wood", "leaf")):
        scene.shape(name, part.scaled(1.7, 1.7, 1.7).moved(LENGTH - 0.45, WIDTH - 0.45, 0), m[paint])


def add_things_on_table(scene, m):
    tx, ty = TABLE_AT
    page = rounded_box((-0.105, -0.1485, 0), (0.105, 0.1485, 0.004), 0.0015, 1)
    pages = ((-1.1, -0.45, 8), (-0.35, -0.44, -5), (0.45, 0.45, 3), (1.1, 0.42, -12), (0.40, -0.45, 14))
    papers = [page.turned("z", turn).moved(tx + x, ty + y, TABLE_Z) for x, y, turn in pages]
    scene.shape("papers", merged(papers), m["paper"])
    cup = lathe([[(0, 0), (0.030, 0)], [(0.030, 0), (0.040, 0.085)], [(0.040, 0.085), (0.036, 0.085)],
                 [(0.036, 0.085), (0.027, 0.01)], [(0.027, 0.01), (0, 0.01)]], 32)
    cups = [cup.moved(tx + x, ty + y, TABLE_Z) for x, y in ((-0.85, -0.42), (0.7, 0.40), (0.12, -0.38))]
    scene.shape("cups", merged(cups), m["board"])
    telephone = rounded_box((-0.15, -0.13, 0), (0.15, 0.13, 0.05), 0.022, 4)
    scene.shape("telephone", telephone.moved(tx, ty, TABLE_Z), m["frame"])


def build(scene):
    materials = {name: scene.material(name, {"model": "matte", "reflectance": paint}) for name, paint in PAINTS.items()}
    add_room(scene, materials)
    add_furniture(scene, materials)
    add_things_on_table(scene, materials)
    scene.camera("view", (0.45, 0.40, 1.72), (4.2, 3.0, 0.86), 56, 320, 240)


if __name__ == "__main__":
    make_scene(__file__, __doc__, build)
