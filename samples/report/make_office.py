#!/usr/bin/env python3
"""A small office for a report: four desks under eight recessed luminaires, meters on the desks, around them and on
walls, four people who look across their desks: office.glb and its luminaire's file.

Called by run.sh beside this script and by a test.
"""
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "scenes_common"))
import need_numpy  # noqa: E402,F401
import numpy as np  # noqa: E402
from gltf_builder import Frame  # noqa: E402
from ies import write_axial  # noqa: E402
from rooms import inside  # noqa: E402
from scene_script import make_scene  # noqa: E402
from shapes import box, merged, quad  # noqa: E402

LENGTH, WIDTH, HEIGHT = 7.2, 5.4, 2.8
LUMINAIRE = "recessed.ies"
DESKS = [(1.2, 1.0), (1.2, 3.2), (4.4, 1.0), (4.4, 3.2)]  # their corners; 1.6 m x 0.8 m
DESK_HEIGHT = 0.74


def matte(scene, name, reflectance):
    return scene.material(name, {"model": "matte", "reflectance": reflectance})


def furnish(scene):
    tops, legs, panels = [], [], []
    for x, y in DESKS:
        tops.append(box((x, y, DESK_HEIGHT - 0.03), (x + 1.6, y + 0.8, DESK_HEIGHT)))
        legs += [box((x + dx, y + 0.05, 0), (x + dx + 0.05, y + 0.75, DESK_HEIGHT - 0.03)) for dx in (0.05, 1.5)]
        panels.append(box((x + 0.5, y + 0.78, DESK_HEIGHT + 0.1), (x + 1.1, y + 0.8, DESK_HEIGHT + 0.45)))
    scene.shape("desk tops", merged(tops), scene.material("desk top", {
        "model": "plastic", "reflectance": 0.4, "roughness": 0.4, "ior": 1.5}))
    scene.shape("desk legs", merged(legs), matte(scene, "legs", 0.3))
    scene.shape("screens", merged(panels), matte(scene, "screen", 0.05))
    scene.shape("cupboards", merged([box((0.02, 0.3, 0), (0.47, 5.1, 1.05)), box((6.7, 4.2, 0), (7.18, 5.38, 2.0))]),
                matte(scene, "cupboard", 0.55))


def measure(scene):
    for k, (x, y) in enumerate(DESKS):
        scene.meters(f"desk {k + 1}", Frame.upright((x + 0.8, y + 0.4, DESK_HEIGHT + 0.01)), width_m=1.6, height_m=0.8,
                     columns=8, rows=4)
        # Somebody who works there, seated, and looks level across the desk.
        scene.observer(f"desk {k + 1}", (x + 0.8, y - 0.25, 1.2), (x + 0.8, y + 5, 1.2))
    scene.meters("room", Frame.upright((LENGTH / 2, WIDTH / 2, 0.75)), width_m=LENGTH - 1, height_m=WIDTH - 1,
                 columns=12, rows=9)
    for name, x, y, width, facing in (("wall west", 0.001, 2.7, 4.4, (1, 0, 0)),
                                      ("wall east", LENGTH - 0.001, 2.1, 3.2, (-1, 0, 0))):
        scene.meters(name, Frame.facing((x, y, 1.85), facing), width_m=width, height_m=1.2, columns=round(width / 0.4),
                     rows=3)  # above the cupboards


def build(scene, folder):
    gamma = np.arange(0, 91, 2.5)
    beam = np.cos(np.radians(gamma)) ** 1.6 / (1 + np.exp((gamma - 62) / 4))
    write_axial(os.path.join(folder, LUMINAIRE), gamma, 1500 * beam / beam[0],
                [("TEST", "computed by make_office.py"), ("TESTLAB", "none"), ("ISSUEDATE", "2026-01-01"),
                 ("MANUFAC", "UPS samples"), ("LUMINAIRE", "recessed, 1200 x 300, microprism")], watts=26,
                opening=(0.3, 1.2, 0))
    for name, face in inside((0, 0, 0), (LENGTH, WIDTH, HEIGHT)).items():
        scene.shape(name, face, matte(scene, name, {"floor": 0.2, "walls": 0.6, "ceiling": 0.8}[name]))
    for k in range(8):
        scene.luminaire(f"recessed {k + 1}",
                        Frame.upright((0.9 + 1.8 * (k % 4), 1.35 + 2.7 * (k // 4), HEIGHT - 0.001)), file=LUMINAIRE)
    scene.shape("door", quad((2.0, 0.002, 0), (0.9, 0, 0), (0, 0, 2.1)), matte(scene, "door", 0.4))
    furnish(scene)
    measure(scene)
    scene.camera("view", (6.9, 0.4, 1.7), (2.2, 3.6, 0.9), 62, 640, 440)


if __name__ == "__main__":
    out = sys.argv[sys.argv.index("--out") + 1] if "--out" in sys.argv[:-1] else __file__
    make_scene(__file__, __doc__, lambda scene: build(scene, os.path.dirname(os.path.abspath(out))))
