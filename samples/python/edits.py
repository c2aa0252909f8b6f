#!/usr/bin/env python3
"""What a CAD program does with a scene that it keeps: an L-shaped room, ten luminaires, two grids, a camera. One
luminaire is moved, dimmed, aimed and removed; each is one call and a commit, where a program that describes all anew
makes a call for each thing. Prints what either takes, and fails where the light of the edited scene has not the same
bits as that of a new one.

    UPS_LIBRARY=build/release/src/api PYTHONPATH=bindings/python samples/python/edits.py
"""
import math
import sys
import time

import numpy as np
import ups

LUMINAIRES = 10
CALLS_OF_AN_EMPTY_ROOM = 8  # the scene, material, mesh, instance, two grids, camera, commit
CALLS_OF_AN_EDIT = 2


def place(x, y, z, tilt_rad=0.0):
    """At a point, turned about Y."""
    c, s = math.cos(tilt_rad), math.sin(tilt_rad)
    return np.array([[c, 0, s, x], [0, 1, 0, y], [-s, 0, c, z]])


# [anew]
def add_walls(scene, material):
    """7 x 2 m along X and 2 x 6.5 m along Y share a corner; 2.7 m high."""
    outline = np.array([(0, 0), (7, 0), (7, 2), (2, 2), (2, 6.5), (0, 6.5)])
    positions = np.concatenate([np.column_stack([outline, np.full(6, z)]) for z in (0, 2.7)])
    floor = np.array([(0, 1, 2), (0, 2, 3), (0, 3, 4), (0, 4, 5)])
    walls = [t for a in range(6) for b in [(a + 1) % 6] for t in ((a, a + 6, b + 6), (a, b + 6, b))]
    return scene.add_mesh(positions, np.concatenate([floor, floor[:, ::-1] + 6, walls]), material)
# [end]


class Room:
    """What is in the room, and the ids of it in the scene that was described last."""

    def __init__(self, context):
        self.context = context
        self.profile = ups.Profile.from_table(context, [0], [0, 30, 60, 90], [[1000, 740, 190, 0]])
        places = [(1 + i, 1) if i < 6 else (1, i - 4) for i in range(LUMINAIRES)]
        self.placed = {i: {"to_world": place(x, y, 2.6)} for i, (x, y) in enumerate(places)}

    # [anew]
    def describe(self):
        """The whole room as a new scene, committed."""
        scene = ups.Scene(self.context)
        scene.add_instance(add_walls(scene, scene.add_material(reflectance_rgb=(0.6, 0.6, 0.6))))
        self.ids = {i: scene.add_luminaire(self.profile, **fields) for i, fields in self.placed.items()}
        x, y = (a.ravel() for a in np.meshgrid(0.3 * np.arange(5), 0.3 * np.arange(4)))
        self.grids = [scene.add_meters(np.column_stack([x + at_x, y + at_y, np.full(20, 0.75)]), (0, 0, 1))
                      for at_x, at_y in ((4, 0.5), (0.4, 4))]
        view = [[0, 0, -1, 0.5], [-1, 0, 0, 1], [0, 1, 0, 1.5]]  # along +X, +Z up
        self.camera = scene.add_camera(32, 24, to_world=view)
        scene.commit()
        return scene
    # [end]

    def render(self, scene):
        """(illuminance of both grids, what has to be the same bits)"""
        result = scene.render(iteration_count=2, light_paths_per_iteration=2048, seed=11)
        readings = np.concatenate([result.meters(grid) for grid in self.grids])
        return readings["illuminance_lx"], readings.tobytes() + result.image(self.camera).tobytes()


def show(what, room, kept, other, edit, edit_other):
    """The edit of a kept scene, and the same in a new one: whether both have the same bits."""
    start = time.perf_counter()
    edit()
    kept.commit()
    edited_ms = 1000 * (time.perf_counter() - start)
    lux, bits = room.render(kept)
    edit_other()
    start = time.perf_counter()
    with other.describe() as anew:
        described_ms = 1000 * (time.perf_counter() - start)
        same = other.render(anew)[1] == bits
    print(f"{what:7} {CALLS_OF_AN_EDIT} calls, {edited_ms:.1f} ms; anew "
          f"{CALLS_OF_AN_EMPTY_ROOM + len(other.placed)} calls, "
          f"{described_ms:.1f} ms; {lux[7]:6.1f} lx, {lux[27]:6.1f} lx; {'the same bits' if same else 'OTHER BITS'}")
    return same


def main():
    context = ups.Context()
    room, other = Room(context), Room(context)
    with room.describe() as scene:
        luminaire, its = room.ids[3], other.placed[3]
        moved, aimed = place(4.5, 0.8, 2.4), place(4.5, 0.8, 2.4, 0.6)
        edits = [("move", lambda: scene.set_luminaire_transform(luminaire, moved), lambda: its.update(to_world=moved)),
                 ("dim", lambda: scene.set_dimming(luminaire, 0.5), lambda: its.update(dimming=0.5)),
                 ("aim", lambda: scene.set_luminaire_transform(luminaire, aimed), lambda: its.update(to_world=aimed)),
                 ("remove", lambda: scene.remove_luminaire(luminaire), lambda: other.placed.pop(3))]
        same = [show(what, room, scene, other, edit, edit_other) for what, edit, edit_other in edits]
    sys.exit(0 if all(same) else "an edited scene has other bits than a new one")


if __name__ == "__main__":
    main()
