"""Does a render in Python have the same bits as in C? UPS_SAME_BITS names the file that same_bits.c wrote, of the
scene that is described there and here."""
import os
from pathlib import Path

import numpy as np
import ups

POSITIONS = [(0, 0, 0), (4, 0, 0), (4, 3, 0), (0, 3, 0), (0, 0, 2.5), (4, 0, 2.5), (4, 3, 2.5), (0, 3, 2.5),
             (1, 1, 1.5), (2, 1, 1.5), (2, 2, 1.5), (1, 2, 1.5)]
INDICES = [(0, 1, 2), (0, 2, 3), (4, 6, 5), (4, 7, 6), (0, 5, 1), (0, 4, 5), (1, 6, 2), (1, 5, 6), (2, 7, 3), (2, 6, 7),
           (3, 4, 0), (3, 7, 4), (8, 9, 10), (8, 10, 11)]


def test_same_bits_as_in_c():
    with ups.Context() as context, ups.Scene(context) as scene:
        material = scene.add_material(model=ups.MaterialModel.PLASTIC, reflectance_rgb=(0.5, 0.6, 0.7), roughness=0.4)
        scene.add_instance(scene.add_mesh(POSITIONS, INDICES, material))
        profile = ups.Profile.from_table(context, [0], [0, 30, 60, 90], [[1000, 740, 190, 0]])
        scene.add_luminaire(profile, to_world=ups.translation(2, 1.5, 2.4))
        i = np.arange(35)
        meters = scene.add_meters(np.column_stack([(i % 7 + 0.5) * 4 / 7, (i // 7 + 0.5) * 3 / 5, np.full(35, 0.75)]),
                                  (0, 0, 1))
        camera = scene.add_camera(24, 16, to_world=[[0, 0, -1, 0.5], [-1, 0, 0, 1.5], [0, 1, 0, 1.25]])
        scene.commit()
        result = scene.render(method=ups.Method.UPS, iteration_count=8, seed=20)
        readings, image = result.meters(meters), result.image(camera)
    assert readings["illuminance_lx"].min() > 1, "there is light"
    assert readings.tobytes() + image.tobytes() == Path(os.environ["UPS_SAME_BITS"]).read_bytes()
