#!/usr/bin/env python3
"""A seated bronze figure between a bare blue lamp and a yellow one in a metal tube with a lens: statue.glb.

The case of figures 9 and 10 of Hachisuka, Pantaleoni and Jensen (2012): the blue emitter lights the room directly, the
yellow one through its lens alone, so that all its light arrives as a caustic. Both emitters are small.
"""
import math
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "scenes_common"))
import need_numpy  # noqa: E402,F401
import numpy as np  # noqa: E402
from implicit import blended, capsule, ellipsoid, surface  # noqa: E402
from scene_script import make_scene  # noqa: E402
from shapes import arc, check_closed, curve, icosphere, lathe, merged, quad, sheet, tube, unit  # noqa: E402

BLUE, YELLOW = (0.06, 0.22, 1.0), (1.0, 0.68, 0.06)  # R, G, B of the emitters
BLUE_RADIUS, BLUE_LUMINANCE = 0.012, 1.0e6           # m; cd/m2 of the strongest channel
YELLOW_RADIUS, YELLOW_LUMINANCE = 0.006, 1.5e7
TUBE_RADIUS, TUBE_LENGTH, EMITTER_FROM_LENS = 0.034, 0.06, 0.036
LENS_EDGE, LENS_BULGE = 0.004, 0.0085
PEDESTAL_Z, SEAT_Z = 0.46, 0.56
ROOM = (2.4, 2.2, 2.4)  # x, y, z


def figure():
    """Sits cross-legged with its hands in its lap, 0.72 m high, and looks towards -y."""
    parts = [ellipsoid((0, 0.01, 0.13), (0.165, 0.12, 0.12)), ellipsoid((0, 0.01, 0.27), (0.125, 0.09, 0.17)),
             ellipsoid((0, 0.0, 0.37), (0.145, 0.09, 0.085)),
             capsule((-0.125, 0.01, 0.425), (0.125, 0.01, 0.425), 0.05)]
    for side in (1, -1):
        knee, shoulder, elbow = (side * 0.255, -0.10, 0.062), (side * 0.155, 0.01, 0.415), (side * 0.20, 0.02, 0.225)
        parts += [capsule((side * 0.09, 0.02, 0.09), knee, 0.085, 0.06),
                  capsule(knee, (-side * 0.07, -0.20 + side * 0.015, 0.055 + side * 0.004), 0.055, 0.036),
                  capsule(shoulder, elbow, 0.047, 0.04), capsule(elbow, (side * 0.045, -0.155, 0.125), 0.039, 0.027)]
    body = blended(parts, 0.028)
    hands = [ellipsoid((side * 0.03, -0.175, 0.127 + side * 0.006), (0.058, 0.036, 0.017)) for side in (1, -1)]
    head = [capsule((0, 0.01, 0.43), (0, 0.0, 0.53), 0.047, 0.042),
            ellipsoid((0, -0.005, 0.575), (0.064, 0.072, 0.086)), ellipsoid((0, -0.012, 0.545), (0.052, 0.058, 0.055)),
            ellipsoid((0, 0.012, 0.650), (0.042, 0.044, 0.036)), ellipsoid((0, 0.012, 0.690), (0.016, 0.016, 0.022))]
    face = [capsule((0, -0.074, 0.592), (0, -0.084, 0.567), 0.006, 0.010),  # nose, mouth
            ellipsoid((0, -0.066, 0.541), (0.018, 0.010, 0.006))]
    for side in (1, -1):  # brow, eye, ear
        face += [capsule((side * 0.036, -0.066, 0.601), (side * 0.006, -0.074, 0.598), 0.005),
                 ellipsoid((side * 0.026, -0.061, 0.585), (0.015, 0.008, 0.006)),
                 capsule((side * 0.066, 0.002, 0.60), (side * 0.064, 0.004, 0.525), 0.013, 0.011)]
    # The hem of the robe, from the left shoulder across the chest and under the right arm.
    hem = curve([(0.10, -0.055, 0.465), (0.045, -0.100, 0.40), (-0.04, -0.112, 0.31), (-0.125, -0.07, 0.235)], 4)
    robe = [capsule(a, b, 0.011) for a, b in zip(hem, hem[1:])]
    whole = blended([body, blended(hands, 0.01), blended(head, 0.02)], 0.022)
    bronze = blended([whole, blended(robe, 0.004), *face], 0.010)
    return surface(bronze, (-0.34, -0.29, -0.02), (0.34, 0.17, 0.74), 0.0055)


def lotus():
    """The seat, 0.10 m high: two rings of petals around a waist."""
    profile = curve([(0.0, 0.262), (0.008, 0.290), (0.024, 0.302), (0.040, 0.285), (0.050, 0.262), (0.060, 0.285),
                     (0.076, 0.305), (0.092, 0.297), (0.100, 0.275)], 4)  # height, radius
    angle = np.arange(288) * 2 * np.pi / 288
    rings = []
    for z, r in profile:
        petal = np.abs(np.cos(9 * angle + (np.pi / 2 if z > 0.05 else 0))) ** 0.7
        depth = 0.035 * np.clip(np.abs(z - 0.05) / 0.02, 0, 1) * (1 - np.clip((z - 0.085) / 0.015, 0, 1))
        ring = r - depth * (1 - petal)
        rings.append(np.stack([ring * np.cos(angle), ring * np.sin(angle), np.full_like(angle, z)], -1))
    centre = np.zeros_like(rings[-1])
    return merged([sheet(rings, wrap=True), sheet([rings[-1], centre + (0, 0, 0.1)], wrap=True)])


