#!/usr/bin/env python3
"""An empty office, 8 m x 6 m x 3 m, under eight flush ceiling panels of 4000 lm: office.glb.

The plain case of interior lighting: large Lambertian emitters, matte surfaces, 32 x 24 meters on the work plane.
Called by hand and by the checks in README.md.
"""
import math
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "scenes_common"))
import need_numpy  # noqa: E402,F401
from gltf_builder import Frame  # noqa: E402
from scene_script import make_scene  # noqa: E402
from shapes import merged, quad  # noqa: E402

LENGTH, WIDTH, HEIGHT = 8.0, 6.0, 3.0
PANEL_SIDE, PANEL_FLUX = 0.6, 4000.0
PANEL_CENTRES = [(x, y) for x in (1.0, 3.0, 5.0, 7.0) for y in (1.5, 4.5)]


def ceiling_cells():
    """The ceiling cut along the edges of the panels: (cells of the ceiling, panels), all facing down."""
    xs = sorted({0.0, LENGTH, *(x + s * PANEL_SIDE / 2 for x, _ in PANEL_CENTRES for s in (-1, 1))})
    ys = sorted({0.0, WIDTH, *(y + s * PANEL_SIDE / 2 for _, y in PANEL_CENTRES for s in (-1, 1))})
    ceiling, panels = [], []
    for x0, x1 in zip(xs, xs[1:]):
        for y0, y1 in zip(ys, ys[1:]):
            is_panel = any(x0 < x < x1 and y0 < y < y1 for x, y in PANEL_CENTRES)
            cell = quad((x0, y1, HEIGHT), (x1 - x0, 0, 0), (0, y0 - y1, 0))
            (panels if is_panel else ceiling).append(cell)
    return merged(ceiling), merged(panels)


def build(scene, meters=True):
    ceiling, panels = ceiling_cells()
    luminance = PANEL_FLUX * len(PANEL_CENTRES) / (math.pi * panels.area())
    panel = scene.material("panel", {"model": "matte", "reflectance": 0.7}, luminance=luminance)
    floor_paint, wall_paint, ceiling_paint = (scene.material(name, {"model": "matte", "reflectance": reflectance})
                                              for name, reflectance in (("floor", 0.2), ("walls", 0.5),
                                                                        ("ceiling", 0.7)))
    corners = [(0, WIDTH, 0), (LENGTH, WIDTH, 0), (LENGTH, 0, 0), (0, 0, 0)]
    walls = merged([quad(a, tuple(q - p for p, q in zip(a, b)), (0, 0, HEIGHT))
                    for a, b in zip(corners, corners[1:] + corners[:1])])
    scene.shape("floor", quad((0, 0, 0), (LENGTH, 0, 0), (0, WIDTH, 0)), floor_paint)
    scene.shape("walls", walls, wall_paint)
    scene.shape("ceiling", ceiling, ceiling_paint)
    scene.shape("panels", panels, panel)
    if meters:
        scene.meters("workplane", Frame.upright((LENGTH / 2, WIDTH / 2, 0.75)), width_m=LENGTH, height_m=WIDTH,
                     columns=32, rows=24)


if __name__ == "__main__":
    make_scene(__file__, __doc__, build)
