#!/usr/bin/env python3
"""A room in sixty lines, with nothing but the package `ups`: illuminance on a plane, its uniformity, a picture.

    pip install --no-build-isolation bindings/python     (in a virtual environment that sees the system's numpy)
    python samples/python/first_room.py FOLDER           writes room.exr and room.png there; Ctrl-C keeps what there is
"""
import sys
from pathlib import Path

import numpy as np
import ups

SIZE = (5.0, 4.0, 2.8)
DOWNLIGHT_IES = b"""IESNA:LM-63-2002
TILT=NONE
1 -1 1 10 1 1 2 0 0 0
1 1 24
0 10 20 30 40 50 60 70 80 90
0
1500 1460 1320 1110 840 560 290 110 25 0
"""


def add_box(scene: ups.Scene, size: tuple[float, float, float]) -> None:
    corners = np.array([[(c >> axis & 1) * size[axis] for axis in range(3)] for c in range(8)])
    for reflectance, quads in ((0.2, [(0, 1, 3, 2)]), (0.7, [(4, 6, 7, 5)]),  # floor, ceiling, walls
                               (0.5, [(0, 4, 5, 1), (1, 5, 7, 3), (3, 7, 6, 2), (2, 6, 4, 0)])):
        triangles = [t for a, b, c, d in quads for t in ((a, b, c), (a, c, d))]
        material = scene.add_material(reflectance_rgb=[reflectance] * 3)
        scene.add_instance(scene.add_mesh(corners, triangles, material))


def main() -> None:
    folder = Path(sys.argv[1] if len(sys.argv) > 1 else ".")
    with ups.Context() as context, ups.Scene(context) as scene:
        add_box(scene, SIZE)
        profile = ups.Profile.parse(context, DOWNLIGHT_IES)
        for x, y in [(1.25, 1), (3.75, 1), (1.25, 3), (3.75, 3)]:
            scene.add_luminaire(profile, to_world=ups.translation(x, y, SIZE[2] - 0.05))
        points, grid = ups.en12464_grid([(0, 0), (5, 0), (5, 4), (0, 4)])
        places = np.column_stack([points["x_m"], points["y_m"], np.full(len(points), 0.75)])
        meters = scene.add_meters(places, normals=(0, 0, 1))
        view = [[1, 0, 0, SIZE[0] / 2], [0, 0, -1, 0.1], [0, 1, 0, 1.5]]  # from a wall's middle along +Y, +Z up
        camera = scene.add_camera(64, 48, to_world=view, vertical_fov_rad=1.2)
        scene.commit()
        result = scene.render(target_relative_error=0.05, time_limit_s=20, seed=1, progress=True)
        statistics = result.statistics(meters)
        print(f"{grid.columns} x {grid.rows} meters: mean {statistics.mean_lx:.0f} lx, "
              f"uniformity {statistics.uniformity:.2f} (95 %: {statistics.uniformity_low:.2f} to "
              f"{statistics.uniformity_high:.2f})")
        luminance = result.image(camera)
        channels = {name: luminance[..., i] for i, name in enumerate("RGB")}
        ups.write_exr(folder / "room.exr", channels, {"unit": "cd/m^2"})
        ups.write_png(folder / "room.png", luminance)


if __name__ == "__main__":
    main()