def spotlight():
    """(tube, lens, emitter) of the yellow lamp around z, shining towards -z; the origin is the middle of the lens."""
    wall = TUBE_RADIUS + 0.0025
    body = lathe([[(0, TUBE_LENGTH - 0.003), (TUBE_RADIUS, TUBE_LENGTH - 0.003)][::-1],
                  [(TUBE_RADIUS, TUBE_LENGTH - 0.003), (TUBE_RADIUS, -0.012)], [(TUBE_RADIUS, -0.012), (wall, -0.012)],
                  [(wall, -0.012), (wall, TUBE_LENGTH)], [(wall, TUBE_LENGTH), (0, TUBE_LENGTH)]], 96)
    edge = TUBE_RADIUS + 0.0006  # reaches into the tube, so that no light passes beside it
    radius = (edge ** 2 + LENS_BULGE ** 2) / (2 * LENS_BULGE)
    half = math.degrees(math.asin(edge / radius))
    below = arc((0, LENS_BULGE - LENS_EDGE / 2 - radius - 2 * (LENS_BULGE - radius)), radius, -90, -90 + half, 20)
    above = arc((0, LENS_EDGE / 2 + LENS_BULGE - radius), radius, 90 - half, 90, 20)
    below[:, 1] += -LENS_EDGE / 2 - below[-1, 1]
    above[:, 1] += LENS_EDGE / 2 - above[0, 1]
    lens = lathe([below, [below[-1], above[0]], above], 96)
    chip = lathe([[(0, 0), (YELLOW_RADIUS, 0)]], 32)  # faces the lens
    return body, check_closed(lens, "lens"), chip.moved(0, 0, EMITTER_FROM_LENS)


def aimed(mesh, at, target):
    """Turns a lamp that shines towards -z so that it shines from `at` to `target`."""
    x, y, z = unit(np.subtract(at, target).astype(float))
    return mesh.turned("y", math.degrees(math.acos(z))).turned("z", math.degrees(math.atan2(y, x))).moved(*at)


def add_lamps(scene):
    tin = scene.material("tube", {"model": "metal", "reflectance": 0.6, "roughness": 0.3})
    lens_glass = scene.material("lens", {"model": "glass", "ior": 1.52})
    cable = scene.material("cable", {"model": "matte", "reflectance": 0.05})
    colours = (("blue", BLUE_LUMINANCE, BLUE), ("yellow", YELLOW_LUMINANCE, YELLOW))
    emitters = [scene.material(name, {"model": "matte", "reflectance": 0.0}, luminance=luminance * np.array(colour))
                for name, luminance, colour in colours]
    blue_at, yellow_at, target = (-0.47, -0.18, 1.40), (0.43, -0.20, 1.43), (0.02, -0.02, 0.84)
    scene.shape("blue lamp", icosphere(BLUE_RADIUS, 3).moved(*blue_at), emitters[0])
    body, lens, bulb = (aimed(part, yellow_at, target) for part in spotlight())
    scene.shape("spotlight tube", body, tin)
    scene.shape("spotlight lens", lens, lens_glass)
    scene.shape("spotlight emitter", bulb, emitters[1])
    tube_end = yellow_at + unit(np.subtract(yellow_at, target)) * TUBE_LENGTH
    for name, (x, y, z) in (("blue", np.add(blue_at, (0, 0, BLUE_RADIUS))), ("yellow", tube_end)):
        scene.shape(f"{name} cable", tube([(x, y, z), (x, y, ROOM[2])], 0.003, 8), cable)


def build(scene):
    wall = scene.material("wall", {"model": "matte", "reflectance": 0.62})
    floor = scene.material("floor", {"model": "matte", "reflectance": 0.5})
    stone = scene.material("stone", {"model": "matte", "reflectance": [0.45, 0.43, 0.40]})
    bronze = scene.material("bronze", {"model": "metal", "reflectance": [0.80, 0.68, 0.56], "roughness": 0.3})
    width, depth, height = ROOM
    x0, x1, y0, y1, up = -width / 2, width / 2, -1.5, depth - 1.5, (0, 0, height)
    scene.shape("floor", quad((x0, y0, 0), (width, 0, 0), (0, depth, 0)), floor)
    walls = [quad((x0, y1, 0), (width, 0, 0), up), quad((x0, y0, 0), (0, depth, 0), up),
             quad((x1, y1, 0), (0, -depth, 0), up), quad((x1, y0, 0), (-width, 0, 0), up),
             quad((x0, y1, height), (width, 0, 0), (0, -depth, 0))]
    scene.shape("walls", merged(walls), wall)
    profile = [(0.36, 0), (0.36, 0.05), (0.32, 0.07), (0.30, PEDESTAL_Z - 0.05), (0.34, PEDESTAL_Z - 0.03),
               (0.34, PEDESTAL_Z), (0, PEDESTAL_Z)]
    scene.shape("pedestal", lathe([list(pair) for pair in zip(profile, profile[1:])], 96), stone)
    scene.shape("lotus", lotus().moved(0, 0, PEDESTAL_Z), bronze)
    scene.shape("figure", figure().moved(0, 0.02, SEAT_Z), bronze)
    add_lamps(scene)
    # The lamps are just out of sight: the edges of so bright things would decide the errors of all methods.
    scene.camera("view", (0.08, -1.45, 1.06), (0.0, 0, 0.87), 39, 256, 256)


if __name__ == "__main__":
    make_scene(__file__, __doc__, build)
