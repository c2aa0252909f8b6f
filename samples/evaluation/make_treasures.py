#!/usr/bin/env python3
"""A crown and coins of glossy metal under plates of glass, lit by a small lamp: treasures.glb.

The case of figure 7 of Hachisuka, Pantaleoni and Jensen (2012). Whatever lies in the case is lit through glass and seen
through glass, and the metal throws caustics of its own onto the cloth.
"""
import math
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "scenes_common"))
import need_numpy  # noqa: E402,F401
import numpy as np  # noqa: E402
from scene_script import make_scene  # noqa: E402
from shapes import box, check_closed, curve, lathe, merged, quad, sheet, sphere, tube  # noqa: E402

PLATE, PLATE_Z, PLATE_SIDE = 0.006, 0.150, 0.62  # of the large plate: thickness, underside, side
LAMP_AT, LAMP_RADIUS, LAMP_FLUX = (-0.25, 0.06, 0.75), 0.008, 800.0
CROWN_RADIUS, CROWN_AT, CUSHION_Z = 0.066, (-0.025, 0.03), 0.034
HEAP_AT, HEAP_RADIUS, HEAP_HEIGHT = (0.105, 0.015), 0.088, 0.036
METALS = {"gold": ([1.00, 0.77, 0.34], 0.18), "silver": ([0.95, 0.93, 0.88], 0.22),
          "copper": ([0.95, 0.64, 0.54], 0.25)}  # F0, roughness


def coin(radius, thickness):
    """Raised rims and a boss on both faces; the origin is its middle."""
    h = thickness / 2
    face = [(0, h + 0.0003), (radius * 0.30, h + 0.0002), (radius * 0.45, h - 0.0003), (radius * 0.80, h - 0.0003),
            (radius * 0.86, h), (radius * 0.95, h)]
    upper = np.array(face)[::-1]
    lower = np.array(face) * (1, -1)
    edge = curve([lower[-1], (radius - 0.0002, -h + 0.0003), (radius, 0), (radius - 0.0002, h - 0.0003), upper[0]], 2)
    return check_closed(lathe([lower, edge, upper], 48), "coin")


def scattered_coins():
    """{metal: mesh}: a heap beside the crown, stacks, single coins on the cloth, most of these below a small plate."""
    rng = np.random.default_rng(17)
    sizes = {"gold": coin(0.0150, 0.0022), "silver": coin(0.0125, 0.0019), "copper": coin(0.0110, 0.0018)}
    placed = {metal: [] for metal in sizes}

    def put(metal, x, y, z, lean):
        placed[metal].append(sizes[metal].turned("x", lean).turned("z", rng.uniform(0, 360)).moved(x, y, z))

    for _ in range(110):
        azimuth, out = rng.uniform(0, 2 * math.pi), math.sqrt(rng.uniform())
        height = HEAP_HEIGHT * (1 - out) * rng.uniform(0.4, 1)
        metal = ("gold", "gold", "silver", "copper")[rng.integers(4)]
        x, y = HEAP_RADIUS * out * math.cos(azimuth), HEAP_RADIUS * out * math.sin(azimuth)
        put(metal, HEAP_AT[0] + x, HEAP_AT[1] + y, 0.002 + height, rng.uniform(4, 28) if height > 0.003 else 0)
    for x, y, count, metal in ((-0.135, -0.03, 9, "gold"), (-0.142, 0.012, 5, "silver"), (0.02, 0.15, 12, "gold"),
                               (0.058, 0.155, 7, "copper"), (-0.145, 0.085, 12, "silver")):
        thickness = {"gold": 0.0022, "silver": 0.0019, "copper": 0.0018}[metal] + 0.0004
        for k in range(count):
            put(metal, x + rng.uniform(-0.0008, 0.0008), y + rng.uniform(-0.0008, 0.0008), 0.0016 + k * thickness, 0)
    for x, y, metal in ((-0.06, -0.105, "gold"), (-0.025, -0.125, "silver"), (0.015, -0.10, "gold"),
                        (0.06, -0.13, "copper"), (0.04, -0.105, "silver"), (-0.10, -0.13, "gold"),
                        (-0.115, -0.09, "copper"), (0.10, -0.11, "gold"), (0.0, -0.15, "gold"),
                        (0.135, -0.125, "silver"), (-0.155, -0.075, "gold")):
        put(metal, x, y, 0.0016, 0)
    return {metal: merged(coins) for metal, coins in placed.items()}


def crown():
    """(metal, gems, cap): a band with eight points, each with a ball, gems between beads, a cap of velvet inside."""
    angle = np.arange(384) * 2 * np.pi / 384
    point = np.abs(np.cos(4 * angle))
    top = 0.040 + 0.048 * point ** 2.2
    flare = 1 + 0.16 * (top / 0.09) ** 1.5

    def ring(z, r):
        return np.stack([r * np.cos(angle), r * np.sin(angle), z * np.ones_like(angle)], -1)

    steps = np.linspace(0, 1, 13)
    reach = [(0.012 + t * (top - 0.012), CROWN_RADIUS * (1 + t ** 1.5 * (flare - 1))) for t in steps]
    outer = [ring(0.012, CROWN_RADIUS), *(ring(z, r) for z, r in reach[1:])]
    inner = [ring(z, r - 0.0022) for z, r in reach[::-1]]
    wall = sheet([*outer, *inner], wrap=True)
    band = lathe([curve([(CROWN_RADIUS - 0.003, 0.0), (CROWN_RADIUS + 0.003, 0.001), (CROWN_RADIUS + 0.004, 0.004),
                         (CROWN_RADIUS + 0.0015, 0.008), (CROWN_RADIUS + 0.0015, 0.022), (CROWN_RADIUS + 0.004, 0.026),
                         (CROWN_RADIUS + 0.003, 0.029), (CROWN_RADIUS - 0.003, 0.030),
                         (CROWN_RADIUS - 0.003, 0.0)], 4)], 128)
    parts, gems = [wall, band], []
    for k in range(8):
        a = math.radians(45 * k)
        tip = CROWN_RADIUS * flare.max()
        parts.append(sphere(0.0065, 16, 24).moved(tip * math.cos(a), tip * math.sin(a), top.max() + 0.004))
    for k in range(16):
        a, r = math.radians(22.5 * k + 11.25), CROWN_RADIUS + 0.0025
        place = (r * math.cos(a), r * math.sin(a), 0.015)
        stone = sphere(1, 14, 24).scaled(0.0035, 0.0058, 0.0058) if k % 2 == 0 else sphere(0.0032, 12, 20)
        (gems if k % 2 == 0 else parts).append(stone.turned("z", math.degrees(a)).moved(*place))
    cap = lathe([curve([(CROWN_RADIUS - 0.004, 0.004), (CROWN_RADIUS - 0.006, 0.030), (0.055, 0.052), (0.028, 0.064),
                        (0, 0.066)], 6)], 64)
    return merged(parts), merged(gems), cap


def plates():
    """(glass, posts): a large plate over everything, a small one over the coins in front."""
    glass, posts = [], []
    half = PLATE_SIDE / 2
    for x0, x1, y0, y1, z, post in ((-half, half, -half, half, PLATE_Z, 0.004),
                                    (-0.125, 0.125, -0.165, -0.068, 0.022, 0.002)):
        glass.append(check_closed(box((x0, y0, z), (x1, y1, z + PLATE)), "plate"))
        # Glass does not touch what it stands on.
        posts += [tube([(x, y, 0), (x, y, z - 0.0005)], post, 16) for x in (x0 + 0.008, x1 - 0.008)
                  for y in (y0 + 0.008, y1 - 0.008)]
    return merged(glass), merged(posts)


def build(scene):
    cloth = scene.material("cloth", {"model": "matte", "reflectance": [0.06, 0.17, 0.15]})
    velvet = scene.material("velvet", {"model": "matte", "reflectance": [0.42, 0.04, 0.06]})
    cushion = scene.material("cushion", {"model": "matte", "reflectance": [0.16, 0.07, 0.28]})
    wall = scene.material("wall", {"model": "matte", "reflectance": [0.62, 0.60, 0.55]})
    glass = scene.material("glass", {"model": "glass", "ior": 1.52})
    ruby = scene.material("ruby", {"model": "plastic", "reflectance": [0.45, 0.01, 0.03], "roughness": 0.2,
                                   "ior": 1.76})
    metals = {name: scene.material(name, {"model": "metal", "reflectance": f0, "roughness": roughness})
              for name, (f0, roughness) in METALS.items()}
    glass_plates, posts = plates()
    scene.shape("plates", glass_plates, glass)
    scene.shape("posts", posts, metals["silver"])
    for name, coins in scattered_coins().items():
        scene.shape(f"{name} coins", coins, metals[name])
    x, y = CROWN_AT
    pillow = sphere(1, 24, 64)
    scene.shape("cushion", pillow.scaled(0.098, 0.088, 0.020).moved(x, y, CUSHION_Z - 0.020), cushion)
    for name, part, material in zip(("crown", "gems", "cap"), crown(), (metals["gold"], ruby, velvet)):
        scene.shape(name, part.moved(x, y, CUSHION_Z - 0.005), material)
    side, low, high = 0.62, 0.0, 0.9
    scene.shape("cloth", quad((-side, -side, low), (2 * side, 0, 0), (0, 2 * side, 0)), cloth)
    up = (0, 0, high - low)
    corners = [(-side, side, low), (side, side, low), (side, -side, low), (-side, -side, low)]
    scene.shape("walls", merged([quad(a, np.subtract(b, a), up) for a, b in zip(corners, corners[1:] + corners[:1])]
                                + [quad((-side, side, high), (2 * side, 0, 0), (0, -2 * side, 0))]), wall)
    lamp = lathe([[(0, 0), (LAMP_RADIUS, 0)]], 32)  # faces down
    emitter = scene.material("lamp", {"model": "matte", "reflectance": 0.0},
                             luminance=LAMP_FLUX / (math.pi * lamp.area()))
    scene.shape("lamp", lamp.moved(*LAMP_AT), emitter)
    scene.camera("view", (0.03, -0.50, 0.45), (0.01, 0.0, 0.035), 31, 256, 256)


if __name__ == "__main__":
    make_scene(__file__, __doc__, build)
